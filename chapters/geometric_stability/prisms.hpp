/// \file
/// \brief Prisms on blocks, for which a hull can decide and four corners cannot (thesis 5.4).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/geometric_stability/geometrically_stable.hpp"
#include "tumble/geometric_stability/support_polygon.hpp"

#include "driver/experiment.hpp"
#include "geometric_stability/pile_builder.hpp"

namespace tumble::chapters {

// A body that is no box, on blocks.
struct PrismOnBlocks {
  World world;           // ground, blocks, and last the prism
  ContactList contacts;  // of the blocks with the ground, and of the prism with the blocks
  std::vector<GeometricStability::Outline> outlines;  // by body index; that of a box is empty
  int prism = 0;                                      // index of the prism
};

inline constexpr double kBlock = 0.5;   // [m] height of the blocks
inline constexpr double kRadius = 1.0;  // [m] from the prism's axis to its corners
inline constexpr double kHeight = 0.5;  // [m] of the prism

inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// The second moment of a regular polygon is the same about every line through its middle, so two numbers
// make up the inertia.
inline BodyProperties prism_properties(int sides) {
  BodyProperties body = box_properties(Vec3(2.0 * kRadius, kHeight, 2.0 * kRadius), 1.0);
  const double s = elementary::sin(std::numbers::pi / sides);
  const double about_axis = 0.5 * body.mass * kRadius * kRadius * (1.0 - 2.0 / 3.0 * s * s);
  const double across = 0.5 * about_axis + body.mass * kHeight * kHeight / 12.0;
  body.inertia_b = Vec3(across, about_axis, across);
  body.inverse_inertia_b = body.inertia_b.cwiseInverse();
  return body;
}

inline std::vector<Vec2> regular_polygon(int sides, double turn) {
  std::vector<Vec2> corners;
  for (int k = 0; k < sides; ++k) {
    const double angle = turn + 2.0 * std::numbers::pi * k / sides;
    corners.emplace_back(kRadius * elementary::cos(angle), kRadius * elementary::sin(angle));
  }
  return corners;
}

// Blocks near the corners; one that would overlap another is left out.
inline World blocks_under(const std::vector<Vec2>& outline, Random& random) {
  PileBuilder builder;
  for (const Vec2& corner : outline) {
    const double x = corner.x() + random.uniform(-0.3, 0.3) * corner.x();
    const double z = corner.y() + random.uniform(-0.3, 0.3) * corner.y();
    const double width = random.uniform(0.3, 0.8);
    const double depth = random.uniform(0.3, 0.8);
    const double turn = random.uniform(0.0, std::numbers::pi);
    const BodyProperties block = box_properties(Vec3(width, kBlock, depth), 1.0);
    builder.add(block, make_state(block, Vec3(x, 0.5 * kBlock, z),
                                  rotation_from_vector(Vec3(0.0, turn, 0.0))));
  }
  return builder.world();
}

// The intersection of two convex polygons (Sutherland and Hodgman).
// polygon: [m] counterclockwise
// window: [m] counterclockwise
inline std::vector<Vec2> common_area(std::vector<Vec2> polygon, const std::vector<Vec2>& window) {
  std::vector<Vec2> kept;
  for (std::size_t k = 0; k < window.size() && !polygon.empty(); ++k) {
    const Vec2& a = window[k];
    const Vec2 edge = window[(k + 1) % window.size()] - a;
    kept.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2& p = polygon[i];
      const Vec2& q = polygon[(i + 1) % polygon.size()];
      const double of_p = cross(edge, p - a);
      const double of_q = cross(edge, q - a);
      if (of_p >= 0.0) kept.push_back(p);
      if ((of_p > 0.0 && of_q < 0.0) || (of_p < 0.0 && of_q > 0.0))
        kept.push_back(p + of_p / (of_p - of_q) * (q - p));
    }
    polygon.swap(kept);
  }
  return polygon;
}

// A regular prism that stands upright on blocks of one height near its corners, each of which may miss
// its corner or be missing.
//
// The library knows boxes only. Here the prism is a body as large as the box around it, with the
// inertia of a prism, an outline of its own, and contact points at the corners of the areas in
// which the outline and the tops of blocks overlap.
inline PrismOnBlocks random_prism(int sides, Random& random) {
  const std::vector<Vec2> outline = regular_polygon(sides, random.uniform(0.0, std::numbers::pi));
  PrismOnBlocks scene{blocks_under(outline, random), {}, {}, 0};
  scene.contacts = touching(scene.world);
  scene.prism = scene.world.count();
  const BodyProperties body = prism_properties(sides);
  const BodyId id = scene.world.add(body, Vec3(0.0, kBlock + 0.5 * kHeight, 0.0));
  for (int k = 1; k < scene.prism; ++k) {
    const auto b = idx(k);
    const std::array<Vec2, 4> corners =
        lower_corners(box_of(scene.world.bodies()[b], scene.world.states()[b]));
    std::vector<Vec2> points(corners.begin(), corners.end());
    std::vector<Vec2> top;
    convex_hull(points, top);
    const std::vector<Vec2> area = common_area(outline, top);
    Contact contact{
        .first_id = scene.world.ids()[b], .second_id = id, .first = k, .second = scene.prism};
    for (const Vec2& xz : area)
      if (contact.count < Manifold::kMostPoints)
        contact.points[static_cast<std::size_t>(contact.count++)].position_w =
            Vec3(xz.x(), kBlock, xz.y());
    if (contact.count > 0) scene.contacts.push_back(contact);
  }
  scene.outlines.resize(scene.world.bodies().size());
  scene.outlines.back() = outline;
  return scene;
}

}  // namespace tumble::chapters
