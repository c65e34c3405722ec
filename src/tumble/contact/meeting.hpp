/// \file
/// \brief Whether two boxes that close their gap overlap, touch at an edge without height, or pass (thesis 3.2).
#pragma once

#include "tumble/contact/moving_body.hpp"
#include "tumble/dynamics/world.hpp"
#include "tumble/geometry/broad_phase.hpp"
#include "tumble/geometry/manifold.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace tumble {

/// The outcome of two boxes that close their gap along a normal.
enum class Meeting : std::uint8_t {
  overlap,  ///< they overlap if nothing stops them
  graze,    ///< they touch at an edge that has no height across the normal
  pass      ///< no contact within the step
};

/// A meeting, and for one that grazes the direction across the normal in which it has no height: two where an edge touches an edge
/// beside it.
struct MeetingFound {
  Meeting meeting = Meeting::overlap;  ///< what happens
  /// [-] world frame, length 1 if it grazes; else 0
  std::array<Vec3, 2> flat_w = {Vec3::Zero(), Vec3::Zero()};
};

/// Finds whether two boxes that have a manifold will overlap when they have met along its normal.
///
/// A manifold of boxes with a gap says that they are near along one axis only. Both are moved together until they
/// overlap by `tolerance::flush_overlap` of the size along the normal; if they then overlap by less than
/// `tolerance::flush_height` along any axis, the contact has no height. How far they slide across the normal until
/// they meet depends on other contacts; so such a pair is dropped only if it misses also with
/// the motion it had before the step, when they meet and at the end of the step.
///
/// Two edges that lie on each other side by side overlap in the direction of neither face: which face they meet is known only from
/// what else holds the bodies.
///
/// A pair with height is dropped if its motion by itself would close the gap along the normal, and yet leads the boxes past each
/// other, with the velocities of the step and those before it: a body that flies past an edge. Where other contacts change the
/// way, the pair may have to be looked for again.
/// \param found     their manifold, at least one point
/// \param size      [m] shortest edge of the two
/// \param touching  [m] gap up to which they touch already
/// \param bodies    how they move in the step, if nothing stops them
/// \param gained_w  [m/s] what gravity has added to their velocities in this step
/// \return the outcome; overlap if one of them is the ground, which has no edges
/// \par Cost
/// Up to three calls of separation(); for a pair that would close its gap some more, mostly one.
[[nodiscard]] MeetingFound find_meeting(const World& world, const IndexPair& pair,
                                        const Manifold& found, double size, double touching,
                                        std::span<const MovingBody> bodies, const Vec3& gained_w,
                                        double dt);

}  // namespace tumble
