/// \file
/// \brief The basic colliding technique.
#include "tumble/basic_colliding/basic.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/contact/contact_records.hpp"
#include "tumble/contact/parts_of_turn.hpp"
#include "tumble/dynamics/step_mistakes.hpp"

#include <algorithm>
#include <string>

namespace tumble {

Basic::Basic(const BasicOptions& options) : options_(options) {
  require::positive(options.resolution, "resolution");
  require::that(options.event_cap >= 1,
                "event_cap = " + std::to_string(options.event_cap) + ": expected 1 or more");
}

StepReport Basic::step(World& world, double dt) {
  require_resolved(dt, options_.resolution);
  records_.clear();
  return step_in_parts(world, dt, [&](World& w, double part, int) { return step_part(w, part); });
}

StepReport Basic::step_part(World& world, double dt) {
  StepReport report;
  released_.clear();
  double elapsed = 0.0;  // [s] of this step
  for (int moment = 0;; ++moment) {
    // [S2.1:search]
    // Let all bodies fly to the end of the step, and see whether
    // two of them overlap there. If so, search back for the moment
    // at which the first two meet.
    const double remaining = dt - elapsed;
    if (!(remaining > 0.0)) break;  // an impact came with the end
    const FirstEvent& found = find_first(world, remaining, report);
    // [S2.1:search]

    // Bodies that overlap when the step begins, and go deeper, collide before anything moves.
    touching_.clear();
    for (const StartOverlap& overlap : found.overlapping_at_start)
      if (moment == 0 && overlap.deepening) touching_.push_back(overlap.pair);
    const bool at_once = !touching_.empty();
    const bool collide = at_once || found.status == CollisionStatus::found;

    // [S2.1:fly_on]
    // No collision, or no end of them: fly to the end of the step.
    const bool lost = found.status == CollisionStatus::cap_reached;
    const bool endless = collide && moment == options_.event_cap;
    const bool capped = lost || endless;
    if (capped) report.status = StepStatus::event_cap;
    if (!collide || capped) {
      fly_all(world, remaining, report);
      break;
    }
    // [S2.1:fly_on]

    // [S2.1:resolve]
    // Put all bodies back to the last moment at which they are
    // apart, and resolve the impact there.
    Event impact;
    if (!at_once) {
      touching_ = found.touching;
      elapsed += found.time;
      impact.rewinds = fly_all(world, found.time, report);
      impact.restarts = static_cast<int>(found.restarts);
      report.rewinds += impact.rewinds;
    }
    impact.time = world.time() + elapsed;
    const double speed_change = resolve(world, impact, report);
    // [S2.1:resolve]
    release_rounding(world, speed_change, dt - elapsed);
  }
  repair_overlap(world, report);
  return report;
}

Flight Basic::flight_of(const World& world) const {
  return Flight{.bodies = world.bodies(),
                .states = world.states(),
                .gravity_w = world.gravity_w,
                .rule = options_.rotation};
}

// The first impact in the time that is left, if all bodies fly on.
const FirstEvent& Basic::find_first(const World& world, double remaining, StepReport& report) {
  const auto half_diagonal = [&](std::size_t k) { return 0.5 * world.bodies()[k].size.norm(); };
  find_flight_pairs(world, remaining, half_diagonal, broad_phase_, bounds_, candidates_);
  const auto released = [&](const IndexPair& pair) {
    return std::find(released_.begin(), released_.end(), pair) != released_.end();
  };
  candidates_.erase(std::remove_if(candidates_.begin(), candidates_.end(), released),
                    candidates_.end());
  const Flight flight = flight_of(world);
  const SearchOptions how{.method = options_.search,
                          .resolution = std::min(options_.resolution, remaining)};
  const FirstEvent& found = search_.find(flight, candidates_, 0.0, remaining, how);
  report.pair_tests += found.pair_tests;
  report.searches += found.evaluations;
  report.restarts += found.restarts;
  return found;
}

// Returns how many bodies flew.
int Basic::fly_all(World& world, double time, StepReport& report) const {
  int moved = 0;
  for (std::size_t k = 0; k < world.bodies().size(); ++k) {
    if (!world.bodies()[k].movable()) continue;
    fly(world.bodies()[k], world.states()[k], world.gravity_w, time, options_.rotation);
    ++moved;
  }
  report.integrations += moved;
  return moved;
}

// The impact of all pairs that touch at this moment.
// Returns by how much it changed the speed of a body at most [m/s].
double Basic::resolve(World& world, const Event& moment, StepReport& report) {
  load_moving_bodies(world, moving_);
  const double margin = search_margin(world, moving_, touching_, options_.resolution);
  const GatherReport gathered = gather_contacts(world, moving_, touching_, margin, {}, contacts_);
  report.pair_tests += gathered.pair_tests;

  const ImpactResult impact = impacts_.resolve(contacts_, moving_, {.order = options_.impacts});
  store_moving_bodies(moving_, world);
  if (impact.status != ImpactStatus::done)
    report.status = std::max(report.status, StepStatus::event_cap);
  report.events += impact.collisions;
  book(impact, report);
  add_records(contacts_, moment.time, records_);
  for (const Contact& contact : contacts_) report_collision(contact, moment, observer());
  double speed_change = 0.0;
  for (const Contact& contact : contacts_) {
    double impulse = 0.0;
    for (int p = 0; p < contact.count; ++p) impulse += contact.points[idx(p)].normal_impulse;
    for (const int body : {contact.first, contact.second})
      speed_change = std::max(speed_change, impulse * moving_[idx(body)].inverse_mass.maxCoeff());
  }
  return speed_change;
}

// Pairs that touch, hardly push, and overlap at the end by less than a rounding: the search would
// find them for ever at this same moment. They are left out until a body is pushed.
void Basic::release_rounding(const World& world, double speed_change, double remaining) {
  const Flight flight = flight_of(world);
  for (const IndexPair& pair : touching_) {
    double size = 0.0;
    for (const int body : {pair.first, pair.second})
      if (world.bodies()[idx(body)].movable())
        size = std::max(size, world.bodies()[idx(body)].size.maxCoeff());
    const double rounding = tolerance::rounding_overlap * size;
    if (speed_change * remaining > rounding) return released_.clear();
    if (gap_at(flight, pair, remaining).distance > -rounding) released_.push_back(pair);
  }
}

// What is left of overlap (rounding, a capped step, a missed collision) is repaired by moving
// bodies (thesis 4.4).
void Basic::repair_overlap(World& world, StepReport& report) {
  repair_bounds(world, 0.0, bounds_);
  broad_phase_.find_pairs(bounds_, candidates_);
  book(repair_.run(world, candidates_), report);
  report.contacts = static_cast<std::int64_t>(records_.size());
}

}  // namespace tumble
