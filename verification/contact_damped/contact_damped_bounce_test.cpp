/// \file
/// \brief The default technique: bounces that follow each other within a step.

#include "support/test.hpp"

#include <tuple>

namespace {

constexpr double kEdge = 0.1;

// A cube in a row along x.
struct InRow {
  double x, speed, mass;
};

// Elastic cubes in a row, without gravity and friction.
Scene row_of(const std::vector<InRow>& cubes) {
  Scene scene{.gravity_w = Vec3::Zero()};
  for (const InRow& cube : cubes)
    scene.boxes.push_back({.name = "cube" + std::to_string(scene.boxes.size()),
                           .size = Vec3::Constant(kEdge),
                           .mass = cube.mass,
                           .position_w = Vec3(cube.x, 0.0, 0.0),
                           .velocity_w = Vec3(cube.speed, 0.0, 0.0),
                           .friction = 0.0,
                           .restitution = 1.0});
  return scene;
}

// Speeds at a time by one impact after the other, and how far the time is from the nearest impact.
struct RowAt {
  std::vector<double> speeds;
  double apart = kInfinity;
};

RowAt one_after_the_other(std::vector<InRow> cubes, double until) {
  RowAt at;
  double time = 0.0;
  for (;;) {
    double next = kInfinity;
    std::size_t hit = 0;
    for (std::size_t k = 0; k + 1 < cubes.size(); ++k) {
      const double closing = cubes[k].speed - cubes[k + 1].speed;
      const double in = (cubes[k + 1].x - cubes[k].x - kEdge) / closing;
      if (closing > 1e-12 && std::max(0.0, in) < next) {
        next = std::max(0.0, in);
        hit = k;
      }
    }
    at.apart = std::min(at.apart, std::abs(time + next - until));
    if (time + next > until) break;
    for (InRow& cube : cubes) cube.x += next * cube.speed;
    time += next;
    InRow& a = cubes[hit];
    InRow& b = cubes[hit + 1];
    const double common = (a.mass * a.speed + b.mass * b.speed) / (a.mass + b.mass);
    a.speed = 2.0 * common - a.speed;
    b.speed = 2.0 * common - b.speed;
  }
  for (const InRow& cube : cubes) at.speeds.push_back(cube.speed);
  return at;
}

// The largest error of a speed after a time, as a share of the fastest cube's speed at the start.
double error_of_speeds(const std::vector<InRow>& cubes, const std::vector<double>& right,
                       double time, double dt) {
  Simulation simulation(row_of(cubes));
  CHECK(simulation.run_for(time, dt) == StepStatus::done);
  double most = 0.0, fastest = 0.0;
  for (std::size_t k = 0; k < cubes.size(); ++k) {
    const double speed = simulation.body("cube" + std::to_string(k)).velocity_w().x();
    most = std::max(most, std::abs(speed - right[k]));
    fastest = std::max(fastest, std::abs(cubes[k].speed));
  }
  return most / fastest;
}

}  // namespace

TEST_CASE("Elastic cubes with gaps pass a push on one after the other, however small the gaps",
          "[exact][contact_damped]") {
  for (const double gap : {1e-4, 5e-4, 1e-3, 3e-3, 5e-3, 8e-3, 2e-2}) {
    for (const double dt : {1.0 / 240.0, 1.0 / 60.0, 1.0 / 30.0}) {
      CAPTURE(gap, dt);
      std::vector<InRow> cubes;
      for (int k = 0; k < 5; ++k) cubes.push_back({k * (kEdge + gap), 0.0, 1.0});
      // One comes in, and one leaves.
      cubes.front() = {-0.5, 1.0, 1.0};
      CHECK(error_of_speeds(cubes, {0.0, 0.0, 0.0, 0.0, 1.0}, 1.0, dt) < 1e-9);
      // Two, and two.
      cubes.front() = {-0.5 - kEdge - gap, 1.0, 1.0};
      cubes[1] = {-0.5, 1.0, 1.0};
      CHECK(error_of_speeds(cubes, {0.0, 0.0, 0.0, 1.0, 1.0}, 1.0, dt) < 1e-9);
    }
  }
}

