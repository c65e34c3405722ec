/// \file
/// \brief Experiment on the search for impact times: how often it starts again (thesis 3.3.1).
#include "tumble/basic_colliding/basic.hpp"
#include "tumble/dynamics/pair_search.hpp"

#include "basic_colliding/near_pairs.hpp"

namespace tumble::chapters {
namespace {

// What the runs with one step came to, by seed.
struct CageCounts {
  std::vector<double> collisions;
  std::vector<double> restarts;
  std::vector<double> searches;   // that the end of a step called for
  std::vector<double> uncovered;  // of them: an earlier collision that the end did not show

  [[nodiscard]] double restarts_per_collision(int left_out) const {
    return sum_without(restarts, left_out) / sum_without(collisions, left_out);
  }
  [[nodiscard]] double uncovered_per_search(int left_out) const {
    return sum_without(uncovered, left_out) / sum_without(searches, left_out);
  }
};

// The first search of a step, done with care: of all pairs that overlap at its end, the one that met
// first. What is left is the thesis's case: at that time a pair overlaps that is apart at the end.
class CarefulSearch {
 public:
  void look_ahead(const World& world, double dt) {
    const Flight flight{.bodies = world.bodies(),
                        .states = world.states(),
                        .gravity_w = world.gravity_w,
                        .rule = RotationRule::frozen};
    shown_.clear();
    hidden_.clear();
    ends_.clear();
    for (std::size_t k = 0; k < world.bodies().size(); ++k)
      ends_.push_back(state_at(flight, static_cast<int>(k), dt));
    const auto gap_at_end = [&](const IndexPair& pair) {
      return gap_between(world.bodies()[idx(pair.first)], ends_[idx(pair.first)],
                         world.bodies()[idx(pair.second)], ends_[idx(pair.second)]);
    };
    for (const IndexPair& pair : near_.find(world, dt))
      (gap_at_end(pair).distance < 0.0 ? shown_ : hidden_).push_back(pair);

    double first = dt;
    for (const IndexPair& pair : shown_) {
      const PairCollision met = find_collision(flight, pair, 0.0, dt);
      if (met.status == CollisionStatus::found) first = std::min(first, met.time);
    }
    if (first == dt) return;
    searches += 1.0;
    const auto met_before = [&](const IndexPair& pair) {
      return gap_at(flight, pair, first).distance < 0.0 &&
             gap_at(flight, pair, 0.0).distance >= 0.0;
    };
    if (std::ranges::any_of(hidden_, met_before)) uncovered += 1.0;
  }

  double searches = 0.0;
  double uncovered = 0.0;

 private:
  NearPairs near_;
  std::vector<BodyState> ends_;    // of all bodies, at the end of the step
  std::vector<IndexPair> shown_;   // overlapping at the end of the step
  std::vector<IndexPair> hidden_;  // apart then
};

// Cubes fly about in a closed cage, without gravity, friction and loss. Searches cost as much as the steps.
void run_cage(double room, int cubes, int seconds, int steps_per_second, int seed,
              bool count_searches, CageCounts& counts) {
  World world = build_world(
      make_scene("cage", {"count=" + std::to_string(cubes), "room=" + std::to_string(room)},
                 static_cast<std::uint64_t>(seed)));
  BasicOptions options;
  options.rotation = RotationRule::frozen;  // exact for cubes, and the fastest
  Basic basic(options);
  double collisions = 0.0;
  double restarts = 0.0;
  CarefulSearch search;
  const int steps = seconds * steps_per_second;
  for (int k = 0; k < steps; ++k) {
    if (count_searches) search.look_ahead(world, 1.0 / steps_per_second);
    const StepReport report = finished(basic.step(world, 1.0 / steps_per_second));
    collisions += static_cast<double>(report.events);
    restarts += static_cast<double>(report.restarts);
  }
  counts.collisions.push_back(collisions);
  counts.restarts.push_back(restarts);
  counts.searches.push_back(search.searches);
  counts.uncovered.push_back(search.uncovered);
}

// The ratio that decides, with another number of cubes that have as much space each, in runs of about as
// many collisions. Fewer seeds do: the bound is far away.
Quantity ratio_with(const Parameters& settings, int cubes, const char* name) {
  const int seconds = std::max(1, settings.count("duration") * settings.count("count") / cubes);
  const int seeds = settings.count("varied");
  CageCounts coarse;
  CageCounts fine;
  for (int seed = 1; seed <= seeds; ++seed) {
    run_cage(settings.number("room"), cubes, seconds, 60, seed, false, coarse);
    run_cage(settings.number("room"), cubes, seconds, 480, seed, false, fine);
  }
  return over_seeds(name, "-", seeds, [&](int left_out) {
    return fine.restarts_per_collision(left_out) / coarse.restarts_per_collision(left_out);
  });
}

Result measure_restarts(const Parameters& settings) {
  constexpr std::array<int, 6> steps_per_second = {15, 30, 60, 120, 240, 480};
  const int seeds = settings.count("seeds");
  const int cubes = settings.count("count");
  std::array<CageCounts, 6> counts;
  const auto per_collision = [&](std::size_t i, const char* name) {
    return over_seeds(name, "-", seeds,
                      [&](int left_out) { return counts[i].restarts_per_collision(left_out); });
  };
  const auto per_search = [&](std::size_t i, const char* name) {
    return over_seeds(name, "-", seeds,
                      [&](int left_out) { return counts[i].uncovered_per_search(left_out); });
  };
  Table table{"", {{"step_s", "s", "time step"}}};
  add_interval_columns("restarts", "-", "restarts of the search per collision", table);
  add_interval_columns("uncovered", "-",
                       "share of searches that uncover what the step's end does not show", table);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    for (int seed = 1; seed <= seeds; ++seed)
      run_cage(settings.number("room"), cubes, settings.count("duration"), steps_per_second[i],
               seed, true, counts[i]);
    table.add(1.0 / steps_per_second[i], with_interval(per_collision(i, "")),
              with_interval(per_search(i, "")));
  }

  // The same seeds with every step: the ratio is made of sums that belong together.
  const auto ratio = [&](std::size_t fine, std::size_t coarse) {
    return [&counts, fine, coarse](int left_out) {
      return counts[fine].restarts_per_collision(left_out) /
             counts[coarse].restarts_per_collision(left_out);
    };
  };
  return {{table},
          {over_seeds("restarts per collision at 1/480 s over those at 1/60 s", "-", seeds,
                      ratio(5, 2)),
           over_seeds("the same, 1/120 s over 1/15 s", "-", seeds, ratio(3, 0)),
           ratio_with(settings, std::max(2, cubes / 2),
                      "the same, 1/480 s over 1/60 s, half as many cubes"),
           ratio_with(settings, 2 * cubes, "the same, 1/480 s over 1/60 s, twice as many cubes"),
           per_search(2, "searches that uncover a hidden collision, 1/60 s")}};
}

const Registered claim_3_3_1c_restarts_figure{
    {.name = "claim_3_3_1c_restarts",
     .parameters = {whole("seeds", 20, 1, 1000, "runs for each step"),
                    whole("varied", 4, 1, 1000, "runs with half and with twice as many cubes"),
                    whole("duration", 10, 1, 100, "length of a run in seconds"),
                    whole("count", 60, 2, 1000, "cubes"),
                    number("room", 2.5, 1.8, 100.0, "m", "edge of the space that each cube has")},
     .quick = {"seeds=2", "varied=2", "duration=5"},
     .experiment = measure_restarts}};

}  // namespace
}  // namespace tumble::chapters
