/// \file
/// \brief Travel and resting poses of boxes, damped and with Coulomb's friction (thesis 5.3).
#include "impulse_damped/damped_variants.hpp"

namespace tumble::chapters {
namespace {

constexpr double kShot = 0.5;  // [s] when the cube is shot; until then the pyramid stands

double flat_across(const Vec3& way) { return std::sqrt(way.x() * way.x() + way.z() * way.z()); }

// Plays a scene to its end.
// Returns [m] the horizontal way from start to end, mean over the boxes: what can be seen of it
double play(const Scene& scene, const PlayedTechnique& technique, int seed, double duration) {
  PlayedScene played(scene, technique, static_cast<std::uint64_t>(seed));
  played.advance(duration);
  double travel = 0.0;
  for (const SceneBox& box : scene.boxes)
    travel +=
        flat_across(played.world().states()[played.index(box.name)].position_w - box.position_w);
  return travel / static_cast<double>(scene.boxes.size());
}

// Figure 6.6 made small. Chance takes the aim, the speed and how the cube is turned.
Scene shot(int rows, int seed) {
  Scene scene = make_scene("fig6_6", {"rows=" + std::to_string(rows), setting("appears", kShot),
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
  std::ranges::sort(differences);
  return {name,
          "-",
          difference_of_medians(damped, coulomb),
          differences[draws / 40],
          differences[draws - 1 - draws / 40],
          static_cast<int>(damped.size())};
}

// Of each seed.
using SceneOfSeed = std::function<Scene(int seed)>;

std::vector<double> play_all(const SceneOfSeed& scene, const PlayedTechnique& technique, int seeds,
                             double duration, int after = 0) {
  std::vector<double> runs;
  for (int seed = after + 1; seed <= after + seeds; ++seed)
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
    return make_scene("fig6_7", {cubes}, static_cast<std::uint64_t>(seed));
  };
  const std::string decides =
      "difference of the median travel over seeds, damped and with Coulomb's friction, over the "
      "latter";

  // The verdict is about the shot: there friction alone ends the way of what was hit. Cubes of a
  // clump are stopped by one another.
  const std::vector<double> coulomb = play_all(shots, coulomb_technique(), seeds, duration);
  std::vector<Quantity> quantities;
  std::vector<double> damped;
  for (const DampedVariant& variant : damped_variants()) {
    const std::vector<double> runs = play_all(shots, variant.technique, seeds, duration);
    quantities.push_back(median_difference(
        variant.words.empty() ? decides : "the same, " + variant.words, runs, coulomb));
    if (variant.words.empty()) damped = runs;
  }
  const std::vector<double> fresh = play_all(shots, coulomb_technique(), seeds, duration, seeds);
  quantities.push_back(median_difference(
      decides + ", fresh seeds", play_all(shots, {"damped"}, seeds, duration, seeds), fresh));
  quantities.push_back(median_difference(
      decides + ", as_reported",
      play_all(shots, {"damped", {"reading=as_reported"}}, seeds, duration, seeds), fresh));
  const std::vector<double> clump_coulomb = play_all(clumps, coulomb_technique(), seeds, duration);
  const std::vector<double> clump_damped = play_all(clumps, {"damped"}, seeds, duration);
  quantities.push_back(
      median_difference("the same of cubes that fly together", clump_damped, clump_coulomb));

  Table table{"",
              {{"scene", "-", "0: a shot at a pyramid; 1: cubes that fly together"},
               {"seed", "-", "of the scene"},
               {"damped_m", "m", "horizontal way, mean over the boxes, damped"},
               {"coulomb_m", "m", "the same, Coulomb's friction"}}};
  const auto add = [&](int scene, const std::vector<double>& a, const std::vector<double>& b) {
    for (std::size_t k = 0; k < a.size(); ++k) table.add(scene, k + 1, a[k], b[k]);
  };
  add(0, damped, coulomb);
  add(1, clump_damped, clump_coulomb);

  Table medians{"medians",
                {{"scene", "-", "as above"},
                 {"damped_m", "m", "median of the way, damped"},
                 {"coulomb_m", "m", "the same, Coulomb's friction"}}};
  medians.add(0, median_of(damped), median_of(coulomb));
  medians.add(1, median_of(clump_damped), median_of(clump_coulomb));
  quantities.push_back({"median travel, shot, damped", "m", median_of(damped)});
  quantities.push_back({"median travel, shot, Coulomb", "m", median_of(coulomb)});
  return {{table, medians}, quantities};
}

const Registered claim_5_3g_seen_figure{
    {.name = "claim_5_3g_seen",
     .parameters = {whole("seeds", 24, 2, 1000, "runs of each scene"),
                    whole("rows", 5, 2, 20, "of the pyramid"),
                    whole("per_edge", 3, 2, 6, "cubes along each edge of the clump's grid"),
                    number("duration", 5.0, 1.0, 60.0, "s", "of a run")},
     .quick = {"seeds=4", "duration=3", "rows=3", "per_edge=2"},
     .experiment = measure_what_is_seen}};

}  // namespace
}  // namespace tumble::chapters
