/// \file
/// \brief The same motion at any size and mass, and Coulomb's stopping distance (thesis 6.3.1).

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

constexpr std::array<double, 3> kSizes{0.01, 1.0, 100.0};
constexpr double kSpeed = 3.0;     // [m/s] of the box that slides, at size 1
constexpr double kFriction = 0.3;  // of that box and the ground

// A world `size` times as large, with `mass` times the density. Speeds grow with the root of the size.
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

// What happens at size 1: a box slides, a crate slides off a table and tumbles, a stack is pushed.
std::vector<World> examples() {
  std::vector<World> worlds;
  worlds.push_back(
      build_world(make_scene("slide", {setting("speed", kSpeed), setting("friction", kFriction)})));
  worlds.push_back(build_world(make_scene("crate_off_table")));
  worlds.push_back(build_world(make_scene("stack", {"count=4"})));
  worlds.back().set_velocity(*worlds.back().find("level2"), Vec3(2.0, 0.0, 0.5), Vec3::Zero());
  return worlds;
}

// By step: the corners of all bodies that move, in shortest edges of the smallest one. The step is
// that of size 1 times the root of the size.
using Motion = std::vector<std::vector<Vec3>>;

Motion motion_of(const World& start, double size, double mass, const std::string& name,
                 double duration) {
  const double step = std::sqrt(size) * kStep;
  const std::unique_ptr<Technique> technique = make_technique(name);
  World world = scaled(start, size, mass);
  double edge = 0.0;
  for (const BodyProperties& body : world.bodies())
    if (body.movable())
      edge = edge == 0.0 ? body.size.minCoeff() : std::min(edge, body.size.minCoeff());
  Motion motion;
  const auto steps = static_cast<int>(std::lround(duration / kStep));
  for (int n = 0; n < steps; ++n) {
    finished(technique->step(world, step));
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
  return largest_of(a, b, [](const Vec3& p, const Vec3& q) { return (p - q).norm(); });
}

double largest_difference(const Motion& a, const Motion& b) {
  return largest_of(a, b, [](const std::vector<Vec3>& p, const std::vector<Vec3>& q) {
    return difference(p, q);
  });
}

// [m] where a sliding box comes to rest, with steps of 1/60 s over `finer`.
double stopping(const World& slide, const std::string& name, int finer) {
  constexpr double seconds = 2.0;  // twice as long as Coulomb's friction needs
  const std::unique_ptr<Technique> technique = make_technique(name);
  World world = slide;
  const double step = kStep / finer;
  const auto steps = static_cast<int>(std::lround(seconds / step));
  for (int k = 0; k < steps; ++k) finished(technique->step(world, step));
  return world.states()[1].position_w.x();
}

// By world: its motion at each of the sizes.
using Motions = std::vector<std::array<Motion, kSizes.size()>>;

Motions motions_of(const std::vector<World>& worlds, const std::string& name, double duration) {
  Motions motions(worlds.size());
  for (std::size_t w = 0; w < worlds.size(); ++w)
    for (std::size_t s = 0; s < kSizes.size(); ++s)
      motions[w][s] = motion_of(worlds[w], kSizes[s], 1.0, name, duration);
  return motions;
}

// From the motion at size 1, over all worlds.
double largest_difference(const Motions& motions) {
  return largest_of(motions, [](const auto& of_world) {
    const auto& [small, usual, large] = of_world;
    return std::max(largest_difference(small, usual), largest_difference(large, usual));
  });
}

// The same for one size in one step.
double difference(const Motions& motions, std::size_t size, std::size_t step) {
  return largest_of(motions,
                    [&](const auto& runs) { return difference(runs[size][step], runs[1][step]); });
}

// Mean way along x of the corners of a box at each of the sizes.
std::array<double, kSizes.size()> ways(const std::array<Motion, kSizes.size()>& runs,
                                       std::size_t step) {
  std::array<double, kSizes.size()> out{};
  for (std::size_t s = 0; s < kSizes.size(); ++s) {
    double sum = 0.0;
    for (const Vec3& corner : runs[s][step]) sum += corner.x();
    out[s] = sum / 8.0;
  }
  return out;
}

Result measure_size(const Parameters& settings) {
  const double duration = settings.number("duration");
  const std::vector<World> worlds = examples();
  const Motions own = motions_of(worlds, "contact_damped", duration);
  const Motions thesis = motions_of(worlds, "damped", duration);
  const auto apart = [&](double size, double mass) {
    return largest_of(worlds, own, [&](const World& world, const auto& runs) {
      return largest_difference(motion_of(world, size, mass, "contact_damped", duration), runs[1]);
    });
  };

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
  for (std::size_t step = 0; step < own[0][1].size(); ++step) {
    const double t = static_cast<double>(step + 1) * kStep;
    table.add(t, difference(own, 0, step), difference(own, 2, step), difference(thesis, 0, step),
              difference(thesis, 2, step));
    const double moving = std::min(t, kSpeed / (kFriction * kGravity));
    path.add(t, ways(own[0], step), ways(thesis[0], step),
             (kSpeed * moving - 0.5 * kFriction * kGravity * moving * moving) / 0.2);
  }

  const double coulomb = kSpeed * kSpeed / (2.0 * kFriction * kGravity);
  const double stops = stopping(worlds[0], "contact_damped", 1);
  return {{table, path},
          {{"largest difference of the dimensionless motion between boxes of 0.01, 1 and 100 times "
            "the size, in edges",
            "-", largest_difference(own)},
           {"the same, 1/64, 1 and 64 times the size, where nothing is rounded", "-",
            std::max(apart(1.0 / 64.0, 1.0), apart(64.0, 1.0))},
           {"the same, densities of 0.001, 1 and 1000", "-",
            std::max(apart(1.0, 1e-3), apart(1.0, 1e3))},
           {"the same, damped as in the thesis", "-", largest_difference(thesis)},
           {"stopping distance of Coulomb", "m", coulomb},
           {"stopping distance", "m", stops},
           {"its error, over Coulomb's", "-", stops / coulomb - 1.0},
           {"its error with steps of 1/960 s", "-",
            stopping(worlds[0], "contact_damped", 16) / coulomb - 1.0},
           {"error of the stopping distance, damped as in the thesis", "-",
            stopping(worlds[0], "damped", 1) / coulomb - 1.0}}};
}

const Registered claim_6_3_1a_size_figure{
    {.name = "claim_6_3_1a_size",
     .parameters = {number("duration", 3.0, 1.5, 60.0, "s", "of each run, at size 1")},
     .quick = {"duration=1.5"},
     .experiment = measure_size}};

}  // namespace
}  // namespace tumble::chapters
