/// \file
/// \brief The numbers of metrics.csv and summary.json: energies, overlap, chatter, counts.
#pragma once

#include "tumble/dynamics/technique.hpp"
#include "tumble/record/chatter.hpp"
#include "tumble/record/overlap.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace tumble {

/// Measurements of the world after a step. They do not depend on the technique.
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

/// Measures a run from poses, momenta and booked energy alone, as an observer of a Simulation or by begin() and measure().
///
/// Overlap is the least translation that separates two boxes, over the 15 axes, or the depth of the lowest corner
/// under the ground. The technique's own contacts are not used, and pairs of immovable bodies are left out.
class MetricsMeter : public Observer {
 public:
  void on_begin(const World& world) override;
  void on_change(const World& world, double energy_added) override;
  void on_step(const World& world, const StepReport& report) override;

  /// Metrics of the observed simulation after the last step; at the start if there was none.
  [[nodiscard]] const Metrics& metrics() const { return metrics_; }

  /// Begins a measurement; returns the metrics at the start.
  Metrics begin(const World& world);

  /// Leaves a change of energy out of the technique's error: bodies were added, removed or changed between steps.
  /// \param energy_added [J] by how much the total energy changed
  void allow(double energy_added) {
    if (start_energy_) *start_energy_ += energy_added;
  }

  /// Measures after a step; for a world that is not finite the energies alone.
  Metrics measure(const World& world, const StepReport& report);

 private:
  Metrics measure_now(const World& world);

  OverlapMeter overlap_;
  ChatterMeter chatter_;
  BookedEnergy booked_;
  std::optional<double> start_energy_;  // [J] once begun
  Metrics metrics_;
};

/// One number of a step, as files have it.
struct MetricsColumn {
  std::string_view name;  ///< with its unit at the end, where it has one
  bool whole = false;     ///< a count
  /// Its value.
  double (*value)(const Metrics& metrics, const StepReport& report) = nullptr;
};

/// All numbers of a step, in the order of the file.
std::span<const MetricsColumn> metrics_columns();

}  // namespace tumble
