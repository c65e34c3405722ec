/// \file
/// \brief Gaps of the text about searching impacts, taken literally and mended (thesis 3.2,
///        3.3.1, A.1; errata T5 to T7).
#include "tumble/basic_colliding/basic.hpp"
#include "tumble/contact/collision_law.hpp"
#include "tumble/math/bracket.hpp"

#include "basic_colliding/errata.hpp"
#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

const IndexPair kBodies{0, 1};

// --- T5: what is tested ---------------------------------------------------------------------

// Three cubes in a row, and their places at each impact of one step.
class RowWatcher : public Observer {
 public:
  RowWatcher(const World& world, std::string suffix)
      : table{std::move(suffix),
              {{"time_s", "s", "time"},
               {"first_m", "m", "place of the first cube"},
               {"second_m", "m", "of the second"},
               {"third_m", "m", "of the third"}}},
        world_(world) {
    note(0.0);
  }
  void on_event(const Event& event) override { note(event.time); }
  void note(double time) {
    const auto cubes = world_.states();
    table.add(time, cubes[0].position_w.x(), cubes[1].position_w.x(), cubes[2].position_w.x());
  }
  Table table;

 private:
  const World& world_;
};

// Cubes of 1 m at 0, 1.5 and 2.9 m move with 2, 0 and -1 m/s for a step of 1 s, without loss. The
// first hits the second, which then has time enough to fly through the third.
Table three_cubes(SearchMethod search, std::string suffix) {
  World world;
  world.gravity_w = Vec3::Zero();
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, 0.0, 1.0);
  for (const auto& [place, speed] : {std::pair{0.0, 2.0}, {1.5, 0.0}, {2.9, -1.0}})
    world.add(cube, Vec3(place, 0.0, 0.0), Quat::Identity(), Vec3(speed, 0.0, 0.0));
  Basic basic({.search = search});
  RowWatcher watcher(world, std::move(suffix));
  basic.observe(&watcher);
  finished(basic.step(world, 1.0));
  watcher.note(world.time());
  return watcher.table;
}

double third_minus_second(const Table& table) {
  return table.rows.back()[3] - table.rows.back()[2];
}

// --- T6 and T7: what a search leaves behind ---------------------------------------------------

enum class Side { apart, overlapping };

// The thesis's search for one pair: if the bodies overlap at the end, the time in between at which
// they began to. The text does not say which end of the last bracket is the answer.
std::optional<double> impact_time(const World& world, double left, double resolution, Side kept) {
  const Flight flight{
      .bodies = world.bodies(), .states = world.states(), .gravity_w = world.gravity_w};
  const auto gap = [&](double time) { return gap_at(flight, kBodies, time).distance; };
  if (gap(left) >= 0.0) return std::nullopt;
  const Bracket last = bisect(gap, Bracket{0.0, left}, resolution, 100).bracket;
  return kept == Side::apart ? last.low : last.high;
}

struct LiteralImpact {
  double time;                 // [s] in the step
  double gap;                  // [m] of the two bodies then
  double separation_velocity;  // [m/s] right after it
};

struct Literally {
  Side kept = Side::apart;
  double resolution = 1e-9;      // [s]
  double restitution = 0.5;      // [-]
  double shortest_flight = 0.0;  // [s] an impact that leaves a shorter one is the last: they stick
};

// One step of two bodies that meet along `normal_w`: search, fly there, collide, search again.
std::vector<LiteralImpact> impacts_in_step(World world, double dt, const Vec3& normal_w, int cap,
                                           const Literally& how) {
  std::vector<LiteralImpact> impacts;
  std::vector<MovingBody> moving;
  double now = 0.0;
  while (static_cast<int>(impacts.size()) < cap) {
    const std::optional<double> time = impact_time(world, dt - now, how.resolution, how.kept);
    if (!time) break;
    for (int k = 0; k < world.count(); ++k) {
      const auto i = idx(k);
      fly(world.bodies()[i], world.states()[i], world.gravity_w, *time, RotationRule::splitting);
    }
    now += *time;
    const double gap =
        gap_at({.bodies = world.bodies(), .states = world.states()}, kBodies, 0.0).distance;

    load_moving_bodies(world, moving);
    collide_at_point(moving[0], moving[1], Vec3::Zero(), normal_w, 0.0, how.restitution);
    store_moving_bodies(moving, world);
    const double separation_velocity = normal_w.dot(moving[1].velocity_w - moving[0].velocity_w);
    impacts.push_back({now, gap, separation_velocity});
    if (2.0 * separation_velocity / kGravity < how.shortest_flight) break;
  }
  return impacts;
}

