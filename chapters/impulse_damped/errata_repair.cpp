/// \file
/// \brief The errata of FIXCONTACTCONSTRAINTS (thesis 4.4, A.2; X1 to X6, DM17).
#include "tumble/contact/repair.hpp"
#include "tumble/dynamics/flight.hpp"
#include "tumble/impulse_damped/as_printed/damped_as_printed.hpp"
#include "tumble/impulse_damped/as_printed/fix_contact_constraints_as_printed.hpp"
#include "tumble/impulse_damped/damped.hpp"
#include "tumble/record/overlap.hpp"

#include "impulse_damped/errata_setup.hpp"

namespace tumble::chapters {
namespace {

constexpr double kPush = 1e-3;          // [m] ε1
constexpr std::int64_t kMany = 100000;  // [-] pushes that a loop which ends does not need

PrintedFixReport fix(World& world, std::int64_t cap, const DampedErrata& mended) {
  return fix_contact_constraints_as_printed(world, contacts_within(world, 0.0), kPush, cap, mended);
}

// Our repair, for what the author meant and does not work out.
void repair(World& world) { OverlapRepair().run(world, all_pairs(world)); }

double gap(const World& world, std::size_t first, std::size_t second) {
  return gap_between(world.bodies()[first], world.states()[first], world.bodies()[second],
                     world.states()[second])
      .distance;
}

// The overlap that is left in a world after the listing, and after our repair.
void add_overlap_left(World world, const std::string& what, const std::string& printed,
                      const std::string& cured, Result& result) {
  World mended = world;
  fix(world, kMany, DampedErrata::all());
  repair(mended);
  result.add(what + printed, "m", OverlapMeter().look(world));
  result.add(what + cured, "m", OverlapMeter().look(mended));
}

void add_cube(World& world, const Vec3& place_w) { world.add(unit_cube(), place_w); }

// X1. A cube has fallen so fast that its centre is 0.1 m below the ground: the ground is the upper
// body, and pushing it leads nowhere.
double endless_pushes(std::int64_t cap, const DampedErrata& mended) {
  World world;
  world.add_ground();
  add_cube(world, Vec3(0.0, -0.0995, 0.0));
  // One point of the four is enough: the others would do the same.
  ContactList contacts = contacts_within(world, 0.0);
  contacts[0].count = 1;
  return static_cast<double>(
      fix_contact_constraints_as_printed(world, contacts, kPush, cap, mended).pushes);
}

// X2. A cube has risen 2.5 mm into a shelf.
double shelf_moved(const DampedErrata& mended) {
  World world;
  add_fixed_box(world, Vec3(2.0, 0.25, 2.0), Vec3(0.0, 2.0, 0.0));
  add_cube(world, Vec3(0.0, 1.375 + 2.5e-3, 0.0));
  fix(world, kMany, mended);
  return world.states()[0].position_w.y() - 2.0;
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
    table.add(1e3 * depth, 1e3 * gap(printed, 0, 1), 1e3 * gap(mended, 0, 1));
    printed_most = std::max(printed_most, gap(printed, 0, 1));
    mended_most = std::max(mended_most, gap(mended, 0, 1));
  }
  result.tables.push_back(table);
  result.add("X3: largest gap below a cube after pushes of 1 mm", "m", printed_most);
  result.add("X3: largest gap below a cube after our repair", "m", mended_most);
}

// X4. A cube overlaps a wall by 4.5 mm and touches another cube on its other side.
World pressed_row() {
  World world;
  add_fixed_box(world, Vec3(1.0, 0.5, 1.0), Vec3(0.0, 0.0, 0.0));
  add_cube(world, Vec3(1.0 - 4.5e-3, 0.1, 0.0));
  add_cube(world, Vec3(2.0 - 4.5e-3 + 1e-6, 0.2, 0.0));
  return world;
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
  const Vec3 middle_w = edge_w - 2.0 * along_w + (0.1 - sunk) * across_w;
  world.add(box_properties(Vec3(6.0, 0.2, 1.0), 1.0), middle_w, lean);
  world.add(unit_cube(), middle_w - 2.0 * along_w + (0.6 - 1e-6) * across_w, lean);
  return world;
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
  result.add("DM17: energy that pushes of 1 mm a step add to a cube in 1 s", "J", added);
  result.add("DM17: energy that pushes of 1 mm a step add to a cube in 1 s, less what is booked",
             "J", added - booked);
}

// X6. Five cubes with the thesis's restitution on top of each other, at rest.
World stack() {
  World world;
  world.add_ground();
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, 0.5, 0.9);
  for (int k = 0; k < 5; ++k) world.add(cube, Vec3(0.0, 0.5 + k, 0.0));
  return world;
}

