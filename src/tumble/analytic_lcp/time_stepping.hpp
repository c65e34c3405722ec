/// \file
/// \brief The technique of Stewart and Trinkle, and of Anitescu and Potra (thesis 2.6.3).
#pragma once

#include "tumble/analytic_lcp/passing_contacts.hpp"
#include "tumble/analytic_lcp/velocity_step.hpp"
#include "tumble/base/cloned.hpp"
#include "tumble/base/options.hpp"
#include "tumble/contact/pivot_update.hpp"
#include "tumble/contact/repair.hpp"
#include "tumble/dynamics/advance_pose.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/geometry/bounding_tree.hpp"

#include <vector>

namespace tumble {

/// Options of the time-stepping technique.
struct TimeSteppingOptions {
  VelocityStepOptions velocities;                   ///< of the step of velocities
  RotationRule rotation = RotationRule::splitting;  ///< how orientations are integrated
  PoseUpdate pose = PoseUpdate::separate;           ///< how bodies that push each other are moved
};

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

/// Time stepping without a search for events: each step solves for the velocities at its end, and moves all bodies with
/// them.
///
/// VelocityStep solves contacts and impacts of a step together, one complementarity problem for each island. Bodies near
/// others move by the semi-implicit rule \f$x^+ = x + h\,v^+\f$, the others along their parabola; orientations follow
/// from the new angular momentum. The remaining overlap is removed by moving bodies: it is of order (hω)² of a body's size,
/// since points move on arcs and the problem assumes straight lines.
///
/// **Bodies that turn together** about a point outside of them separate by this, unless they move by
/// PoseUpdate::exponential: velocities are consistent at the poses of the start, and poses follow from them (PivotUpdate).
///
/// **Form.** With Stewart and Trinkle's, the default, a body may close its gap and no more, so nothing is passed at any
/// step. With Anitescu and Potra's a fast body overlaps by \f$h\,v\f$ before it is found, and may pass a thin one. Their
/// proof that there is always a solution holds for both, since only positive gaps are used.
///
/// **Pyramid.** With 8 directions, the default, friction is weaker by up to 8 % between them. With 4 it is exact along
/// them (the axes of the world, for level or upright faces), weaker by up to 29 % between them, and needs a third of the
/// work.
///
/// **Restitution** is Newton's at all points at once, see VelocityStep: bodies turn back up to a step before they touch.
/// In a row of touching bodies, those that do not approach separate only as far as they are pushed apart.
///
/// **Energy.** No step raises it, except by the repair of overlap. Bodies near others move with the velocity at the end of
/// the step, so that gravity does \f$\tfrac h2 m\,g\cdot(v^+ - v^-)\f$ more work than at the mean velocity; this is
/// booked with the normal impulses. A bounce leaves e² of the energy at the end of its step: a cube that arrives with v
/// leaves with \f$\sqrt{e^2v^2 + g^2h^2} - g\,h\f$.
///
/// **Range.** Points count up to the distance that the two fastest bodies can close in a step. Bodies without a contact
/// area while they are apart (corner to corner) touch where they would overlap at the end (PassingContacts). Where a step would
/// turn bodies that touch in a point so that they overlap elsewhere, it is solved again with the points of that overlap. A body that
/// an impact makes the fastest in this step may overlap for a step and be repaired.
/// \par Cost
/// O(N³) for a group with N unknowns, (2 + d) for each point that rubs; a group in which nothing rubs
/// is solved without friction. Groups above FrictionLemkeSolver::kMostUnknowns are swept: some hundred sweeps of O(N).
/// \see Stewart, Trinkle 1996; Anitescu, Potra 1997 (see FrictionPyramid).
/// \algorithm{Time stepping: section 2.6.3}
/// \verified{A sliding box stops where Coulomb's law says}
class TimeStepping : public Cloned<Technique, TimeStepping> {
 public:
  /// Makes the technique.
  /// \throws std::invalid_argument for a number of directions other than 4 or 8
  explicit TimeStepping(const TimeSteppingOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "time_stepping"; }
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::span<const ContactRecord> contacts() const override { return records_; }
  [[nodiscard]] std::vector<Diagnostic> diagnostics() const override;
  /// The problem that the last step could not solve; nullptr if there is none; valid until the next step.
  [[nodiscard]] const LcpProblem* unsolved_problem() const { return velocity_step_.problem(); }

  /// How the velocities of the last step were found, with the error of the answers.
  [[nodiscard]] const VelocityStepResult& velocities() const { return velocities_; }

 private:
  StepReport step_part(World& world, double dt);
  void gather(const World& world, double dt, StepReport& report);
  void find_pairs(const World& world, double margin);
  void record(const World& world);
  void find_flying(const World& world);
  [[nodiscard]] double moved_against_gravity(const World& world, double dt) const;
  void move(World& world, double dt, StepReport& report);
  bool solve_missed(World& world, double dt, StepReport& report);

  TimeSteppingOptions options_;
  BoundingTree broad_phase_;
  VelocityStep velocity_step_;
  VelocityStepResult velocities_;
  PassingContacts passing_;
  OverlapRepair repair_;
  PivotUpdate carried_;

  // Storage of one step, kept so that a warm step asks for no memory.
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> pairs_;
  std::vector<BodyState> start_;    // of the step
  std::vector<BodyState> ended_;    // at its end, before it is solved again
  std::vector<MovingBody> before_;  // at its start
  std::vector<MovingBody> moving_;  // at its end, once it is solved
  std::vector<MovingBody> again_;   // ditto, solved again
  std::vector<Acceleration> free_;
  ContactList contacts_;
  ContactList more_;  // with those that the step missed
  std::vector<PushedPair> pushed_;
  std::vector<char> flying_;  // by body index: nothing is near it
  std::vector<ContactRecord> records_;
};

}  // namespace tumble
