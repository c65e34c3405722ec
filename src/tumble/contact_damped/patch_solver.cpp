/// \file
/// \brief Impulses of one contact area.
#include "tumble/contact_damped/patch_solver.hpp"

#include "tumble/contact/tolerances.hpp"
#include "tumble/contact_damped/bounded_friction.hpp"
#include "tumble/contact_damped/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

// How many times faster than other velocities may be wrong a point that pushes may slide, and still rests. Where
// points creep IslandSolver comes to the end of it over many steps, and friction under the area's bound, which
// is another one than that of each point, would set it back in each.
constexpr double kCreep = 10.0;

// Where the pressure of an area acts: its sum, its centre, and the lever of friction about it.
struct Pressure {
  double normal = 0.0;  // [N s]
  double along = 0.0;   // [m] centre
  double across = 0.0;  // [m]
  double lever = 0.0;   // [N m s] sum of p |s - c|
};

Pressure pressure_of(const ContactPatch& block) {
  Pressure total;
  for (std::size_t i = 0; i < static_cast<std::size_t>(block.count); ++i) {
    const ContactPatchPoint& p = block.points[i];
    total.normal += p.impulse;
    total.along += p.impulse * p.along;
    total.across += p.impulse * p.across;
  }
  if (!(total.normal > 0.0)) return Pressure{};
  total.along /= total.normal;
  total.across /= total.normal;
  for (std::size_t i = 0; i < static_cast<std::size_t>(block.count); ++i) {
    const ContactPatchPoint& p = block.points[i];
    const double a = p.along - total.along;
    const double b = p.across - total.across;
    total.lever += p.impulse * std::sqrt(a * a + b * b);
  }
  return total;
}

// Moment about the normal of friction that acts at the centre of pressure.
double moment_of(const Pressure& at, double along, double across) {
  return at.along * across - at.across * along;
}

// The area sticks: one product gives the impulse. Returns whether it is allowed.
bool try_sticking(ContactPatch& block, const Six& motion, Six& change, double& corrected) {
  Six wrong{};
  for (std::size_t k = 0; k < 6; ++k) wrong[k] = block.goal[k] - motion[k];
  const Six had = impulse_of(block);
  Six impulse = had;
  for (std::size_t k = 0; k < 6; ++k) {
    double sum = 0.0;
    for (std::size_t j = 0; j < 6; ++j) sum += block.mass[k][j] * wrong[j];
    change[k] = sum;
    impulse[k] += sum;
  }
  const double normal = impulse[2];
  if (!(normal > 0.0)) return false;
  std::array<double, ContactPatch::kMostPoints> p;
  if (!spread_evenly(impulse, block, p)) return false;
  Pressure at;
  at.normal = normal;
  at.along = -impulse[4] / normal;
  at.across = impulse[3] / normal;
  const auto count = static_cast<std::size_t>(block.count);
  const double limit = block.friction * normal;
  double friction = impulse[0] * impulse[0] + impulse[1] * impulse[1];
  const double moment = impulse[5] - moment_of(at, impulse[0], impulse[1]);
  if (moment != 0.0) {
    for (std::size_t i = 0; i < count; ++i) {
      const double a = block.points[i].along - at.along;
      const double b = block.points[i].across - at.across;
      at.lever += p[i] * std::sqrt(a * a + b * b);
    }
    if (!(at.lever > 0.0)) return false;
    const double turned = moment * normal / at.lever;
    friction += turned * turned;
  }
  if (friction > limit * limit) return false;
  for (std::size_t i = 0; i < count; ++i) block.points[i].impulse = p[i];
  block.along_impulse = impulse[0];
  block.across_impulse = impulse[1];
  block.twist_impulse = impulse[5];
  corrected = std::sqrt(wrong[0] * wrong[0] + wrong[1] * wrong[1] + wrong[2] * wrong[2]);
  return true;
}

