/// \file
/// \brief Any technique, with noise in its fast impacts (thesis 2.4.2).
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/contact/moving_body.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/dynamics/wrapped_technique.hpp"
#include "tumble/previous_work/impact_noise.hpp"

#include <span>
#include <vector>

namespace tumble {

/// How much noise an impact gets, and which impacts.
struct ImpactNoiseOptions {
  double speed = tolerance::noisy_speed;  ///< [-] of approach, as a share of sqrt(g L); at least 0
  double normal = tolerance::noisy_normal;  ///< [rad] standard deviation of the turn, 0 to 1
  double restitution = tolerance::noisy_restitution;  ///< [-] half the range around e, 0 to 1
};

/// Checks options.
/// \throws std::invalid_argument naming the value that is out of range
void require_valid(const ImpactNoiseOptions& options);

/// Disturbs what a technique makes of fast impacts, after the step in which they happen.
///
/// All events of a pair in a step are one impact; of a technique that reports no events, all impulses of its contacts are. Its
/// impulse j is their sum, at their mean point. It is fast if the bodies approached there before the step by more than
/// `speed` times \f$\sqrt{gL}\f$, L their shortest edge. Its three random values turn j by an angle about a random axis across the
/// normal and shift restitution from e to e',
/// by a second impulse at the same point,
/// \f[ \delta = (R - 1)\, j + (e' - e)\, \frac{|n\cdot u|}{n^{\mathsf T} K n}\, n , \f]
/// with u the velocity before the step. So linear momentum is kept, and a technique without noise has its own bits.
///
/// **Never more energy than restitution allows.** After \f$\delta\f$ the total energy of both bodies is at most that before the step without
/// \f$\tfrac12(1 - e'^2)(n\cdot u)^2/(n^{\mathsf T}Kn)\f$, what a frictionless impact of restitution e' loses, or at most what
/// the technique left, if that is more; and the point does not approach faster than the technique left it. The impulse is halved until
/// both hold, and after some halvings left out. Its energy is booked as that of restitution.
///
/// The impact's values depend on its name alone, and change nothing before it. (2.4.2)
/// \see Barzel, Hughes, Wood, "Plausible motion simulation for computer graphics animation", 1996.
/// \verified{Noise in impacts keeps momentum and never adds energy beyond restitution}
class NoisyImpacts : public Cloned<WrappedTechnique, NoisyImpacts> {
 public:
  /// Wraps a technique.
  /// \throws std::invalid_argument for no technique, or an option out of range
  NoisyImpacts(std::unique_ptr<Technique> inner, ImpactNoise noise,
               const ImpactNoiseOptions& options = {});

  StepReport step(World& world, double dt) override;

  /// The fast impacts so far: their names, in the order in which they happened.
  [[nodiscard]] std::span<const ImpactName> impacts() const { return impacts_; }

 private:
  /// The impulses of a pair in a step, added up.
  struct Meeting {
    BodyId first{};                 // the body with the smaller id
    BodyId second{};                // the other one
    Vec3 impulse_w = Vec3::Zero();  // [N s] on the second body
    Vec3 normal_w = Vec3::Zero();   // [N s] sum of the normals, weighted
    Vec3 point_w = Vec3::Zero();    // [N s m] sum of the points, weighted
    double time = 0.0;              // [N s²] sum of the times, weighted
    double weight = 0.0;            // [N s] along the normals

    void add(const Vec3& point, const Vec3& normal, const Vec3& impulse, double at);
  };
  [[nodiscard]] MovingBody before_impact(const World& world, int index, double flown) const;
  void disturb(World& world, const Meeting& meeting, double start, BookedEnergy& energy);

  ImpactNoise noise_;
  ImpactNoiseOptions options_;
  std::vector<ImpactName> impacts_;
  bool has_events_ = false;        // the technique reports its impacts as events
  std::vector<BodyState> before_;  // by index, at the start of the step
};

}  // namespace tumble
