/// \file
/// \brief Bodies in flight under forces that stay as they are (thesis 3.3.1).
#pragma once

#include "tumble/analytic_lcp/assembly.hpp"
#include "tumble/contact/pivot_update.hpp"
#include "tumble/dynamics/advance_pose.hpp"

#include <span>
#include <vector>

namespace tumble {

/// Where bodies are at any time after an instant, if constant forces act on them besides gravity.
///
/// The centre follows its parabola exactly. A constant torque τ turns the body with the mean of its
/// angular momentum so far,
/// \f[ R(t) = \text{rule}\bigl(R_0,\; L_0 + \tfrac12 \tau t,\; t\bigr), \qquad L(t) = L_0 + \tau t, \f]
/// which is of order 2 in t, and continuous, so that it can be searched for collisions. Every state
/// is flown to from the start in one go: a body put at a time found by a search has the very bits
/// that the search saw.
///
/// Bodies that stand on others may follow them (carry()): then they move along the arcs of
/// PivotUpdate, of order 2 in t and continuous as well, and their momenta are as above.
class ForcedFlight {
 public:
  /// Keeps the present states as the start; no body follows another one.
  void begin(const World& world);

  /// Says what acts from the start on, besides gravity.
  /// \param wrenches  one for each body index; those of immovable bodies are not read
  /// \throws std::invalid_argument if there is not one for each body
  void set_wrenches(std::span<const Wrench> wrenches);

  /// Makes bodies follow those that push them.
  /// \param pushed  pairs of a pushing and a pushed body
  void carry(const World& world, std::span<const MovingBody> bodies,
             std::span<const PushedPair> pushed);

  /// Sets the accelerations of bodies that follow others, due to the wrenches and gravity.
  void accelerate(std::span<const Acceleration> rates);

  /// The displacement of a body from its parabola because it follows another one.
  /// \param time  [s] after the start
  /// \return [m] world frame; 0 for a body that follows none
  [[nodiscard]] Vec3 offset_w(int body, double time) const;

  /// Puts all bodies where they are at a time.
  /// \param world  the bodies of begin(); states are overwritten
  /// \param time   [s] after the start
  /// \throws std::invalid_argument if an angular momentum is not finite
  void put(World& world, double time, RotationRule rule) const;

  /// Puts one body where it is at a time.
  /// \param world  the bodies of begin(); its state is overwritten
  /// \param body   its index; nothing happens to an immovable one
  /// \throws std::invalid_argument if an angular momentum is not finite
  void put(World& world, int body, double time, RotationRule rule) const;

  /// The states at the start: one for each body index.
  [[nodiscard]] std::span<const BodyState> start() const { return start_; }

 private:
  std::vector<BodyState> start_;
  std::vector<Wrench> wrenches_;
  PivotUpdate carried_;
};

}  // namespace tumble
