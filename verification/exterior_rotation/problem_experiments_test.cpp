/// \file
/// \brief Figures 6.1 to 6.3: what opens, by how much in a step, and one twist for each body, which keeps groups together.
#include "driver/played_scene.hpp"
#include "exterior_rotation/falling_column.hpp"
#include "exterior_rotation/glued_runs.hpp"
#include "exterior_rotation/held_run.hpp"
#include "exterior_rotation/nested_pendulum.hpp"
#include "exterior_rotation/pushed_column.hpp"
#include "exterior_rotation/side_view.hpp"
#include "support/test.hpp"

using namespace tumble::chapters;

namespace {

World nested_start() { return build_world(make_scene("fig6_3")); }

}  // namespace

TEST_CASE(
    "A step opens a joint by half the square of its turn under forward Euler and closes it by "
    "as much under semi-implicit Euler",
    "[exact][exterior_rotation]") {
  const double turn = 2.0;  // [rad/s]
  const double dt = 1e-4;   // [s] the next term of the error is of the size of dt
  const double arc = 0.5 * turn * turn * dt * dt;
  const World column = column_world(0.5, turn);
  const auto gap = [&](std::size_t scheme) {
    return gap_of_step(column, options_of(film_schemes()[scheme]), dt);
  };
  CHECK(gap(0) == near(arc, 1e-3 * arc));
  CHECK(gap(1) == near(-arc, 1e-3 * arc));
  CHECK(gap(2) == near(arc, 1e-3 * arc));
}

TEST_CASE(
    "Forces in the joints of figures 6.1 and 6.3 are right at the start of each step that "
    "opens them",
    "[exact][exterior_rotation]") {
  for (const World& start : {column_world(0.3), nested_start()}) {
    const HeldRun run = run_held(start, options_of(film_schemes()[0]), kStep, 36);
    CHECK(run.acceleration < 1e-12 * start.gravity_w.norm());  // rounding; measured 1e-15
    CHECK(farthest_apart(run.frames.back()) > 1e-3);
  }
}

TEST_CASE("Forces at an instant are found wrong if a joint is forgotten",
          "[unit][exterior_rotation]") {
  World world = column_world(0.3, 1.0);
  std::vector<Joint> joints = run_held(world, {}, kStep, 0).joints;
  CHECK(relative_acceleration(world, joints) < 1e-12);
  // Without glue at the top the highest cube falls as it likes: another joint's points do not care, so
  // its own are asked for by a joint that is held no more.
  joints.back().hold = JointHold::nothing;
  CHECK(relative_acceleration(world, joints) > 1.0);
}

TEST_CASE("The nested boxes of figure 6.3 move as a double pendulum",
          "[reference][exterior_rotation]") {
  const World start = nested_start();
  const HeldRun run = run_held(start, options_of(film_schemes()[5]), kStep, 36);
  for (const int k : {6, 18, 36}) {
    const HeldFrame& frame = run.frames[idx(k)];
    const NestedAngles found = nested_angles(run.world(frame));
    const NestedAngles judged = nested_pendulum(start, frame.time);
    CHECK(found.lower == near(judged.lower, 1e-11));
    CHECK(found.upper == near(judged.upper, 1e-11));
  }
}

TEST_CASE("A column that is pushed along moves as one and feels the push in its glue",
          "[exact][exterior_rotation]") {
  const double push = 40.0;  // [N]
  const PushedRun run = push_column(4, push, kStep, 60);
  // Forward Euler from rest: x = a h^2 n (n - 1) / 2.
  CHECK(run.way == near(0.5 * push / 4.0 * kStep * kStep * 60.0 * 59.0, 1e-11));
  CHECK(run.force == near(push / 4.0, 1e-11));  // a joint at an end moves one cube of four
  CHECK(run.gap < 1e-13);
  CHECK(run.gaps.size() == 61);
  // An odd number is pushed in the middle of its middle one.
  CHECK(push_column(3, push, kStep, 60).gap < 1e-13);
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
