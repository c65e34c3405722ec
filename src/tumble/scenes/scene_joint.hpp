/// \file
/// \brief A joint of a scene.
#pragma once

#include "tumble/dynamics/world.hpp"

#include <string>

namespace tumble {

struct Scene;

/// One joint of a scene; the fields are the keys of scene files.
struct SceneJoint {
  std::string name = {};             ///< unique among joints; empty: "joint" and its place from 1
  JointKind kind = JointKind::ball;  ///< its free motions
  std::string first = {};            ///< a box that is present at the start, or "ground": the world
  std::string second = {};           ///< another one
  Vec3 anchor_w = Vec3::Zero();      ///< [m] the joint's point, at the start
  Vec3 axis_w = Vec3::Zero();        ///< [-] of a hinge, at the start, of any length above 0
};

/// Joins the bodies of a world as in its scene.
/// \param scene  each box has its name
/// \param world  of that scene at time 0; gets the joints
/// \throws SceneMistake naming the first value that is wrong: a body that is missing, comes later or is named twice, two
///         bodies of which none can move, an axis that a hinge lacks or another joint has, a number that is not finite or above
///         tolerance::largest_value, or a name that another joint has or with control characters in it
void join_bodies(Scene& scene, World& world);

}  // namespace tumble
