/// \file
/// \brief The listing FIXCONTACTCONSTRAINTS as it is printed (thesis 4.4, A.2).
#include "tumble/impulse_damped/as_printed/fix_contact_constraints_as_printed.hpp"

#include "tumble/base/error.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/dynamics/flight.hpp"
#include "tumble/geometric_stability/as_printed/set_geometrically_stable_as_printed.hpp"

#include <string>
#include <utility>
#include <vector>

namespace tumble {
namespace {

// How far two bodies are apart now, and the direction from the first to the second.
Separation gap_of(const World& world, int first, int second) {
  const auto a = static_cast<std::size_t>(first);
  const auto b = static_cast<std::size_t>(second);
  return gap_between(world.bodies()[a], world.states()[a], world.bodies()[b], world.states()[b]);
}

bool movable(const World& world, int body) {
  return world.bodies()[static_cast<std::size_t>(body)].movable();
}

// What the mended readings make of a contact: X1, the direction in which the bodies part now, and
// the upper one, as printed; X2, the body that moves is one that can be moved.
PrintedContact mended(const World& world, PrintedContact c, const DampedErrata& repaired) {
  if (repaired.has("X1")) {
    c.lower_to_upper_w = gap_of(world, c.lower, c.upper).normal_w;
    if (c.lower_to_upper_w.y() < 0.0) {
      std::swap(c.lower, c.upper);
      c.lower_to_upper_w = -c.lower_to_upper_w;
    }
  }
  if (repaired.has("X2") && !movable(world, c.upper) && movable(world, c.lower)) {
    std::swap(c.lower, c.upper);
    c.lower_to_upper_w = -c.lower_to_upper_w;
  }
  return c;
}

}  // namespace

PrintedFixReport fix_contact_constraints_as_printed(World& world, std::span<const Contact> contacts,
                                                    double eps1, std::int64_t cap,
                                                    const DampedErrata& repaired) {
  require::positive(eps1, "eps1");
  require::that(cap >= 1, "cap = " + std::to_string(cap) + ": give at least 1");
  PrintedFixReport report;
  const double before = energy_of(world).potential;
  const auto intersecting = [&](int first, int second) {
    ++report.pair_tests;
    return gap_of(world, first, second).distance < 0.0;
  };

  // [FIXCONTACTCONSTRAINTS:1]
  // All contact points, the lowest first.
  const std::vector<PrintedContact> sorted = sort_contact_points_ascending(world, contacts);
  // [FIXCONTACTCONSTRAINTS:1]
  // [FIXCONTACTCONSTRAINTS:2]
  // One after the other:
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    // [FIXCONTACTCONSTRAINTS:2]
    const PrintedContact contact = mended(world, sorted[i], repaired);
    // [FIXCONTACTCONSTRAINTS:3-5]
    // the upper body moves, the lower one stays; along the normal.
    const int moving_object = contact.upper;
    const int stable_object = contact.lower;
    const Vec3 offset_vector = contact.lower_to_upper_w;
    // [FIXCONTACTCONSTRAINTS:3-5]
    std::int64_t pushes = 0;
    // [FIXCONTACTCONSTRAINTS:6-7]
    // As long as they overlap, it goes on by a small distance.
    while (intersecting(moving_object, stable_object)) {
      Vec3& center = world.states()[static_cast<std::size_t>(moving_object)].position_w;
      center = center + offset_vector * eps1;
      // [FIXCONTACTCONSTRAINTS:6-7]
      ++report.pushes;
      // Erratum X1: nothing says that this ends.
      if (++pushes == cap) {
        report.ended = false;
        break;
      }
    }
  }
  report.energy = energy_of(world).potential - before;
  // [FIXCONTACTCONSTRAINTS:8]
  return report;
  // [FIXCONTACTCONSTRAINTS:8]
}

}  // namespace tumble
