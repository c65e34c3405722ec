/// \file
/// \brief The direct solver: its bodies and points, and its matrix.
#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/contact/graph.hpp"
#include "tumble/contact_damped/island_math.hpp"
#include "tumble/contact_damped/island_solver.hpp"
#include "tumble/contact_damped/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {

using island_math::motion_of, island_math::Spring, island_math::velocities_of,
    island_math::wrench_of;

namespace {

// Distributes the normal impulse of a patch over its points: the impulse of the last solution and an even share of
// the change since then. If a point would pull, the distribution of the sweeps.
std::array<double, ContactPatch::kMostPoints> point_pressures(const ContactPatch& patch,
                                                              const Six& since) {
  const auto count = idx(patch.count);
  std::array<double, ContactPatch::kMostPoints> pressure{};
  bool pushes = patch.spans_area;
  if (pushes) distribute_evenly(since, patch, pressure);
  const double none = tolerance::rounding * impulse_of(patch)[2];
  for (std::size_t i = 0; i < count && pushes; ++i) {
    const double before = patch.points[i].solver_impulse[2];
    pressure[i] = before == 0.0 && std::abs(pressure[i]) <= none ? 0.0 : before + pressure[i];
    pushes = pressure[i] >= 0.0;
  }
  for (std::size_t i = 0; i < count && !pushes; ++i) pressure[i] = patch.points[i].impulse;
  return pressure;
}

}  // namespace

void IslandSolver::load(const Island& island, std::span<const MovingBody> free, FrictionLaw law) {
  number_members(island);
  members_.clear();
  for (const int body : island.bodies) {
    const MovingBody& now = island.now[idx(body)];
    Member& member = members_.emplace_back();
    member.mass = member.load = 1.0 / now.inverse_mass.x();
    member.inertia_w = now.inverse_inertia_w.inverse();
    member.free = velocities_of(free[idx(body)]);
    member.now = velocities_of(now);
  }
  find_loads(island);
  constraints_.clear();
  points_.clear();
  joined_.clear();
  for (const int contact : island.patch_indices) {
    const ContactPatch& patch = island.all_patches[idx(contact)];
    if (asks_for_nothing(patch)) continue;
    Constraint& constraint = constraints_.emplace_back();
    constraint.patch = contact;
    constraint.first = member_of_[idx(patch.first)];
    constraint.second = member_of_[idx(patch.second)];
    if (constraint.first >= 0 && constraint.second >= 0) {
      constraint.pair = static_cast<int>(joined_.size());
      joined_.push_back({constraint.first, constraint.second});
    }
    constraint.begin = static_cast<int>(points_.size());
    double load =
        std::numeric_limits<double>::infinity();  // [kg] the smaller one of its two bodies
    for (const int member : {constraint.first, constraint.second})
      if (member >= 0) load = std::min(load, members_[idx(member)].load);
    load_points(patch, load, law);
    constraint.end = static_cast<int>(points_.size());
  }
  forget_members(island);
  x_.resize(members_.size());
  newton_start_.resize(members_.size());
  // Factorization takes square roots. In units of about a body's mass, scaling all masses by a power of two
  // leaves the same bits.
  int power = 0;
  std::frexp(members_.front().mass, &power);
  unit_mass_ = std::ldexp(1.0, -power);
}

// Numbers the bodies that are solved for, in member_of_. To be forgotten after use.
void IslandSolver::number_members(const Island& island) {
  member_of_.resize(island.now.size(), -1);
  int members = 0;
  for (const int body : island.bodies) member_of_[idx(body)] = members++;
}

void IslandSolver::forget_members(const Island& island) {
  for (const int body : island.bodies) member_of_[idx(body)] = -1;
}

// The heaviest body that each one may carry: itself, what rests on it, and what leans on it.
void IslandSolver::find_loads(const Island& island) {
  const double g = island.world.gravity_w.norm();
  const Vec3 up_w = g > 0.0 ? Vec3(-island.world.gravity_w / g) : Vec3::Zero();
  for (bool more = true; more;) {
    more = false;
    for (std::size_t k = island.upward.size(); k-- > 0;) {
      const ContactPatch& patch = island.all_patches[idx(island.upward[k])];
      const int first = member_of_[idx(patch.first)];
      const int second = member_of_[idx(patch.second)];
      if (first < 0 || second < 0) continue;
      const int direction = support_direction(patch.frame_w.col(2), up_w);
      double& on_first = members_[idx(first)].load;
      double& on_second = members_[idx(second)].load;
      if (direction >= 0 && on_first < on_second) {
        on_first = on_second;
        more = true;
      }
      if (direction <= 0 && on_second < on_first) {
        on_second = on_first;
        more = true;
      }
    }
  }
}

