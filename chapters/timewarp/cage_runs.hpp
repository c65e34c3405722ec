/// \file
/// \brief Cubes in a cage under a form of the timewarp, and its work (thesis 2.4.3).
#pragma once

#include "driver/experiment.hpp"

namespace tumble::chapters {

// [frames] Length of full timewarp's flights where no synchronisation ends them. Reason: about the
// time from one collision of a body in the cage to its next; pair tests are fewest there, see the
// figure "timewarp_stride".
inline constexpr int kLongFlight = 8;

// A technique of the library with some of its options changed.
struct TimewarpForm {
  std::string name;                        // in the library, for example "timewarp_simple"
  std::vector<std::string> settings = {};  // each as key=value
  bool settles = false;  // bodies are ahead of the frame, so that a start differs from what follows
};

// All bodies taken back for each collision; pairs that overlap at the end of the frame are searched.
TimewarpForm all_taken_back();

// Full timewarp that is never synchronised.
// stride: [frames] length of a flight, above 0
TimewarpForm full_timewarp(double stride = kLongFlight);

// Full timewarp in which all bodies wait for one another now and then; they fly until then.
// every: [frames] from one synchronisation to the next, at least 1
TimewarpForm synchronised_timewarp(int every);

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
Parameters cage_settings();

// A stretch with the settings of a figure.
CageStretch stretch_of(const Parameters& settings, int count);

// Builds a cage and leads it, by the timewarp with swept volumes.
World led_cage(const CageStretch& stretch, int seed);

// A cage before and after the frames in which a technique with memory settles.
struct SettledCage {
  World before;  // after the lead, its velocities multiplied
  World after;   // `settle` frames later
};

// Hurries a cage and lets it settle, by the timewarp with swept volumes.
SettledCage settled_cage(const World& led, const CageStretch& stretch);

// Counts what a technique does in the frames of a stretch. One that settles does so first, others
// begin after that: all go through the same time.
CageWork work_of(const SettledCage& cage, const CageStretch& stretch, const TimewarpForm& form);

// One count over all seeds, or over all but one.
double total(const Works& works, double CageWork::*count, int left_out = -1);

// The same for each event.
double per_event(const Works& works, double CageWork::*count, int left_out = -1);

}  // namespace tumble::chapters
