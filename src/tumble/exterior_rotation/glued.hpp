/// \file
/// \brief The technique in which whatever touches at the start sticks for ever (thesis 6.2).
///
/// Uses the chapter on analytic forces.
#pragma once

#include "tumble/base/options.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/exterior_rotation/joint_events.hpp"
#include "tumble/exterior_rotation/runge_kutta.hpp"
#include "tumble/exterior_rotation/simple_steps.hpp"
#include "tumble/exterior_rotation/tolerances.hpp"

#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace tumble {

/// How the motion is integrated.
enum class GluedScheme : std::uint8_t {
  rk4,             ///< classical_table()
  dormand_prince,  ///< dormand_prince_table(), steps as long as the accuracy allows
  midpoint,        ///< midpoint_table()
  forward_euler,   ///< SimpleScheme::forward_euler, the thesis's
  semi_implicit,   ///< SimpleScheme::semi_implicit
  impulse,         ///< SimpleScheme::impulse
  leapfrog         ///< SimpleScheme::leapfrog
};

/// All schemes, in the order of the enumeration.
/// \return each once
std::span<const GluedScheme> glued_schemes();

/// The name that a user calls a scheme by.
/// \param scheme one of them
/// \return as in the enumeration
std::string_view name_of(GluedScheme scheme);

/// Whether joints can open.
enum class GluedJoints : std::uint8_t {
  bilateral,  ///< glue: a joint pulls as well as it pushes
  unilateral  ///< very high friction and no glue: what would have to be pulled comes apart
};

/// When it is noticed that a joint opens, comes apart or closes.
enum class GluedEvents : std::uint8_t {
  located,  ///< the moment is searched for, and the step is divided there
  step_end  ///< at the end of the step in which it happened
};

/// Options of the technique.
struct GluedOptions {
  GluedScheme scheme = GluedScheme::rk4;        ///< how the motion is integrated
  PoseUpdate pose = PoseUpdate::separate;       ///< of the schemes that find forces once
  GluedJoints joints = GluedJoints::bilateral;  ///< whether they can open
  GluedEvents events = GluedEvents::located;    ///< when that is noticed
  /// [-] of dormand_prince: error allowed in a step, see RungeKutta::step()
  double accuracy = tolerance::rotation_accuracy;
};

/// Names the options to a visitor, see options.hpp.
/// \param o  the options
/// \param v  an OptionDeclarer or OptionReader
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
  v.number("accuracy", o.accuracy, tolerance::least_rotation_accuracy, 1.0, "-",
           "scheme=dormand_prince: error allowed in a step, in edges and radians");
}

/// Bodies that stick where they touch at the start, and know no other contact.
///
/// The situation of section 6.2 by itself: friction so high that nothing slips, and forces that are
/// right at the instant for which they are found. What is left to go wrong is the integration, and
/// every scheme that is chosen here shows its own error.
///
/// The first step finds the joints (find_joints()). A body that is added later sticks to what it touches
/// in the next step; the others keep their joints as they are. What joints do not allow of the velocities
/// is lost then, as in an impact that does not bounce. Bodies that have come apart, or come together
/// later, pass through each other.
///
/// **Unilateral joints** change at events, see joint_margin(). Located, each is found to
/// `tolerance::joint_moment` of a step by steps of other lengths from the same start, the joint is
/// changed, and the step goes on from there; the order of the scheme is kept across it. Noticed at the
/// end of a step, an event is up to a step late. A face that opens costs the square of the delay, an edge
/// that lets go the delay itself, as its friction ends at once: order 1 is left.
/// \par Cost
/// As many solves of the joints as the scheme has stages, one more a step for unilateral joints, and some
/// forty steps' worth for a located event.
/// \algorithm{A group that sticks: section 6.2 with its footnote}
/// \verified{Orders of the glued column are 1, 1, 1, 2 and 4}
class Glued : public Technique {
 public:
  /// Makes the technique.
  /// \param options see there
  /// \throws std::invalid_argument for an accuracy out of range, or pose=exponential with a scheme of
  ///         several stages
  explicit Glued(const GluedOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "glued"; }
  /// \copydoc Technique::step
  /// Worlds in which more than a hundred pairs of bodies touch are refused.
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::unique_ptr<Technique> clone() const override;
  /// \copydoc Technique::contacts
  /// One for each joint that holds: where the force acts, at the pose for which it was found last.
  [[nodiscard]] std::span<const ContactRecord> contacts() const override { return records_; }
  [[nodiscard]] std::vector<std::string> ignores(const World& world) const override;

  /// The joints as they are now.
  /// \return empty before the first step, unless find() was called
  [[nodiscard]] std::span<const Joint> joints() const { return joints_; }
  /// Finds the joints now instead of in the first step.
  /// \param world the bodies
  /// \throws std::invalid_argument for more than a hundred pairs that touch
  void find(const World& world);
  /// How many systems of joint forces were solved in all steps: the work, whatever the machine.
  /// \return from 0
  [[nodiscard]] int solves() const { return forces_.solves(); }

 private:
  bool join(const World& world, std::vector<Joint>& fresh);
  double advance(double dt, World& world);
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
  double try_dt_ =
      0.0;  // [s] of dormand_prince: what the next step may be as long as; 0: not known

  // Storage of one step.
  std::vector<BodyState> start_;
  std::vector<MovingBody> moving_;
  std::vector<Wrench> wrenches_;
  std::vector<char> changed_;  // by joint, at one instant
  JointForces told_;           // for contacts() and impacts: not counted as work
  std::vector<ContactRecord> records_;
};

}  // namespace tumble
