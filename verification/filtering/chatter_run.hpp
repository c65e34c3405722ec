/// \file
/// \brief Shaking of the bodies of a scene under a technique once they should rest (thesis 5.5).
#pragma once

#include "tumble/record/chatter.hpp"
#include "tumble/record/overlap.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// Sums over the bodies that rest in both; lists in the order of ids.
inline std::vector<BodyChatter> resting_in_both(const std::vector<BodyChatter>& sums,
                                                const std::vector<BodyChatter>& more) {
  std::vector<BodyChatter> both;
  for (BodyChatter body : sums)
    for (const BodyChatter& other : more)
      if (other.id == body.id) {
        body.amplitude += other.amplitude;
        body.acceleration += other.acceleration;
        both.push_back(body);
      }
  return both;
}

inline double largest(const std::vector<BodyChatter>& bodies, double BodyChatter::*measure) {
  return bodies.empty() ? std::numeric_limits<double>::quiet_NaN() : largest_of(bodies, measure);
}

// What became of a scene that should come to rest. The same measure for all techniques:
// contact follows from the poses, within the distance of `tolerance::touching`.
struct ChatterRun {
  // Those that rest, half second by half second, from the settling to the end: see ChatterMeter.
  // Their measures are means over the half seconds.
  std::vector<BodyChatter> resting;
  int bodies = 0;                    // how many can move
  double displaced = 0.0;            // [m] from its start, of the centre that got farthest
  bool solved = true;                // false: a step was not solved, and nothing rests
  std::int64_t steps = 0;            // that were done
  std::int64_t capped = 0;           // steps that met the cap of events
  std::int64_t last_collisions = 0;  // that were resolved while the bodies were watched

  // The largest amplitude of a body that rests [m], NaN if nothing rests.
  [[nodiscard]] double amplitude() const { return largest(resting, &BodyChatter::amplitude); }
  // The largest acceleration of a body that rests [-], 1 is a free fall; NaN if nothing rests.
  [[nodiscard]] double acceleration() const { return largest(resting, &BodyChatter::acceleration); }
  // How many do not rest.
  [[nodiscard]] int restless() const { return bodies - static_cast<int>(resting.size()); }
};

// Simulates a scene of cubes with 60 steps a second and measures its chatter.
// settling: [s] before bodies should rest
// watched: [s] after that, half a second or more
inline ChatterRun chatter_of(const Scene& scene, const PlayedTechnique& played, double settling,
                             double watched, std::uint64_t seed = 1) {
  PlayedScene now(scene, played, seed);
  const std::vector<BodyState> start(now.world().states().begin(), now.world().states().end());
  ChatterRun run;
  for (const BodyProperties& body : now.world().bodies())
    if (body.movable()) ++run.bodies;
  const auto first = std::lround(settling / kStep);
  const auto half_seconds = std::lround(watched / kStep) / (ChatterMeter::kWindow - 1);
  const auto last = first + half_seconds * (ChatterMeter::kWindow - 1);
  OverlapMeter near;
  ChatterMeter meter;
  const auto look = [&] {
    near.look(now.world().bodies(), now.world().states());
    meter.add(now.world(), near.in_contact());
  };
  for (run.steps = 0; run.steps < last;) {
    if (run.steps == first) look();
    const StepReport report = now.Simulation::step(kStep);
    now.update_boxes();
    if (report.status >= StepStatus::unsolved) {
      run.solved = false;
      run.resting.clear();
      return run;
    }
    ++run.steps;
    if (report.status == StepStatus::event_cap) ++run.capped;  // shown in the table
    if (run.steps <= first) continue;
    run.last_collisions += report.events;
    look();
    if ((run.steps - first) % (ChatterMeter::kWindow - 1) != 0) continue;
    const std::vector<BodyChatter> each = meter.each(now.world().gravity_w.norm());
    run.resting =
        run.steps - first < ChatterMeter::kWindow ? each : resting_in_both(run.resting, each);
  }
  for (BodyChatter& body : run.resting) {
    body.amplitude /= static_cast<double>(half_seconds);
    body.acceleration /= static_cast<double>(half_seconds);
  }
  run.displaced = farthest_moved(start, now.world().states());
  return run;
}

}  // namespace tumble::chapters