TEST_CASE(
    "Nearly all rows of elastic cubes of unlike masses part as one impact after the other says",
    "[exact][contact_damped]") {
  // The others have more impacts in a step than it has parts, or two at the end of the run that come in another order.
  Random random(3);
  int rows = 0, wrong = 0;
  while (rows < 100) {
    const int count = 3 + static_cast<int>(random.below(4));
    const double speed = std::pow(10.0, random.uniform(-0.5, 1.0));
    std::vector<InRow> cubes;
    double x = 0.0;
    for (int k = 0; k < count; ++k) {
      cubes.push_back({x, 0.0, std::pow(10.0, random.uniform(-0.5, 0.5))});
      x += kEdge + std::pow(10.0, random.uniform(-3.5, -1.5));
    }
    cubes.front().speed = speed;
    const double time = 0.6 / speed;
    const RowAt right = one_after_the_other(cubes, time);
    if (right.apart < 2.0 / 60.0) continue;  // the end of the run is in the middle of an impact
    ++rows;
    if (error_of_speeds(cubes, right.speeds, time, 1.0 / 60.0) > 1e-6) ++wrong;
  }
  CHECK(wrong <= 5);
}

TEST_CASE("An elastic cube between two walls keeps its speed when a step holds several bounces",
          "[exact][contact_damped]") {
  Scene scene = row_of({{0.0, 3.0, 1.0}});
  for (const double side : {-1.0, 1.0}) {
    SceneBox wall{.size = Vec3(0.1, 1.0, 1.0), .position_w = Vec3(side * 0.11, 0.0, 0.0)};
    wall.fixed = true;
    wall.friction = 0.0;
    wall.restitution = 1.0;
    scene.boxes.push_back(wall);
  }
  Simulation simulation(scene);
  CHECK(simulation.run_for(1.0) == StepStatus::done);
  CHECK(std::abs(std::abs(simulation.body("cube0").velocity_w().x()) - 3.0) < 1e-9);
}

TEST_CASE(
    "A light cube that falls a little above a heavy one leaves with the speed of Galileo's drop",
    "[exact][contact_damped]") {
  // The heavy one bounces with v, and meets the light one that arrives with v.
  const double v = std::sqrt(2.0 * 9.81 * 1.0);
  for (const double gap : {1e-3, 1e-2}) {
    for (const double dt : {1.0 / 240.0, 1.0 / 120.0, 1.0 / 60.0, 1.0 / 30.0}) {
      CAPTURE(gap, dt);
      Scene scene{.ground = SceneGround{0.0, 1.0}};
      for (const auto& [name, y, mass] :
           {std::tuple{"heavy", 1.05, 1.0}, std::tuple{"light", 1.15 + gap, 0.1}})
        scene.boxes.push_back({.name = name,
                               .size = Vec3::Constant(kEdge),
                               .mass = mass,
                               .position_w = Vec3(0.0, y, 0.0),
                               .friction = 0.0,
                               .restitution = 1.0});
      Simulation simulation(scene);
      CHECK(simulation.run_for(0.5, dt) == StepStatus::done);
      const double since = simulation.world().time() - v / 9.81;
      const auto speed_at_bounce = [&](const char* name) {
        return simulation.body(name).velocity_w().y() + 9.81 * since;
      };
      CHECK(std::abs(speed_at_bounce("heavy") - 0.7 / 1.1 * v) < 1e-2 * v);
      CHECK(std::abs(speed_at_bounce("light") - 2.9 / 1.1 * v) < 1e-2 * v);
    }
  }
}

TEST_CASE("A light elastic cube between heavy ones that arrive at once stays, and they return",
          "[exact][contact_damped]") {
  for (const double mass : {10.0, 100.0, 1e4}) {
    for (const double dt : {1.0 / 240.0, 1.0 / 60.0, 1.0 / 30.0}) {
      CAPTURE(mass, dt);
      const std::vector<InRow> cubes = {{-0.5, 1.0, mass}, {0.0, 0.0, 1.0}, {0.5, -1.0, mass}};
      CHECK(error_of_speeds(cubes, {-1.0, 0.0, 1.0}, 1.0, dt) < 1e-5);
    }
  }
}

