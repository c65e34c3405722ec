/// \file
/// \brief A series of blocks as one heavier block: levels, thresholds, work.
#include "tumble/geometric_stability/towers.hpp"

#include "geometric_stability/balance_drawing.hpp"
#include "geometric_stability/balance_limits.hpp"

namespace tumble::chapters {

double largest_overhang(int blocks) {
  double sum = 0.0;
  for (int k = 1; k <= blocks; ++k) sum += 0.5 / k;
  return sum;
}

namespace {

// Blocks of 1 m length over the edge of a table, the k-th from the top 1/k as far over the one below it as
// the uppermost: they reach farthest, and all of them would tip at once.
RestingPile blocks_over_edge(int blocks, double overhang) {
  World world;
  const BodyProperties table = fixed_box_properties(Vec3(4.0, 1.0, 1.0));
  world.add(table, make_state(table, Vec3(-2.0, -0.5, 0.0)), "table");
  const BodyProperties block = box_properties(Vec3(1.0, 0.25, 1.0), 1.0);
  double right = 0.0;  // [m] of the edge below
  for (int k = blocks; k >= 1; --k) {
    right += overhang / largest_overhang(blocks) * 0.5 / k;
    world.add(block, Vec3(right - 0.5, 0.25 * (blocks - k) + 0.125, 0.0));
  }
  return pile_of(std::move(world));
}

}  // namespace

RestingPile series_of(std::string_view pattern, int blocks, double overhang) {
  return pile_of(build_world(
      make_scene("fig6_4", {"pattern=" + std::string(pattern), "count=" + std::to_string(blocks),
                            setting("overhang", overhang)})));
}

double series_limit(std::string_view pattern, int blocks, StandTest test) {
  return threshold([&](double overhang) { return test(series_of(pattern, blocks, overhang)); },
                   0.98, 0.01);
}

double edge_error(int blocks, StandTest test) {
  const double wanted = largest_overhang(blocks);
  const double found =
      threshold([&](double overhang) { return test(blocks_over_edge(blocks, overhang)); },
                1.5 * wanted, 0.5 * wanted);
  return relative_error(found, wanted);
}

namespace {

constexpr const char* kStaircase = "staircase";
constexpr const char* kToAndFro = "to_and_fro";

// The base of a series, and its lowest block: by index, after the ground.
constexpr int kBase = 1;
constexpr int kLowest = 2;

// The series as a load on its base.
struct OneBlock {
  Towers towers;
  TowerLoad load;        // all blocks
  BalanceReport report;  // of the base with that load
};

OneBlock one_block(const RestingPile& series) {
  OneBlock one;
  one.towers.run(series.world, series.contacts, {});
  one.load = one.towers.loads()[kLowest];
  std::vector<char> held(series.world.bodies().size(), 1);
  held[kBase] = 0;
  const Load load{kBase, one.load.centre_w(), one.load.mass * series.world.gravity_w};
  ContactList below;
  for (const Contact& contact : series.contacts)
    if (contact.second == kBase) below.push_back(contact);
  StaticEquilibrium equilibrium;
  one.report = equilibrium.solve(series.world, {below, {&load, 1}, held});
  return one;
}

Table work_table(int largest) {
  Table table{"",
              {{"blocks", "-", "in the series, to and fro by a quarter of their length"},
               {"unknowns", "-", "contact forces, block by block"},
               {"unknowns_one", "-", "contact forces of the base, with the series as a load"},
               {"baraff", "-", "multiplications of Baraff's method, block by block"},
               {"equilibrium", "-", "multiplications of the test of balance, block by block"},
               {"one", "-", "multiplications of that test with the series as a load"}}};
  for (int n = 1; n <= largest; ++n) {
    const RestingPile series = series_of(kToAndFro, n, 0.25);
    const BalanceWork work = work_of(series);
    const OneBlock one = one_block(series);
    table.add(n, work.equilibrium.unknowns, one.report.unknowns, work.multiplications,
              work.equilibrium.multiplications, one.report.multiplications);
  }
  return table;
}

// Of each level of a series: where the upper block touches, and the centre of all from it upwards.
Table level_table(const RestingPile& series, const Towers& towers) {
  Table table{"levels",
              {{"y_m", "m", "height of the contact"},
               {"left_m", "m", "left end of the hull of the contact"},
               {"right_m", "m", "right end"},
               {"centre_m", "m", "centre of all blocks above, to the right"}}};
  for (const Contact& contact : series.contacts) {
    if (contact.second < kLowest) continue;
    double left = contact.points[0].position_w.x();
    double right = left;
    for (int p = 1; p < contact.count; ++p) {
      left = std::min(left, contact.points[idx(p)].position_w.x());
      right = std::max(right, contact.points[idx(p)].position_w.x());
    }
    table.add(contact.points[0].position_w.y(), left, right,
              towers.loads()[idx(contact.second)].centre_w().x());
  }
  return table;
}

// Where the force of the base on the lowest block acts, block by block.
struct Support {
  double x = 0.0;      // [m]
  double y = 0.0;      // [m]
  double force = 0.0;  // [N]
};

Support support_of(const RestingPile& series) {
  StaticEquilibrium equilibrium;
  equilibrium.solve(series.world, weights_of(series));
  Support support;
  std::size_t push = 0;
  for (const Contact& contact : series.contacts)
    for (int p = 0; p < contact.count; ++p, ++push) {
      if (contact.first != kBase || contact.second != kLowest) continue;
      const double force = equilibrium.forces_w()[push].y();
      support.force += force;
      support.x += force * contact.points[idx(p)].position_w.x();
      support.y = contact.points[idx(p)].position_w.y();
    }
  support.x /= support.force;
  return support;
}

Result measure_one_block(const Parameters& settings) {
  const int count = settings.count("count");
  const RestingPile stands = series_of(kStaircase, count, settings.number("overhang"));
  const OneBlock one = one_block(stands);
  if (!towers_stand(stands) || !balanced(stands))
    throw std::runtime_error("the first staircase does not stand: give a smaller overhang");
  const Table levels = level_table(stands, one.towers);
  const Support support = support_of(stands);
  const Vec3 centre_w = one.load.centre_w();

  Table boxes = boxes_table();
  add_boxes(stands.world, 0.0, {}, boxes);
  // In its place: one block as high as all of them, on the ground that the lowest one covers.
  const double high = 2.0 * (centre_w.y() - support.y);
  boxes.rows.push_back(boxes.rows[0]);
  boxes.rows.back()[0] = 1.0;
  boxes.add(1.0, stands.world.states()[kLowest].position_w.x(), centre_w.y(),
            stands.world.bodies()[kLowest].size.x(), high, 1.0);
  Table replaced{"one",
                 {{"mass_kg", "kg", "of the one block"},
                  {"x_m", "m", "its centre, to the right"},
                  {"y_m", "m", "its centre, up"},
                  {"support_x_m", "m", "where the force of the base acts, block by block"},
                  {"support_y_m", "m", "height of the base"},
                  {"force_N", "N", "of the base"},
                  {"overhang", "-", "of each block of the staircase that stands"},
                  {"beyond", "-", "of each block of the one that tips"}},
                 {{one.load.mass, centre_w.x(), centre_w.y(), support.x, support.y, support.force,
                   settings.number("overhang"), settings.number("beyond")}}};

  const RestingPile falls = series_of(kStaircase, count, settings.number("beyond"));
  StaticEquilibrium equilibrium;
  if (equilibrium.solve(falls.world, weights_of(falls)).balanced)
    throw std::runtime_error("the second staircase stands: give a larger value for beyond");
  Towers towers;
  towers.run(falls.world, falls.contacts, {});
  int tips = 0;
  for (int b = kLowest; b < falls.world.count(); ++b)
    if (towers.states()[idx(b)] == TowerState::tips) tips = b;
  add_boxes(falls.world, 2.0, equilibrium.motion(), boxes);
  const StartOfMotion starts = start_of_motion(falls.world, equilibrium.motion(), 0.25);

  double by_towers = 0.0;
  double by_balance = 0.0;
  for (int n = 1; n <= 6; ++n) {
    by_towers = std::max(by_towers, edge_error(n, towers_stand));
    by_balance = std::max(by_balance, edge_error(n, whole_stands));
  }
  Table work = work_table(settings.count("largest"));
  const std::vector<double>& last = work.rows.back();
  return {{work, boxes, levels, replaced, starts.outlines, starts.arrows},
          {{"mass of the one block", "kg", one.load.mass},
           {"its centre, from the middle of the lowest block", "m", centre_w.x()},
           {"distance of the support force, found block by block, from it", "m",
            std::abs(support.x - centre_w.x())},
           {"overhang up to which the staircase stands, by towers", "-",
            series_limit(kStaircase, count, towers_stand)},
           {"overhang up to which five blocks to and fro stand, by towers", "-",
            series_limit(kToAndFro, 5, towers_stand)},
           {"block of the staircase that tips beyond, counted from below", "-", tips - kBase},
           {"overhang over an edge that six blocks reach, by towers", "m",
            threshold([](double d) { return towers_stand(blocks_over_edge(6, d)); }, 2.0, 0.5)},
           {"largest relative error of the reach of one to six blocks, by towers", "-", by_towers},
           {"the same, by static equilibrium block by block", "-", by_balance},
           {"unknown forces of the longest series, block by block", "-", last[1]},
           {"the same, with the series as one block", "-", last[2]},
           {"multiplications for the longest series, block by block over as one block", "-",
            last[4] / last[5]}}};
}

const Registered fig6_4_one_block_figure{
    {.name = "fig6_4_one_block",
     .parameters = {whole("count", 5, 2, 20, "blocks of the staircase"),
                    number("overhang", 0.18, 0.0, 0.9, "-", "of each block, one that stands"),
                    number("beyond", 0.23, 0.0, 0.9, "-", "of each block, one that tips"),
                    whole("largest", 16, 1, 60, "blocks of the longest series")},
     .quick = {"largest=8"},
     .experiment = measure_one_block}};

}  // namespace
}  // namespace tumble::chapters
