/// \file
/// \brief The numbers of metrics.csv and summary.json: energies, overlap, chatter, counts.
#pragma once

#include "tumble/dynamics/technique.hpp"
#include "tumble/record/chatter.hpp"
#include "tumble/record/overlap.hpp"

namespace tumble {

/// The state of a run after a step, in numbers that know no technique.
struct Metrics {
  double kinetic = 0.0;       ///< [J]
  double potential = 0.0;     ///< [J] against y = 0
  BookedEnergy booked;        ///< [J] by cause, since the start
  double energy_error = 0.0;  ///< [J] change of the total energy that was not booked
  /// [-] the same over Σ m g L of the movable bodies, L a body's shortest edge; without gravity g is
  /// 9.81 m/s²
  double energy_error_share = 0.0;
  Vec3 momentum_w = Vec3::Zero();          ///< [kg m/s] of all movable bodies
  Vec3 angular_momentum_w = Vec3::Zero();  ///< [kg m²/s] about the origin
  double deepest_overlap = 0.0;            ///< [m] largest penetration over all pairs; 0: none
  Chatter chatter;                         ///< over the last half second
  double fastest = 0.0;                    ///< [m/s] largest speed of a centre of mass
  int asleep = 0;                          ///< bodies that sleep
};

/// Measures a run from outside, from poses and momenta alone: as an observer of a Simulation, or by hand.
///
/// Overlap is the least translation over the 15 axes that separates two boxes, and the depth of the
/// lowest corner under the ground; the technique's own contacts are not used. Pairs of immovable bodies
/// do not count.
class MetricsMeter : public Observer {
 public:
  void on_begin(const World& world) override;
  void on_change(const World& world, double energy_added) override;
  void on_step(const World& world, const StepReport& report) override;

  /// The numbers of an observed run.
  /// \return after the last step; at the start if there was none
  [[nodiscard]] const Metrics& metrics() const { return metrics_; }

  /// Begins with the world at the start.
  /// \param world the bodies at time 0
  /// \return the numbers at the start
  Metrics begin(const World& world);

  /// Allows for bodies that were added, removed or changed from outside: their energy is not the technique's error.
  /// \param energy_added [J] how much the total energy changed by it
  void allow(double energy_added) { start_energy_ += energy_added; }

  /// Measures after a step.
  /// \param world   the bodies
  /// \param report  what the step did
  /// \return the numbers; of a world that is not finite the energies alone
  Metrics measure(const World& world, const StepReport& report);

 private:
  Metrics measure_now(const World& world);

  OverlapMeter overlap_;
  ChatterMeter chatter_;
  BookedEnergy booked_;
  double start_energy_ = 0.0;
  Metrics metrics_;
};

}  // namespace tumble
