/// \file
/// \brief Claim 6.1b: the chatter that is left in the settled clump.
#include "filtering/settled_run.hpp"

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
    return static_cast<double>(
        std::ranges::count_if(amplitudes, [line](double a) { return a >= line; }));
  }
};

Left left_in(const Parameters& p, const PlayedTechnique& technique, int seed) {
  const SettledRun run = settle_clump(p, seed, technique);
  Left left;
  for (const BodyProperties& body : run.world.bodies())
    if (body.movable()) left.bodies += 1.0;
  for (const std::size_t k : resting_bodies(run))
    left.amplitudes.push_back(settled_shake(run, k).amplitude /
                              run.world.bodies()[k].size.minCoeff());
  return left;
}

// The claim counts all bodies of the clump, those too that do not rest and so cannot chatter; the same
// among those that rest stands beside it. The interval is over seeds, since bodies of a clump shake
// together. The line is ours, so half and twice of it are tried too.
Quantity share_of_bodies(std::string name, const std::vector<Left>& clumps, bool of_resting,
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
    const Quantity found = share_of_bodies(words, clumps, false);
    shares.add(v, found.value, found.low, found.high, 1.0 - resting / bodies);
    result.add(found);
    if (v > 0) continue;

    std::vector<double> moving;
    double chattering = 0.0;
    for (const Left& clump : clumps) {
      chattering += clump.chattering();
      for (const double amplitude : clump.amplitudes)
        if (amplitude >= kRoundingMotion) moving.push_back(amplitude);
    }
    std::ranges::sort(moving);
    const double count = static_cast<double>(moving.size());
    for (std::size_t k = 0; k < moving.size(); ++k)
      sorted.add((resting - count + static_cast<double>(k) + 0.5) / bodies, moving[k]);
    still.add(bodies, bodies - resting, resting - count, chattering);
    result.add(share_of_bodies("the same share of those that rest", clumps, true));
    result.add(share_of_bodies("the same share, chatter from half a thousandth on", clumps, false,
                               0.5 * kChatters));
    result.add(share_of_bodies("the same share, chatter from two thousandths on", clumps, false,
                               2.0 * kChatters));
  }
  std::vector<Left> reported;
  const int seeds = settings.count("seeds");
  for (int seed = seeds + 1; seed <= 2 * seeds; ++seed)
    reported.push_back(left_in(settings, {"damped", {"reading=as_reported"}}, seed));
  result.add(share_of_bodies(
      "share of the bodies of the settled clump that chatter by a thousandth of an edge or more, "
      "as_reported",
      reported, false));
  result.tables = {sorted, shares, still};
  return result;
}

const Registered claim_6_1b_chatter_figure{
    {.name = "claim_6_1b_chatter",
     .parameters = {whole("seeds", 20, 1, 100, "clumps"),
                    whole("varied", 3, 1, 100, "of these, with other constants"),
                    whole("per_edge", 5, 2, 8, "cubes along each edge of the grid at the start"),
                    number("settling", 10.0, 0.5, 60.0, "s", "before cubes should rest"),
                    number("watched", 4.0, 0.5, 60.0, "s", "after that")},
     .quick = {"seeds=2", "varied=2", "per_edge=3", "settling=5", "watched=1"},
     .experiment = measure_left_chatter}};

}  // namespace
}  // namespace tumble::chapters
