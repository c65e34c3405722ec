/// \file
/// \brief A stack held up by impulses alone (thesis 2.5.2, said there of Mirtich's method).
///
/// A column of cubes that only move up and down is exactly one-dimensional, so this is a simulation
/// of its own, from impact to impact, without steps or searches. All cubes fall alike: the speed of
/// one cube against the next changes only in impacts, the next impact of two neighbours is where a
/// straight line crosses 0, and that of the lowest cube with the ground where a parabola does.
///
/// **The law.** Cubes never rest, contact is a train of small collisions. Two that meet with speed u
/// part with the larger of e u and the slowest rebound, w = g hop / 2: thrown up from the ground
/// like that, a cube is back after the shortest hop. Mirtich raises the restitution of slow
/// collisions for the same purpose. Momentum is kept in each.
///
/// What to expect: over a second, the contact below n cubes hands up n m g. With u = w in each
/// impact, the ground does so in n / hop impulses of m (u + w), and a contact between cubes that
/// carries k of them in 2k / hop impulses of half that size: n² / hop in all.
#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

// Cubes of 1 kg, from the ground up.
struct CubeColumn {
  std::vector<double> gaps;    // [m] below each cube: to the ground or to the cube below
  std::vector<double> speeds;  // [m/s] of each cube, upwards
};

struct Law {
  double slowest_rebound;  // [m/s] w
  double restitution;      // [-] e
};

struct Count {
  double time = 0.0;          // [s] simulated
  std::int64_t impulses = 0;  // in that time
  bool capped = false;        // whether it ended at the cap
};

// Speed of cube k against what is below it; below 0 it comes nearer.
double separation_speed(const CubeColumn& column, std::size_t k) {
  return column.speeds[k] - (k == 0 ? 0.0 : column.speeds[k - 1]);
}

// Time until cube k meets what is below it. A gap is at least 0 up to rounding.
double time_to_impact(const CubeColumn& column, std::size_t k) {
  const double gap = std::max(column.gaps[k], 0.0);
  const double v = separation_speed(column, k);
  if (k == 0) return (v + std::sqrt(v * v + 2.0 * kGravity * gap)) / kGravity;
  return v < 0.0 ? gap / -v : std::numeric_limits<double>::infinity();
}

void fly_all(CubeColumn& column, double time) {
  for (std::size_t k = 0; k < column.gaps.size(); ++k) {
    column.gaps[k] += separation_speed(column, k) * time;
    if (k == 0) column.gaps[k] -= 0.5 * kGravity * time * time;
  }
  for (double& speed : column.speeds) speed -= kGravity * time;
}

// Lets cube k collide with what is below it.
void collide(CubeColumn& column, std::size_t k, const Law& law, Count& count) {
  const double approach = -separation_speed(column, k);
  const double change = approach + std::max(law.restitution * approach, law.slowest_rebound);
  if (k == 0) {
    column.speeds[0] += change;
  } else {
    column.speeds[k] += 0.5 * change;
    column.speeds[k - 1] -= 0.5 * change;
  }
  column.gaps[k] = 0.0;
  ++count.impulses;
}

// Cubes start at rest, as far apart as the shortest hop is high, or less: cubes that touch exactly
// would meet in impacts at one instant for ever, and rounding would order them.
CubeColumn resting_column(int cubes, double hop, Random random) {
  CubeColumn column;
  for (int k = 0; k < cubes; ++k) {
    column.gaps.push_back(random.uniform(0.0, kGravity * hop * hop / 8.0));
    column.speeds.push_back(0.0);
  }
  return column;
}

// One impact after the other, the earliest first, the lowest of those at one time.
Count simulate(CubeColumn column, const Law& law, double duration, std::int64_t cap) {
  Count count;
  while (true) {
    std::size_t next = 0;
    double wait = time_to_impact(column, 0);
    for (std::size_t k = 1; k < column.gaps.size(); ++k) {
      const double time = time_to_impact(column, k);
      if (time < wait) {
        wait = time;
        next = k;
      }
    }
    count.capped = count.impulses == cap;
    if (count.capped || count.time + wait > duration) break;
    count.time += wait;
    fly_all(column, wait);
    collide(column, next, law, count);
  }
  if (!count.capped) count.time = duration;
  return count;
}

