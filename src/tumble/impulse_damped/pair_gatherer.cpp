/// \file
/// \brief Overlapping pairs: normals by one of three rules, one point or the contact area.
#include "tumble/impulse_damped/pair_gatherer.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/geometry/overlap_normals.hpp"
#include "tumble/impulse_damped/tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace tumble {
namespace {

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
    : normals_(normals), points_(points), broad_phase_(make_broad_phase("bounding_tree")) {}

PairGatherer::PairGatherer(const PairGatherer& other)
    : normals_(other.normals_), points_(other.points_), broad_phase_(other.broad_phase_->clone()) {}

PairReport PairGatherer::gather(const World& world, std::span<const BodyState> last,
                                std::span<const BodyState> now, const SleepingRule* sleeping,
                                double margin, ContactList& out) {
  const std::span<const BodyProperties> bodies = world.bodies();
  require::that(last.size() == bodies.size() && now.size() == bodies.size(),
                "states: one entry for each body of the world is needed");
  require::not_negative(margin, "margin");
  bounds_.resize(bodies.size());
  for (std::size_t k = 0; k < bodies.size(); ++k)
    bounds_[k] = bounds_of(bodies[k], now[k],
                           0.5 * margin + tolerance::rounding_overlap * bodies[k].size.maxCoeff());
  broad_phase_->find_pairs(bounds_, pairs_);

  out.clear();
  PairReport report;
  for (const IndexPair& pair : pairs_) {
    const BodyProperties& a = bodies[idx(pair.first)];
    const BodyProperties& b = bodies[idx(pair.second)];
    const bool still = (!a.movable() || world.sleep_states()[idx(pair.first)].asleep) &&
                       (!b.movable() || world.sleep_states()[idx(pair.second)].asleep);
    if (sleeping != nullptr ? !sleeping->needs_test(pair.first, pair.second) : still) continue;
    if (!a.movable() && !b.movable()) continue;
    ++report.pair_tests;

    Manifold manifold;
    if (!touch_pair(world, now, pair, margin, kNoAxis, manifold)) continue;
    Contact contact = contact_of(world, pair);
    set_points(manifold, contact);
    if (a.shape == Shape::box && b.shape == Shape::box)
      turn_normal(box_of(a, now[idx(pair.first)]), box_of(b, now[idx(pair.second)]),
                  box_of(a, last[idx(pair.first)]), box_of(b, last[idx(pair.second)]), margin,
                  manifold, contact);
    for (int p = 0; p < contact.count; ++p)
      report.deepest_overlap = std::max(report.deepest_overlap, -contact.points[idx(p)].distance);
    if (points_ == PointRule::one) reduce_to_one(shortest_edge(a, b), contact);
    out.push_back(contact);
  }
  return report;
}

// [S3.3.2:normal]
// The normal of two boxes that touch by the rule, and where they touch along it.
void PairGatherer::turn_normal(const Box& first, const Box& second, const Box& first_last,
                               const Box& second_last, double margin, Manifold& manifold,
                               Contact& contact) const {
  Separation found{0.0, manifold.normal_w, manifold.axis};
  if (normals_ == NormalRule::last_face) {
    // The face that was closest when the step began, turned with its body since. The normal keeps
    // the side on which the other box was then.
    found = closest_face(first_last, second_last);
    const AxisIndex i = found.axis;
    const Vec3 then_w = i < 3 ? first_last.axes_w.col(i) : second_last.axes_w.col(i - 3);
    const Vec3 now_w = i < 3 ? first.axes_w.col(i) : second.axes_w.col(i - 3);
    const double side = then_w.dot(found.normal_w) < 0.0 ? -1.0 : 1.0;
    found.normal_w = side * now_w;
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
  set_points(manifold, contact);
  contact.normal_w = found.normal_w;
  contact.axis = found.axis;
}
// [S3.3.2:normal]

}  // namespace tumble
