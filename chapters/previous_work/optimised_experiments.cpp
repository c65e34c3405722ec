/// \file
/// \brief The largest steps of animation by optimisation, what its programs cost, and where bodies touch (thesis 2.7.2).
#include "tumble/previous_work/optimised.hpp"
#include "tumble/previous_work/tolerances.hpp"
#include "tumble/record/overlap.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

// [s] From the largest down: the first one that passes is the largest.
constexpr std::array<double, 6> kSteps{0.5, 0.25, 0.125, 1.0 / 15, 1.0 / 30, 1.0 / 60};
constexpr double kSmallest = kSteps.back();
constexpr double kVeryLarge = 1.0 / 15;  // [s] four frames of a display
constexpr double kOverlap = 0.01;        // [-] of the shortest edge, at most in the end
constexpr double kTouch = 1e-3;          // [-] of an edge: points up to this far apart touch
constexpr double kRounding = 1e-9;       // [-] of the energy

// A figure of the thesis at one step.
struct Ran {
  std::vector<std::array<double, 2>> course = {};  // [s], [-] time, overlap of an edge
  double overlap = 0.0;                            // [-] of an edge, in the end
  double deepest = 0.0;                            // [-] of an edge, after any step
  double unbooked =
      0.0;  // [-] energy above that of the start and of what the shot brought, in the end
  bool passes = false;
  OptimisedWork work;
  std::int64_t products = 0;  // multiplications of a complementarity problem a step
};

// Multiplications that find the impulses of the contacts where the poses ended, from none.
std::int64_t complementarity(const World& world, double dt) {
  std::vector<MovingBody> bodies;
  load_moving_bodies(world, bodies);
  StepReport report;
  NearPoints touching;
  touching.find(world, bodies, kTouch, report);
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (world.bodies()[k].movable()) bodies[k].velocity_w += dt * world.gravity_w;
  std::vector<double> least;
  for (const double gap : touching.gaps()) least.push_back(-std::max(0.0, gap) / dt);
  RubbingPoints rows;
  rows.take(bodies, touching.contacts(), least);
  ProjectedDescent<RubbingPoints> descent;
  const DescentReport found =
      descent.solve(rows, rows.impulses(), tolerance::optimised_step * rows.first_step(),
                    OptimisedOptions{}.budget);
  return static_cast<std::int64_t>(found.products) *
         static_cast<std::int64_t>(rows.size() * rows.size());
}

Ran run_at(const Scene& scene, double dt, double duration, bool compare) {
  auto owned = std::make_unique<Optimised>();
  Optimised& technique = *owned;
  PlayedScene played(scene, std::move(owned));
  Ran ran;
  double allowed = energy_of(played.world()).total();  // [J]
  OverlapMeter overlaps;
  while (played.world().time() < duration - 0.5 * dt) {
    const double before = energy_of(played.world()).total();
    played.update_boxes();  // the shot
    allowed += energy_of(played.world()).total() - before;
    const World start = played.world();
    finished(played.Simulation::step(dt));
    if (compare) {
      // Poses of the end, momenta of the start: what the program for the momenta begins with.
      World ended = played.world();
      for (std::size_t k = 0; k < ended.states().size(); ++k) {
        ended.states()[k].linear_momentum_w = start.states()[k].linear_momentum_w;
        ended.states()[k].angular_momentum_w = start.states()[k].angular_momentum_w;
      }
      ran.products += complementarity(ended, dt);
    }
    ran.overlap = overlaps.look(played.world().bodies(), played.world().states());
    ran.deepest = std::max(ran.deepest, ran.overlap);
    ran.course.push_back({played.world().time(), ran.overlap});
  }
  ran.unbooked = energy_of(played.world()).total() / allowed - 1.0;
  ran.passes = ran.overlap <= kOverlap && ran.unbooked <= kRounding;
  ran.work = technique.work();
  return ran;
}

// Points at which a body of a heap touches others, mean over the steps.
double points_of_heap(int seed, const char* technique, int per_edge, double duration) {
  PlayedScene played(make_scene("clump", {"per_edge=" + std::to_string(per_edge)},
                                static_cast<std::uint64_t>(seed)),
                     {technique});
  double points = 0.0, steps = 0.0;
  std::vector<MovingBody> bodies;
  played.advance(duration, [&](const StepReport&) {
    load_moving_bodies(played.world(), bodies);
    StepReport report;
    NearPoints touching;
    touching.find(played.world(), bodies, kTouch, report);
    for (const Contact& contact : std::as_const(touching).contacts())
      points += contact.count * (contact.first == 0 ? 1.0 : 2.0);  // the ground is no body of it
    steps += 1.0;
  });
  return points / steps / (per_edge * per_edge * per_edge);
}

