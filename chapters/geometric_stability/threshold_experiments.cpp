/// \file
/// \brief Accuracy of the limits that balance finds.
#include "geometric_stability/balance_limits.hpp"

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
  return largest_of(table.rows, [&](const std::vector<double>& row) { return row[column]; });
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
  const auto own_stands = std::ranges::count_if(masses.rows, [](const std::vector<double>& row) {
    return own_centres_stand(heavy_top(100.0, row[0]));
  });

  const BalanceWork pyramid = work_of(pile_of(
      build_world(make_scene("pyramid", {"rows=" + std::to_string(settings.count("rows"))}))));
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
     .parameters = {whole("steps", 12, 2, 200, "offsets from -0.24 to 0.24 m"),
                    whole("rows", 8, 2, 10, "of the pyramid whose work is counted")},
     .quick = {"steps=4", "rows=4"},
     .experiment = measure_thresholds}};

}  // namespace
}  // namespace tumble::chapters
