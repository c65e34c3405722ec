/// \file
/// \brief The listing SETGEOMETRICALLYSTABLE as printed (thesis 5.4, A.2).
#include "tumble/geometric_stability/as_printed/set_geometrically_stable_as_printed.hpp"

#include "tumble/base/error.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/geometric_stability/support_polygon.hpp"
#include "tumble/geometric_stability/tolerances.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace tumble {

std::vector<PrintedContact> sort_contact_points_ascending(const World& world,
                                                          std::span<const Contact> contacts) {
  const auto height_of = [&](int body) {
    require::that(
        body >= 0 && body < world.count(),
        "contact of body " + std::to_string(body) + ": there are " + std::to_string(world.count()));
    return world.states()[static_cast<std::size_t>(body)].position_w.y();
  };
  std::vector<PrintedContact> sorted;
  for (const Contact& contact : contacts) {
    PrintedContact c{contact.second, contact.first, contact.normal_w, Vec3::Zero()};
    if (height_of(contact.first) > height_of(contact.second))
      c = {contact.first, contact.second, -contact.normal_w, Vec3::Zero()};
    for (int k = 0; k < contact.count; ++k) {
      c.point_w = contact.points[static_cast<std::size_t>(k)].position_w;
      sorted.push_back(c);
    }
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const PrintedContact& a, const PrintedContact& b) {
                     return a.point_w.y() < b.point_w.y();
                   });
  return sorted;
}

namespace {

// Erratum G8: two directions, or two points in the ground plane, are equal only if they are identical.
bool equivalent(const Vec3& direction_w, const Vec3& vertical_w, bool tolerant) {
  if (!tolerant) return direction_w == vertical_w;
  return direction_w.cross(vertical_w).norm() <= tolerance::vertical_normal &&
         direction_w.dot(vertical_w) > 0.0;
}

Vec2 project_xz_plane(const Vec3& point_w) { return {point_w.x(), point_w.z()}; }

// Marks the corners of a body above a point.
void mark_projected_corners(const World& world, int body, const Vec2& place, bool tolerant,
                            PrintedStability& o) {
  const auto index = static_cast<std::size_t>(body);
  const BodyProperties& properties = world.bodies()[index];
  if (properties.shape == Shape::ground) return;  // it has none
  const double reach = tolerant ? tolerance::corner_support * properties.size.minCoeff() : 0.0;
  const std::array<Vec2, 4> corners = lower_corners(box_of(properties, world.states()[index]));
  for (std::size_t k = 0; k < corners.size(); ++k)
    if ((corners[k] - place).norm() <= reach)
      o.corners = static_cast<std::uint8_t>(o.corners | (1U << k));
}

}  // namespace

void set_geometrically_stable_as_printed(const World& world, std::span<const Contact> contacts,
                                         const PrintedStabilityRepairs& repairs,
                                         std::span<PrintedStability> bodies) {
  require::that(bodies.size() == world.bodies().size(),
                "bodies: " + std::to_string(bodies.size()) + " entries for " +
                    std::to_string(world.count()) + " bodies");
  const auto of = [&](int body) -> PrintedStability& {
    return bodies[static_cast<std::size_t>(body)];
  };
  const auto immovable = [&](int body) {
    return !world.bodies()[static_cast<std::size_t>(body)].movable();
  };
  // Erratum G7: rising bodies are not excluded.
  const auto rises = [&](int body) {
    const Vec3& momentum_w = world.states()[static_cast<std::size_t>(body)].linear_momentum_w;
    return repairs.rising && momentum_w.y() > repairs.upward_momentum;
  };
  // Erratum G5: corners stay marked from the last step.
  if (repairs.fresh_corners)
    for (PrintedStability& o : bodies) o.corners = 0;

  // [SETGEOMETRICALLYSTABLE:1-5]
  // At first only bodies of infinite mass are stable.
  for (int o = 0; o < world.count(); ++o) {
    if (immovable(o)) {
      of(o).stable = true;
    } else {
      of(o).stable = false;
    }
  }
  // [SETGEOMETRICALLYSTABLE:1-5]
  // [SETGEOMETRICALLYSTABLE:6]
  // All contact points, the lowest first.
  const std::vector<PrintedContact> sorted = sort_contact_points_ascending(world, contacts);
  // [SETGEOMETRICALLYSTABLE:6]

  // Erratum G3 mended: vetoes are collected first.
  std::vector<bool> vetoed(bodies.size(), false);
  const auto clear = [&](int body) {
    // Erratum G4: also for an immovable body.
    if (repairs.immovable && immovable(body)) return;
    of(body).stable = false;
    if (repairs.vetoes_last) vetoed[static_cast<std::size_t>(body)] = true;
  };
  const Vec3 negative_y_axis = -Vec3::UnitY();
  const Vec3 positive_y_axis = Vec3::UnitY();
  if (repairs.vetoes_last) {
    for (const PrintedContact& c : sorted) {
      const Vec3 normal = -c.lower_to_upper_w;
      if (equivalent(normal, negative_y_axis, repairs.tolerances) ||
          equivalent(normal, positive_y_axis, repairs.tolerances))
        continue;
      clear(c.upper);
      if (repairs.both_bodies) clear(c.lower);
    }
  }

  // [SETGEOMETRICALLYSTABLE:7]
  // One after the other:
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    // [SETGEOMETRICALLYSTABLE:7]
    // [SETGEOMETRICALLYSTABLE:8-12]
    // the upper and the lower body, and the normal out of the upper one.
    const PrintedContact& c = sorted[i];
    const int top_index = c.upper;
    const int bot_index = c.lower;
    PrintedStability& o = of(top_index);
    const Vec3 outward_normal = -c.lower_to_upper_w;
    // [SETGEOMETRICALLYSTABLE:8-12]
    // [SETGEOMETRICALLYSTABLE:13]
    // On a stable body, straight below?
    if (equivalent(outward_normal, negative_y_axis, repairs.tolerances) && of(bot_index).stable) {
      // [SETGEOMETRICALLYSTABLE:13]
      // [SETGEOMETRICALLYSTABLE:14-15]
      // Mark the corner above this point.
      const Vec2 projected_contact_point = project_xz_plane(c.point_w);
      mark_projected_corners(world, top_index, projected_contact_point, repairs.tolerances, o);
      // [SETGEOMETRICALLYSTABLE:14-15]
      if (vetoed[static_cast<std::size_t>(top_index)] || rises(top_index)) continue;
      // [SETGEOMETRICALLYSTABLE:16-17]
      // The fourth one makes it stable.
      if (o.corners == kAllCorners) o.stable = true;
      // [SETGEOMETRICALLYSTABLE:16-17]
      // [SETGEOMETRICALLYSTABLE:18-20]
      // Otherwise it is unstable, unless the normal points straight up.
    } else {
      if (!equivalent(outward_normal, positive_y_axis, repairs.tolerances)) {
        clear(top_index);
        // [SETGEOMETRICALLYSTABLE:18-20]
        const bool vertical = equivalent(outward_normal, negative_y_axis, repairs.tolerances);
        if (repairs.both_bodies && !vertical) clear(bot_index);
      }
    }
  }
  // [SETGEOMETRICALLYSTABLE:21]
  return;
  // [SETGEOMETRICALLYSTABLE:21]
}

}  // namespace tumble
