/// \file
/// \brief The parts into which the default technique divides a step in which bodies move far (thesis 3.2).
#pragma once

#include "tumble/contact_patches/contact_patch.hpp"
#include "tumble/dynamics/advance_pose.hpp"
#include "tumble/dynamics/world.hpp"
#include "tumble/geometry/broad_phase.hpp"

#include <span>

namespace tumble {

/// [-] Parts of a step that end where fast boxes meet, at most. Reason: a hundred cubes at 60 m/s in a closed room of 8 m meet
/// thirty times in a step; each part costs a step. (3.2)
inline constexpr int kMostMeetings = 100;

/// [-] Halvings of a part in which bodies sink into each other by turning, at most. Reason: of 5000 boxes that are thrown to the
/// ground with up to 40 m/s and 170 rad/s 18 % sank by more than a tenth of an edge, and with four halvings none. (3.2)
inline constexpr int kMostHalvings = 4;

/// Into how many parts a step is divided, if an option allows it, where bodies that touch move far into each other, or
/// edges far along each other. Then a contact found at its start does not stay where it is. On a face it does.
/// \param free     velocities with gravity, without contacts
/// \return from 1 to `allowed`
[[nodiscard]] int parts_of_motion(std::span<const ContactPatch> patches,
                                  std::span<const MovingBody> free, double dt, int allowed);

/// The farthest turn [rad] of a body that may touch another: its contacts of the start of the step are elsewhere at its end.
/// \param bodies   velocities before the step
[[nodiscard]] double farthest_turn(std::span<const ContactPatch> patches,
                                   std::span<const MovingBody> bodies, double dt);

/// For how long no two boxes that move far against each other meet. Those of a step that are half an edge further on could
/// have passed each other, or be so deep in each other that their contact points the wrong way.
/// \param rule        by which bodies turn
/// \return [s] up to dt: the time of the first meeting of such a pair; for one that meets at once the time in which it
///         moves by half an edge
/// \par Cost
/// A conservative search for each such pair.
[[nodiscard]] double time_to_fast_meeting(const World& world, std::span<const MovingBody> bodies,
                                          std::span<const IndexPair> candidates, RotationRule rule,
                                          double dt);

}  // namespace tumble
