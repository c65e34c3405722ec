/// \file
/// \brief The scenes of figures 6.1 to 6.3 under every technique of the library: how far what should stay
///        together comes apart (thesis 6.2).
#pragma once

#include "driver/figure.hpp"
#include "driver/played_scene.hpp"

#include <span>
#include <string>
#include <string_view>

namespace tumble::chapters {

/// A technique as it is compared.
struct ComparedTechnique {
  std::string words;       ///< for readers and names of quantities
  PlayedTechnique played;  ///< what is run
};

/// Techniques with the option `pose`, and `glued` with impulses as the plainest of them.
/// \return six; `impulse` twice, with its usual ten contact passes and with a hundred
std::span<const ComparedTechnique> techniques_with_pose();

/// All other techniques of the library.
/// \return six; the last one, `basic`, has no resting contact
std::span<const ComparedTechnique> techniques_without_pose();

/// The same technique with bodies carried by what they stand on.
/// \param technique  one of techniques_with_pose()
/// \return with pose=exponential
PlayedTechnique exponential(const ComparedTechnique& technique);

/// A motion that is compared: it ends before any of its contacts would open without glue.
struct ComparedScene {
  std::string name;   ///< of the scene
  double time = 0.0;  ///< [s] from its start
};

/// The scenes of figures 6.1, 6.2 and 6.3.
/// \return three, with 0.8 s, 0.45 s and 0.4 s
std::span<const ComparedScene> compared_scenes();

/// How a technique did. All lengths are the largest after any step; they are told from the places that
/// touched at the start.
struct TechniqueGaps {
  double opening = 0.0;  ///< [m] along the normal, 0 or above
  double overlap = 0.0;  ///< [m] along the normal, 0 or above
  double pivot = 0.0;    ///< [m] of the edge on the larger box from where it was, in any direction
  double slide = 0.0;    ///< [m] of places between movable bodies from themselves, in any direction
  double angle_error =
      0.0;         ///< [rad] at the end, less the closed form; figure 6.3: the angle of the
                   ///< two that is further off GSL's double pendulum
  int capped = 0;  ///< steps that met the cap on events

  /// What is called the gap here.
  /// \return [m] opening or overlap, whichever is larger
  [[nodiscard]] double gap() const;
};

/// Runs a technique.
/// \param scene     what and how long
/// \param played    the technique
/// \param rate      [1/s] steps
/// \param settings  of the scene, each as key=value
/// \return how it did
/// \throws std::runtime_error for a step that was not solved or a state that is not finite
TechniqueGaps run_technique(const ComparedScene& scene, const PlayedTechnique& played,
                            double rate = 60.0, const std::vector<std::string>& settings = {});

/// Figure 6.1 under techniques_with_pose(), both ways to move bodies.
/// \param settings  time and rate
/// \return a row for each technique
Result measure_column_gaps(const Parameters& settings);

/// Figure 6.2, in the same way.
/// \param settings  time and rate
/// \return a row for each technique
Result measure_one_box_gaps(const Parameters& settings);

/// Figure 6.3, in the same way.
/// \param settings  time and rate
/// \return a row for each technique
Result measure_nested_gaps(const Parameters& settings);

/// All three figures under techniques_without_pose().
/// \param settings  rate, and the share of the usual times that is simulated
/// \return a row for each technique
Result measure_other_gaps(const Parameters& settings);

/// Why the gaps of figure 6.1 differ: how they depend on the step, and what takes them away.
/// \param settings  time, and how often the step is halved
/// \return a row for each step
Result measure_gap_reasons(const Parameters& settings);

}  // namespace tumble::chapters
