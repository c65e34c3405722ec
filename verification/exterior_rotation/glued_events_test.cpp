/// \file
/// \brief Joints that only press: opening, separation, closing, and the events reported for them.
#include "tumble/exterior_rotation/glued.hpp"

#include "exterior_rotation/cases.hpp"
#include "support/test.hpp"

namespace {

// The angle of the column's centre, from the vertical, about the pivot.
double centre_angle(const World& world) {
  Vec3 centre_w = Vec3::Zero();
  for (std::size_t k = 2; k < 6; ++k) centre_w += world.states()[k].position_w / 4.0;
  return std::atan2(centre_w.x(), centre_w.y() - 2.0);
}

std::vector<Event> events_of(const GluedOptions& options, double dt, double duration) {
  World world = world_of("fig6_1", {{"angle", "0.1"}});
  Glued technique(options);
  Listener notes;
  technique.observe(&notes);
  run(world, technique, static_cast<int>(std::lround(duration / dt)), dt);
  return notes.events;
}

}  // namespace

TEST_CASE("The column's top joint opens first, where its centre of pressure reaches the far edge",
          "[exact][exterior_rotation]") {
  struct Case {
    const char* angle;
    double opens;  // [rad] of the column's centre, from the closed form
  };
  for (const Case& c : {Case{"0.1", 0.681721773}, Case{"0.3", 0.719834032}}) {
    World world = world_of("fig6_1", {{"angle", c.angle}});
    Glued technique(pressing(GluedScheme::dormand_prince));
    Listener notes;
    technique.observe(&notes);
    while (notes.events.empty() && world.time() < 3.0) technique.step(world, kFrame);
    REQUIRE_FALSE(notes.events.empty());
    CHECK(notes.events[0].first == world.ids()[4]);
    CHECK(notes.events[0].second == world.ids()[5]);
    CHECK(technique.joints()[3].hold == JointHold::edge);
    // Until then it was as good as glued: position of its centre at that moment.
    World glued = world_of("fig6_1", {{"angle", c.angle}});
    GluedOptions bilateral = pressing(GluedScheme::dormand_prince);
    bilateral.joints = GluedJoints::bilateral;
    Glued(bilateral).step(glued, notes.events[0].time);
    CHECK(centre_angle(glued) == near(c.opens, 1e-9));  // [rad] to the digits given
  }
}

TEST_CASE("Located events do not depend on the step, those of its end are up to a step late",
          "[exact][exterior_rotation]") {
  const std::vector<Event> truth =
      events_of(pressing(GluedScheme::dormand_prince), kFrame / 4.0, 1.5);
  REQUIRE(truth.size() == 2);
  CHECK(truth[0].time == near(1.386047114, 2e-9));  // [s]
  CHECK(truth[1].time == near(1.446539, 1e-6));
  for (const GluedScheme scheme : {GluedScheme::rk4, GluedScheme::dormand_prince}) {
    const std::vector<Event> located = events_of(pressing(scheme), kFrame, 1.5);
    const std::vector<Event> late = events_of(pressing(scheme, GluedEvents::step_end), kFrame, 1.5);
    REQUIRE(located.size() == 2);
    REQUIRE(late.size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
      CHECK(located[k].time == near(truth[k].time, 1e-6));  // [s] rk4's error, grown
      CHECK(located[k].first == truth[k].first);
      CHECK(late[k].time >= truth[k].time - 1e-6);
    }
    CHECK(late[0].time <= truth[0].time + kFrame);
    // Dormand and Prince's steps are parts of a frame.
    if (scheme == GluedScheme::rk4)
      CHECK(std::abs(late[0].time / kFrame - std::round(late[0].time / kFrame)) < 1e-9);
  }
}

