/// \file
/// \brief Bodies that come near each other and do not touch.
#include "tumble/scenes/simulation.hpp"

#include "support/test.hpp"

namespace {

// Whether a box that moves along a way, as far as it leads, overlaps another one: on each of the 15 axes both cover an interval of
// the way, and these have a part in common.
bool overlap_on_way(const SceneBox& still, const SceneBox& moving, const Vec3& way_w) {
  const Mat3 a = still.orientation_wb.toRotationMatrix();
  const Mat3 b = moving.orientation_wb.toRotationMatrix();
  std::vector<Vec3> axes_w;
  for (int i = 0; i < 3; ++i) {
    axes_w.push_back(a.col(i));
    axes_w.push_back(b.col(i));
    for (int k = 0; k < 3; ++k) axes_w.push_back(a.col(i).cross(b.col(k)).normalized());
  }
  double first = -std::numeric_limits<double>::infinity(), last = -first;
  for (const Vec3& n : axes_w) {
    const double reach = 0.5 * ((a.transpose() * n).cwiseAbs().dot(still.size) +
                                (b.transpose() * n).cwiseAbs().dot(moving.size));
    const double place = n.dot(moving.position_w - still.position_w), speed = n.dot(way_w);
    const double one = (-reach - place) / speed, other = (reach - place) / speed;
    first = std::max(first, std::min(one, other));
    last = std::min(last, std::max(one, other));
  }
  return first < last;
}

// Two boxes without gravity, of which one flies past the other with some room, or without: below 0 they overlap on the way.
Scene near_miss(double room, double speed, std::uint64_t seed) {
  Random random(seed);
  Scene scene{.gravity_w = Vec3::Zero()};
  for (const char* name : {"still", "flies"}) {
    SceneBox& box = scene.boxes.emplace_back();
    box.name = name;
    for (int i = 0; i < 3; ++i) box.size[i] = random.uniform(0.5, 1.5);
    box.orientation_wb = rotation_from_vector(random.in_cube(3.0));
    box.restitution = 0.3;
  }
  SceneBox& flies = scene.boxes[1];
  flies.velocity_w = Vec3(speed, 0.0, 0.0);
  const double angle = random.uniform(0.0, 6.283);
  const Vec3 aside_w(0.0, std::cos(angle), std::sin(angle));
  const double start = -3.0 - random.uniform(0.0, 0.3);
  double low = 0.0, high = 4.0;
  for (int k = 0; k < 50; ++k) {
    const double middle = 0.5 * (low + high);
    flies.position_w = middle * aside_w;
    (overlap_on_way(scene.boxes[0], flies, Vec3::UnitX()) ? low : high) = middle;
  }
  flies.position_w = (high + room) * aside_w + Vec3(start, 0.0, 0.0);
  return scene;
}

// [m/s] By how much the velocity of the flying box has changed after it has passed.
double changed(double room, double speed, double dt, std::uint64_t seed) {
  Simulation simulation(near_miss(room, speed, seed));
  simulation.run_for(6.5 / speed, dt);
  return (simulation.body("flies").velocity_w() - Vec3(speed, 0.0, 0.0)).norm();
}

}  // namespace

TEST_CASE("A box that flies past another one goes on as before, and one that does not is hit",
          "[unit][contact_damped]") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    for (const double room : {0.001, 0.01, 0.03}) {
      CAPTURE(room);
      CHECK(changed(room, 3.0, 1.0 / 60.0, seed) < 1e-9);
      CHECK(changed(room, 10.0, 1.0 / 60.0, seed) < 1e-9);
      CHECK(changed(room, 10.0, 1.0 / 240.0, seed) < 1e-9);
    }
    for (const double overlap : {0.01, 0.05}) {
      CAPTURE(overlap);
      CHECK(changed(-overlap, 10.0, 1.0 / 60.0, seed) > 1e-3);
    }
  }
}

TEST_CASE("A bar that turns beside a block does not touch it", "[unit][contact_damped]") {
  Scene scene{.gravity_w = Vec3::Zero()};
  SceneBox bar;
  bar.name = "bar";
  bar.size = Vec3(2.0, 0.1, 0.1);
  SceneBox block;
  block.name = "block";
  block.size = Vec3(0.5, 0.5, 0.5);
  block.fixed = true;
  block.position_w.x() = 0.25 + 0.01 + std::hypot(1.0, 0.05);  // a centimetre beyond its reach
  for (const double spin : {5.0, 50.0}) {                      // [rad/s]
    CAPTURE(spin);
    bar.angular_velocity_w = Vec3(0.0, 0.0, spin);
    scene.boxes = {bar, block};
    Simulation simulation(scene);
    simulation.run_for(2.0);
    CHECK(simulation.body("bar").velocity_w().norm() < 1e-12);
    CHECK(simulation.body("bar").angular_velocity_w().z() == near(spin, 1e-12));
  }
}

