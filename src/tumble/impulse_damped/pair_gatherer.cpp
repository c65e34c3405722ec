/// \file
/// \brief Overlapping pairs: normals by one of three rules, one point or the contact area.
#include "tumble/impulse_damped/pair_gatherer.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/suggestion.hpp"
#include "tumble/geometry/ground.hpp"
#include "tumble/geometry/signed_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace tumble {
namespace {

// s(n) along a face axis, 0 to 5, with the normal from the first box to the second.
Separation along_face(const Box& first, const Box& second, AxisIndex axis) {
  const Vec3 n_w = axis < 3 ? first.axes_w.col(axis) : second.axes_w.col(axis - 3);
  const double along = n_w.dot(second.center_w - first.center_w);
  return Separation{std::abs(along) - reach(first, n_w) - reach(second, n_w),
                    along < 0.0 ? Vec3(-n_w) : n_w, axis};
}

// A surface point of one box, and the other box's distance there.
struct Probe {
  double distance = 0.0;  // [m] of the deepest point found so far; 0: none is inside
  AxisIndex axis = kNoAxis;
  Vec3 outward_w = Vec3::Zero();
};

// Looks at 26 points of `probing` from the distance function of `box`, whose axes have the numbers
// base to base + 2. A point must be deeper than what was found by more than a tie.
void probe(const Box& probing, const Box& box, AxisIndex base, double tie, Probe& deepest) {
  for (int i = 0; i < 27; ++i) {
    const Vec3 unit(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (unit.isZero(0.0)) continue;
    const Vec3 point_w = probing.center_w + probing.axes_w * unit.cwiseProduct(probing.half);
    const SignedDistance found = signed_distance(box, point_w);
    if (!(found.distance < deepest.distance - tie)) continue;
    int axis = 0;  // inside, the gradient is one of the box's axes
    (box.axes_w.transpose() * found.gradient_w).cwiseAbs().maxCoeff(&axis);
    deepest = Probe{found.distance, base + axis, found.gradient_w};
  }
}

// The centre of the points that overlap, each weighted by its depth.
void reduce_to_one(Contact& contact) {
  double weight = 0.0;
  double deepest = std::numeric_limits<double>::infinity();
  Vec3 sum_w = Vec3::Zero();
  Vec3 plain_w = Vec3::Zero();
  FeatureId feature = 0;
  for (int p = 0; p < contact.count; ++p) {
    const ContactPoint& point = contact.points[at(p)];
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
  centre.position_w = weight > 0.0 ? Vec3(sum_w / weight) : Vec3(plain_w / contact.count);
  centre.distance = deepest;
  centre.feature = feature;
  contact.points[0] = centre;
  contact.count = 1;
}

}  // namespace

Separation closest_face(const Box& first, const Box& second) {
  const double tie = tolerance::face_tie * std::min(first.half.minCoeff(), second.half.minCoeff());
  Separation best = along_face(first, second, 0);
  for (AxisIndex axis = 1; axis < 6; ++axis) {
    const Separation found = along_face(first, second, axis);
    if (found.distance > best.distance + tie) best = found;
  }
  return best;
}

Separation deepest_gradient(const Box& first, const Box& second) {
  const double tie = tolerance::face_tie * std::min(first.half.minCoeff(), second.half.minCoeff());
  Probe deepest;
  probe(second, first, 0, tie, deepest);
  const AxisIndex of_first = deepest.axis;
  probe(first, second, 3, tie, deepest);
  if (deepest.axis == kNoAxis) return {};
  // The second box leaves the first along the first one's gradient, or against its own.
  const Vec3 normal_w = deepest.axis == of_first ? deepest.outward_w : Vec3(-deepest.outward_w);
  const double along = normal_w.dot(second.center_w - first.center_w);
  return Separation{along - reach(first, normal_w) - reach(second, normal_w), normal_w,
                    deepest.axis};
}

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
    const BodyProperties& a = bodies[at(pair.first)];
    const BodyProperties& b = bodies[at(pair.second)];
    const bool still = (!a.movable() || world.sleep_states()[at(pair.first)].asleep) &&
                       (!b.movable() || world.sleep_states()[at(pair.second)].asleep);
    if (sleeping != nullptr ? !sleeping->needs_test(pair.first, pair.second) : still) continue;
    if (!a.movable() && !b.movable()) continue;
    ++report.pair_tests;

    Contact contact;
    contact.first = pair.first;
    contact.second = pair.second;
    contact.first_id = world.ids()[at(pair.first)];
    contact.second_id = world.ids()[at(pair.second)];
    contact.friction = std::sqrt(a.friction * b.friction);
    contact.restitution = std::max(a.restitution, b.restitution);
    const bool ground_first = a.shape == Shape::ground;
    if (ground_first || b.shape == Shape::ground) {
      const int box = ground_first ? pair.second : pair.first;
      Manifold manifold;
      if (!collide_with_ground(box_of(bodies[at(box)], now[at(box)]), margin, manifold)) continue;
      contact.normal_w = ground_first ? manifold.normal_w : Vec3(-manifold.normal_w);
      contact.count = manifold.count;
      for (int p = 0; p < manifold.count; ++p) {
        const ManifoldPoint& point = manifold.points[at(p)];
        contact.points[at(p)].position_w = point.position_w;
        contact.points[at(p)].distance = point.distance;
        contact.points[at(p)].feature = point.feature;
      }
    } else if (!touch(box_of(a, now[at(pair.first)]), box_of(b, now[at(pair.second)]),
                      box_of(a, last[at(pair.first)]), box_of(b, last[at(pair.second)]), margin,
                      contact)) {
      continue;
    }
    for (int p = 0; p < contact.count; ++p)
      report.deepest_overlap = std::max(report.deepest_overlap, -contact.points[at(p)].distance);
    if (points_ == PointRule::one) reduce_to_one(contact);
    out.push_back(contact);
  }
  return report;
}

// [S3.3.2:normal]
// Whether two boxes touch, and if so, along which normal and where.
bool PairGatherer::touch(const Box& first, const Box& second, const Box& first_last,
                         const Box& second_last, double margin, Contact& contact) const {
  Manifold manifold;
  if (!collide(first, second, margin, kNoAxis, manifold)) return false;
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
  contact.normal_w = found.normal_w;
  contact.axis = found.axis;
  contact.count = manifold.count;
  for (int p = 0; p < manifold.count; ++p) {
    const ManifoldPoint& point = manifold.points[at(p)];
    contact.points[at(p)].position_w = point.position_w;
    contact.points[at(p)].distance = point.distance;
    contact.points[at(p)].feature = point.feature;
  }
  return true;
}
// [S3.3.2:normal]

}  // namespace tumble
