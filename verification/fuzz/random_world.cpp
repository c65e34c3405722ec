/// \file
/// \brief Random worlds and their judge.
#include "fuzz/random_world.hpp"

#include "tumble/base/index.hpp"
#include "tumble/base/random.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/geometry/separation.hpp"
#include "tumble/record/overlap.hpp"
#include "tumble/record/passage_check.hpp"
#include "tumble/record/run_checks.hpp"
#include "tumble/scenes/simulation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>

namespace tumble::fuzz {
namespace {

// A number whose logarithm is uniform.
double log_uniform(Random& chance, double low, double high) {
  return low * std::pow(high / low, chance.unit());
}

bool overlaps(const SceneBox& box, const std::vector<SceneBox>& others) {
  const Box own = make_box(box.position_w, box.orientation_wb, box.size);
  return std::ranges::any_of(others, [&](const SceneBox& other) {
    return separation(own, make_box(other.position_w, other.orientation_wb, other.size)).distance <
           0.0;
  });
}

double lowest_point(const SceneBox& box) {
  const Vec3 up_b = box.orientation_wb.conjugate() * Vec3::UnitY();
  return box.position_w.y() - 0.5 * up_b.cwiseAbs().dot(box.size);
}

// Each on top of the one before, shifted by less than half an edge: most stand, some topple.
void stack(Random& chance, double start, std::vector<SceneBox>& boxes) {
  double top = start;
  Vec3 below_w = Vec3::Zero();
  for (SceneBox& box : boxes) {
    const double x = chance.uniform(-0.4, 0.4);
    const double z = chance.uniform(-0.4, 0.4);
    box.position_w = below_w + Vec3(x * box.size.x(), 0.0, z * box.size.z());
    box.position_w.y() = top + 0.5 * box.size.y();
    top += box.size.y();
    below_w = Vec3(box.position_w.x(), 0.0, box.position_w.z());
  }
}

// In a cloud that gets wider until all fit.
void scatter(Random& chance, bool ground, std::vector<SceneBox>& boxes) {
  std::vector<SceneBox> placed;
  double half = boxes.front().size.norm();
  for (SceneBox& box : boxes) {
    box.orientation_wb = chance.orientation();
    do {
      half *= 1.05;
      box.position_w = chance.in_cube(half);
      if (ground) box.position_w.y() += half - std::min(0.0, lowest_point(box) + half);
    } while (overlaps(box, placed));
    placed.push_back(box);
  }
}

double deepest_overlap(const World& world) {
  OverlapMeter meter;
  meter.look(world.bodies(), world.states());
  double deepest = 0.0;
  for (std::size_t k = 0; k < meter.depths().size(); ++k)
    if (world.bodies()[k].shape == Shape::box)
      deepest = std::max(deepest, meter.depths()[k] / world.bodies()[k].size.minCoeff());
  return deepest;
}

constexpr double kAny = std::numeric_limits<double>::infinity();
constexpr std::array kWorldPromises{
    WorldPromise{"contact_damped", 1e-9, 0.01, kAny}, WorldPromise{"analytic", 1e-9, 0.01, 0.1},
    WorldPromise{"time_stepping", 1e-9, 0.01, kAny}, WorldPromise{"impulse", 1e-9, 0.01, kAny},
    WorldPromise{"damped", kAny, 0.01, kAny}, WorldPromise{"basic", 1e-9, kAny, kAny},
    WorldPromise{"timewarp_simple", 1e-9, kAny, kAny},
    WorldPromise{"timewarp_safer", 1e-9, kAny, kAny},
    WorldPromise{"timewarp_swept", 1e-9, kAny, kAny},
    WorldPromise{"timewarp_full", 1e-9, kAny, kAny}, WorldPromise{"penalty", 1e-9, 0.01, kAny},
    WorldPromise{"faure", 1e-9, 0.01, kAny}, WorldPromise{"settling", kAny, kAny, kAny},
    WorldPromise{"optimised", 1e-9, 0.01, kAny}, WorldPromise{"microcollisions", 1e-9, kAny, kAny},
    // Its velocities are differences of positions, and a ton at rest beside a gram that flies has rounding in them.
    WorldPromise{"relaxation", 1e-5, kAny, kAny}};

}  // namespace

WorldPromise promise_of(std::string_view technique) {
  for (const WorldPromise& p : kWorldPromises)
    if (p.technique == technique) return p;
  return {technique, kAny, kAny, kAny};
}

RandomWorld random_world(std::uint64_t seed, const WorldRange& range) {
  Random chance(seed);
  RandomWorld world;
  Scene& scene = world.scene;
  scene.title = "random world " + std::to_string(seed);
  const bool stacked = chance.unit() < 0.5;
  const bool ground = chance.unit() < 0.7;
  const bool gravity = ground || chance.unit() < 0.5;
  const bool smooth = chance.unit() < 0.2;
  const bool bouncy = chance.unit() < 0.5;
  if (!gravity) scene.gravity_w.setZero();
  if (ground) scene.ground = SceneGround{chance.unit(), bouncy ? chance.unit() : 0.0};
  const auto count =
      idx(range.least_boxes + static_cast<int>(chance.below(static_cast<std::uint32_t>(
                                  range.most_boxes - range.least_boxes + 1))));
  double shortest = 1e9;
  for (std::size_t k = 0; k < count; ++k) {
    SceneBox box;
    const double scale = stacked && chance.unit() < 0.5 ? 1.0 : std::sqrt(range.edge_ratio);
    for (Eigen::Index i = 0; i < 3; ++i)
      box.size[i] = log_uniform(chance, 1.0 / std::sqrt(scale), std::sqrt(scale));
    box.mass = log_uniform(chance, 1.0 / std::sqrt(range.mass_ratio), std::sqrt(range.mass_ratio));
    box.friction = smooth ? 0.0 : chance.uniform(0.0, 2.0);
    box.restitution = bouncy ? range.restitution * chance.unit() : 0.0;
    shortest = std::min(shortest, box.size.minCoeff());
    scene.boxes.push_back(box);
  }
  world.dt = std::sqrt(shortest) / 60.0;
  if (stacked) {
    stack(chance, 0.0, scene.boxes);
  } else {
    scatter(chance, ground, scene.boxes);
  }
  for (SceneBox& box : scene.boxes) {
    if (stacked && chance.unit() < 0.6) continue;
    const double travel = range.most_travel * chance.unit();
    box.velocity_w = travel * box.size.minCoeff() / world.dt * chance.direction();
    const double turn = range.most_turn * chance.unit();
    box.angular_velocity_w = turn / world.dt * chance.direction();
    if (stacked) box.angular_velocity_w.setZero();
  }
  return world;
}

WorldVerdict judge(const RandomWorld& random, std::string_view technique,
                   const std::vector<std::string>& settings, int steps) {
  WorldVerdict verdict;
  try {
    Simulation simulation(random.scene, technique, settings);
    simulation.update_boxes();
    EnergyCheck energy;
    PassageCheck left;
    simulation.observe(energy);
    const World& world = simulation.world();
    const Energy start = energy_of(world);
    const Vec3 momentum_w = linear_momentum(world);
    const bool closed = !random.scene.ground && random.scene.gravity_w.isZero();
    const double scale = start.kinetic + lifting_energy(world);
    double speeds = 0.0;
    for (const SceneBox& box : random.scene.boxes) speeds += box.mass * box.velocity_w.norm();
    double booked = 0.0;
    for (int k = 0; k < steps; ++k) {
      const StepReport report = simulation.step(random.dt);
      verdict.reported = verdict.reported || energy.status() != StepStatus::done;
      if (report.status != StepStatus::done) {
        verdict.status = report.status;
        break;
      }
      verdict.finite = all_finite(world);
      if (!verdict.finite) break;
      booked += report.energy.total();
      const double rise = energy_of(world).total() - start.total();
      if (scale > 0.0) {
        verdict.energy_rise = std::max(verdict.energy_rise, rise / scale);
        verdict.unbooked_rise = std::max(verdict.unbooked_rise, (rise - booked) / scale);
      }
      if (closed && speeds > 0.0)
        verdict.momentum_change = std::max(verdict.momentum_change,
                                           (linear_momentum(world) - momentum_w).norm() / speeds);
    }
    verdict.overlap = deepest_overlap(world);
    left.at_end(world);
    verdict.reported =
        verdict.reported || verdict.status != StepStatus::done || left.status() != StepStatus::done;
  } catch (const std::exception& mistake) {
    verdict.thrown = mistake.what();
  }
  return verdict;
}

}  // namespace tumble::fuzz