// All runs with one height and one shortest hop.
struct Runs {
  std::vector<double> rates;  // [1/s] impulses per second, by seed
  int capped = 0;             // runs that ended at the cap
  [[nodiscard]] double mean(int left_out = -1) const {
    const std::size_t counted = rates.size() - (left_out < 0 ? 0 : 1);
    return sum_without(rates, left_out) / static_cast<double>(counted);
  }
};

Runs run_all(int cubes, double hop, const Parameters& settings) {
  const Law law{0.5 * kGravity * hop, settings.number("restitution")};
  const int seeds = settings.count("seeds");
  Runs runs;
  for (int seed = 1; seed <= seeds; ++seed) {
    const CubeColumn start = resting_column(cubes, hop, Random(static_cast<std::uint64_t>(seed)));
    const Count count = simulate(start, law, settings.number("duration"), settings.whole("cap"));
    runs.rates.push_back(static_cast<double>(count.impulses) / count.time);
    runs.capped += count.capped ? 1 : 0;
  }
  return runs;
}

Result measure_stack_impulses(const Parameters& settings) {
  const int most = settings.count("most");
  const int seeds = settings.count("seeds");
  const std::array<double, 2> hops = {1e-3, 1e-4};  // [s] named in the claim
  const std::array<std::string, 2> names = {"1 ms", "0.1 ms"};

  Table table{"",
              {{"cubes", "-", "in the stack"},
               {"long_per_s", "1/s", "impulses per second, shortest hop 1 ms, mean over seeds"},
               {"short_per_s", "1/s", "the same, 0.1 ms"},
               {"long_capped", "-", "runs of 1 ms that met the cap"},
               {"short_capped", "-", "runs of 0.1 ms that met the cap"},
               {"long_linear_per_s", "1/s", "cubes / hop, 1 ms"},
               {"short_linear_per_s", "1/s", "cubes / hop, 0.1 ms"},
               {"long_square_per_s", "1/s", "cubes² / hop, 1 ms"},
               {"short_square_per_s", "1/s", "cubes² / hop, 0.1 ms"}}};
  std::vector<Quantity> quantities;
  std::array<std::vector<Runs>, 2> found;
  for (int n = 1; n <= most; ++n) {
    for (std::size_t h = 0; h < hops.size(); ++h) found[h].push_back(run_all(n, hops[h], settings));
    const Runs& longer = found[0].back();
    const Runs& shorter = found[1].back();
    table.add(n, longer.mean(), shorter.mean(), longer.capped, shorter.capped, n / hops[0],
              n / hops[1], n * n / hops[0], n * n / hops[1]);
  }
  int capped = 0;
  for (std::size_t h = 0; h < hops.size(); ++h) {
    const std::vector<Runs>& runs = found[h];
    const Runs& four = runs[3];
    quantities.push_back(over_seeds(
        "impulses per second with four cubes over those with one cube, shortest hop " + names[h],
        "-", seeds, [&](int left) { return four.mean(left) / runs[0].mean(left); }));
    for (const Runs& one : runs) capped += one.capped;
  }
  Parameters lively = settings;
  lively.set("restitution", "0.9");
  const Runs one = run_all(1, hops[0], lively);
  const Runs four = run_all(4, hops[0], lively);
  quantities.push_back(
      over_seeds("the same ratio, faster impacts with restitution 0.9, shortest hop 1 ms", "-",
                 seeds, [&](int left) { return four.mean(left) / one.mean(left); }));
  quantities.push_back({"runs that met the cap", "-", capped});
  return {{table}, quantities};
}

const Registered claim_2_5_2a_stack_figure{
    {.name = "claim_2_5_2a_stack",
     .parameters = {whole("most", 8, 4, 32, "cubes in the highest stack"),
                    number("restitution", 0.0, 0.0, 0.9, "-",
                           "of impacts faster than the slowest rebound"),
                    number("duration", 1.0, 1e-3, 60.0, "s", "length of each run"),
                    whole("seeds", 20, 2, 1000,
                          "runs for each height, with random gaps at the start"),
                    whole("cap", 5000000, 1000, 1000000000, "impulses allowed in a run")},
     .quick = {"most=5", "duration=0.1", "seeds=4"},
     .experiment = measure_stack_impulses}};

}  // namespace
}  // namespace tumble::chapters
