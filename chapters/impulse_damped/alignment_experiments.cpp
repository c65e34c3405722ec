/// \file
/// \brief What each part of the damping does against chatter, and whom the alignment test misses
///        (thesis 5.3).
#include "impulse_damped/alignment_experiments.hpp"

#include "tumble/impulse_damped/tolerances.hpp"

#include "driver/statistics.hpp"
#include "impulse_damped/settled_boxes.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <vector>

namespace tumble::chapters {
namespace {

// One choice of parts and constants, tried on several seeds.
struct Tried {
  std::vector<std::vector<BoxEnd>> ends = {};  // of each seed

  // What share of the boxes has a property, without one of the seeds.
  template <typename Has>
  double share(const Has& has, int left_out) const {
    return count(has, left_out) / count([](const BoxEnd&) { return true; }, left_out);
  }
  template <typename Has>
  double count(const Has& has, int left_out) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < ends.size(); ++k)
      if (static_cast<int>(k) != left_out)
        sum += static_cast<double>(std::count_if(ends[k].begin(), ends[k].end(), has));
    return sum;
  }
  double rest_time(int left_out) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < ends.size(); ++k)
      for (const BoxEnd& end : ends[k])
        if (static_cast<int>(k) != left_out) sum += end.rest_time;
    return sum / count([](const BoxEnd&) { return true; }, left_out);
  }
};

struct Constants {
  const char* name;
  double eps = 1.0;
  double k = 1.0;
};
constexpr std::array<Constants, 5> kConstants{{{"", 1.0, 1.0},
                                               {", thresholds halved", 0.5, 1.0},
                                               {", thresholds doubled", 2.0, 1.0},
                                               {", damping half as fast", 1.0, 0.5},
                                               {", damping twice as fast", 1.0, 2.0}}};

DampedOptions options_of(const std::string& parts, const Constants& constants, int seed) {
  DampedOptions options;
  options.damping = damping_parts_from(parts);
  options.numbers.eps_scale = constants.eps;
  options.numbers.k_scale = constants.k;
  options.seed = static_cast<std::uint64_t>(seed);
  return options;
}

bool chatters(const BoxEnd& end) { return end.chatters(); }

}  // namespace

Result measure_ablation(const Parameters& settings) {
  const int seeds = settings.count("seeds");
  const double duration = settings.number("duration");
  const auto attempt = [&](const std::string& parts, const Constants& constants, int per_edge) {
    Tried tried;
    for (int seed = 1; seed <= seeds; ++seed)
      tried.ends.push_back(
          settle(clump(per_edge, seed), options_of(parts, constants, seed), duration));
    return tried;
  };
  const int per_edge = settings.count("per_edge");

  // Sets of parts: a word for the quantities, and what is used.
  static constexpr std::array<std::array<const char*, 2>, 8> kSets{
      {{"scaling only", "scale"},
       {"scaling and alignment tests", "scale+align+tilt"},
       {"all parts", "all"},
       {"all but scaling", "small+align+tilt+freeze"},
       {"all but slow components", "scale+align+tilt+freeze"},
       {"all but the settling of aligned boxes", "scale+small+tilt+freeze"},
       {"all but turning upright", "scale+small+align+freeze"},
       {"all but small moves undone", "scale+small+align+tilt"}}};
  Result result;
  Table table{"",
              {{"set", "-",
                "1 to 8: scaling; with alignment; all; all but scaling, but slow "
                "components, but settling, but turning upright, but small moves undone"},
               {"chatter", "-", "share of the boxes that chatter"},
               {"restless", "-", "share of the boxes that do not rest in the last half second"},
               {"rest_s", "s", "mean time at which a box last moved by more than a little"}}};
  std::vector<Tried> tried;
  for (std::size_t k = 0; k < kSets.size(); ++k) {
    tried.push_back(attempt(kSets[k][1], kConstants[0], per_edge));
    const Tried& now = tried.back();
    table.rows.push_back({static_cast<double>(k + 1), now.share(chatters, -1),
                          now.share([](const BoxEnd& end) { return !end.rests; }, -1),
                          now.rest_time(-1)});
  }
  std::stable_sort(table.rows.begin(), table.rows.end(),
                   [](const auto& a, const auto& b) { return a[1] > b[1]; });
  result.tables = {table};

  // The claim's number: at the usual size, with other constants, and with few boxes.
  const std::string claim =
      "boxes that chatter with the scaling of velocities only, less those with the alignment tests "
      "too, over all boxes";
  const auto compare = [&](const std::string& name, const Tried& scaled, const Tried& aligned) {
    result.quantities.push_back(over_seeds(name, "-", seeds, [&](int left_out) {
      return scaled.share(chatters, left_out) - aligned.share(chatters, left_out);
    }));
  };
  compare(claim, tried[0], tried[1]);
  for (std::size_t c = 1; c < kConstants.size(); ++c)
    compare(std::string("the same") + kConstants[c].name,
            attempt(kSets[0][1], kConstants[c], per_edge),
            attempt(kSets[1][1], kConstants[c], per_edge));
  for (const double shake : {0.05, 0.2}) {
    const auto shakes = [=](const BoxEnd& end) { return end.rests && end.shake > shake; };
    result.quantities.push_back(over_seeds(shake < 0.1 ? "the same, half the shake is chatter"
                                                       : "the same, twice the shake is chatter",
                                           "-", seeds, [&](int left_out) {
                                             return tried[0].share(shakes, left_out) -
                                                    tried[1].share(shakes, left_out);
                                           }));
  }
  compare("the same, 8 cubes", attempt(kSets[0][1], kConstants[0], 2),
          attempt(kSets[1][1], kConstants[0], 2));
  for (std::size_t k = 0; k < kSets.size(); ++k) {
    const Tried& now = tried[k];
    const std::string name = kSets[k][0];
    result.quantities.push_back(
        over_seeds("share of the boxes that chatter, " + name, "-", seeds,
                   [&](int left_out) { return now.share(chatters, left_out); }));
    result.quantities.push_back(over_seeds("mean time to rest, " + name, "s", seeds,
                                           [&](int left_out) { return now.rest_time(left_out); }));
  }
  return result;
}

