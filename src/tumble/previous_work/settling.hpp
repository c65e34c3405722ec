/// \file
/// \brief Potential energy minimised step by step, without velocities (thesis 2.7.1).
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/base/options.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/previous_work/near_points.hpp"
#include "tumble/previous_work/nearest_motion.hpp"

#include <vector>

namespace tumble {

/// Options of settling.
struct SettlingOptions {
  double reach = 0.1;  ///< [-] largest movement of a body in a step, over the shortest edge
  int budget = 2000;   ///< steps of the iteration of a quadratic program
};

template <class Visitor>
void describe(SettlingOptions& o, Visitor& v) {
  v.number("reach", o.reach, 0.01, 1.0, "-",
           "largest movement of a body in a step, over the shortest edge");
  v.whole("budget", o.budget, 1, 1000000, "steps of the iteration of a quadratic program");
}

/// Milenkovic's positions without velocities: in each step all bodies move to lower potential energy, as far as they may.
///
/// With displacements q (translations and rotations) a step finds
/// \f[ -m g \cdot q + \frac{1}{2\tau^2}\, q^{\mathsf T} M q \quad\text{least for}\quad J q + d \ge 0 , \f]
/// where d is the gap of each contact point. The second term is the trust region in which the linear constraints say enough: a free body falls
/// by \f$\tau^2 g\f$, which is `reach` of the shortest edge, and no corner moves farther than that. The multipliers of the points are forces. Where
/// nothing moves any more they carry the weight: a minimum is a static equilibrium. Where edges cross, corners of the
/// faces beside them are points too (add_face_points()).
///
/// **What it cannot do.** Momentum: velocities are set to 0, a thrown box falls straight down, nothing topples farther than it
/// falls, and the time of a run is a count of steps. There is no friction, so boxes slide off each other until faces lie flat.
/// \par Cost and determinism
/// A quadratic program in a step, up to five where bodies topple, by ProjectedDescent. No allocation once warm.
/// \see Milenkovic, "Position-based physics", SIGGRAPH 1996.
/// \algorithm{Potential energy minimised: section 2.7.1}
/// \deviation{A quadratic program with a quadratic trust region in place of linear programs.}
/// \verified{Settled boxes carry their weight with the forces of a minimum}
class Settling : public Cloned<Technique, Settling> {
 public:
  /// Makes the technique.
  /// \throws std::invalid_argument for a value out of range
  explicit Settling(const SettlingOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "settling"; }
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::span<const ContactRecord> contacts() const override { return records_; }
  [[nodiscard]] std::vector<std::string> ignores(const World& world) const override;

 private:
  SettlingOptions options_;
  NearPoints points_;
  double last_time_squared_ = 0.0;  // [s²] τ² of the step before, or 0

  // Of one step; kept so that a warm step asks for no memory.
  std::vector<MovingBody> still_, moving_;
  NearestMotion program_;
  std::vector<ContactRecord> records_;
};

}  // namespace tumble
