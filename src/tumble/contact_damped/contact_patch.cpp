/// \file
/// \brief One contact area as a unit.
#include "tumble/contact_damped/contact_patch.hpp"

#include "tumble/contact/effective_mass.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/contact_damped/tolerances.hpp"
#include "tumble/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

// How far, as a share of the slop in a step, the targets of an area's points may be from those of one motion
// that is asked for in their place. A whole slop would make an area that rests on some points, with others just
// apart, move in every step towards what its points do not ask for.
constexpr double kFlat = 0.01;

constexpr std::size_t kNormal = 2, kRollAlong = 3, kRollAcross = 4;

// Adds what one body contributes: with S = [r]x, its velocity at the middle changes by
// (1/m - S I⁻¹ S) F - S I⁻¹ M, its angular velocity by I⁻¹ M + I⁻¹ S F.
void add_body(const MovingBody& body, const Vec3& arm_w, const Mat3& frame_w, SixBySix& sum) {
  if (body.inverse_mass.x() == 0.0) return;
  const Mat3 inverse_inertia = frame_w.transpose() * body.inverse_inertia_w * frame_w;
  const Mat3 s = skew(frame_w.transpose() * arm_w);
  const Mat3 turn = inverse_inertia * s;  // angular velocity of a force
  const Mat3 push = -(s * turn);          // velocity of a force
  for (std::size_t i = 0; i < 3; ++i) {
    const auto a = static_cast<Eigen::Index>(i);
    sum[i][i] += body.inverse_mass.x();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto b = static_cast<Eigen::Index>(k);
      sum[i][k] += push(a, b);
      sum[i + 3][k] += turn(a, b);
      sum[k][i + 3] += turn(a, b);
      sum[i + 3][k + 3] += inverse_inertia(a, b);
    }
  }
}

// Inverse of a symmetric positive definite matrix, by its factors L D L'. No roots are taken: masses
// times a power of two leave the same bits.
SixBySix inverse_of(const SixBySix& m) {
  SixBySix l{};
  SixBySix inverse_l{};
  Six d{};
  for (std::size_t j = 0; j < 6; ++j) {
    d[j] = m[j][j];
    for (std::size_t k = 0; k < j; ++k) d[j] -= l[j][k] * l[j][k] * d[k];
    for (std::size_t i = j + 1; i < 6; ++i) {
      double sum = m[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= l[i][k] * l[j][k] * d[k];
      l[i][j] = sum / d[j];
    }
  }
  for (std::size_t j = 0; j < 6; ++j) {
    inverse_l[j][j] = 1.0;
    for (std::size_t i = j + 1; i < 6; ++i) {
      double sum = 0.0;
      for (std::size_t k = j; k < i; ++k) sum -= l[i][k] * inverse_l[k][j];
      inverse_l[i][j] = sum;
    }
  }
  SixBySix inverse{};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = 0.0;
      for (std::size_t k = i; k < 6; ++k) sum += inverse_l[k][i] * inverse_l[k][j] / d[k];
      inverse[i][j] = inverse[j][i] = sum;
    }
  }
  return inverse;
}

// Second moments of the points about their middle, and their inverse if they span an area.
void find_spread(ContactPatch& block) {
  double aa = 0.0, ac = 0.0, cc = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(block.count); ++i) {
    const ContactPatchPoint& p = block.points[i];
    aa += p.along * p.along;
    ac += p.along * p.across;
    cc += p.across * p.across;
  }
  const double determinant = aa * cc - ac * ac;
  const double size = aa + cc;
  block.spreads = block.count >= 3 && determinant > tolerance::thin_patch * size * size;
  if (block.spreads) block.spread = {cc / determinant, -ac / determinant, aa / determinant};
}

// How far above the mean of an area's points its surfaces touch [m], along the normal: points lie halfway
// between the surfaces, those that are apart higher or lower than the others. Velocities are matched at
// the middle, and a box that turns about an edge must not be held by a point beside that edge.
double height_of_touch(const Manifold& found, const Vec3& mean_w, double slop) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < static_cast<std::size_t>(found.count); ++i)
    least = std::min(least, found.points[i].distance);
  const double most = std::max(least, 0.0) + slop;
  double height = 0.0;
  int touching = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(found.count); ++i) {
    const ManifoldPoint& p = found.points[i];
    if (p.distance > most) continue;
    height += found.normal_w.dot(p.position_w - mean_w);
    ++touching;
  }
  return touching == found.count ? 0.0 : height / touching;
}

}  // namespace