// Friction at the centre of pressure: what stops the area there, or else what the bound allows, straight
// against the motion. With the radius r = lever / N the bound is |(F, T / r)| <= mu N, and the motion
// that goes with it (u, r omega).
void rub(ContactPatch& block, Six& motion, Six& change, double& corrected) {
  const SixBySix& K = block.inverse_mass;
  const Pressure at = pressure_of(block);
  const bool nothing = at.normal == 0.0 && block.along_impulse == 0.0 &&
                       block.across_impulse == 0.0 && block.twist_impulse == 0.0;
  if (nothing) return;  // friction there is none
  const double radius = at.normal > 0.0 ? at.lever / at.normal : 0.0;
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
  if (!(radius > 0.0)) A(2, 2) = A(0, 0);  // nothing to twist with: the third motion is 0 as well
  const double moment =
      block.twist_impulse - moment_of(at, block.along_impulse, block.across_impulse);
  const Vec3 had(block.along_impulse, block.across_impulse, radius > 0.0 ? moment / radius : 0.0);
  // A moment that has lost its lever goes first.
  const double lost = radius > 0.0 ? 0.0 : -moment;
  for (std::size_t k = 0; k < 6; ++k) motion[k] += K[5][k] * lost;
  const Vec3 now(motion[0] - at.across * motion[5], motion[1] + at.along * motion[5],
                 radius * motion[5]);
  const Vec3 more = bounded_friction(A, now - A * had, block.friction * at.normal) - had;
  const double turn = radius * more.z();
  for (std::size_t k = 0; k < 6; ++k)
    motion[k] += a[k] * more.x() + b[k] * more.y() + K[5][k] * turn;
  const double twist = lost + turn + moment_of(at, more.x(), more.y());
  change[0] += more.x();
  change[1] += more.y();
  change[5] += twist;
  block.along_impulse += more.x();
  block.across_impulse += more.y();
  block.twist_impulse += twist;
  // A length, no component, so that the directions of the tangents have no say.
  corrected = std::max(corrected, (A * more).norm());
}

// Normal velocity of a point.
double speed_at(const ContactPatchPoint& p, const Six& motion) {
  return motion[2] + p.across * motion[3] - p.along * motion[4];
}

// Motion of a unit impulse at a point along the normal.
Six yields_at(const ContactPatchPoint& p, const SixBySix& K) {
  Six yields;
  for (std::size_t k = 0; k < 6; ++k) yields[k] = K[2][k] + p.across * K[3][k] - p.along * K[4][k];
  return yields;
}

// Brings one point's normal velocity to a value, with an impulse that is at least 0 in all.
void press_point(const ContactPatchPoint& p, double target, const SixBySix& K, double& impulse,
                 Six& motion, Six& change, double& corrected) {
  const double speed = speed_at(p, motion);
  if (impulse == 0.0 && speed >= target) return;  // apart, and may stay so
  const Six yields = yields_at(p, K);
  const double yield = speed_at(p, yields);
  const double wanted = std::max(0.0, impulse - (speed - target) / yield);
  const double more = wanted - impulse;
  if (more == 0.0) return;
  for (std::size_t k = 0; k < 6; ++k) motion[k] += yields[k] * more;
  change[2] += more;
  change[3] += more * p.across;
  change[4] -= more * p.along;
  impulse = wanted;
  corrected = std::max(corrected, std::abs(more) * yield);
}

// All points touch and none pulls: as for the whole area, but of normal velocities alone. Of the pressures
// that do it the most even ones are taken; on them friction about the normal depends.
bool press_evenly(ContactPatch& block, Six& motion, Six& change, double& corrected) {
  const SixBySix& K = block.inverse_mass;
  // [K22 K23 K24; . K33 K34; . . K44] d = goal - motion, by factors L D L'.
  const double l32 = K[3][2] / K[2][2];
  const double l42 = K[4][2] / K[2][2];
  const double d3 = K[3][3] - l32 * K[3][2];
  const double l43 = (K[4][3] - l42 * K[3][2]) / d3;
  const double d4 = K[4][4] - l42 * K[4][2] - l43 * l43 * d3;
  const double w2 = block.goal[2] - motion[2];
  const double w3 = block.goal[3] - motion[3];
  const double w4 = block.goal[4] - motion[4];
  const double y3 = w3 - l32 * w2;
  const double roll_across = (w4 - l42 * w2 - l43 * y3) / d4;
  const double roll_along = y3 / d3 - l43 * roll_across;
  const double normal = w2 / K[2][2] - l32 * roll_along - l42 * roll_across;
  Six impulse = impulse_of(block);
  impulse[2] += normal;
  impulse[3] += roll_along;
  impulse[4] += roll_across;
  std::array<double, ContactPatch::kMostPoints> pressure;
  if (!(impulse[2] > 0.0) || !spread_evenly(impulse, block, pressure)) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(block.count); ++i) {
    const ContactPatchPoint& p = block.points[i];
    corrected = std::max(corrected, std::abs(w2 + p.across * w3 - p.along * w4));
    block.points[i].impulse = pressure[i];
  }
  for (std::size_t k = 0; k < 6; ++k)
    motion[k] += K[2][k] * normal + K[3][k] * roll_along + K[4][k] * roll_across;
  change[2] += normal;
  change[3] += roll_along;
  change[4] += roll_across;
  return true;
}

