/// \file
/// \brief Explicit steps of a body that breaks.
#include "tumble/fracture/fracture.hpp"

#include "tumble/base/error.hpp"
#include "tumble/dynamics/advance_pose.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace tumble {
namespace {

constexpr double kFriction = 0.5;       // [-] between pieces
constexpr double kStiffRoom = 0.67;     // share of the stiffness that the substep is made for
constexpr int kTouchesEvery = 40;       // substeps: a node moves by a fraction of an edge
constexpr double kTouchesReach = 0.02;  // of the extent of an element
constexpr double kTouchesApart =
    -0.1;  // smallest share of a node's place in an element that is near

// The way out of a box for a point in it.
struct WayOut {
  double depth = 0.0;  // [m]
  Vec3 normal_w = Vec3::UnitY();
};

WayOut way_out(const Box& box, const Vec3& point_w) {
  const Vec3 at = box.axes_w.transpose() * (point_w - box.center_w);
  const Vec3 room = box.half - at.cwiseAbs();
  int axis = 0;
  const double depth = room.minCoeff(&axis);
  return {depth, (at[axis] < 0.0 ? -1.0 : 1.0) * box.axes_w.col(axis)};
}

// The face of a touch; the next touch mostly has the same.
class FaceOfTouches {
 public:
  explicit FaceOfTouches(const ElasticMesh& mesh) : mesh_(mesh) {}
  const NearFace& of(int element, int corner) {
    if (!face_ || element != element_ || corner != at_)
      face_.emplace(mesh_, mesh_.elements[idx(element)], corner);
    element_ = element;
    at_ = corner;
    return *face_;
  }

 private:
  const ElasticMesh& mesh_;
  std::optional<NearFace> face_;
  int element_ = 0, at_ = 0;
};

}  // namespace

Fracture::Fracture(ElasticMesh mesh, World rigid, double least)
    : mesh_(std::move(mesh)), rigid_(std::move(rigid)), least_(least) {
  require::that(!mesh_.elements.empty(), "mesh: 0 elements: make one with elastic_box()");
  require::positive(least, "least [m]");
  double fastest = 0.0;
  for (const Tetrahedron& element : mesh_.elements)
    fastest = std::max(fastest, element_rate(element, mesh_.material.lambda, mesh_.material.mu,
                                             mesh_.material.density));
  stiffness_ = tolerance::fracture_contact * fastest;
  look_ = tolerance::crack_look * courant_step(mesh_);
  deepest_ = tolerance::fracture_deepest * mesh_.material.wave_speed() * courant_step(mesh_);
  measure(0);
}

// The step of elements with nodes from one on, if it is shorter.
void Fracture::measure(int from) {
  substep_ = std::min(substep_, tolerance::fracture_step * stable_step(mesh_, stiffness_, from));
  work_.shortest = substep_;
}

// The penalty force on a node: a spring and a damper that only push, and friction. All are in proportion to the mass
// that feels them, so that no contact needs a shorter step.
Vec3 Fracture::push(double mass, double depth, const Vec3& normal_w, const Vec3& slip_w) const {
  const double damping = 2.0 * tolerance::fracture_damping * std::sqrt(stiffness_);
  const double away = slip_w.dot(normal_w);
  const double normal = std::max(0.0, mass * (stiffness_ * depth - damping * away));
  const Vec3 across = slip_w - away * normal_w;
  const double wanted = mass * damping * across.norm();
  const double most = kFriction * normal;
  return normal * normal_w - (wanted > most ? most / wanted : 1.0) * mass * damping * across;
}

void Fracture::push_by_boxes(double h) {
  for (std::size_t k = 0; k < rigid_.bodies().size(); ++k) {
    const BodyProperties& body = rigid_.bodies()[k];
    BodyState& state = rigid_.states()[k];
    const Box box = box_of(body, state);
    const double radius = body.shape == Shape::box ? box.half.norm() : 0.0;
    const Vec3 velocity_w = velocity(body, state), spin_w = angular_velocity(body, state);
    Vec3 push_w = Vec3::Zero(), turn_w = Vec3::Zero();
    for (std::size_t n = 0; n < mesh_.nodes.size(); ++n) {
      const ElasticNode& node = mesh_.nodes[n];
      const Vec3 arm_w = node.position_w - state.position_w;
      WayOut way;
      if (body.shape == Shape::ground) {
        way.depth = -node.position_w.y();
      } else if (arm_w.squaredNorm() < radius * radius) {
        way = way_out(box, node.position_w);
      }
      if (way.depth <= 0.0) continue;
      const Vec3 force_w = push(node.mass, way.depth, way.normal_w,
                                node.velocity_w - velocity_w - spin_w.cross(arm_w));
      forces_[n] += force_w;
      push_w -= force_w;
      turn_w -= arm_w.cross(force_w);
    }
    if (!body.movable()) continue;
    state.linear_momentum_w += h * (push_w + body.mass * rigid_.gravity_w);
    state.angular_momentum_w += h * turn_w;
    advance_pose(body, state, h, RotationRule::splitting);
  }
}

void Fracture::find_forces() {
  forces_.resize(mesh_.nodes.size());
  tension_.resize(mesh_.elements.size());
  for (std::size_t n = 0; n < mesh_.nodes.size(); ++n) forces_[n] = mesh_.nodes[n].load_w;
  add_forces(mesh_, forces_, tension_);
  work_.evaluations += static_cast<std::int64_t>(mesh_.elements.size());
}