TEST_CASE("A box that was tipped and falls back closes its joint and loses the speed it has then",
          "[exact][exterior_rotation]") {
  World world;
  const BodyProperties wall = fixed_box_properties(Vec3(4.0, 1.0, 4.0));
  world.add(wall, Vec3(0.0, -0.5, 0.0));
  world.add(box_properties(Vec3::Ones(), 2.0), Vec3(0.0, 0.5, 0.0));
  Glued technique(pressing(GluedScheme::dormand_prince));
  world.gravity_w = Vec3(8.0, -6.0, 0.0);  // past the edge
  const StepReport first = technique.step(world, kFrame);
  CHECK(first.events == 1);
  CHECK(technique.joints()[0].hold == JointHold::edge);
  run(world, technique, 15);
  CHECK(opened(technique.joints()[0], world.states()) > 0.01);
  CHECK(technique.joints()[0].hold == JointHold::edge);
  // Its edge is where it was.
  const Vec3 held_w = held_point(technique.joints()[0], world.states()).second_w;
  CHECK((held_w - Vec3(0.5, 0.0, 0.0)).norm() < 1e-9);  // [m]

  world.gravity_w = Vec3(0.0, -9.81, 0.0);
  double booked = 0.0;
  const double before = energy_of(world).total();
  std::int64_t events = 0;
  for (int k = 0; k < 120; ++k) {
    const StepReport report = technique.step(world, kFrame);
    booked += report.energy.restitution;
    events += report.events;
    CHECK(report.status == StepStatus::done);
  }
  CHECK(events == 1);
  CHECK(technique.joints()[0].hold == JointHold::area);
  CHECK(booked < -0.1);                                            // [J] it fell down
  CHECK(energy_of(world).total() == near(before + booked, 1e-8));  // [J]
  CHECK(energy_of(world).kinetic < 1e-20);                         // [J] it rests
  CHECK((world.states()[1].position_w - Vec3(0.0, 0.5, 0.0)).norm() < 1e-9);
}

TEST_CASE("A hanging box falls at once if its joint can only press, and stays with glue",
          "[exact][exterior_rotation]") {
  for (const GluedJoints joints : {GluedJoints::bilateral, GluedJoints::unilateral}) {
    World world;
    const BodyProperties wall = fixed_box_properties(Vec3::Ones());
    world.add(wall, Vec3(0.0, 5.0, 0.0));
    world.add(box_properties(Vec3::Ones(), 2.0), Vec3(0.0, 4.0, 0.0));
    GluedOptions options = pressing(GluedScheme::rk4);
    options.joints = joints;
    Glued technique(options);
    run(world, technique, 60);
    const double fallen = joints == GluedJoints::bilateral ? 0.0 : 0.5 * 9.81;
    CHECK(world.states()[1].position_w.y() == near(4.0 - fallen, 1e-9));  // [m]
    CHECK(technique.contacts().size() == (joints == GluedJoints::bilateral ? 1U : 0U));
  }
}

TEST_CASE("Joints that open and close endlessly stay unchanged for the rest of a step",
          "[unit][exterior_rotation]") {
  // Impulses end velocities at the start of a step, forces are computed at its end: they disagree on
  // whether a joint that has just opened should.
  for (const PoseUpdate pose : {PoseUpdate::separate, PoseUpdate::exponential}) {
    World world = world_of("fig6_1");
    GluedOptions options = pressing(GluedScheme::impulse);
    options.pose = pose;
    Glued technique(options);
    std::int64_t most = 0;
    for (int k = 0; k < 100; ++k) {
      const StepReport report = technique.step(world, kFrame);
      most = std::max(most, report.events);
      CHECK((report.status == StepStatus::event_cap) == (report.events >= 80));
    }
    CHECK(most <= 100);  // 20 of each of four joints, and those at the last instant
  }
}

TEST_CASE("Bodies that have come apart fall freely", "[exact][exterior_rotation]") {
  World world = world_of("fig6_3");
  Glued technique(pressing(GluedScheme::rk4));
  run(world, technique, 60);
  REQUIRE(technique.joints().size() == 2);
  CHECK(technique.joints()[0].hold == JointHold::nothing);
  CHECK(technique.joints()[1].hold == JointHold::nothing);
  CHECK(technique.contacts().empty());
  const Vec3 v = BodyView(world, 3).velocity_w();
  const Vec3 spin = world.states()[3].angular_momentum_w;
  technique.step(world, 0.5);
  CHECK((BodyView(world, 3).velocity_w() - v - Vec3(0.0, -4.905, 0.0)).norm() < 1e-13);
  CHECK(world.states()[3].angular_momentum_w == spin);
}
