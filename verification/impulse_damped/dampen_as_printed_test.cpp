/// \file
/// \brief The listings DAMPENOBJECTS and FIXCONTACTCONSTRAINTS as printed.
#include "tumble/impulse_damped/as_printed/damped_as_printed.hpp"
#include "tumble/impulse_damped/as_printed/dampen_objects_as_printed.hpp"
#include "tumble/impulse_damped/as_printed/fix_contact_constraints_as_printed.hpp"
#include "tumble/impulse_damped/damped.hpp"

#include "support/test.hpp"

namespace {

constexpr double dt = 1.0 / 60.0;  // [s]

const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);

World one_cube(const Vec3& place_w, const Vec3& momentum_w, const Vec3& spin_w) {
  World world;
  BodyState state = make_state(cube, place_w);
  state.linear_momentum_w = momentum_w;
  state.angular_momentum_w = spin_w;
  world.add(cube, state);
  return world;
}

constexpr DampedNumbers usual;  // what the technique has by default

PrintedNumbers numbers() { return {thresholds_of(usual, cube, 9.81, dt), factors_of(usual, dt)}; }

DampenReport dampen(World& world, bool touched, const DampedErrata& repaired) {
  const std::vector<std::uint8_t> flags(world.states().size(), touched ? 1 : 0);
  return dampen_objects_as_printed(world, flags, numbers(), dt, RotationRule::splitting, repaired);
}

Contact contact_between(int first, int second, const Vec3& normal_w, const Vec3& point_w) {
  Contact contact{.first = first, .second = second, .normal_w = normal_w, .count = 1};
  contact.points[0].position_w = point_w;
  return contact;
}

// How far the listing without its misprints and the reading as meant come, and how far apart.
struct Motion {
  double moved = 0.0;    // [m] largest change of a height
  double apart = 0.0;    // [m]
  double damping = 0.0;  // [J] that it adds
};

// Five lively cubes above each other, with gaps [m] below them, fall for a second.
Motion run_both(double gap) {
  World printed = ground_world();
  const BodyProperties lively = box_properties(Vec3::Ones(), 1.0, 0.5, 0.9);
  for (int k = 0; k < 5; ++k) printed.add(lively, Vec3(0.0, 0.5 + k + gap * (k + 1), 0.0));
  World meant = printed;
  const World start = printed;
  DampedAsPrintedOptions options;
  options.repaired = DampedErrata(
      "D2,D4,D5,D6,C1,C2,C3,C4,C5,C6,C7,C10,RK1,RK3,RC4,DM1,DM2,DM3,DM4,DM5,DM8,DM13,DM16,X1,X2");
  options.stable_boxes = false;
  DampedAsPrinted listing(options);
  DampedOptions standard{.stable_boxes = StableRule::off};
  standard.noise.where = Randomness::off;  // the listings know no chance
  Damped technique(standard);
  Motion motion;
  for (int step = 0; step < 60; ++step) {
    listing.step(printed, dt);
    motion.damping += technique.step(meant, dt).energy.damping;
    for (std::size_t k = 1; k < 6; ++k) {
      const Vec3& place_w = meant.states()[k].position_w;
      motion.apart = std::max(motion.apart, (printed.states()[k].position_w - place_w).norm());
      motion.moved =
          std::max(motion.moved, std::abs(place_w.y() - start.states()[k].position_w.y()));
    }
  }
  return motion;
}

}  // namespace

