/// \file
/// \brief The cure: one twist for each body keeps groups together; what it leaves (claims 6.2c and 6.2d).
#include "driver/quick.hpp"
#include "exterior_rotation/falling_column.hpp"
#include "exterior_rotation/glued_runs.hpp"
#include "support/test.hpp"

using namespace tumble;
using namespace tumble::chapters;

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