void Fracture::find_touches() {
  const std::vector<Touch> known = std::exchange(touches_, {});
  until_touches_ = kTouchesEvery;
  if (std::exchange(has_cracked_, false)) {
    pieces_ = pieces_of(mesh_, piece_);
    outside_ = outside_of(mesh_);
  }
  if (pieces_ < 2) return;
  const auto key = [](const Touch& t) { return std::tie(t.element, t.corner, t.node); };
  FaceOfTouches face(mesh_);
  for (const NearPair& near : near_pieces(mesh_, piece_, outside_, kTouchesReach)) {
    const Sunk sunk =
        face.of(near.element, near.corner).sunk(mesh_.nodes[idx(near.node)].position_w);
    if (*std::min_element(sunk.shares.begin(), sunk.shares.end()) < kTouchesApart) continue;
    Touch touch{near.node, near.element, near.corner, mesh_.elements[idx(near.element)].volume,
                0.0,       false};
    const auto same =
        std::lower_bound(known.begin(), known.end(), touch,
                         [&](const Touch& a, const Touch& b) { return key(a) < key(b); });
    if (same != known.end() && key(*same) == key(touch)) {
      touch.depth = same->depth;
      touch.open = same->open;
    }
    touches_.push_back(touch);
  }
}

// Of nodes in elements of other pieces: out through the face on the outside, and the element's nodes the other way by their
// shares at the point, so that both momenta are kept. Only what has come in through this face is pushed: a spring that
// begins deep would add energy.
void Fracture::push_by_pieces() {
  FaceOfTouches faces(mesh_);
  for (Touch& touch : touches_) {
    const Tetrahedron& element = mesh_.elements[idx(touch.element)];
    if (element.volume != touch.volume) continue;
    const NearFace& face = faces.of(touch.element, touch.corner);
    const Sunk sunk = face.sunk(mesh_.nodes[idx(touch.node)].position_w);
    touch.open = sunk.inside && sunk.depth > 0.0 && sunk.depth < deepest_ &&
                 (touch.open || touch.depth <= 0.0);
    touch.depth = sunk.depth;
    if (!touch.open) continue;
    Vec3 slip_w = mesh_.nodes[idx(touch.node)].velocity_w;
    double inverse_mass = 1.0 / mesh_.nodes[idx(touch.node)].mass;
    for (int i = 0; i < 4; ++i) {
      const ElasticNode& node = mesh_.nodes[idx(element.nodes[idx(i)])];
      slip_w -= sunk.shares[idx(i)] * node.velocity_w;
      inverse_mass += sunk.shares[idx(i)] * sunk.shares[idx(i)] / node.mass;
    }
    const Vec3 force_w = push(1.0 / inverse_mass, sunk.depth, face.normal_w(), slip_w);
    forces_[idx(touch.node)] += force_w;
    for (int i = 0; i < 4; ++i)
      forces_[idx(element.nodes[idx(i)])] -= sunk.shares[idx(i)] * force_w;
  }
}

// Returns false if a velocity is not a number.
bool Fracture::move(double h) {
  double sum = 0.0;
  for (std::size_t n = 0; n < mesh_.nodes.size(); ++n) {
    ElasticNode& node = mesh_.nodes[n];
    node.velocity_w += h * (forces_[n] / node.mass + rigid_.gravity_w);
    node.velocity_w = node.velocity_w.cwiseProduct(node.moves);
    node.position_w += h * node.velocity_w;
    sum += node.velocity_w.sum();
  }
  return std::isfinite(sum);
}

StepReport Fracture::step(double dt) {
  require::positive(dt, "dt");
  StepReport report;
  const int cracks = work_.cracks.cracks;
  double left = dt;
  for (int count = 0; left > 0.0 && report.status == StepStatus::done; ++count) {
    if (count == kMostSubsteps) {
      report.status = StepStatus::event_cap;
      break;
    }
    // [S2.4.1:substep]
    find_forces();
    since_look_ += substep_;
    if (since_look_ >= look_) {
      since_look_ = 0.0;
      const int before = static_cast<int>(mesh_.nodes.size());
      if (crack_all(mesh_, tension_, least_, work_.cracks)) {
        measure(before);
        has_cracked_ = true;
        find_forces();  // the same positions, other nodes
      }
    }
    if (until_touches_-- <= 0) find_touches();
    // Equal substeps: varying ones would feed the fastest swings. Green's strain ε stiffens what is stretched by 1 + 3 ε,
    // for which the substep has room as long as ε is small.
    const double pulled = std::max(0.0, *std::max_element(tension_.begin(), tension_.end()));
    const double stiffer = std::max(1.0, kStiffRoom * (1.0 + 1.5 * pulled / mesh_.material.mu));
    const double most = substep_ / std::sqrt(stiffer);
    const double h = left / std::ceil(left / most);
    push_by_pieces();
    push_by_boxes(h);
    if (!move(h)) report.status = StepStatus::not_finite;
    // [S2.4.1:substep]
    ++work_.substeps;
    report.integrations += static_cast<std::int64_t>(mesh_.nodes.size());
    left = h < left ? left - h : 0.0;
  }
  report.events = work_.cracks.cracks - cracks;
  rigid_.finish_step(dt);
  return report;
}

}  // namespace tumble