TEST_CASE("With all its misprints, the listing ends whatever is negative along y and z",
          "[exact][impulse_damped]") {
  // Line by line: k1 and k2; aligned exactly: p_y = -k1 is "small" and ended, k3; in the loop over
  // y, z and nothing, p_z and the spins about y and z are "small" too. x is never looked at.
  World world = one_cube(Vec3::Zero(), Vec3(-1.0, -1.0, -1.0), Vec3(-1.0, -1.0, -1.0));
  const DampenReport report = dampen(world, true, DampedErrata());
  const BodyState& state = world.states()[0];
  CHECK(state.linear_momentum_w.x() == near(-usual.k1, 1e-15));
  CHECK(state.linear_momentum_w.y() == 0.0);
  CHECK(state.linear_momentum_w.z() == 0.0);
  CHECK(state.angular_momentum_w.x() == near(-usual.k2 * usual.k3, 1e-15));
  CHECK(state.angular_momentum_w.y() == 0.0);
  CHECK(state.angular_momentum_w.z() == 0.0);
  // Line 22 moves with v + g dt.
  CHECK(state.position_w.x() == near(-usual.k1 * dt, 1e-15));
  CHECK(state.position_w.y() == near(-9.81 * dt * dt, 1e-15));
  CHECK(report.damped == 1);
  CHECK(report.moved == 1);
  CHECK(report.frozen == 0);
}

TEST_CASE("A loop of pushes that does not end is left at the cap and reported",
          "[exact][impulse_damped]") {
  // A normal along the ground never leads out of it.
  World world = ground_world();
  world.add(cube, Vec3(0.0, 0.4, 0.0));
  const Contact sideways = contact_between(0, 1, Vec3::UnitX(), Vec3::Zero());
  const PrintedFixReport report =
      fix_contact_constraints_as_printed(world, {&sideways, 1}, 1e-3, 250, DampedErrata());
  CHECK_FALSE(report.ended);
  CHECK(report.pushes == 250);
  CHECK(world.states()[1].position_w.x() == near(0.25, 1e-12));  // [m]

  World mended = ground_world();
  mended.add(cube, Vec3(0.0, 0.3995, 0.0));
  const PrintedFixReport ended =
      fix_contact_constraints_as_printed(mended, {&sideways, 1}, 1e-3, 250, DampedErrata("X1"));
  CHECK(ended.ended);
  CHECK(ended.pushes == 101);                        // 100.5 mm
  CHECK(ended.energy == near(9.81 * 0.101, 1e-12));  // [J]
}

TEST_CASE("Without its misprints the listing is the reading as meant",
          "[reference][impulse_damped]") {
  // Both were written from the thesis apart from each other. Cubes that fall on each other bounce,
  // are damped and pushed. Not at rest: there damping ends all motion. And straight down: once cubes
  // lean or shift, the centre of an overlap weighs depths in the one and not in the other.
  for (const double gap : {0.01, 0.1}) {
    INFO("gap " << gap << " m");
    const Motion motion = run_both(gap);
    CHECK(motion.moved > 1e-3);     // [m] measured 0.049 and 0.499
    CHECK(motion.damping < -1e-3);  // [J] measured -1.50 and -0.40
    CHECK(motion.apart < 1e-12);    // [m] measured 0
  }
}

TEST_CASE("Bad input of the printed listings is refused with its value", "[unit][impulse_damped]") {
  World world = one_cube(Vec3::Zero(), Vec3::Zero(), Vec3::Zero());
  const std::vector<std::uint8_t> two(2, 0);
  CHECK_THROWS_WITH(
      dampen_objects_as_printed(world, two, numbers(), dt, RotationRule::splitting, DampedErrata()),
      Contains("touched: 2 flags for 1 bodies"));
  const std::vector<std::uint8_t> one(1, 0);
  CHECK_THROWS_WITH(dampen_objects_as_printed(world, one, numbers(), 0.0, RotationRule::splitting,
                                              DampedErrata()),
                    Contains("dt"));
  CHECK_THROWS_WITH(fix_contact_constraints_as_printed(world, {}, 0.0, 1, DampedErrata()),
                    Contains("eps1"));
  CHECK_THROWS_WITH(fix_contact_constraints_as_printed(world, {}, 1e-3, 0, DampedErrata()),
                    Contains("cap = 0: give at least 1"));
}
