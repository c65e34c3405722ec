/// \file
/// \brief Overlapping pairs: normals by one of three rules, one point or the contact area.
#include "tumble/impulse_damped/pair_gatherer.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/state_hash.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/geometry/overlap_normals.hpp"
#include "tumble/impulse_damped/tolerances.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace tumble {
namespace {

bool unmoved(const BodyState& a, const BodyState& b) {
  return same_bits(a.position_w, b.position_w) &&
         same_bits(a.orientation_wb.coeffs(), b.orientation_wb.coeffs());
}

// The centre of the points that overlap, each weighted by its depth; of all, if they only touch.
void reduce_to_one(double size, Contact& contact) {
  double weight = 0.0;
  double deepest = std::numeric_limits<double>::infinity();
  Vec3 sum_w = Vec3::Zero();
  Vec3 plain_w = Vec3::Zero();
  FeatureId feature = 0;
  for (int p = 0; p < contact.count; ++p) {
    const ContactPoint& point = contact.points[idx(p)];
    const double depth = std::max(0.0, -point.distance);
    weight += depth;
    sum_w += depth * point.position_w;
    plain_w += point.position_w;
    if (point.distance < deepest) {
      deepest = point.distance;
      feature = point.feature;
    }
  }
  ContactPoint centre;
  const bool overlap = weight > tolerance::impulse_even * size;
  centre.position_w = overlap ? Vec3(sum_w / weight) : Vec3(plain_w / contact.count);
  centre.distance = deepest;
  centre.feature = feature;
  contact.points[0] = centre;
  contact.count = 1;
}

}  // namespace

PairGatherer::PairGatherer(NormalRule normals, PointRule points)
    : normals_(normals), points_(points) {}

PairReport PairGatherer::gather(const World& world, std::span<const BodyState> last,
                                std::span<const BodyState> now, const SleepingRule* sleeping,
                                double margin, ContactList& out) {
  const std::span<const BodyProperties> bodies = world.bodies();
  require::that(last.size() == bodies.size() && now.size() == bodies.size(),
                "states: one entry for each body of the world is needed");
  require::not_negative(margin, "margin");
  if (normals_ == NormalRule::last_face) remember(bodies, last);
  if (place_boxes(bodies, now, margin)) broad_phase_.find_pairs(bounds_, pairs_);

  out.clear();
  PairReport report;
  searched_.clear();
  manifolds_.clear();
  std::size_t next = 0;  // of the last search
  for (const IndexPair& pair : pairs_) {
    const BodyProperties& a = bodies[idx(pair.first)];
    const BodyProperties& b = bodies[idx(pair.second)];
    const bool still = (!a.movable() || world.sleep_states()[idx(pair.first)].asleep) &&
                       (!b.movable() || world.sleep_states()[idx(pair.second)].asleep);
    if (sleeping != nullptr ? !sleeping->needs_test(pair.first, pair.second) : still) continue;
    if (!a.movable() && !b.movable()) continue;
    ++report.pair_tests;

    // What the last search found of a pair holds as long as both bodies are where they were.
    while (next < before_.size() && before_[next].pair < pair) ++next;
    const bool known = next < before_.size() && before_[next].pair == pair &&
                       moved_[idx(pair.first)] == 0 && moved_[idx(pair.second)] == 0;
    bool touch = false;
    if (known) {
      touch = before_[next].manifold >= 0;
      if (touch) manifold_ = manifolds_before_[idx(before_[next].manifold)];
    } else if (touch_pair(world, pair, boxes_[idx(pair.first)], boxes_[idx(pair.second)], margin,
                          kNoAxis, manifold_)) {
      touch = true;
      if (a.shape == Shape::box && b.shape == Shape::box) turn_normal(pair, margin, manifold_);
    }
    searched_.push_back({pair, touch ? static_cast<int>(manifolds_.size()) : -1});
    if (!touch) continue;
    manifolds_.push_back(manifold_);
    Contact& contact = out.emplace_back();
    set_pair(world, pair, contact);
    contact.axis = manifold_.axis;
    set_points(manifold_, contact);
    for (int p = 0; p < contact.count; ++p)
      report.deepest_overlap = std::max(report.deepest_overlap, -contact.points[idx(p)].distance);
    if (points_ == PointRule::one) reduce_to_one(shortest_edge(a, b), contact);
  }
  std::swap(searched_, before_);
  std::swap(manifolds_, manifolds_before_);
  return report;
}

