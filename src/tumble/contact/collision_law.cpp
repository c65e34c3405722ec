/// \file
/// \brief An impact at one point: restitution, friction and the guard of energy.
#include "tumble/contact/collision_law.hpp"

#include "tumble/base/error.hpp"
#include "tumble/contact/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

// The impact in the frame of the contact: component 0 along the normal, 1 and 2 across.
struct Local {
  Vec3 u;     // [m/s] relative velocity on arrival
  Mat3 k;     // [1/kg] inverse mass
  double mu;  // [-] friction

  // [J] change of kinetic energy by an impulse j: work of j at the mean of u and u + K j.
  [[nodiscard]] double energy(const Vec3& j) const { return j.dot(u + 0.5 * (k * j)); }
};

// An impulse in that frame.
struct Candidate {
  Vec3 j = Vec3::Zero();  // [N s]
  ImpactMode mode = ImpactMode::none;
};

// x = S⁺ r for a symmetric positive semidefinite 2×2 matrix: the shortest x if S cannot reach r.
// `scale` says what counts as 0 beside the rest of K.
Vec2 solve_2x2(const Mat2& s, const Vec2& r, double scale) {
  const double trace = s.trace();
  if (trace <= tolerance::rigid * scale) return Vec2::Zero();  // nothing gives way
  const double det = s(0, 0) * s(1, 1) - s(0, 1) * s(1, 0);
  if (det > tolerance::rigid * trace * trace)
    return Vec2(s(1, 1) * r[0] - s(0, 1) * r[1], s(0, 0) * r[1] - s(1, 0) * r[0]) / det;
  return (s * r) / (trace * trace);  // S = λ v v' with λ = trace: S⁺ = S / λ²
}

// Where friction points when it does not stick: against the slip u_t; if there is none, the way
// that sticking would have pushed.
Vec2 against_slip(const Vec2& u_t, double speed, const Vec2& stick) {
  const double slip = u_t.norm();
  return slip > tolerance::still * speed ? Vec2(-u_t / slip) : Vec2(stick.normalized());
}

// The impulse after which the normal velocity is w >= 0 (Newton's law).
Candidate newton(const Local& p, double w) {
  const double rise = w - p.u[0];  // what the normal velocity has to gain
  const Vec2 k_tn = p.k.block<2, 1>(1, 0);
  const Candidate frictionless{Vec3(rise / p.k(0, 0), 0.0, 0.0), ImpactMode::frictionless};
  if (p.mu == 0.0) return frictionless;

  // Stick: K j = (rise, -u_t). Eliminating j_n leaves the 2×2 system of the Schur complement.
  const Mat2 schur = p.k.block<2, 2>(1, 1) - k_tn * k_tn.transpose() / p.k(0, 0);
  const Vec2 target = -p.u.tail<2>() - k_tn * (rise / p.k(0, 0));
  const Vec2 j_t = solve_2x2(schur, target, p.k.trace());
  const double j_n = (rise - k_tn.dot(j_t)) / p.k(0, 0);
  if (j_t.norm() <= p.mu * j_n) return {Vec3(j_n, j_t[0], j_t[1]), ImpactMode::stick};

  // Slip: j = s d along the edge of the cone, with n'K d s = rise.
  const Vec2 t = against_slip(p.u.tail<2>(), p.u.norm(), j_t);
  const Vec3 d(1.0, p.mu * t[0], p.mu * t[1]);
  const double yield = p.k.row(0).dot(d);
  if (yield <= tolerance::jamming * p.k(0, 0)) return frictionless;
  return {rise / yield * d, ImpactMode::slip};
}

// The impulse of approach and the one of separation, e times as large along the normal (Poisson's
// law).
Candidate poisson(const Local& p, double e) {
  const Candidate approach = newton(p, 0.0);
  const Vec3 u = p.u + p.k * approach.j;
  const double j_n = e * approach.j[0];
  Candidate all = approach;
  all.j[0] += j_n;
  if (p.mu == 0.0 || approach.mode == ImpactMode::frictionless) return all;

  // The normal impulse is known now; friction sticks if it can.
  const Vec2 k_tn = p.k.block<2, 1>(1, 0);
  Vec2 j_t = solve_2x2(p.k.block<2, 2>(1, 1), -u.tail<2>() - k_tn * j_n, p.k.trace());
  ImpactMode mode = ImpactMode::stick;
  if (j_t.norm() > p.mu * j_n) {
    j_t = p.mu * j_n * against_slip(u.tail<2>(), p.u.norm(), j_t);
    mode = ImpactMode::slip;
  }
  if (p.k(0, 0) * j_n + k_tn.dot(j_t) < 0.0) return all;  // would approach again
  all.mode = mode;
  all.j.tail<2>() += j_t;
  return all;
}

}  // namespace

