/// \file
/// \brief Damped integration, the thesis's own technique (thesis 5.2 to 5.4, A.2).
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/base/options.hpp"
#include "tumble/contact/islands.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/geometric_stability/geometrically_stable.hpp"
#include "tumble/impulse_damped/damped_stage.hpp"
#include "tumble/impulse_damped/dampen_objects.hpp"
#include "tumble/impulse_damped/fix_contact_constraints.hpp"

#include <cstdint>
#include <vector>

namespace tumble {

/// Remedy for overlap that the impulses leave.
enum class ShockRule : std::uint8_t {
  position,  ///< bodies are pushed out of overlap: the thesis's (4.4)
  velocity   ///< shock propagation, from the ground up: Guendelman's; no body is moved
};

/// Options of damped integration.
struct DampedOptions {
  int collision_passes = 5;                         ///< NUM_COLLISION_ITERATIONS
  int contact_passes = 10;                          ///< NUM_CONTACT_ITERATIONS
  NormalRule normals = NormalRule::last_face;       ///< contact normal of a pair
  PointRule points = PointRule::one;                ///< contact points of a pair
  ShockRule shock = ShockRule::position;            ///< remedy for remaining overlap
  StableRule stable_boxes = StableRule::corners;    ///< rule of geometric stability
  DampingParts damping;                             ///< parts of the damping in use
  DampedNumbers numbers;                            ///< thresholds ε and factors k
  NoiseOptions noise;                               ///< randomness in collisions
  bool sleeping = false;                            ///< islands at rest are not simulated (4.5)
  RotationRule rotation = RotationRule::splitting;  ///< how orientations are integrated
  std::uint64_t seed = 1;                           ///< of randomness
};

template <class Visitor>
void describe(DampedOptions& o, Visitor& v) {
  v.word("normals", o.normals,
         {{"last_face", NormalRule::last_face},
          {"separation", NormalRule::separation},
          {"signed_distance", NormalRule::signed_distance}},
         "contact normal of overlapping pairs: the closest face of the last step (thesis 3.3.2), "
         "the axis of least overlap, or the gradient of a box's distance");
  v.word("points", o.points, {{"one", PointRule::one}, {"area", PointRule::area}},
         "contact points of a pair: one as in the thesis, or the whole contact area");
  v.word("shock", o.shock, {{"position", ShockRule::position}, {"velocity", ShockRule::velocity}},
         "remedy for remaining overlap: bodies are pushed up (thesis 4.4), or velocities are "
         "stopped from the ground up (Guendelman)");
  v.word("stable_boxes", o.stable_boxes,
         {{"corners", StableRule::corners}, {"hull", StableRule::hull}, {"off", StableRule::off}},
         "rule that classifies a box as geometrically stable (thesis 5.4)");
  v.word("damping", o.damping, damping_words(), "parts of the damping in use (thesis 5.3)");
  v.word("randomness", o.noise.where,
         {{"off", Randomness::off},
          {"fast", Randomness::fast},
          {"slow", Randomness::slow},
          {"all", Randomness::all}},
         "collisions that are varied at random (thesis 4.2)");
  v.number("random_speed", o.noise.speed, 0.0, 1e6, "-",
           "threshold of fast collisions over sqrt(g L)");
  v.number("random_normal", o.noise.normal, 0.0, 1.0, "rad",
           "standard deviation of the angle of random normals");
  v.number("random_restitution", o.noise.restitution, 0.0, 1.0, "-",
           "half the range of random restitution");
  v.number("eps_scale", o.numbers.eps_scale, 0.0, 1e3, "-", "factor of all damping thresholds");
  v.number("k_scale", o.numbers.k_scale, 0.0, 1e3, "-", "exponent of all damping factors");
  v.whole("collision_passes", o.collision_passes, 0, 1000, "passes over collisions");
  v.whole("contact_passes", o.contact_passes, 0, 1000, "passes over contacts");
  v.flag("sleeping", o.sleeping, "do not simulate bodies at rest (thesis 4.5)");
  v.word("rotation", o.rotation, words_of(rotation_rules()), kRotationMeaning);
}

/// Damped integration: impulses, then damping, then pushes out of overlap.
///
/// Built on the impulses of Guendelman, Bridson and Fedkiw. A step
/// 1. lets bodies that would overlap at its end collide (resolve_collisions()), and stops those that gravity presses
///    together (resolve_contacts());
/// 2. adds gravity, damps bodies in contact and moves all bodies (ObjectDamping);
/// 3. pushes bodies out of overlap (FixContactConstraints);
/// 4. finds the geometrically stable bodies, which do not move downwards in the next step (GeometricStability).
///
/// Damping takes the place of friction.
///
/// **Energy** may rise, as in the thesis: impulses are applied one pair after the other, at velocities that include the
/// gravity of the step, and pushes lift bodies. Pushes, damping and impulses are booked; the error is that of the
/// semi-implicit rule for bodies in flight, and that of rotation.
///
/// **Fast bodies** stop where the step began, as with Impulse; from half their shortest edge on a run reports it (HitCheck).
/// One point of a face that lands flat stops the body, which turns it.
///
/// **Large turns.** A step in which a body turns by more than a radian is divided (parts_of_turn()).
///
/// **Repairs of the listing** are described at its parts; these are in the step itself: the damping depends on dt. A body
/// that is pushed or moved between two steps, or gets another gravity, is not stable in the second one. Overlap is searched
/// again after bodies have moved, for the pushes and, within tolerance::stability_margin, for stability; the listing uses
/// the pairs of the last pass, which belong to poses that no body has reached.
/// \par Cost
/// A broad phase and a test of each near pair in each of the 15 passes, and twice at the end.
/// \algorithm{DAMPEDINTEGRATION: section 5.2 and appendix A.2}
/// \deviation{Overlap is looked for again after bodies have moved.}
/// \verified{A cube at rest stays where it is to the last bit}
class Damped : public Cloned<Technique, Damped> {
 public:
  /// Makes the technique.
  /// \throws std::invalid_argument for a number of passes below 0, or constants out of range
  explicit Damped(const DampedOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "damped"; }
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::span<const ContactRecord> contacts() const override { return records_; }
  [[nodiscard]] std::vector<std::string> ignores(const World& world) const override;