// Boxes and bounds of bodies that are not where they were in the last search. Returns whether there are any.
bool PairGatherer::place_boxes(std::span<const BodyProperties> bodies,
                               std::span<const BodyState> now, double margin) {
  bool any = false;
  const bool other = now_.size() != now.size() || margin != margin_;
  if (other) before_.clear();
  margin_ = margin;
  now_.resize(now.size());
  sizes_.resize(now.size());
  boxes_.resize(now.size());
  bounds_.resize(now.size());
  moved_.assign(now.size(), 0);
  for (std::size_t k = 0; k < now.size(); ++k) {
    if (!other && unmoved(now[k], now_[k]) && sizes_[k] == bodies[k].size) continue;
    moved_[k] = 1;
    any = true;
    now_[k] = now[k];
    sizes_[k] = bodies[k].size;
    const double around = 0.5 * margin + tolerance::rounding_overlap * bodies[k].size.maxCoeff();
    if (bodies[k].shape != Shape::box) {
      bounds_[k] = bounds_of(bodies[k], now[k], around);
      continue;
    }
    boxes_[k] = box_of(bodies[k], now[k]);
    bounds_[k] = bounds_of(boxes_[k], around);
  }
  return any || other;
}

// The faces of bodies that began the last step elsewhere are forgotten, and what was found along their normals.
void PairGatherer::remember(std::span<const BodyProperties> bodies,
                            std::span<const BodyState> last) {
  bool any = false;
  const bool other = last_.size() != last.size();
  last_.resize(last.size());
  last_sizes_.resize(last.size());
  last_boxes_.resize(last.size());
  moved_.assign(last.size(), 0);
  for (std::size_t k = 0; k < last.size(); ++k) {
    if (!other && unmoved(last_[k], last[k]) && last_sizes_[k] == bodies[k].size) continue;
    moved_[k] = 1;
    any = true;
    last_[k] = last[k];
    last_sizes_[k] = bodies[k].size;
    if (bodies[k].shape == Shape::box) last_boxes_[k] = box_of(bodies[k], last[k]);
  }
  if (!any) return;
  const auto stale = [&](const auto& found) {
    return other || moved_[idx(found.pair.first)] != 0 || moved_[idx(found.pair.second)] != 0;
  };
  std::erase_if(before_, stale);
  std::erase_if(last_faces_, stale);
}

const PairGatherer::LastFace& PairGatherer::last_face(const IndexPair& pair) {
  const auto place =
      std::lower_bound(last_faces_.begin(), last_faces_.end(), pair,
                       [](const LastFace& face, const IndexPair& to) { return face.pair < to; });
  if (place != last_faces_.end() && place->pair == pair) return *place;
  const Box& first = last_boxes_[idx(pair.first)];
  const Box& second = last_boxes_[idx(pair.second)];
  const Separation found = closest_face(first, second);
  const AxisIndex i = found.axis;
  const Vec3 then_w = i < 3 ? first.axes_w.col(i) : second.axes_w.col(i - 3);
  const double side = then_w.dot(found.normal_w) < 0.0 ? -1.0 : 1.0;
  return *last_faces_.insert(place, {pair, i, side});
}

// [S3.3.2:normal]
// The normal of two boxes that touch by the rule, and where they touch along it.
void PairGatherer::turn_normal(const IndexPair& pair, double margin, Manifold& manifold) {
  const Box& first = boxes_[idx(pair.first)];
  const Box& second = boxes_[idx(pair.second)];
  Separation found{0.0, manifold.normal_w, manifold.axis};
  if (normals_ == NormalRule::last_face) {
    // The face that was closest when the step began, turned with its body since. The normal keeps
    // the side on which the other box was then.
    const LastFace& face = last_face(pair);
    found.axis = face.axis;
    const Vec3 now_w =
        face.axis < 3 ? first.axes_w.col(face.axis) : second.axes_w.col(face.axis - 3);
    found.normal_w = face.side * now_w;
  } else if (normals_ == NormalRule::signed_distance) {
    const Separation gradient = deepest_gradient(first, second);
    if (gradient.axis != kNoAxis) found = gradient;
  }

  // The contact area along that normal. Where the rule's face misses it, as faces do that do not
  // lie over each other, the points are those of the shortest way out.
  if (found.axis != manifold.axis || found.normal_w != manifold.normal_w) {
    const Manifold exact = manifold;
    const double along = found.normal_w.dot(second.center_w - first.center_w);
    found.distance = along - reach(first, found.normal_w) - reach(second, found.normal_w);
    find_manifold(first, second, found, margin, manifold);
    if (manifold.count == 0) manifold = exact;
  }
  manifold.normal_w = found.normal_w;
  manifold.axis = found.axis;
}
// [S3.3.2:normal]

}  // namespace tumble
