/// \file
/// \brief Work of the impulses of contacts in a step.
#pragma once

#include "tumble/base/index.hpp"
#include "tumble/contact/contact.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/dynamics/technique.hpp"

#include <span>

namespace tumble {

/// Books the work of impulses: each times the mean of the velocities before and after all of them.
/// \param contacts  with their impulses
/// \param before    how bodies moved, one for each body index
/// \param after     how they move with the impulses, and with gravity if it acted
/// \param energy    restitution and friction are added
inline void book_impulses(std::span<const Contact> contacts, std::span<const MovingBody> before,
                          std::span<const MovingBody> after, BookedEnergy& energy) {
  for (const Contact& contact : contacts) {
    for (int k = 0; k < contact.count; ++k) {
      const ContactPoint& point = contact.points[idx(k)];
      const auto velocity_w = [&](std::span<const MovingBody> bodies) {
        return relative_velocity(bodies[idx(contact.first)], bodies[idx(contact.second)],
                                 point.position_w);
      };
      const Vec3 mean_w = 0.5 * (velocity_w(before) + velocity_w(after));
      energy.restitution += point.normal_impulse * contact.normal_w.dot(mean_w);
      energy.friction += point.friction_impulse_w.dot(mean_w);
    }
  }
}

/// Energy that a body gets by moving with the velocity of a step's end while its impulses are booked at the mean one:
/// \f$h\,g\cdot(p - p')/2\f$.
/// \param dt         [s] h
/// \param before_w   [kg m/s] p, its momentum at the start
/// \param after_w    [kg m/s] p', its momentum at the end
/// \return [J] below 0 for what merely falls
[[nodiscard]] inline double lift_at_end_velocity(const Vec3& gravity_w, double dt,
                                                 const Vec3& before_w, const Vec3& after_w) {
  return 0.5 * dt * gravity_w.dot(before_w - after_w);
}

}  // namespace tumble
