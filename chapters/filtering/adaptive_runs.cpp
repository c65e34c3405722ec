/// \file
/// \brief Runs with fixed and adaptive sub-steps, and throws at a thin plank.
#include "filtering/adaptive_runs.hpp"

#include "tumble/contact/tolerances.hpp"
#include "tumble/dynamics/step_report.hpp"
#include "tumble/record/chatter.hpp"

#include "driver/finished.hpp"

namespace tumble::chapters {
namespace {

double time_of_rest(const SettledRun& run, std::size_t index) {
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

}  // namespace

Parameters adaptive_parameters(int seeds, int per_edge, int halvings) {
  return Parameters{}
      .add_whole("seeds", seeds, 2, 1000, "clumps")
      .add_whole("per_edge", per_edge, 1, 10, "cubes along each edge of the grid at the start")
      .add_number("settling", 4.0, 0.5, 1000.0, "s", "before bodies should rest")
      .add_number("watched", 2.0, 0.5, 1000.0, "s", "after that, a multiple of half a second")
      .add_whole("halvings", halvings, 0, 10, "of a step, at most");
}

AdaptiveStepOptions fixed_steps(int halvings) {
  AdaptiveStepOptions options;
  options.halvings = halvings;
  options.fewest = halvings;
  return options;
}

SteppedRun settle_in_steps(const Scene& scene, std::unique_ptr<Technique> technique,
                           const AdaptiveStepOptions& options, double settling, double watched) {
  auto divided = std::make_unique<AdaptiveStep>(std::move(technique), options);
  const AdaptiveStep& steps = *divided;
  PlayedScene played(scene, std::move(divided));
  SteppedRun out;
  out.run = record_run(
      played, settling, watched,
      [&](const World& world, std::vector<char>& touches) {
        touches.assign(static_cast<std::size_t>(world.count()), 0);
        for (const BodyId id : steps.touched())
          touches[static_cast<std::size_t>(world.index_of(id))] = 1;
      },
      [&](const StepReport& report) {
        add_report(report, out.work);
        out.substeps.push_back(static_cast<int>(steps.substeps().size()));
      });
  return out;
}

RestingMeasures measure_resting(const SettledRun& run) {
  RestingMeasures out;
  for (std::size_t k = 0; k < run.world.bodies().size(); ++k)
    if (run.world.bodies()[k].movable()) out.times.push_back(time_of_rest(run, k));
  for (const std::size_t k : resting_bodies(run))
    out.amplitudes.push_back(settled_shake(run, k).amplitude);
  std::sort(out.times.begin(), out.times.end());
  std::sort(out.amplitudes.begin(), out.amplitudes.end());
  return out;
}

double RestingMeasures::chatter() const { return amplitudes.empty() ? 0.0 : median_of(amplitudes); }

double RestingMeasures::mean_chatter() const {
  if (amplitudes.empty()) return 0.0;
  return std::accumulate(amplitudes.begin(), amplitudes.end(), 0.0) /
         static_cast<double>(amplitudes.size());
}

double RestingMeasures::time_to_rest(double share) const {
  const double bodies = std::ceil(share * static_cast<double>(times.size()));
  return times[static_cast<std::size_t>(std::max(bodies, 1.0)) - 1];
}

double share_moving(const RestingMeasures& measured, double time) {
  const auto moving =
      measured.times.end() - std::lower_bound(measured.times.begin(), measured.times.end(), time);
  return static_cast<double>(moving) / static_cast<double>(measured.times.size());
}

double share_through(double speed, int throws, const AdaptiveStepOptions& options) {
  int through = 0;
  for (int k = 0; k < throws; ++k) {
    World world;
    world.add(fixed_box_properties(Vec3(0.05, 20.0, 20.0)), BodyState{});
    const BodyProperties cube = box_properties(Vec3::Constant(0.2), 1.0);
    const double distance = 0.5 + speed * kStep * (k + 0.5) / throws;  // [m] of the centres
    const BodyId id = world.add(
        cube, make_state(cube, Vec3(-distance, 0.0, 0.0), Quat::Identity(), Vec3(speed, 0.0, 0.0)));
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
