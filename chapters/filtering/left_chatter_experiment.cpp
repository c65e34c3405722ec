/// \file
/// \brief Claim 6.1b: the chatter that is left in the settled clump.
#include "driver/statistics.hpp"
#include "filtering/settled_run.hpp"
#include "filtering/technique_chatter_experiments.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

namespace tumble::chapters {
namespace {

constexpr double kRoundingMotion = 1e-9;  // [-] what moves less does not move, up to rounding

// The method of the thesis, and with half and twice the constants that it does not give.
struct Variant {
  std::string words;
  PlayedTechnique technique;
};
const std::array<Variant, 7>& variants() {
  static const std::array<Variant, 7> list = {
      Variant{"", {"damped", {}}},
      Variant{" with half the epsilons", {"damped", {"eps_scale=0.5"}}},
      Variant{" with twice the epsilons", {"damped", {"eps_scale=2"}}},
      Variant{" with half the damping", {"damped", {"k_scale=0.5"}}},
      Variant{" with twice the damping", {"damped", {"k_scale=2"}}},
      Variant{" with half the passes", {"damped", {"collision_passes=3", "contact_passes=5"}}},
      Variant{" with twice the passes", {"damped", {"collision_passes=10", "contact_passes=20"}}}};
  return list;
}

// One clump. Amplitudes are means over the half seconds that were watched, over the edge.
struct Left {
  std::vector<double> amplitudes;  // [-] of those that rest
  double bodies = 0.0;             // that can move

  [[nodiscard]] double chattering(double line = kChatters) const {
    return static_cast<double>(std::count_if(amplitudes.begin(), amplitudes.end(),
                                             [line](double a) { return a >= line; }));
  }
};

Left left_in(const Parameters& p, const PlayedTechnique& technique, int seed) {
  SettledRequest request;
  request.per_edge = p.count("per_edge");
  request.seed = static_cast<std::uint64_t>(seed);
  request.settling = p.number("settling");
  request.watched = p.number("watched");
  request.technique = technique;
  const SettledRun run = settle_clump(request);
  Left left;
  const double gravity = run.world.gravity_w.norm();
  for (const BodyProperties& body : run.world.bodies())
    if (body.movable()) left.bodies += 1.0;
  for (const std::size_t k : resting_bodies(run)) {
    const Shake shake = shake_of(settled_path(run, run.frames, k), gravity, run.interval);
    left.amplitudes.push_back(shake.amplitude / run.world.bodies()[k].size.minCoeff());
  }
  return left;
}

// The claim counts all bodies of the clump, those too that do not rest and so cannot chatter; the same
// among those that rest is told beside it. The interval is over seeds, since bodies of a
// clump shake together. The line is ours, so half and twice of it are told too.
Quantity share(std::string name, const std::vector<Left>& clumps, bool of_resting,
               double line = kChatters) {
  return over_seeds(std::move(name), "-", static_cast<int>(clumps.size()), [&](int left_out) {
    double chattering = 0.0;
    double all = 0.0;
    for (std::size_t k = 0; k < clumps.size(); ++k) {
      if (static_cast<int>(k) == left_out) continue;
      chattering += clumps[k].chattering(line);
      all += of_resting ? static_cast<double>(clumps[k].amplitudes.size()) : clumps[k].bodies;
    }
    return all > 0.0 ? chattering / all : 0.0;
  });
}

}  // namespace

Result measure_left_chatter(const Parameters& settings) {
  Table sorted{"",
               {{"share", "-", "of all bodies, those that move less; half of this one"},
                {"amplitude", "-",
                 "largest distance between two places of a corner, over the "
                 "edge; mean over half seconds"}}};
  Table still{"still",
              {{"bodies", "-", "in all clumps"},
               {"restless", "-", "of these do not rest"},
               {"still", "-", "rest and do not move at all, up to rounding"},
               {"quiet", "-", "rest and move by less than the claim's thousandth"},
               {"chattering", "-", "rest and move by that or more"}}};
  Table shares{"shares",
               {{"variant", "-",
                 "0: as it is; half, twice the epsilons; the same of the damping, of the passes"},
                {"share", "-", "of all bodies, those that chatter"},
                {"low", "-", "lower end of the interval of 95 %"},
                {"high", "-", "upper end"},
                {"restless", "-", "share of all bodies that do not rest"}}};
  Result result;
  for (std::size_t v = 0; v < variants().size(); ++v) {
    std::vector<Left> clumps;
    double resting = 0.0;
    double bodies = 0.0;
    const int seeds = settings.count(v == 0 ? "seeds" : "varied");
    for (int seed = 1; seed <= seeds; ++seed) {
      clumps.push_back(left_in(settings, variants()[v].technique, seed));
      resting += static_cast<double>(clumps.back().amplitudes.size());
      bodies += clumps.back().bodies;
    }
    const std::string words = v == 0 ? "share of the bodies of the settled clump that chatter by a "
                                       "thousandth of an edge or more"
                                     : "the same share" + variants()[v].words;
    const Quantity found = share(words, clumps, false);
    shares.rows.push_back(
        {static_cast<double>(v), found.value, found.low, found.high, 1.0 - resting / bodies});
    result.quantities.push_back(found);
    if (v > 0) continue;

    std::vector<double> moving;
    double chattering = 0.0;
    for (const Left& clump : clumps) {
      chattering += clump.chattering();
      for (const double amplitude : clump.amplitudes)
        if (amplitude >= kRoundingMotion) moving.push_back(amplitude);
    }
    std::sort(moving.begin(), moving.end());
    const double count = static_cast<double>(moving.size());
    for (std::size_t k = 0; k < moving.size(); ++k)
      sorted.rows.push_back({(resting - count + static_cast<double>(k) + 0.5) / bodies, moving[k]});
    still.rows.push_back(
        {bodies, bodies - resting, resting - count, count - chattering, chattering});
    result.quantities.push_back(share("the same share of those that rest", clumps, true));
    result.quantities.push_back(
        {"share of bodies that rest and do not move at all", "-", (resting - count) / bodies});
    result.quantities.push_back({"share of bodies that do not rest", "-", 1.0 - resting / bodies});
    result.quantities.push_back(
        {"largest amplitude of a body that rests", "-", moving.empty() ? 0.0 : moving.back()});
    result.quantities.push_back(
        share("the same share, chatter from half a thousandth on", clumps, false, 0.5 * kChatters));
    result.quantities.push_back(
        share("the same share, chatter from two thousandths on", clumps, false, 2.0 * kChatters));
  }
  result.tables = {sorted, shares, still};
  return result;
}

}  // namespace tumble::chapters