Vec3 position_of(const ContactPatch& block, const MovingBody& first,
                 const ContactPatchPoint& point) {
  return first.position_w + block.first_arm_w + point.along * block.frame_w.col(0) +
         point.across * block.frame_w.col(1);
}

void build_patch(const Manifold& found, const MovingBody& first, const MovingBody& second,
                 ContactPatch& block) {
  Vec3 middle_w = Vec3::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(found.count); ++i)
    middle_w += found.points[i].position_w;
  middle_w /= found.count;
  middle_w += height_of_touch(found, middle_w, tolerance::contact_damped_slop * block.size) *
              found.normal_w;
  const Tangents tangents = tangents_of(found.normal_w);
  block.frame_w.col(0) = tangents.first_w;
  block.frame_w.col(1) = tangents.second_w;
  block.frame_w.col(2) = found.normal_w;
  block.axis = found.axis;
  block.first_arm_w = middle_w - first.position_w;
  block.second_arm_w = middle_w - second.position_w;
  block.count = found.count;
  for (std::size_t i = 0; i < static_cast<std::size_t>(found.count); ++i) {
    const ManifoldPoint& p = found.points[i];
    ContactPatchPoint& point = block.points[i];
    point = ContactPatchPoint{};
    point.along = tangents.first_w.dot(p.position_w - middle_w);
    point.across = tangents.second_w.dot(p.position_w - middle_w);
    point.built_gap = point.gap = p.distance;
    point.feature = p.feature;
  }
  block.along_impulse = block.across_impulse = block.twist_impulse = 0.0;
  block.inverse_mass = {};
  add_body(first, block.first_arm_w, block.frame_w, block.inverse_mass);
  add_body(second, block.second_arm_w, block.frame_w, block.inverse_mass);
  find_spread(block);
  if (block.spreads) block.mass = inverse_of(block.inverse_mass);
}

void begin_lift(const MovingBody& first, const MovingBody& second, ContactPatch& block) {
  for (ContactPatchPoint& p : block.points) p.lift = 0.0;
  block.ease = {};
  add_body(first, block.first_arm_w, block.frame_w, block.ease);
  add_body(second, block.second_arm_w, block.frame_w, block.ease);
}

bool spread_evenly(const Six& impulse, const ContactPatch& block,
                   std::array<double, ContactPatch::kMostPoints>& pressure) {
  const double even = impulse[kNormal] / block.count;
  const double along =
      block.spread[1] * impulse[kRollAlong] - block.spread[0] * impulse[kRollAcross];
  const double across =
      block.spread[2] * impulse[kRollAlong] - block.spread[1] * impulse[kRollAcross];
  bool pushes = true;
  for (std::size_t i = 0; i < static_cast<std::size_t>(block.count); ++i) {
    pressure[i] = even + along * block.points[i].along + across * block.points[i].across;
    pushes = pushes && pressure[i] >= 0.0;
  }
  return pushes;
}

