/// \file
/// \brief The impulses of one contact patch.
#include "tumble/contact_patches/patch_solver.hpp"

#include "tumble/base/tolerances.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/contact_patches/patch_pressure.hpp"
#include "tumble/contact_patches/point_friction.hpp"
#include "tumble/contact_patches/tolerances.hpp"
#include "tumble/math/minimum_in_ball.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

// A patch while it is solved.
struct PatchUpdate {
  Six motion{};                 // relative motion of its bodies with the impulses so far
  Six change{};                 // impulse added so far
  double largest_change = 0.0;  // [m/s] of a velocity
};

// If the patch sticks, one product gives the impulse. Returns whether friction and pressure allow it.
bool try_sticking(ContactPatch& patch, PatchUpdate& update) {
  // [S6.3.1:stick]
  Six wrong{};
  for (std::size_t k = 0; k < 6; ++k) wrong[k] = patch.target_motion[k] - update.motion[k];
  Six impulse = impulse_of(patch);
  for (std::size_t k = 0; k < 6; ++k) {
    double sum = 0.0;
    for (std::size_t j = 0; j < 6; ++j) sum += patch.mass[k][j] * wrong[j];
    update.change[k] = sum;
    impulse[k] += sum;
  }
  // [S6.3.1:stick]
  const double normal = impulse[six::normal];
  if (!(normal > 0.0)) return false;
  std::array<double, ContactPatch::kMostPoints> p;
  if (!distribute_evenly(impulse, patch, p)) return false;
  PatchPressure at{.normal = normal,
                   .along = -impulse[six::roll_across] / normal,
                   .across = impulse[six::roll_along] / normal};
  const auto count = static_cast<std::size_t>(patch.count);
  const double limit = patch.friction * normal;
  double friction =
      impulse[six::along] * impulse[six::along] + impulse[six::across] * impulse[six::across];
  const double moment =
      impulse[six::twist] - moment_of(at, impulse[six::along], impulse[six::across]);
  if (moment != 0.0) {
    for (std::size_t i = 0; i < count; ++i) {
      const double a = patch.points[i].along - at.along;
      const double b = patch.points[i].across - at.across;
      at.lever += p[i] * std::sqrt(a * a + b * b);
    }
    if (!(at.lever > 0.0)) return false;
    const double turned = moment * normal / at.lever;
    friction += turned * turned;
  }
  if (friction > limit * limit) return false;
  for (std::size_t i = 0; i < count; ++i) patch.points[i].impulse = p[i];
  patch.along_impulse = impulse[six::along];
  patch.across_impulse = impulse[six::across];
  patch.twist_impulse = impulse[six::twist];
  for (const ContactPatchPoint& point :
       patch.used())  // they span an area: 0 only if nothing changes
    update.largest_change =
        std::max(update.largest_change, velocity_at(point.along, point.across, wrong).norm());
  return true;
}

// Friction at the centre of pressure: the impulse that stops the patch there, or else the largest one within the bound,
// against the motion. With the radius r = lever / N the bound is |(F, T / r)| <= mu N, its motion (u, r omega).
void solve_friction(ContactPatch& patch, PatchUpdate& update) {
  Six& motion = update.motion;
  const SixBySix& K = patch.inverse_mass;
  const PatchPressure at = pressure_of(patch);
  const bool nothing = at.normal == 0.0 && patch.along_impulse == 0.0 &&
                       patch.across_impulse == 0.0 && patch.twist_impulse == 0.0;
  if (nothing) return;
  // All pressure at one point, but for rounding, has no lever.
  const bool twists = at.lever > tolerance::rounding * patch.size * at.normal;
  const double radius = twists ? at.lever / at.normal : 0.0;
  // Motions of unit forces at the centre of pressure; of a unit moment it is a column of K.
  Six a, b;
  for (std::size_t k = 0; k < 6; ++k) {
    a[k] = K[0][k] - at.across * K[5][k];
    b[k] = K[1][k] + at.along * K[5][k];
  }
  Mat3 A;
  A << a[0] - at.across * a[5], a[1] + at.along * a[5], radius * a[5],  //
      0.0, b[1] + at.along * b[5], radius * b[5],                       //
      0.0, 0.0, radius * radius * K[5][5];
  A(1, 0) = A(0, 1);
  A(2, 0) = A(0, 2);
  A(2, 1) = A(1, 2);
  if (!twists) A(2, 2) = A(0, 0);  // nothing to twist with: the third motion is 0 as well
  const double moment =
      patch.twist_impulse - moment_of(at, patch.along_impulse, patch.across_impulse);
  const Vec3 had(patch.along_impulse, patch.across_impulse, twists ? moment / radius : 0.0);
  // A moment without a lever, as pressure is at one point now, is removed first.
  const double lost = twists ? 0.0 : -moment;
  for (std::size_t k = 0; k < 6; ++k) motion[k] += K[5][k] * lost;
  const Vec3 now(motion[0] - at.across * motion[5], motion[1] + at.along * motion[5],
                 radius * motion[5]);
  const Vec3 more = minimum_in_ball(A, now - A * had, patch.friction * at.normal) - had;
  const double turn = radius * more.z();
  for (std::size_t k = 0; k < 6; ++k)
    motion[k] += a[k] * more.x() + b[k] * more.y() + K[5][k] * turn;
  const double twist = lost + turn + moment_of(at, more.x(), more.y());
  update.change[six::along] += more.x();
  update.change[six::across] += more.y();
  update.change[six::twist] += twist;
  patch.along_impulse += more.x();
  patch.across_impulse += more.y();
  patch.twist_impulse += twist;
  // The length of a vector, not a component, so that it does not depend on the choice of tangents.
  update.largest_change = std::max(update.largest_change, (A * more).norm());
}

