/// \file
/// \brief The listings RESOLVECOLLISIONS and RESOLVECONTACTS as they are printed (thesis A.2).
#pragma once

#include "tumble/dynamics/technique.hpp"
#include "tumble/impulse_damped/as_printed/collide_as_printed.hpp"
#include "tumble/impulse_damped/pair_gatherer.hpp"

#include <functional>

namespace tumble {

/// What the two listings take from the step around them.
struct PrintedStage {
  World& world;                     ///< the bodies
  PrintedObjects& objects;          ///< the same, as the listings see them; begun
  PairGatherer& gatherer;           ///< finds what overlaps
  std::span<const BodyState> last;  ///< where the bodies were when the step began
  const PrintedCollide& collide;    ///< what COLLIDE needs
  Vec3 ahead_w = Vec3::Zero();      ///< [m/s] what gravity will add to velocities in this step
  double dt = 0.0;                  ///< [s] above 0
  RotationRule rotation = RotationRule::splitting;  ///< how bodies turn
  int passes = 0;                                   ///< [-] NUM_..._ITERATIONS, at least 0
  /// [-] First number of the loop over passes (RK2): 1, as printed, or 0.
  int loop_base = 1;
  bool elastic = false;     ///< contacts with e = 1, as the prose of 5.2 has it (RK3)
  ContactList& collisions;  ///< what was gathered last
  StepReport& report;       ///< is added to
  /// Called with each impulse, if it is set.
  std::function<void(const Contact&, const PrintedCollision&)> told = {};
};

/// RESOLVECOLLISIONS, one statement for each printed line: passes over all pairs that overlap where
/// gravity and their velocities would take them, with the restitution of the pair each time (RC1).
///
/// RC2: what was gathered at the beginning of a pass stays in the list, even if an impulse has
/// meanwhile turned the bodies away; mended, a pair is looked at again before its turn. RC3: pairs
/// come in the order of their ids. RC4: see PrintedObjects::revert_to_original_positions().
/// \param stage all that it needs; poses are as before when it returns, up to RC4
/// \algorithm{RESOLVECOLLISIONS as printed: appendix A.2}
void resolve_collisions_as_printed(PrintedStage& stage);

/// RESOLVECONTACTS, one statement for each printed line: the same with gravity, and with a
/// restitution that goes from -1 to 0 over the passes.
///
/// RK1: pass number and number of passes are integers, and so is their quotient: the restitution is
/// -1, which is no impulse at all, in all passes but the last; mended, the quotient is real.
/// \param stage all that it needs; poses are as before when it returns, up to RC4
/// \algorithm{RESOLVECONTACTS as printed: appendix A.2}
void resolve_contacts_as_printed(PrintedStage& stage);

}  // namespace tumble
