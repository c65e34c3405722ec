/// \file
/// \brief The order of two impacts that are nearer in time than the tolerance of the search (thesis
///        5.1).
#include "timewarp/tie_experiments.hpp"

#include "tumble/timewarp/timewarp_simple.hpp"
#include "tumble/timewarp/timewarp_swept.hpp"

#include "driver/common_numbers.hpp"
#include "driver/statistics.hpp"
#include "timewarp/event_story.hpp"
#include "timewarp/tie_scenes.hpp"

#include <array>
#include <string>

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

// Who is asked, of cubes that do not turn and of those that do.
enum Asked { kBySimple, kBySwept, kByBoth, kAsked };
using Answers = std::array<std::array<Tally, 2>, kAsked>;

struct Techniques {
  explicit Techniques(double resolution)
      : simple(options(resolution)),
        swept(swept_options(resolution, TieRule::one_by_one)),
        together(swept_options(resolution, TieRule::together)) {}
  TimewarpSimple simple;
  TimewarpSwept swept;
  TimewarpSwept together;

 private:
  static TimewarpOptions options(double resolution) {
    TimewarpOptions out;
    out.resolution = resolution;
    return out;
  }
  static TimewarpSweptOptions swept_options(double resolution, TieRule ties) {
    TimewarpSweptOptions out;
    out.resolution = resolution;
    out.ties = ties;
    return out;
  }
};

TwoImpacts impacts_in(int bin, int trial, bool turning, double tolerance) {
  Random chance = Random(turning ? 2 : 1)
                      .fork(static_cast<std::uint64_t>(bin))
                      .fork(static_cast<std::uint64_t>(trial));
  const double share = (bin + chance.unit()) / kWithin;
  return two_impacts({.frame = kStep, .delay = share * tolerance, .turning = turning},
                     chance.fork(0));
}

Answers ask(int bin, const Parameters& settings, Techniques& techniques) {
  Answers answers;
  const double tolerance = settings.number("resolution");
  for (const bool turning : {false, true}) {
    for (int k = 0; k < settings.count("trials"); ++k) {
      const TwoImpacts impacts = impacts_in(bin, k, turning, tolerance);
      const std::size_t which = turning ? 1 : 0;
      answers[kBySimple][which].add(impacts, techniques.simple);
      answers[kBySwept][which].add(impacts, techniques.swept);
      answers[kByBoth][which].add_together(impacts, techniques.together);
    }
  }
  return answers;
}

Tally both(const std::array<Tally, 2>& answers) {
  Tally all = answers[0];
  all.add(answers[1]);
  return all;
}

// The tolerance is ours: swept volumes alone with another one, and pairs as near to it as before.
Tally wrong_with(double tolerance, int trials) {
  Techniques techniques(tolerance);
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

// What is to be expected of bisection. It cuts a frame into cells, the same for all pairs, and
// takes the time at which the cell begins. Two impacts in one cell have one time, and their order
// is that of the indices: wrong for every other pair. So the share falls from a half to nothing at
// one cell.
Table expected_of_bisection(double resolution) {
  double cell = kStep;
  while (cell > resolution) cell *= 0.5;
  const double last = static_cast<double>(kBins) / kWithin;
  return {"bisection",
          {{"between", "-", "time between the impacts over the tolerance"},
           {"expected", "-", "share in the wrong order by bisection, closed form"}},
          {{0.0, 0.5}, {cell / resolution, 0.0}, {last, 0.0}}};
}

}  // namespace

Result measure_ties(const Parameters& settings) {
  const double tolerance = settings.number("resolution");
  Techniques techniques(tolerance);
  Table table{"",
              {{"between", "-", "time between the impacts over the tolerance, middle of the bin"},
               {"together", "-", "share resolved at one stroke, ties together"}}};
  for (const std::string who : {"simple", "straight", "turning", "ties"}) {
    table.columns.push_back({who, "-", "share in the wrong order: " + who});
    table.columns.push_back({who + "_low", "-", "95 % interval of it"});
    table.columns.push_back({who + "_high", "-", "95 % interval of it"});
  }
  Answers within;
  Tally beyond;
  for (int bin = 0; bin < kBins; ++bin) {
    const Answers answers = ask(bin, settings, techniques);
    const double between = (bin + 0.5) / kWithin;
    const Tally together = both(answers[kByBoth]);
    table.rows.push_back({between, share_of_trials("", together.together, together.trials).value});
    for (const Tally& tally :
         {both(answers[kBySimple]), answers[kBySwept][0], answers[kBySwept][1], together}) {
      const Quantity share = wrong_of("", tally);
      for (const double value : {share.value, share.low, share.high})
        table.rows.back().push_back(value);
    }
    if (bin >= kWithin) beyond.add(both(answers[kBySwept]));
    for (std::size_t asked = 0; asked < kAsked && bin < kWithin; ++asked)
      for (std::size_t k = 0; k < 2; ++k) within[asked][k].add(answers[asked][k]);
  }

  const Tally stroke = both(within[kByBoth]);
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

}  // namespace tumble::chapters
