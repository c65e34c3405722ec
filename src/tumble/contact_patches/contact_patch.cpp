/// \file
/// \brief Building a contact patch, its targets and its warm start.
#include "tumble/contact_patches/contact_patch.hpp"

#include "tumble/contact/effective_mass.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/contact_patches/tolerances.hpp"
#include "tumble/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

// Adds the inverse mass of one body: with S = [r]x, its velocity at the middle changes by
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

// Inverse of the second moments of the points about their middle, if they span an area.
void find_moments(ContactPatch& patch) {
  double aa = 0.0, ac = 0.0, cc = 0.0;
  for (const ContactPatchPoint& p : patch.used()) {
    aa += p.along * p.along;
    ac += p.along * p.across;
    cc += p.across * p.across;
  }
  const double determinant = aa * cc - ac * ac;
  const double size = aa + cc;
  patch.spans_area = patch.count >= 3 && determinant > tolerance::thin_patch * size * size;
  if (patch.spans_area)
    patch.inverse_moments = {cc / determinant, -ac / determinant, aa / determinant};
}

// How far above the mean of a patch's points its surfaces touch [m], along the normal: points lie halfway
// between the surfaces, those with a gap higher or lower than the others. Velocities are matched at
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

SixBySix inverse_mass_of(const ContactPatch& patch, const MovingBody& first,
                         const MovingBody& second) {
  SixBySix sum{};
  add_body(first, patch.first_arm_w, patch.frame_w, sum);
  add_body(second, patch.second_arm_w, patch.frame_w, sum);
  return sum;
}

Vec3 position_of(const ContactPatch& patch, const MovingBody& first,
                 const ContactPatchPoint& point) {
  return first.position_w + patch.first_arm_w + point.along * patch.frame_w.col(0) +
         point.across * patch.frame_w.col(1);
}

void build_patch(const Manifold& found, const MovingBody& first, const MovingBody& second,
                 ContactPatch& patch) {
  Vec3 middle_w = Vec3::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(found.count); ++i)
    middle_w += found.points[i].position_w;
  middle_w /= found.count;
  middle_w +=
      height_of_touch(found, middle_w, tolerance::contact_slop * patch.size) * found.normal_w;
  const Tangents tangents = tangents_of(found.normal_w);
  patch.frame_w.col(0) = tangents.first_w;
  patch.frame_w.col(1) = tangents.second_w;
  patch.frame_w.col(2) = found.normal_w;
  patch.axis = found.axis;
  patch.first_arm_w = middle_w - first.position_w;
  patch.second_arm_w = middle_w - second.position_w;
  patch.count = found.count;
  for (std::size_t i = 0; i < static_cast<std::size_t>(found.count); ++i) {
    const ManifoldPoint& p = found.points[i];
    ContactPatchPoint& point = patch.points[i];
    point = ContactPatchPoint{};
    point.along = tangents.first_w.dot(p.position_w - middle_w);
    point.across = tangents.second_w.dot(p.position_w - middle_w);
    point.built_gap = point.gap = p.distance;
    point.feature = p.feature;
  }
  patch.along_impulse = patch.across_impulse = patch.twist_impulse = 0.0;
  patch.inverse_mass = inverse_mass_of(patch, first, second);
  find_moments(patch);
  if (patch.spans_area) patch.mass = inverse_of(patch.inverse_mass);
}

bool distribute_evenly(const Six& impulse, const ContactPatch& patch,
                       std::array<double, ContactPatch::kMostPoints>& pressure) {
  const double even = impulse[six::normal] / patch.count;
  const double along = patch.inverse_moments[1] * impulse[six::roll_along] -
                       patch.inverse_moments[0] * impulse[six::roll_across];
  const double across = patch.inverse_moments[2] * impulse[six::roll_along] -
                        patch.inverse_moments[1] * impulse[six::roll_across];
  bool pushes = true;
  for (std::size_t i = 0; i < static_cast<std::size_t>(patch.count); ++i) {
    pressure[i] = even + along * patch.points[i].along + across * patch.points[i].across;
    pushes = pushes && pressure[i] >= 0.0;
  }
  return pushes;
}

void transfer_impulses(const ContactPatch& before, ContactPatch& patch) {
  // About the middle of the new patch. It moves with the body on which the patch has moved less.
  const Six old = impulse_of(before);
  const Mat3 turn = patch.frame_w.transpose() * before.frame_w;
  const Vec3 force = turn * Vec3(old[0], old[1], old[2]);
  const Vec3 on_first_w = before.first_arm_w - patch.first_arm_w;
  const Vec3 on_second_w = before.second_arm_w - patch.second_arm_w;
  const bool with_first = on_first_w.squaredNorm() < on_second_w.squaredNorm();
  const Vec3 shift = patch.frame_w.transpose() * (with_first ? on_first_w : on_second_w);
  const Vec3 moment = turn * Vec3(old[3], old[4], old[5]) + shift.cross(force);
  patch.solved_directly = before.solved_directly;
  patch.steps_since_impact = before.steps_since_impact;
  patch.along_impulse = force[0];
  patch.across_impulse = force[1];
  patch.twist_impulse = moment[2];
  const auto count = static_cast<std::size_t>(patch.count);
  bool same_points = before.count == patch.count;
  for (std::size_t i = 0; i < count && same_points; ++i)
    same_points = before.points[i].feature == patch.points[i].feature;
  for (std::size_t i = 0; i < count && same_points; ++i)
    patch.points[i].solver_impulse = turn * before.points[i].solver_impulse;
  std::array<double, ContactPatch::kMostPoints> pressure;
  const Six impulse{0.0, 0.0, force[2], moment[0], moment[1], 0.0};
  if (patch.spans_area && force[2] > 0.0 && distribute_evenly(impulse, patch, pressure)) {
    for (std::size_t i = 0; i < count; ++i) patch.points[i].impulse = pressure[i];
    return;
  }
  // Otherwise each previous point passes its impulse to the point of the same feature, or to the nearest one.
  for (const ContactPatchPoint& old_point : before.used()) {
    if (!(old_point.impulse > 0.0)) continue;
    const Vec3 at = turn * Vec3(old_point.along, old_point.across, 0.0) + shift;
    ContactPatchPoint* receiver = nullptr;
    double nearest = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      ContactPatchPoint& p = patch.points[i];
      const double a = p.along - at.x();
      const double b = p.across - at.y();
      const double far = p.feature == old_point.feature ? -1.0 : a * a + b * b;
      if (receiver != nullptr && far >= nearest) continue;
      receiver = &p;
      nearest = far;
    }
    receiver->impulse += old_point.impulse;
  }
}