// [J] added so far by ending overlap, after each step.
std::vector<double> energy_added(Technique&& technique, int steps) {
  World world = stack();
  std::vector<double> added = {0.0};
  for (int step = 0; step < steps; ++step)
    added.push_back(added.back() + finished(technique.step(world, kStep)).energy.repair);
  return added;
}

// The listing, without its misprints.
//
// Ten passes leave the cubes some of what a step of gravity has given, so that they sink in and are
// pushed up, in each step anew. The usual damping hides that: of the topmost cube's 0.118 N s, k1
// and k5 leave 0.054, which is below ε6, 0.0626, and ended; nothing sinks in, and nothing is pushed.
// With half of all ε it is not ended, and the pushes go on. To see what pushes do by themselves,
// damping is off here.
DampedAsPrinted pushes(bool stable_boxes) {
  return DampedAsPrinted(undamped(DampedErrata::all(), stable_boxes));
}

// The same with the usual damping, all ε being multiplied.
DampedAsPrinted damped_pushes(double eps_scale) {
  DampedAsPrintedOptions options{.repaired = DampedErrata::all(), .stable_boxes = false};
  options.numbers.eps_scale = eps_scale;
  return DampedAsPrinted(options);
}

// What the pushes took the place of: velocities are stopped from the ground up. Not damped, either.
Damped shock_of_velocities() {
  DampedOptions options{.shock = ShockRule::velocity,
                        .stable_boxes = StableRule::off,
                        .numbers = undamped(DampedErrata::all()).numbers};
  return Damped(options);
}

void add_stack_erratum(double duration, Result& result) {
  const int steps = static_cast<int>(duration / kStep + 0.5);
  const std::vector<double> printed = energy_added(pushes(false), steps);
  const std::vector<double> stable = energy_added(pushes(true), steps);
  const std::vector<double> mended = energy_added(shock_of_velocities(), steps);
  Table table{"stack",
              {{"time_s", "s", "time"},
               {"printed_J", "J", "energy added so far by pushes of 1 mm, nothing being damped"},
               {"stable_J", "J", "the same, stable boxes being found"},
               {"mended_J", "J", "with shock propagation of velocities"}}};
  for (std::size_t k = 0; k < printed.size(); ++k)
    table.add(kStep * static_cast<double>(k), printed[k], stable[k], mended[k]);
  result.tables.push_back(table);
  const std::string added = "X6: energy added to a stack of five at rest, ";
  const auto each_second = [&](const std::string& how, const std::vector<double>& energies) {
    result.add(added + "for each second, " + how, "W", energies.back() / duration);
  };
  each_second("positions pushed", printed);
  each_second("velocities stopped", mended);
  result.add(added + "in all, positions pushed, stable boxes found", "J", stable.back());
  each_second("positions pushed, damped", energy_added(damped_pushes(1.0), steps));
  each_second("positions pushed, damped with half of all thresholds",
              energy_added(damped_pushes(0.5), steps));
}

}  // namespace

void add_repair_errata(int cap, double duration, Result& result) {
  const DampedErrata all = DampedErrata::all();
  result.add("X1: pushes of a cube below the ground, as listed, until a cap", "-",
             endless_pushes(cap, all.without("X1").without("X2")));
  result.add("X1: pushes of a cube below the ground, along the normal of now", "-",
             endless_pushes(cap, all));
  compare(result, "X2: way of a fixed shelf that a cube has risen into, ", "m", "upper body pushed",
          "movable body pushed", all, shelf_moved);
  add_gap(result);
  add_overlap_left(pressed_row(), "X4: overlap left in a row pressed against a wall, ", "one pass",
                   "repeated sweeps", result);
  add_overlap_left(plank_on_pillar(4.5e-3),
                   "X5: overlap left of a plank and the cube on its low end, ", "by height",
                   "by support", result);
  add_pushed_energy(result);
  add_stack_erratum(duration, result);
}

}  // namespace tumble::chapters
