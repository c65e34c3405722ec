/// \file
/// \brief The listing DAMPENOBJECTS: damping in place of friction (thesis 5.3, A.2).
#pragma once

#include "tumble/base/options.hpp"
#include "tumble/dynamics/advance_pose.hpp"
#include "tumble/dynamics/world.hpp"
#include "tumble/impulse_damped/damped_numbers.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace tumble {

/// Which parts of the damping are used; to see what each of them is good for.
struct DampingParts {
  bool scale = true;   ///< lines 4, 5: momenta of bodies in contact shrink
  bool small = true;   ///< lines 11 to 21: slow components shrink or vanish
  bool align = true;   ///< lines 6 to 9: an aligned box stops falling and spins less
  bool tilt = true;    ///< line 10: an aligned box is turned upright
  bool freeze = true;  ///< lines 23 to 28: a body that hardly moves stays where it was

  /// \param other  parts \return whether they are the same
  bool operator==(const DampingParts& other) const = default;
};

/// The combinations of parts that the option `damping` accepts, each with its name.
std::vector<Word<DampingParts>> damping_words();

/// Parts of the damping by their names.
/// \param names  "all", "none", or names joined by +, such as "scale+align"
/// \throws std::invalid_argument for an unknown name, with the list of choices
DampingParts damping_parts_from(std::string_view names);

/// What damping did.
struct DampingReport {
  double energy = 0.0;  ///< [J] added: kinetic by lines 4 to 21, and mechanical by lines 23 to 28
  int aligned = 0;      ///< bodies in contact with a face across gravity
  int moved = 0;        ///< bodies advanced
  int frozen = 0;       ///< movable bodies that were put back
};

/// Whether a face of a box is across gravity, within a tolerance.
/// \param tolerance       [rad] largest angle between a box's axis and the vertical
/// \return true if \f$\max_i |R_{yi}| \ge \cos\varepsilon\f$
[[nodiscard]] bool check_y_axis_alignment(const Quat& orientation_wb, double tolerance);

/// Turns a box so that the axis that is nearest to the vertical comes nearer to it.
/// \param most            [rad] by how much at most, at least 0
/// \return [-] the new orientation; exactly upright if the tilt was not above `most`
[[nodiscard]] Quat tilted_towards_y_axis(const Quat& orientation_wb, double most);

/// The listing DAMPENOBJECTS, in the sense in which it was meant.
///
/// Bodies in contact are slowed down; those that are slow anyway are stopped; a box that nearly lies flat
/// is put flat. Then all bodies move, and each that hardly moves is put back.
///
/// **Mended.** Small is |x| < ε. The second threshold of momentum (line 14) is a smaller one, ε6:
/// printed alike, the first would do nothing. Lines 20 and 21 stop a small upward *linear* motion,
/// once and not three times; as printed they stop a spin about the vertical in one sense only. The
/// alignment test has a tolerance, ε2. Turns are compared by their angle. Bodies move with the
/// velocities that they have: gravity is in them already.
///
/// **Kept.** Each component is tested by itself, in the axes of the world. For a body whose moments
/// differ, a component of L that vanishes can raise its energy
/// \f$\tfrac12 L\cdot I_w^{-1}L\f$, by up to \f$(I_a+I_b)^2/(4 I_a I_b)\f$; cubes are safe. A heap
/// in free fall is braked. A body that is put back keeps its momentum. The box is turned about its centre,
/// so that a corner rises or sinks.
/// \algorithm{DAMPENOBJECTS: section 5.3 and appendix A.2}
/// \deviation{Small means small in size; line 14 has a threshold of its own; lines 20 and 21 stop small upward motion; factors belong to 1/60 s; thresholds are in units of the box.}
/// \verified{Halving the step leaves the same momentum after a second}
class ObjectDamping {
 public:
  /// Damps and moves all bodies.
  /// \param world    states in and out; sleepers stay
  /// \param touched  by index: whether the body had a contact interaction in this step
  DampingReport run(World& world, std::span<const char> touched, const DampedNumbers& numbers,
                    const DampingParts& parts, double dt, RotationRule rotation);

 private:
  std::vector<BodyState> old_;  // before the bodies move
};

}  // namespace tumble
