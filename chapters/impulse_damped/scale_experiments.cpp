/// \file
/// \brief The same motion at any size and mass, and Coulomb's stopping distance (thesis 6.3.1).
#include "impulse_damped/scale_experiments.hpp"

#include "driver/common_numbers.hpp"
#include "driver/played_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace tumble::chapters {
namespace {

constexpr std::array<double, 3> kSizes{0.01, 1.0, 100.0};
constexpr double kSpeed = 3.0;     // [m/s] of the box that slides, at size 1
constexpr double kFriction = 0.3;  // of that box and the ground

// A world `size` times as large, with `mass` times the density. Speeds grow with the root.
World scaled(const World& world, double size, double mass) {
  World out;
  out.gravity_w = world.gravity_w;
  const double root = std::sqrt(size);
  for (std::size_t k = 0; k < world.bodies().size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    const BodyState& state = world.states()[k];
    if (body.shape == Shape::ground) {
      out.add_ground(body.friction, body.restitution);
      continue;
    }
    const Vec3 edges = size * body.size;
    const BodyProperties other = body.movable()
                                     ? box_properties(edges, size * size * size * mass * body.mass,
                                                      body.friction, body.restitution)
                                     : fixed_box_properties(edges, body.friction, body.restitution);
    out.add(other,
            make_state(other, size * state.position_w, state.orientation_wb,
                       root * velocity(body, state), angular_velocity(body, state) / root),
            world.name(static_cast<int>(k)));
  }
  return out;
}

std::unique_ptr<Technique> fresh(const std::string& name) {
  const TechniqueRecipe& recipe = technique_recipe(name);
  return recipe.make(recipe.options(), 1);
}

// What happens at size 1: a box slides, a crate slides off a table and tumbles, a stack is pushed.
std::vector<World> examples() {
  std::vector<World> worlds;
  worlds.push_back(
      build_world(scene_with("slide", {setting("speed", kSpeed), setting("friction", kFriction)})));
  worlds.push_back(build_world(scene_with("crate_off_table", {})));
  worlds.push_back(build_world(scene_with("stack", {"count=4"})));
  worlds.back().set_velocity(*worlds.back().find("level2"), Vec3(2.0, 0.0, 0.5), Vec3::Zero());
  return worlds;
}

// By step: the corners of all bodies that move, in shortest edges of the smallest one. The step is
// that of size 1 times the root of the size.
using Motion = std::vector<std::vector<Vec3>>;

Motion motion_of(const World& start, double size, double mass, const std::string& name,
                 double duration) {
  const double step = std::sqrt(size) * kStep;
  const std::unique_ptr<Technique> technique = fresh(name);
  World world = scaled(start, size, mass);
  double edge = 0.0;
  for (const BodyProperties& body : world.bodies())
    if (body.movable())
      edge = edge == 0.0 ? body.size.minCoeff() : std::min(edge, body.size.minCoeff());
  Motion motion;
  const auto steps = static_cast<int>(std::lround(duration / kStep));
  for (int n = 0; n < steps; ++n) {
    technique->step(world, step);
    motion.emplace_back();
    for (std::size_t k = 0; k < world.bodies().size(); ++k) {
      if (!world.bodies()[k].movable()) continue;
      for (const Vec3& corner : corners_of(box_of(world.bodies()[k], world.states()[k])))
        motion.back().push_back(corner / edge);
    }
  }
  return motion;
}

double difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, (a[k] - b[k]).norm());
  return most;
}

double largest_difference(const Motion& a, const Motion& b) {
  double most = 0.0;
  for (std::size_t step = 0; step < a.size(); ++step)
    most = std::max(most, difference(a[step], b[step]));
  return most;
}

// [m] where a sliding box comes to rest, over its size, with steps of 1/60 s over `finer`.
double stopping(const World& slide, const std::string& name, int finer, double size) {
  constexpr double seconds = 2.0;  // at size 1: twice as long as Coulomb's friction needs
  const std::unique_ptr<Technique> technique = fresh(name);
  World world = scaled(slide, size, 1.0);
  const double step = kStep / finer;
  const auto steps = static_cast<int>(std::lround(seconds * std::sqrt(size) / step));
  for (int k = 0; k < steps; ++k) technique->step(world, step);
  return world.states()[1].position_w.x() / size;
}

}  // namespace

