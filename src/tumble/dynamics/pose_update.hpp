/// \file
/// \brief The two ways in which techniques with contact put bodies where they are next (thesis 6.2).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string_view>

namespace tumble {

/// How bodies that touch are moved, once their velocities are known.
enum class PoseUpdate : std::uint8_t {
  /// Each body's centre goes straight and the body turns about it, see advance_pose(). Bodies that
  /// turn together about a point outside of them come apart by \f$\omega^2 h^2 s/2\f$ in a step.
  separate,
  /// Each body turns about the point that it stands on, by the exponential of its twist there, see
  /// PivotUpdate.
  exponential
};

/// The meaning of the option `pose`, wherever a technique has it.
inline constexpr std::string_view kPoseMeaning =
    "motion of bodies that push each other: each by itself, or about its support point (thesis "
    "6.2)";

/// Both, in the order of the enumeration.
inline std::span<const PoseUpdate> pose_updates() {
  static constexpr std::array kUpdates = {PoseUpdate::separate, PoseUpdate::exponential};
  return kUpdates;
}

/// The name that a user calls it by: "separate" or "exponential".
inline std::string_view name_of(PoseUpdate update) {
  switch (update) {
    case PoseUpdate::separate: return "separate";
    case PoseUpdate::exponential: return "exponential";
  }
  throw std::invalid_argument("tumble: not a pose update");
}

}  // namespace tumble