  /// The bodies that were geometrically stable at the end of the last step: ids of movable bodies, ascending.
  [[nodiscard]] std::span<const BodyId> stable_bodies() const { return stable_ids_; }

 private:
  StepReport step_part(World& world, double dt, int part);
  [[nodiscard]] double moved_against_gravity(const World& world, double dt) const;
  void begin(World& world, double dt, StepReport& report);
  [[nodiscard]] bool keeps_mark(const World& world, std::size_t body) const;
  void integrate_object_velocities(World& world, double dt) const;
  void end(World& world, double dt, StepReport& report);
  void report_collisions(const World& world, double dt, StepReport& report);
  void record(const World& world, double dt, StepReport& report);

  DampedOptions options_;

  // Memory from step to step.
  std::vector<BodyId> stable_ids_;      // movable bodies that are stable, ascending
  std::vector<BodyState> stable_left_;  // ditto: as the step has left them
  Vec3 stable_under_w_ = Vec3::Zero();  // [m/s²] gravity of that step
  SleepingRule sleeping_;

  // Storage of one step, kept so that a warm step asks for no memory.
  PairGatherer gatherer_;  // by the rules of the options
  PairGatherer areas_;     // exact, all points
  PairGatherer
      margins_;  // ditto, and what is near: by itself, so that each knows what it found before
  DampedBodies bodies_;
  Collide collide_;
  ShockPropagation shock_;
  ObjectDamping damping_;
  FixContactConstraints fix_;
  GeometricStability stability_;
  Islands islands_;
  ContactList collisions_;
  PushedPairs pushed_;
  std::vector<char> stable_;
  std::vector<MovingBody> collided_;  // after collisions
  std::vector<Vec3> started_w_;       // [kg m/s] momenta before damping
  std::vector<ContactRecord> records_;
};

}  // namespace tumble
