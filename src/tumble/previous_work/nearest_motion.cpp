/// \file
/// \brief The motion nearest to a wanted one with which no contact point goes in.
#include "tumble/previous_work/nearest_motion.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/effective_mass.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

void NearestMotion::take(std::span<const MovingBody> bodies, std::span<const Contact> contacts,
                         std::span<const double> gaps) {
  bodies_ = bodies;
  rows_.clear();
  forces_.clear();
  for (const Contact& contact : contacts) {
    const MovingBody& a = bodies[idx(contact.first)];
    const MovingBody& b = bodies[idx(contact.second)];
    for (int k = 0; k < contact.count; ++k) {
      const ContactPoint& p = contact.points[idx(k)];
      Row row;
      row.first = contact.first;
      row.second = contact.second;
      row.normal_w = contact.normal_w;
      row.arm_first_w = (p.position_w - a.position_w).cross(contact.normal_w);
      row.arm_second_w = (p.position_w - b.position_w).cross(contact.normal_w);
      row.yield = 1.0 / effective_mass(a, b, p.position_w, contact.normal_w);
      row.constant =
          contact.normal_w.dot(relative_velocity(a, b, p.position_w)) + gaps[rows_.size()];
      rows_.push_back(row);
      forces_.push_back(std::max(0.0, p.normal_impulse));
    }
  }
}

// [S2.7:multiply]
// What forces change of the motions of all bodies.
void NearestMotion::push(std::span<const double> f) {
  linear_w_.assign(bodies_.size(), Vec3::Zero());
  angular_w_.assign(bodies_.size(), Vec3::Zero());
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const Row& row = rows_[k];
    linear_w_[idx(row.first)] -= f[k] * row.normal_w;
    linear_w_[idx(row.second)] += f[k] * row.normal_w;
    angular_w_[idx(row.first)] -= f[k] * row.arm_first_w;
    angular_w_[idx(row.second)] += f[k] * row.arm_second_w;
  }
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    linear_w_[b] = bodies_[b].inverse_mass.cwiseProduct(linear_w_[b]);
    angular_w_[b] = bodies_[b].inverse_inertia_w * angular_w_[b];
  }
}

// And with that of the motions of all points: A f.
void NearestMotion::multiply(std::span<const double> f, std::span<double> out) {
  push(f);
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const Row& row = rows_[k];
    out[k] = row.normal_w.dot(linear_w_[idx(row.second)] - linear_w_[idx(row.first)]) +
             row.arm_second_w.dot(angular_w_[idx(row.second)]) -
             row.arm_first_w.dot(angular_w_[idx(row.first)]);
  }
}
// [S2.7:multiply]

void NearestMotion::allow(std::span<double> f) {
  for (double& x : f) x = std::max(0.0, x);
}

DescentReport NearestMotion::solve(std::span<MovingBody> bodies, std::span<Contact> contacts,
                                   std::span<const double> gaps, double wanted, int budget) {
  take(bodies, contacts, gaps);
  double first = 0.0;
  for (const Row& row : rows_) {
    const double sinks = std::min(0.0, row.constant);
    first += sinks * sinks / row.yield;
  }
  const DescentReport report = descent_.solve(*this, forces_, wanted * std::sqrt(first), budget);
  multiplications_ += static_cast<std::int64_t>(report.products) *
                      static_cast<std::int64_t>(rows_.size() * rows_.size());
  push(forces_);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    bodies[b].velocity_w += linear_w_[b];
    bodies[b].angular_velocity_w += angular_w_[b];
    bodies[b].changed = true;
  }
  std::size_t next = 0;
  for (Contact& contact : contacts)
    for (int k = 0; k < contact.count; ++k) contact.points[idx(k)].normal_impulse = forces_[next++];
  return report;
}

}  // namespace tumble
