/// \file
/// \brief One island in a step, and sweeps over it (thesis 6.3.1).
#pragma once

#include "tumble/contact_patches/contact_patch.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/dynamics/world.hpp"

#include <span>
#include <vector>

namespace tumble {

/// An island in a step: bodies that touch one another, their patches, and their velocities. A view; all
/// velocities are of the whole world, by body index.
struct Island {
  const World& world;                   ///< all bodies
  double dt = 0.0;                      ///< [s] of the step
  std::span<const int> bodies;          ///< indices of its movable bodies, at least one
  std::span<const int> patch_indices;   ///< of its patches in `all_patches`, ascending
  std::span<const int> upward;          ///< the same from the ground up, the order of sweeps
  std::span<ContactPatch> all_patches;  ///< of all islands
  std::span<const Quat> start_wb;       ///< orientations at the start of the step
  std::span<const MovingBody>
      start;                         ///< velocities before gravity, places at the start of the step
  std::span<const MovingBody> free;  ///< with gravity, without contacts
  std::span<MovingBody> now;         ///< with the impulses so far
  int levels = 0;                    ///< of support, see IslandOrder::levels()
};

/// The shortest edge [m] of a body in an island's patches.
[[nodiscard]] double shortest_edge(const Island& island);

/// The speed that gravity gives in a step, or what stands for it where there is none.
/// \param size     [m] shortest edge
/// \return [m/s] see tolerance::weightless_speed
[[nodiscard]] double gravity_in_step(double gravity, double size, double dt);

/// The speed that gravity gives in a step to the bodies of an island, see gravity_in_step().
/// \return [m/s]
[[nodiscard]] double unit_speed(const Island& island);

/// The residual that counts as none: a share of unit_speed().
/// \return [m/s] see tolerance::contact_settled
[[nodiscard]] double negligible_residual(const Island& island);

/// How fast an island's bodies move along each other or apart, at the fastest point of a patch: before the step and with
/// the impulses so far, in ascending order. What moves as one, as a tower on a sled, is at rest.
///
/// A landing island is fast before and slow then; one at rest may be thrown about by impulses that are far from
/// right. So an island moves fast if the lower one is high, and is quiet if no patch moves both times. The range is that of
/// the two moments, not one over bodies.
struct SpeedRange {
  double lower = 0.0;   ///< [-] as a share of sqrt(g L)
  double higher = 0.0;  ///< [-] ditto
  double moving =
      0.0;  ///< [-] share of the patches that are faster than tolerance::moving_speed both times
  /// No patch moves, or all that do belong to few bodies: one that slides over others moves, they do not, however many it
  /// touches. Where nothing is hit, patches with immovable bodies do not count.
  bool few = false;
  /// Nothing is hit, and no patch between movable bodies moves: all rest, or slide together.
  bool as_one = false;
};

/// How fast an island moves.
[[nodiscard]] SpeedRange speed_range(const Island& island);

/// Whether all patches of an island are slower than tolerance::moving_speed, before the step and with the impulses so far.
[[nodiscard]] bool hardly_moves(const Island& island);

/// How many patches of an island are faster than tolerance::moving_speed before the step.
[[nodiscard]] std::int64_t moving_patches(const Island& island);

/// Whether an island is large and moves fast: its contacts change at once, so its overlap gets few sweeps.
[[nodiscard]] bool is_large_and_fast(const Island& island);

/// Whether an island has at most tolerance::small_island bodies.
[[nodiscard]] bool is_small(const Island& island);

/// Whether an island has friction above tolerance::newton_steepest_friction, for which Newton steps are not tried.
[[nodiscard]] bool is_steep(const Island& island);

/// Notes how fast the points of an island approach before it is solved.
/// \param island  `approach` of its points is written
void note_approach(const Island& island);

/// Warm start: applies the impulses of the step before, and notes how fast points approach.
/// \param island  `now` is `free` before
void warm_start(const Island& island);

/// Direction of a sweep.
enum class SweepOrder : std::uint8_t {
  down,  ///< from the top down, as weight goes
  up     ///< from the ground up, as support goes
};

/// One Gauss-Seidel sweep: solve_patch() for all patches of an island.
/// \param patch_iterations  of friction and pressure in turn within a patch; 0: only what sticks is solved
/// \param residual          [m/s] at which a patch is skipped, see solve_patch()
/// \param changes           [m/s] in and out, by contact: what solve_patch() returns; empty: not asked for
/// \return [m/s] the largest change of a velocity, or error of a patch that was left, see solve_patch()
double sweep(const Island& island, SweepOrder order, int patch_iterations, double residual,
             StepReport& report, std::span<double> changes = {});

/// The largest error of the patches whose bodies do not move fast along each other. However fast others move, bodies
/// that carry something must go on carrying it.
/// \param island  with the impulses so far
/// \return [m/s] by how much a point approaches faster than its target; 0 or above
[[nodiscard]] double approach_of_slow_patches(const Island& island);

/// How far bodies of an island sink into each other within the step, beyond what the targets of their points allow.
/// \param island  with velocities `now`
/// \return [-] the deepest, as a share of the shortest edge of its pair
[[nodiscard]] double deepest_sinking(const Island& island);

/// How deep the points of an island that sink by more than tolerance::sinking_that_counts in the step will be: that, and the
/// overlap that is there.
/// \param island  with velocities `now`
/// \return [-] the deepest, as a share of the shortest edge of its pair
[[nodiscard]] double overlap_of_sinking(const Island& island);

/// Copies the bodies of an island's patches, the immovable ones too.
/// \param from    by body index
/// \param to      by body index; those of other islands stay as they are
void copy_bodies(const Island& island, std::span<const MovingBody> from,
                 std::vector<MovingBody>& to);

/// Sets all impulses to 0.
/// \param island  `now` is `free` again
void discard_impulses(const Island& island);

/// The share of the impulses so far with which the kinetic energy is not above that of `free`. Those of a solver that has
/// not converged may add some.
/// \return [-] 1 if all of them add none
[[nodiscard]] double share_without_gain(const Island& island);

/// Whether impulses push bodies apart that need no push, as those of an impact do after it. Sweeps would take many more to undo
/// them: they spread evenly over a row, and each patch finds its own in order. A solution pushes only where
/// \f$v_n = v^*\f$; so the work \f$\sum \lambda\,(v_n - v^*)\f$ over points that separate faster is compared with the energy
/// \f$\tfrac12 |\Delta v|_M^2\f$ of the change of velocity in the step.
/// \return whether it is more than tolerance::work_apart of that
[[nodiscard]] bool pushes_apart(const Island& island);

/// Whether a point of an island approaches fast: its impulses are those of an impact, beside which weights are small.
/// \param island  after note_approach()
[[nodiscard]] bool has_impact(const Island& island);

/// Whether it had one in one of the last steps: tolerance::steps_after_impact.
[[nodiscard]] bool is_after_impact(const Island& island);

/// Energy guard: impulses that are not quite solved could raise the kinetic energy, and are scaled back to where
/// they do not. The energy is a parabola in the scale, and at 0 it is that of `free`.
/// \param island  impulses and velocities in and out
/// \param share   share_without_gain()
void limit_energy(const Island& island, double share, StepReport& report);

/// Energy guard of restitution, after bodies have moved. Newton's law at several points may ask for more energy
/// than there is. What there is, is the kinetic energy at the start of the step and the work of gravity on the way
/// that bodies have really gone. Velocities and impulses go back together towards those before the bounce, as far as
/// needed: the energy on this way is a parabola, and at its start there is not too much. So velocities stay
/// those of the impulses, and momentum is kept.
/// \param island    with the bounce; impulses and velocities in and out
/// \param before    velocities before the bounce, with which bodies have moved, by body index
/// \param impulses  of all patches then, by their index
void limit_bounce(const Island& island, std::span<const MovingBody> before,
                  std::span<const PatchImpulses> impulses, StepReport& report);

}  // namespace tumble
