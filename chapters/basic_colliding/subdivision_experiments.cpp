/// \file
/// \brief Experiment on broad phases: how many tests of bounds they save (thesis 4.1).
#include "tumble/dynamics/integrate.hpp"
#include "tumble/geometry/broad_phase.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

constexpr double kEdge = 1.0;  // [m] of every cube

// All pairs first, then the methods that subdivide space.
constexpr std::array<const char*, 6> kMethods = {"all_pairs",     "sweep_and_prune", "hashed_grid",
                                                 "bounding_tree", "kd_tree",         "octree"};

// Cubes that fly and tumble in a large cube of space and turn back at its walls. They pass through
// one another: a broad phase does not care.
class Swarm {
 public:
  Swarm(int count, double spacing, Random random)
      : cube_(box_properties(Vec3::Constant(kEdge), 1.0)),
        half_(0.5 * spacing * elementary::pow(count, 1.0 / 3.0)) {
    for (int k = 0; k < count; ++k) {
      Random chance = random.fork(static_cast<std::uint64_t>(k));
      const Vec3 position_w = chance.in_cube(half_);
      const Quat orientation_wb = chance.orientation();
      const Vec3 velocity_w = chance.in_cube(2.0);
      const Vec3 spin_w = chance.in_cube(2.0);
      states_.push_back(make_state(cube_, position_w, orientation_wb, velocity_w, spin_w));
    }
  }

  void step() {
    for (BodyState& state : states_) {
      fly(cube_, state, Vec3::Zero(), kStep, RotationRule::frozen);
      for (int axis = 0; axis < 3; ++axis) {
        double& momentum = state.linear_momentum_w[axis];
        if (state.position_w[axis] * momentum > 0.0 && std::abs(state.position_w[axis]) > half_)
          momentum = -momentum;
      }
    }
  }

  void fill(std::vector<Bounds>& bounds) const {
    bounds.clear();
    for (const BodyState& state : states_) bounds.push_back(bounds_of(cube_, state));
  }

 private:
  BodyProperties cube_;
  double half_;  // [m]
  std::vector<BodyState> states_;
};

// Tests per step with each method, on average over the steps of one run, and pairs that overlap.
struct PairWork {
  std::array<double, kMethods.size()> tests{};
  double pairs = 0.0;
};

PairWork measure(int count, const Parameters& settings, int seed) {
  const int steps = settings.count("steps");
  Swarm swarm(count, settings.number("spacing"), Random(static_cast<std::uint64_t>(seed)));
  std::vector<std::unique_ptr<BroadPhase>> methods;
  for (const char* name : kMethods) methods.push_back(make_broad_phase(name));
  std::vector<Bounds> bounds;
  std::vector<IndexPair> pairs;
  std::vector<IndexPair> all_pairs;
  PairWork work;
  for (int k = 0; k < steps; ++k) {
    swarm.step();
    swarm.fill(bounds);
    // The number of tests of all pairs is always the same: once is enough, as the judge of the rest.
    const bool last = k + 1 == steps;
    for (std::size_t m = last ? 0 : 1; m < methods.size(); ++m) {
      methods[m]->find_pairs(bounds, m == 0 ? all_pairs : pairs);
      if (last && m > 0 && pairs != all_pairs)
        throw std::runtime_error(std::string(kMethods[m]) + " finds other pairs");
      const auto tests = static_cast<double>(methods[m]->pair_tests());
      work.tests[m] += m == 0 ? tests : tests / steps;
    }
  }
  work.pairs = static_cast<double>(all_pairs.size());
  return work;
}

// The runs of all seeds, one method after the other.
struct MethodRuns {
  std::array<std::vector<double>, kMethods.size()> tests;  // per step, by seed
  std::vector<double> pairs;

  [[nodiscard]] double mean(std::size_t method) const {
    return sum_without(tests[method], -1) / static_cast<double>(tests[method].size());
  }
  // Tests of all pairs over those of another method, or of the best one of all.
  [[nodiscard]] double saving(std::size_t method, int left_out) const {
    return sum_without(tests[0], left_out) / sum_without(tests[method], left_out);
  }
  [[nodiscard]] double best_saving(int left_out) const {
    double best = 0.0;
    for (std::size_t m = 1; m < kMethods.size(); ++m) best = std::max(best, saving(m, left_out));
    return best;
  }
};

MethodRuns measure_all(int count, const Parameters& settings) {
  MethodRuns runs;
  for (int seed = 1; seed <= settings.count("seeds"); ++seed) {
    const PairWork work = measure(count, settings, seed);
    for (std::size_t m = 0; m < kMethods.size(); ++m) runs.tests[m].push_back(work.tests[m]);
    runs.pairs.push_back(work.pairs);
  }
  return runs;
}

Result measure_subdivision(const Parameters& settings) {
  const int seeds = settings.count("seeds");
  Table table{"",
              {{"bodies", "-", "cubes"},
               {"all_pairs", "-", "tests of two bounds per step: every pair"},
               {"sweep_and_prune", "-", "the same, sweep and prune"},
               {"hashed_grid", "-", "the same, hashed grid"},
               {"bounding_tree", "-", "the same, bounding tree (tests of nodes counted)"},
               {"kd_tree", "-", "the same, kd-tree (bodies of each cell that is cut counted)"},
               {"octree", "-", "the same, octree (ditto)"},
               {"overlaps", "-", "pairs of bounds that do overlap"}}};
  std::vector<Quantity> quantities;
  int crossing = 0;  // the largest number at which all pairs is no worse than the tree
  for (const int count : {2, 3, 4, 5, 6, 8, 10, 15, 20, 30, 50, 100, 200, 500, 1000, 2000, 3000}) {
    if (count > settings.count("most")) break;
    const MethodRuns runs = measure_all(count, settings);
    table.add(count, runs.mean(0), runs.mean(1), runs.mean(2), runs.mean(3), runs.mean(4),
              runs.mean(5), sum_without(runs.pairs, -1) / seeds);
    if (runs.mean(0) <= runs.mean(3)) crossing = count;
    if (count != 1000) continue;
    quantities.push_back(
        over_seeds("tests of all pairs over those of the best broad phase, at 1000 bodies", "-",
                   seeds, [&](int left_out) { return runs.best_saving(left_out); }));
    for (const std::size_t m : {2U, 3U, 4U, 5U})
      quantities.push_back(over_seeds(std::string("the same, ") + kMethods[m], "-", seeds,
                                      [&](int left_out) { return runs.saving(m, left_out); }));
  }
  quantities.push_back(
      {"bodies up to which all pairs tests no more than bounding_tree", "-", crossing});
  return {{table}, quantities};
}

const Registered claim_4_1a_subdivision_figure{
    {.name = "claim_4_1a_subdivision",
     .parameters = {whole("seeds", 20, 1, 1000, "runs for each number of bodies"),
                    whole("steps", 30, 1, 1000, "of 1/60 s in a run"),
                    number("spacing", 2.0, 1.0, 100.0, "m", "edge of the space that each cube has"),
                    whole("most", 3000, 2, 3000, "most bodies")},
     .quick = {"seeds=2", "most=1000"},
     .experiment = measure_subdivision}};

}  // namespace
}  // namespace tumble::chapters
