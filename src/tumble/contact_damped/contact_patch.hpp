/// \file
/// \brief One contact area as a unit: six numbers of motion, six of force (thesis 6.3.1).
#pragma once

#include "tumble/contact/moving_body.hpp"
#include "tumble/dynamics/body.hpp"
#include "tumble/geometry/manifold.hpp"

#include <array>
#include <cstdint>

namespace tumble {

/// Six numbers in the frame of a contact area (first tangent, second tangent, normal): of motion, the
/// velocity and the angular velocity of the second body as seen from the first; of impulses, the
/// force and the moment on the second body. Both at the area's middle.
using Six = std::array<double, 6>;

/// Row by row.
using SixBySix = std::array<Six, 6>;

/// One point of a contact area.
struct ContactPatchPoint {
  double along = 0.0;      ///< [m] from the middle along the first tangent
  double across = 0.0;     ///< [m] from the middle along the second tangent
  double built_gap = 0.0;  ///< [m] when the area was found; below 0 the surfaces overlap
  double gap = 0.0;        ///< [m] now
  double target = 0.0;     ///< [m/s] least normal velocity allowed at the end of the step
  double approach = 0.0;   ///< [m/s] normal velocity with which it hits, if below 0
  double impulse = 0.0;    ///< [N s] along the normal, at least 0
  double lift = 0.0;       ///< [m] what the repair of overlap has pushed so far, at least 0
  FeatureId feature = 0;   ///< its name over time
  /// [N s] along, across, normal: what IslandSolver gave the point when it last solved the area. What
  /// has come to the area since is in its sums alone.
  Vec3 given = Vec3::Zero();
};

/// A contact area of two bodies, with all that solving it needs.
///
/// While the bodies hardly move against each other, the area, its frame and the inverse masses are
/// kept from step to step, and gaps follow from the small motion.
struct ContactPatch {
  static constexpr std::size_t kMostPoints = Manifold::kMostPoints;  ///< of an area

