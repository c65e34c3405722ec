/// \file
/// \brief Tests of moving overlapping bodies apart.
#include "tumble/contact/repair.hpp"

#include "tumble/contact/tolerances.hpp"

#include "support/test.hpp"
#include "support/touching.hpp"

namespace {

constexpr double kSlop = tolerance::repair_slop;  // [m] for bodies with a shortest edge of 1 m

BodyState place(const Vec3& position_w, const Quat& orientation_wb = Quat::Identity()) {
  return BodyState{.position_w = position_w, .orientation_wb = orientation_wb};
}

BodyId cube(World& world, double x, double y, double mass = 1.0) {
  return world.add(box_properties(Vec3::Ones(), mass), place(Vec3(x, y, 0.0)));
}

BodyId fixed(World& world, const Vec3& size, double x, double y) {
  return world.add(fixed_box_properties(size), place(Vec3(x, y, 0.0)));
}

RepairReport repair(World& world) {
  OverlapRepair repair_rule;
  return repair_rule.run(world, all_pairs(world));
}

// [J] relative to y = 0
double potential_energy(const World& world) {
  double energy = 0.0;
  for (int b = 0; b < world.count(); ++b)
    if (world.bodies()[idx(b)].movable())
      energy -=
          world.bodies()[idx(b)].mass * world.gravity_w.dot(world.states()[idx(b)].position_w);
  return energy;
}

// Boxes thrown into a small space, with momenta; some immovable, some asleep.
World heap(std::uint64_t seed, int count, double side) {
  Random random(seed);
  World world;
  if (seed % 2 == 0) world.add_ground();
  for (int b = 0; b < count; ++b) {
    Vec3 size;
    for (int k = 0; k < 3; ++k) size[k] = random.uniform(0.3, 1.0);
    const double mass = random.uniform(0.5, 5.0);
    Vec3 position_w = random.in_cube(0.5 * side);
    position_w.y() += 0.5 * side;
    const Quat orientation_wb = random.orientation();
    if (random.below(8) == 0) {
      world.add(fixed_box_properties(size), place(position_w, orientation_wb));
    } else {
      BodyState state = place(position_w, orientation_wb);
      state.linear_momentum_w = random.in_cube(1.0);
      state.angular_momentum_w = random.in_cube(1.0);
      world.add(box_properties(size, mass), state);
      world.sleep_states().back().asleep = random.below(8) == 0;
    }
  }
  if (seed % 3 == 0) world.gravity_w.setZero();
  return world;
}

}  // namespace

TEST_CASE("A stack of five pressed into itself is put right in one sweep", "[exact][repair]") {
  World world = ground_world();
  std::vector<BodyId> boxes;
  for (int k = 0; k < 5; ++k) boxes.push_back(cube(world, 0.0, 0.45 + 0.92 * k, 2.0));
  const double before = potential_energy(world);
  const RepairReport report = repair(world);
  CHECK(report.status == RepairStatus::clear);
  CHECK(report.sweeps == 1);
  CHECK(report.moves == 5);
  CHECK(report.deepest_before == near(0.08).epsilon(1e-12));
  CHECK(report.deepest_after == near(kSlop).epsilon(1e-9));  // [m] rounding only
  for (int k = 0; k < 5; ++k) {
    const Vec3 expected(0.0, 0.5 + k - (k + 1) * kSlop, 0.0);
    // Rounding of five sums of numbers up to 5 m: measured 9e-16 m.
    CHECK((world.body(boxes[idx(k)]).position_w() - expected).norm() < 1e-14);
  }
  CHECK(report.energy == near(potential_energy(world) - before).epsilon(1e-12));
  CHECK(report.energy > 0.0);

  // After that there is nothing to do: each pair is tested once.
  const StateHash hash = world.hash();
  const RepairReport again = repair(world);
  CHECK(again.sweeps == 0);
  CHECK(again.pair_tests == 15);
  CHECK(world.hash().value() == hash.value());
}

TEST_CASE("A contact is left as an overlap, not as a gap", "[unit][repair]") {
  World world = ground_world();
  const BodyId box = cube(world, 0.0, 0.3);
  OverlapRepair coarse(RepairOptions{.slop = 0.05, .most_sweeps = 1});
  const RepairReport report = coarse.run(world, all_pairs(world));
  CHECK(report.status == RepairStatus::clear);
  CHECK(world.body(box).position_w().y() == near(0.45).epsilon(1e-14));
  // The slop is a share of the shortest edge of the two bodies.
  World thin;
  const BodyId plate = thin.add(box_properties(Vec3(1.0, 0.1, 1.0), 1.0), place(Vec3(0, 0.54, 0)));
  fixed(thin, Vec3::Ones(), 0.0, 0.0);
  repair(thin);
  CHECK(thin.body(plate).position_w().y() == near(0.55 - 0.1 * kSlop).epsilon(1e-14));
}

