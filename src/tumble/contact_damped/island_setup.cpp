/// \file
/// \brief All contact areas of a island together: what is solved, and its matrix.
#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/contact_damped/island_parts.hpp"
#include "tumble/contact_damped/island_solver.hpp"
#include "tumble/contact_damped/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

using island::add_push, island::into_cone, island::motion_at, island::motion_of, island::Spring,
    island::velocities_of;

void IslandSolver::load(std::span<const int> members, std::span<const int> contacts,
                        std::span<const MovingBody> free, std::span<const ContactPatch> blocks,
                        std::span<const MovingBody> bodies) {
  member_of_.assign(bodies.size(), -1);
  members_.clear();
  wanted_stamps_.clear();
  for (const int body : members) {
    member_of_[at(body)] = static_cast<int>(members_.size());
    Member& member = members_.emplace_back();
    member.mass = 1.0 / bodies[at(body)].inverse_mass.x();
    member.inertia_w = bodies[at(body)].inverse_inertia_w.inverse();
    member.free = velocities_of(free[at(body)]);
    member.now = velocities_of(bodies[at(body)]);
  }
  areas_.clear();
  points_.clear();
  joined_.clear();
  for (const int contact : contacts) {
    const ContactPatch& block = blocks[at(contact)];
    Area& area = areas_.emplace_back();
    area.block = contact;
    area.first = member_of_[at(block.first)];
    area.second = member_of_[at(block.second)];
    if (area.first >= 0 && area.second >= 0) {
      area.pair = static_cast<int>(joined_.size());
      joined_.push_back({area.first, area.second});
    }
    area.begin = static_cast<int>(points_.size());
    load_points(block);
    area.end = static_cast<int>(points_.size());
    wanted_stamps_.push_back(block.stamp);
  }
  x_.resize(members_.size());
  from_.resize(members_.size());
  // Factoring takes roots. With masses of about 1, those times a power of two leave the same bits.
  int power = 0;
  std::frexp(members_.front().mass, &power);
  unit_mass_ = std::ldexp(1.0, -power);
}

// How much of the normal impulse each point of an area bears: what it was given and an even share of what has
// come since. Where that would pull, what sweeps have left.
std::array<double, ContactPatch::kMostPoints> IslandSolver::pressures_of(const ContactPatch& block,
                                                                         const Six& since) {
  const auto count = at(block.count);
  std::array<double, ContactPatch::kMostPoints> pressure{};
  bool pushes = block.spreads;
  if (pushes) spread_evenly(since, block, pressure);
  const double none = tolerance::rounding * impulse_of(block)[2];
  for (std::size_t i = 0; i < count && pushes; ++i) {
    const double given = block.points[i].given[2];
    pressure[i] = given == 0.0 && std::abs(pressure[i]) <= none ? 0.0 : given + pressure[i];
    pushes = pressure[i] >= 0.0;
  }
  for (std::size_t i = 0; i < count && !pushes; ++i) pressure[i] = block.points[i].impulse;
  return pressure;
}

// The points of an area, each with what it was given when the area was last solved. Friction that has come
// since is shared out: each point gets the share of its pressure, and what turns the area about the centre
// of pressure in proportion to the lever too.
void IslandSolver::load_points(const ContactPatch& block) {
  const SixBySix& K = block.inverse_mass;
  Six since = impulse_of(block);
  for (std::size_t i = 0; i < at(block.count); ++i)
    add_push(block.points[i].along, block.points[i].across, -block.points[i].given, since);
  const auto pressure = pressures_of(block, since);
  double normal = 0.0, along = 0.0, across = 0.0, square = 0.0, far = 0.0;
  for (std::size_t i = 0; i < at(block.count); ++i) {
    const ContactPatchPoint& p = block.points[i];
    normal += pressure[i];
    along += pressure[i] * p.along;
    across += pressure[i] * p.across;
    far += pressure[i] * (p.along * p.along + p.across * p.across);
  }
  if (normal > 0.0) {
    along /= normal;
    across /= normal;
  }
  for (std::size_t i = 0; i < at(block.count); ++i) {
    const ContactPatchPoint& p = block.points[i];
    const double a = p.along - along;
    const double c = p.across - across;
    square += pressure[i] * (a * a + c * c);
  }
  const double moment = since[5] - (along * since[1] - across * since[0]);
  // A single point that pushes has no lever but rounding.
  const double turn = square > tolerance::rounding * far ? moment / square : 0.0;
  for (std::size_t i = 0; i < at(block.count); ++i) {
    const ContactPatchPoint& p = block.points[i];
    Point& point = points_.emplace_back();
    point.along = p.along;
    point.across = p.across;
    point.target = p.target;
    point.friction = block.friction;
    point.yield = K[2][2] + 2.0 * (p.across * K[2][3] - p.along * K[2][4]) +
                  p.across * p.across * K[3][3] - 2.0 * p.across * p.along * K[3][4] +
                  p.along * p.along * K[4][4];
    if (!(pressure[i] > 0.0)) continue;
    const double share = pressure[i] / normal;
    double f = p.given[0] + share * since[0] - turn * pressure[i] * (p.across - across);
    double g = p.given[1] + share * since[1] + turn * pressure[i] * (p.along - along);
    const double size = std::sqrt(f * f + g * g);
    const double bound = block.friction * pressure[i];
    if (size > bound) {
      f *= bound / size;
      g *= bound / size;
    }
    point.pushed = {f, g, pressure[i]};
  }
}