Result measure_size(const Parameters& settings) {
  const double duration = settings.number("duration");
  const std::vector<World> worlds = examples();
  const std::vector<std::string> words = {"sliding box", "crate off a table", "pushed stack"};
  const std::vector<std::string> techniques = {"contact_damped", "damped"};

  // motions[technique][world][size]
  std::vector<std::vector<std::vector<Motion>>> motions;
  for (const std::string& technique : techniques) {
    motions.emplace_back();
    for (const World& world : worlds) {
      motions.back().emplace_back();
      for (const double size : kSizes)
        motions.back().back().push_back(motion_of(world, size, 1.0, technique, duration));
    }
  }
  const auto apart = [&](std::size_t technique, std::size_t world) {
    const std::vector<Motion>& runs = motions[technique][world];
    return std::max(largest_difference(runs[0], runs[1]), largest_difference(runs[2], runs[1]));
  };
  const auto worst = [&](std::size_t technique) {
    double most = 0.0;
    for (std::size_t w = 0; w < worlds.size(); ++w) most = std::max(most, apart(technique, w));
    return most;
  };
  const auto with_mass = [&](const std::string& technique, std::size_t t) {
    double most = 0.0;
    for (std::size_t w = 0; w < worlds.size(); ++w)
      for (const double mass : {1e-3, 1e3})
        most =
            std::max(most, largest_difference(motion_of(worlds[w], 1.0, mass, technique, duration),
                                              motions[t][w][1]));
    return most;
  };

  Result result;
  std::vector<Quantity>& out = result.quantities;
  out.push_back(
      {"largest difference of the dimensionless motion between boxes of 0.01, 1 and 100 times the "
       "size, in edges",
       "-", worst(0)});
  for (std::size_t w = 0; w < worlds.size(); ++w)
    out.push_back({"the same, " + words[w], "-", apart(0, w)});
  double exact = 0.0;
  for (std::size_t w = 0; w < worlds.size(); ++w)
    for (const double size : {1.0 / 64.0, 64.0})
      exact = std::max(
          exact, largest_difference(motion_of(worlds[w], size, 1.0, "contact_damped", duration),
                                    motions[0][w][1]));
  out.push_back({"the same, 1/64, 1 and 64 times the size, where nothing is rounded", "-", exact});
  out.push_back({"the same, densities of 0.001, 1 and 1000", "-", with_mass("contact_damped", 0)});
  out.push_back({"the same, damped as in the thesis", "-", worst(1)});
  out.push_back({"the same, damped as in the thesis, densities of 0.001, 1 and 1000", "-",
                 with_mass("damped", 1)});
  const double coulomb = kSpeed * kSpeed / (2.0 * kFriction * 9.81);
  const auto short_by = [&](const char* technique, int finer, double size) {
    return stopping(worlds[0], technique, finer, size) / coulomb - 1.0;
  };
  out.push_back({"stopping distance of Coulomb", "m", coulomb});
  out.push_back({"stopping distance", "m", stopping(worlds[0], "contact_damped", 1, 1.0)});
  out.push_back({"its error, over Coulomb's", "-", short_by("contact_damped", 1, 1.0)});
  out.push_back({"its error with steps of 1/960 s", "-", short_by("contact_damped", 16, 1.0)});
  out.push_back(
      {"its error at 0.01 of the size, the same step", "-", short_by("contact_damped", 1, 0.01)});
  out.push_back({"its error at 100 times the size, the same step", "-",
                 short_by("contact_damped", 1, 100.0)});
  out.push_back(
      {"error of the stopping distance, damped as in the thesis", "-", short_by("damped", 1, 1.0)});

  Table table{"",
              {{"time_s", "s", "at size 1; at others times the root of the size"},
               {"small", "-", "largest distance from the motion at size 1, in edges, size 0.01"},
               {"large", "-", "the same, size 100"},
               {"damped_small", "-", "the same, damped as in the thesis, size 0.01"},
               {"damped_large", "-", "the same, size 100"}}};
  Table path{"path",
             {{"time_s", "s", "at size 1; at others times the root of the size"},
              {"x_small", "-", "way of the sliding box in heights, size 0.01"},
              {"x", "-", "size 1"},
              {"x_large", "-", "size 100"},
              {"damped_small", "-", "damped as in the thesis, size 0.01"},
              {"damped", "-", "size 1"},
              {"damped_large", "-", "size 100"},
              {"coulomb", "-", "in closed form"}}};
  for (std::size_t step = 0; step < motions[0][0][1].size(); ++step) {
    const double t = static_cast<double>(step + 1) * kStep;
    table.rows.push_back({t});
    path.rows.push_back({t});
    for (std::size_t technique = 0; technique < 2; ++technique) {
      for (const std::size_t size : {std::size_t{0}, std::size_t{2}}) {
        double most = 0.0;
        for (const std::vector<Motion>& runs : motions[technique])
          most = std::max(most, difference(runs[size][step], runs[1][step]));
        table.rows.back().push_back(most);
      }
      for (const Motion& run : motions[technique][0]) {
        double sum = 0.0;
        for (const Vec3& corner : run[step]) sum += corner.x();
        path.rows.back().push_back(sum / 8.0);
      }
    }
    const double ends = kSpeed / (kFriction * 9.81);
    const double moving = std::min(t, ends);
    path.rows.back().push_back((kSpeed * moving - 0.5 * kFriction * 9.81 * moving * moving) / 0.2);
  }
  result.tables = {table, path};
  return result;
}

}  // namespace tumble::chapters
