/// \file
/// \brief The technique for bodies that stick: memory, changes between steps, reports.
#include "tumble/exterior_rotation/glued.hpp"

#include "exterior_rotation/cases.hpp"
#include "support/test.hpp"

TEST_CASE("Finding the joints before the first step changes nothing", "[unit][exterior_rotation]") {
  for (const char* spin : {"0", "2"})
    for (const GluedEvents events : {GluedEvents::located, GluedEvents::step_end}) {
      GluedOptions options{.joints = GluedJoints::unilateral, .events = events};
      World one = world_of("fig6_1", {{"angle", "0.9"}, {"spin", spin}});
      World other = one;
      Glued late(options);
      Glued early(options);
      CHECK(early.joints().empty());
      early.find(other);
      CHECK(early.joints().size() == 4);
      const StepReport first = late.step(one, kFrame);
      const StepReport second = early.step(other, kFrame);
      CHECK(same_states(one, other));
      CHECK(first.events == second.events);
    }
}

TEST_CASE("Bodies that come and go between steps leave the others glued",
          "[unit][exterior_rotation]") {
  // Forward Euler has opened the column's joints by more than the margin of glue.
  World world = world_of("fig6_1");
  World alone = world;
  Glued technique(way(GluedScheme::forward_euler));
  Glued undisturbed(way(GluedScheme::forward_euler));
  run(world, technique, 30);
  run(alone, undisturbed, 30);
  CHECK(gap_of(technique.joints(), world.states()).apart > 1e-4);
  const BodyId guest = world.add(box_properties(Vec3::Ones(), 1.0), Vec3(-2.0, 2.5, 0.0));
  run(world, technique, 5);
  run(alone, undisturbed, 5);
  CHECK(technique.joints().size() == 5);
  for (std::size_t k = 0; k < alone.states().size(); ++k)
    CHECK((alone.states()[k].position_w - world.states()[k].position_w).norm() < 1e-12);
  CHECK(world.states()[6].position_w == Vec3(-2.0, 2.5, 0.0));  // it stands
  world.remove(guest);
  run(world, technique, 5);
  run(alone, undisturbed, 5);
  CHECK(technique.joints().size() == 4);
  CHECK(apart(world, alone) < 1e-12);  // [m, -] rounding
  // A box whose support is removed falls freely, together with the boxes on it.
  const Vec3 v = velocity(world.bodies()[4], world.states()[4]);
  world.remove(world.ids()[2]);
  run(world, technique, 1);
  CHECK(technique.joints().size() == 2);
  Vec3 momentum_w = Vec3::Zero();
  for (std::size_t k = 2; k < 5; ++k) momentum_w += world.states()[k].linear_momentum_w;
  CHECK(v.norm() > 0.1);
  CHECK(technique.contacts().size() == 2);
}

TEST_CASE("The glued technique reports the pivot's force and the centre of pressure of each joint",
          "[exact][exterior_rotation]") {
  World world = world_of("fig6_1", {{"angle", "0.3"}});
  Glued technique;
  const double dt = 1e-9;  // [s] contacts are those of a step's end: nothing has moved
  const StepReport report = technique.step(world, dt);
  REQUIRE(technique.contacts().size() == 4);
  CHECK(report.contacts == 4);
  const ContactRecord& pivot = technique.contacts()[0];
  CHECK(pivot.first == world.ids()[1]);
  CHECK(pivot.second == world.ids()[2]);
  CHECK_FALSE(pivot.is_impulse);
  CHECK(pivot.state == ContactState::stick);
  CHECK((pivot.point_w - Vec3(0.0, 2.0, 0.0)).norm() < 1e-12);  // [m]
  CHECK((pivot.normal_w - Vec3::UnitY()).norm() < 1e-14);
  CHECK((pivot.push_w / (4.0 * 9.81) - Vec3(0.2117409275, 0.9345008556, 0.0)).norm() < 1e-8);
  const std::array<double, 3> centres = {0.1866083421, 0.3337873452, 0.4415370095};
  for (std::size_t k = 0; k < 3; ++k) {
    const ContactRecord& contact = technique.contacts()[k + 1];
    const BodyState& lower = world.states()[k + 2];
    const Vec3 point_b = lower.orientation_wb.conjugate() * (contact.point_w - lower.position_w);
    CHECK(0.5 - point_b.x() == near(centres[k], 1e-8));  // [m] from the pivot's side
    CHECK(point_b.y() == near(0.5, 1e-12));
    CHECK(point_b.z() == near(0.0, 1e-12));
  }
  CHECK(technique.ignores(world) ==
        std::vector<std::string>{"collisions", "contacts other than those at the start",
                                 "limits of friction"});
}