Result measure_steps(const Parameters& settings) {
  const double duration = settings.number("duration");
  const std::array<Scene, 2> scenes{
      make_scene("fig6_6", {"appears=0.5", "rows=" + std::to_string(settings.count("rows"))}),
      make_scene("fig6_7", {"per_edge=" + std::to_string(settings.count("per_edge"))})};
  Table table{"",
              {{"figure", "-", "1: figure 6.6, 2: figure 6.7"},
               {"dt_s", "s", "step"},
               {"time_s", "s", "from the start"},
               {"overlap", "-", "of the worst pair after this step, over an edge"}}};
  double largest = 0.0, deepest = 0.0, ratio = 0.0;
  const auto ran = [&](std::size_t k, double dt) {
    Ran run = run_at(scenes[k], dt, duration, k == 1 && dt == kSmallest);
    for (const auto& [time, overlap] : run.course) table.add(k + 1, dt, time, overlap);
    if (dt == kSmallest)
      ratio = static_cast<double>(run.work.poses + run.work.momenta) /
              static_cast<double>(run.products);
    return run;
  };
  for (const double dt : kSteps) {
    const Ran shot = ran(0, dt), clump = ran(1, dt);
    if (!shot.passes || !clump.passes) continue;
    largest = dt;
    deepest = std::max(shot.deepest, clump.deepest);
    break;
  }
  if (ratio == 0.0) ran(1, kSmallest);
  Result result{.tables = {table}};
  result.add(
      "the smaller of two ratios: the largest such step over 1/15 s, and multiplications of the "
      "quadratic programs over those of the complementarity problem",
      "-", std::min(largest / kVeryLarge, ratio));
  result.add("largest step at which both figures end without overlap", "s", largest);
  result.add("multiplications of the quadratic programs over those of the complementarity problem",
             "-", ratio);
  result.add("deepest overlap after any step at this one, over an edge", "-", deepest);
  return result;
}

Result measure_touches(const Parameters& settings) {
  const int seeds = settings.count("seeds"), per_edge = settings.count("per_edge");
  Table table{"",
              {{"seed", "-", "of the heap"},
               {"optimised", "-", "points at which a body touches others"},
               {"time_stepping", "-", "the same under time stepping"}}};
  double optimised = 0.0, stepping = 0.0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const double here = points_of_heap(seed, "optimised", per_edge, settings.number("duration"));
    const double there =
        points_of_heap(seed, "time_stepping", per_edge, settings.number("duration"));
    table.add(seed, here, there);
    optimised += here / seeds;
    stepping += there / seeds;
  }
  Result result{.tables = {table}};
  result.add(
      "points at which a body of a heap of 27 cubes touches others after a step of optimisation "
      "based animation, over the same under time stepping",
      "-", optimised / stepping);
  result.add("points at which a body of a heap touches others, optimised", "-", optimised);
  result.add("points at which a body of a heap touches others, time_stepping", "-", stepping);
  return result;
}

const Registered optimised_figure{
    {.name = "claim_2_7_2a_optimised",
     .parameters = {number("duration", 4.0, 0.5, 100.0, "s", "of each run"),
                    whole("rows", 10, 1, 100, "rows of the pyramid of figure 6.6"),
                    whole("per_edge", 5, 1, 20,
                          "cubes along each edge of the clump of figure 6.7")},
     .quick = {"duration=1.5", "rows=4", "per_edge=2"},
     .experiment = measure_steps}};

const Registered touches_figure{
    {.name = "claim_2_7_2b_touches",
     .parameters = {whole("seeds", 5, 1, 1000, "heaps"),
                    whole("per_edge", 3, 1, 20, "cubes along each edge of a heap's grid"),
                    number("duration", 3.0, 0.1, 100.0, "s", "of each heap")},
     .quick = {"seeds=1", "per_edge=2", "duration=1.5"},
     .experiment = measure_touches}};

}  // namespace
}  // namespace tumble::chapters
