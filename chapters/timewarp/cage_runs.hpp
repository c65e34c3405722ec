/// \file
/// \brief Cubes in a cage under a form of the timewarp, and its work (thesis 2.4.3).
#pragma once

#include "tumble/dynamics/technique.hpp"

#include "driver/figure.hpp"

#include <memory>
#include <string>
#include <vector>

namespace tumble::chapters {

/// [frames] Length of full timewarp's flights where no synchronisation ends them. Reason: about the
/// time from one collision of a body in the cage to its next; pair tests are fewest there, see the
/// figure "timewarp_stride".
inline constexpr int kLongFlight = 8;

/// A technique of the library with some of its options changed.
struct TimewarpForm {
  std::string name;                        ///< in the library, for example "timewarp_simple"
  std::vector<std::string> settings = {};  ///< each as key=value
  bool settles =
      false;  ///< bodies are ahead of the frame, so that a start differs from what follows
};

/// All bodies taken back for each collision; pairs that overlap at the end of the frame are searched.
/// \return the basic technique of 2.1
TimewarpForm all_taken_back();

/// Full timewarp that is never synchronised.
/// \param stride  [frames] length of a flight, above 0
/// \return timewarp_full
TimewarpForm full_timewarp(double stride = kLongFlight);

/// Full timewarp in which all bodies wait for one another now and then; they fly until then.
/// \param every  [frames] from one synchronisation to the next, at least 1
/// \return timewarp_full
TimewarpForm synchronised_timewarp(int every);

/// Work of a stretch of a run; sums over seeds can be made of it.
struct CageWork {
  double frames = 0.0;        ///< [-]
  double events = 0.0;        ///< collisions
  double integrations = 0.0;  ///< flights of one body
  double pair_tests = 0.0;    ///< separation tests
  double rewinds = 0.0;       ///< bodies taken back
};

/// The work of the same stretch in several cages, by seed.
using Works = std::vector<CageWork>;

/// A cage, and the frames of its run in which work is counted.
struct CageStretch {
  int count = 512;      ///< cubes; a cube number, so that the cage is full
  double speed = 2.0;   ///< [m/s] largest component of a velocity at the start
  double spin = 2.0;    ///< [rad/s] largest component of an angular velocity at the start
  double factor = 1.0;  ///< [-] by which all velocities are multiplied after the lead
  int lead = 30;        ///< frames before anything else, so that the grid of the start is forgotten
  int settle = 0;       ///< frames after that in which a technique with memory finds its stride
  int frames = 6;       ///< frames in which work is counted
  double dt = 1.0 / 60;  ///< [s] of a frame
};

/// The settings that the figures on cages share.
/// \return seeds, speed, spin, lead
Parameters cage_settings();

/// A stretch with the settings of a figure.
/// \param settings  speed, spin, lead
/// \param count     cubes
/// \return it settles for one long flight
CageStretch stretch_of(const Parameters& settings, int count);

/// Builds a cage and leads it, by the timewarp with swept volumes.
/// \param stretch  count, speed, spin, lead, dt
/// \param seed     of the scene
/// \return it after the lead
/// \throws std::runtime_error if a frame was not finished
World led_cage(const CageStretch& stretch, int seed);

/// A cage before and after the frames in which a technique with memory settles.
struct SettledCage {
  World before;  ///< after the lead, its velocities multiplied
  World after;   ///< `settle` frames later
};

/// Hurries a cage and lets it settle, by the timewarp with swept volumes.
/// \param led      as led_cage() gave it
/// \param stretch  factor, settle, dt
/// \return two moments of it
/// \throws std::runtime_error if a frame was not finished
SettledCage settled_cage(const World& led, const CageStretch& stretch);

/// Counts what a technique does in the frames of a stretch. One that settles does so first, others
/// begin after that: all go through the same time.
/// \param cage     as settled_cage() gave it
/// \param stretch  settle, frames, dt
/// \param form     the technique
/// \return its work
/// \throws std::runtime_error if a frame was not finished
CageWork work_of(const SettledCage& cage, const CageStretch& stretch, const TimewarpForm& form);

/// One count over all seeds, or over all but one.
/// \param works     by seed
/// \param count     which
/// \param left_out  index of the seed that is not counted; -1: none
/// \return the sum
double total(const Works& works, double CageWork::*count, int left_out = -1);

/// The same for each event.
/// \param works     by seed
/// \param count     which
/// \param left_out  index of the seed that is not counted; -1: none
/// \return the sum over the number of events
double per_event(const Works& works, double CageWork::*count, int left_out = -1);

}  // namespace tumble::chapters
