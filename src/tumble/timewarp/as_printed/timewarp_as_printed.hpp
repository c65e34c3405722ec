/// \file
/// \brief The synchronised timewarp as its two listings are printed (thesis A.1).
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/timewarp/as_printed/queries_as_printed.hpp"

#include <span>
#include <vector>

namespace tumble {

/// The thesis's two listings of a synchronised timewarp, statement by statement, with all their
/// misprints, or with some of them mended.
///
/// It serves to be compared with the reading as meant: a run with all errata mended but one shows the
/// effect of that one. Functions that the listings call without defining them are in PrintedQueries,
/// with their errata; those in the lines themselves are
///
/// | errata | as printed                                        | mended                       |
/// |--------|---------------------------------------------------|------------------------------|
/// | T1     | one body collides before the other one is there   | both go there first          |
/// | T2     | two nested loops share a counter and end at once  | each has its own             |
/// | T3     | a body is searched against an old test state      | both test states first       |
/// | T10    | immovable bodies are stamped and searched again   | they are not                 |
/// | F1     | test states collide and are then overwritten      | valid states collide         |
/// | F2     | valid times stay at the frame's start             | they are updated             |
/// | F3     | test states of neighbours are not restored        | they are                     |
/// | F4     | restored test states are those at the collision   | at the end of the frame      |
/// | F5     | an earlier collision discards the present one     | it and its states are kept   |
///
/// T2 has an effect only where T1 is not mended, F3 and F4 only with neighbours near the collision, F6
/// only where T7 is not mended: otherwise the present pair is apart at its time. F8 is a choice and F9 a
/// misprint in a caption; mending them changes nothing. T5 and T9 are choices, too: with them mended the
/// simple listing is equivalent to TimewarpSwept.
/// \par Status
/// `event_cap` if the main loop has reached its cap: test states then become valid as they are.
/// `not_finite` if they are not numbers: the frame is then undone, except for its time.
/// \par Cost
/// As TimewarpSimple and TimewarpSafer, but each body of a collision costs n bounds. Allocates.
/// \algorithm{Timewarp as printed: appendix A.1}
/// \deviation{The main loop is capped.}
/// \verified{With all misprints mended the printed timewarps give the collisions of the forms as meant to the last bit}
/// \verified{The timewarp as printed ends every step with finite numbers, whatever is mended}
class TimewarpAsPrinted final : public Cloned<Technique, TimewarpAsPrinted> {
 public:
  /// Makes the technique.
  /// \throws std::invalid_argument for a resolution not above 0, a cap below 1, or less than one
  ///         event a pair
  explicit TimewarpAsPrinted(const TimewarpAsPrintedOptions& options = {});

  /// The name of the form as meant: "timewarp_simple" or "timewarp_safer".
  [[nodiscard]] std::string_view name() const override;
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::span<const ContactRecord> contacts() const override {
    return queries_.contacts();
  }

  /// The valid times after the main loop of the last frame, before the last lines overwrite them.
  /// \return [s] by index, from the start of the frame; valid until the next step
  [[nodiscard]] std::span<const double> valid_times() const { return valid_times_; }

  /// The test states after the main loop of the last frame, before overlap is repaired.
  /// \return by index; valid until the next step
  [[nodiscard]] std::span<const BodyState> test_states() const { return test_states_; }

  /// Passes of the main loop in the last frame [-]: from 0 to the cap.
  [[nodiscard]] int passes() const { return passes_; }

 private:
  void simple(World& world, double dt);
  void safer(World& world, double dt);
  bool given_up();
  void main_loop_ended();

  TimewarpAsPrintedOptions options_;
  PrintedQueries queries_;
  CollisionHeap collision_heap_;
  PrintedMoment current_;
  std::vector<double> valid_times_;
  std::vector<BodyState> test_states_;
  int passes_ = 0;
};

}  // namespace tumble
