/// \file
/// \brief Runs with fixed and adaptive sub-steps, when their bodies come to rest, and cubes thrown at a
///        thin plank (thesis 6.3.1).
#pragma once

#include "tumble/contact/tolerances.hpp"
#include "tumble/filtering/adaptive_step.hpp"
#include "tumble/record/chatter.hpp"

#include "driver/experiment.hpp"
#include "filtering/settled_run.hpp"

namespace tumble::chapters {

// The settings of a figure on adaptive steps.
inline Parameters adaptive_parameters(int seeds, int per_edge, int halvings) {
  return {whole("seeds", seeds, 2, 1000, "clumps"),
          whole("per_edge", per_edge, 1, 10, "cubes along each edge of the grid at the start"),
          number("settling", 4.0, 0.5, 1000.0, "s", "before bodies should rest"),
          number("watched", 2.0, 0.5, 1000.0, "s", "after that, a multiple of half a second"),
          whole("halvings", halvings, 0, 10, "of a step, at most")};
}

// A run at 60 frames a second whose steps were divided, and what it took.
struct SteppedRun {
  SettledRun run;             // in contact in a frame: in any sub-step since the frame before
  std::vector<int> substeps;  // by frame; none at the start
};

// Lets a scene play with divided steps, and records its frames.
// settling: [s] before bodies should rest
// watched: [s] after that, a multiple of half a second
inline SteppedRun settle_in_steps(const Scene& scene, std::unique_ptr<Technique> technique,
                                  const AdaptiveStepOptions& options, double settling,
                                  double watched) {
  auto divided = std::make_unique<AdaptiveStep>(std::move(technique), options);
  const AdaptiveStep& steps = *divided;
  PlayedScene played(scene, std::move(divided));
  SteppedRun out;
  record_until(
      settling + watched, played,
      [&](const World& world, std::vector<char>& touches) {
        touches.assign(static_cast<std::size_t>(world.count()), 0);
        for (const BodyId id : steps.touched())
          touches[static_cast<std::size_t>(world.index_of(id))] = 1;
        out.substeps.push_back(static_cast<int>(steps.substeps().size()));
      },
      out.run);
  out.run.first = static_cast<int>(std::lround(settling / kStep));
  return out;
}

// Every step divided alike.
inline AdaptiveStepOptions fixed_steps(int halvings) {
  return AdaptiveStepOptions{.halvings = halvings, .fewest = halvings};
}

// How the bodies of a run come to rest, and how those shake that do.
//
// A body has come to rest when no corner of it ends a half second farther than a hundredth of the
// shortest edge from where it began it: this is what resting means to ChatterMeter, so that chatter
// does not keep a body from resting and creeping does. Its time of rest is the end of the last half
// second in which that was not so; a body that never rests has the end of the run. The time to rest of a
// run is when nine tenths of its bodies have come to rest: the last few of a clump may roll for
// long, and half of one lies on the ground soon.
struct RestingMeasures {
  std::vector<double> times;       // [s] of rest, by movable body, ascending
  std::vector<double> amplitudes;  // [m] of the bodies that rest while watched, ascending

  // Chatter as the claim has it.
  // Returns [m] median amplitude of the bodies that rest; 0 if none does
  [[nodiscard]] double chatter() const { return amplitudes.empty() ? 0.0 : median_of(amplitudes); }
  // Another mean of it.
  // Returns [m] mean amplitude of the bodies that rest; 0 if none does
  [[nodiscard]] double mean_chatter() const {
    if (amplitudes.empty()) return 0.0;
    return std::accumulate(amplitudes.begin(), amplitudes.end(), 0.0) /
           static_cast<double>(amplitudes.size());
  }
  // When a share of the bodies has come to rest.
  // share: [-] above 0, up to 1
  // Returns [s]
  [[nodiscard]] double time_to_rest(double share = 0.9) const {
    const double bodies = std::ceil(share * static_cast<double>(times.size()));
    return times[static_cast<std::size_t>(std::max(bodies, 1.0)) - 1];
  }
};

inline double time_of_rest(const SettledRun& run, std::size_t index) {
  const BodyProperties& body = run.world.bodies()[index];
  const double limit = tolerance::resting_movement * body.size.minCoeff();
  const auto corners = [&](int frame) {
    return corners_of(box_of(body, run.frames.frame(frame).states[index]));
  };
  constexpr int kWay = ChatterMeter::kWindow - 1;  // steps in half a second
  for (int end = run.frames.count() - 1; end >= kWay; --end)
    if (!(largest_displacement(corners(end - kWay), corners(end)) < limit)) return end * kStep;
  return 0.0;
}

// Measures a run.
inline RestingMeasures measure_resting(const SettledRun& run) {
  RestingMeasures out;
  for (std::size_t k = 0; k < run.world.bodies().size(); ++k)
    if (run.world.bodies()[k].movable()) out.times.push_back(time_of_rest(run, k));
  for (const std::size_t k : resting_bodies(run))
    out.amplitudes.push_back(settled_shake(run, k).amplitude);
  std::ranges::sort(out.times);
  std::ranges::sort(out.amplitudes);
  return out;
}

// The share of the bodies that still move: those whose time of rest is not yet over.
// time: [s] of the frame
// Returns [-] 0 to 1
inline double share_moving(const RestingMeasures& measured, double time) {
  const auto moving =
      measured.times.end() - std::lower_bound(measured.times.begin(), measured.times.end(), time);
  return static_cast<double>(moving) / static_cast<double>(measured.times.size());
}

// Throws cubes of 0.2 m at a fixed plank of 0.05 m, from distances that differ by less than the way
// in a step, under `damped` at 60 steps a second.
// speed: [m/s] of the cube, above 0
// Returns [-] share of them that end behind the plank
inline double share_through(double speed, int throws, const AdaptiveStepOptions& options) {
  int through = 0;
  for (int k = 0; k < throws; ++k) {
    World world;
    world.add(fixed_box_properties(Vec3(0.05, 20.0, 20.0)), BodyState{});
    const double distance = 0.5 + speed * kStep * (k + 0.5) / throws;  // [m] of the centres
    const BodyId id = world.add(box_properties(Vec3::Constant(0.2), 1.0), Vec3(-distance, 0.0, 0.0),
                                Quat::Identity(), Vec3(speed, 0.0, 0.0));
    AdaptiveStep technique(make_technique("damped", {}, 1), options);
    // Until it would be half a metre behind it, and some frames.
    const double end = (distance + 0.5) / speed + 4.0 * kStep;
    while (world.time() < end) finished(technique.step(world, kStep));
    const auto index = static_cast<std::size_t>(world.index_of(id));
    through += world.states()[index].position_w.x() > 0.0 ? 1 : 0;
  }
  return static_cast<double>(through) / throws;
}

}  // namespace tumble::chapters
