/// \file
/// \brief Work of the impulses of contacts in a step.
#include "tumble/contact/impulse_work.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/effective_mass.hpp"

namespace tumble {

void book_impulses(std::span<const Contact> contacts, std::span<const MovingBody> before,
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

}  // namespace tumble
