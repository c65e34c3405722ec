/// \file
/// \brief Stacks under microcollisions: how many impacts carry them (thesis 2.5.2, a second measurement).
#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

constexpr double kGap = 1e-4;      // [m] between cubes at the start, at most
constexpr double kOffset = 1e-2;   // [m] from the column's axis, at most
constexpr double kSettles = 1.0;   // [s] before impacts are counted
constexpr double kFriction = 0.5;  // [-]
constexpr int kFewSeeds = 2;
constexpr double kNever = std::numeric_limits<double>::quiet_NaN();

// Cubes of 1 m and 1 kg on one another, or beside one another on the ground.
Scene cubes(int count, bool beside, Random random) {
  Scene scene{.ground = SceneGround{}};
  scene.ground->friction = kFriction;
  double height = 0.0;
  for (int k = 0; k < count; ++k) {
    const double gap = random.uniform(0.0, kGap);
    const double x = random.uniform(-kOffset, kOffset);
    const double z = random.uniform(-kOffset, kOffset);
    height = beside ? gap : height + gap;
    scene.boxes.push_back(
        {.position_w = Vec3(beside ? 2.0 * k : x, height + 0.5, z), .friction = kFriction});
    height += 1.0;
  }
  return scene;
}

// Impacts of a second, once the cubes have settled [1/s], by seed.
std::vector<double> rates_of(int count, bool beside, int seeds, const Parameters& settings) {
  const PlayedTechnique played{"microcollisions", {"event_cap=1000000"}};
  std::vector<double> rates;
  for (int seed = 1; seed <= seeds; ++seed) {
    PlayedScene run(cubes(count, beside, Random(static_cast<std::uint64_t>(seed))), played);
    run.advance(kSettles);
    std::int64_t events = 0;
    run.advance(kSettles + settings.number("duration"),
                [&](const StepReport& report) { events += report.events; });
    rates.push_back(static_cast<double>(events) / settings.number("duration"));
  }
  return rates;
}

Result measure_stack_microcollisions(const Parameters& settings) {
  const int seeds = settings.count("seeds");
  Table table{"",
              {{"cubes", "-", "on one another"},
               {"impacts_per_s", "1/s", "mean over seeds"},
               {"square_per_s", "1/s", "those of two cubes, in step with the square"}}};
  std::map<int, std::vector<double>> rates;
  for (const int count : {1, 2, 3, 4, 6}) {
    if (count > settings.count("most")) break;
    // Three and six are for the picture alone.
    const int runs = count % 3 == 0 ? std::min(seeds, kFewSeeds) : seeds;
    rates[count] = rates_of(count, false, runs, settings);
    const double two = count == 1 ? kNever : sum_without(rates[2], -1) / seeds;
    table.add(count, sum_without(rates[count], -1) / runs, 0.25 * count * count * two);
  }
  const std::vector<double> beside = rates_of(4, true, seeds, settings);
  Result result{.tables = {table}};
  result.quantities = {
      ratio_of_sums("impacts per second with four cubes on one another over those with one cube, "
                    "under microcollisions",
                    "-", rates[4], rates[1]),
      ratio_of_sums("the same for four cubes beside one another", "-", beside, rates[1]),
      ratio_of_sums("four cubes on one another over two", "-", rates[4], rates[2]),
      mean_over_seeds("impacts per second with four cubes on one another", "1/s", rates[4])};
  return result;
}

const Registered microcollisions_figure{
    {.name = "claim_2_5_2a_microcollisions",
     .parameters = {whole("most", 6, 4, 6, "cubes in the highest stack"),
                    whole("seeds", 20, 2, 1000,
                          "runs for each height, with random gaps and offsets"),
                    number("duration", 1.0, 0.1, 60.0, "s", "in which impacts are counted")},
     .quick = {"most=4", "seeds=2", "duration=0.1"},
     .experiment = measure_stack_microcollisions}};

}  // namespace
}  // namespace tumble::chapters
