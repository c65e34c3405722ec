/// \file
/// \brief A search over all bodies that misses nothing, as a reference for the order of collisions
///        (thesis 5.1).
#pragma once

#include "tumble/basic_colliding/basic.hpp"

namespace tumble::chapters {

/// The basic technique with a conservative search, which never meets a cap.
///
/// The number of tests that a search between two bodies takes is capped, and a step in which that
/// happens ignores the collisions that are left. Here such a step is taken again in two halves, and
/// these in halves if need be.
class PatientSearch final : public Technique {
 public:
  /// Makes the technique.
  /// \param resolution  [s] how exactly collisions are searched for, above 0
  explicit PatientSearch(double resolution);

  [[nodiscard]] std::string_view name() const override { return "patient_search"; }
  /// Advances the world.
  /// \param world  all bodies; in and out
  /// \param dt     [s] above 0
  /// \return that of the last part; `events` and `restarts`, steps taken again, of all parts
  /// \throws std::runtime_error if a part shorter than the resolution still meets a cap
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::unique_ptr<Technique> clone() const override;

 private:
  double resolution_;
  Basic basic_;
};

}  // namespace tumble::chapters
