/// \file
/// \brief A check of a run by any technique: nothing hangs in the air.
#pragma once

#include "tumble/geometry/bounding_tree.hpp"
#include "tumble/record/run_checks.hpp"

#include <vector>

namespace tumble {

/// Under gravity bodies do not stay in place unless they reach something that is fixed or moves, by way of others that are
/// near: within `tolerance::deep_overlap` of their shortest edge, in any direction, or by a joint.
///
/// A body stays in place if it has moved by less than `tolerance::hang_move` of what it would have fallen from rest meanwhile:
/// at least that tenth of an edge, and for three steps, without a collision. Free flight never does so, nor at the top of a
/// throw. Bounds are compared, which makes a report certain.
/// \par Cost
/// A comparison for each body. Bodies that stay in place are looked at together, the next time after twice as long.
class HangCheck : public RunCheck {
 public:
  void on_begin(const World& world) override;
  void on_change(const World& world, double energy_added) override;
  void on_event(const Event& event) override;
  void on_step(const World& world, const StepReport& report) override;

 private:
  // Where a body has been since when.
  struct Stay {
    Vec3 place_w = Vec3::Zero();
    double since = 0.0;     // [s]
    double look_at = 0.0;   // [s] not before
    bool in_place = false;  // for long enough
  };
  void look(const World& world);
  void find_held(const World& world);

  double time_ = 0.0;        // [s] before the step
  std::vector<Stay> stays_;  // by index
  std::vector<BodyId> hit_;  // in collisions of this step
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> pairs_;  // that are near each other
  std::vector<char> held_;        // by index: not 0 if it may stay
  BoundingTree near_;
};

}  // namespace tumble
