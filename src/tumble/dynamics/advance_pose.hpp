/// \file
/// \brief The one function through which every technique moves bodies (thesis 3.1).
#pragma once

#include "tumble/dynamics/body.hpp"

#include <span>
#include <string_view>

namespace tumble {

/// How a body is turned over a step while its angular momentum L is constant.
///
/// The angular velocity \f$\omega = R\,I_b^{-1}R^{\mathsf T}L\f$ changes as the body turns, so all
/// rules make an error of order dt^(p+1) in a step:
///
/// | rule        | order p | energy  | forth and back | exact for          | costs       |
/// |-------------|---------|---------|----------------|--------------------|-------------|
/// | `frozen`    | 1       | drifts  | O(dt²) off     | cubes              | 1 rotation  |
/// | `midpoint`  | 2       | drifts  | O(dt⁴) off     | cubes              | 2 rotations |
/// | `rk4`       | 4       | drifts  | O(dt⁶) off     | none               | 4 slopes    |
/// | `splitting` | 2       | bounded | exact          | cubes, square bars | 4 rotations |
///
/// "Exact" is to rounding, for any dt. Only where a rule is exact is it a flow, so that a step of
/// a and one of b make the step a + b; elsewhere the two differ by O(dt^(p+1)).
enum class RotationRule : std::uint8_t {
  frozen,    ///< constant ω, the one at the start
  midpoint,  ///< constant ω, the one after half a step with the first ω
  rk4,       ///< Runge and Kutta's classical rule on the quaternion, then normalised
  splitting  ///< exact rotations about the body's own axes, composed symmetrically
};

/// All rotation rules, in the order of the enumeration.
std::span<const RotationRule> rotation_rules();

/// The meaning of the option `rotation`, wherever a technique has it.
inline constexpr std::string_view kRotationMeaning = "integration rule of rotations";

/// The name that a user calls a rule by: "frozen", "midpoint", "rk4" or "splitting".
std::string_view name_of(RotationRule rule);

/// Moves a body for a time with both momenta constant.
///
/// \f[ x \leftarrow x + \Delta t\,P/m, \qquad q \leftarrow \text{rule}(q, L, \Delta t). \f]
/// Momenta are not touched, so P and L are conserved to the last bit. Nothing happens, to the last
/// bit, if dt is 0 or the body is immovable, and the orientation stays if L is 0.
///
/// The orders and exactness of the rules are those of RotationRule. All rules commute with a
/// mirror image of the scene and with scaling by powers of two (lengths by 4, times by 2 and
/// masses by any) bit for bit: every operation is odd, even, or a product.
///
/// **Splitting.** With the body's momentum \f$\Pi = R^{\mathsf T}L\f$ and moments ordered so that
/// \f$I_b\f$ is the middle one, twice the kinetic energy is
/// \f[ \frac{L^2}{I_b} + \Bigl(\frac1{I_a}-\frac1{I_b}\Bigr)\Pi_a^2
///                     + \Bigl(\frac1{I_c}-\frac1{I_b}\Bigr)\Pi_c^2. \f]
/// Each part alone moves the body by an exact rotation: about L, about axis a, about axis c. The
/// first commutes with the others; these are composed as a/2, c, a/2, which is symmetric in time,
/// of order 2 and keeps the energy within a bound of order dt² for ever. If two moments are equal
/// one of them is the middle one, at most one other part is left, and the step is exact.
/// \param dt     [s] may be negative: back in time
/// \throws std::invalid_argument if the angular momentum is not finite; dt must be finite
/// \see McLachlan, "Explicit Lie-Poisson integration and the Euler equations", Phys. Rev. Lett.
///      71, 1993; Touma, Wisdom, "Lie-Poisson integrators for rigid body dynamics in the solar
///      system", Astron. J. 107, 1994; Fassò, "Comparison of splitting algorithms for the rigid
///      body", J. Comput. Phys. 189, 2003.
/// \verified{An asymmetric top follows its elliptic functions}
void advance_pose(const BodyProperties& body, BodyState& state, double dt, RotationRule rule);

/// A bound of the angular speed along the arc \f$t \mapsto\f$ advance_pose(t), for 0 <= t <= dt.
///
/// With inverse moments \f$u_1 \ge u_2 \ge u_3\f$, L and the energy T are constant, and the largest
/// angular speed that they allow is \f$\Omega^2 = (u_1 + u_3)\,2T - u_1 u_3 L^2\f$ (all momentum
/// on axes 1 and 3). A rule is not the true motion, so
/// - `frozen`: ω at the start, which does not change;
/// - `splitting`: \f$\Omega\,(1 + \Delta t\,\sigma)\f$, where \f$\sigma = (u_1-u_2)|\Pi_1|_{max}
///   + (u_2-u_3)|\Pi_3|_{max}\f$ is how fast L can swing about in the body: the rule turns about
///   axes that were true a moment ago. Random boxes need less than half of that allowance;
/// - `midpoint`, `rk4`: \f$B\,(1 + \Delta t\,D)\f$ with \f$B = u_1|L|\f$ and \f$D = (u_1 - u_3)|L|\f$. Their
///   energy is not bounded, and a long bar that tumbles may come to spin about its length.
///
/// Holds while a body turns by no more than 3 rad and swings by no more than 4 (dt times Ω and σ, or
/// B and D); a longer step than that is no simulation.
/// \param state  its state at the start of the arc
/// \param dt     [s] how long the arc is, at least 0
/// \return [rad/s] 0 for an immovable body
double angular_speed_bound(const BodyProperties& body, const BodyState& state, double dt,
                           RotationRule rule);

}  // namespace tumble
