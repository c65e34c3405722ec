/// \file
/// \brief A contact patch: where two bodies touch, with six numbers of motion and six of impulse (thesis 6.3.1).
#pragma once

#include "tumble/contact/moving_body.hpp"
#include "tumble/contact_patches/tolerances.hpp"
#include "tumble/dynamics/body.hpp"
#include "tumble/geometry/manifold.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace tumble {

/// Six numbers in the frame of a contact patch (first tangent, second tangent, normal), all taken at the
/// patch's middle; see tumble::six for the indices.
///
/// As *motion*: velocity and angular velocity of the second body relative to the first one. As *impulse*:
/// linear and angular impulse on the second body; the first one gets the opposite.
using Six = std::array<double, 6>;

/// A 6×6 matrix, row by row.
using SixBySix = std::array<Six, 6>;

/// Indices of a Six.
namespace six {
inline constexpr std::size_t along = 0;        ///< tangential, along the first tangent
inline constexpr std::size_t across = 1;       ///< tangential, along the second tangent
inline constexpr std::size_t normal = 2;       ///< along the normal
inline constexpr std::size_t roll_along = 3;   ///< about the first tangent
inline constexpr std::size_t roll_across = 4;  ///< about the second tangent
inline constexpr std::size_t twist = 5;        ///< about the normal
}  // namespace six

/// One point of a contact patch.
struct ContactPatchPoint {
  double along = 0.0;      ///< [m] from the middle along the first tangent
  double across = 0.0;     ///< [m] from the middle along the second tangent
  double target = 0.0;     ///< [m/s] least normal velocity allowed at the end of the step
  double impulse = 0.0;    ///< [N s] along the normal, at least 0
  double gap = 0.0;        ///< [m] now; below 0 the surfaces overlap
  double built_gap = 0.0;  ///< [m] when the patch was built
  double approach = 0.0;   ///< [m/s] normal velocity with which it hits, if below 0
  FeatureId feature = 0;   ///< identifies the point over time
  /// [N s] along, across, normal: the point's impulse when IslandSolver last solved the patch. Later
  /// changes are in the sums of the patch only.
  Vec3 solver_impulse = Vec3::Zero();
};

/// A contact patch of two bodies, with all that solving it needs.
///
/// While the bodies hardly move relative to each other, the points, the frame and the inverse masses are
/// kept from step to step, and gaps follow from the small motion (PersistentManifolds).
struct ContactPatch {
  static constexpr std::size_t kMostPoints = Manifold::kMostPoints;  ///< of a patch
  static constexpr int kNoImpact = 1000;                             ///< steps since it: many

  // What a sweep reads stands together, since memory bounds large worlds.
  int first = 0;                 ///< index of the first body in this step
  int second = 0;                ///< index of the second body in this step
  int count = 0;                 ///< points in use
  bool spans_area = false;       ///< three points or more that are not on a line
  bool targets_planar = false;   ///< one motion, `target_motion`, meets the targets of all points
  bool solved_directly = false;  ///< by the direct solver, in the last step
  double size = 0.0;             ///< [m] shortest edge of the movable bodies
  double friction = 0.0;         ///< [-] coefficient of the pair
  double along_impulse = 0.0;    ///< [N s] friction along the first tangent
  double across_impulse = 0.0;   ///< [N s] friction along the second tangent
  double twist_impulse = 0.0;    ///< [N m s] friction about the normal at the middle
  Mat3 frame_w = Mat3::Identity();   ///< [-] columns: first tangent, second, normal
  Vec3 first_arm_w = Vec3::Zero();   ///< [m] from the first body's centre to the middle
  Vec3 second_arm_w = Vec3::Zero();  ///< [m] from the second body's centre to the middle
  Six target_motion{};               ///< the motion whose normal velocities fit the targets best
  /// [1/m²] inverse of the points' second moments: along-along, along-across, across-across
  std::array<double, 3> inverse_moments{};
  SixBySix inverse_mass{};                            ///< motion of a unit impulse
  SixBySix mass{};                                    ///< its inverse, if `spans_area`
  std::array<ContactPatchPoint, kMostPoints> points;  ///< the first `count`

