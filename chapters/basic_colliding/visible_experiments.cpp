/// \file
/// \brief Experiment on visible collisions that a test at the end of each step misses (thesis 3.2).
#include "tumble/basic_colliding/basic.hpp"
#include "tumble/dynamics/pair_search.hpp"

#include "basic_colliding/near_pairs.hpp"

namespace tumble::chapters {
namespace {

constexpr double kVisible = 0.01;  // [-] overlap over size

// A collision of one pair, within one step.
struct Collision {
  double depth =
      0.0;  // [-] deepest overlap that the two reach until the end of the step, over size
  bool missed = false;  // they are apart again at the end
};

// Pyramid or clump, and a projectile whose height, aim and orientation are the seed's.
World shot_at(const std::string& target, const Parameters& settings, int seed) {
  const SceneRecipe& recipe = scene_recipe("projectile");
  Parameters p = recipe.parameters();
  p.set("target", target);
  p.set("rows", std::to_string(settings.count("rows")));
  p.set("per_edge", std::to_string(settings.count("per_edge")));
  p.set("restitution", "0.9");  // the thesis's (3.3.2)
  p.set("appears", "0");
  p.set("distance", "2");
  const Random random(static_cast<std::uint64_t>(seed));
  Scene scene = recipe.build(p, random.fork(1));
  SceneBox& shot = scene.boxes.back();
  Random chance = random.fork(2);
  shot.position_w += chance.in_cube(1.0);
  shot.orientation_wb = chance.orientation();
  return build_world(scene);
}

// Watches the steps of a run before they are taken.
class Watch {
 public:
  // The first collision of each pair in the coming step, all bodies flying freely from its start on:
  // exactly what the end-of-step test is asked to see. Pairs that overlap already are left out.
  void look_ahead(const World& world, std::vector<Collision>& collisions) {
    const Flight flight{.bodies = world.bodies(),
                        .states = world.states(),
                        .gravity_w = world.gravity_w,
                        .rule = RotationRule::frozen};
    SearchOptions careful{.method = SearchMethod::conservative, .cap = 1000000};
    for (const IndexPair& pair : near_.find(world, kStep)) {
      const PairCollision found = find_collision(flight, pair, 0.0, kStep, careful);
      if (found.status == CollisionStatus::cap_reached)
        throw std::runtime_error("search not finished");
      if (found.status != CollisionStatus::found) continue;
      const double at_end = -gap_at(flight, pair, kStep).distance;
      collisions.push_back(
          {std::max(at_end, depth_after(flight, pair, found.overlap_time)), at_end <= 0.0});
    }
  }

 private:
  // [-] Deepest overlap from a time to the end of the step, at 64 times. All cubes have 1 m.
  static double depth_after(const Flight& flight, const IndexPair& pair, double time) {
    constexpr int samples = 64;
    double depth = 0.0;
    for (int k = 0; k < samples; ++k) {
      const double later = time + (kStep - time) * k / samples;
      depth = std::max(depth, -gap_at(flight, pair, later).distance);
    }
    return depth;
  }