TEST_CASE("A box that presses against a shelf from below goes down, and the shelf stays",
          "[unit][repair]") {
  World world = ground_world();
  const BodyId shelf = fixed(world, Vec3(2.0, 0.2, 2.0), 0.0, 1.15);
  const BodyId box = cube(world, 0.0, 0.6);  // its top is 0.05 m inside the shelf
  const RepairReport report = repair(world);
  CHECK(report.status == RepairStatus::clear);
  CHECK(world.body(shelf).position_w() == Vec3(0.0, 1.15, 0.0));
  CHECK(world.body(box).position_w().y() == near(0.55 + 0.2 * kSlop).epsilon(1e-14));
  CHECK(report.energy < 0.0);
}

TEST_CASE("A box squeezed between two walls ends in their middle, and the status reports it",
          "[unit][repair]") {
  for (const double off : {0.0, 0.03, -0.08}) {
    World world;
    fixed(world, Vec3(1.0, 3.0, 3.0), -0.9, 0.0);
    fixed(world, Vec3(1.0, 3.0, 3.0), 0.9, 0.0);
    const BodyId box = cube(world, off, 0.0);  // 1 m in a gap of 0.8 m
    const RepairReport report = repair(world);
    CHECK(report.status == RepairStatus::unsolved);
    CHECK(report.sweeps == RepairOptions{}.most_sweeps);
    CHECK(report.deepest_before == near(0.1 + std::abs(off), 1e-12));
    // [m] 0.1 is the best there is; half steps miss the middle by a little: measured 0.1120
    CHECK(report.deepest_after < 0.115);
    CHECK(std::abs(world.body(box).position_w().x()) < 0.015);
    CHECK(world.body(box).position_w().y() == 0.0);
  }
}

TEST_CASE("A box in a wedge of two faces finds its way out", "[unit][repair]") {
  // Two fixed blocks whose faces meet in the origin and open upwards at 60 degrees: the pushes on
  // the box are partly against each other, and still it can be done.
  World world;
  const Vec3 size(1.0, 6.0, 6.0);
  for (const double side : {-1.0, 1.0}) {
    const Quat lean = Quat(std::sqrt(3.0) + 2.0, 0.0, 0.0, -side).normalized();  // 30 degrees
    world.add(fixed_box_properties(size), place(lean * Vec3(side * 0.5, 2.5, 0.0), lean));
  }
  const BodyId box = world.add(box_properties(Vec3::Constant(0.8), 1.0), place(Vec3(0, 0.9, 0)));
  const RepairReport report = repair(world);
  CHECK(report.status == RepairStatus::clear);
  CHECK(report.sweeps > 1);
  // It fits where the wedge is 0.8 m wide: lower corners at 0.4 sqrt(3); the slop along
  // a normal that rises by one half is twice as much along y.
  CHECK(report.deepest_before == near(0.5 * (0.4 * std::sqrt(3.0) - 0.5)).epsilon(1e-12));
  CHECK(world.body(box).position_w().y() ==
        near(0.4 + 0.4 * std::sqrt(3.0) - 2.0 * 0.8 * kSlop, 1e-4));
}

TEST_CASE("Two boxes side by side on the ground share the way in the ratio of their masses",
          "[unit][repair]") {
  World world = ground_world();
  const double height = 0.5 - 0.5 * kSlop;
  const BodyId light = cube(world, -0.46, height, 1.0);
  const BodyId heavy = cube(world, 0.46, height, 3.0);
  const RepairReport report = repair(world);
  CHECK(report.status == RepairStatus::clear);
  CHECK(report.moves == 1);
  const double way = 0.08 - kSlop;
  CHECK(world.body(light).position_w().x() == near(-0.46 - 0.75 * way).epsilon(1e-14));
  CHECK(world.body(heavy).position_w().x() == near(0.46 + 0.25 * way).epsilon(1e-14));
  CHECK(report.energy == near(0.0, 1e-15));
}

TEST_CASE("A box beside a stack's second box gives way, not the stack's lower one",
          "[unit][repair]") {
  // A box of level 2 that overlaps sideways with a tall one of level 1: the upper one moves.
  World world = ground_world();
  const BodyId tall =
      world.add(box_properties(Vec3(1.0, 3.0, 1.0), 1.0), place(Vec3(1.45, 1.499, 0)));
  const BodyId low = cube(world, 0.0, 0.499);
  const BodyId high = cube(world, 0.5, 1.498);
  const RepairReport report = repair(world);
  CHECK(report.status == RepairStatus::clear);
  CHECK(world.body(tall).position_w().x() == 1.45);
  CHECK(world.body(low).position_w().x() == 0.0);
  CHECK(world.body(high).position_w().x() == near(0.45 + kSlop).epsilon(1e-12));
}