TEST_CASE("A row of touching elastic cubes that is hit leaves as one, however long and unlike",
          "[exact][contact_damped]") {
  for (const int count : {5, 25, 60}) {
    for (const double ratio : {1.0, 10.0}) {
      CAPTURE(count, ratio);
      std::vector<InRow> cubes = {{-0.5, 1.0, 1.0}};
      double mass = 0.0;
      for (int k = 0; k < count; ++k) {
        cubes.push_back({k * kEdge, 0.0, std::pow(ratio, k % 3)});
        mass += cubes.back().mass;
      }
      // Newton's law at the face that is hit, and momentum.
      std::vector<double> right(cubes.size(), 2.0 / (1.0 + mass));
      right.front() = (1.0 - mass) / (1.0 + mass);
      CHECK(error_of_speeds(cubes, right, 1.0, 1.0 / 60.0) < 1e-4);
    }
  }
}

TEST_CASE("A long row of touching boxes on ice that is hit without restitution moves on as one",
          "[exact][contact_damped]") {
  // Islands of more than twenty bodies are not solved to convergence in each step; impulses of the impact must not be the start
  // of the next one.
  for (const int count : {19, 20, 24, 32, 60}) {
    Scene scene;
    scene.ground.emplace().friction = 0.0;
    for (int k = 0; k <= count; ++k)
      scene.boxes.push_back({.name = "box" + std::to_string(k),
                             .position_w = Vec3(k == 0 ? -0.05 : k, 0.5, 0.0),
                             .velocity_w = Vec3(k == 0 ? 6.0 : 0.0, 0.0, 0.0),
                             .friction = 0.0});
    Simulation simulation(scene);
    CHECK(simulation.run_for(1.0, 1.0 / 60.0) == StepStatus::done);
    const double common = 6.0 / (count + 1);
    for (int k = 0; k <= count; ++k) {
      CAPTURE(count, k);
      const double speed = simulation.body("box" + std::to_string(k)).velocity_w().x();
      CHECK(std::abs(speed - common) < 0.05 * common);
    }
  }
}

TEST_CASE(
    "A row of up to two hundred boxes that is hit moves by Newton's law from the next step on",
    "[exact][contact_damped]") {
  // More patches than the budget has Newton steps for, but the matrix of a row costs little.
  constexpr double kSpeed = 3.0;
  for (const double restitution : {0.0, 1.0})
    for (const double mass : {1.0, 10.0})
      for (const int count : {50, 52, 80, 199}) {
        CAPTURE(restitution, mass, count);
        Scene scene;
        scene.ground.emplace().friction = 0.0;
        for (int k = 0; k <= count; ++k)
          scene.boxes.push_back({.name = "box" + std::to_string(k),
                                 .mass = k == 0 ? mass : 1.0,
                                 .position_w = Vec3(k, 0.5, 0.0),
                                 .velocity_w = Vec3(k == 0 ? kSpeed : 0.0, 0.0, 0.0),
                                 .friction = 0.0,
                                 .restitution = restitution});
        Simulation simulation(scene);
        CHECK(simulation.run_for(2.0 * kFrame) == StepStatus::done);
        // The pair that was hit parts with e times the speed, the others stay together.
        const double row = kSpeed * (1.0 + restitution) * mass / (mass + count);
        for (int k = 0; k <= count; ++k) {
          const double expected = k == 0 ? row - restitution * kSpeed : row;
          const double speed = simulation.body("box" + std::to_string(k)).velocity_w().x();
          CHECK(std::abs(speed - expected) < 0.05 * row);
        }
      }
}

TEST_CASE("Boxes that are thrown at a wall without restitution are not thrown back",
          "[exact][contact_damped]") {
  // The direct solver does not find these impulses; its unfinished ones push boxes apart.
  for (const int height : {5, 6}) {
    CAPTURE(height);
    Scene scene;
    scene.ground.emplace().friction = 0.3;
    for (int k = 0; k < 10; ++k)
      for (int level = 0; level < height; ++level)
        scene.boxes.push_back({.name = "box" + std::to_string(10 * level + k),
                               .position_w = Vec3(1e-6 + k, 0.5 + level, 0.0),
                               .velocity_w = Vec3(-3.0, 0.0, 0.0),
                               .friction = 0.3});
    scene.boxes.push_back({.name = "wall",
                           .size = Vec3(1.0, 9.0, 20.0),
                           .fixed = true,
                           .position_w = Vec3(-1.0, 4.5, 0.0),
                           .friction = 0.3});
    Simulation simulation(scene);
    CHECK(simulation.run_for(0.02, 1.0 / 240.0) == StepStatus::done);
    for (int k = 0; k < 10 * height; ++k)
      CHECK(std::abs(simulation.body("box" + std::to_string(k)).velocity_w().x()) < 0.05);
  }
}

