/// \file
/// \brief Structures from the side, and how they start to move, as tables for gnuplot.
#pragma once

#include "tumble/dynamics/wrench.hpp"

#include "driver/experiment.hpp"
#include "geometric_stability/pile_forces.hpp"

namespace tumble::chapters {

// A table of boxes seen along z.
inline Table boxes_table() {
  return {"boxes",
          {{"view", "-", "in which drawing"},
           {"x_m", "m", "centre, to the right"},
           {"y_m", "m", "centre, up"},
           {"width_m", "m", "along x"},
           {"height_m", "m", "along y"},
           {"role", "-", "0: support; 1: stays; 2: starts to move"}}};
}

// [-] Share of the fastest corner below which a box counts as one that stays.
inline constexpr double kStays = 1e-6;

inline double fastest_body(const World& world, std::span<const Acceleration> motion) {
  double fastest = 0.0;
  for (std::size_t b = 0; b < motion.size(); ++b)
    if (world.bodies()[b].movable())
      fastest = std::max(fastest, fastest_of(world.bodies()[b], motion[b]));
  return fastest;
}

// Adds the boxes of a world.
inline void add_boxes(const World& world, double view, std::span<const Acceleration> motion,
                      Table& table) {
  const double fastest = fastest_body(world, motion);
  for (std::size_t b = 0; b < world.bodies().size(); ++b) {
    const BodyProperties& body = world.bodies()[b];
    if (body.shape != Shape::box) continue;
    double role = body.movable() ? 1.0 : 0.0;
    if (!motion.empty() && body.movable() && fastest_of(body, motion[b]) > kStays * fastest)
      role = 2.0;
    const Vec3& p = world.states()[b].position_w;
    table.add(view, p.x(), p.y(), body.size.x(), body.size.y(), role);
  }
}

// Start of a motion of boxes, seen along z.
struct StartOfMotion {
  Table outlines;     // "outlines": edges of the boxes a moment later, as vectors
  Table arrows;       // "arrows": from each centre that moves, along its way, longer
  double time = 0.0;  // [s] that moment: the way of a point is a t²/2
};

// Draws the start of a motion from rest.
// way: [m] of the fastest corner until the moment that is drawn
inline StartOfMotion start_of_motion(const World& world, std::span<const Acceleration> motion,
                                     double way) {
  constexpr double longer = 4.0;  // [-] arrows over the way of their centres
  StartOfMotion start{{"outlines",
                       {{"x_m", "m", "from"},
                        {"y_m", "m", "from"},
                        {"dx_m", "m", "along the edge"},
                        {"dy_m", "m", "along the edge"}}},
                      {"arrows",
                       {{"x_m", "m", "centre"},
                        {"y_m", "m", "centre"},
                        {"dx_m", "m", "four times its way until then"},
                        {"dy_m", "m", "four times its way until then"}}}};
  const double fastest = fastest_body(world, motion);
  if (!(fastest > 0.0)) return start;
  start.time = std::sqrt(2.0 * way / fastest);
  const double half_square = way / fastest;  // [s²] t²/2
  for (std::size_t b = 0; b < motion.size(); ++b) {
    const BodyProperties& body = world.bodies()[b];
    if (!body.movable() || fastest_of(body, motion[b]) <= kStays * fastest) continue;
    const Vec3 centre_w = world.states()[b].position_w;
    const Vec3 moved_w = half_square * motion[b].linear_w;
    const double turn = half_square * motion[b].angular_w.z();
    start.arrows.add(centre_w.x(), centre_w.y(), longer * moved_w.x(), longer * moved_w.y());
    const double cosine = elementary::cos(turn);
    const double sine = elementary::sin(turn);
    std::array<Vec2, 4> corners;
    constexpr double kSides[4][2] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
    for (std::size_t k = 0; k < 4; ++k) {
      const double x = kSides[k][0] * body.size.x();
      const double y = kSides[k][1] * body.size.y();
      corners[k] = Vec2(centre_w.x() + moved_w.x() + cosine * x - sine * y,
                        centre_w.y() + moved_w.y() + sine * x + cosine * y);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec2 edge = corners[(k + 1) % 4] - corners[k];
      start.outlines.add(corners[k].x(), corners[k].y(), edge.x(), edge.y());
    }
  }
  return start;
}

}  // namespace tumble::chapters