bool IslandSolver::costs_more_than(double most, const Island& island) {
  number_members(island);
  joined_.clear();
  for (const int contact : island.patch_indices) {
    const ContactPatch& patch = island.all_patches[idx(contact)];
    const int first = member_of_[idx(patch.first)];
    const int second = member_of_[idx(patch.second)];
    if (first >= 0 && second >= 0) joined_.push_back({first, second});
  }
  forget_members(island);
  matrix_.analyse(static_cast<int>(island.bodies.size()), joined_);
  return static_cast<double>(matrix_.multiplications_of_factor()) > most;
}

// Whether factors would, for each member. Finds out where they have entries, which factor() needs.
bool IslandSolver::costs_too_much(double max_work) {
  matrix_.analyse(static_cast<int>(members_.size()), joined_);
  return static_cast<double>(matrix_.multiplications_of_factor()) >
         max_work * static_cast<double>(members_.size());
}

// The points of a patch, each with its impulse of the last solution. Friction that was added since is distributed:
// each point gets a share in proportion to its pressure, and of the moment about the centre of pressure in
// proportion to its lever as well.
// Springs between light bodies are stiff enough for the heaviest body that they may carry.
void IslandSolver::load_points(const ContactPatch& patch, double load, FrictionLaw law) {
  const SixBySix& K = patch.inverse_mass;
  Six since = impulse_of(patch);
  for (const ContactPatchPoint& p : patch.used())
    add_push(p.along, p.across, -p.solver_impulse, since);
  const auto pressure = point_pressures(patch, since);
  double normal = 0.0, along = 0.0, across = 0.0, square = 0.0, far = 0.0;
  for (std::size_t i = 0; i < idx(patch.count); ++i) {
    const ContactPatchPoint& p = patch.points[i];
    normal += pressure[i];
    along += pressure[i] * p.along;
    across += pressure[i] * p.across;
    far += pressure[i] * (p.along * p.along + p.across * p.across);
  }
  if (normal > 0.0) {
    along /= normal;
    across /= normal;
  }
  for (std::size_t i = 0; i < idx(patch.count); ++i) {
    const ContactPatchPoint& p = patch.points[i];
    const double a = p.along - along;
    const double c = p.across - across;
    square += pressure[i] * (a * a + c * c);
  }
  const double moment = since[5] - (along * since[1] - across * since[0]);
  // A single point that pushes has no lever except rounding.
  const double turn = square > tolerance::rounding * far ? moment / square : 0.0;
  for (std::size_t i = 0; i < idx(patch.count); ++i) {
    const ContactPatchPoint& p = patch.points[i];
    if (std::isinf(p.target)) continue;
    Point& point = points_.emplace_back();
    point.place = i;
    point.along = p.along;
    point.across = p.across;
    point.target = p.target;
    point.friction = law == FrictionLaw::held ? 0.0 : patch.friction;
    point.inverse_mass = inverse_mass_at(K, p.along, p.across);
    point.inverse_mass = std::min(point.inverse_mass, tolerance::lightest_spring / load);
    if (!(pressure[i] > 0.0)) continue;
    const double share = pressure[i] / normal;
    double f = p.solver_impulse[0] + share * since[0] - turn * pressure[i] * (p.across - across);
    double g = p.solver_impulse[1] + share * since[1] + turn * pressure[i] * (p.along - along);
    const double size = std::sqrt(f * f + g * g);
    const double bound = point.friction * pressure[i];
    if (size > bound) {
      f *= bound / size;
      g *= bound / size;
    }
    point.impulse = {f, g, pressure[i]};
  }
}

// Relative motion of a patch at the present velocities.
Six IslandSolver::motion_now(const Constraint& constraint, const ContactPatch& patch) const {
  Six motion{};
  if (constraint.second >= 0)
    motion = motion_of(patch.frame_w, patch.second_arm_w, members_[idx(constraint.second)].now);
  if (constraint.first >= 0) {
    const Six other =
        motion_of(patch.frame_w, patch.first_arm_w, members_[idx(constraint.first)].now);
    for (std::size_t k = 0; k < 6; ++k) motion[k] -= other[k];
  }
  return motion;
}

