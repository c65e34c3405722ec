/// \file
/// \brief The order of two impacts that are nearer in time than the tolerance of the search (thesis
///        5.1).
#include "tumble/timewarp/timewarp_simple.hpp"
#include "tumble/timewarp/timewarp_swept.hpp"

#include "timewarp/event_story.hpp"
#include "timewarp/tie_scenes.hpp"

namespace tumble::chapters {
namespace {

constexpr int kWithin = 10;  // bins of the time between, up to the tolerance
constexpr int kBins = 15;    // all of them

// Sees how many bodies the first moment of a frame takes out of their flight.
class FirstMoment final : public TimewarpWatcher {
 public:
  void on_queue(const TimewarpLook& look) override {
    if (look.current == nullptr || bodies > 0) return;
    for (const double time : look.valid_times)
      if (time > 0.0) ++bodies;
  }
  int bodies = 0;
};

// Pairs of impacts, and how they came out.
struct Tally {
  std::int64_t trials = 0;
  std::int64_t wrong = 0;     // the later one first
  std::int64_t together = 0;  // at one stroke

  void add(const Tally& other) {
    trials += other.trials;
    wrong += other.wrong;
    together += other.together;
  }
  void add(const TwoImpacts& impacts, Technique& technique) {
    const std::vector<Collision> story = story_of(technique, impacts.world, kStep);
    ++trials;
    if (!story.empty() && (story.front().first == 0) != impacts.left_first) ++wrong;
  }
  void add_together(const TwoImpacts& impacts, TimewarpSwept& technique) {
    FirstMoment moment;
    technique.watch(&moment);
    Tally order;
    order.add(impacts, technique);
    technique.watch(nullptr);
    ++trials;
    if (moment.bodies == impacts.world.count())
      ++together;
    else
      wrong += order.wrong;
  }
};

struct TieTechniques {
  explicit TieTechniques(double resolution)
      : simple({.resolution = resolution}),
        swept({{.resolution = resolution}, TieRule::one_by_one}),
        together({{.resolution = resolution}, TieRule::together}) {}
  TimewarpSimple simple;
  TimewarpSwept swept;
  TimewarpSwept together;
};

// By technique, each of cubes that do not turn and of those that do.
enum TieTechnique : std::size_t { kBySimple, kBySwept, kTogether, kTieTechniques };
using TieTallies = std::array<std::array<Tally, 2>, kTieTechniques>;

TwoImpacts impacts_in(int bin, int trial, bool turning, double tolerance) {
  Random chance = Random(turning ? 2 : 1)
                      .fork(static_cast<std::uint64_t>(bin))
                      .fork(static_cast<std::uint64_t>(trial));
  const double share = (bin + chance.unit()) / kWithin;
  return two_impacts({.frame = kStep, .delay = share * tolerance, .turning = turning},
                     chance.fork(0));
}

TieTallies tallies_of(int bin, const Parameters& settings, TieTechniques& techniques) {
  TieTallies tallies;
  for (const std::size_t turning : {0U, 1U}) {
    for (int k = 0; k < settings.count("trials"); ++k) {
      const TwoImpacts impacts = impacts_in(bin, k, turning == 1, settings.number("resolution"));
      tallies[kBySimple][turning].add(impacts, techniques.simple);
      tallies[kBySwept][turning].add(impacts, techniques.swept);
      tallies[kTogether][turning].add_together(impacts, techniques.together);
    }
  }
  return tallies;
}

Tally both(const std::array<Tally, 2>& tallies) {
  Tally all = tallies[0];
  all.add(tallies[1]);
  return all;
}

// The tolerance is ours: swept volumes alone with another one, and pairs as near to it as before.
Tally wrong_with(double tolerance, int trials) {
  TieTechniques techniques(tolerance);
  Tally tally;
  for (int bin = 0; bin < kWithin; ++bin)
    for (const bool turning : {false, true})
      for (int k = 0; k < trials; ++k)
        tally.add(impacts_in(bin, k, turning, tolerance), techniques.swept);
  return tally;
}

Quantity wrong_of(const std::string& name, const Tally& tally) {
  return share_of_trials(name, tally.wrong, tally.trials);
}

// Expected of bisection. It cuts a frame into cells, the same for all pairs, and takes the time at
// which the cell begins. Two impacts in one cell have one time, and their order is that of the indices:
// wrong for every other pair. So the share falls from a half to nothing at one cell.
Table expected_of_bisection(double resolution) {
  double cell = kStep;
  while (cell > resolution) cell *= 0.5;
  const double last = static_cast<double>(kBins) / kWithin;
  return {"bisection",
          {{"between", "-", "time between the impacts over the tolerance"},
           {"expected", "-", "share in the wrong order by bisection, closed form"}},
          {{0.0, 0.5}, {cell / resolution, 0.0}, {last, 0.0}}};
}

// The time between two impacts is even from 0 to one and a half times the tolerance; half of the cubes
// turn.
Result measure_ties(const Parameters& settings) {
  const double tolerance = settings.number("resolution");
  TieTechniques techniques(tolerance);
  Table table{"",
              {{"between", "-", "time between the impacts over the tolerance, middle of the bin"},
               {"together", "-", "share resolved at one stroke, ties together"},
               {"ties", "-", "share in the wrong order, ties together"}}};
  for (const std::string what : {"simple", "straight", "turning"})
    add_interval_columns(what, "-", "share in the wrong order: " + what, table);
  TieTallies within;
  Tally beyond;
  for (int bin = 0; bin < kBins; ++bin) {
    const TieTallies tallies = tallies_of(bin, settings, techniques);
    const Tally together = both(tallies[kTogether]);
    table.add((bin + 0.5) / kWithin, share_of_trials("", together.together, together.trials).value,
              wrong_of("", together).value, with_interval(wrong_of("", both(tallies[kBySimple]))),
              with_interval(wrong_of("", tallies[kBySwept][0])),
              with_interval(wrong_of("", tallies[kBySwept][1])));
    if (bin >= kWithin) beyond.add(both(tallies[kBySwept]));
    for (std::size_t by = 0; by < kTieTechniques && bin < kWithin; ++by)
      for (const std::size_t turning : {0U, 1U}) within[by][turning].add(tallies[by][turning]);
  }

  const Tally stroke = both(within[kTogether]);
  return {
      {table, expected_of_bisection(tolerance)},
      {wrong_of("share of the pairs of impacts nearer in time than the tolerance that swept "
                "volumes bring in the wrong order",
                both(within[kBySwept])),
       wrong_of("the same, a tenth of the tolerance",
                wrong_with(0.1 * tolerance, settings.count("varied"))),
       wrong_of("the same, ten times the tolerance",
                wrong_with(10.0 * tolerance, settings.count("varied"))),
       wrong_of("the same, cubes that do not turn", within[kBySwept][0]),
       wrong_of("the same, cubes that turn", within[kBySwept][1]),
       wrong_of("the same, simple", both(within[kBySimple])),
       wrong_of("the same, ties together", stroke),
       share_of_trials("share of them resolved at one stroke, ties together", stroke.together,
                       stroke.trials),
       wrong_of("share of the pairs farther apart than the tolerance in the wrong order", beyond)}};
}

const Registered claim_5_1c_ties_figure{
    {.name = "claim_5_1c_ties",
     .parameters = {whole("trials", 400, 1, 100000,
                          "pairs of impacts in each bin, turning and not"),
                    whole("varied", 400, 1, 100000, "the same with other tolerances"),
                    number("resolution", 1e-6, 1e-9, 1e-3, "s",
                           "tolerance of the search for collisions")},
     .quick = {"trials=40", "varied=40"},
     .experiment = measure_ties}};

}  // namespace
}  // namespace tumble::chapters