// Pressure, while friction stays: of all points at once, or of one after the other.
void press(ContactPatch& block, Six& motion, Six& change, double& corrected) {
  if (block.flat && press_evenly(block, motion, change, corrected)) return;
  for (std::size_t i = 0; i < static_cast<std::size_t>(block.count); ++i) {
    ContactPatchPoint& p = block.points[i];
    press_point(p, p.target, block.inverse_mass, p.impulse, motion, change, corrected);
  }
}

// Whether the points of an area are right as they are, and none that pushes slides: then any impulses within
// Coulomb's bound will do, whoever found them. Of that bound what holds for every way to share friction out
// among points is looked at.
bool rests(const ContactPatch& block, const Six& motion, double rest) {
  const double creep = kCreep * rest;
  double normal = 0.0, lever = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(block.count); ++i) {
    const ContactPatchPoint& p = block.points[i];
    const double wrong = speed_at(p, motion) - p.target;
    if (!(wrong >= -rest)) return false;
    if (!(p.impulse > 0.0)) continue;
    const double along = motion[0] - p.across * motion[5];
    const double across = motion[1] + p.along * motion[5];
    if (!(wrong <= rest)) return false;
    if (block.friction > 0.0 && !(along * along + across * across <= creep * creep)) return false;
    normal += p.impulse;
    lever += p.impulse * std::sqrt(p.along * p.along + p.across * p.across);
  }
  const double most = (1.0 + tolerance::friction_limit) * block.friction;
  const double bound = most * normal;
  return block.along_impulse * block.along_impulse + block.across_impulse * block.across_impulse <=
             bound * bound &&
         std::abs(block.twist_impulse) <= most * lever;
}

}  // namespace

double solve_patch(ContactPatch& block, MovingBody& first, MovingBody& second, int rounds,
                   double rest) {
  Six motion = motion_of(block, first, second);
  Six change{};
  double corrected = 0.0;
  // An area all of which touches is brought to rest to the last digit.
  const bool touches = block.flat && block.goal == Six{};
  if (!touches && rest > 0.0 && rests(block, motion, rest)) return 0.0;
  if (!block.flat || !try_sticking(block, motion, change, corrected)) {
    if (touches && rest > 0.0 && rests(block, motion, rest)) return 0.0;
    change = {};
    for (int round = 0; round < rounds; ++round) {
      double most = 0.0;
      rub(block, motion, change, most);
      press(block, motion, change, most);
      corrected = std::max(corrected, most);
      if (most < tolerance::patch_settled * corrected) break;
    }
  }
  if (corrected > 0.0) apply(change, block, first, second);
  return corrected;
}

void require_separation(double slowest, ContactPatch& block) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(block.count); ++i) {
    ContactPatchPoint& p = block.points[i];
    if (!(p.impulse > 0.0)) continue;
    p.target = p.approach < -slowest ? -block.restitution * p.approach : 0.0;
  }
  block.flat = false;
}

double lift_patch(ContactPatch& block, double slop, double share, MovingBody& first,
                  MovingBody& second) {
  Six motion = motion_of(block, first, second);
  Six change{};
  double corrected = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(block.count); ++i) {
    ContactPatchPoint& p = block.points[i];
    const double rest = -p.gap - slop;  // what is to be lifted; below 0 it may sink by as much
    press_point(p, rest > 0.0 ? share * rest : rest, block.ease, p.lift, motion, change, corrected);
  }
  if (corrected > 0.0) apply(change, block, first, second);
  return corrected;
}

}  // namespace tumble
