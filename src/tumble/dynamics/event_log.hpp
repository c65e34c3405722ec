/// \file
/// \brief Records of collisions and contact points.
#pragma once

#include "tumble/base/types.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

namespace tumble {

/// One collision that was resolved.
struct Event {
  double time = 0.0;              ///< [s] since the start of the run
  BodyId first{};                 ///< the body with the smaller id
  BodyId second{};                ///< the other one
  Vec3 point_w = Vec3::Zero();    ///< [m] where the impulse acts, world frame
  Vec3 normal_w = Vec3::UnitY();  ///< [-] from the first body to the second, world frame
  Vec3 impulse_w = Vec3::Zero();  ///< [N s] on the second body, world frame; the first got minus it
  int rewinds = 0;                ///< bodies put back in time to get here
  int restarts = 0;               ///< searches begun again for a third body
};

/// State of a contact point.
enum class ContactState : std::uint8_t {
  stick,  ///< it pushes, with friction below its limit
  slip,   ///< it pushes, with friction at its limit
  open    ///< it does not push
};

/// The name of a contact's state in files, for example "stick".
constexpr std::string_view name_of(ContactState state) {
  if (state == ContactState::open) return "open";
  return state == ContactState::slip ? "slip" : "stick";
}

/// One contact point of a step.
struct ContactRecord {
  double time = 0.0;                        ///< [s] of the pose that it belongs to
  BodyId first{};                           ///< the body with the smaller id
  BodyId second{};                          ///< the other one
  Vec3 point_w = Vec3::Zero();              ///< [m] world frame
  Vec3 normal_w = Vec3::UnitY();            ///< [-] from the first body to the second, world frame
  Vec3 push_w = Vec3::Zero();               ///< on the second body, world frame; see is_impulse
  bool is_impulse = true;                   ///< push_w is an impulse [N s]; else a force [N]
  ContactState state = ContactState::open;  ///< whether it pushes, and slips
};

/// All collisions of a run, in the order in which they were resolved.
using EventLog = std::vector<Event>;

}  // namespace tumble