  NearPairs near_;
};

// What came of one run.
struct Run {
  std::vector<Collision> collisions;
  double steps = 0.0;
  double capped = 0.0;  // of them met the cap: the rest of the step ignored collisions
};

Run run(const std::string& target, const Parameters& settings, int seed) {
  BasicOptions options{.event_cap = settings.count("event_cap")};
  options.rotation = RotationRule::frozen;  // exact for cubes
  Basic basic(options);
  World world = shot_at(target, settings, seed);
  Watch watch;
  Run out;
  while (world.time() < settings.number("duration") - 0.5 * kStep) {
    watch.look_ahead(world, out.collisions);
    out.steps += 1.0;
    if (ended_at_cap(basic.step(world, kStep))) out.capped += 1.0;
  }
  return out;
}

// How many collisions of each run are deeper than this, and how many of those are missed.
struct Counts {
  std::vector<double> all;  // by seed
  std::vector<double> missed;
};

Counts count(const std::vector<Run>& runs, double deeper_than) {
  Counts counts;
  for (const Run& run : runs) {
    double all = 0.0;
    double missed = 0.0;
    for (const Collision& collision : run.collisions) {
      if (collision.depth <= deeper_than) continue;
      all += 1.0;
      missed += collision.missed ? 1.0 : 0.0;
    }
    counts.all.push_back(all);
    counts.missed.push_back(missed);
  }
  return counts;
}

Quantity share_missed(const std::string& name, const Counts& counts) {
  return ratio_of_sums(name, "-", counts.missed, counts.all);
}

Result measure_missed_visible(const Parameters& settings) {
  const int seeds = settings.count("seeds");
  std::vector<Run> pyramids;
  std::vector<Run> clumps;
  std::vector<Run> both(static_cast<std::size_t>(seeds));
  std::vector<double> steps, capped;  // of each run
  for (int seed = 1; seed <= seeds; ++seed) {
    pyramids.push_back(run("pyramid", settings, seed));
    clumps.push_back(run("clump", settings, seed));
    std::vector<Collision>& all = both[static_cast<std::size_t>(seed - 1)].collisions;
    for (const Run* part : {&pyramids.back(), &clumps.back()}) {
      all.insert(all.end(), part->collisions.begin(), part->collisions.end());
      steps.push_back(part->steps);
      capped.push_back(part->capped);
    }
  }

  Table table{"",
              {{"depth", "-", "collisions deeper than this, over the size of a cube"},
               {"pyramid", "-", "share of them that the end-of-step test misses, pyramid"},
               {"pyramid_low", "-", "lower end of its interval of 95 % over the seeds"},
               {"pyramid_high", "-", "upper end of it"},
               {"clump", "-", "the same, clump"},
               {"clump_low", "-", "lower end"},
               {"clump_high", "-", "upper end"},
               {"collisions", "-", "in both, deeper than that"},
               {"missed", "-", "of them"}}};
  for (const double depth : {1e-3, 1.8e-3, 3.2e-3, 5.6e-3, 1e-2, 1.8e-2, 3.2e-2, 5.6e-2, 0.1}) {
    const Quantity pyramid = share_missed("", count(pyramids, depth));
    const Quantity clump = share_missed("", count(clumps, depth));
    const Counts sum = count(both, depth);
    table.add(depth, pyramid.value, pyramid.low, pyramid.high, clump.value, clump.low, clump.high,
              sum_without(sum.all, -1), sum_without(sum.missed, -1));
  }

  const double deepest_missed = largest_of(both, [](const Run& run) {
    return largest_of(run.collisions, [](const Collision& c) { return c.missed ? c.depth : 0.0; });
  });
  const Counts visible = count(both, kVisible);
  return {
      {table},
      {share_missed("missed visible collisions over all visible collisions", visible),
       share_missed("the same, visible from half the overlap on", count(both, 0.5 * kVisible)),
       share_missed("the same, visible from twice the overlap on", count(both, 2.0 * kVisible)),
       ratio_of_sums("steps that met their cap of collisions, over all steps", "-", capped, steps),
       {"visible collisions missed", "-", sum_without(visible.missed, -1)},
       {"deepest overlap of a missed collision, over size", "-", deepest_missed}}};
}

const Registered claim_3_2b_visible_figure{
    {.name = "claim_3_2b_visible",
     .parameters = {whole("seeds", 20, 1, 1000, "runs of each scene"),
                    whole("rows", 7, 1, 20, "rows of the pyramid"),
                    whole("per_edge", 4, 1, 6, "cubes along each edge of the clump"),
                    number("duration", 1.0, 0.1, 10.0, "s", "length of a run"),
                    whole("event_cap", 50, 1, 100000, "moments of impact in a step")},
     .quick = {"seeds=4"},
     .experiment = measure_missed_visible}};

}  // namespace
}  // namespace tumble::chapters