PatchImpulses impulses_in(const ContactPatch& patch) {
  PatchImpulses all{patch.along_impulse, patch.across_impulse, patch.twist_impulse};
  std::transform(patch.used().begin(), patch.used().end(), all.begin() + 3,
                 [](const ContactPatchPoint& p) { return p.impulse; });
  return all;
}

void go_back(const PatchImpulses& before, double share, ContactPatch& patch) {
  const auto between = [share](double from, double to) { return from + share * (to - from); };
  patch.along_impulse = between(before[0], patch.along_impulse);
  patch.across_impulse = between(before[1], patch.across_impulse);
  patch.twist_impulse = between(before[2], patch.twist_impulse);
  const double* from = before.data() + 3;
  for (ContactPatchPoint& p : patch.used()) p.impulse = between(*from++, p.impulse);
}

void scale_impulses(double factor, ContactPatch& patch) {
  patch.along_impulse *= factor;
  patch.across_impulse *= factor;
  patch.twist_impulse *= factor;
  for (ContactPatchPoint& p : patch.used()) {
    p.impulse *= factor;
    p.solver_impulse *= factor;
  }
}

void set_targets(double slop, double dt, ContactPatch& patch) {
  bool all_touch = true;
  // [S6.3.1:targets]
  for (ContactPatchPoint& p : patch.used()) {
    const double reach = p.impulse > 0.0 ? tolerance::kept_touch * slop : slop;
    p.target = is_apart(p.gap, reach) ? -(p.gap - slop) / dt : 0.0;
    all_touch = all_touch && p.target == 0.0;
  }
  // [S6.3.1:targets]
  patch.target_motion = {};
  patch.targets_planar = patch.spans_area;
  if (!patch.spans_area || all_touch) return;
  // The normal velocities of one motion lie in a plane: the one that fits the targets best.
  double mean = 0.0, along = 0.0, across = 0.0;
  for (const ContactPatchPoint& p : patch.used()) {
    mean += p.target / patch.count;
    along += p.along * p.target;
    across += p.across * p.target;
  }
  const double slope_along = patch.inverse_moments[0] * along + patch.inverse_moments[1] * across;
  const double slope_across = patch.inverse_moments[1] * along + patch.inverse_moments[2] * across;
  for (const ContactPatchPoint& p : patch.used()) {
    const double plane = mean + slope_along * p.along + slope_across * p.across;
    if (std::abs(plane - p.target) * dt > tolerance::planar_targets * slop)
      patch.targets_planar = false;
  }
  patch.target_motion[six::normal] = mean;
  patch.target_motion[six::roll_along] = slope_across;
  patch.target_motion[six::roll_across] = -slope_along;
}

bool asks_for_nothing(const ContactPatch& patch) {
  return std::all_of(patch.used().begin(), patch.used().end(), [](const ContactPatchPoint& p) {
    return p.target == -std::numeric_limits<double>::infinity();
  });
}

void correct_targets_for_rotation(const MovingBody& first, const MovingBody& second, double dt,
                                  ContactPatch& patch) {
  const auto turns_far = [dt](const MovingBody& body) {
    return dt * body.angular_velocity_w.norm() > tolerance::fast_turn;
  };
  if (!turns_far(first) && !turns_far(second)) return;
  // How much further along the normal than its tangent the arc of a point leads.
  const auto rise = [&](const MovingBody& body, const Vec3& arm_w) {
    if (!turns_far(body)) return 0.0;
    const Vec3 turn_w = dt * body.angular_velocity_w;
    const Vec3 arc_w = rotation_from_vector(turn_w) * arm_w - arm_w;
    return patch.frame_w.col(2).dot(arc_w - turn_w.cross(arm_w));
  };
  for (ContactPatchPoint& p : patch.used()) {
    const Vec3 offset_w = p.along * patch.frame_w.col(0) + p.across * patch.frame_w.col(1);
    const double away =
        rise(second, patch.second_arm_w + offset_w) - rise(first, patch.first_arm_w + offset_w);
    if (!(away > 0.0)) continue;
    p.target -= away / dt;
    patch.targets_planar = false;
  }
}

}  // namespace tumble
