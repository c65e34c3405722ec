/// \file
/// \brief Collisions of several bodies at one instant (thesis 2.5.1, 5.2).
#pragma once

#include "tumble/base/options.hpp"
#include "tumble/contact/simultaneous_impacts.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/dynamics/technique.hpp"

namespace tumble {

/// In which order the contacts of one instant are resolved.
///
/// Rigid bodies do not say what happens when several collide at once; both readings are used, and
/// they differ. Newton's cradle of equal balls at rest, e = 1, hit by a ball of speed 1:
///
/// | balls               | simultaneous              | sequential             |
/// |---------------------|---------------------------|------------------------|
/// | 3, one comes in     | -1/3, 2/3, 2/3            | 0, 0, 1                |
/// | 5, one comes in     | -3/5, 2/5, 2/5, 2/5, 2/5  | 0, 0, 0, 0, 1          |
/// | 5, two come in      | -1/5, -1/5, 4/5, 4/5, 4/5 | 0, 0, 0, 1, 1          |
///
/// Both keep momentum and energy. Real balls do what the right column says, because their
/// deformation runs through the row; a box that lands on its face does what the left way says for
/// its corners.
enum class ImpactOrder : std::uint8_t {
  /// All points at one stroke (SimultaneousImpacts): symmetric scenes stay symmetric, and no order of
  /// bodies matters. Restitution is that of the approach speeds stored in the points.
  simultaneous,
  /// One contact after the other in the given order, again and again, until none approaches: each
  /// time a collision of two bodies with restitution of its own. The points of one contact go
  /// together. On a stack of n with e = 0 the approach left shrinks by cos²(π/2n) in a pass, so ten
  /// passes do little for n above 5.
  sequential
};

/// The names of the orders as words of options.
inline std::vector<Word<ImpactOrder>> impact_words() {
  return {{"simultaneous", ImpactOrder::simultaneous}, {"sequential", ImpactOrder::sequential}};
}

/// The meaning of the option `impacts`, wherever a technique has it.
inline constexpr std::string_view kImpactsMeaning = "resolution of collisions at the same moment";

/// How impacts are resolved.
struct ImpactOptions {
  ImpactOrder order = ImpactOrder::sequential;  ///< see there
  /// [-] sequential: approaches slower than this share of the fastest at the start are none
  double settled = tolerance::impact_settled;
  int most_passes = 1000;  ///< sequential: cap on the passes, at least 1
};

/// How impacts ended.
enum class ImpactStatus : std::uint8_t {
  done,         ///< no point approaches any more
  cap_reached,  ///< some still do, or friction has not settled: as many passes as allowed
  no_solution   ///< bodies are squeezed by immovable ones that move: see SimultaneousStatus
};

/// What was done.
struct ImpactResult {
  ImpactStatus status = ImpactStatus::done;  ///< how it ended
  int collisions = 0;                        ///< contacts resolved, each time counted
  int impulses = 0;                          ///< points pushed, each time counted
  int passes = 0;                            ///< over all contacts
  int pivots = 0;                            ///< of the complementarity solver
  /// [-] smallest share of the restitution asked for that was used in a collision: below 1 if
  /// energy would have risen, or if not all contacts could have their own
  double restitution_share = 1.0;
  double restitution_energy = 0.0;  ///< [J] work of normal impulses, 0 or below without friction
  double friction_energy = 0.0;     ///< [J] work of tangential impulses
  double worst_approach = 0.0;      ///< [m/s] fastest approach left, 0 or above
};

/// Adds impulses, passes, pivots and energy to the report of a step.
/// \param impact  what was done; its collisions are not added, for a pair may bounce twice at once
void book(const ImpactResult& impact, StepReport& report);

/// Resolves collisions of any number of bodies at one instant.
///
/// No call raises the kinetic energy, each contact's impulses are within its cone, and momentum is
/// kept: see SimultaneousImpacts, and solve_impact() for contacts of one point in sequential order.
/// \par Cost and determinism
/// Simultaneous: the dense problem of SimultaneousImpacts over all points. Sequential: small problems,
/// as many as there are collisions. No allocation once warm. The same input gives the same bits.
class ImpactSolver {
 public:
  /// Resolves impacts.
  /// \param contacts  what touches, with approach speeds as gathered. The impulses in the points
  ///                  are overwritten by those of this call. Sequential order overwrites approach
  ///                  speeds
  /// \param bodies    how the bodies move, one for each body index; changed
  /// \throws std::invalid_argument for an option out of range or a contact of a body that is not
  ///         there
  ImpactResult resolve(std::span<Contact> contacts, std::span<MovingBody> bodies,
                       const ImpactOptions& options = {});

 private:
  void one_after_the_other(std::span<Contact> contacts, std::span<MovingBody> bodies,
                           const ImpactOptions& options, ImpactResult& result);

  SimultaneousImpacts block_;
};

/// The fastest approach among the points of some contacts [m/s]; 0 or above.
double fastest_approach(std::span<const Contact> contacts, std::span<const MovingBody> bodies);

}  // namespace tumble
