/// \file
/// \brief Share of the work saved by SETGEOMETRICALLYSTABLE as printed that may be saved (thesis 5.4, A.2).
#include "tumble/contact/tolerances.hpp"
#include "tumble/geometric_stability/as_printed/set_geometrically_stable_as_printed.hpp"
#include "tumble/geometric_stability/load_proof.hpp"
#include "tumble/geometric_stability/static_equilibrium.hpp"

#include "driver/experiment.hpp"
#include "geometric_stability/random_piles.hpp"
#include "geometric_stability/resting_pile.hpp"

namespace tumble::chapters {
namespace {

constexpr double kAccelerates = 1e-3;  // [-] of g: a box that is faster may not be left out
constexpr double kPyramidGap = 0.05;   // [-] of the pyramids

// The listing as printed, with everything mended, and with one erratum each left in.
struct Reading {
  const char* name;
  PrintedStabilityRepairs repairs;
};

constexpr std::size_t kReadings = 6;
using Readings = std::array<Reading, kReadings>;

Readings readings() {
  // [kg m/s] Cubes of 1 m and 1 kg.
  const PrintedStabilityRepairs mended{
      true, true, true, true, true, true, tolerance::resting_speed * std::sqrt(9.81)};
  Readings list{{{"as printed", {}},
                 {"mended", mended},
                 {"G2", mended},
                 {"G3", mended},
                 {"G4", mended},
                 {"G8", mended}}};
  list[2].repairs.both_bodies = false;
  list[3].repairs.vetoes_last = false;
  list[4].repairs.immovable = false;
  list[5].repairs.tolerances = false;
  return list;
}

// Contact points of one or more instants.
struct Points {
  double all = 0.0;         // unknowns of the full system
  double load_proof = 0.0;  // removed if all that bear every load are left out
  std::array<double, kReadings> removed{};
  std::array<double, kReadings> wrong{};  // of these, at a box that accelerates
  std::array<double, kReadings> lucky{};  // at boxes that do not, but are not stable when mended

  void add(const Points& other) {
    all += other.all;
    load_proof += other.load_proof;
    for (std::size_t r = 0; r < kReadings; ++r) {
      removed[r] += other.removed[r];
      wrong[r] += other.wrong[r];
      lucky[r] += other.lucky[r];
    }
  }
};

// Looks at instants, one after the other, as the listing is called in each step.
class Listings {
 public:
  Points look(const RestingPile& pile) {
    const std::vector<char> fast = accelerating_from_rest(pile);
    Points points;
    for (std::size_t r = 0; r < kReadings; ++r) {
      known_[r].resize(fast.size());
      set_geometrically_stable_as_printed(pile.world, pile.contacts, readings_[r].repairs,
                                          known_[r]);
    }
    for (const Contact& contact : pile.contacts) {
      points.all += contact.count;
      const auto a = static_cast<std::size_t>(contact.first);
      const auto b = static_cast<std::size_t>(contact.second);
      for (std::size_t r = 0; r < kReadings; ++r) {
        if (!known_[r][a].stable || !known_[r][b].stable) continue;
        const bool wrong = fast[a] != 0 || fast[b] != 0;
        const bool granted = known_[1][a].stable && known_[1][b].stable;
        points.removed[r] += contact.count;
        if (wrong) points.wrong[r] += contact.count;
        if (!wrong && !granted) points.lucky[r] += contact.count;
      }
    }
    return points;
  }

 private:
  // By static equilibrium: how bodies would begin to move from rest where they are.
  static std::vector<char> accelerating_from_rest(const RestingPile& pile) {
    StaticEquilibrium equilibrium;
    BalanceTask task;
    task.contacts = pile.contacts;
    equilibrium.solve(pile.world, task);
    RestingForces motion;
    motion.accelerations.assign(equilibrium.motion().begin(), equilibrium.motion().end());
    return accelerating(pile, motion, kAccelerates);
  }

