/// \file
/// \brief Hits and false alarms of rules that detect chatter (claim 6.3.1c).
#include "tumble/contact/tolerances.hpp"

#include "filtering/motion_corpus.hpp"

namespace tumble::chapters {
namespace {

// What may not be classified as chatter, each of the same weight: sliding by itself, sliding within
// a clump that shakes, rolling and rocking.
constexpr std::array<Doing, 4> kMoving = {Doing::slides, Doing::creeps, Doing::rolls, Doing::rocks};
constexpr double kPathOverWay = 4.0;  // [-] of the rule that asks for nothing else
constexpr double kMostRows = 150.0;   // of the table of a curve

using Corpora = std::vector<MotionCorpus>;  // by seed
using Test = std::function<bool(const Moment&)>;
using Score = std::function<double(const Moment&)>;  // the higher, the more it chatters

// Share of the moments of a kind that pass a test; without one seed, or with all (-1).
double share(const Corpora& corpora, Doing doing, int left_out, const Test& test) {
  double passed = 0.0;
  double all = 0.0;
  for (std::size_t seed = 0; seed < corpora.size(); ++seed) {
    if (static_cast<int>(seed) == left_out) continue;
    for (const Moment& moment : corpora[seed].moments) {
      if (moment.doing != doing) continue;
      all += 1.0;
      passed += test(moment) ? 1.0 : 0.0;
    }
  }
  return all > 0.0 ? passed / all : 0.0;
}

double mean_share(const Corpora& corpora, int left_out, const Test& test) {
  double sum = 0.0;
  for (const Doing doing : kMoving) sum += share(corpora, doing, left_out, test);
  return sum / static_cast<double>(kMoving.size());
}

bool detected(const Moment& moment) { return moment.verdict == Motion::chatters; }
bool left_moving(const Moment& moment) { return moment.verdict == Motion::moves; }

// Hits and false alarms at every threshold between two scores, and the area under them.
struct Curve {
  Table table;
  double area = 0.0;
};

Curve curve_of(const Corpora& corpora, const std::string& suffix, const std::string& threshold_is,
               const Score& score) {
  std::array<double, kDoings + 1> count{};
  for (const MotionCorpus& corpus : corpora)
    for (const Moment& moment : corpus.moments)
      count[static_cast<std::size_t>(moment.doing)] += 1.0;
  struct Scored {
    double score, hit, alarm;
  };
  std::vector<Scored> all;
  for (const MotionCorpus& corpus : corpora)
    for (const Moment& moment : corpus.moments) {
      const double weight = 1.0 / count[static_cast<std::size_t>(moment.doing)];
      if (moment.doing == Doing::chatters) all.push_back({score(moment), weight, 0.0});
      if (std::ranges::find(kMoving, moment.doing) != kMoving.end())
        all.push_back({score(moment), 0.0, weight / static_cast<double>(kMoving.size())});
    }
  std::ranges::sort(all, [](const Scored& a, const Scored& b) { return a.score > b.score; });
  Curve curve{{suffix,
               {{"threshold", "-", threshold_is},
                {"alarms", "-", "share of motion classified as chatter, mean of four kinds"},
                {"hits", "-", "share of chatter that is detected"}}}};
  // A threshold that is infinite, of a body that does not drift at all, leaves its cell empty.
  const auto add = [&](double threshold, double alarms, double hits) {
    const double cell =
        std::isfinite(threshold) ? threshold : std::numeric_limits<double>::quiet_NaN();
    curve.table.add(cell, alarms, hits);
  };
  add(all.empty() ? 0.0 : all.front().score, 0.0, 0.0);
  double alarms = 0.0;
  double hits = 0.0;
  for (std::size_t k = 0; k < all.size();) {
    const double before_alarms = alarms;
    const double before_hits = hits;
    const double threshold = all[k].score;
    for (; k < all.size() && !(all[k].score < threshold); ++k) {
      hits += all[k].hit;
      alarms += all[k].alarm;
    }
    curve.area += (alarms - before_alarms) * 0.5 * (hits + before_hits);
    const std::vector<double>& last = curve.table.rows.back();
    const bool apart = std::abs(hits - last[2]) + std::abs(alarms - last[1]) >= 1.0 / kMostRows;
    if (apart || k == all.size() || threshold == 0.0) add(threshold, alarms, hits);
  }
  return curve;
}

struct Rule {
  std::string name;
  Test test;
};

Result measure_detector(const Parameters& settings) {
  const int seeds = settings.count("seeds");
  Corpora corpora;
  for (int k = 0; k < seeds; ++k)
    corpora.push_back(corpus_of(static_cast<std::uint64_t>(settings.count("first_seed") + k),
                                settings.count("per_edge"), settings.count("boxes")));

  Result result;
  std::vector<Quantity>& out = result.quantities;
  const auto add = [&](const std::string& name, const std::function<double(int left_out)>& value) {
    Quantity quantity = over_seeds(name, "-", seeds, value);
    quantity.low = std::max(quantity.low, 0.0);  // they are shares
    quantity.high = std::min(quantity.high, 1.0);
    out.push_back(quantity);
  };
  const auto hits = [&](int left_out) {
    return share(corpora, Doing::chatters, left_out, detected);
  };
  const auto kept = [&](int left_out) { return mean_share(corpora, left_out, left_moving); };
  add("the smaller of two shares of a corpus with labels: chatter that is classified as chatter, "
      "and slow "
      "sliding, rolling and rocking that is not",
      [&](int left_out) { return std::min(hits(left_out), kept(left_out)); });
  add("chatter that is classified as chatter", hits);
  add("mean share of sliding, creeping, rolling and rocking that is classified as motion", kept);
  add("falling and fast sliding that is classified as motion", [&](int left_out) {
    return 0.5 * (share(corpora, Doing::falls, left_out, left_moving) +
                  share(corpora, Doing::speeds, left_out, left_moving));
  });

  const Curve rule =
      curve_of(corpora, "", "swing over drift", [](const Moment& m) { return m.swing_ratio; });
  const Curve path =
      curve_of(corpora, "path", "path over way", [](const Moment& m) { return m.path_over_way; });
  const Curve speed = curve_of(corpora, "speed", "speed over sqrt(g L), times -1",
                               [](const Moment& m) { return -m.fastest; });
  out.push_back({"area under the curve of the rule", "-", rule.area});
  out.push_back({"area under the curve of path over way", "-", path.area});
  out.push_back({"area under the curve of speed", "-", speed.area});

  const std::array<Rule, 4> rules = {
      {{"rule", detected},
       {"path", [](const Moment& m) { return m.path_over_way > kPathOverWay; }},
       {"slow", [](const Moment& m) { return m.fastest <= tolerance::sleeping_speed; }},
       {"small", [](const Moment& m) { return m.small; }}}};
  add("chatter that the sleeping rule calls slow",
      [&](int left_out) { return share(corpora, Doing::chatters, left_out, rules[2].test); });
  add("slow sliding whose momenta the damping calls small",
      [&](int left_out) { return share(corpora, Doing::slides, left_out, rules[3].test); });
  double moving = 0.0;
  double freezes = 0.0;
  for (const MotionCorpus& corpus : corpora) {
    moving += corpus.moving;
    freezes += corpus.false_freezes;
  }
  out.push_back({"false freezes per second of a moving body", "1/s", freezes / moving});

  Table points{
      "points",
      {{"rule", "-", "1: ours, 2: path over way, 3: sleeping rule, 4: damping's thresholds"},
       {"alarms", "-", "share of motion classified as chatter, mean of four kinds"},
       {"hits", "-", "share of chatter that is detected"}}};
  Table kinds{"kinds",
              {{"kind", "-",
                "1: chatters, 2: slides, 3: rolls, 4: rocks, 5: creeps, 6: falls, "
                "7: slides fast"}}};
  for (std::size_t r = 0; r < rules.size(); ++r) {
    points.add(r + 1, mean_share(corpora, -1, rules[r].test),
               share(corpora, Doing::chatters, -1, rules[r].test));
    kinds.columns.push_back({rules[r].name, "-", "share classified as chatter, or as slow"});
  }
  for (std::size_t k = 0; k < kDoings; ++k) {
    std::array<double, rules.size()> shares{};
    for (std::size_t r = 0; r < rules.size(); ++r)
      shares[r] = share(corpora, static_cast<Doing>(k), -1, rules[r].test);
    kinds.add(k + 1, shares);
  }
  Table windows{"windows",
                {{"frames", "-", "W"},
                 {"hits", "-", "share of chatter that is detected"},
                 {"kept", "-", "share of motion classified as motion, mean of four kinds"}}};
  for (std::size_t w = 0; w < kWindows.size(); ++w) {
    const Test chatters = [w](const Moment& m) { return m.others[w] == Motion::chatters; };
    const Test moves = [w](const Moment& m) { return m.others[w] == Motion::moves; };
    windows.add(kWindows[w], share(corpora, Doing::chatters, -1, chatters),
                mean_share(corpora, -1, moves));
  }
  result.tables = {rule.table, path.table, speed.table, points, kinds, windows};
  return result;
}

const Registered claim_6_3_1c_detector_figure{
    {.name = "claim_6_3_1c_detector",
     .parameters =
         {whole("seeds", 20, 2, 1000, "clumps, and as many sets of single boxes"),
          whole("first_seed", 13, 1, 1000000,
                "the rule's numbers were chosen on 1 to 4, the labels mended after 5 to 12"),
          whole("per_edge", 5, 2, 8, "cubes along each edge of a clump's grid at the start"),
          whole("boxes", 4, 1, 1000, "of each kind, under each of two techniques")},
     .quick = {"seeds=2", "first_seed=5", "per_edge=3", "boxes=1"},
     .experiment = measure_detector}};

}  // namespace
}  // namespace tumble::chapters