  BodyId first_id{};                         ///< the body with the smaller id
  BodyId second_id{};                        ///< the other one
  int first = 0;                             ///< index of the first body in this step
  int second = 0;                            ///< index of the second body in this step
  AxisIndex axis = kNoAxis;                  ///< remembered for the next step
  std::uint64_t stamp = 0;                   ///< another one each time that the area is found anew
  double size = 0.0;                         ///< [m] shortest edge of the movable bodies
  double friction = 0.0;                     ///< [-] coefficient of the pair
  double restitution = 0.0;                  ///< [-] of the pair
  Mat3 frame_w = Mat3::Identity();           ///< [-] columns: first tangent, second, normal
  Vec3 first_arm_w = Vec3::Zero();           ///< [m] from the first body's centre to the middle
  Vec3 second_arm_w = Vec3::Zero();          ///< [m] from the second body's centre to the middle
  std::array<Vec3, 2> built_position_w;      ///< [m] of both bodies when the area was found
  std::array<Quat, 2> built_orientation_wb;  ///< [-] of both bodies then
  std::array<double, 2> built_inverse_mass{};  ///< [1/kg] of both bodies then; 0 for sleepers
  double built_reach = 0.0;                    ///< [m] points apart by more were left out
  int count = 0;                               ///< points in use
  std::array<ContactPatchPoint, kMostPoints> points;  ///< the first `count`
  double along_impulse = 0.0;                         ///< [N s] friction along the first tangent
  double across_impulse = 0.0;                        ///< [N s] friction along the second tangent
  double twist_impulse = 0.0;  ///< [N m s] friction about the normal at the middle
  SixBySix inverse_mass{};     ///< motion of a unit impulse
  SixBySix mass{};             ///< its inverse, if `spreads`
  SixBySix ease{};             ///< motion of a unit push, see begin_lift()
  /// [1/m²] inverse of the points' second moments: along-along, along-across, across-across
  std::array<double, 3> spread{};
  bool spreads = false;  ///< three points or more that span an area
  bool flat = false;     ///< one motion meets all targets
  Six goal{};            ///< this motion
};

/// Where a point of an area is.
/// \param block  the area
/// \param first  its first body, where it was at the start of the step
/// \param point  one of the area's
/// \return [m] world frame
Vec3 position_of(const ContactPatch& block, const MovingBody& first,
                 const ContactPatchPoint& point);

/// Builds a block from a manifold.
///
/// The area's middle is the mean of its points, at the height along the normal at which those that touch
/// do: points that are apart lie halfway between the surfaces.
/// \param found   where the bodies touch, normal from the first to the second; at least one point
/// \param first   how the first body moves
/// \param second  how the second one does
/// \param block   ids, indices, coefficients stay; the rest is overwritten, impulses are 0
void build_patch(const Manifold& found, const MovingBody& first, const MovingBody& second,
                 ContactPatch& block);

/// Spreads a normal impulse over the points of an area as evenly as its centre allows: the split with
/// the least sum of squares among those that may pull.
/// \param impulse   the sum along the normal and the two moments across it are used
/// \param block     the area, one that spreads
/// \param pressure  out: [N s] one for each point
/// \return whether no point pulls
bool spread_evenly(const Six& impulse, const ContactPatch& block,
                   std::array<double, ContactPatch::kMostPoints>& pressure);

/// Gives a new block the impulses of the old one of the same pair: those of the points by name, and
/// friction as it was in the world frame.
/// \param before  the old one
/// \param block   the new one; impulses are overwritten
void inherit(const ContactPatch& before, ContactPatch& block);

/// Sets the least normal velocities of the points for a step.
///
/// A point that is apart by d may close its gap up to the slop, \f$v_n \ge -(d - s)/\Delta t\f$; one
/// that touches or overlaps may not approach. Whether one motion of the area meets all
/// targets is found as well.
/// \param slop   [m] gaps up to this are none
/// \param dt     [s] of the step
/// \param block  targets, flat and goal are overwritten
void set_targets(double slop, double dt, ContactPatch& block);

/// Makes an area ready for the repair of its overlap: no push so far, and how far it yields to one.
/// \param first   moves of the first body
/// \param second  moves of the second body
/// \param block   `lift` of its points and `ease` are overwritten
void begin_lift(const MovingBody& first, const MovingBody& second, ContactPatch& block);

/// Corrects targets where a body turns so far in a step that a point leaves its tangent: by what
/// the arc \f$(e^{[h\omega]} - 1)\,r\f$ leads further away than \f$h\,\omega\times r\f$.
/// \param first   how the first body would move
/// \param second  how the second one would
/// \param dt      [s] of the step
/// \param block   after set_targets(); targets and flat in and out
void follow_arcs(const MovingBody& first, const MovingBody& second, double dt, ContactPatch& block);

/// The motion of a block's bodies against each other.
/// \param block   the area
/// \param first   how the first body moves
/// \param second  how the second one does
/// \return in the area's frame
inline Six motion_of(const ContactPatch& block, const MovingBody& first, const MovingBody& second) {
  const Vec3 v = second.velocity_w + second.angular_velocity_w.cross(block.second_arm_w) -
                 first.velocity_w - first.angular_velocity_w.cross(block.first_arm_w);
  const Vec3 w = second.angular_velocity_w - first.angular_velocity_w;
  const auto& f = block.frame_w;
  return {f.col(0).dot(v), f.col(1).dot(v), f.col(2).dot(v),
          f.col(0).dot(w), f.col(1).dot(w), f.col(2).dot(w)};
}

/// All impulses of a block as one.
/// \param block the area
/// \return in the area's frame
inline Six impulse_of(const ContactPatch& block) {
  Six sum{block.along_impulse, block.across_impulse, 0.0, 0.0, 0.0, block.twist_impulse};
  for (std::size_t i = 0; i < static_cast<std::size_t>(block.count); ++i) {
    const ContactPatchPoint& p = block.points[i];
    sum[2] += p.impulse;
    sum[3] += p.impulse * p.across;
    sum[4] -= p.impulse * p.along;
  }
  return sum;
}

/// Applies impulses to the bodies of a block.
/// \param impulse  in the area's frame
/// \param block    the area
/// \param first    changed unless immovable
/// \param second   changed unless immovable
inline void apply(const Six& impulse, const ContactPatch& block, MovingBody& first,
                  MovingBody& second) {
  const auto& f = block.frame_w;
  const Vec3 force_w = impulse[0] * f.col(0) + impulse[1] * f.col(1) + impulse[2] * f.col(2);
  const Vec3 moment_w = impulse[3] * f.col(0) + impulse[4] * f.col(1) + impulse[5] * f.col(2);
  if (first.inverse_mass.x() > 0.0) {
    first.velocity_w -= first.inverse_mass.x() * force_w;
    first.angular_velocity_w -=
        first.inverse_inertia_w * (moment_w + block.first_arm_w.cross(force_w));
    first.changed = true;
  }
  if (second.inverse_mass.x() > 0.0) {
    second.velocity_w += second.inverse_mass.x() * force_w;
    second.angular_velocity_w +=
        second.inverse_inertia_w * (moment_w + block.second_arm_w.cross(force_w));
    second.changed = true;
  }
}

}  // namespace tumble