Result measure_leaning(const Parameters& settings) {
  const int seeds = settings.count("seeds");
  const double duration = settings.number("duration");
  const auto attempt = [&](const std::string& parts, const Constants& constants) {
    Tried tried;
    for (int seed = 1; seed <= seeds; ++seed) {
      const DampedOptions options = options_of(parts, constants, seed);
      tried.ends.push_back(settle(clump(settings.count("per_edge"), seed), options, duration));
      const std::vector<BoxEnd> planks = settle(propped_planks(seed), options, duration);
      tried.ends.back().insert(tried.ends.back().end(), planks.begin(), planks.end());
    }
    return tried;
  };
  const auto leans = [](const BoxEnd& end) { return !end.on_face; };
  const auto shaky_lean = [](const BoxEnd& end) { return end.chatters() && !end.on_face; };
  const auto shaky_flat = [](const BoxEnd& end) { return end.chatters() && end.on_face; };
  const auto caught_lean = [=](const BoxEnd& end) { return shaky_lean(end) && end.aligned; };
  const auto caught_flat = [=](const BoxEnd& end) { return shaky_flat(end) && end.aligned; };

  Result result;
  std::vector<Tried> tried;
  for (const Constants& constants : kConstants) {
    tried.push_back(attempt("scale", constants));
    const Tried& now = tried.back();
    const std::string name =
        tried.size() == 1 ? "share of the chattering boxes that the test catches among those that "
                            "lean, over the share among those that lie flat"
                          : std::string("the same") + constants.name;
    result.quantities.push_back(over_seeds(name, "-", seeds, [&](int left_out) {
      return now.count(caught_lean, left_out) / now.count(shaky_lean, left_out) /
             (now.count(caught_flat, left_out) / now.count(shaky_flat, left_out));
    }));
  }
  const Tried& usual = tried.front();
  const Tried all = attempt("all", kConstants[0]);
  const auto share = [&](const std::string& name, const Tried& of, const auto& has,
                         const auto& among) {
    result.quantities.push_back(over_seeds(name, "-", seeds, [&](int left_out) {
      return of.count(has, left_out) / of.count(among, left_out);
    }));
  };
  const auto flat = [](const BoxEnd& end) { return end.on_face; };
  share("share of the boxes that lie flat that chatter", usual, shaky_flat, flat);
  share("of these, share that the test catches", usual, caught_flat, shaky_flat);
  share("share of the boxes that lean that chatter", usual, shaky_lean, leans);
  share("of these, share that the test catches, leaning", usual, caught_lean, shaky_lean);
  share("share of the boxes that lean that chatter, all parts of the damping", all, shaky_lean,
        leans);
  result.quantities.push_back(over_seeds(
      "boxes that lean and chatter, mean of a heap and its planks", "-", seeds, [&](int left_out) {
        return usual.count(shaky_lean, left_out) / (seeds - (left_out < 0 ? 0 : 1));
      }));

  Table table{"",
              {{"tilt_deg", "deg", "between the vertical and the nearest axis of the box"},
               {"shake", "-", "acceleration of its corners over that of free fall"},
               {"leans", "-", "1: none of its faces lies on anything"},
               {"caught", "-", "1: the alignment test finds it"},
               {"limit_deg", "deg", "tilt up to which it does"}}};
  const double degree = std::numbers::pi / 180.0;
  for (const std::vector<BoxEnd>& ends : usual.ends)
    for (const BoxEnd& end : ends)
      if (end.chatters())
        table.rows.push_back({end.tilt / degree, end.shake, end.on_face ? 0.0 : 1.0,
                              end.aligned ? 1.0 : 0.0, tolerance::damped_aligned / degree});
  result.tables = {table};
  return result;
}

}  // namespace tumble::chapters
