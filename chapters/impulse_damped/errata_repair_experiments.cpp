/// \file
/// \brief The errata of FIXCONTACTCONSTRAINTS (thesis 4.4, A.2; X1 to X5, DM17).
#include "tumble/contact/gather.hpp"
#include "tumble/contact/repair.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/dynamics/flight.hpp"
#include "tumble/impulse_damped/as_printed/fix_contact_constraints_as_printed.hpp"

#include "impulse_damped/errata_damping_experiments.hpp"
#include "impulse_damped/errata_damping_setup.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace tumble::chapters {
namespace {

using namespace errata_setup;

constexpr double kPush = 1e-3;          // [m] ε1
constexpr std::int64_t kMany = 100000;  // [-] pushes that a loop which ends does not need

// All pairs of a world that touch.
ContactList contacts_of(const World& world) {
  std::vector<IndexPair> pairs;
  for (int i = 0; i < world.count(); ++i)
    for (int j = i + 1; j < world.count(); ++j) pairs.push_back({i, j});
  std::vector<MovingBody> moving;
  load_moving_bodies(world, moving);
  ContactList contacts;
  gather_contacts(world, moving, pairs, 0.0, {}, contacts);
  return contacts;
}

PrintedFixReport fix(World& world, std::int64_t cap, const DampedErrata& mended) {
  return fix_contact_constraints_as_printed(world, contacts_of(world), kPush, cap, mended);
}

// Our repair, for what the author meant and does not work out.
void repair(World& world) {
  std::vector<IndexPair> pairs;
  for (int i = 0; i < world.count(); ++i)
    for (int j = i + 1; j < world.count(); ++j) pairs.push_back({i, j});
  OverlapRepair().run(world, pairs);
}

double gap(const World& world, std::size_t first, std::size_t second) {
  return gap_between(world.bodies()[first], world.states()[first], world.bodies()[second],
                     world.states()[second])
      .distance;
}

// [m] of all pairs of which one can be moved, 0 if none overlaps
double deepest_overlap(const World& world) {
  double deepest = 0.0;
  for (std::size_t i = 0; i < world.bodies().size(); ++i)
    for (std::size_t j = i + 1; j < world.bodies().size(); ++j)
      if (world.bodies()[i].movable() || world.bodies()[j].movable())
        deepest = std::max(deepest, -gap(world, i, j));
  return deepest;
}

void add_fixed_box(World& world, const Vec3& size, const Vec3& place_w) {
  const BodyProperties body = fixed_box_properties(size);
  world.add(body, make_state(body, place_w));
}

void add_cube(World& world, const Vec3& place_w) {
  world.add(unit_cube(), make_state(unit_cube(), place_w));
}

// X1. A cube has fallen so fast that its centre is 0.1 m below the ground: the ground is the upper
// body, and pushing it leads nowhere.
void add_endless_loop(std::int64_t cap, Result& result) {
  const auto pushes = [&](const DampedErrata& mended) {
    World world;
    world.add_ground();
    add_cube(world, Vec3(0.0, -0.0995, 0.0));
    // One point of the four is enough: the others would do the same.
    ContactList contacts = contacts_of(world);
    contacts[0].count = 1;
    return static_cast<double>(
        fix_contact_constraints_as_printed(world, contacts, kPush, cap, mended).pushes);
  };
  add(result, "X1: pushes of a cube below the ground, as listed, until a cap", "-",
      pushes(all_but("X1").without("X2")));
  add(result, "X1: pushes of a cube below the ground, along the normal of now", "-",
      pushes(DampedErrata::all()));
}

// X2. A cube has risen 2.5 mm into a shelf.
void add_immovable_upper(Result& result) {
  const auto moved = [](const DampedErrata& mended) {
    World world;
    add_fixed_box(world, Vec3(2.0, 0.25, 2.0), Vec3(0.0, 2.0, 0.0));
    add_cube(world, Vec3(0.0, 1.375 + 2.5e-3, 0.0));
    fix(world, kMany, mended);
    return world.states()[0].position_w.y() - 2.0;
  };
  add(result, "X2: way of a fixed shelf that a cube has risen into, upper body pushed", "m",
      moved(all_but("X2")));
  add(result, "X2: way of a fixed shelf that a cube has risen into, movable body pushed", "m",
      moved(DampedErrata::all()));
}

// X3. A cube overlaps the ground by up to 3 mm. What gap is left?
void add_gap(Result& result) {
  Table table{"gap",
              {{"depth_mm", "mm", "overlap of a cube with the ground"},
               {"printed_mm", "mm", "gap after pushes of 1 mm; below 0: overlap"},
               {"mended_mm", "mm", "gap after our repair"}}};
  double printed_most = 0.0;
  double mended_most = 0.0;
  constexpr int count = 240;
  for (int k = 0; k < count; ++k) {
    const double depth = 3.0 * kPush * (k + 0.5) / count;
    World printed;
    printed.add_ground();
    add_cube(printed, Vec3(0.0, 0.5 - depth, 0.0));
    World mended = printed;
    fix(printed, kMany, DampedErrata::all());
    repair(mended);
    table.rows.push_back({1e3 * depth, 1e3 * gap(printed, 0, 1), 1e3 * gap(mended, 0, 1)});
    printed_most = std::max(printed_most, gap(printed, 0, 1));
    mended_most = std::max(mended_most, gap(mended, 0, 1));
  }
  result.tables.push_back(table);
  add(result, "X3: largest gap below a cube after pushes of 1 mm", "m", printed_most);
  add(result, "X3: largest gap below a cube after our repair", "m", mended_most);
}

// X4. A cube overlaps a wall by 4.5 mm and touches another cube on its other side.
void add_one_pass(Result& result) {
  World printed;
  add_fixed_box(printed, Vec3(1.0, 0.5, 1.0), Vec3(0.0, 0.0, 0.0));
  add_cube(printed, Vec3(1.0 - 4.5e-3, 0.1, 0.0));
  add_cube(printed, Vec3(2.0 - 4.5e-3 + 1e-6, 0.2, 0.0));
  World mended = printed;
  fix(printed, kMany, DampedErrata::all());
  repair(mended);
  add(result, "X4: overlap left in a row pressed against a wall, one pass", "m",
      deepest_overlap(printed));
  add(result, "X4: overlap left in a row pressed against a wall, repeated sweeps", "m",
      deepest_overlap(mended));
}

// X5. A plank leans on a high pillar, and its low end carries a cube. The cube's contact is lower
// than the pillar's, so that it is dealt with before the plank is.
World plank_on_pillar(double sunk) {
  constexpr double sine = 0.6;
  constexpr double cosine = 0.8;
  const Quat lean(std::sqrt(0.5 * (1.0 + cosine)), 0.0, 0.0, std::sqrt(0.5 * (1.0 - cosine)));
  const Vec3 along_w(cosine, sine, 0.0);
  const Vec3 across_w(-sine, cosine, 0.0);
  World world;
  // The pillar's left upper edge is in the plank's lower face, 2 m from its middle.
  const Vec3 edge_w(1.6, 3.2, 0.0);
  add_fixed_box(world, Vec3(0.5, 3.2, 2.0), Vec3(1.6 + 0.25, 1.6, 0.0));
  const BodyProperties plank = box_properties(Vec3(6.0, 0.2, 1.0), 1.0);
  const Vec3 middle_w = edge_w - 2.0 * along_w + (0.1 - sunk) * across_w;
  world.add(plank, make_state(plank, middle_w, lean));
  world.add(unit_cube(),
            make_state(unit_cube(), middle_w - 2.0 * along_w + (0.6 - 1e-6) * across_w, lean));
  return world;
}

void add_sort_key(Result& result) {
  World printed = plank_on_pillar(4.5e-3);
  World mended = printed;
  fix(printed, kMany, DampedErrata::all());
  repair(mended);
  add(result, "X5: overlap left of a plank and the cube on its low end, by height", "m",
      deepest_overlap(printed));
  add(result, "X5: overlap left of a plank and the cube on its low end, by support", "m",
      deepest_overlap(mended));
}

// DM17. A cube sinks by 1 mm in each step and is pushed out by as much: scaling of momenta takes
// nothing of that away.
void add_pushed_energy(Result& result) {
  World world;
  world.add_ground();
  add_cube(world, Vec3(0.0, 0.5 + 0.5 * kPush, 0.0));
  double added = 0.0;
  double booked = 0.0;
  for (int step = 0; step < 60; ++step) {
    world.states()[1].position_w.y() -= kPush;
    const double before = energy_of(world).potential;
    booked += fix(world, kMany, DampedErrata::all()).energy;
    added += energy_of(world).potential - before;
  }
  add(result, "DM17: energy that pushes of 1 mm a step add to a cube in 1 s", "J", added);
  add(result, "DM17: energy that pushes of 1 mm a step add to a cube in 1 s, less what is booked",
      "J", added - booked);
}

}  // namespace

void add_repair_errata(int cap, Result& result) {
  add_endless_loop(cap, result);
  add_immovable_upper(result);
  add_gap(result);
  add_one_pass(result);
  add_sort_key(result);
  add_pushed_energy(result);
}

}  // namespace tumble::chapters