TEST_CASE("A heavy cube pushes a row of cubes with gaps together, and throws none ahead",
          "[exact][contact_damped]") {
  // An impact goes on through the row within a step, and the last impulses of one are not the start of the next step.
  for (const int count : {3, 19, 20, 24, 32, 40}) {
    for (const double gap : {0.0, 0.001, 0.01}) {
      CAPTURE(count, gap);
      constexpr double kMass = 100.0, kSpeed = 6.0;
      Scene scene;
      scene.ground.emplace().friction = 0.0;
      for (int k = 0; k <= count; ++k)
        scene.boxes.push_back({.name = "cube" + std::to_string(k),
                               .mass = k == 0 ? kMass : 1.0,
                               .position_w = Vec3(k == 0 ? -0.05 : k * (1.0 + gap), 0.5, 0.0),
                               .velocity_w = Vec3(k == 0 ? kSpeed : 0.0, 0.0, 0.0),
                               .friction = 0.0});
      Simulation simulation(scene);
      double overlap = 0.0;
      for (int n = 0; n < 90; ++n) {
        const StepReport report = simulation.step();
        CHECK(report.status == StepStatus::done);
        overlap = std::max(overlap, report.deepest_overlap);
      }
      CHECK(overlap < 0.015);  // [m]
      const double common = kSpeed * kMass / (count + kMass);
      for (int k = 0; k <= count; ++k) {
        const double speed = simulation.body("cube" + std::to_string(k)).velocity_w().x();
        CHECK(std::abs(speed - common) < 0.05 * common);
      }
    }
  }
}

TEST_CASE("Thin plates behind a box that is hit do not pass through each other",
          "[unit][contact_damped]") {
  for (const double speed : {2.0, 8.0, 20.0}) {
    for (const double thick : {0.02, 0.1}) {
      CAPTURE(speed, thick);
      Scene scene;
      scene.gravity_w.setZero();
      for (int k = 0; k <= 5; ++k) {
        const double size = k < 2 ? 0.3 : thick;
        const double before =
            k < 2 ? 0.31 * (k - 1) : 0.16 + 0.5 * thick + (thick + 0.005) * (k - 2);
        scene.boxes.push_back({.name = "box" + std::to_string(k),
                               .size = Vec3(size, 0.3, 0.3),
                               .position_w = Vec3(before, 0.0, 0.0),
                               .velocity_w = Vec3(k == 0 ? speed : 0.0, 0.0, 0.0)});
      }
      Simulation simulation(scene);
      for (int n = 0; n < 30; ++n) {
        CHECK(simulation.step().status == StepStatus::done);
        const World& world = simulation.world();
        for (std::size_t k = 0; k < 5; ++k) {
          CAPTURE(n, k);
          const double gap = separation(box_of(world.bodies()[k], world.states()[k]),
                                        box_of(world.bodies()[k + 1], world.states()[k + 1]))
                                 .distance;
          CHECK(gap > -0.02 * thick);
        }
      }
    }
  }
}

TEST_CASE("Eight elastic cubes on ice with gaps of a millimetre pass a push on one after the other",
          "[exact][contact_damped]") {
  Scene scene;
  scene.ground.emplace().friction = 0.0;
  for (int k = 0; k <= 8; ++k)
    scene.boxes.push_back({.name = "cube" + std::to_string(k),
                           .position_w = Vec3(k == 0 ? -0.5 : 1.001 * k, 0.5, 0.0),
                           .velocity_w = Vec3(k == 0 ? 2.0 : 0.0, 0.0, 0.0),
                           .friction = 0.0,
                           .restitution = 1.0});
  Simulation simulation(scene);
  CHECK(simulation.run_for(1.0, 1.0 / 60.0) == StepStatus::done);
  for (int k = 0; k <= 8; ++k)
    CHECK(std::abs(simulation.body("cube" + std::to_string(k)).velocity_w().x() -
                   (k == 8 ? 2.0 : 0.0)) < 1e-6);
}