// Classifies points as sliding or not, which the convex law does not need, and starts z from the velocities.
void IslandSolver::begin_iterations(std::span<const ContactPatch> patches, double unit_speed,
                                    FrictionLaw law) {
  stiffness_ = tolerance::admm_stiffness;
  first_residual_ = 0.0;
  for (Constraint& constraint : constraints_) {
    const Six motion = motion_now(constraint, patches[idx(constraint.patch)]);
    for (int i = constraint.begin; i < constraint.end; ++i) {
      Point& p = points_[idx(i)];
      Vec3 u = velocity_at(p.along, p.across, motion);
      u[2] -= p.target;
      const double speed = std::sqrt(u[0] * u[0] + u[1] * u[1]);
      p.slides =
          law == FrictionLaw::coulomb && speed > tolerance::slide_steps * p.friction * unit_speed;
      if (p.slides) {
        p.slip_direction = {u[0] / speed, u[1] / speed, 0.0};
        p.impulse.head<2>() = -p.friction * p.impulse[2] * p.slip_direction.head<2>();
        p.auxiliary = {0.0, 0.0, std::max(0.0, u[2])};
      } else {
        start_auxiliary(u, p);
      }
    }
  }
}

// M + J' D J and its factors. D is the stiffness of each point's spring, tangential and normal, or for Newton steps
// the derivative of its impulse.
void IslandSolver::factor(std::span<const ContactPatch> patches, bool newton) {
  matrix_.clear();
  for (std::size_t m = 0; m < members_.size(); ++m) {
    Mat6 own = Mat6::Zero();
    own.topLeftCorner<3, 3>().diagonal().setConstant(unit_mass_ * members_[m].mass);
    own.bottomRightCorner<3, 3>() = unit_mass_ * members_[m].inertia_w;
    matrix_.add_to(static_cast<int>(m), own);
  }
  for (const Constraint& constraint : constraints_) {
    const ContactPatch& patch = patches[idx(constraint.patch)];
    Spring spring;
    const Mat3& f = patch.frame_w;
    for (int i = constraint.begin; i < constraint.end; ++i) {
      const Point& p = points_[idx(i)];
      const double normal = stiffness_ / p.inverse_mass;
      const double tangential = p.slides ? 0.0 : normal;
      const Mat3 d =
          unit_mass_ * (newton ? Mat3(f * p.spring_slope * f.transpose())
                               : Mat3(tangential * Mat3::Identity() +
                                      (normal - tangential) * f.col(2) * f.col(2).transpose()));
      const Mat3 s = skew(p.along * f.col(0) + p.across * f.col(1));
      const Mat3 ds = d * s;
      spring.force_of_move += d;
      spring.force_of_turn -= ds;
      spring.moment_of_turn -= s * ds;
    }
    if (constraint.first >= 0)
      matrix_.add_to(constraint.first, spring.between(patch.first_arm_w, patch.first_arm_w));
    if (constraint.second >= 0)
      matrix_.add_to(constraint.second, spring.between(patch.second_arm_w, patch.second_arm_w));
    if (constraint.pair >= 0)
      matrix_.add_to_pair(constraint.pair, -spring.between(patch.first_arm_w, patch.second_arm_w));
  }
  matrix_.factor();
}

// Momenta without contacts.
void IslandSolver::begin_right_side() {
  for (std::size_t m = 0; m < members_.size(); ++m) {
    x_[m].head<3>() = members_[m].mass * members_[m].free.head<3>();
    x_[m].tail<3>() = members_[m].inertia_w * members_[m].free.tail<3>();
  }
}

void IslandSolver::add_to_right_side(const Constraint& constraint, const ContactPatch& patch,
                                     const Six& impulse) {
  if (constraint.first >= 0)
    x_[idx(constraint.first)] -= wrench_of(patch.frame_w, patch.first_arm_w, impulse);
  if (constraint.second >= 0)
    x_[idx(constraint.second)] += wrench_of(patch.frame_w, patch.second_arm_w, impulse);
}

void IslandSolver::solve_with_factors() {
  for (Vec6& x : x_) x *= unit_mass_;
  matrix_.solve(x_);
}

}  // namespace tumble
