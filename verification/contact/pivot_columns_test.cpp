/// \file
/// \brief A column that turns about an edge, by each technique that can carry bodies.
#include "tumble/contact/pivot_update.hpp"

#include "support/test.hpp"

namespace {

constexpr double kLean = 0.3;  // [rad] of the centre of mass about the edge, at the start
// [rad] The same after half a second, from the closed form of a pendulum whose bodies are glued.
constexpr double kLeanAfterHalf = 0.441380063385;

// Four unit cubes with a friction of 10, leaning over the edge of a fixed box, at rest. The whole may be
// turned about the vertical, so that nothing is along an axis.
World leaning_column(double yaw) {
  World world;
  const Quat around = rotation_from_vector(Vec3(0.0, yaw, 0.0));
  const Quat lean = rotation_from_vector(Vec3(0.0, 0.0, -(kLean + std::atan(0.25))));
  const Vec3 edge_w(0.0, 2.0, 0.0);
  const BodyProperties table = fixed_box_properties(Vec3(4.0, 4.0, 4.0), 10.0);
  world.add(table, around * Vec3(-2.0, 0.0, 0.0), around);
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, 10.0);
  for (int k = 0; k < 4; ++k)
    world.add(cube, around * (edge_w + lean * Vec3(-0.5, 0.5 + k, 0.0)),
              (around * lean).normalized());
  return world;
}

std::unique_ptr<Technique> made(const std::string& name, PoseUpdate pose) {
  return make_technique(name, {"pose=" + std::string(name_of(pose))});
}

struct Fall {
  double gap = 0.0;       // [m] most by which the middles of two faces that were one are apart
  double slipped = 0.0;   // [m] of the lowest cube's edge from the table's, in the end
  double lean = 0.0;      // [rad] of the centre of mass in the end
  double unbooked = 0.0;  // [J] change of energy that is not booked, in all
};

Fall fall(const std::string& name, PoseUpdate pose, double yaw = 0.0) {
  World world = leaning_column(yaw);
  const std::unique_ptr<Technique> technique = made(name, pose);
  Fall seen;
  const double start = energy_of(world).total();
  double booked = 0.0;
  for (int step = 0; step < 30; ++step) {
    const StepReport report = technique->step(world, kFrame);
    CHECK(report.status == StepStatus::done);
    booked += report.energy.total();
    for (int k = 1; k < 4; ++k) {
      const BodyState& below = world.states()[idx(k)];
      const BodyState& above = world.states()[idx(k + 1)];
      const Vec3 apart_w = above.position_w - above.orientation_wb * Vec3(0.0, 0.5, 0.0) -
                           below.position_w - below.orientation_wb * Vec3(0.0, 0.5, 0.0);
      seen.gap = std::max(seen.gap, apart_w.norm());
    }
  }
  Vec3 middle_w = Vec3(0.0, -2.0, 0.0);
  for (int k = 1; k < 5; ++k) middle_w += 0.25 * world.states()[idx(k)].position_w;
  const BodyState& lowest = world.states()[1];
  const Vec3 edge_w = lowest.position_w + lowest.orientation_wb * Vec3(0.5, -0.5, 0.0);
  seen.slipped = (edge_w - Vec3(0.0, 2.0, 0.0)).norm();
  seen.lean = std::atan2(std::hypot(middle_w.x(), middle_w.z()), middle_w.y());
  seen.unbooked = energy_of(world).total() - start - booked;
  return seen;
}

}  // namespace

TEST_CASE("Analytic forces and time stepping keep a falling column together by its exponential",
          "[exact][exterior_rotation][time_stepping][analytic]") {
  for (const char* name : {"analytic", "time_stepping"}) {
    for (const double yaw : {0.0, 0.7}) {
      INFO(name << ", yaw " << yaw);
      CHECK(fall(name, PoseUpdate::separate, yaw).gap > 2e-5);      // [m] measured 5e-5
      CHECK(fall(name, PoseUpdate::exponential, yaw).gap < 1e-12);  // [m] measured 4e-15
    }
  }
}

TEST_CASE("A falling column comes apart less by its exponential with solvers that leave something",
          "[unit][exterior_rotation][contact_damped][impulse]") {
  // [m] Between the cubes: 6e-5 and 4e-6, what the solver leaves in fast heaps.
  CHECK(fall("contact_damped", PoseUpdate::separate).gap > 2e-5);
  CHECK(fall("contact_damped", PoseUpdate::exponential).gap < 1e-5);
  // impulse's passes do not agree on the cubes yet (5e-4 to 1e-3 m with both rules); on the table: 2e-5 and 8e-8.
  CHECK(fall("impulse", PoseUpdate::separate).slipped > 1e-5);
  CHECK(fall("impulse", PoseUpdate::exponential).slipped < 1e-6);
}

TEST_CASE("A column falls as fast by its exponential as the pendulum that it is",
          "[exact][exterior_rotation][time_stepping][contact_damped][analytic]") {
  for (const PoseUpdate pose : pose_updates()) {
    INFO(name_of(pose));
    // [rad] Half a step of the acceleration for the semi-implicit rule; the midpoint's error of order two.
    CHECK(std::abs(fall("time_stepping", pose).lean - kLeanAfterHalf) < 6e-3);
    CHECK(std::abs(fall("contact_damped", pose).lean - kLeanAfterHalf) < 6e-3);
    CHECK(std::abs(fall("analytic", pose).lean - kLeanAfterHalf) < 2e-5);
    CHECK(std::abs(fall("analytic", pose).unbooked) < 1e-11);  // [J]
  }
}
