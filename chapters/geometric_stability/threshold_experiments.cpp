/// \file
/// \brief Accuracy of the limits that balance finds, and the question that friction leaves open.
#include "driver/experiment.hpp"
#include "geometric_stability/heavy_top_experiments.hpp"
#include "geometric_stability/tower_experiments.hpp"

namespace tumble::chapters {

namespace {

// [-] The mass ratio from which a rule lets figure 6.5 stand; NaN if it never does.
double mass_limit(double offset, StandTest test) {
  return threshold([&](double mass) { return test(heavy_top(mass, offset)); }, 0.01, 100.0);
}

Table mass_table(int steps) {
  Table table{"",
              {{"offset_m", "m", "of the top block of figure 6.5, to the right"},
               {"by_hand", "-", "mass ratio from which it stands, closed form"},
               {"balance", "-", "by the test of balance"},
               {"middles", "-", "by the rule that loads act at the middles of areas"},
               {"error", "-", "relative, of the test of balance"}}};
  for (int k = 0; k <= steps; ++k) {
    const double offset = 0.24 * (2.0 * k / steps - 1.0);
    const double hand = mass_ratio_by_hand(offset);
    const double found = mass_limit(offset, whole_stands);
    table.add(offset, hand, found, mass_limit(offset, middles_stand), relative_error(found, hand));
  }
  return table;
}

Table stairs_table(int most) {
  Table table{"stairs",
              {{"blocks", "-", "of the staircase"},
               {"by_hand", "-", "overhang up to which it stands, over a length: closed form"},
               {"balance", "-", "by the test of balance"},
               {"towers", "-", "as one heavier block"},
               {"middles", "-", "by the rule that loads act at the middles of areas"},
               {"own", "-", "by the rule that each block's own centre decides"},
               {"error", "-", "relative, of the test of balance"},
               {"towers_error", "-", "relative, as one heavier block"}}};
  for (int n = 2; n <= most; ++n) {
    const double hand = 1.0 / n;
    const double found = series_limit("staircase", n, whole_stands);
    const double towers = series_limit("staircase", n, towers_stand);
    table.add(n, hand, found, towers, series_limit("staircase", n, middles_stand),
              series_limit("staircase", n, own_centres_stand), relative_error(found, hand),
              relative_error(towers, hand));
  }
  return table;
}

Table edge_table(int most) {
  Table table{"edge",
              {{"blocks", "-", "over the edge of a table"},
               {"error", "-", "relative, of how far they reach, of the test of balance"},
               {"towers_error", "-", "relative, as one heavier block"}}};
  for (int n = 1; n <= most; ++n)
    table.add(n, edge_error(n, whole_stands), edge_error(n, towers_stand));
  return table;
}

double largest(const Table& table, std::size_t column) {
  double most = 0.0;
  for (const auto& row : table.rows) most = std::max(most, row[column]);
  return most;
}

// A box between two walls that touch it: nothing below.
World wedged(double friction) {
  World world;
  const BodyProperties wall = fixed_box_properties(Vec3(1.0, 4.0, 2.0), friction);
  world.add(wall, make_state(wall, Vec3(-1.0, 2.0, 0.0)), "left");
  world.add(wall, make_state(wall, Vec3(1.0, 2.0, 0.0)), "right");
  const BodyProperties box = box_properties(Vec3::Ones(), 1.0, friction);
  world.add(box, make_state(box, Vec3(0.0, 3.0, 0.0)), "box");
  return world;
}

// A plank that leans on a wall without friction.
struct LeaningPlank {
  double length = 2.0;     // [m]
  double thickness = 0.1;  // [m]
  double angle = 60.0;     // [deg] from the ground
  double turn = 0.0;       // [rad] of plank and wall together, about the vertical
};

RestingPile leaning_plank(const LeaningPlank& plank, double friction) {
  World world;
  world.add_ground(friction);
  const Quat turn = rotation_from_vector(Vec3(0.0, plank.turn, 0.0));
  const BodyProperties wall = fixed_box_properties(Vec3(1.0, 4.0, 4.0), 0.0);
  world.add(wall, make_state(wall, turn * Vec3(-0.5, 2.0, 0.0), turn), "wall");
  const BodyProperties body =
      box_properties(Vec3(plank.length, plank.thickness, 0.5), 1.0, friction);
  const double angle = plank.angle * std::numbers::pi / 180.0;
  // Its own x axis points down along it; foot and upper end are edges of its lower face.
  const Quat lean = rotation_from_vector(Vec3(0.0, 0.0, -angle));
  const Vec3 place_w = Vec3(plank.length * elementary::cos(angle), 0.0, 0.0) +
                       lean * Vec3(-0.5 * plank.length, 0.5 * plank.thickness, 0.0);
  world.add(body, make_state(body, turn * place_w, turn * lean), "plank");
  return pile_of(std::move(world));
}

// [-] The least coefficient of friction with which a plank stays. Moments about the foot: the wall pushes
// with m g (cot θ / 2 - t / (2 L)), and friction at the foot holds as much, up to μ m g. For t = 0 that is
// tan θ >= 1 / (2 μ).
double friction_by_hand(const LeaningPlank& plank) {
  const double angle = plank.angle * std::numbers::pi / 180.0;
  return 0.5 * (elementary::cos(angle) / elementary::sin(angle) - plank.thickness / plank.length);
}

// [-] The least friction with which the test of balance lets a plank stay.
double friction_limit(const LeaningPlank& plank, int edges) {
  return threshold([&](double mu) { return balanced(leaning_plank(plank, mu), edges); }, 0.001,
                   10.0);
}

Result measure_thresholds(const Parameters& settings) {
  const Table masses = mass_table(settings.count("steps"));
  const Table stairs = stairs_table(8);
  const Table edge = edge_table(6);
  // Five blocks to and fro stand up to 3/8: the centre of the upper three over the second.
  const double fro = relative_error(
      threshold([](double o) { return balanced(series_of("to_and_fro", 5, o)); }, 0.9, 0.1), 0.375);
  const double overhang =
      std::max({largest(stairs, 6), largest(stairs, 7), largest(edge, 1), largest(edge, 2), fro});
  const double mass = largest(masses, 4);
  // How many of the heaviest tops the rule of own centres lets stand.
  const auto own_stands = std::count_if(
      masses.rows.begin(), masses.rows.end(),
      [](const std::vector<double>& row) { return own_centres_stand(heavy_top(100.0, row[0])); });

  const BalanceWork pyramid = work_of(pile_of(
      build_world(scene_with("pyramid", {"rows=" + std::to_string(settings.count("rows"))}))));
  const BalanceWork heavy = work_of(heavy_top(1.0, 0.2));
  const auto ratio = [](const BalanceWork& work) {
    return static_cast<double>(work.multiplications) /
           static_cast<double>(work.equilibrium.multiplications);
  };
  return {
      {masses, stairs, edge},
      {{"largest relative error of the mass, and of the overhang, at which the equilibrium test "
        "changes its verdict, against the closed form",
        "-", std::max(mass, overhang)},
       {"the same, of the mass of figure 6.5", "-", mass},
       {"the same, of overhangs, towers included", "-", overhang},
       {"mass ratio from which figure 6.5 stands, loads at the middles of areas", "-",
        mass_limit(0.0, middles_stand)},
       {"offsets at which own centres let a top of a hundred times the mass stand", "-",
        own_stands},
       {"overhang up to which a staircase of five stands, loads at the middles of areas", "-",
        series_limit("staircase", 5, middles_stand)},
       {"the same, own centres", "-", series_limit("staircase", 5, own_centres_stand)},
       {"pivots for the pyramid, Baraff's method", "-", pyramid.pivots},
       {"pivots for the pyramid, the test of balance", "-", pyramid.equilibrium.pivots},
       {"multiplications for the pyramid, Baraff's method over balance", "-", ratio(pyramid)},
       {"multiplications for figure 6.5, Baraff's method over balance", "-", ratio(heavy)}}};
}

const Registered claim_6_3_1d_equilibrium_figure{
    {.name = "claim_6_3_1d_equilibrium",
     .parameters = Parameters{}
                       .add_whole("steps", 12, 2, 200, "offsets from -0.24 to 0.24 m")
                       .add_whole("rows", 8, 2, 10, "of the pyramid whose work is counted"),
     .quick = {"steps=4", "rows=4"},
     .experiment = measure_thresholds}};

Result measure_weakly_stable(const Parameters& settings) {
  LeaningPlank plank;
  plank.angle = settings.number("angle");
  const double hand = friction_by_hand(plank);
  Table table{"",
              {{"edges", "-", "of the pyramid of friction"},
               {"along", "-", "relative error of the least friction, plank along an edge"},
               {"between", "-", "the same, plank between two edges"},
               {"by_hand", "-", "what the pyramid lacks there: 1/cos(pi/edges) - 1"}}};
  double between_8 = 0.0;
  double between_16 = 0.0;
  double apart = 0.0;  // from what the pyramid lacks
  for (int edges = 4; edges <= settings.count("edges"); edges += 4) {
    plank.turn = 0.0;
    const double along = relative_error(friction_limit(plank, edges), hand);
    plank.turn = std::numbers::pi / edges;
    const double between = friction_limit(plank, edges) / hand - 1.0;
    const double lacks = 1.0 / elementary::cos(std::numbers::pi / edges) - 1.0;
    table.add(edges, along, between, lacks);
    apart = std::max(apart, std::abs(between - lacks));
    if (edges == 8) between_8 = between;
    if (edges == 16) between_16 = between;
  }

  const double friction = settings.number("friction");
  Table falls{"falls",
              {{"time_s", "s", "time"},
               {"contact_damped_m", "m", "how far the box has fallen, contact_damped"},
               {"analytic_m", "m", "the same, analytic"},
               {"free_m", "m", "the same, in free fall"}}};
  World damped = wedged(friction);
  World analytic = damped;
  const auto fallen = [](const World& world) { return 3.0 - world.states()[2].position_w.y(); };
  const std::unique_ptr<Technique> first = make_technique("contact_damped", {});
  const std::unique_ptr<Technique> second = make_technique("analytic", {});
  while (damped.time() < settings.number("duration") + 0.5 * kStep) {
    const double t = damped.time();
    falls.add(t, fallen(damped), fallen(analytic), 0.5 * 9.81 * t * t);
    finished(first->step(damped, kStep));
    finished(second->step(analytic, kStep));
  }
  const std::vector<double>& last = falls.rows.back();
  const RestingPile box = pile_of(wedged(friction));
  return {
      {table, falls},
      {{"the same, by hand", "-", hand},
       {"relative error, along an edge, at worst", "-", largest(table, 1)},
       {"relative error of 8 edges, between two", "-", between_8},
       {"relative error of 16 edges, between two", "-", between_16},
       {"distance of these errors from what the pyramid lacks, at worst", "-", apart},
       {"whether friction can hold the wedged box (1: yes)", "-", balanced(box, 8)},
       {"the same, without friction", "-", balanced(box)},
       {"fall of the wedged box at the end over free fall, contact_damped", "-", last[1] / last[3]},
       {"the same, analytic", "-", last[2] / last[3]}}};
}

const Registered weakly_stable_figure{
    {.name = "weakly_stable",
     .parameters =
         Parameters{}
             .add_number("angle", 60.0, 30.0, 85.0, "deg", "of the plank, from the ground")
             .add_whole("edges", 32, 16, 64, "of the finest pyramid of friction")
             .add_number("friction", 0.5, 0.01, 10.0, "-", "of walls and box")
             .add_number("duration", 0.5, 0.1, 0.6, "s", "of the fall"),
     .quick = {"edges=16"},
     .experiment = measure_weakly_stable}};

}  // namespace
}  // namespace tumble::chapters
