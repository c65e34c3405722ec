/// \file
/// \brief Travel and resting poses of boxes, damped and with Coulomb's friction (thesis 5.3).
#include "tumble/base/error.hpp"
#include "tumble/base/random.hpp"

#include "driver/registry.hpp"
#include "driver/statistics.hpp"
#include "impulse_damped/damped_variants.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace tumble::chapters {
namespace {

constexpr double kShot = 0.5;  // [s] when the cube is shot; until then the pyramid stands

// What can be seen of a run: how far things go, and how they lie in the end.
struct Seen {
  double travel = 0.0;            // [m] horizontal way from start to end, mean over the boxes
  double flat = 0.0;              // [-] share of the boxes with a face up, within two degrees
  std::vector<Vec3> ends_w = {};  // [m] where each box ends
};

double flat_across(const Vec3& way) { return std::sqrt(way.x() * way.x() + way.z() * way.z()); }

// Plays a scene to its end.
Seen play(const Scene& scene, const PlayedTechnique& technique, int seed, double duration) {
  constexpr double upright = 0.99939;  // [-] cosine of two degrees
  PlayedScene played(scene, technique, static_cast<std::uint64_t>(seed));
  played.advance(duration);
  Seen seen;
  for (const SceneBox& box : scene.boxes) {
    const BodyState& end = played.world().states()[played.index(box.name)];
    const Mat3 axes_w = end.orientation_wb.toRotationMatrix();
    seen.travel += flat_across(end.position_w - box.position_w);
    seen.flat += axes_w.row(1).cwiseAbs().maxCoeff() > upright ? 1.0 : 0.0;
    seen.ends_w.push_back(end.position_w);
  }
  const auto count = static_cast<double>(scene.boxes.size());
  seen.travel /= count;
  seen.flat /= count;
  return seen;
}

// Figure 6.6 made small. Chance takes the aim, the speed and how the cube is turned.
Scene shot(int rows, int seed) {
  Scene scene = scene_with("fig6_6", {"rows=" + std::to_string(rows), setting("appears", kShot),
                                      setting("height", 0.5 * rows)});
  Random random(static_cast<std::uint64_t>(seed));
  SceneBox& projectile = scene.boxes.back();
  const double aside = random.uniform(-1.0, 1.0);
  const double higher = random.uniform(-0.5, 0.5);
  projectile.position_w += Vec3(aside, higher, 0.0);
  projectile.velocity_w *= random.uniform(0.5, 1.0);
  projectile.orientation_wb = random.orientation();
  return scene;
}

std::vector<double> list_of(const std::vector<Seen>& runs, double Seen::*what) {
  std::vector<double> list;
  for (const Seen& run : runs) list.push_back(run.*what);
  return list;
}

double difference_of_medians(const std::vector<double>& damped,
                             const std::vector<double>& coulomb) {
  const double reference = median_of(coulomb);
  return std::abs(median_of(damped) - reference) / reference;
}

// With the interval that holds for 95 of 100 draws of as many seeds from these, each seed with both
// of its runs. The jackknife of over_seeds() does not serve for medians: leaving out a seed gives
// two values only.
Quantity median_difference(const std::string& name, const std::vector<double>& damped,
                           const std::vector<double>& coulomb) {
  constexpr int draws = 1000;
  Random random(1);
  std::vector<double> differences;
  for (int d = 0; d < draws; ++d) {
    std::vector<double> first, second;
    for (std::size_t k = 0; k < damped.size(); ++k) {
      const std::size_t seed = random.below(static_cast<std::uint32_t>(damped.size()));
      first.push_back(damped[seed]);
      second.push_back(coulomb[seed]);
    }
    differences.push_back(difference_of_medians(first, second));
  }
  std::sort(differences.begin(), differences.end());
  return {name,
          "-",
          difference_of_medians(damped, coulomb),
          differences[draws / 40],
          differences[draws - 1 - draws / 40],
          static_cast<int>(damped.size())};
}

// Mean distance between the ends of the same box in two runs.
double apart(const Seen& a, const Seen& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.ends_w.size(); ++k) sum += (a.ends_w[k] - b.ends_w[k]).norm();
  return sum / static_cast<double>(a.ends_w.size());
}

// Of each seed.
using SceneOfSeed = std::function<Scene(int seed)>;

std::vector<Seen> play_all(const SceneOfSeed& scene, const PlayedTechnique& technique, int seeds,
                           double duration) {
  std::vector<Seen> runs;
  for (int seed = 1; seed <= seeds; ++seed)
    runs.push_back(play(scene(seed), technique, seed, duration));
  return runs;
}

