/// \file
/// \brief Loads on the tops of a pile, and the bodies that move under them (thesis 5.4).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/dynamics/wrench.hpp"

#include "driver/experiment.hpp"
#include "geometric_stability/pile_forces.hpp"

namespace tumble::chapters {

// The corners of the face of a body that looks up most [m], world frame, in order around the face.
inline std::array<Vec3, 4> top_of(const World& world, int body) {
  const Box box = box_of(world.bodies()[idx(body)], world.states()[idx(body)]);
  int up = 0;
  box.axes_w.row(1).cwiseAbs().maxCoeff(&up);
  const double sign = box.axes_w(1, up) > 0.0 ? 1.0 : -1.0;
  const int u = (up + 1) % 3;
  const int v = (up + 2) % 3;
  const Vec3 centre_w = box.center_w + sign * box.half[up] * box.axes_w.col(up);
  const Vec3 x_w = box.half[u] * box.axes_w.col(u);
  const Vec3 z_w = box.half[v] * box.axes_w.col(v);
  return {centre_w - x_w - z_w, centre_w + x_w - z_w, centre_w + x_w + z_w, centre_w - x_w + z_w};
}

// A load on every movable body: straight down, at any point of its top, from a tenth of its weight
// to a hundred times as much, each power of ten as likely.
inline std::vector<Wrench> random_loads(const World& world, Random& random) {
  std::vector<Wrench> loads(world.bodies().size());
  const double g = world.gravity_w.norm();
  for (int b = 0; b < world.count(); ++b) {
    const BodyProperties& body = world.bodies()[idx(b)];
    if (!body.movable()) continue;
    const std::array<Vec3, 4> top = top_of(world, b);
    const double x = random.unit();
    const double z = random.unit();
    const Vec3 point_w = top[0] + x * (top[1] - top[0]) + z * (top[3] - top[0]);
    const double weights = elementary::exp(std::numbers::ln10 * random.uniform(-1.0, 2.0));
    loads[idx(b)] = weight_at(world.states()[idx(b)], point_w, weights * body.mass * g);
  }
  return loads;
}

// Acceleration by a load of a body without contacts, its weight left out [m/s²], see fastest_of().
inline double alone(const World& world, int body, const Wrench& load) {
  const BodyProperties& properties = world.bodies()[idx(body)];
  const Mat3 inverse_w = inverse_inertia_w(properties, world.states()[idx(body)].orientation_wb);
  return fastest_of(properties,
                    {properties.inverse_mass * load.force_w, inverse_w * load.torque_w});
}

inline constexpr double kMovesByItself = 1e-6;  // [-] of g, under weights alone
// [-] Of g, under loads: a hundred-millionth of them.
inline constexpr double kMovesUnderLoads = 1e-4;
// [-] Weights of the body: a corner that hangs over by a hundredth is tipped.
inline constexpr double kHeavy = 1e4;
inline constexpr int kRandomHalves = 20;            // loads on half of the corners
inline constexpr std::uint64_t kLoadSeed = 0x10ad;  // of these

// A place that can be loaded.
struct Corner {
  int body;
  Wrench load;  // straight down
};

inline std::vector<Corner> corners_of_tops(const World& world,
                                           std::span<const std::vector<Vec2>> outlines) {
  std::vector<Corner> corners;
  const double g = world.gravity_w.norm();
  for (int b = 0; b < world.count(); ++b) {
    const BodyProperties& body = world.bodies()[idx(b)];
    if (!body.movable()) continue;
    const BodyState& state = world.states()[idx(b)];
    const auto add = [&](const Vec3& point_w) {
      corners.push_back({b, weight_at(state, point_w, kHeavy * body.mass * g)});
    };
    if (outlines.empty() || outlines[idx(b)].empty()) {
      for (const Vec3& point_w : top_of(world, b)) add(point_w);
    } else {
      for (const Vec2& xz : outlines[idx(b)]) add(Vec3(xz.x(), state.position_w.y(), xz.y()));
    }
  }
  return corners;
}

inline void add_to(Wrench& sum, const Wrench& load) {
  sum.force_w += load.force_w;
  sum.torque_w += load.torque_w;
}

// The bodies that move under some load, by the whole complementarity problem.
//
// Tried are the weights alone; a load of 10^4 weights on each corner of each top, one at a
// time; and loads on a random half of all corners.
// outlines: by body index, corners [m] in x and z to load instead of those of a box; may be empty, as a
// whole or for a body
inline std::vector<char> moves_under_loads(const World& world, std::span<const Contact> contacts,
                                           std::span<const std::vector<Vec2>> outlines = {}) {
  std::vector<char> moves(world.bodies().size(), 0);
  PileForces forces("least_constraint");
  std::vector<Wrench> loads(world.bodies().size());
  const auto attempt = [&](double limit) {
    if (!forces.solve(world, contacts, loads))
      throw std::runtime_error("the contact forces of a pile were not found");
    for (std::size_t b = 0; b < moves.size(); ++b)
      if (world.bodies()[b].movable() &&
          fastest_of(world.bodies()[b], forces.accelerations()[b]) > limit * world.gravity_w.norm())
        moves[b] = 1;
    loads.assign(loads.size(), Wrench{});
  };
  attempt(kMovesByItself);
  const std::vector<Corner> corners = corners_of_tops(world, outlines);
  for (const Corner& corner : corners) {
    loads[idx(corner.body)] = corner.load;
    attempt(kMovesUnderLoads);
  }
  Random random(kLoadSeed);
  for (int k = 0; k < kRandomHalves; ++k) {
    for (const Corner& corner : corners)
      if (random.below(2) == 0) add_to(loads[idx(corner.body)], corner.load);
    attempt(kMovesUnderLoads);
  }
  return moves;
}

}  // namespace tumble::chapters