TEST_CASE("Immovable and sleeping bodies never move", "[unit][repair]") {
  World world;
  fixed(world, Vec3::Ones(), 0.0, 0.0);
  fixed(world, Vec3::Ones(), 0.5, 0.0);
  const BodyId sleeper = cube(world, 0.0, 0.9);
  world.sleep_states().back().asleep = true;
  RepairReport report = repair(world);
  CHECK(report.status == RepairStatus::clear);
  CHECK(report.pair_tests == 0);
  CHECK(report.deepest_before == 0.0);
  CHECK(world.body(sleeper).position_w().y() == 0.9);

  // A body that is awake goes out of the sleeper's way, although it is below.
  const BodyId below = cube(world, 0.0, 0.1);
  world.remove(world.ids()[0]);
  world.remove(world.ids()[0]);
  report = repair(world);
  CHECK(world.body(sleeper).position_w().y() == 0.9);
  CHECK(world.body(below).position_w().y() == near(-0.1 + kSlop).epsilon(1e-12));
}

TEST_CASE("Only positions change, and the energy booked is the potential energy added",
          "[exact][repair]") {
  int wrong = 0;
  int solved = 0;
  double worst = 0.0;  // [J]
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    World world = heap(seed, 12, 3.0);
    const World before = world;
    const RepairReport report = repair(world);
    for (int b = 0; b < world.count(); ++b) {
      const BodyState& now = world.states()[idx(b)];
      const BodyState& was = before.states()[idx(b)];
      const BodyProperties& body = world.bodies()[idx(b)];
      if (now.linear_momentum_w != was.linear_momentum_w ||
          now.angular_momentum_w != was.angular_momentum_w ||
          now.orientation_wb.coeffs() != was.orientation_wb.coeffs())
        ++wrong;
      if (kinetic_energy(body, now) != kinetic_energy(body, was)) ++wrong;
      const bool held = !body.movable() || world.sleep_states()[idx(b)].asleep;
      if (held && now.position_w != was.position_w) ++wrong;
    }
    worst = std::max(worst,
                     std::abs(report.energy - potential_energy(world) + potential_energy(before)));
    if ((report.deepest_before == 0.0) != (report.deepest_after == 0.0 && report.sweeps == 0))
      ++wrong;
    if (report.status == RepairStatus::clear) {
      ++solved;
      // No box is larger than 1 m, so no slop is above 1 mm and its hundredth.
      if (report.deepest_after > 1.01 * kSlop) ++wrong;
    }
  }
  CHECK(wrong == 0);
  CHECK(worst < 1e-11);  // [J] rounding of energies up to 600 J: measured 1.7e-13
  CHECK(solved > 150);   // of 200: measured 173; the others have no room
}

TEST_CASE("The order of the pairs changes no bit of a repair", "[determinism][repair]") {
  int wrong = 0;
  OverlapRepair forwards;
  OverlapRepair shuffled;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    World world = heap(seed, 12, 2.5);
    World other = world;
    std::vector<IndexPair> pairs = all_pairs(world);
    const RepairReport report = forwards.run(world, pairs);
    Random random(seed);
    for (std::size_t i = pairs.size(); i > 1; --i) {
      std::swap(pairs[i - 1], pairs[random.below(static_cast<std::uint32_t>(i))]);
      if (random.below(2) == 0) std::swap(pairs[i - 1].first, pairs[i - 1].second);
    }
    const RepairReport again = shuffled.run(other, pairs);
    if (world.hash().value() != other.hash().value()) ++wrong;
    if (report.energy != again.energy || report.pair_tests != again.pair_tests ||
        report.deepest_after != again.deepest_after)
      ++wrong;
  }
  CHECK(wrong == 0);
}

TEST_CASE("Bad input to a repair is refused", "[unit][repair]") {
  CHECK_THROWS_WITH(OverlapRepair(RepairOptions{.slop = 0.0}), Contains("slop"));
  CHECK_THROWS_WITH(OverlapRepair(RepairOptions{.most_sweeps = 0}), Contains("most_sweeps = 0"));
  World world;
  cube(world, 0.0, 0.0);
  cube(world, 0.0, 0.5);
  OverlapRepair rule;
  CHECK_THROWS_WITH(rule.run(world, std::vector<IndexPair>{{0, 2}}), Contains("0, 2"));
  CHECK_THROWS_WITH(rule.run(world, std::vector<IndexPair>{{1, 1}}), Contains("1, 1"));
  CHECK_THROWS_AS(rule.run(world, std::vector<IndexPair>{{-1, 1}}), std::invalid_argument);
}
