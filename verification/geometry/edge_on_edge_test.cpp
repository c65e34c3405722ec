/// \file
/// \brief Boxes that touch edge on edge: the normal at the ridge of a tent, and tents against statics.
#include "tumble/geometry/edge_on_edge.hpp"

#include "tumble/geometry/manifold.hpp"

#include "geometry/boxes.hpp"
#include "support/test.hpp"

namespace {

using Catch::Matchers::WithinAbs;

constexpr double kPi = std::numbers::pi;
const Vec3 kCard(2.5, 0.02, 1.25);  // [m]

// A card that leans towards +x (side 1) or -x (side -1), as far from the middle as half the gap between the cards' edges.
BodyState leaning(const BodyProperties& card, double angle, double gap, double side, double yaw) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double top = 0.5 * (kCard.x() * c + kCard.y() * s);
  const double height = 0.5 * (kCard.x() * s + kCard.y() * c);
  const Quat around = rotation_from_vector(Vec3(0.0, yaw, 0.0));
  return make_state(card, around * Vec3(-side * (top + 0.5 * gap), height, 0.0),
                    (around * rotation_from_vector(Vec3(0.0, 0.0, side * angle))).normalized());
}

World tent(double angle, double gap, double friction, double yaw) {
  World world = ground_world(friction, 0.0);
  const BodyProperties card = box_properties(kCard, 0.3, friction);
  for (const double side : {1.0, -1.0}) world.add(card, leaning(card, angle, gap, side, yaw));
  return world;
}

Manifold at_ridge(const World& world, double margin) {
  Manifold out;
  collide(box_of(world.bodies()[1], world.states()[1]),
          box_of(world.bodies()[2], world.states()[2]), margin, kNoAxis, out);
  return out;
}

// [m] How far the middle of a card of a tent has sunk after a time.
double sunk(const char* technique, const World& start, double dt, double duration) {
  World world = start;
  const std::unique_ptr<Technique> stepper = make_technique(technique);
  for (double t = 0.0; t < duration; t += dt)
    REQUIRE(stepper->step(world, dt).status == StepStatus::done);
  return start.states()[1].position_w.y() - world.states()[1].position_w.y();
}

}  // namespace

TEST_CASE("A tent of two cards has a horizontal normal at its ridge", "[exact][manifold]") {
  for (const double degrees : {50.0, 60.0, 75.0}) {
    for (const double gap : {-1e-4, -1e-9, 0.0, 1e-9, 1e-4, 1e-2}) {
      for (const double yaw : {0.0, 0.6}) {
        CAPTURE(degrees, gap, yaw);
        const Manifold found = at_ridge(tent(degrees * kPi / 180.0, gap, 0.5, yaw), 2e-2);
        REQUIRE(found.count == 2);
        CHECK((found.normal_w - Vec3(std::cos(yaw), 0.0, -std::sin(yaw))).norm() < 1e-6);
        for (const ManifoldPoint& p : {found.points[0], found.points[1]}) {
          CHECK_THAT(p.distance, WithinAbs(gap, 1e-12));
          CHECK_THAT(std::hypot(p.position_w.x(), p.position_w.z()), WithinAbs(0.625, 1e-9));
        }
      }
    }
  }
}

TEST_CASE("Blocks laid in rows do not push each other across a common edge", "[exact][manifold]") {
  Manifold found;
  collide(cube_at(Vec3::Zero()), cube_at(Vec3(1.0, 1.0, 0.0)), 0.01, kNoAxis, found);
  CHECK_THAT(found.normal_w.cwiseAbs().maxCoeff(), WithinAbs(1.0, 1e-15));
}

TEST_CASE("Corners that lie on each other do not touch along their upright edges",
          "[exact][manifold]") {
  // The tip of a cube that is turned by 45 degrees lies 0.4 mm inside the corner of the top of another one.
  const double inside = 4e-4, deep = 1e-5;  // [m]
  const Quat yaw = about(Vec3::UnitY(), 0.25 * kPi);
  const Vec3 center_w = Vec3(0.5 - inside, 1.0 - deep, -0.5 + inside) - yaw * Vec3(-0.5, 0.0, 0.5);
  Manifold found;
  REQUIRE(collide(cube_at(Vec3::Zero()), cube_at(center_w, yaw), 0.01, kNoAxis, found));
  CHECK_THAT(found.normal_w.y(), WithinAbs(1.0, 1e-12));
}

// A card of weight W that leans at an angle a presses the other one by W / (2 tan a) and the ground by W.
TEST_CASE("A tent stands if friction is more than 1 / (2 tan a), and only then",
          "[unit][manifold][time_stepping][contact_damped][analytic][impulse]") {
  for (const char* technique : {"contact_damped", "time_stepping", "analytic", "impulse"}) {
    for (const double degrees : {50.0, 60.0, 70.0}) {
      const double angle = degrees * kPi / 180.0, needed = 0.5 / std::tan(angle);
      CAPTURE(technique, degrees);
      for (const double gap : {0.0, 1e-2}) {
        CAPTURE(gap);
        const double sinks = 0.5 * gap / std::tan(angle);  // [m] until the edges meet
        CHECK(std::abs(sunk(technique, tent(angle, gap, 1.15 * needed, 0.6), 1.0 / 60.0, 1.0)) <
              sinks + 0.002);
      }
      CHECK(sunk(technique, tent(angle, 0.0, 0.85 * needed, 0.6), 1.0 / 60.0, 1.0) > 0.05);
    }
  }
}
