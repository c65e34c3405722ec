/// \file
/// \brief A row of glued boxes that breaks, against a beam (after thesis 2.4.1).
#include "tumble/fracture/breaking_row.hpp"

#include "tumble/contact_damped/contact_damped.hpp"

#include "support/test.hpp"

namespace {

RowOptions plank(RowRule rule = RowRule::stress) {
  return RowOptions{.density = 2500.0, .strength = 1e6, .rule = rule};
}

// Momentum and angular momentum about the origin.
std::array<Vec3, 2> momenta_of(const World& world) {
  std::array<Vec3, 2> sum{Vec3::Zero(), Vec3::Zero()};
  for (const BodyState& state : world.states()) {
    sum[0] += state.linear_momentum_w;
    sum[1] += state.position_w.cross(state.linear_momentum_w) + state.angular_momentum_w;
  }
  return sum;
}

double mass_of(const World& world) {
  double sum = 0.0;
  for (const BodyProperties& body : world.bodies()) sum += body.movable() ? body.mass : 0.0;
  return sum;
}

}  // namespace

TEST_CASE("A row of glued boxes carries the bending moments of a beam", "[exact][breaking_row]") {
  // Free, pushed up at both ends and down in the middle: the moment of the pushes less that of the row's own mass, which
  // does not accelerate.
  World world = weightless_world();
  BreakingRow row(world, plank(), Vec3::Zero());
  ContactDamped technique;
  const double force = 10.0;
  row.push(world, Vec3(0.0, 0.5 * force * kFrame, 0.0), 0.0);
  row.push(world, Vec3(0.0, 0.5 * force * kFrame, 0.0), 1.0);
  row.push(world, Vec3(0.0, -force * kFrame, 0.0), 0.5);
  CHECK(row.step(world, technique, kFrame).events == 0);
  REQUIRE(row.loads().size() == 39);
  for (const JointLoad& load : row.loads()) {
    const double x = (load.joint + 1) / 40.0;
    CHECK(std::abs(load.torque_b.z()) == near(0.5 * force * std::min(x, 1.0 - x), 1e-9));
    if (load.joint < 19) CHECK(load.force_b.y() == near(0.5 * force, 1e-9));
  }
  // σ = M c / I, over the strength
  const double stress = 0.25 * force * 0.025 / (0.1 * 0.05 * 0.05 * 0.05 / 12.0);
  CHECK(row.loads()[19].share == near(stress / 1e6, 1e-12));
  CHECK(row.joints_solved() == 39);
}

TEST_CASE("A row that falls freely or spins slowly carries nothing but its centripetal tension",
          "[exact][breaking_row]") {
  World world;
  BreakingRow row(world, plank(), Vec3::Zero());
  ContactDamped technique;
  row.step(world, technique, kFrame);
  for (const JointLoad& load : row.loads()) CHECK(load.share < 1e-9);
  const double spin = 2.0;  // [rad/s] about z
  world.set_velocity(row.pieces()[0].body, Vec3::Zero(), Vec3(0.0, 0.0, spin));
  row.step(world, technique, kFrame);
  // ρ ω² L²/8 in the middle
  const double tension = 2500.0 * spin * spin / 8.0;
  CHECK(row.loads()[19].share == near(tension / 1e6, 1e-9));
}

TEST_CASE("A row of glued boxes breaks where the moment is largest, and keeps mass and momenta",
          "[exact][breaking_row]") {
  for (const RowRule rule : {RowRule::stress, RowRule::force}) {
    World world = weightless_world();
    BreakingRow row(world, plank(rule), Vec3(0.2, 0.3, 0.4), Vec3(1.0, 2.0, 3.0));
    world.set_velocity(row.pieces()[0].body, Vec3(1.0, 2.0, 3.0), Vec3(0.1, 0.2, 0.3));
    const double mass = mass_of(world);
    ContactDamped technique;
    const double force = rule == RowRule::stress ? 200.0 : 20000.0;
    row.push(world, Vec3(0.0, 0.5 * force * kFrame, 0.0), 0.0);
    row.push(world, Vec3(0.0, 0.5 * force * kFrame, 0.0), 1.0);
    row.push(world, Vec3(0.0, -force * kFrame, 0.0), 0.5);
    const std::array<Vec3, 2> before = momenta_of(world);
    CHECK(row.step(world, technique, kFrame).events == 1);
    REQUIRE(row.pieces().size() == 2);
    CHECK(row.pieces()[0].count + row.pieces()[1].count == 40);
    if (rule == RowRule::stress) CHECK(row.pieces()[0].count == 20);
    CHECK(mass_of(world) == near(mass, 1e-12));
    const std::array<Vec3, 2> after = momenta_of(world);
    CHECK((after[0] - before[0]).norm() < 1e-9 * before[0].norm());
    CHECK((after[1] - before[1]).norm() < 1e-9 * (1.0 + before[1].norm()));
  }
}

TEST_CASE("A row that cannot be is refused with its value", "[unit][breaking_row]") {
  World world;
  RowOptions options = plank();
  options.boxes = 1;
  CHECK_THROWS_WITH(BreakingRow(world, options, Vec3::Zero()), Contains("boxes = 1"));
  options = plank();
  options.strength = -1.0;
  CHECK_THROWS_WITH(BreakingRow(world, options, Vec3::Zero()), Contains("strength"));
  options = plank();
  options.density = 0.0;
  CHECK_THROWS_WITH(BreakingRow(world, options, Vec3::Zero()), Contains("density"));
}
