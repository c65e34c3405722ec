/// \file
/// \brief The default technique: islands that are solved again, as bodies were sent into others or turned into them.
#include "tumble/base/index.hpp"
#include "tumble/contact_damped/body_motion.hpp"
#include "tumble/contact_damped/contact_damped.hpp"
#include "tumble/contact_damped/island_plan.hpp"
#include "tumble/contact_damped/tolerances.hpp"
#include "tumble/contact_patches/tolerances.hpp"
#include "tumble/dynamics/flight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

// [-] Overlap, as a share of the shortest edge, beyond which a tenth of tolerance::sunk_by_turning counts, in islands within the
// budget. Reason: bodies that turn on each other may gain a little in each step, and repair takes a fifth of it: two of 2300
// random worlds ended above 1 %. Beyond the budget more sweeps follow only, and falling heaps of a thousand cubes get deeper. (3.2)
constexpr double kDeepOverlap = 0.005;
constexpr double kIfDeep = 0.1;

// How far the bodies of a patch are apart at the end of the step [m]; below 0 they overlap.
double distance_after(const Island& island, const BodyMotion& motion, const ContactPatch& patch) {
  const auto after = [&](int k) {
    return state_after(motion, k, island.now[idx(k)], island.world);
  };
  const std::span<const BodyProperties> bodies = island.world.bodies();
  return gap_between(bodies[idx(patch.first)], after(patch.first), bodies[idx(patch.second)],
                     after(patch.second))
      .distance;
}

// Whether a body turns in the step so far that it shows, or would without contacts: targets allow for that.
bool turns(const Island& island, int k) {
  return island.dt * std::max(island.now[idx(k)].angular_velocity_w.norm(),
                              island.free[idx(k)].angular_velocity_w.norm()) >
         tolerance::turn_that_shows;
}

// What the points of a patch leave out: its bodies turn in the step, and with them its normal.
struct Turned {
  double deeper = 0.0;    // [m] more overlap than at the start of the step
  double counts = 1.0;    // [m] from where on that counts
  double expected = 0.0;  // [m] how far apart the nearest point says that the bodies will be
};

// `if_deep`: where they overlap deeply this share of more counts.
Turned turned_in_step(const Island& island, const BodyMotion& motion, const ContactPatch& patch,
                      double if_deep) {
  if (!turns(island, patch.first) && !turns(island, patch.second)) return {};
  const Six u = motion_of(patch, island.now[idx(patch.first)], island.now[idx(patch.second)]);
  double expected = std::numeric_limits<double>::infinity();
  double overlap = 0.0;
  for (const ContactPatchPoint& p : patch.used()) {
    expected = std::min(expected, p.gap + island.dt * velocity_at(p.along, p.across, u).z());
    overlap = std::max(overlap, -p.gap);
  }
  const double counts = (overlap > kDeepOverlap * patch.size ? if_deep : 1.0) *
                        tolerance::sunk_by_turning * patch.size;
  return {-overlap - distance_after(island, motion, patch), counts, expected};
}

// The farthest turn of a body of an island in the step [rad].
double farthest_turn(const Island& island) {
  double square = 0.0;
  for (const int k : island.bodies)
    square = std::max(square, island.now[idx(k)].angular_velocity_w.squaredNorm());
  return island.dt * std::sqrt(square);
}

// The most that bodies of an island sink into each other in the step by turning, as a share of what counts.
double sunk_by_turning(const Island& island, const BodyMotion& motion, double if_deep) {
  if (std::none_of(island.bodies.begin(), island.bodies.end(),
                   [&](int k) { return turns(island, k); }))
    return 0.0;  // as at rest
  double most = 0.0;
  for (const int contact : island.patch_indices) {
    const ContactPatch& patch = island.all_patches[idx(contact)];
    const Turned turned = turned_in_step(island, motion, patch, if_deep);
    most = std::max(most, turned.deeper / turned.counts);
  }
  return most;
}

