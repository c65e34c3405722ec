/// \file
/// \brief Springs and dampers where bodies overlap (thesis 2.5.1).
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/base/options.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/dynamics/advance_pose.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/geometry/bounding_tree.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace tumble {

/// How a step follows springs and dampers. Forces are those where the step begins.
enum class PenaltyScheme : std::uint8_t {
  semi_implicit,  ///< velocities first; bodies move with the new ones
  explicit_euler  ///< bodies move with the old velocities
};

/// The mass m at the spring k and the damper c, \f$m\ddot x = -k x - c\dot x\f$ for \f$x < 0\f$.
struct PenaltyLaw {
  double frequency = 0.0;  ///< [rad/s] \f$\omega = \sqrt{k/m}\f$
  double damping = 0.0;    ///< [-] \f$\zeta = c/(2\sqrt{km})\f$; 1 is critical
};

/// The longest step with which a swing does not grow.
///
/// With \f$x' = x + h v'\f$ a swing decays while \f$h^2\omega^2 + 4\zeta h\omega < 4\f$: without damping below
/// \f$2/\omega\f$. With \f$x' = x + h v\f$ it decays while \f$h\omega < 2\zeta\f$ and
/// \f$4\zeta h\omega < 4 + h^2\omega^2\f$: without damping never.
/// \param law  frequency above 0, damping at least 0
/// \return [s] 0: no step
/// \verified{Swings on springs decay below the stable step and grow above it}
double stable_step(PenaltyScheme scheme, const PenaltyLaw& law);

/// Restitution of a bounce without gravity.
///
/// If the damper may pull, the mass is released where it touched, after half a swing:
/// \f$e = \exp(-\pi\zeta/\sqrt{1-\zeta^2})\f$, and 0 from critical damping on. If contacts only push, it is released
/// as soon as the damper would pull more than the spring pushes, and
/// \f$e = \exp(-2\zeta\arccos\zeta/\sqrt{1-\zeta^2})\f$: \f$e^{-2}\f$ at critical damping.
/// \param damping  [-] ζ, at least 0
/// \return [-] 0 to 1
/// \verified{A ball on a spring and a damper bounces by the closed forms of both laws}
double penalty_restitution(double damping, bool pull);

/// The damping that gives a restitution, at most 1.
/// \param pull         whether contacts may pull
/// \return [-] the inverse of penalty_restitution(); 1 for restitutions below those of critical damping
double penalty_damping_for(double restitution, bool pull);

/// Options of penalty forces.
struct PenaltyOptions {
  double stiffness =
      0.0;  ///< [N/m] of the springs under a box on four corners; 0: from mass, size and step
  double damping = -1.0;  ///< [-] ζ; below 0: the one that gives the bodies' restitution
  int substeps = 8;       ///< of a step, each with contacts of its own
  PenaltyScheme scheme = PenaltyScheme::semi_implicit;  ///< see there
  bool pull = false;                                    ///< whether dampers may pull
  bool unstable = false;  ///< whether a step that is too long is simulated
  RotationRule rotation = RotationRule::splitting;  ///< how bodies turn
};

template <class Visitor>
void describe(PenaltyOptions& o, Visitor& v) {
  v.number("stiffness", o.stiffness, 0.0, 1e20, "N/m",
           "springs under a box on four corners; 0: from mass, size and step");
  v.number("damping", o.damping, -1.0, 1e3, "-",
           "fraction of critical damping; -1: from the bodies' restitution");
  v.whole("substeps", o.substeps, 1, 100000, "substeps of a step");
  v.word("scheme", o.scheme,
         {{"semi_implicit", PenaltyScheme::semi_implicit},
          {"explicit", PenaltyScheme::explicit_euler}},
         "bodies move with the new velocities, or with the old ones");
  v.flag("pull", o.pull, "dampers may also pull separating bodies, as in the textbook law");
  v.word("unstable", o.unstable, {{"refused", false}, {"simulated", true}},
         "a step that is too long for the springs of one box");
  v.word("rotation", o.rotation, words_of(rotation_rules()), kRotationMeaning);
}

/// Penalty forces: nothing is solved, each contact point pushes by the overlap and approach of its bodies.
///
/// A point with the depth d, at which the bodies approach at u, pushes with
/// \f[ f = \max(0,\; k d + c u), \f]
/// and against its slip s with \f$\min(\mu f,\; c_t |s|)\f$: Coulomb's friction with its jump at rest smoothed. A quarter
/// of `stiffness` is at each point, so that a box on four corners sinks in by \f$m g/k\f$.
///
/// **Defaults.** A point gets the spring on which the lighter of its bodies sinks in by
/// `tolerance::penalty_sag` of the shortest edge, or the stiffest one that the step can follow if that is softer; and the
/// damper that gives the bodies' restitution, at least \f$e^{-2}\f$. The stiffest one is found as if each body were
/// divided among its contacts, and these among their points. So no part of a body is used
/// twice, and whatever lies on what, no swing at rest grows: with stiffness K, damping C and mass M of all bodies the
/// condition is \f$4M - h^2 K - 2hC > 0\f$. Points that open, close or slide are not covered.
///
/// **A stiffness of one's own** is refused if one box on four corners is already unstable with it, and the message names the
/// step that is not too long. More boxes may need a shorter one.
///
/// **What it cannot do.** What should not bounce keeps a seventh of its speed, as a run notes (ignores()). Overlap causes the push: depth grows with the load, so ten boxes sink in ten times as far
/// as one, and a load of a hundred times the mass presses the lower box flat. Friction creeps on slopes. A body that is faster than
/// its own thickness in a substep, or has more energy than the spring can take up before it is half
/// through, comes out on the other side.
/// \par Cost and determinism
/// A test of each near pair in each substep, and no more. No allocation once warm; no order of contacts matters
/// but to rounding.
/// \algorithm{Penalty forces: section 2.5.1}
/// \deviation{Friction is smoothed and has no memory. A contact only pushes, unless pull=on.}
/// \verified{A cube on springs sinks by m g / k}
class Penalty : public Cloned<Technique, Penalty> {
 public:
  /// Makes the technique.
  /// \throws std::invalid_argument for a value out of range
  explicit Penalty(const PenaltyOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "penalty"; }
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::span<const ContactRecord> contacts() const override { return records_; }
  [[nodiscard]] std::vector<std::string> ignores(const World& world) const override;

 private:
  // Spring and damper of a point.
  struct Spring {
    double stiffness = 0.0;  // [N/m]
    double damping = 0.0;    // [N s/m]
  };

  [[nodiscard]] double damping_of(double restitution) const;
  void require_stable(const World& world, double h) const;
  void substep(World& world, double h, StepReport& report);
  void find_contacts(const World& world, StepReport& report);
  void split_bodies();
  void push(const World& world, double h);
  [[nodiscard]] Spring spring_at(const World& world, const Contact& contact, int point, double zeta,
                                 double h) const;
  void record(double h, StepReport& report);

  PenaltyOptions options_;

  // Of one substep; kept so that a warm step asks for no memory.
  BoundingTree near_;
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> pairs_;
  ContactList contacts_;
  std::vector<MovingBody> start_, moving_, split_;
  std::vector<BodyState> old_;
  std::vector<ContactRecord> records_;
};

}  // namespace tumble