TEST_CASE("Dormand and Prince's steps meet the requested accuracy at the expected cost",
          "[reference][exterior_rotation]") {
  World truth = world_of("fig6_1");
  Glued fine(way(GluedScheme::rk4));
  run(truth, fine, 2000, 1.0 / 2000);  // [m, -] error 1e-14
  int before = 0;
  for (const double accuracy : {1e-5, 1e-7, 1e-9, 1e-11, 1e-13}) {
    World world = world_of("fig6_1");
    GluedOptions options = way(GluedScheme::dormand_prince);
    options.accuracy = accuracy;
    Glued technique(options);
    const StepReport report = technique.step(world, 1.0);
    const int steps = technique.solves() / 7;
    INFO(accuracy << ": " << steps << " steps, off by " << apart(world, truth));
    // Errors of steps add and grow with the fall, by e^(1.9) at most.
    CHECK(apart(world, truth) < 10.0 * steps * accuracy + 1e-13);
    CHECK(report.iterations == technique.solves());
    CHECK(technique.solves() > before);
    CHECK(technique.solves() < 3500);
    before = technique.solves();
  }
  // A step that is cut at the end of a frame does not shorten the next one.
  GluedOptions options = way(GluedScheme::dormand_prince);
  options.accuracy = 1e-12;
  World world = world_of("fig6_1");
  Glued technique(options);
  run(world, technique, 4, 0.25);
  World once = world_of("fig6_1");
  Glued whole(options);
  whole.step(once, 1.0);
  CHECK(technique.solves() < 1.2 * whole.solves());
}

TEST_CASE("Orders of the glued column are 1, 1, 1, 2 and 4", "[reference][exterior_rotation]") {
  const World start = world_of("fig6_1");
  World truth = start;
  Glued fine(way(GluedScheme::rk4));
  run(truth, fine, 2000, 1.0 / 2000);  // [m, -] error 1e-14
  struct Case {
    GluedScheme scheme;
    double order;
    int steps;  // above rounding, and enough for the leading term
  };
  for (const Case& c :
       {Case{GluedScheme::forward_euler, 1.0, 1600}, Case{GluedScheme::semi_implicit, 1.0, 1600},
        Case{GluedScheme::impulse, 1.0, 1600}, Case{GluedScheme::midpoint, 2.0, 400},
        Case{GluedScheme::rk4, 4.0, 100}}) {
    std::array<double, 2> off{};
    std::array<double, 2> gap{};
    for (std::size_t k = 0; k < 2; ++k) {
      const int steps = c.steps * (k == 0 ? 1 : 2);
      World world = start;
      Glued technique(way(c.scheme));
      run(world, technique, steps, 1.0 / steps);
      off[k] = apart(world, truth);
      gap[k] = gap_of(technique.joints(), world.states()).apart;
    }
    INFO(name_of(c.scheme) << ": " << off[0] << ", " << off[1] << "; " << gap[0] << ", " << gap[1]);
    CHECK(std::log2(off[0] / off[1]) == near(c.order, 0.1));
    CHECK(std::log2(gap[0] / gap[1]) == near(c.order, 0.1));
  }
}