// Normal velocity of a point.
double speed_at(const ContactPatchPoint& p, const Six& motion) {
  return motion[2] + p.across * motion[3] - p.along * motion[4];
}

// Motion of the patch for a unit normal impulse at a point.
Six response_to(const ContactPatchPoint& p, const SixBySix& K) {
  Six response;
  for (std::size_t k = 0; k < 6; ++k)
    response[k] = K[2][k] + p.across * K[3][k] - p.along * K[4][k];
  return response;
}

// Brings the normal velocity of one point to its target, with an accumulated impulse of at least 0.
void solve_point(const ContactPatchPoint& p, double target, const SixBySix& K, double& impulse,
                 PatchUpdate& update) {
  const double speed = speed_at(p, update.motion);
  if (impulse == 0.0 && speed >= target) return;  // open, and allowed to stay so
  const Six response = response_to(p, K);
  const double inverse_mass = speed_at(p, response);
  const double wanted = std::max(0.0, impulse - (speed - target) / inverse_mass);
  const double more = wanted - impulse;
  if (more == 0.0) return;
  for (std::size_t k = 0; k < 6; ++k) update.motion[k] += response[k] * more;
  update.change[six::normal] += more;
  update.change[six::roll_along] += more * p.across;
  update.change[six::roll_across] -= more * p.along;
  impulse = wanted;
  update.largest_change = std::max(update.largest_change, std::abs(more) * inverse_mass);
}

// Brings the normal velocities of all points to their targets at once, by the most even pressures that do so, since
// friction about the normal depends on them. Returns false, with nothing changed, if a point would pull.
bool solve_pressure_at_once(ContactPatch& patch, PatchUpdate& update) {
  Six& motion = update.motion;
  const SixBySix& K = patch.inverse_mass;
  // [K22 K23 K24; . K33 K34; . . K44] d = target - motion, by factors L D L'.
  const double l32 = K[3][2] / K[2][2];
  const double l42 = K[4][2] / K[2][2];
  const double d3 = K[3][3] - l32 * K[3][2];
  const double l43 = (K[4][3] - l42 * K[3][2]) / d3;
  const double d4 = K[4][4] - l42 * K[4][2] - l43 * l43 * d3;
  const double w2 = patch.target_motion[2] - motion[2];
  const double w3 = patch.target_motion[3] - motion[3];
  const double w4 = patch.target_motion[4] - motion[4];
  const double y3 = w3 - l32 * w2;
  const double roll_across = (w4 - l42 * w2 - l43 * y3) / d4;
  const double roll_along = y3 / d3 - l43 * roll_across;
  const double normal = w2 / K[2][2] - l32 * roll_along - l42 * roll_across;
  Six impulse = impulse_of(patch);
  impulse[six::normal] += normal;
  impulse[six::roll_along] += roll_along;
  impulse[six::roll_across] += roll_across;
  std::array<double, ContactPatch::kMostPoints> pressure;
  if (!(impulse[six::normal] > 0.0) || !distribute_evenly(impulse, patch, pressure)) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(patch.count); ++i) {
    const ContactPatchPoint& p = patch.points[i];
    update.largest_change =
        std::max(update.largest_change, std::abs(w2 + p.across * w3 - p.along * w4));
    patch.points[i].impulse = pressure[i];
  }
  for (std::size_t k = 0; k < 6; ++k)
    motion[k] += K[2][k] * normal + K[3][k] * roll_along + K[4][k] * roll_across;
  update.change[six::normal] += normal;
  update.change[six::roll_along] += roll_along;
  update.change[six::roll_across] += roll_across;
  return true;
}