TEST_CASE("A box slides under a ceiling with little room", "[unit][contact_damped]") {
  Scene scene{.ground = SceneGround{.friction = 0.3}};
  SceneBox& slides = scene.boxes.emplace_back();
  slides.name = "slides";
  slides.position_w.y() = 0.5;
  slides.velocity_w.x() = 6.0;
  slides.friction = 0.3;
  SceneBox& ceiling = scene.boxes.emplace_back();
  ceiling.name = "ceiling";
  ceiling.size = Vec3(10.0, 1.0, 4.0);
  ceiling.fixed = true;
  ceiling.position_w = Vec3(6.0, 1.5001, 0.0);
  for (const double dt : {1.0 / 37.0, 1.0 / 60.0, 1.0 / 240.0}) {
    CAPTURE(dt);
    Simulation simulation(scene);
    simulation.run_for(1.0, dt);
    // Friction slows it by 0.3 g, and a step is as exact as its rule: half of what it loses in one.
    const double slowed = 0.3 * kGravity, time = simulation.world().time();
    CHECK(simulation.body("slides").position_w().x() ==
          near(6.0 * time - 0.5 * slowed * time * time, 0.6 * slowed * dt));
  }
}

TEST_CASE(
    "A slider whose front edge ends a step just at a seam slides on, along a floor and a wall",
    "[unit][contact_damped]") {
  // There its edge lies on that of the next tile, and between the two faces no normal is right.
  for (const double tile : {0.25, 0.3, 0.5, 2.0})
    for (const double length : {0.5, 0.8, 1.0})
      for (const double speed : {6.0, 12.0, 18.0, 20.0})
        for (const double aside : {0.0, 3.0})
          for (const double uneven : {0.0, 1e-5}) {
            CAPTURE(tile, length, speed, aside, uneven);
            Scene scene{.gravity_w = Vec3(aside, -9.81, 0.0)};
            for (int k = 0; k * tile < 0.7 * speed + 3.0; ++k) {
              scene.boxes.push_back({.name = "floor" + std::to_string(k),
                                     .size = Vec3(6.0, 1.0, tile),
                                     .fixed = true,
                                     .position_w = Vec3(0.0, -0.5 - uneven * (k % 3), k * tile),
                                     .friction = 0.0});
              scene.boxes.push_back({.name = "wall" + std::to_string(k),
                                     .size = Vec3(1.0, 6.0, tile),
                                     .fixed = true,
                                     .position_w = Vec3(1.0, 3.0, (k + 0.37) * tile),
                                     .friction = 0.0});
            }
            const double start = 1.0 + 0.5 * (tile - length);
            scene.boxes.push_back({.name = "slider",
                                   .size = Vec3(1.0, 0.6, length),
                                   .mass = 2.0,
                                   .position_w = Vec3(0.0, 0.3, start),
                                   .velocity_w = Vec3(0.0, 0.0, speed),
                                   .friction = 0.0});
            Simulation simulation(scene);
            simulation.run_for(0.6, 1.0 / 30.0);
            const Vec3 end_w(0.0, 0.3, start + 0.6 * speed);
            CHECK((simulation.body("slider").position_w() - end_w).norm() < 1e-5 + 50.0 * uneven);
          }
}

TEST_CASE("A box that spins on flush tiles without friction spins on where it is",
          "[unit][contact_damped]") {
  // Its corners go over seams, and it would trip over the sides of tiles that it leaves, or lands on.
  for (const double tile : {0.25, 0.5})
    for (const double edge : {0.5, 1.0})
      for (const double spin : {6.0, 15.0})
        for (const double height : {0.0, 0.05})
          for (const double dt : {1.0 / 60.0, 1.0 / 240.0}) {
            CAPTURE(tile, edge, spin, height, dt);
            Scene scene;
            for (int i = 0; i * tile < 3.0; ++i)
              for (int k = 0; k * tile < 3.0; ++k)
                scene.boxes.push_back({.name = "tile" + std::to_string(i) + "_" + std::to_string(k),
                                       .size = Vec3(tile, 0.2, tile),
                                       .fixed = true,
                                       .position_w = Vec3((i + 0.5) * tile, -0.1, (k + 0.5) * tile),
                                       .friction = 0.0});
            const Vec3 middle_w(1.0 + 0.5 * edge, 0.2, 1.0 + 0.5 * edge);
            scene.boxes.push_back({.name = "box",
                                   .size = Vec3(edge, 0.4, edge),
                                   .mass = 2.0,
                                   .position_w = middle_w + height * Vec3::UnitY(),
                                   .orientation_wb = rotation_from_vector(Vec3(0.0, 0.3, 0.0)),
                                   .angular_velocity_w = Vec3(0.0, spin, 0.0),
                                   .friction = 0.0});
            Simulation simulation(scene);
            simulation.run_for(1.0, dt);
            const BodyView box = simulation.body("box");
            CHECK((box.position_w() - middle_w).norm() < 5e-3);
            CHECK(std::abs(box.angular_velocity_w().y() - spin) < 1e-3 * spin);
          }
}
