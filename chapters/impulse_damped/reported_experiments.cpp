/// \file
/// \brief Damping that gives the outcome that the thesis reports of figures 6.6 and 6.7 (6.1).
#include "tumble/impulse_damped/damped_numbers.hpp"
#include "tumble/record/metrics.hpp"

#include "impulse_damped/chatter_colours.hpp"
#include "impulse_damped/damped_variants.hpp"
#include "impulse_damped/settled_boxes.hpp"

namespace tumble::chapters {
namespace {

constexpr int kFirstSeed = 201;  // the search for the constants has seen seeds 1 to 20

// What is seen of a run in its last second. Edges are 1 m, masses 1 kg.
struct Ending {
  double chatter = 0.0;                // [mm] of the worst body that rests
  double kinetic = 0.0;                // [J] of all at the end
  double overlap = 0.0;                // [mm] the deepest
  double gain = 0.0;                   // [J] the most that a step adds to the total energy
  bool hangs = false;                  // a body that gets nowhere has nothing below it
  std::vector<PictureBox> boxes = {};  // at the end, coloured by their chatter

  // The four sayings of claim 6.1c: a hundredth of an edge is seen.
  [[nodiscard]] std::array<bool, 4> sayings() const {
    return {overlap <= 10.0, !hangs, gain <= 0.01 * kGravity, chatter <= 10.0};
  }
};

// Whether a body that has moved by less than a hundredth of its edge since `before` has no contact with a
// normal within 60 degrees of up below it.
bool any_hangs(const World& world, const std::vector<BodyState>& before) {
  PairGatherer areas(NormalRule::separation, PointRule::area);
  ContactList contacts;
  areas.gather(world, world.states(), world.states(), nullptr, 0.01, contacts);
  std::vector<char> held(world.bodies().size(), 0);
  for (const Contact& contact : contacts) {
    if (contact.normal_w.y() > 0.5) held[idx(contact.second)] = 1;
    if (contact.normal_w.y() < -0.5) held[idx(contact.first)] = 1;
  }
  for (std::size_t k = 0; k < held.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable() || held[k]) continue;
    const double way = largest_displacement(corners_of(box_of(body, before[k])),
                                            corners_of(box_of(body, world.states()[k])));
    if (way < 0.01 * body.size.minCoeff()) return true;
  }
  return false;
}

Ending ending_of(const char* scene, const PlayedTechnique& technique, int seed, double duration) {
  const auto number = static_cast<std::uint64_t>(seed);
  PlayedScene played(make_scene(scene, {}, number), technique, number);
  MetricsMeter meter;
  ChatterMeter each;
  OverlapMeter touches;
  Ending out;
  std::vector<BodyState> before;
  double energy = std::numeric_limits<double>::infinity();
  played.advance(duration, [&](const StepReport& report) {
    const World& world = played.world();
    const double left = duration - world.time();
    if (left > 1.0) return;
    const Metrics now = meter.measure(world, report);
    out.overlap = std::max(out.overlap, 1e3 * now.deepest_overlap);
    if (left < 0.4) out.chatter = std::max(out.chatter, 1e3 * now.chatter.amplitude);
    out.kinetic = now.kinetic;
    out.gain = std::max(out.gain, now.kinetic + now.potential - energy);
    energy = now.kinetic + now.potential;
    if (before.empty() && left < 0.5) before.assign(world.states().begin(), world.states().end());
    touches.look(world.bodies(), world.states());
    each.add(world, touches.in_contact());
  });
  out.hangs = any_hangs(played.world(), before);
  out.boxes = coloured_by_chatter(played.world(), each).boxes;
  return out;
}

// The median and, if asked for, the largest value.
void report(std::vector<double> values, const std::string& name, const char* unit, bool largest,
            std::vector<Quantity>& numbers) {
  std::ranges::sort(values);
  numbers.push_back({name + ", median", unit, values[values.size() / 2]});
  if (largest) numbers.push_back({name + ", largest", unit, values.back()});
}

// The techniques: as the thesis has it, with our constants and with those that give its outcome, and with friction.
struct Arm {
  const char* words;
  PlayedTechnique technique;
};
const std::array<Arm, 3>& arms() {
  static const std::array<Arm, 3> list{{{"as_meant", {"damped"}},
                                        {"as_reported", {"damped", {"reading=as_reported"}}},
                                        {"contact_damped", coulomb_technique()}}};
  return list;
}

Drawing drawing_of(const Ending& end, const std::string& name) {
  const Camera camera = camera_for(end.boxes, Vec3(0.55, 0.5, 1.0), 360.0, 240.0, true);
  return {name, to_gnuplot(draw_boxes(end.boxes, camera))};
}

// By seed: runs of the two figures as_meant and as_reported, which are two pairs of the range.
using Known = std::array<std::array<std::vector<Ending>, 2>, 2>;

// The constants that the thesis leaves open, over their range: how many sayings hold with each pair.
void add_range(const Parameters& settings, const Known& known, Result& result) {
  const int seeds = settings.count("range_seeds");
  Table range{"range",
              {{"k_scale", "-", "power of all factors"},
               {"eps_scale", "-", "factor of all thresholds"},
               {"sayings", "-", "of four that hold, mean over both figures and seeds"},
               {"shot_mm", "mm", "chatter in the end, figure 6.6, mean over seeds"},
               {"clump_mm", "mm", "the same, figure 6.7"}}};
  double most = 0.0;
  for (const double eps : {0.5, 1.0, 2.0}) {
    for (const double k : {1.0, 2.0, 3.0, 4.0}) {
      const PlayedTechnique damped{"damped", {setting("k_scale", k), setting("eps_scale", eps)}};
      const bool ran = eps == 1.0 && k <= kReportedDamping;
      double hold = 0.0;
      std::array<double, 2> chatter{};
      for (int seed = kFirstSeed; seed < kFirstSeed + seeds; ++seed) {
        for (const std::size_t figure : {0U, 1U}) {
          const auto place = static_cast<std::size_t>(seed - kFirstSeed);
          const std::vector<Ending>& same = known[k < kReportedDamping ? 0 : 1][figure];
          const Ending end = ran && place < same.size()
                                 ? same[place]
                                 : ending_of(figure == 0 ? "fig6_6" : "fig6_7", damped, seed,
                                             settings.number("duration"));
          const std::array<bool, 4> holds = end.sayings();
          hold += 0.5 * static_cast<double>(std::ranges::count(holds, true)) / seeds;
          chatter[figure] += end.chatter / seeds;
        }
      }
      range.add(k, eps, hold, chatter);
      most = std::max(most, hold);
    }
  }
  result.add("most of the four sayings that hold with any pair of constants", "-", most);
  result.tables.push_back(range);
}

Result measure_reported(const Parameters& settings) {
  const int seeds = settings.count("seeds");
  Table table{"",
              {{"arm", "-", "1 as_meant, 2 as_reported, 3 contact_damped"},
               {"figure", "-", "6.6 or 6.7"},
               {"seed", "-", "of the scene and of chance"},
               {"chatter_mm", "mm", "of the worst body that rests, in the end"},
               {"kinetic_j", "J", "of all bodies in the end"},
               {"overlap_mm", "mm", "the deepest in the last second"},
               {"gain_j", "J", "the most that a step of the last second adds"},
               {"hangs", "-", "1: a body rests with nothing below it"}}};
  Table sayings{
      "sayings",
      {{"arm", "-", "as above"},
       {"overlap", "-", "share of the runs without overlap above a hundredth of an edge"},
       {"hanging", "-", "share without a box that rests with nothing below it"},
       {"energy", "-", "share without a step that adds a hundredth of m g L"},
       {"shaking", "-", "share without a box at rest that shakes by a hundredth of an edge"}}};
  Result result;
  std::vector<Quantity> means;
  Known known;
  for (std::size_t a = 0; a < arms().size(); ++a) {
    const Arm& arm = arms()[a];
    std::vector<double> hold(idx(seeds), 0.0);
    std::array<double, 4> shares{};
    for (const double figure : {6.6, 6.7}) {
      const bool shot = figure < 6.65;
      std::array<std::vector<double>, 2> seen;
      for (int k = 0; k < seeds; ++k) {
        const Ending end = ending_of(shot ? "fig6_6" : "fig6_7", arm.technique, kFirstSeed + k,
                                     settings.number("duration"));
        table.add(a + 1, figure, kFirstSeed + k, end.chatter, end.kinetic, end.overlap, end.gain,
                  end.hangs);
        seen[0].push_back(end.chatter);
        seen[1].push_back(end.kinetic);
        if (a < 2) known[a][shot ? 0 : 1].push_back(end);
        const std::array<bool, 4> holds = end.sayings();
        for (std::size_t n = 0; n < 4; ++n) {
          hold[idx(k)] += holds[n] ? 0.5 : 0.0;
          shares[n] += holds[n] ? 0.5 / seeds : 0.0;
        }
        if (k == 0 && a < 2)
          result.drawings.push_back(
              drawing_of(end, std::string(shot ? "shot_" : "clump_") + arm.words));
      }
      if (a == 2) continue;  // the control has nothing of this
      const std::string where = std::string("figure ") + (shot ? "6.6" : "6.7") + ", " + arm.words;
      report(seen[0], "chatter in the end, " + where, "mm", shot, result.quantities);
      if (shot)
        report(seen[1], "kinetic energy in the end, " + where, "J", true, result.quantities);
    }
    sayings.add(a + 1, shares);
    means.push_back(mean_over_seeds(
        a == 0
            ? "sayings of four that hold at the end of figures 6.6 and 6.7: no overlap above a "
              "hundredth of an edge, no box that rests with nothing below it, no step that adds "
              "energy worth a hundredth of m g L, no box at rest that shakes by a hundredth of an "
              "edge; mean over runs"
            : std::string("the same, ") + arm.words,
        "-", hold));
  }
  result.quantities.insert(result.quantities.end(), means.begin(), means.end());
  result.tables = {table, sayings, chatter_colour_bar()};
  if (settings.count("range_seeds") > 0) add_range(settings, known, result);
  return result;
}

const Registered as_reported_figure{
    {.name = "as_reported_6_1",
     .parameters = {whole("seeds", 20, 2, 100, "from 201 on"),
                    whole("range_seeds", 1, 0, 100,
                          "of each pair of constants; 0: no pair is tried"),
                    number("duration", 10.0, 2.0, 100.0, "s", "of each run")},
     .quick = {"seeds=2", "range_seeds=0", "duration=7"},
     .experiment = measure_reported}};

}  // namespace
}  // namespace tumble::chapters
