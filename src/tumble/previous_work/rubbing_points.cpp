/// \file
/// \brief Contact points with friction as unknowns of an iteration.
#include "tumble/previous_work/rubbing_points.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/effective_mass.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

double pushed_energy(std::span<const Contact> contacts) {
  double sum = 0.0;
  for (const Contact& contact : contacts)
    for (int k = 0; k < contact.count; ++k)
      sum +=
          contact.points[idx(k)].normal_impulse * std::abs(contact.points[idx(k)].approach_speed);
  return sum;
}

void RubbingPoints::take(std::span<const MovingBody> bodies, std::span<const Contact> contacts,
                         std::span<const double> least) {
  bodies_ = bodies;
  rows_.clear();
  yield_.clear();
  constant_.clear();
  impulses_.clear();
  limits_.clear();
  for (const Contact& contact : contacts) {
    const MovingBody& a = bodies[idx(contact.first)];
    const MovingBody& b = bodies[idx(contact.second)];
    const Tangents tangents = tangents_of(contact.normal_w);
    for (int k = 0; k < contact.count; ++k) {
      const ContactPoint& p = contact.points[idx(k)];
      Row row;
      row.first = contact.first;
      row.second = contact.second;
      row.friction = contact.friction;
      row.axis_w = {contact.normal_w, tangents.first_w, tangents.second_w};
      const Vec3 motion_w = relative_velocity(a, b, p.position_w);
      const Mat3 yield_w = inverse_mass_at(a, b, p.position_w);
      std::array<double, 3> yield{};
      for (std::size_t i = 0; i < 3; ++i) {
        row.arm_first_w[i] = (p.position_w - a.position_w).cross(row.axis_w[i]);
        row.arm_second_w[i] = (p.position_w - b.position_w).cross(row.axis_w[i]);
        yield[i] = row.axis_w[i].dot(yield_w * row.axis_w[i]);
        constant_.push_back(row.axis_w[i].dot(motion_w));
      }
      // The mean, so that nothing depends on the choice of directions.
      yield[1] = yield[2] = 0.5 * (yield[1] + yield[2]);
      yield_.insert(yield_.end(), yield.begin(), yield.end());
      constant_[impulses_.size()] -= least[rows_.size()];
      rows_.push_back(row);
      impulses_.push_back(p.normal_impulse);
      impulses_.push_back(p.friction_impulse_w.dot(tangents.first_w));
      impulses_.push_back(p.friction_impulse_w.dot(tangents.second_w));
    }
  }
}

// [S2.6.4:multiply]
// What impulses change of the bodies' velocities, and these of the motions of all points.
void RubbingPoints::multiply(std::span<const double> p, std::span<double> out) {
  linear_w_.assign(bodies_.size(), Vec3::Zero());
  angular_w_.assign(bodies_.size(), Vec3::Zero());
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const Row& row = rows_[k];
    Vec3 first_w = linear_w_[idx(row.first)], second_w = linear_w_[idx(row.second)];
    Vec3 turns_first_w = angular_w_[idx(row.first)], turns_second_w = angular_w_[idx(row.second)];
    for (std::size_t i = 0; i < 3; ++i) {
      const double impulse = p[3 * k + i];
      if (impulse == 0.0) continue;
      first_w -= impulse * row.axis_w[i];
      second_w += impulse * row.axis_w[i];
      turns_first_w -= impulse * row.arm_first_w[i];
      turns_second_w += impulse * row.arm_second_w[i];
    }
    linear_w_[idx(row.first)] = first_w;
    linear_w_[idx(row.second)] = second_w;
    angular_w_[idx(row.first)] = turns_first_w;
    angular_w_[idx(row.second)] = turns_second_w;
  }
  yield(linear_w_, angular_w_);
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const Row& row = rows_[k];
    const Vec3 linear_w = linear_w_[idx(row.second)] - linear_w_[idx(row.first)];
    const Vec3 second_w = angular_w_[idx(row.second)], first_w = angular_w_[idx(row.first)];
    for (std::size_t i = 0; i < 3; ++i)
      out[3 * k + i] = row.axis_w[i].dot(linear_w) + row.arm_second_w[i].dot(second_w) -
                       row.arm_first_w[i].dot(first_w);
  }
}
// [S2.6.4:multiply]

void RubbingPoints::yield(std::span<Vec3> linear_w, std::span<Vec3> angular_w) {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    linear_w[b] = bodies_[b].inverse_mass.cwiseProduct(linear_w[b]);
    angular_w[b] = bodies_[b].inverse_inertia_w * angular_w[b];
  }
}

void RubbingPoints::allow(std::span<double> p) const {
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    p[3 * k] = std::max(p[3 * k], 0.0);
    const double most = limits_.empty() ? rows_[k].friction * p[3 * k] : limits_[k];
    const double rubs = std::sqrt(p[3 * k + 1] * p[3 * k + 1] + p[3 * k + 2] * p[3 * k + 2]);
    if (!(rubs > most)) continue;
    const double share = most / rubs;
    p[3 * k + 1] *= share;
    p[3 * k + 2] *= share;
  }
}

void RubbingPoints::fix_limits(bool rubs) {
  limits_.clear();
  for (std::size_t k = 0; k < rows_.size(); ++k)
    limits_.push_back(rubs ? rows_[k].friction * impulses_[3 * k] : 0.0);
}

void RubbingPoints::end_limits() {
  limits_.clear();
  allow(impulses_);
}

bool RubbingPoints::lifts(double share) {
  image_.resize(impulses_.size());
  multiply(impulses_, image_);
  double fastest = 0.0, lift = 0.0;
  for (std::size_t i = 0; i < impulses_.size(); ++i) {
    fastest = std::max(fastest, std::abs(constant_[i]));
    if (i % 3 == 0 && impulses_[i] > 0.0) lift = std::max(lift, image_[i] + constant_[i]);
  }
  return lift > share * fastest;
}

double RubbingPoints::first_step() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < size(); i += 3) {
    const double sinks = std::min(constant_[i], 0.0);
    sum += sinks * sinks / yield_[i];
  }
  return std::sqrt(sum);
}

void RubbingPoints::require_no_energy() {
  allow(impulses_);
  image_.resize(impulses_.size());
  multiply(impulses_, image_);
  double energy = 0.0;
  for (std::size_t i = 0; i < impulses_.size(); ++i)
    energy += impulses_[i] * (0.5 * image_[i] + constant(i));
  if (!(energy <= 0.0)) std::fill(impulses_.begin(), impulses_.end(), 0.0);
}

Vec3 RubbingPoints::impulse_w(std::size_t row) const {
  const Row& r = rows_[row];
  return impulses_[3 * row] * r.axis_w[0] + impulses_[3 * row + 1] * r.axis_w[1] +
         impulses_[3 * row + 2] * r.axis_w[2];
}

void RubbingPoints::push(std::span<Contact> contacts, std::span<MovingBody> bodies) const {
  std::size_t row = 0;
  for (Contact& contact : contacts) {
    for (int k = 0; k < contact.count; ++k, ++row) {
      ContactPoint& p = contact.points[idx(k)];
      const Vec3 impulse = impulse_w(row);
      p.normal_impulse = impulse.dot(contact.normal_w);
      p.friction_impulse_w = impulse - p.normal_impulse * contact.normal_w;
      if (p.normal_impulse > 0.0)
        apply_impulse(bodies[idx(contact.first)], bodies[idx(contact.second)], p.position_w,
                      impulse);
    }
  }
}

}  // namespace tumble
