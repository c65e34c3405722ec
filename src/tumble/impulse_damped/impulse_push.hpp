/// \file
/// \brief One impulse between two bodies that overlap where they are about to be (thesis 2.5.2).
#pragma once

#include "tumble/contact/simultaneous_impacts.hpp"
#include "tumble/impulse_damped/impulse_pairs.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace tumble {

/// Where the impulse of a pair acts.
///
/// The authors look at one point of a pair after the other. A box that lands flat then gets its
/// first impulse at a corner, which spins it: a cube at -2 m/s with e = 0.9 leaves at -1.05 m/s,
/// turning at 2.85 rad/s about two axes, instead of at +1.8 m/s without turning. Both choices here
/// are right.
enum class ImpulsePoints : std::uint8_t {
  area,  ///< at all points of the contact area together (SimultaneousImpacts)
  one    ///< at their centre, each point weighted by its depth
};

/// What an impulse did.
struct PushResult {
  bool pushed = false;         ///< whether the pair approached, and so was pushed
  int impulses = 0;            ///< points that were pushed
  int pivots = 0;              ///< of the complementarity solver
  double normal_work = 0.0;    ///< [J] of the normal impulses, on the bodies that are free to move
  double friction_work = 0.0;  ///< [J] of the tangential ones
};

/// Collisions and contacts of pairs by impulses.
///
/// No impulse pulls, friction is within Coulomb's cone, momentum is kept, and kinetic energy does
/// not rise, as SimultaneousImpacts and solve_impact() have it. Only if a movable body was frozen, the
/// latter holds for the motion against that body alone: what it lifts gains energy, which is
/// booked.
class ImpulsePush {
 public:
  /// Chooses the points.
  explicit ImpulsePush(ImpulsePoints points = ImpulsePoints::area) : points_(points) {}

  /// Lets a pair collide: Newton's restitution, Coulomb's friction.
  ///
  /// The speed of approach to which restitution belongs is that of the event, the fastest at which
  /// this pair has been seen to approach in this step. If others press the two together again, they
  /// part with that speed again, or as fast as the energy of the new approach allows.
  /// \param pair         overlaps; impulses are added to its points
  PushResult collide(ImpulsePair& pair, std::span<MovingBody> bodies, double restitution,
                     double dt);

  /// Lets a pair that is in contact approach more slowly.
  ///
  /// With ε = -1 + share below 0 for restitution, a point that approaches at v goes on at |ε| v.
  /// It is found as this share of the impulse that ends the approach: the same for one point
  /// without friction, since that impulse is linear in 1 + ε, and for several that all approach.
  /// No more than this is needed for the promises of the class: cones are convex and energy is
  /// too, so a part of an impulse that keeps them keeps them as well. Friction comes in by the
  /// same share.
  /// \param pair    overlaps; impulses are added to its points
  /// \param share   [-] 1 + ε, above 0 and at most 1, which ends the approach
  /// \param ahead_w [m/s] how far the velocities are ahead of those at which the work of the
  ///                impulse is reported: half of what gravity gave in this step
  PushResult hold(ImpulsePair& pair, std::span<MovingBody> bodies, double share, double dt,
                  const Vec3& ahead_w = Vec3::Zero());

 private:
  bool load(const ImpulsePair& pair, std::span<const MovingBody> bodies, double dt);
  int solve(std::span<MovingBody> bodies);
  bool stops_at_center(std::span<MovingBody> bodies);
  void solve_at_center(std::span<MovingBody> bodies);
  PushResult push(ImpulsePair& pair, std::span<MovingBody> bodies, double share,
                  const Vec3& ahead_w);
  static void account(const MovingBody& before, const MovingBody& after, double side,
                      const Vec3& ahead_w, const Contact& work, PushResult& result);

  ImpulsePoints points_;
  Contact work_;  // the impulses of this call alone
  Vec3 center_w_ = Vec3::Zero();
  double still_ = 0.0;                                  // [m/s] slower than this is none
  std::array<double, Manifold::kMostPoints> weight_{};  // of the points, sum 1
  SimultaneousImpacts block_;
};

}  // namespace tumble
