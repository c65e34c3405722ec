/// \file
/// \brief Wishes about the end of a motion (thesis 2.4.2).
#pragma once

#include "tumble/dynamics/world.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

struct Scene;
struct SceneBox;

/// Kinds of wishes about a body, at the end of a run.
enum class WishKind : std::uint8_t {
  face_up,  ///< it rests, and this face of it is up
  ends_in,  ///< its centre is in a region
  topples,  ///< the axis that pointed up has rotated by an angle or more
  stands,   ///< that axis has rotated by less than an angle
  moves,    ///< its centre is a distance or more from its start
  stays     ///< its centre is at most a distance from its start
};

/// The kinds of wishes, as scene files name them, in the order of WishKind.
inline constexpr std::array<std::string_view, 6> kWishKinds = {"face_up", "ends_in", "topples",
                                                               "stands",  "moves",   "stays"};

/// The faces of a box, by the axis of its own frame that points out of them.
inline constexpr std::array<std::string_view, 6> kFaces = {"+x", "-x", "+y", "-y", "+z", "-z"};

/// A wish about some bodies. The fields are the keys of scene files; each kind uses only some of them.
struct Wish {
  WishKind kind = WishKind::topples;     ///< the kind of wish
  std::vector<std::string> bodies = {};  ///< names; the wish applies to each of them
  int face = 2;                          ///< face_up: place in kFaces
  Vec3 low_w = Vec3::Zero();             ///< [m] ends_in: one corner of the region, world frame
  Vec3 high_w = Vec3::Zero();            ///< [m] ends_in: the other corner, nowhere below the first
  double angle_deg = 45.0;               ///< [degrees] topples, stands: above 0, below 180
  double distance =
      0.0;  ///< [m] moves, stays; 0: the longest edge, for stays a quarter of the shortest
};

/// The distance of a wish that a body moves or stays.
/// \param wish  with a distance, or 0
/// \return [m] that of the wish, or its default for this body
[[nodiscard]] double distance_of(const Wish& wish, const SceneBox& box);

/// The violation of a wish.
///
/// Each body of a wish adds a number from 0 (it meets the wish) to 1; face_up and rest add one each.
/// With the angle θ by which the axis that pointed up has rotated, its limit θ₁, the distance d of the centre from its start, the distance r
/// of the wish, the distance D of the centre from the region, and the longest edge L:
/// | kind | adds |
/// |---|---|
/// | face_up | \f$(1 - \cos\varphi)/2\f$, φ from the face's normal to the vertical, if it is above 8 degrees; and the speed of its fastest point over sqrt(g L), if that is above 0.05 |
/// | ends_in | \f$D / (D + L)\f$ |
/// | topples | \f$(\cos\theta - \cos\theta_1) / (1 - \cos\theta_1)\f$, if θ is below θ₁ |
/// | stands | \f$(\cos\theta_1 - \cos\theta) / (1 + \cos\theta_1)\f$, if θ is not |
/// | moves | \f$1 - d/r\f$, if d is below r |
/// | stays | \f$1 - r/d\f$, if d is above r |
/// A missing body adds 1.
/// \param wish   checked by check_wishes()
/// \return [-] 0 if the wish is met
/// \verified{Each kind of wish is met on one side of its limit and not on the other}
[[nodiscard]] double violation(const Wish& wish, const Scene& scene, const World& world);

/// The violation of all wishes of a scene [-]: their sum.
[[nodiscard]] double violation(const Scene& scene, const World& world);

/// Checks wishes, and refuses impossible ones: an unknown body, a region that is empty or too low for its body, a fixed body
/// that should move or topple, and two wishes for one body that exclude each other: two faces up, regions without a common
/// point, topples and stands, moves and stays, or stays and a region out of reach.
/// \param scene  with the names of its boxes
/// \throws SceneMistake for the first wrong wish: the value, and the expected one
void check_wishes(const Scene& scene);

}  // namespace tumble
