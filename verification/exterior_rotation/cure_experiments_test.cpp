/// \file
/// \brief The cure: one twist for each body keeps groups together; what it leaves (claims 6.2c and 6.2d).
#include "driver/quick.hpp"
#include "exterior_rotation/falling_column.hpp"
#include "exterior_rotation/glued_runs.hpp"
#include "support/test.hpp"

using namespace tumble;
using namespace tumble::chapters;

TEST_CASE("One force and one torque carry each box of a falling column round its circle",
          "[claims][exterior_rotation]") {
  const FigureUnderTest figure("claim_6_2d_one_twist");
  // What the claim's rule calls refuted is 1e-9; what was asked of the cure is 1e-12.
  CHECK(
      figure.number(
          "largest gap or overlap of figure 6.1's column in a second of its fall at 60 steps a "
          "second, each body moved by the exponential of its own twist with the same forces, over "
          "an edge") < 1e-12);  // [-] measured 4e-15
  CHECK(figure.number("the same in any direction, not only along the normal") < 1e-12);  // [m]
  CHECK(figure.number("largest gap or overlap, centre and orientation apart") ==
        near(5.337e-3, 5e-7));  // [m] evaluated apart from this code
}

TEST_CASE("One twist for each body leaves the error of the column's angle as large as it was",
          "[reference][exterior_rotation]") {
  const FigureUnderTest figure("claim_6_2d_one_twist");
  // [rad] evaluated apart from this code, five digits.
  CHECK(figure.number("error of the angle, forward Euler, apart") == near(-2.8388e-2, 5e-7));
  CHECK(figure.number("error of the angle, semi-implicit Euler, apart") == near(1.1521e-2, 5e-7));
  CHECK(figure.number("error of the angle, impulses, apart") == near(1.1431e-2, 5e-7));
  CHECK(figure.number("error of the angle, impulses, one twist") == near(1.2980e-2, 5e-7));
  CHECK(figure.number("error of the angle, leapfrog, one twist") == near(-6.6931e-5, 5e-10));
  for (const char* scheme : {"forward Euler", "semi-implicit Euler", "impulses", "leapfrog"}) {
    const std::string name = std::string("error of the angle, ") + scheme;
    const double ratio = figure.number(name + ", one twist") / figure.number(name + ", apart");
    INFO(scheme);
    CHECK(ratio > 0.8);  // [-] measured 0.91 to 1.22
    CHECK(ratio < 1.3);
  }
}

TEST_CASE(
    "Groups moved by one twist for each body hold together at every step, in space and in flight",
    "[claims][exterior_rotation]") {
  const std::array<World, 3> worlds = {column_world(0.3), column_on_corner(0.3, 2.0),
                                       column_in_flight(Vec3(2.0, 3.0, 0.5), Vec3(3.0, 1.0, 2.0))};
  for (const World& start : worlds)
    for (const GluedScheme scheme : {GluedScheme::semi_implicit, GluedScheme::leapfrog})
      for (const int rate : {5, 60}) {
        INFO(name_of(scheme) << " at " << rate);
        const GluedOptions options = glued_options(scheme, PoseUpdate::exponential);
        CHECK(run_glued(start, options, 1.0 / rate, rate).apart < 1e-12);  // [m]
      }
}

TEST_CASE("The centre of a group in flight goes straight, whatever scheme turns its twists",
          "[exact][exterior_rotation]") {
  World start = column_in_flight(Vec3(2.0, 3.0, 0.5), Vec3(3.0, 1.0, 2.0));
  start.gravity_w.setZero();
  const GroupMotion before = motion_of(start);
  for (const GluedScheme scheme : {GluedScheme::forward_euler, GluedScheme::semi_implicit,
                                   GluedScheme::impulse, GluedScheme::leapfrog})
    for (const int rate : {5, 60}) {
      const GluedRun run =
          run_glued(start, {.scheme = scheme, .pose = PoseUpdate::exponential}, 1.0 / rate, rate);
      const GroupMotion after = motion_of(run.world);
      INFO(name_of(scheme) << " at " << rate);
      CHECK((after.centre_w - before.centre_w - before.momentum_w / before.mass).norm() < 1e-12);
      CHECK((after.momentum_w - before.momentum_w).norm() < 1e-12);  // [N s]
      CHECK(run.apart < 1e-12);                                      // [m]
    }
}

TEST_CASE("The best single rotation of figure 6.3 leaves less than one twist each, a tree nothing",
          "[claims][exterior_rotation]") {
  const FigureUnderTest figure("claim_6_2c_one_pivot");
  CHECK(figure.number(
            "gap or overlap that the best single rotation leaves in a step of figure 6.3 at 60 "
            "steps a second, over what one rotation for each body leaves") <= 2.0);  // 0.0033
  CHECK(figure.number("largest ratio of the best single rotation to one twist each, upper box "
                      "within 10 rad/s") <= 2.0);  // [-] measured 0.65
  // Over a lower box that hardly turns the verdict would be another one.
  CHECK(figure.number("the same ratio for spins of -0.3 and -9 rad/s") > 2.0);  // [-] measured 2.6
  CHECK(figure.number("what the best single rotation leaves") > 1e-7);  // [m] measured 2.6e-6
  CHECK(figure.number("what a tree of pivots leaves") < 1e-14);         // [m] measured 0
}

TEST_CASE(
    "Twists that meet at a moving joint part by half h² times the spins' difference and its speed",
    "[exact][exterior_rotation]") {
  const FigureUnderTest figure("claim_6_2c_one_pivot");
  const double predicted = figure.number("half h² |Δω| |v_p|");
  // 3 rad/s, and 1.5 rad/s with a lever of 1.25 m; 60 steps a second.
  CHECK(predicted == near(0.5 * 3.0 * 1.5 * 1.25 / 3600.0, 1e-15));
  CHECK(figure.number("what one twist for each body leaves") ==
        near(predicted, 1e-4 * predicted));  // [m] the next order is 5e-5 of it
  CHECK(figure.number("order of the mismatch in the step, one twist each") == near(2.0, 0.001));
  CHECK(figure.number("largest error of the prediction in the shortest step, over it") < 1e-5);
}