Result measure_what_is_seen(const Parameters& settings) {
  const int seeds = settings.count("seeds");
  require::that(seeds >= 2, "medians over seeds take two of them");
  const int rows = settings.count("rows");
  const double duration = settings.number("duration");
  const std::string cubes = "per_edge=" + std::to_string(settings.count("per_edge"));
  const SceneOfSeed shots = [&](int seed) { return shot(rows, seed); };
  const SceneOfSeed clumps = [&](int seed) {
    return scene_with("fig6_7", {cubes}, static_cast<std::uint64_t>(seed));
  };
  const std::string decides =
      "difference of the median travel over seeds, damped and with Coulomb's friction, over the "
      "latter";

  // The verdict is about the shot: there friction alone ends the way of what was hit. Cubes of a
  // clump are stopped by one another.
  const std::vector<Seen> coulomb = play_all(shots, coulomb_technique(), seeds, duration);
  const std::vector<double> far = list_of(coulomb, &Seen::travel);
  std::vector<Quantity> quantities;
  std::vector<Seen> damped;
  for (const DampedVariant& variant : damped_variants()) {
    const std::vector<Seen> runs = play_all(shots, variant.technique, seeds, duration);
    quantities.push_back(
        median_difference(variant.words.empty() ? decides : "the same, " + variant.words,
                          list_of(runs, &Seen::travel), far));
    if (variant.words.empty()) damped = runs;
  }
  const std::vector<Seen> clump_coulomb = play_all(clumps, coulomb_technique(), seeds, duration);
  const std::vector<Seen> clump_damped = play_all(clumps, {"damped"}, seeds, duration);
  quantities.push_back(median_difference("the same of cubes that fly together",
                                         list_of(clump_damped, &Seen::travel),
                                         list_of(clump_coulomb, &Seen::travel)));

  Table table{"",
              {{"scene", "-", "0: a shot at a pyramid; 1: cubes that fly together"},
               {"seed", "-", "of the scene"},
               {"damped_m", "m", "horizontal way, mean over the boxes, damped"},
               {"coulomb_m", "m", "the same, Coulomb's friction"},
               {"damped_flat", "-", "share of the boxes that end with a face up, damped"},
               {"coulomb_flat", "-", "the same, Coulomb's friction"},
               {"apart_m", "m", "distance of a box's two ends, mean"}}};
  const auto add = [&](int scene, const std::vector<Seen>& a, const std::vector<Seen>& b) {
    for (std::size_t k = 0; k < a.size(); ++k)
      table.add(scene, k + 1, a[k].travel, b[k].travel, a[k].flat, b[k].flat, apart(a[k], b[k]));
  };
  add(0, damped, coulomb);
  add(1, clump_damped, clump_coulomb);

  Table medians{"medians",
                {{"scene", "-", "as above"},
                 {"damped_m", "m", "median of the way, damped"},
                 {"coulomb_m", "m", "the same, Coulomb's friction"}}};
  const auto median_travel = [](const std::vector<Seen>& runs) {
    return median_of(list_of(runs, &Seen::travel));
  };
  medians.add(0, median_travel(damped), median_travel(coulomb));
  medians.add(1, median_travel(clump_damped), median_travel(clump_coulomb));
  std::vector<double> two, same;
  for (std::size_t k = 0; k < damped.size(); ++k) {
    two.push_back(apart(damped[k], coulomb[k]));
    same.push_back(apart(coulomb[k], coulomb[(k + 1) % coulomb.size()]));
  }
  quantities.push_back({"median travel, shot, damped", "m", median_travel(damped)});
  quantities.push_back({"median travel, shot, Coulomb", "m", median_travel(coulomb)});
  quantities.push_back(
      {"ends of a box apart, shot, damped and Coulomb, median", "m", median_of(two)});
  quantities.push_back(
      {"ends of a box apart, shot, two seeds of Coulomb, median", "m", median_of(same)});
  return {{table, medians}, quantities};
}

const Registered claim_5_3g_seen_figure{
    {.name = "claim_5_3g_seen",
     .parameters = Parameters{}
                       .add_whole("seeds", 24, 2, 1000, "runs of each scene")
                       .add_whole("rows", 5, 2, 20, "of the pyramid")
                       .add_whole("per_edge", 3, 2, 6, "cubes along each edge of the clump's grid")
                       .add_number("duration", 5.0, 1.0, 60.0, "s", "of a run"),
     .quick = {"seeds=4", "duration=3", "rows=3", "per_edge=2"},
     .experiment = measure_what_is_seen}};

}  // namespace
}  // namespace tumble::chapters
