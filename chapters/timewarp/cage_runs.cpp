/// \file
/// \brief Cubes in a cage under a form of the timewarp, and its work (thesis 2.4.3).
#include "timewarp/cage_runs.hpp"

#include "driver/finished.hpp"

namespace tumble::chapters {
namespace {

// Runs frames and returns what was done in them.
CageWork run(Technique& technique, World& world, double dt, int frames) {
  CageWork work;
  for (int k = 0; k < frames; ++k) {
    const StepReport report = finished(technique.step(world, dt));
    work.frames += 1.0;
    work.events += static_cast<double>(report.events);
    work.integrations += static_cast<double>(report.integrations);
    work.pair_tests += static_cast<double>(report.pair_tests);
    work.rewinds += static_cast<double>(report.rewinds);
  }
  return work;
}

}  // namespace

TimewarpForm all_taken_back() { return {"basic", {"search=discrete"}}; }

TimewarpForm full_timewarp(double stride) {
  return {"timewarp_full", {setting("stride", stride), "synchronise_every=0"}, true};
}

TimewarpForm synchronised_timewarp(int every) {
  return {"timewarp_full", {"stride=0", "synchronise_every=" + std::to_string(every)}};
}

Parameters cage_settings() {
  return Parameters{}
      .add_whole("seeds", 20, 2, 1000, "cages of each kind")
      .add_number("speed", 2.0, 0.01, 100.0, "m/s", "largest component of a velocity at the start")
      .add_number("spin", 2.0, 0.0, 100.0, "rad/s",
                  "largest component of an angular velocity at the start")
      .add_whole("lead", 30, 0, 10000, "frames of 1/60 s before work is counted");
}

CageStretch stretch_of(const Parameters& settings, int count) {
  CageStretch stretch;
  stretch.count = count;
  stretch.speed = settings.number("speed");
  stretch.spin = settings.number("spin");
  stretch.lead = settings.count("lead");
  stretch.settle = kLongFlight;
  return stretch;
}

World led_cage(const CageStretch& stretch, int seed) {
  World world =
      build_world(scene_with("cage",
                             {"count=" + std::to_string(stretch.count),
                              setting("speed", stretch.speed), setting("spin", stretch.spin)},
                             static_cast<std::uint64_t>(seed)));
  run(*make_technique("timewarp_swept"), world, stretch.dt, stretch.lead);
  return world;
}

SettledCage settled_cage(const World& led, const CageStretch& stretch) {
  SettledCage cage{led, led};
  for (BodyState& state : cage.before.states()) {
    state.linear_momentum_w *= stretch.factor;
    state.angular_momentum_w *= stretch.factor;
  }
  cage.after = cage.before;
  run(*make_technique("timewarp_swept"), cage.after, stretch.dt, stretch.settle);
  return cage;
}

CageWork work_of(const SettledCage& cage, const CageStretch& stretch, const TimewarpForm& form) {
  const std::unique_ptr<Technique> technique = make_technique(form.name, form.settings);
  World world = form.settles ? cage.before : cage.after;
  if (form.settles) run(*technique, world, stretch.dt, stretch.settle);
  return run(*technique, world, stretch.dt, stretch.frames);
}

double total(const Works& works, double CageWork::*count, int left_out) {
  double sum = 0.0;
  for (std::size_t k = 0; k < works.size(); ++k)
    if (static_cast<int>(k) != left_out) sum += works[k].*count;
  return sum;
}

double per_event(const Works& works, double CageWork::*count, int left_out) {
  return total(works, count, left_out) / total(works, &CageWork::events, left_out);
}

}  // namespace tumble::chapters