// A cube falls on the ground and arrives with 0.05 m/s.
World slow_landing() {
  constexpr double speed = 0.05;
  World world;
  world.add_ground();
  world.add(box_properties(Vec3::Ones(), 1.0),
            Vec3(0.0, 0.5 + 0.5 * speed * speed / kGravity, 0.0));
  return world;
}

// A cube flies at 1 m/s against one that is 0.4 m away and at rest.
constexpr double kMeet = 0.4;  // [s]
World push_from_behind() {
  World world;
  world.gravity_w = Vec3::Zero();
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  world.add(cube, Vec3::Zero(), Quat::Identity(), Vec3::UnitX());
  world.add(cube, Vec3(1.0 + kMeet, 0.0, 0.0));
  return world;
}

Table count_table(const std::vector<LiteralImpact>& impacts, std::string suffix) {
  Table table{std::move(suffix),
              {{"since_ms", "ms", "time since the first impact"}, {"impacts", "-", "so far"}}};
  for (const LiteralImpact& impact : impacts)
    table.add(1e3 * (impact.time - impacts.front().time), table.rows.size() + 1);
  return table;
}

// The gap from shortly before the cubes meet until shortly after; it does not change after an impact.
Table gap_table(const std::vector<LiteralImpact>& impacts, std::string suffix) {
  constexpr double around = 2e-6;  // [s]
  const auto none = std::numeric_limits<double>::quiet_NaN();
  Table table{std::move(suffix),
              {{"since_us", "µs", "time since the cubes really met"},
               {"gap_um", "µm", "between them; below 0 they overlap"},
               {"impact_um", "µm", "the same if this is an impact; else empty"}}};
  table.add(-1e6 * around, 1e6 * around, none);
  for (const LiteralImpact& impact : impacts)
    table.add(1e6 * (impact.time - kMeet), 1e6 * impact.gap, 1e6 * impact.gap);
  table.add(1e6 * (impacts.back().time + 4.0 * around - kMeet), 1e6 * impacts.back().gap, none);
  return table;
}

}  // namespace

void add_pass_erratum(Result& result) {
  const Table literal = three_cubes(SearchMethod::discrete, "pass_literal");
  const Table mended = three_cubes(SearchMethod::conservative, "pass_mended");
  result.tables.insert(result.tables.end(), {literal, mended});
  result.add("T5: third cube ahead of the second, end of the step tested", "m",
             third_minus_second(literal));
  result.add("T5: third cube ahead of the second, way there searched", "m",
             third_minus_second(mended));
}

void add_progress_errata(int cap, Result& result) {
  const auto count = [](const std::vector<LiteralImpact>& all) {
    return static_cast<double>(all.size());
  };

  // T6. Flights get shorter by half each time: without an end to them the step has none.
  Literally how;
  const auto endless = impacts_in_step(slow_landing(), 1.0 / 60.0, Vec3::UnitY(), cap, how);
  how.shortest_flight = 1e-6;
  const auto ended = impacts_in_step(slow_landing(), 1.0 / 60.0, Vec3::UnitY(), cap, how);
  result.tables.push_back(count_table(endless, "flights_literal"));
  result.tables.push_back(count_table(ended, "flights_mended"));
  result.add("T6: impacts in a step that nothing ends, until a cap", "-", count(endless));
  result.add("T6: impacts in a step, a flight below 1 µs being the last", "-", count(ended));
  result.add("T6: time from the first of them to the last", "s",
             ended.back().time - ended.front().time);

  // T7. The cubes stick together and fly on. Left overlapping, they are found again.
  how = {.kept = Side::overlapping, .resolution = 1e-6, .restitution = 0.0};
  const auto inside = impacts_in_step(push_from_behind(), 1.0, Vec3::UnitX(), cap, how);
  how.kept = Side::apart;
  const auto outside = impacts_in_step(push_from_behind(), 1.0, Vec3::UnitX(), cap, how);
  result.tables.push_back(gap_table(inside, "side_literal"));
  result.tables.push_back(gap_table(outside, "side_mended"));
  result.add("T7: impacts, the overlapping end being kept, until a cap", "-", count(inside));
  result.add("T7: impacts, the separated end being kept", "-", count(outside));
}

}  // namespace tumble::chapters
