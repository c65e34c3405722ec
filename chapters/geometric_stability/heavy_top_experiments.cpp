/// \file
/// \brief A heavy block that keeps two others from tipping: forces, thresholds, runs.
#include "geometric_stability/balance_drawing.hpp"
#include "geometric_stability/balance_limits.hpp"

#include <cstdlib>

namespace tumble::chapters {

RestingPile heavy_top(double mass_ratio, double offset, double friction) {
  return pile_of(build_world(
      make_scene("fig6_5", {setting("mass_ratio", mass_ratio), setting("offset", offset),
                            setting("friction", friction)})));
}

// Lengths in metres, forces in weights of a lower block, x = 0 between the pedestals, o >= 0. The lower
// blocks have their centres at ±2, their pedestals are under ±[1, 1.75]. The top block, M at o, rests
// on the left one at a in [o - 1.25, -1] with A and on the right one at b in [1, o + 1.25] with B:
//   A + B = M,   A a + B b = M o.                                                              (1)
// Friction across these contacts pulls at the top block's lower face to both sides. It is the same,
// T, on both, or the top block would slide; and it holds the lower blocks back, with a lever of 1 about
// the outer edges of the pedestals.
// Left, about -1.75:   A (a + 1.75) + T >= 0.25.                                               (2)
// Right, about 1.75:   B (1.75 - b) + T >= 0.25.                                               (3)
// With (1) in (3):     M (1.75 - o) >= 0.25 - T + 1.75 A - A a.                                (4)
// a <= -1 makes the right of (4) at least 0.25 - T + 2.75 A, and A at least (0.25 - T) / 0.75 by (2).
// T is at most mu A, so that A >= 0.25 / (0.75 + mu), and
//   M (1.75 - o) >= 0.25 + (2.75 - mu) A >= (0.25 (0.75 + mu) + 0.25 (2.75 - mu)) / (0.75 + mu)
//                 = 0.875 / (0.75 + mu).
// It is reached with a = -1, T = mu A, and then b = (M o + A) / (M - A), which is in [1, o + 1.25] for
// o up to 0.25. The pedestals' reactions are inside of them, since what acts is between -1.75 and -1.
double mass_ratio_by_hand(double offset, double friction) {
  return 14.0 / ((3.0 + 4.0 * friction) * (7.0 - 4.0 * std::abs(offset)));
}

double mass_ratio_by_balance(double offset, double friction, int friction_edges) {
  return threshold(
      [&](double mass) { return balanced(heavy_top(mass, offset, friction), friction_edges); },
      0.01, 100.0);
}

namespace {

constexpr int kEdges = 8;  // of the pyramid of friction: two of them along x

// A technique whose runs show the same.
struct Runs {
  std::string words;                  // for the quantity
  std::string technique;              // its name
  std::vector<std::string> settings;  // its options
  bool rough = false;                 // with friction
  std::vector<double> offsets;        // [m] of the top block: marks shall not hide each other
};

std::vector<Runs> all_runs() {
  return {{"contact_damped without friction",
           "contact_damped",
           {},
           false,
           {-0.22, -0.14, -0.06, 0.05, 0.13}},
          {"analytic without friction",
           "analytic",
           {"friction=none"},
           false,
           {-0.18, -0.10, -0.03, 0.09, 0.24}},
          {"contact_damped with friction",
           "contact_damped",
           {},
           true,
           {-0.22, -0.13, -0.04, 0.05, 0.14, 0.23}}};
}

// The forces of an answer, the points of a contact at the same x taken together: from below, on
// the upper body.
Table force_table(const RestingPile& structure, const StaticEquilibrium& equilibrium) {
  Table table{"forces",
              {{"x_m", "m", "where it acts"},
               {"y_m", "m", "where it acts"},
               {"share", "-", "upwards, over the weight of a lower block"}}};
  const double weight = -structure.world.gravity_w.y();  // [N] of 1 kg
  std::size_t push = 0;
  for (const Contact& contact : structure.contacts) {
    const std::size_t first = table.rows.size();
    for (std::size_t p = 0; p < static_cast<std::size_t>(contact.count); ++p, ++push) {
      const Vec3& point_w = contact.points[p].position_w;
      const double share = std::abs(equilibrium.forces_w()[push].y()) / weight;
      auto row = table.rows.begin() + static_cast<std::ptrdiff_t>(first);
      while (row != table.rows.end() && std::abs((*row)[0] - point_w.x()) > 1e-6) ++row;
      if (row == table.rows.end())
        table.add(point_w.x(), point_w.y(), share);
      else
        (*row)[2] += share;
    }
  }
  return table;
}

Table run_table(double friction, double seconds) {
  Table table{"runs",
              {{"offset_m", "m", "of the top block"},
               {"mass_ratio", "-", "of the top block over a lower one"},
               {"stands", "-", "1: nothing has moved by a centimetre"},
               {"kind", "-",
                "0: contact_damped, no friction; 1: analytic, no friction; 2: contact_damped with "
                "friction"}}};
  int kind = 0;
  for (const Runs& runs : all_runs()) {
    const double mu = runs.rough ? friction : 0.0;
    for (const double offset : runs.offsets) {
      for (const double factor : {0.9, 0.97, 1.03, 1.1}) {
        const double mass = factor * mass_ratio_by_hand(offset, mu);
        const bool stands =
            stays(heavy_top(mass, offset, mu), runs.technique, runs.settings, seconds);
        table.add(offset, mass, stands, kind);
      }
    }
    ++kind;
  }
  return table;
}

// The error of the closed form against the mass ratio from which runs stand, at worst over offsets.
double error_of_runs(const Runs& runs, const Parameters& settings) {
  const double friction = settings.number("friction");
  const double seconds = settings.number("seconds");
  const double mu = runs.rough ? friction : 0.0;
  double worst = 0.0;
  for (const double offset : {0.0, 0.1, 0.2}) {
    const double wanted = mass_ratio_by_hand(offset, mu);
    double falls = 0.9 * wanted;
    double stands = 1.15 * wanted;
    const auto does = [&](double mass) {
      return stays(heavy_top(mass, offset, mu), runs.technique, runs.settings, seconds);
    };
    if (does(falls) || !does(stands)) return 0.1;  // at least
    while (stands - falls > settings.number("resolution") * wanted) {
      const double middle = 0.5 * (falls + stands);
      (does(middle) ? stands : falls) = middle;
    }
    worst = std::max(worst, std::abs(stands / wanted - 1.0));
  }
  return worst;
}

Table threshold_table(double friction, int steps) {
  Table table{"",
              {{"offset_m", "m", "of the top block, to the right"},
               {"by_hand", "-", "mass ratio from which it stands, closed form"},
               {"by_balance", "-", "the same, bisection on the test of balance"},
               {"rough_by_hand", "-", "with friction, closed form"},
               {"rough_by_balance", "-", "with friction, bisection"}}};
  for (int k = 0; k <= steps; ++k) {
    const double offset = 0.24 * (2.0 * k / steps - 1.0);
    table.add(offset, mass_ratio_by_hand(offset), mass_ratio_by_balance(offset),
              mass_ratio_by_hand(offset, friction),
              mass_ratio_by_balance(offset, friction, kEdges));
  }
  return table;
}

Result measure_heavy_top(const Parameters& settings) {
  const double offset = settings.number("offset");
  const double friction = settings.number("friction");
  const double seconds = settings.number("seconds");

  StaticEquilibrium equilibrium;
  const RestingPile heavy = heavy_top(settings.number("mass_ratio"), offset);
  if (!equilibrium.solve(heavy.world, weights_of(heavy)).balanced)
    throw std::runtime_error("the first configuration does not stand: give a larger mass_ratio");
  Table boxes = boxes_table();
  add_boxes(heavy.world, 0.0, {}, boxes);
  const Table forces = force_table(heavy, equilibrium);

  const RestingPile light = heavy_top(settings.number("too_light"), offset);
  if (equilibrium.solve(light.world, weights_of(light)).balanced)
    throw std::runtime_error("the second configuration stands: give less for too_light");
  add_boxes(light.world, 1.0, equilibrium.motion(), boxes);
  const StartOfMotion starts = start_of_motion(light.world, equilibrium.motion(), 0.3);
  const auto left = static_cast<std::size_t>(light.world.index_of(*light.world.find("left")));
  const double tips = equilibrium.motion()[left].angular_w.z();

  // At the threshold the forces are the only ones.
  const RestingPile limit = heavy_top(mass_ratio_by_balance(0.2), 0.2);
  equilibrium.solve(limit.world, weights_of(limit));
  double on_left = 0.0;
  double on_right = 0.0;
  double right_moment = 0.0;
  for (const auto& row : force_table(limit, equilibrium).rows) {
    if (row[1] < 1.5) continue;  // of a pedestal
    (row[0] < 0.0 ? on_left : on_right) += row[2];
    if (row[0] > 0.0) right_moment += row[2] * row[0];
  }

  const Table thresholds = threshold_table(friction, settings.count("steps"));
  std::vector<Quantity> quantities = {
      {"mass ratio from which it stands, centred", "-", mass_ratio_by_balance(0.0)},
      {"the same, top block off by 0.2 m", "-", mass_ratio_by_balance(0.2)},
      {"mass ratio from which friction can hold it, centred", "-",
       mass_ratio_by_balance(0.0, friction, kEdges)},
      {"force on the left block at the limit, off by 0.2 m, over its weight", "-", on_left},
      {"where the force on the right block acts then", "m", right_moment / on_right},
      {"acceleration with which the left block of the light case starts to turn", "rad/s2", tips}};
  for (const Runs& runs : all_runs())
    quantities.push_back(
        {"largest relative error of the mass ratio from which runs stand, " + runs.words, "-",
         error_of_runs(runs, settings)});
  return {{thresholds, run_table(friction, seconds), boxes, forces, starts.outlines, starts.arrows},
          quantities};
}

const Registered fig6_5_heavy_top_figure{
    {.name = "fig6_5_heavy_top",
     .parameters = {number("mass_ratio", 1.0, 1e-3, 1e3, "-", "of the top that stands"),
                    number("too_light", 0.5, 1e-3, 1e3, "-", "of the top that does not"),
                    number("offset", 0.2, -0.24, 0.24, "m", "of the top in both"),
                    number("friction", 0.5, 0.01, 2.0, "-", "of the runs with friction"),
                    number("seconds", 5.0, 0.1, 100.0, "s", "of each run"),
                    number("resolution", 1e-5, 1e-9, 0.1, "-",
                           "of the limit of runs, as a share of it"),
                    whole("steps", 12, 2, 200, "offsets from -0.24 to 0.24 m")},
     .quick = {"steps=2", "seconds=2", "resolution=0.01"},
     .experiment = measure_heavy_top}};

}  // namespace
}  // namespace tumble::chapters
