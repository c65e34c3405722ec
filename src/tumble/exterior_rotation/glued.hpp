/// \file
/// \brief The glued technique: bodies in contact at the start stick together permanently (thesis 6.2).
///
/// Uses the chapter on analytic forces.
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/base/options.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/exterior_rotation/joint_contacts.hpp"
#include "tumble/exterior_rotation/joint_events.hpp"
#include "tumble/exterior_rotation/runge_kutta.hpp"
#include "tumble/exterior_rotation/simple_steps.hpp"
#include "tumble/exterior_rotation/tolerances.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace tumble {

/// Time integration schemes.
enum class GluedScheme : std::uint8_t {
  rk4,             ///< classical_table()
  dormand_prince,  ///< dormand_prince_table(), with adaptive steps
  midpoint,        ///< midpoint_table()
  forward_euler,   ///< SimpleScheme::forward_euler, the thesis's
  semi_implicit,   ///< SimpleScheme::semi_implicit
  impulse,         ///< SimpleScheme::impulse
  leapfrog         ///< SimpleScheme::leapfrog
};

/// All schemes, in the order of the enumeration.
std::span<const GluedScheme> glued_schemes();

/// The name of a scheme in options: its enumerator as text.
std::string_view name_of(GluedScheme scheme);

/// Whether joints can open.
enum class GluedJoints : std::uint8_t {
  bilateral,  ///< glue: a joint pulls as well as it pushes
  unilateral  ///< unlimited friction without glue: a joint that would have to pull opens
};

/// Time at which a change of a joint takes effect.
enum class GluedEvents : std::uint8_t {
  located,  ///< the event is located, and the step divided there
  step_end  ///< at the end of the step
};

/// What bodies do that touch, other than by a joint of the scene.
enum class GluedContacts : std::uint8_t {
  stick,   ///< those that touch at the start stick; later ones pass through each other
  collide  ///< they push and rub, see JointContacts; only joints of the scene hold
};

/// Options of the glued technique.
struct GluedOptions {
  GluedScheme scheme = GluedScheme::rk4;          ///< time integration
  PoseUpdate pose = PoseUpdate::separate;         ///< of the schemes with one evaluation of forces
  GluedJoints joints = GluedJoints::bilateral;    ///< whether joints can open
  GluedEvents events = GluedEvents::located;      ///< time of their changes
  GluedContacts contacts = GluedContacts::stick;  ///< of bodies that touch
  /// [-] of dormand_prince: error allowed in a step, see RungeKutta::step()
  double accuracy = tolerance::rotation_accuracy;
};

template <class Visitor>
void describe(GluedOptions& o, Visitor& v) {
  v.word("scheme", o.scheme, words_of(glued_schemes()), "time integration (thesis 6.2)");
  v.word("pose", o.pose, words_of(pose_updates()),
         "schemes with one evaluation of forces: centre and orientation apart, or by one twist");
  v.word("joints", o.joints,
         {{"bilateral", GluedJoints::bilateral}, {"unilateral", GluedJoints::unilateral}},
         "glue, or very high friction without pull");
  v.word("events", o.events,
         {{"located", GluedEvents::located}, {"step_end", GluedEvents::step_end}},
         "joints=unilateral: time at which joints open or close");
  v.word("contacts", o.contacts,
         {{"stick", GluedContacts::stick}, {"collide", GluedContacts::collide}},
         "bodies that touch at the start stick, others pass; or all collide, and only [[joint]] "
         "holds (thesis 2.6.5)");
  v.number("accuracy", o.accuracy, tolerance::least_rotation_accuracy, 1.0, "-",
           "scheme=dormand_prince: error allowed in a step, in edges and radians");
}

/// Bodies that stick where they touch at the start, without any other contact.
///
/// The situation of section 6.2 in isolation: unlimited friction, and forces that are exact at the instant
/// at which they are computed. The remaining error is that of the integration scheme.
///
/// The first step finds the joints (find_joints()). A body that is added later sticks to the bodies it
/// touches in the next step; other joints do not change. Relative velocity that new joints forbid is
/// removed, as in an impact without restitution. Bodies that have come apart, or meet later, pass
/// through each other.
///
/// **Joints of the scene** (World::joints()) are held beside them, or alone with `contacts = collide`: bodies then meet as
/// JointContacts has it. Two bodies that a joint joins stick nowhere else and never collide. What a step leaves of a gap in such
/// joints is closed after it.
///
/// **Unilateral joints** change at events, see joint_margin(). A located event is found to
/// `tolerance::joint_moment` of a step by repeating the step with other lengths; the joint is changed, and
/// the step continues from there, so that the order of the scheme is preserved. With `step_end` a change
/// is up to a step late. The error is quadratic in the delay where a face opens, and linear where an edge
/// is released, as its friction ends at once: order 1 remains.
/// \par Cost
/// As many solves of the joints as the scheme has stages, one more per step for unilateral joints, and
/// about forty steps for a located event.
/// \algorithm{A group that sticks: section 6.2 with its footnote}
/// \verified{Orders of the glued column are 1, 1, 1, 2 and 4}
class Glued : public Cloned<Technique, Glued> {
 public:
  /// Makes the technique.
  /// \throws std::invalid_argument for an accuracy out of range, pose=exponential with a scheme of
  ///         several stages, or contacts=collide with one that is not of Runge and Kutta, has steps of its own
  ///         length, or with joints that open
  explicit Glued(const GluedOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "glued"; }
  /// \copydoc Technique::step
  /// Worlds with more than 600 rows of joints that close loops are refused.
  StepReport step(World& world, double dt) override;
  /// \copydoc Technique::contacts
  /// One for each closed joint: the point of action of its force, at the pose of the last evaluation. With
  /// contacts=collide those of bodies that met, as impulses of the step, come before.
  [[nodiscard]] std::span<const ContactRecord> contacts() const override { return records_; }
  [[nodiscard]] std::vector<std::string> ignores(const World& world) const override;
  [[nodiscard]] bool holds_joints() const override { return true; }

  /// The present joints; empty before the first step, unless find() was called.
  [[nodiscard]] std::span<const Joint> joints() const { return joints_; }
  /// Finds the joints now instead of in the first step.
  void find(const World& world);
  /// Number of systems of joint forces solved in all steps: the cost, independent of the machine.
  [[nodiscard]] int solves() const { return forces_.solves(); }

 private:
  bool join(const World& world, std::vector<Joint>& fresh);
  void add_made(const World& world);
  void close(World& world);
  double advance(double dt, World& world);
  double meet(double dt, World& world, StepReport& report);
  double advance_adaptively(double most, World& world);
  double margin(const World& world, JointChange& change);
  double find_event(double taken, double dt, World& world);
  void change_joints(double time, World& world, StepReport& report);
  void end_relative_motion(std::span<const Joint> fresh, World& world, StepReport& report);
  void record(const World& world);

  GluedOptions options_;
  std::vector<Joint> joints_;
  std::vector<BodyId> found_for_;  // the bodies when the joints were found
  JointForces forces_;
  RungeKutta runge_kutta_;
  SimpleSteps simple_;
  JointContacts meeting_;
  std::size_t made_ = 0;  // joints of the scene
  double try_dt_ = 0.0;   // [s] of dormand_prince: length to try for the next step; 0: unknown

  // Storage of one step.
  std::vector<BodyState> start_;
  std::vector<MovingBody> moving_;
  std::vector<Wrench> wrenches_;
  std::vector<char> changed_;  // by joint, at one instant
  JointForces record_forces_;  // for contacts() and impacts: not counted as cost
  std::vector<ContactRecord> records_;
};

}  // namespace tumble
