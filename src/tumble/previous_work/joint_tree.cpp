/// \file
/// \brief Forces of joints in linear time.
#include "tumble/previous_work/joint_tree.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/previous_work/tolerances.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <string>

namespace tumble {
namespace {

constexpr std::int64_t kProduct = 216;  // multiplications of two blocks
constexpr std::int64_t kInverse =
    216;  // of a symmetric one: 91 for L, and what L and D take for six columns
constexpr std::int64_t kTimesVector = 36;

bool immovable(const MovingBody& body) { return body.inverse_mass.isZero(0.0); }

// The inverse of a symmetric positive definite block by its own L D L', without roots. False: it is singular.
bool invert(const Mat6& block, Mat6& inverse) {
  Mat6 lower = Mat6::Identity();
  Vec6 pivots;
  for (int j = 0; j < 6; ++j) {
    double pivot = block(j, j);
    for (int k = 0; k < j; ++k) pivot -= lower(j, k) * lower(j, k) * pivots[k];
    if (!(pivot > tolerance::dependent_joint * block(j, j))) return false;
    pivots[j] = pivot;
    for (int i = j + 1; i < 6; ++i) {
      double sum = block(i, j);
      for (int k = 0; k < j; ++k) sum -= lower(i, k) * lower(j, k) * pivots[k];
      lower(i, j) = sum / pivot;
    }
  }
  for (int column = 0; column < 6; ++column) {
    Vec6 x = Vec6::Unit(column);
    for (int i = 0; i < 6; ++i)
      for (int k = 0; k < i; ++k) x[i] -= lower(i, k) * x[k];
    for (int i = 5; i >= 0; --i) {
      x[i] /= pivots[i];
      for (int k = i + 1; k < 6; ++k) x[i] -= lower(k, i) * x[k];
    }
    inverse.col(column) = x;
  }
  return true;
}

}  // namespace

Mat6 mass_of(const MovingBody& body) {
  Mat6 mass = Mat6::Zero();
  mass.diagonal().head<3>() = body.inverse_mass.cwiseInverse();
  mass.bottomRightCorner<3, 3>() = body.inverse_inertia_w.inverse();
  return mass;
}

// --- sets of bodies ---------------------------------------------------------------------------------

BodySets::BodySets(std::span<const MovingBody> bodies, std::vector<int>& sets) : sets_(sets) {
  sets_.resize(bodies.size());
  int wall = -1;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (immovable(bodies[k]) && wall < 0) wall = static_cast<int>(k);
    sets_[k] = immovable(bodies[k]) ? wall : static_cast<int>(k);
  }
}

int BodySets::root_of(int body) {
  while (sets_[idx(body)] != body) {
    sets_[idx(body)] = sets_[idx(sets_[idx(body)])];
    body = sets_[idx(body)];
  }
  return body;
}

bool BodySets::join(int a, int b) {
  a = root_of(a);
  b = root_of(b);
  sets_[idx(std::max(a, b))] = std::min(a, b);
  return a != b;
}

// --- trees ------------------------------------------------------------------------------------------

void JointTree::hang(const Place& place) {
  if (hung_[idx(place.body)] != 0) return;
  hung_[idx(place.body)] = 1;
  waiting_.push_back(place);
}