// Adds the points where bodies sink so, if they were too far apart for a patch; else asks its points to end as much higher.
void raise_targets(const Island& island, const BodyMotion& motion, double if_deep,
                   PersistentManifolds& manifolds) {
  for (const int contact : island.patch_indices) {
    ContactPatch& patch = island.all_patches[idx(contact)];
    const Turned turned = turned_in_step(island, motion, patch, if_deep);
    if (!(turned.deeper > turned.counts)) continue;
    if (manifolds.add_points(island.world, island.now, island.dt, patch)) continue;
    for (ContactPatchPoint& p : patch.used())
      p.target = std::max(p.target, (turned.expected + turned.deeper - p.gap) / island.dt);
    patch.targets_planar = false;
  }
}

}  // namespace

// Whether impulses send a body along a way that was not searched.
bool ContactDamped::is_sent_elsewhere(const World& world, double dt) const {
  // Candidates were found along `free`; at rest `end` is `start`, which the margins include.
  const auto differs = [&](std::size_t k, const std::vector<MovingBody>& velocities) {
    const BodyProperties& body = world.bodies()[k];
    return dt * fastest_point_change(body, velocities[k], velocities_.end[k]) >
           tolerance::kept_margin * body.size.minCoeff();
  };
  for (std::size_t k = 0; k < velocities_.end.size(); ++k)
    if (world.bodies()[k].movable() && differs(k, velocities_.start) &&
        differs(k, velocities_.free))
      return true;
  return false;
}

// Adds the pairs that impulses push together. Returns whether there are any.
bool ContactDamped::find_missed(const World& world, double dt) {
  PersistentManifolds& manifolds = memory_.manifolds;
  if (!is_sent_elsewhere(world, dt)) return false;
  find_candidates(world, velocities_.end, dt);
  if (manifolds.add_missed(world, velocities_.end, storage_.candidates, dt) == 0) return false;
  storage_.touching.clear();
  for (const ContactPatch& patch : manifolds.patches())
    storage_.touching.push_back({patch.first, patch.second});
  memory_.order.update(world, manifolds.patches(), storage_.touching);
  return true;
}

// Impulses may send a body where nothing was found on its way. The islands of such pairs are solved again, with them. That may send
// the next body on: an impact goes through a row in one step, as far as there is time.
void ContactDamped::solve_missed(const World& world, double dt, StepReport& report) {
  std::uint64_t last = memory_.manifolds.last_stamp();
  for (int n = 0; n < tolerance::rounds_of_missed && find_missed(world, dt); ++n) {
    for (int k = 0; k < memory_.order.islands().count(); ++k) {
      const Island island = view_of_island(world, k, dt);
      if (std::any_of(island.patch_indices.begin(), island.patch_indices.end(),
                      [&](int contact) { return island.all_patches[idx(contact)].stamp > last; }))
        solve_again(island, report);
    }
    if (costs_too_much()) return;
    last = memory_.manifolds.last_stamp();
  }
}

// Impulses hold points along the normal of the start of the step. A body that turns takes the normal with it, and its corners
// along an arc. Where bodies so sink into each other, points are asked for as much more, and the island is solved again.
// Solutions with which they sink further, or that make a body spin, are not taken. Notes whether bodies of a small island sink all
// the same: step_part() makes a shorter part then.
void ContactDamped::solve_turning(const World& world, double dt, StepReport& report) {
  const BodyMotion motion{dt, options_.rotation, storage_.in_flight};
  storage_.small_sinks = false;
  for (int k = 0; k < memory_.order.islands().count(); ++k) {
    const Island island = view_of_island(world, k, dt);
    const double if_deep = exceeds_budget(island, effort()) ? 1.0 : kIfDeep;
    // [S6.3.1:turning]
    double sunk = sunk_by_turning(island, motion, if_deep);
    for (int n = 0; n < tolerance::solutions_for_turning && sunk > 1.0; ++n) {
      const double most_turn = std::max(farthest_turn(island), tolerance::turn_given_way);
      storage_.kept.keep(island, storage_.in_flight);
      raise_targets(island, motion, if_deep, memory_.manifolds);
      solve_again(island, report);
      const double now = sunk_by_turning(island, motion, if_deep);
      if (!(now < sunk) || farthest_turn(island) > most_turn) {
        storage_.kept.restore(island, storage_.in_flight);
        break;
      }
      sunk = now;
    }
    // [S6.3.1:turning]
    if (is_small(island) && sunk > 1.0) storage_.small_sinks = true;
  }
}

}  // namespace tumble
