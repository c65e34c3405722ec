/// \file
/// \brief Energy, overlap and momenta as a run measures them.
#include "tumble/record/metrics.hpp"

#include "support/test.hpp"

namespace {

void add(World& world, const Vec3& position_w, const Quat& orientation_wb = Quat::Identity()) {
  world.add(box_properties(Vec3::Ones(), 1.0), position_w, orientation_wb);
}

double overlap_of(const World& world) { return MetricsMeter().begin(world).deepest_overlap; }

}  // namespace

TEST_CASE("What changes the energy and is not booked is the energy error", "[exact][record]") {
  // 2 kg at 3 m/s: 9 J. Slowed to 1 m/s, 1 J; of the 8 J lost, 5.5 J are booked. L is the shortest edge.
  World world;
  const BodyId id = world.add(box_properties(Vec3(0.5, 1.0, 2.0), 2.0), Vec3(0.0, 5.0, 0.0),
                              Quat::Identity(), Vec3(3.0, 0.0, 0.0));
  MetricsMeter meter;
  const Metrics start = meter.begin(world);
  CHECK(start.kinetic == 9.0);
  CHECK(start.potential == near(2.0 * 9.81 * 5.0).epsilon(1e-15));
  CHECK(start.energy_error == 0.0);
  world.set_velocity(id, Vec3(1.0, 0.0, 0.0), Vec3::Zero());
  StepReport report;
  report.energy = {.restitution = -1.0, .friction = -3.0, .damping = -2.0, .repair = 0.5};
  const Metrics after = meter.measure(world, report);
  CHECK(after.kinetic == 1.0);
  CHECK(after.booked.total() == -5.5);
  CHECK(after.energy_error == near(-2.5).epsilon(1e-14));
  CHECK(after.energy_error_share == near(-2.5 / (2.0 * 9.81 * 0.5)).epsilon(1e-14));
  CHECK(after.momentum_w == Vec3(2.0, 0.0, 0.0));
  CHECK(after.angular_momentum_w == Vec3(0.0, 0.0, -10.0));  // r × P = (0,5,0) × (2,0,0)
  CHECK(after.fastest == 1.0);
  // Booked energy adds up over steps.
  const Metrics again = meter.measure(world, report);
  CHECK(again.booked.friction == -6.0);
  CHECK(again.energy_error == near(3.0).epsilon(1e-14));
}

TEST_CASE("The deepest overlap is that of the closed form", "[exact][record]") {
  const Quat on_edge = rotation_from_degrees(Vec3(0.0, 0.0, 45.0));
  const double half_diagonal = std::sqrt(0.5);
  {
    World world;  // an edge in a face
    add(world, Vec3::Zero());
    add(world, Vec3(0.1, 0.5 + half_diagonal - 0.05, 0.0), on_edge);
    CHECK(overlap_of(world) == near(0.05).epsilon(1e-13));
  }
  {
    World
        world;  // an edge across another: the normal is y, neither a face of the one nor the other
    add(world, Vec3::Zero(), on_edge);
    add(world, Vec3(0.0, 2.0 * half_diagonal - 0.02, 0.0),
        rotation_from_degrees(Vec3(45.0, 0.0, 0.0)));
    CHECK(overlap_of(world) == near(0.02).epsilon(1e-12));
  }
}

TEST_CASE("A world that has become infinite is reported as such and nothing throws",
          "[unit][record]") {
  World world = ground_world();
  add(world, Vec3(0.0, 1.0, 0.0));
  MetricsMeter meter;
  meter.begin(world);
  for (const double bad : {kNan, kInfinity}) {
    world.states()[1].position_w.y() = bad;
    const Metrics m = meter.measure(world, {});
    CHECK(!std::isfinite(m.potential));
    CHECK(m.deepest_overlap == 0.0);
  }
}

TEST_CASE("Every column of metrics.csv has a name of its own and is a number", "[unit][record]") {
  std::set<std::string_view> names;
  Metrics m;
  m.chatter.bodies = 3;
  StepReport report{.events = 7};
  int counts = 0;
  for (const MetricsColumn& column : metrics_columns()) {
    INFO(column.name);
    CHECK(names.insert(column.name).second);
    const double value = column.value(m, report);
    CHECK(value == (column.name == "chatter_bodies" ? 3.0
                    : column.name == "collisions"   ? 7.0
                                                    : 0.0));
    if (column.whole) ++counts;
  }
  CHECK(names.size() == 32);
  CHECK(counts == 13);
}