// The same of the two points of an edge. One after the other, the first would take what is left of the second, and friction
// would turn a body that is its own mirror image.
bool solve_pair_at_once(ContactPatch& patch, PatchUpdate& update) {
  ContactPatchPoint& p = patch.points[0];
  ContactPatchPoint& q = patch.points[1];
  const Six of_p = response_to(p, patch.inverse_mass), of_q = response_to(q, patch.inverse_mass);
  const double pp = speed_at(p, of_p), pq = speed_at(p, of_q), qq = speed_at(q, of_q);
  const double determinant = pp * qq - pq * pq;
  if (!(determinant > tolerance::rounding * pp * qq)) return false;
  const double wrong_p = p.target - speed_at(p, update.motion);
  const double wrong_q = q.target - speed_at(q, update.motion);
  const double more_p = (qq * wrong_p - pq * wrong_q) / determinant;
  const double more_q = (pp * wrong_q - pq * wrong_p) / determinant;
  if (!(p.impulse + more_p >= 0.0 && q.impulse + more_q >= 0.0)) return false;
  p.impulse += more_p;
  q.impulse += more_q;
  for (std::size_t k = 0; k < 6; ++k) update.motion[k] += of_p[k] * more_p + of_q[k] * more_q;
  update.change[six::normal] += more_p + more_q;
  update.change[six::roll_along] += more_p * p.across + more_q * q.across;
  update.change[six::roll_across] -= more_p * p.along + more_q * q.along;
  update.largest_change = std::max({update.largest_change, std::abs(wrong_p), std::abs(wrong_q)});
  return true;
}

// Pressure, with friction held: of all points at once, or of one after the other.
void solve_pressure(ContactPatch& patch, PatchUpdate& update) {
  if (patch.targets_planar && solve_pressure_at_once(patch, update)) return;
  if (patch.count == 2 && solve_pair_at_once(patch, update)) return;
  for (ContactPatchPoint& p : patch.used()) {
    solve_point(p, p.target, patch.inverse_mass, p.impulse, update);
  }
}

// Whether all normal velocities meet their targets and no point that pushes slides: then any impulses within Coulomb's
// bound are a solution. The part of the bound is checked that holds for every distribution of friction over the points.
bool is_solved(const ContactPatch& patch, const Six& motion, double residual) {
  const double creep = tolerance::patch_creep * residual;
  double normal = 0.0, lever = 0.0;
  for (const ContactPatchPoint& p : patch.used()) {
    const double wrong = speed_at(p, motion) - p.target;
    if (!(wrong >= -residual)) return false;
    if (!(p.impulse > 0.0)) continue;
    const double along = motion[0] - p.across * motion[5];
    const double across = motion[1] + p.along * motion[5];
    if (!(wrong <= residual)) return false;
    if (patch.friction > 0.0 && !(along * along + across * across <= creep * creep)) return false;
    normal += p.impulse;
    lever += p.impulse * std::sqrt(p.along * p.along + p.across * p.across);
  }
  const double most = (1.0 + tolerance::friction_limit) * patch.friction;
  const double bound = most * normal;
  return patch.along_impulse * patch.along_impulse + patch.across_impulse * patch.across_impulse <=
             bound * bound &&
         std::abs(patch.twist_impulse) <= most * lever;
}

}  // namespace

double solve_patch(ContactPatch& patch, MovingBody& first, MovingBody& second, int iterations,
                   double residual) {
  PatchUpdate update;
  update.motion = motion_of(patch, first, second);
  const auto solved = [&] { return residual > 0.0 && is_solved(patch, update.motion, residual); };
  // A patch all of whose points touch is first brought to rest to the last digit.
  const bool touches = patch.targets_planar && patch.target_motion == Six{};
  if (!touches && solved()) return 0.0;
  double correction = 0.0;
  // [S6.3.1:patch]
  if (patch.targets_planar && try_sticking(patch, update)) {
    correction = update.largest_change;
  } else {
    if (touches && solved()) return 0.0;
    if (iterations == 0) return error_at_points(patch, update.motion);
    update.change = {};
    for (int k = 0; k < iterations; ++k) {
      update.largest_change = 0.0;
      solve_friction(patch, update);
      solve_pressure(patch, update);
      correction = std::max(correction, update.largest_change);
      if (update.largest_change < tolerance::patch_settled * correction) break;
    }
  }
  if (correction > 0.0) apply(update.change, patch, first, second);
  // [S6.3.1:patch]
  return correction;
}

void require_separation(double slowest, ContactPatch& patch) {
  for (ContactPatchPoint& p : patch.used()) {
    if (!(p.impulse > 0.0)) continue;
    p.target = p.approach < -slowest ? -patch.restitution * p.approach : 0.0;
  }
  patch.targets_planar = false;
}

double correct_overlap(const ContactPatch& patch, double share, OverlapCorrection& correction,
                       MovingBody& first, MovingBody& second) {
  PatchUpdate update;
  update.motion = motion_of(patch, first, second);
  for (std::size_t i = 0; i < static_cast<std::size_t>(patch.count); ++i) {
    const ContactPatchPoint& p = patch.points[i];
    const double overlap = -p.gap;  // below 0 it may sink by as much
    solve_point(p, overlap > 0.0 ? share * overlap : overlap, correction.inverse_mass,
                correction.pushes[i], update);
  }
  if (update.largest_change > 0.0) apply(update.change, patch, first, second);
  return update.largest_change;
}

}  // namespace tumble