  BodyId first_id{};                           ///< the body with the smaller id
  BodyId second_id{};                          ///< the other one
  AxisIndex axis = kNoAxis;                    ///< separating axis to try first in the next step
  std::uint64_t stamp = 0;                     ///< changes each time that the patch is built
  double restitution = 0.0;                    ///< [-] of the pair
  double carried_impulse = 0.0;                ///< [N s] along the normal, from the step before
  int steps_since_impact = kNoImpact;          ///< since an impact in its island
  std::array<Vec3, 2> built_position_w;        ///< [m] of both bodies when the patch was built
  std::array<Quat, 2> built_orientation_wb;    ///< [-] of both bodies then
  std::array<double, 2> built_inverse_mass{};  ///< [1/kg] of both bodies then; 0 for sleeping ones
  double built_reach = 0.0;                    ///< [m] points with a larger gap were left out
  /// [-] directions in which a grazed edge has no height, else 0
  std::array<Vec3, 2> flat_w = {Vec3::Zero(), Vec3::Zero()};

  /// The points in use.
  /// \return `count` of them
  [[nodiscard]] std::span<const ContactPatchPoint> used() const {
    return std::span(points).first(static_cast<std::size_t>(count));
  }
  /// The points in use.
  /// \return `count` of them
  [[nodiscard]] std::span<ContactPatchPoint> used() {
    return std::span(points).first(static_cast<std::size_t>(count));
  }
};

/// Position of a point of a patch.
/// \param first  its first body, where it was at the start of the step
/// \param point  one of the patch's
/// \return [m] world frame
Vec3 position_of(const ContactPatch& patch, const MovingBody& first,
                 const ContactPatchPoint& point);

/// The motion of a patch for a unit impulse.
/// \param patch   its frame and middle
/// \param first   the inverse mass of the first body
/// \param second  the same of the second one
/// \return [1/kg] and the like, in the patch's frame
[[nodiscard]] SixBySix inverse_mass_of(const ContactPatch& patch, const MovingBody& first,
                                       const MovingBody& second);

/// Builds a patch from a manifold.
///
/// The middle is the mean of the points, at the height along the normal of those that touch: points with a
/// gap lie halfway between the surfaces.
/// \param found   where the bodies touch, normal from the first to the second; at least one point
/// \param first   velocity and inverse mass of the first body
/// \param second  the same of the second one
/// \param patch   ids, indices, coefficients, targets and `built_*` stay; the rest is overwritten, impulses are 0
void build_patch(const Manifold& found, const MovingBody& first, const MovingBody& second,
                 ContactPatch& patch);

/// Distributes a normal impulse over the points of a patch as evenly as its centre of pressure allows: the
/// split with the least sum of squares, negative values included.
/// \param impulse   the sum along the normal and the two moments across it are used
/// \param patch     one that spans an area
/// \param pressure  out: [N s] one for each point
/// \return whether all are at least 0
bool distribute_evenly(const Six& impulse, const ContactPatch& patch,
                       std::array<double, ContactPatch::kMostPoints>& pressure);

/// Warm start of a patch that was built again: takes over the impulses of the pair's previous patch, those
/// of points by feature, and friction as it was in the world frame.
/// \param patch   the new one; impulses are overwritten
void transfer_impulses(const ContactPatch& before, ContactPatch& patch);

/// The impulses of a patch by themselves: friction along, across and about the normal, then those of its points.
using PatchImpulses = std::array<double, 3 + ContactPatch::kMostPoints>;

/// Copies the impulses of a patch.
/// \return [N s], [N m s]; 0 for points that are not in use
[[nodiscard]] PatchImpulses impulses_in(const ContactPatch& patch);

/// Goes back towards earlier impulses of a patch.
/// \param before  the earlier ones, of the same points
/// \param share   [-] of the way from there to the present ones that is kept, 0 to 1
/// \param patch   impulses in and out
void go_back(const PatchImpulses& before, double share, ContactPatch& patch);

/// Multiplies all impulses of a patch.
/// \param factor  [-] at least 0
/// \param patch   impulses in and out
void scale_impulses(double factor, ContactPatch& patch);

