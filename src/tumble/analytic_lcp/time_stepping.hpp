/// \file
/// \brief The technique of Stewart and Trinkle, and of Anitescu and Potra (thesis 2.6.3).
///
/// Uses no other chapter.
#pragma once

#include "tumble/analytic_lcp/passing_contacts.hpp"
#include "tumble/analytic_lcp/velocity_step.hpp"
#include "tumble/base/options.hpp"
#include "tumble/contact/pivot_update.hpp"
#include "tumble/contact/repair.hpp"
#include "tumble/dynamics/advance_pose.hpp"
#include "tumble/dynamics/technique.hpp"

#include <memory>
#include <vector>

namespace tumble {

/// Options of the time-stepping technique.
struct TimeSteppingOptions {
  VelocityStepOptions velocities;                   ///< how velocities are found
  RotationRule rotation = RotationRule::splitting;  ///< how bodies turn
  PoseUpdate pose = PoseUpdate::separate;           ///< how bodies that push each other are moved
};

/// Names the options to a visitor, see options.hpp.
/// \param o  the options
/// \param v  an OptionDeclarer or OptionReader
template <class Visitor>
void describe(TimeSteppingOptions& o, Visitor& v) {
  v.word("form", o.velocities.form,
         {{"stewart_trinkle", SteppingForm::stewart_trinkle},
          {"anitescu_potra", SteppingForm::anitescu_potra}},
         "contacts may close their gaps, or only touching points count");
  v.word("directions", o.velocities.directions, {{"8", 8}, {"4", 4}},
         "directions of the friction pyramid");
  v.word("sticky", o.velocities.sticky.rule,
         {{"speed", StickyRule::speed},
          {"step_size", StickyRule::step_size},
          {"off", StickyRule::off}},
         "rule for collisions that are too slow to bounce (thesis 4.3)");
  v.word("rotation", o.rotation, words_of(rotation_rules()), kRotationMeaning);
  v.word("pose", o.pose, words_of(pose_updates()), kPoseMeaning);
}

/// No event is searched for: each step finds the velocities at its end, then moves all bodies with
/// them.
///
/// VelocityStep takes resting contacts and impacts of a step together, one complementarity problem
/// for each group of bodies. Poses of bodies near others follow by the semi-implicit rule
/// \f$x^+ = x + h\,v^+\f$; the others fly their parabola. Orientations follow by the new angular momentum. The
/// remaining overlap, of order (hω)² of a body's size because points move on arcs and the problem
/// assumes straight lines, is removed by moving bodies.
///
/// **Bodies that turn together** about a point outside of them come apart by this, and are kept together
/// by PoseUpdate::exponential: velocities agree at the poses of the start, and poses follow from them
/// (PivotUpdate).
///
/// **The form.** Stewart and Trinkle's is the default: a body may close its gap and no more, so nothing
/// is passed at any step. With Anitescu and Potra's a fast body sinks in by \f$h\,v\f$ before it is
/// noticed, and may pass a thin one. Their proof that there is always a solution holds for both, since
/// only positive gaps are used.
///
/// **The pyramid.** 8 directions are the default: half way between them friction is weaker by up to 8 %.
/// With 4, along the axes of the world for level or upright faces, it is exact along them, weaker by up
/// to 29 % between them, and takes about a third of the work.
///
/// **Restitution** is Newton's at all points at once, see VelocityStep: bodies turn back up to a step before they touch.
/// In a row of bodies that touch, those that do not approach part only as far as they are pushed apart.
///
/// **Energy.** No step raises it, but for the repair of overlap. A body that nothing is near keeps it; others move
/// with the velocity of the step's end, so that gravity does \f$\tfrac h2 m\,g\cdot(v^+ - v^-)\f$ more than at
/// the mean velocity. This is booked with the impulses along the normals. A bounce leaves e² of the energy, what lifts
/// the body in the rest of the step included: a cube that comes with v leaves with the speed
/// \f$\sqrt{e^2v^2 + g^2h^2} - g\,h\f$.
///
/// **How far it looks.** Points count up to the distance that the two fastest bodies can close in a step.
/// Bodies without a contact area as long as they are apart (corner to corner) touch where they would
/// overlap at the end (PassingContacts). A body that is sent off faster than all by an impact in this very
/// step may overlap for a step and be repaired.
/// \par Cost
/// O(N³) for a group with N unknowns, (2 + d) for each point that rubs; a group in which nothing rubs
/// is solved without friction. Groups above FrictionLemkeSolver::kMostUnknowns are swept: some hundred sweeps of O(N).
/// \see Stewart, Trinkle 1996; Anitescu, Potra 1997 (see FrictionPyramid).
/// \algorithm{Time stepping: section 2.6.3}
/// \verified{A box that slides stops after 62 steps and 1.5041075 m}
class TimeStepping : public Technique {
 public:
  /// Makes the technique.
  /// \param options see there
  /// \throws std::invalid_argument for a number of directions other than 4 or 8
  explicit TimeStepping(const TimeSteppingOptions& options = {});
  /// A copy with all memory.
  /// \param other the original
  TimeStepping(const TimeStepping& other);
  TimeStepping& operator=(const TimeStepping&) = delete;
  ~TimeStepping() override = default;

  [[nodiscard]] std::string_view name() const override { return "time_stepping"; }
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::unique_ptr<Technique> clone() const override;
  [[nodiscard]] std::span<const ContactRecord> contacts() const override { return records_; }
  [[nodiscard]] std::vector<Diagnostic> diagnostics() const override;
  /// The problem that the last step could not solve.
  /// \return nullptr if there is none; valid until the next step
  [[nodiscard]] const LcpProblem* unsolved_problem() const { return velocity_step_.problem(); }

  /// How the velocities of the last step were found.
  /// \return with the error of the answers
  [[nodiscard]] const VelocityStepResult& velocities() const { return velocities_; }

 private:
  StepReport step_part(World& world, double dt);
  void gather(const World& world, double dt, StepReport& report);
  void find_pairs(const World& world, double margin);
  void record(const World& world);
  void find_flying(const World& world);
  [[nodiscard]] double moved_against_gravity(const World& world, double dt) const;
  void move(World& world, double dt, StepReport& report);

  TimeSteppingOptions options_;
  std::unique_ptr<BroadPhase> broad_phase_;
  VelocityStep velocity_step_;
  VelocityStepResult velocities_;
  PassingContacts passing_;
  OverlapRepair repair_;
  PivotUpdate carried_;

  // Storage of one step, kept so that a warm step asks for no memory.
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> pairs_;
  std::vector<MovingBody> moving_;
  std::vector<Acceleration> free_;
  ContactList contacts_;
  std::vector<PushedPair> pushed_;
  std::vector<char> flying_;  // by body index: nothing is near it
  std::vector<ContactRecord> records_;
};

}  // namespace tumble
