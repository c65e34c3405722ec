/// \file
/// \brief Cubes in a cage under a form of the timewarp, and its work (thesis 2.4.3).
#pragma once

#include "driver/experiment.hpp"

#include <tuple>

namespace tumble::chapters {

// [frames] Length of full timewarp's flights where no synchronisation ends them. Reason: about the
// time from one collision of a body in the cage to its next; pair tests are fewest there.
inline constexpr int kLongFlight = 8;

// A technique of the library with some of its options changed.
struct TimewarpForm {
  std::string name;                        // in the library, for example "timewarp_simple"
  std::vector<std::string> settings = {};  // each as key=value
  bool settles = false;  // bodies are ahead of the frame, so that a start differs from what follows
};

// All bodies taken back for each collision; pairs that overlap at the end of the frame are searched.
inline TimewarpForm all_taken_back() { return {"basic", {"search=discrete"}}; }

// Full timewarp that is never synchronised.
// stride: [frames] length of a flight, above 0
inline TimewarpForm full_timewarp(double stride = kLongFlight) {
  return {"timewarp_full", {setting("stride", stride), "synchronise_every=0"}, true};
}

// Full timewarp in which all bodies wait for one another now and then; they fly until then.
// every: [frames] from one synchronisation to the next, at least 1
inline TimewarpForm synchronised_timewarp(int every) {
  return {"timewarp_full", {"stride=0", "synchronise_every=" + std::to_string(every)}};
}

// Work of a stretch of a run; sums over seeds can be made of it.
struct CageWork {
  double frames = 0.0;        // [-]
  double events = 0.0;        // collisions
  double integrations = 0.0;  // flights of one body
  double pair_tests = 0.0;    // separation tests
  double rewinds = 0.0;       // bodies taken back
};

// The work of the same stretch in several cages, by seed.
using Works = std::vector<CageWork>;

// A cage, and the frames of its run in which work is counted.
struct CageStretch {
  int count = 512;       // cubes; a cube number, so that the cage is full
  double speed = 2.0;    // [m/s] largest component of a velocity at the start
  double spin = 2.0;     // [rad/s] largest component of an angular velocity at the start
  double factor = 1.0;   // [-] by which all velocities are multiplied after the lead
  int lead = 30;         // frames before anything else, so that the grid of the start is forgotten
  int settle = 0;        // frames after that in which a technique with memory finds its stride
  int frames = 6;        // frames in which work is counted
  double dt = 1.0 / 60;  // [s] of a frame
};

// The settings that the figures on cages share.
inline Parameters cage_settings() {
  return {whole("seeds", 20, 2, 1000, "cages of each kind"),
          number("speed", 2.0, 0.01, 100.0, "m/s", "largest component of a velocity at the start"),
          number("spin", 2.0, 0.0, 100.0, "rad/s",
                 "largest component of an angular velocity at the start"),
          whole("lead", 30, 0, 10000, "frames of 1/60 s before work is counted")};
}

// A stretch with the settings of a figure.
inline CageStretch stretch_of(const Parameters& settings, int count) {
  return CageStretch{.count = count,
                     .speed = settings.number("speed"),
                     .spin = settings.number("spin"),
                     .lead = settings.count("lead"),
                     .settle = kLongFlight};
}

// Runs frames and returns what was done in them.
inline CageWork run(Technique& technique, World& world, double dt, int frames) {
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

// A cage after its lead, by the timewarp with swept volumes. Figures ask for the same cages, so what the program has
// led once it keeps.
inline const World& led_cage(const CageStretch& stretch, int seed) {
  static std::map<std::tuple<int, double, double, int, double, int>, World> cages;
  const auto [cage, fresh] = cages.try_emplace(
      {stretch.count, stretch.speed, stretch.spin, stretch.lead, stretch.dt, seed});
  World& world = cage->second;
  if (fresh) {
    world = build_world(make_scene("cage",
                                   {"count=" + std::to_string(stretch.count),
                                    setting("speed", stretch.speed), setting("spin", stretch.spin)},
                                   static_cast<std::uint64_t>(seed)));
    run(*make_technique("timewarp_swept"), world, stretch.dt, stretch.lead);
  }
  return world;
}

// A cage before and after the frames in which a technique with memory settles.
struct SettledCage {
  World before;  // after the lead, its velocities multiplied
  World after;   // `settle` frames later
};

// Hurries a cage and lets it settle, by the timewarp with swept volumes.
inline SettledCage settled_cage(const World& led, const CageStretch& stretch) {
  SettledCage cage{led, led};
  for (BodyState& state : cage.before.states()) {
    state.linear_momentum_w *= stretch.factor;
    state.angular_momentum_w *= stretch.factor;
  }
  cage.after = cage.before;
  run(*make_technique("timewarp_swept"), cage.after, stretch.dt, stretch.settle);
  return cage;
}

// Counts what a technique does in the frames of a stretch. One that settles does so first, others
// begin after that: all go through the same time.
inline CageWork work_of(const SettledCage& cage, const CageStretch& stretch,
                        const TimewarpForm& form) {
  const std::unique_ptr<Technique> technique = make_technique(form.name, form.settings);
  World world = form.settles ? cage.before : cage.after;
  if (form.settles) run(*technique, world, stretch.dt, stretch.settle);
  return run(*technique, world, stretch.dt, stretch.frames);
}

// One count over all seeds, or over all but one.
inline double total(const Works& works, double CageWork::*count, int left_out = -1) {
  double sum = 0.0;
  for (std::size_t k = 0; k < works.size(); ++k)
    if (static_cast<int>(k) != left_out) sum += works[k].*count;
  return sum;
}

// The same for each event.
inline double per_event(const Works& works, double CageWork::*count, int left_out = -1) {
  return total(works, count, left_out) / total(works, &CageWork::events, left_out);
}

}  // namespace tumble::chapters