// Motion of an area at the present velocities.
Six IslandSolver::motion_now(const Area& area, const ContactPatch& block) const {
  Six motion{};
  if (area.second >= 0)
    motion = motion_of(block.frame_w, block.second_arm_w, members_[at(area.second)].now);
  if (area.first >= 0) {
    const Six other = motion_of(block.frame_w, block.first_arm_w, members_[at(area.first)].now);
    for (std::size_t k = 0; k < 6; ++k) motion[k] -= other[k];
  }
  return motion;
}

// z of the velocities at the start, and which points slide.
void IslandSolver::start_from(std::span<const ContactPatch> blocks, double unit) {
  for (Area& area : areas_) {
    const Six motion = motion_now(area, blocks[at(area.block)]);
    for (int i = area.begin; i < area.end; ++i) {
      Point& p = points_[at(i)];
      const double rho = stiffness_ / p.yield;
      Vec3 u = motion_at(p.along, p.across, motion);
      u[2] -= p.target;
      const double speed = std::sqrt(u[0] * u[0] + u[1] * u[1]);
      p.slides = speed > tolerance::island_slides * p.friction * unit;
      wanted_stamps_.push_back(p.slides ? 1 : 0);
      if (p.slides) {
        p.slip = {u[0] / speed, u[1] / speed, 0.0};
        p.pushed.head<2>() = -p.friction * p.pushed[2] * p.slip.head<2>();
        p.reached = {0.0, 0.0, std::max(0.0, u[2])};
      } else {
        p.reached = u + (into_cone(p.pushed - rho * u, p.friction) - p.pushed) / rho;
      }
    }
  }
}

// M + J' D J and its factors, with the springs' stiffness across and along the normal of each point, or for
// hard springs as they follow.
void IslandSolver::factor(std::span<const ContactPatch> blocks, bool soft) {
  matrix_.clear();
  for (std::size_t m = 0; m < members_.size(); ++m) {
    Mat6 own = Mat6::Zero();
    own.topLeftCorner<3, 3>().diagonal().setConstant(unit_mass_ * members_[m].mass);
    own.bottomRightCorner<3, 3>() = unit_mass_ * members_[m].inertia_w;
    matrix_.add_to(static_cast<int>(m), own);
  }
  for (const Area& area : areas_) {
    const ContactPatch& block = blocks[at(area.block)];
    Spring spring{Mat3::Zero(), Mat3::Zero(), Mat3::Zero()};
    const Mat3& f = block.frame_w;
    for (int i = area.begin; i < area.end; ++i) {
      const Point& p = points_[at(i)];
      const double across = p.slides ? 0.0 : stiffness_ / p.yield;
      const double along = stiffness_ / p.yield;
      const Mat3 d = unit_mass_ * (soft ? Mat3(across * Mat3::Identity() +
                                               (along - across) * f.col(2) * f.col(2).transpose())
                                        : Mat3(f * p.follows * f.transpose()));
      const Mat3 s = skew(p.along * f.col(0) + p.across * f.col(1));
      const Mat3 ds = d * s;
      spring.force_of_move += d;
      spring.force_of_turn -= ds;
      spring.moment_of_turn -= s * ds;
    }
    if (area.first >= 0)
      matrix_.add_to(area.first, spring.between(block.first_arm_w, block.first_arm_w));
    if (area.second >= 0)
      matrix_.add_to(area.second, spring.between(block.second_arm_w, block.second_arm_w));
    if (area.pair >= 0)
      matrix_.add_to_pair(area.pair, -spring.between(block.first_arm_w, block.second_arm_w));
  }
  matrix_.factor();
}

void IslandSolver::factor_if_changed(std::span<const ContactPatch> blocks, IslandResult& result) {
  if (factored_stiffness_ == stiffness_ && stamps_ == wanted_stamps_) return;
  stamps_ = wanted_stamps_;
  factored_stiffness_ = stiffness_;
  ++result.factorings;
  factor(blocks, true);
}

}  // namespace tumble
