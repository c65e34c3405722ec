/// \file
/// \brief Joints that a world has from its scene: ball, hinge, fixed.
#pragma once

#include "tumble/dynamics/body.hpp"

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace tumble {

/// What a joint leaves free.
enum class JointKind : std::uint8_t {
  ball,   ///< all turning about a point
  hinge,  ///< turning about one axis
  fixed   ///< nothing
};

/// All kinds, in the order of the enumeration.
std::span<const JointKind> joint_kinds();

/// The name of a kind in scene files: its enumerator as text.
std::string_view name_of(JointKind kind);

/// A joint between two bodies. It is made by World::join() where the bodies are, and never changes.
struct BodyJoint {
  std::string name;                   ///< in files and messages
  JointKind kind = JointKind::ball;   ///< what it leaves free
  std::array<BodyId, 2> bodies = {};  ///< the smaller id first
  std::array<Vec3, 2> anchors_b = {Vec3::Zero(),
                                   Vec3::Zero()};  ///< [m] its point, in each body's frame
  std::array<Vec3, 2> axes_b = {Vec3::Zero(),
                                Vec3::Zero()};  ///< [-] of a hinge, ditto, of length 1
  /// [-] orientation of the second body in the frame of the first, when the joint was made
  Quat second_in_first = Quat::Identity();
};

}  // namespace tumble
