/// \file
/// \brief Contact with friction by sweeps over the points.
#include "tumble/analytic_lcp/friction_sweeps.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/effective_mass.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

constexpr double kRunsAway = 1000.0;  // times the least change so far: it will not settle

}  // namespace

FrictionSweepReport FrictionSweeps::solve(std::span<const MovingBody> bodies,
                                          std::span<const Contact> contacts,
                                          std::span<const FrictionPoint> points, double wanted,
                                          std::span<Vec3> pushes) {
  bodies_.assign(bodies.begin(), bodies.end());
  load(contacts, points, pushes);
  const auto visits = static_cast<std::int64_t>(std::max<std::size_t>(rows_.size(), 1));
  const auto most =
      static_cast<int>(std::clamp<std::int64_t>(kMostVisits / visits, kLeastSweeps, kMostSweeps));
  FrictionSweepReport report{.error = std::numeric_limits<double>::infinity()};
  double slope = 0.0;
  while (report.sweeps < most) {
    double change = 0.0;
    for (Row& row : rows_) change = std::max(change, settle(row));
    ++report.sweeps;
    if (change < report.error) {
      report.error = change;
      for (Row& row : rows_) row.closest_w = row.push_w;
    }
    if (report.error <= wanted || !(change <= kRunsAway * report.error)) break;
    slope = go_on(slope);
  }
  for (std::size_t i = 0; i < pushes.size(); ++i) pushes[i] = rows_[i].closest_w;
  return report;
}

void FrictionSweeps::load(std::span<const Contact> contacts, std::span<const FrictionPoint> points,
                          std::span<const Vec3> pushes) {
  rows_.clear();
  for (const FrictionPoint& point : points) {
    const Contact& contact = contacts[idx(point.contact)];
    Row& row = rows_.emplace_back();
    row.first = contact.first;
    row.second = contact.second;
    row.place_w = contact.points[idx(point.point)].position_w;
    row.normal_w = contact.normal_w;
    row.constant = point.normal_constant;
    row.friction = point.rough ? contact.friction : 0.0;
    const MovingBody& first = bodies_[idx(row.first)];
    const MovingBody& second = bodies_[idx(row.second)];
    row.free_w = relative_velocity(first, second, row.place_w);
    row.yield_w = inverse_mass_at(first, second, row.place_w);
    row.normal_yield = row.normal_w.dot(row.yield_w * row.normal_w);
    const Tangents tangents = tangents_of(row.normal_w);
    Eigen::Matrix<double, 3, 2> plane;
    plane << tangents.first_w, tangents.second_w;
    const Eigen::Matrix2d yield = plane.transpose() * row.yield_w * plane;
    row.stop_w = plane * yield.inverse() * plane.transpose();
    const double half = 0.5 * (yield(0, 0) - yield(1, 1));
    row.slip_yield = 0.5 * yield.trace() + std::sqrt(half * half + yield(0, 1) * yield(0, 1));
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) push(rows_[i], pushes[i]);
}

// Changes the push of a point.
void FrictionSweeps::push(Row& row, const Vec3& change_w) {
  row.push_w += change_w;
  apply_impulse(bodies_[idx(row.first)], bodies_[idx(row.second)], row.place_w, change_w);
}

// [S2.6.3:sweeps]
// One point by itself. Returns how much its motion changes, in m/s.
double FrictionSweeps::settle(Row& row) {
  row.before_w = row.push_w;
  const Vec3& n = row.normal_w;
  if (!(row.normal_yield > 0.0)) return 0.0;
  const Vec3 u = relative_velocity(bodies_[idx(row.first)], bodies_[idx(row.second)], row.place_w);
  const double was = n.dot(row.push_w);
  const double sinks = n.dot(u - row.free_w) + row.constant;
  const double pressed = std::max(0.0, was - sinks / row.normal_yield);
  const Vec3 rubbed_w = across(row.push_w, n);
  Vec3 rubs_w = Vec3::Zero();
  if (row.friction > 0.0 && pressed > 0.0) {
    const Vec3 slip = across(Vec3(u + (pressed - was) * (row.yield_w * n)), n);
    const double limit = row.friction * pressed;
    rubs_w = rubbed_w - row.stop_w * slip;
    if (rubs_w.norm() > limit) {
      rubs_w = rubbed_w - slip / row.slip_yield;
      const double size = rubs_w.norm();
      if (size > limit) rubs_w *= limit / size;
    }
  }
  const Vec3 change_w = (pressed - was) * n + (rubs_w - rubbed_w);
  push(row, change_w);
  return std::max(std::abs(pressed - was) * row.normal_yield,
                  (rubs_w - rubbed_w).norm() * row.slip_yield);
}
// [S2.6.3:sweeps]

// Along the conjugate direction of Fletcher and Reeves, with the change of a sweep for the slope. Takes and
// returns the square of that, as an energy.
double FrictionSweeps::go_on(double slope_before) {
  double slope = 0.0;
  for (const Row& row : rows_)
    slope += row.normal_yield * (row.push_w - row.before_w).squaredNorm();
  const bool turns = !(slope <= slope_before);
  const double share = turns ? 0.0 : slope / slope_before;
  for (Row& row : rows_) {
    const Vec3 change_w = row.push_w - row.before_w;
    const Vec3 further_w = share * row.way_w;
    row.way_w = further_w + change_w;
    if (share > 0.0) push(row, further_w);
  }
  return slope;
}

}  // namespace tumble