// A joint is in a tree if it unites two sets. Each tree is then walked through from its root, depth first.
void JointTree::arrange(std::span<const MovingBody> bodies, std::span<const JointRows> joints) {
  BodySets sets(bodies, set_);
  loops_.clear();
  in_tree_.assign(joints.size(), 0);
  start_.assign(bodies.size() + 1, 0);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    require::that(joints[j].count >= 1 && joints[j].count <= 6,
                  "joint with " + std::to_string(joints[j].count) + " rows: expected 1 to 6");
    in_tree_[j] = sets.join(joints[j].first, joints[j].second) ? 1 : 0;
    if (in_tree_[j] == 0) {
      loops_.push_back(static_cast<int>(j));
      continue;
    }
    ++start_[idx(joints[j].first) + 1];
    ++start_[idx(joints[j].second) + 1];
  }
  for (std::size_t k = 1; k < start_.size(); ++k) start_[k] += start_[k - 1];
  beside_.assign(idx(start_.back()), 0);
  std::vector<int>& next = set_;  // no longer needed
  next.assign(start_.begin(), start_.end() - 1);
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (in_tree_[j] != 0)
      for (const int body : {joints[j].first, joints[j].second})
        beside_[idx(next[idx(body)]++)] = static_cast<int>(j);

  links_.resize(bodies.size());  // blocks of the time before are overwritten when they are factored
  std::size_t used = 0;
  hung_.assign(bodies.size(), 0);
  const auto children_wait = [&](int body, int place) {
    for (int at = start_[idx(body)]; at < start_[idx(body) + 1]; ++at) {
      const int joint = beside_[idx(at)];
      const JointRows& rows = joints[idx(joint)];
      const int other = rows.first == body ? rows.second : rows.first;
      if (!immovable(bodies[idx(other)])) hang({other, joint, place});
    }
  };
  const auto grow = [&] {
    while (!waiting_.empty()) {
      static_cast<Place&>(links_[used]) = waiting_.back();
      waiting_.pop_back();
      children_wait(links_[used].body, static_cast<int>(used));
      ++used;
    }
  };
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (!immovable(bodies[k])) continue;
    children_wait(static_cast<int>(k), -1);
    grow();
  }
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (immovable(bodies[k])) continue;
    hang({static_cast<int>(k), -1, -1});
    grow();
  }
  links_.resize(used);
}

// [S2.6.5:factor]
// From the leaves to the roots: what a body and its joint leave of their parent's block.
bool JointTree::factor(std::span<const MovingBody> bodies, std::span<const JointRows> joints) {
  for (Link& link : links_) link.body_inverse = mass_of(bodies[idx(link.body)]);  // D, so far
  for (std::size_t k = links_.size(); k-- > 0;) {
    Link& link = links_[k];
    const Mat6 mass = link.body_inverse;
    if (!invert(mass, link.body_inverse)) return false;
    multiplications_ += kInverse;
    if (link.joint < 0) continue;
    const JointRows& rows = joints[idx(link.joint)];
    const bool second = rows.second == link.body;
    const Mat6& own = second ? rows.on_second : rows.on_first;
    link.lower = -(own * link.body_inverse);
    Mat6 yield =
        -(link.lower * own.transpose());  // how the joint gives way with all that hangs on it
    for (int i = rows.count; i < 6; ++i) yield(i, i) = 1.0;
    if (!invert(yield, link.joint_inverse)) return false;
    link.joint_inverse = -link.joint_inverse;
    multiplications_ += 2 * kProduct + kInverse;
    if (link.parent < 0) continue;
    const Mat6& on_parent = second ? rows.on_first : rows.on_second;
    link.upper = -(on_parent.transpose() * link.joint_inverse);
    links_[idx(link.parent)].body_inverse += link.upper * on_parent;  // its D grows
    multiplications_ += 2 * kProduct;
  }
  return true;
}
// [S2.6.5:factor]

// [S2.6.5:solve]
// L from the leaves to the roots, D, and L transposed back again.
void JointTree::solve(std::span<Vec6> body_part, std::span<Vec6> joint_part) {
  for (Link& link : links_) {
    link.body_part = body_part[idx(link.body)];
    if (link.joint >= 0) link.joint_part = joint_part[idx(link.joint)];
  }
  for (std::size_t k = links_.size(); k-- > 0;) {
    Link& link = links_[k];
    if (link.joint < 0) continue;
    link.joint_part -= link.lower * link.body_part;
    if (link.parent >= 0) links_[idx(link.parent)].body_part -= link.upper * link.joint_part;
  }
  for (Link& link : links_) {
    link.body_part = link.body_inverse * link.body_part;
    multiplications_ += kTimesVector;
    if (link.joint < 0) continue;
    link.joint_part = link.joint_inverse * link.joint_part;
    if (link.parent >= 0)
      link.joint_part -= link.upper.transpose() * links_[idx(link.parent)].body_part;
    link.body_part -= link.lower.transpose() * link.joint_part;
    multiplications_ += (link.parent >= 0 ? 5 : 3) * kTimesVector;
  }
  for (const Link& link : links_) {
    body_part[idx(link.body)] = link.body_part;
    if (link.joint >= 0) joint_part[idx(link.joint)] = link.joint_part;
  }
}
// [S2.6.5:solve]

}  // namespace tumble