TEST_CASE("A block of up to 96 touching cubes that falls flat bounces as one by Newton's law",
          "[unit][contact_damped]") {
  struct Block {
    int x, y, z;
  };
  for (const Block& b : {Block{3, 5, 3}, Block{3, 6, 3}, Block{4, 4, 4}, Block{4, 6, 4}})
    for (const double restitution : {0.2, 0.5, 1.0}) {
      CAPTURE(b.x, b.y, b.z, restitution);
      Scene scene{.ground = SceneGround{0.5, restitution}};
      for (int i = 0; i < b.x; ++i)
        for (int j = 0; j < b.y; ++j)
          for (int k = 0; k < b.z; ++k)
            scene.boxes.push_back({.position_w = Vec3(i, j + 0.5, k),
                                   .velocity_w = Vec3(0.0, -3.0, 0.0),
                                   .restitution = restitution});
      Simulation simulation(scene);
      simulation.step();
      for (const SceneBox& box : simulation.scene().boxes)
        CHECK(simulation.body(box.name).velocity_w().y() == near(3.0 * restitution, 0.01));
    }
}

namespace {

// What is (x, y) after an impact of a rigid body in a plane, without restitution: the impulses that stop the point r, or those at the
// bound of friction, against the slip that they leave.
std::vector<Vec2> after_impact(const Vec2& v, const Vec2& r, double moment, double friction) {
  const double W_xx = 1.0 + r.y() * r.y() / moment, W_yy = 1.0 + r.x() * r.x() / moment;
  const double W_xy = -r.x() * r.y() / moment;
  std::vector<Vec2> found;
  const double determinant = W_xx * W_yy - W_xy * W_xy;
  const Vec2 sticks(W_xy * v.y() - W_yy * v.x(), W_xy * v.x() - W_xx * v.y());
  if (std::abs(sticks.x()) <= friction * sticks.y()) found.emplace_back(v + sticks / determinant);
  for (const double side : {-1.0, 1.0}) {
    const double resists = W_yy - side * friction * W_xy;
    if (!(resists > 0.0)) continue;
    const Vec2 slides = -v.y() / resists * Vec2(-side * friction, 1.0);
    if (side * (v.x() + W_xx * slides.x() + W_xy * slides.y()) > 0.0)
      found.emplace_back(v + slides);
  }
  return found;
}

}  // namespace

TEST_CASE(
    "A bar that hits the ground with an edge gets the impulse of Coulomb's law, in its plane alone",
    "[exact][contact_damped]") {
  // The two points of the edge are solved at once, and much friction does not make the iterations swing.
  int tried = 0;
  for (const double friction : {0.3, 0.6, 1.0, 1.2, 1.5, 2.0})
    for (const double angle : {0.3, 0.6, 0.9, 1.2})
      for (const double length : {1.0, 3.0})
        for (const double speed : {-3.0, -1.0, 1.0, 2.0}) {
          const Vec3 size(length, 0.5, 0.5);
          const Quat tilted = rotation_from_vector(Vec3(0.0, 0.0, angle));
          // The lower left edge, as the bar is tilted to the left.
          const Vec3 edge_w = tilted * Vec3(-0.5 * size.x(), -0.5 * size.y(), 0.0);
          const Vec2 v(speed, -1.0);
          const double moment = (size.x() * size.x() + size.y() * size.y()) / 12.0;
          const std::vector<Vec2> right = after_impact(v, edge_w.head<2>(), moment, friction);
          if (right.size() != 1) continue;
          ++tried;
          Scene scene{.gravity_w = Vec3::Zero(), .ground = SceneGround{.friction = friction}};
          scene.boxes.push_back({.name = "bar",
                                 .size = size,
                                 .mass = 1.0,
                                 .position_w = Vec3(0.0, -edge_w.y(), 0.0),
                                 .orientation_wb = tilted,
                                 .velocity_w = Vec3(v.x(), v.y(), 0.0),
                                 .friction = friction});
          Simulation simulation(scene, "contact_damped");
          simulation.step(1.0 / 240.0);
          CAPTURE(friction, angle, length, speed);
          const Vec3 got = simulation.body("bar").velocity_w();
          CHECK((got.head<2>() - right[0]).norm() < 1e-3);
          CHECK(std::abs(got.z()) < 1e-6);
        }
  CHECK(tried > 100);
}