void inherit(const ContactPatch& before, ContactPatch& block) {
  // The impulse of the old area, seen from the new one's middle and in its frame. It goes with the body on
  // which the area has moved less: with the one that slides, if the other one is larger.
  const Six old = impulse_of(before);
  const Mat3 turn = block.frame_w.transpose() * before.frame_w;
  const Vec3 force = turn * Vec3(old[0], old[1], old[2]);
  const Vec3 on_first_w = before.first_arm_w - block.first_arm_w;
  const Vec3 on_second_w = before.second_arm_w - block.second_arm_w;
  const bool with_first = on_first_w.squaredNorm() < on_second_w.squaredNorm();
  const Vec3 shift = block.frame_w.transpose() * (with_first ? on_first_w : on_second_w);
  const Vec3 moment = turn * Vec3(old[3], old[4], old[5]) + shift.cross(force);
  block.along_impulse = force[0];
  block.across_impulse = force[1];
  block.twist_impulse = moment[2];
  const auto count = static_cast<std::size_t>(block.count);
  bool same_points = before.count == block.count;
  for (std::size_t i = 0; i < count && same_points; ++i)
    same_points = before.points[i].feature == block.points[i].feature;
  for (std::size_t i = 0; i < count && same_points; ++i)
    block.points[i].given = turn * before.points[i].given;
  std::array<double, ContactPatch::kMostPoints> pressure;
  const Six impulse{0.0, 0.0, force[2], moment[0], moment[1], 0.0};
  if (block.spreads && force[2] > 0.0 && spread_evenly(impulse, block, pressure)) {
    for (std::size_t i = 0; i < count; ++i) block.points[i].impulse = pressure[i];
    return;
  }
  // Else each old point leaves its impulse to the one of the same name, or to the nearest one.
  for (std::size_t k = 0; k < static_cast<std::size_t>(before.count); ++k) {
    const ContactPatchPoint& gone = before.points[k];
    if (!(gone.impulse > 0.0)) continue;
    const Vec3 at = turn * Vec3(gone.along, gone.across, 0.0) + shift;
    ContactPatchPoint* heir = nullptr;
    double nearest = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      ContactPatchPoint& p = block.points[i];
      const double a = p.along - at.x();
      const double b = p.across - at.y();
      const double far = p.feature == gone.feature ? -1.0 : a * a + b * b;
      if (heir != nullptr && far >= nearest) continue;
      heir = &p;
      nearest = far;
    }
    heir->impulse += gone.impulse;
  }
}

void set_targets(double slop, double dt, ContactPatch& block) {
  bool all_touch = true;
  for (std::size_t i = 0; i < static_cast<std::size_t>(block.count); ++i) {
    ContactPatchPoint& p = block.points[i];
    p.target = p.gap > slop ? -(p.gap - slop) / dt : 0.0;
    all_touch = all_touch && p.target == 0.0;
  }
  block.goal = {};
  block.flat = block.spreads;
  if (!block.spreads) return;
  if (all_touch) return;
  // The plane through the targets that is nearest to them; a plane is what one motion can do.
  double mean = 0.0, along = 0.0, across = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(block.count); ++i) {
    const ContactPatchPoint& p = block.points[i];
    mean += p.target / block.count;
    along += p.along * p.target;
    across += p.across * p.target;
  }
  const double slope_along = block.spread[0] * along + block.spread[1] * across;
  const double slope_across = block.spread[1] * along + block.spread[2] * across;
  for (std::size_t i = 0; i < static_cast<std::size_t>(block.count); ++i) {
    const ContactPatchPoint& p = block.points[i];
    const double plane = mean + slope_along * p.along + slope_across * p.across;
    if (std::abs(plane - p.target) * dt > kFlat * slop) block.flat = false;
  }
  block.goal[kNormal] = mean;
  block.goal[kRollAlong] = slope_across;
  block.goal[kRollAcross] = -slope_along;
}

void follow_arcs(const MovingBody& first, const MovingBody& second, double dt,
                 ContactPatch& block) {
  // How much further than its tangent the arc of a point leads along the normal.
  const auto rise = [&](const MovingBody& body, const Vec3& arm_w) {
    const Vec3 turn_w = dt * body.angular_velocity_w;
    if (!(turn_w.norm() > tolerance::fast_turn)) return 0.0;
    const Vec3 arc_w = rotation_from_vector(turn_w) * arm_w - arm_w;
    return block.frame_w.col(2).dot(arc_w - turn_w.cross(arm_w));
  };
  for (std::size_t i = 0; i < static_cast<std::size_t>(block.count); ++i) {
    ContactPatchPoint& p = block.points[i];
    const Vec3 offset_w = p.along * block.frame_w.col(0) + p.across * block.frame_w.col(1);
    const double away =
        rise(second, block.second_arm_w + offset_w) - rise(first, block.first_arm_w + offset_w);
    if (!(away > 0.0)) continue;
    p.target -= away / dt;
    block.flat = false;
  }
}

}  // namespace tumble