/// Whether a point does not touch. One that rests a slop above the other body stays there, whatever rounding does.
/// \param gap   [m] of the point
/// \param slop  [m] smaller gaps count as touching, and those larger by a hundredth
[[nodiscard]] inline bool is_apart(double gap, double slop) {
  return gap > (1.0 + tolerance::planar_targets) * slop;
}

/// Sets the least normal velocities of the points for a step.
///
/// A point with the gap d may close it up to the slop, \f$v_n \ge -(d - s)/\Delta t\f$; one
/// that touches or overlaps may not approach. A point that pushes touches up to tolerance::kept_touch. Finds also whether one motion of the patch meets all targets.
/// \param slop   [m] smaller gaps count as touching
/// \param patch  targets, targets_planar and target_motion are overwritten
void set_targets(double slop, double dt, ContactPatch& patch);

/// Whether no velocity is asked for at any point of a patch: all targets are minus infinity.
[[nodiscard]] bool asks_for_nothing(const ContactPatch& patch);

/// Corrects the targets where a body turns so far in a step that a point leaves its tangent: by how much
/// the arc \f$(e^{[h\omega]} - 1)\,r\f$ leads further away than \f$h\,\omega\times r\f$.
/// \param first   how the first body would move
/// \param second  how the second one would
/// \param patch   after set_targets(); targets and targets_planar in and out
void correct_targets_for_rotation(const MovingBody& first, const MovingBody& second, double dt,
                                  ContactPatch& patch);

/// The relative motion of a patch's bodies.
/// \param first   how the first body moves
/// \param second  how the second one does
/// \return in the patch's frame
inline Six motion_of(const ContactPatch& patch, const MovingBody& first, const MovingBody& second) {
  const Vec3 v = second.velocity_w + second.angular_velocity_w.cross(patch.second_arm_w) -
                 first.velocity_w - first.angular_velocity_w.cross(patch.first_arm_w);
  const Vec3 w = second.angular_velocity_w - first.angular_velocity_w;
  const auto& f = patch.frame_w;
  return {f.col(0).dot(v), f.col(1).dot(v), f.col(2).dot(v),
          f.col(0).dot(w), f.col(1).dot(w), f.col(2).dot(w)};
}

/// The motion of a point of a patch.
/// \param along   [m] its place
/// \param across  [m] ditto
/// \return [m/s] along, across, normal
inline Vec3 velocity_at(double along, double across, const Six& motion) {
  return {motion[0] - across * motion[5], motion[1] + along * motion[5],
          motion[2] + across * motion[3] - along * motion[4]};
}

/// The sum of all impulses of a patch.
/// \return in the patch's frame
inline Six impulse_of(const ContactPatch& patch) {
  Six sum{patch.along_impulse, patch.across_impulse, 0.0, 0.0, 0.0, patch.twist_impulse};
  for (const ContactPatchPoint& p : patch.used()) {
    sum[six::normal] += p.impulse;
    sum[six::roll_along] += p.impulse * p.across;
    sum[six::roll_across] -= p.impulse * p.along;
  }
  return sum;
}

/// Applies an impulse to the bodies of a patch.
/// \param impulse  in the patch's frame
/// \param first    changed unless immovable
/// \param second   changed unless immovable
inline void apply(const Six& impulse, const ContactPatch& patch, MovingBody& first,
                  MovingBody& second) {
  const auto& f = patch.frame_w;
  const Vec3 force_w = impulse[0] * f.col(0) + impulse[1] * f.col(1) + impulse[2] * f.col(2);
  const Vec3 moment_w = impulse[3] * f.col(0) + impulse[4] * f.col(1) + impulse[5] * f.col(2);
  if (first.inverse_mass.x() > 0.0) {
    first.velocity_w -= first.inverse_mass.x() * force_w;
    first.angular_velocity_w -=
        first.inverse_inertia_w * (moment_w + patch.first_arm_w.cross(force_w));
    first.changed = true;
  }
  if (second.inverse_mass.x() > 0.0) {
    second.velocity_w += second.inverse_mass.x() * force_w;
    second.angular_velocity_w +=
        second.inverse_inertia_w * (moment_w + patch.second_arm_w.cross(force_w));
    second.changed = true;
  }
}

}  // namespace tumble
