/// \file
/// \brief The scenes of figures 6.1 to 6.3 under every technique of the library: how far what should stay
///        together comes apart (thesis 6.2).
#pragma once

#include "driver/experiment.hpp"

namespace tumble::chapters {

// The angle at which the column and the box of the scenes fig6_1 and fig6_2 start, [rad] from the vertical.
inline constexpr double kSceneAngle = 0.3;

// A technique as it is compared.
struct ComparedTechnique {
  std::string words;       // for readers and names of quantities
  PlayedTechnique played;  // to be run
};

// Techniques with the option `pose`, and `glued` with impulses as the plainest of them.
std::span<const ComparedTechnique> techniques_with_pose();

// All other techniques of the library.
std::span<const ComparedTechnique> techniques_without_pose();

// The same technique with bodies carried by what they stand on.
PlayedTechnique exponential(const ComparedTechnique& technique);

// A motion to compare: it ends before any of its contacts would open without glue.
struct ComparedScene {
  std::string name;   // of the scene
  double time = 0.0;  // [s] from its start
};

// The scenes of figures 6.1, 6.2 and 6.3.
std::span<const ComparedScene> compared_scenes();

// The result of a run. All lengths are the largest after any step, measured at the places that touched at
// the start.
struct TechniqueGaps {
  double opening = 0.0;  // [m] along the normal, 0 or above
  double overlap = 0.0;  // [m] along the normal, 0 or above
  double pivot = 0.0;    // [m] of the edge on the larger box from where it was, in any direction
  double slide = 0.0;    // [m] of places between movable bodies from themselves, in any direction
  // [rad] at the end, less the closed form; figure 6.3: that angle of the two with the larger error
  // against GSL's double pendulum
  double angle_error = 0.0;
  int capped = 0;  // steps that met the cap on events: the page says so of `basic`

  // The gap [m], opening or overlap, whichever is larger.
  [[nodiscard]] double gap() const;
};

// Runs a technique.
// rate: [1/s] steps
TechniqueGaps run_technique(const ComparedScene& scene, const PlayedTechnique& played,
                            double rate = 60.0, const std::vector<std::string>& settings = {});

}  // namespace tumble::chapters