double largest_share(double start, double slope, double curvature) {
  // The positive root of E(θ), in the form that does not subtract nearly equal numbers.
  const double root = std::sqrt(std::max(0.0, slope * slope - 4.0 * curvature * start));
  if (!(slope > 0.0 || curvature > 0.0)) return 1.0;  // it does not rise
  const double share =
      slope > 0.0 ? -2.0 * start / (slope + root) : (root - slope) / (2.0 * curvature);
  return std::clamp(share, 0.0, 1.0);
}

void check(const PointImpact& impact) {
  require::unit(impact.normal_w, "normal_w");
  require::finite(impact.velocity_w, "velocity_w");
  require::finite(impact.inverse_mass_w, "inverse_mass_w");
  require::not_negative(impact.friction, "friction");
  require::within(impact.restitution, 0.0, 1.0, "restitution");
  require::finite(impact.approach_speed, "approach_speed");
}

PointImpulse solve_impact(const PointImpact& impact, RestitutionLaw law) {
  PointImpulse result{.restitution = impact.restitution};
  const Vec3& n = impact.normal_w;
  if (n.dot(impact.velocity_w) >= 0.0) return result;

  // Into the frame of the contact.
  const Tangents tangents = tangents_of(n);
  Mat3 axes_w;
  axes_w << n, tangents.first_w, tangents.second_w;
  const Mat3& k_w = impact.inverse_mass_w;
  const Local p{axes_w.transpose() * impact.velocity_w, axes_w.transpose() * k_w * axes_w,
                impact.friction};
  if (p.k(0, 0) <= tolerance::rigid * p.k.trace()) return result;

  // The law, with the restitution asked for.
  const double w = impact.restitution * std::max(0.0, -impact.approach_speed);
  const bool bounces = law == RestitutionLaw::newton ? w > 0.0 : impact.restitution > 0.0;
  Candidate asked = law == RestitutionLaw::newton ? newton(p, w) : poisson(p, impact.restitution);

  // The guard of energy: back towards no restitution, and from there towards no friction.
  const double allowed = tolerance::energy_rounding * std::abs(asked.j.dot(p.u));
  if (p.energy(asked.j) > allowed) {
    Vec3 safe = newton(p, 0.0).j;
    if (!bounces || p.energy(safe) > 0.0) safe = Vec3(-p.u[0] / p.k(0, 0), 0.0, 0.0);
    const Vec3 way = asked.j - safe;
    const double share =
        largest_share(p.energy(safe), way.dot(p.u + p.k * safe), 0.5 * way.dot(p.k * way));
    asked.j = safe + share * way;
    result.restitution *= bounces ? share : 1.0;
  }

  // The account, and back into the world.
  const Vec3 mean = p.u + 0.5 * (p.k * asked.j);
  result.mode = asked.mode;
  result.impulse_w = axes_w * asked.j;
  result.restitution_energy = asked.j[0] * mean[0];
  result.friction_energy = asked.j.tail<2>().dot(mean.tail<2>());
  return result;
}

PointImpulse collide_at_point(MovingBody& first, MovingBody& second, const Vec3& point_w,
                              const Vec3& normal_w, double friction, double restitution,
                              RestitutionLaw law) {
  PointImpact impact;
  impact.normal_w = normal_w;
  impact.velocity_w = relative_velocity(first, second, point_w);
  impact.inverse_mass_w = inverse_mass_at(first, second, point_w);
  impact.friction = friction;
  impact.restitution = restitution;
  impact.approach_speed = normal_w.dot(impact.velocity_w);
  check(impact);
  const PointImpulse result = solve_impact(impact, law);
  if (result.mode != ImpactMode::none) apply_impulse(first, second, point_w, result.impulse_w);
  return result;
}

}  // namespace tumble