  Readings readings_ = readings();
  std::array<std::vector<PrintedStability>, kReadings> known_;
};

Points of_scene(const std::string& name, const std::vector<std::string>& settings) {
  return Listings().look(pile_of(build_world(scene_with(name, settings))));
}

// By seed: random piles at rest.
std::vector<Points> of_random_piles(int seeds, double tilted) {
  std::vector<Points> list;
  for (int seed = 1; seed <= seeds; ++seed) {
    const RestingPile pile =
        pile_of(random_pile(static_cast<std::uint64_t>(seed), {.tilted = tilted}));
    Points points = Listings().look(pile);
    std::vector<char> proof;
    LoadProof().run(pile.world, pile.contacts, proof);
    points.load_proof = points.all - points_without(pile, proof);
    list.push_back(points);
  }
  return list;
}

// A second of a pyramid in motion; corners stay marked from step to step, if that is not mended.
Points of_run(const World& world) {
  Listings listings;
  Points points;
  count_run(world, 60,
            [&](const World& now) { points.add(listings.look(pile_now(now, 1.0 / 60.0))); });
  return points;
}

Points total(const std::vector<Points>& list, int without = -1) {
  Points sum;
  for (std::size_t k = 0; k < list.size(); ++k)
    if (static_cast<int>(k) != without) sum.add(list[k]);
  return sum;
}

double right_share(const Points& points, std::size_t reading) {
  return 1.0 - points.wrong[reading] / points.removed[reading];
}

// A row for each way to read the listing.
void add_group(double group, const Points& points, Table& table) {
  for (std::size_t r = 0; r < kReadings; ++r)
    table.add(group, r, points.all, points.removed[r],
              points.removed[r] - points.wrong[r] - points.lucky[r], points.lucky[r],
              points.wrong[r]);
}

Result measure_share_of_gain(const Parameters& settings) {
  const int seeds = settings.count("seeds");
  const std::vector<Points> upright = of_random_piles(seeds, 0.0);
  const std::vector<Points> tilted = of_random_piles(seeds, settings.number("tilted"));
  std::vector<Points> both = upright;
  both.insert(both.end(), tilted.begin(), tilted.end());
  std::vector<Points> knocked;
  for (int knock = 1; knock <= settings.count("knocks"); ++knock)
    knocked.push_back(
        of_run(knocked_pyramid(5, kPyramidGap, 0.2, static_cast<std::uint64_t>(knock))));
  const Points falls = of_run(knocked_pyramid(3, kPyramidGap, 0.0, 1));
  const Points apart = of_scene("fig5_6", {"rows=9", "gap=0.05"});
  const Points close = of_scene("fig5_6", {"rows=9", "gap=0"});

  Table table{"",
              {{"group", "-",
                "0, 1: figure 5.6, apart and touching; 2, 3: a wall, apart and touching; 4, 5: "
                "random piles, upright and some boxes tilted; 6: pyramids that were knocked; 7: a "
                "pyramid that falls; 8: all random piles"},
               {"reading", "-", "0: as printed; 1: mended; 2 to 5: mended but for G2, G3, G4, G8"},
               {"all", "-", "unknown forces, all boxes"},
               {"removed", "-", "of these, between bodies that are called stable"},
               {"granted", "-", "of those, also removed if mended, and no box accelerates"},
               {"lucky", "-", "not removed if mended, and no box accelerates"},
               {"wrong", "-", "at a box that accelerates by more than a thousandth of g"}}};
  add_group(0, apart, table);
  add_group(1, close, table);
  add_group(2, of_scene("wall", {"courses=6", "bricks=6"}), table);
  add_group(3, of_scene("wall", {"courses=6", "bricks=6", "gap=0"}), table);
  add_group(4, total(upright), table);
  add_group(5, total(tilted), table);
  add_group(6, total(knocked), table);
  add_group(7, falls, table);
  add_group(8, total(both), table);

  const int piles = static_cast<int>(both.size());
  const int knocks = static_cast<int>(knocked.size());
  const std::string right = "share of the unknowns removed as printed that may be removed, ";
  const std::string kept = "unknowns removed by the mended listing over those removed as printed, ";
  const auto kept_of = [](const Points& sum) { return sum.removed[1] / sum.removed[0]; };
  return {
      {table},
      {over_seeds(right + "random piles", "-", piles,
                  [&](int k) { return right_share(total(both, k), 0); }),
       over_seeds(right + "pyramids that were knocked", "-", knocks,
                  [&](int k) { return right_share(total(knocked, k), 0); }),
       {right + "pyramid that falls", "-", right_share(falls, 0)},
       over_seeds("share of the unknowns removed by the mended listing that may be removed, "
                  "random piles",
                  "-", piles, [&](int k) { return right_share(total(both, k), 1); }),
       over_seeds(kept + "random piles", "-", piles,
                  [&](int k) { return kept_of(total(both, k)); }),
       over_seeds(kept + "pyramids that were knocked", "-", knocks,
                  [&](int k) { return kept_of(total(knocked, k)); }),
       {kept + "figure 5.6, neighbours apart", "-", kept_of(apart)},
       {kept + "figure 5.6, neighbours touch", "-", kept_of(close)},
       over_seeds("unknowns of random piles, all over those left by the mended listing", "-", piles,
                  [&](int k) {
                    const Points sum = total(both, k);
                    return sum.all / (sum.all - sum.removed[1]);
                  }),
       over_seeds("the same if all that bear every load are left out", "-", piles, [&](int k) {
         const Points sum = total(both, k);
         return sum.all / (sum.all - sum.load_proof);
       })}};
}

const Registered stable_share_of_gain_figure{
    {.name = "stable_share_of_gain",
     .parameters =
         Parameters{}
             .add_whole("seeds", 40, 2, 1000, "random piles of each kind")
             .add_number("tilted", 0.3, 0.0, 1.0, "-", "share of the boxes that come down tilted")
             .add_whole("knocks", 20, 2, 1000, "knocked pyramids"),
     .quick = {"seeds=6", "knocks=2"},
     .experiment = measure_share_of_gain}};

}  // namespace
}  // namespace tumble::chapters
