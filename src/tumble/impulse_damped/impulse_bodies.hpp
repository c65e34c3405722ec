/// \file
/// \brief Bodies of a step that is solved by impulses: how they move, and where that takes them.
#pragma once

#include "tumble/contact/moving_body.hpp"
#include "tumble/contact/pivot_update.hpp"
#include "tumble/dynamics/advance_pose.hpp"

#include <span>
#include <vector>

namespace tumble {

/// The velocities of all bodies during a step, and the poses that they lead to at its end.
///
/// Impulses of Guendelman, Bridson and Fedkiw are decided at poses that the bodies would have at
/// the end of the step,
/// \f[ x' = x + h\,(v + h\,g), \qquad q' = \text{rule}(q, L, h), \f]
/// while the velocities that they change are those of the step. The predicted centre stands in
/// MovingBody::position_w, so lever arms are those of the predicted poses; inertia is that of the
/// step's start, so that the energy of an impulse is exact. As h g is part of the prediction from
/// the start, adding gravity to the velocities moves no prediction.
///
/// **Carried bodies** (PivotUpdate, with RigidAt::end, as impulses make velocities agree where bodies
/// will be): a body is predicted about the point on which it stands. Bodies that it carries follow when carry()
/// is called, at the beginning of each pass and before the move, so that in between others are predicted
/// with what carried them when the pass began.
///
/// Sleeping bodies count as immovable.
class ImpulseBodies {
 public:
  /// Reads all velocities and predicts all poses.
  /// \param world   the bodies at the start of the step
  /// \param dt      [s] h, above 0
  /// \param pushed  the pushes when the step before ended; empty: no body is carried
  void begin(const World& world, double dt, RotationRule rule,
             std::span<const PushedPair> pushed = {});

  /// Predicts where a body will be, after its velocity was changed.
  /// \param world  as for begin(); poses are still those of the start
  void predict(const World& world, int body);

  /// Predicts all that are carried anew, as far as the bodies below them have changed.
  void carry(const World& world);

  /// Adds h g to the velocity of every body that moves, and to its momentum in the world.
  /// \param world the bodies; linear momenta in and out
  void add_gravity(World& world);

  /// Makes a body as heavy as the ground, until thaw().
  void freeze(int body);

  /// Gives all bodies their own mass and inertia back.
  void thaw(const World& world);

  /// Writes the velocities into the world and moves all bodies with them.
  /// \param energy  [J] what carried bodies have got by not going straight is added
  /// \return how many bodies were moved
  int move(World& world, double& energy);

  /// Energy that impulses of contacts are not booked with: they count at velocities of half a step of gravity earlier,
  /// and bodies move with those of the step's end. For one that was pushed, with v_c after collisions and v' at the
  /// end, m h g·(v_c - v') / 2; what rests, slides along or flies has none.
  /// \return [J] after move()
  [[nodiscard]] double moved_against_gravity(const World& world) const;

  /// How bodies move, the predicted centre as position.
  /// \return one for each body index; call predict() after a change of velocity
  [[nodiscard]] std::span<MovingBody> moving() { return moving_; }
  /// Where bodies will be: one for each body index.
  [[nodiscard]] std::span<const BodyState> predicted() const { return predicted_; }
  /// How often a body was predicted in this step: from 1; another number means another pose.
  [[nodiscard]] int version(int body) const { return version_[static_cast<std::size_t>(body)]; }
  /// How often any body was predicted in this step: the sum over all bodies.
  [[nodiscard]] int predictions() const { return predictions_; }

 private:
  [[nodiscard]] bool moves(const World& world, std::size_t k) const;

  double dt_ = 0.0;  // [s]
  RotationRule rule_ = RotationRule::splitting;
  Vec3 ahead_w_ = Vec3::Zero();  // [m/s] of gravity, not yet in the velocities
  int predictions_ = 0;
  std::vector<MovingBody> moving_;
  std::vector<Vec3> collided_w_;  // [m/s] before gravity was added
  std::vector<BodyState> predicted_;
  std::vector<int> version_;
  PivotUpdate carried_;
};

}  // namespace tumble
