/// \file
/// \brief Clumps that settle without velocities, and a thrown box (thesis 2.7.1).
#include "tumble/previous_work/settling.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

constexpr int kStepsToRest = 600;
constexpr double kStill = 1e-4;  // [-] of an edge: moves less than this in a step
constexpr double kDeep = 1e-3;   // [-] of an edge: overlap of what does not count as rest

Scene small_clump(int seed) {
  return make_scene("clump", {"per_edge=2"}, static_cast<std::uint64_t>(seed));
}

// A clump on its way down.
struct Settled {
  bool rests = false;
  int steps = 0;                 // until then
  double energy = 0.0;           // [J] at the end
  double imbalance = 0.0;        // [-] what the contact forces on the ground miss of the weight
  std::vector<double> energies;  // [J] after each step
};

Settled settle(int seed) {
  PlayedScene run(small_clump(seed), PlayedTechnique{"settling"});
  Settled settled;
  while (!settled.rests && settled.steps < kStepsToRest) {
    const std::vector<BodyState> before(run.world().states().begin(), run.world().states().end());
    const StepReport report = run.step();
    ++settled.steps;
    settled.energies.push_back(energy_of(run.world()).total());
    // What has not met anything yet falls by its reach, so it does not count as still.
    settled.rests =
        farthest_moved(before, run.world().states()) <= kStill && report.deepest_overlap <= kDeep;
  }
  settled.energy = energy_of(run.world()).total();
  Vec3 push_w = Vec3::Zero();
  const BodyId ground = run.world().ids()[0];
  for (const ContactRecord& contact : run.technique().contacts())
    if (contact.first == ground) push_w += contact.push_w;
  double weight = 0.0;
  for (const BodyProperties& body : run.world().bodies())
    if (body.movable()) weight += body.mass * kGravity;
  settled.imbalance = (push_w - Vec3(0.0, weight, 0.0)).norm() / weight;
  return settled;
}

// The same clump under the default technique [J], after each step.
std::vector<double> fall(int seed, double duration) {
  PlayedScene run(small_clump(seed), PlayedTechnique{"contact_damped"});
  std::vector<double> energies;
  run.advance(duration,
              [&](const StepReport&) { energies.push_back(energy_of(run.world()).total()); });
  return energies;
}

// A box that is thrown up and forward, beside its parabola.
// Returns [-] how high it rises above its start, over what the parabola does
double thrown(Table& table) {
  const Vec3 start_w(0.0, 1.5, 0.0), velocity_w(3.0, 4.0, 0.0);  // [m], [m/s]
  Scene scene{.ground = SceneGround{}};
  scene.boxes.emplace_back();
  scene.boxes[0].position_w = start_w;
  scene.boxes[0].velocity_w = velocity_w;
  PlayedScene run(scene, PlayedTechnique{"settling"});
  double highest = start_w.y();
  for (int k = 0; k < 48; ++k) {
    const double t = kStep * k;
    const Vec3& at_w = run.world().states()[1].position_w;
    highest = std::max(highest, at_w.y());
    table.add(t, at_w.y(), start_w.y() + velocity_w.y() * t - 0.5 * kGravity * t * t);
    run.step();
  }
  return (highest - start_w.y()) / (velocity_w.y() * velocity_w.y() / (2.0 * kGravity));
}

Result measure_settling(const Parameters& settings) {
  const int seeds = settings.count("seeds");
  Table table{"",
              {{"step", "-", "from the start; seconds times 60"},
               {"settling", "J", "energy of the first clump without velocities"},
               {"default", "J", "the same clump under contact_damped"}}};
  int restless = 0;
  std::vector<double> steps;
  double imbalance = 0.0, lower = 0.0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const Settled settled = settle(seed);
    const std::vector<double> falls = fall(seed, settings.number("duration"));
    restless += settled.rests ? 0 : 1;
    steps.push_back(settled.steps);
    imbalance = std::max(imbalance, settled.imbalance);
    lower += settled.energy / falls.back() / seeds;
    if (seed > 1) continue;
    for (std::size_t k = 0; k < falls.size(); ++k)
      table.add(k + 1, settled.energies[std::min(k, settled.energies.size() - 1)], falls[k]);
  }
  Table arc{"thrown",
            {{"time_s", "s", "from the start"},
             {"settling", "m", "height of a thrown box without velocities"},
             {"parabola", "m", "of free flight"}}};
  const double height = thrown(arc);
  const double share = static_cast<double>(restless) / seeds;
  Result result{.tables = {table, arc}};
  result.add(
      "the larger of two shares: clumps that do not come to rest, and the height that a thrown box "
      "reaches over that of its parabola",
      "-", std::max(share, height));
  result.add("clumps that do not come to rest", "-", restless);
  result.add("steps to rest, the most", "-", *std::ranges::max_element(steps));
  result.add("what contact forces of clumps at rest miss of the weight, at most", "-", imbalance);
  result.add("energy at rest over that under contact_damped, mean", "-", lower);
  return result;
}

const Registered settling_figure{
    {.name = "claim_2_7_1a_settling",
     .parameters = {whole("seeds", 10, 1, 100, "clumps"),
                    number("duration", 4.0, 0.5, 100.0, "s", "of the clumps that fall")},
     .quick = {"seeds=2", "duration=1"},
     .experiment = measure_settling}};

}  // namespace
}  // namespace tumble::chapters
