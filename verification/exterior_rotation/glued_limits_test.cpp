/// \file
/// \brief The technique for bodies that stick: refusals, and worlds at its limits.
#include "tumble/exterior_rotation/glued.hpp"

#include "exterior_rotation/cases.hpp"
#include "support/test.hpp"

namespace {

World glued_pair(double spin) {
  World world = weightless_world();
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  const Vec3 spin_w(0.0, 0.0, spin);
  for (const Vec3& place_w : {Vec3(-0.5, 0.0, 0.0), Vec3(0.5, 0.0, 0.0)})
    world.add(cube, place_w, Quat::Identity(), spin_w.cross(place_w), spin_w);
  return world;
}

}  // namespace

TEST_CASE("Wrong options of the glued technique are refused with the right ones",
          "[unit][exterior_rotation]") {
  for (const double accuracy : {0.0, 1e-15, 2.0, kNan}) {
    CHECK_THROWS_WITH(Glued({.accuracy = accuracy}), Contains("accuracy"));
  }
  for (const GluedScheme scheme :
       {GluedScheme::rk4, GluedScheme::dormand_prince, GluedScheme::midpoint})
    CHECK_THROWS_WITH(Glued(way(scheme, PoseUpdate::exponential)),
                      Contains("pose = exponential") && Contains(std::string(name_of(scheme))) &&
                          Contains("leapfrog"));
  const TechniqueRecipe& recipe = technique_recipe("glued");
  Parameters p = recipe.options();
  CHECK_THROWS_WITH(p.set("scheme", "euler"), Contains("forward_euler"));
  CHECK_THROWS_WITH(p.set("joints", "loose"), Contains("unilateral"));
  CHECK_THROWS_AS(p.set("accuracy", "0"), std::invalid_argument);
  p.set("pose", "exponential");
  CHECK_THROWS_WITH(recipe.make(p, 1), Contains("rk4"));
  p.set("scheme", "leapfrog");
  CHECK(recipe.make(p, 1)->name() == "glued");

  World world = world_of("fig6_2");
  Glued technique;
  for (const double dt : {0.0, -1.0, kInfinity})
    CHECK_THROWS_WITH(technique.step(world, dt), Contains("dt"));
}

TEST_CASE("Bodies without weight and without a push stay in every joint that only presses",
          "[unit][exterior_rotation]") {
  for (GluedOptions options : all_ways()) {
    INFO(text_of(options));
    options.joints = GluedJoints::unilateral;
    World pair = glued_pair(0.0);
    const World start = pair;
    Glued technique(options);
    run(pair, technique, 10);
    CHECK(technique.joints()[0].hold == JointHold::area);
    CHECK(same_states(pair, start));
  }
}

TEST_CASE("Excessive velocities end a step of the glued technique with a reason",
          "[unit][exterior_rotation]") {
  for (const GluedOptions& options : all_ways())
    for (const double speed : {1e4, 1e100, 1e200, 1e300})
      for (const bool spins : {false, true}) {
        INFO(text_of(options) << ", " << speed << (spins ? " rad/s" : " m/s"));
        World world = glued_pair(0.0);
        // By way of no check, as with NaN below.
        world.states()[1] = make_state(world.bodies()[1], world.states()[1].position_w,
                                       world.states()[1].orientation_wb,
                                       spins ? Vec3::Zero() : Vec3(speed, 0.0, 0.0),
                                       spins ? Vec3(0.0, 0.0, speed) : Vec3::Zero());
        Glued technique(options);
        try {
          const StepReport report = technique.step(world, kFrame);
          CHECK(report.iterations < 20000);
        } catch (const std::invalid_argument& error) {
          CHECK_FALSE(std::string(error.what()).empty());
        }
      }
  // NaN, set by way of no check.
  for (const GluedOptions& options : all_ways()) {
    World world = glued_pair(1.0);
    world.states()[0].linear_momentum_w.x() = kNan;
    Glued technique(options);
    bool told = false;
    try {
      technique.step(world, kFrame);
      told = !all_finite(world);
    } catch (const std::invalid_argument&) {
      told = true;
    }
    INFO(text_of(options));
    CHECK(told);
  }
}

TEST_CASE(
    "A body that turns more than once in a step is refused by fixed steps and followed by others",
    "[unit][exterior_rotation]") {
  World world;
  const Vec3 spin_w(0.0, 0.0, 500.0);
  world.add(box_properties(Vec3::Ones(), 1.0), Vec3::Zero(), Quat::Identity(), Vec3::Zero(),
            spin_w);
  const World start = world;
  Glued fixed(way(GluedScheme::rk4));
  CHECK_THROWS_WITH(fixed.step(world, kFrame), Contains("dt = ") && Contains("full turn"));
  CHECK(same_states(world, start));
  Glued free(way(GluedScheme::dormand_prince));
  free.step(world, kFrame);
  CHECK(angle_between(world.states()[0].orientation_wb, rotation_from_vector(kFrame * spin_w)) <
        1e-12);  // [rad] about a fixed axis: rounding
}

TEST_CASE(
    "More than 600 rows of joints that close loops are refused with their number and what to do",
    "[unit][exterior_rotation]") {
  World world;
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  for (int k = 0; k < 2; ++k) world.add(cube, Vec3(k, 0.0, 0.0));
  Joint joint;  // a point, held more than two hundred times
  joint.second = 1;
  joint.count = 1;
  joint.hold = JointHold::corner;
  std::vector<Joint> joints(202, joint);
  std::vector<MovingBody> moving = moving_bodies(world);
  std::vector<Wrench> rates;
  CHECK_THROWS_WITH(JointForces().hold(world, moving, joints, rates),
                    Contains("603 rows") && Contains("600 at most") && Contains("leave out"));
  joints.pop_back();
  CHECK_NOTHROW(JointForces().hold(world, moving, joints, rates));
}
