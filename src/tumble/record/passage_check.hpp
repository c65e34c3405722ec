/// \file
/// \brief A check of a run by any technique: no body passes through another one.
#pragma once

#include "tumble/geometry/bounding_tree.hpp"
#include "tumble/record/run_checks.hpp"

#include <vector>

namespace tumble {

/// No body may pass through another one in a step, and none may overlap another one by more than
/// `tolerance::deep_overlap` of the shorter of their shortest edges at the end of the run. (During the run deep overlaps
/// are allowed: a technique may need some steps to separate bodies that meet fast.)
///
/// Two bodies that are apart before and after a step have passed through each other if their cores meet on the straight
/// line between the two poses. The core of a body is a box inside it, so much smaller that the turning body covers it
/// during the whole step. If cores overlap after a step, or come to overlap in several, the pair is checked in the same way
/// once it has separated, from its last separate poses. So a reported passage is certain; one near an edge is missed.
///
/// Where a body turns far, the step is divided, and each part is looked at in the same way: if it turned at one rate, that of
/// its angular velocity before or after, its way is known. If not, only passages through its centre are found.
/// \par Cost
/// A comparison for each body, as long as none moves or turns by half its shortest edge in a step or is deep in another one.
class PassageCheck : public RunCheck {
 public:
  void on_begin(const World& world) override;
  void on_change(const World& world, double energy_added) override;
  void on_step(const World& world, const StepReport& report) override;
  /// Looks for bodies that a step has brought into others, however slowly: they are found once they leave on the other side.
  /// \param world    after the step, which on_step() has seen
  /// \param deepest  [m] deepest overlap in it, see OverlapMeter; nothing is looked at where no core can have met another
  void on_overlap(const World& world, double deepest);
  /// Looks for bodies that are left in others.
  /// \param world  after the last step, finite
  void at_end(const World& world);

 private:
  // How a body turned in a step, at a constant rate.
  struct Turn {
    Vec3 turn_w = Vec3::Zero();  // [rad]
    double doubt = 0.0;          // [rad] how much that may be off
  };
  void look_for_passages(const World& world);
  void look_for_turns(const World& world);
  [[nodiscard]] Turn turn_in_step(const World& world, std::size_t k) const;
  [[nodiscard]] bool turns_into(const World& world, std::size_t first, const Turn& turn_of_first,
                                std::size_t second, const Turn& turn_of_second) const;
  void note_entered(const World& world, std::size_t first, std::size_t second);
  void look_at_entered(const World& world);
  void find_passage(const World& world, std::size_t first, std::size_t second);
  [[nodiscard]] double turn_of(const World& world, std::size_t k) const;

  std::vector<BodyState> before_;       // at the start of the step
  double time_ = 0.0;                   // [s] ditto
  std::vector<BodyState> last_before_;  // at the start of the one before
  double last_time_ = 0.0;              // [s] ditto
  BoundingTree near_;
  std::vector<char> fast_;          // not 0: moved by more than half its shortest edge
  std::vector<std::size_t> solid_;  // bodies with a core, by index; the next two are theirs
  std::vector<Box> cores_;          // where the step began
  std::vector<Bounds> swept_;
  std::vector<Turn> turns_;
  std::vector<IndexPair> pairs_;

  // Two bodies whose cores met in a step and have not parted since.
  struct Entering {
    std::size_t body = 0;
    BodyState before;     // where that step began
    double turned = 0.0;  // [rad] since, at most
  };
  struct Entered {
    Entering first, second;
  };
  std::vector<Entered> entered_;
};

}  // namespace tumble
