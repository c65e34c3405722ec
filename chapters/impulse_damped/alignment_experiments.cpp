/// \file
/// \brief Effect of each part of the damping on chatter, and boxes that the alignment test misses (thesis
///        5.3).
#include "tumble/impulse_damped/tolerances.hpp"

#include "impulse_damped/damped_variants.hpp"
#include "impulse_damped/settled_boxes.hpp"

#include <tuple>

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
        sum += static_cast<double>(std::ranges::count_if(ends[k], has));
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

bool chatters(const BoxEnd& end) { return end.chatters(); }

// How the boxes of a heap end. Both figures ask for the same heaps, so what the program has settled once it keeps.
const std::vector<BoxEnd>& settled_heap(int per_edge, int seed, const std::string& parts,
                                        const DampedScales& scales, double duration) {
  static std::map<std::tuple<int, int, std::string, double, double, double>, std::vector<BoxEnd>>
      heaps;
  const auto [heap, fresh] =
      heaps.try_emplace({per_edge, seed, parts, scales.eps, scales.k, duration});
  if (fresh)
    heap->second = settle(clump(per_edge, seed), damped_options(parts, scales, seed), duration);
  return heap->second;
}

// What is tried against chatter: parts of the damping, and whether the share of the boxes that chatter is a number of the figure.
struct PartSet {
  const char* words;
  const char* parts;
  bool share;
};
constexpr std::array<PartSet, 8> kSets{
    {{"scaling only", "scale", true},
     {"scaling and alignment tests", "scale+align+tilt", true},
     {"all parts", "all", true},
     {"all but scaling", "small+align+tilt+freeze", false},
     {"all but slow components", "scale+align+tilt+freeze", false},
     {"all but the settling of aligned boxes", "scale+small+tilt+freeze", true},
     {"all but turning upright", "scale+small+align+freeze", true},
     {"all but small moves undone", "scale+small+align+tilt", true}}};

// How long the ways of the centres of a heap are from three seconds to four, all boxes together [m].
double way_of(World world, const DampedOptions& options) {
  Damped technique(options);
  double way = 0.0;
  while (world.time() < 4.0 - 0.5 * kStep) {
    const std::vector<BodyState> before(world.states().begin(), world.states().end());
    finished(technique.step(world, kStep));
    if (world.time() < 3.0 + 0.5 * kStep) continue;
    for (std::size_t k = 0; k < before.size(); ++k)
      way += (world.states()[k].position_w - before[k].position_w).norm();
  }
  return way;
}

// Claim 6.1d: the ways with all parts of the damping over those without any.
Quantity ways_of_heaps(int per_edge, int seeds, int after) {
  std::vector<double> all, none;
  for (int seed = after + 1; seed <= after + seeds; ++seed) {
    all.push_back(way_of(clump(per_edge, seed), damped_options("all", {}, seed)));
    none.push_back(way_of(clump(per_edge, seed), damped_options("none", {}, seed)));
  }
  return over_seeds(
      "way of the boxes of heaps in the fourth second with all parts of the damping over the same "
      "without any",
      "-", seeds, [&](int left_out) {
        double above = 0.0, below = 0.0;
        for (std::size_t k = 0; k < all.size(); ++k) {
          if (static_cast<int>(k) == left_out) continue;
          above += all[k];
          below += none[k];
        }
        return above / below;
      });
}

Result measure_ablation(const Parameters& settings) {
  const int seeds = settings.count("seeds");
  const double duration = settings.number("duration");
  const auto attempt = [&](const PartSet& set, const DampedScales& scales, int per_edge,
                           int after = 0) {
    Tried tried;
    for (int seed = after + 1; seed <= after + seeds; ++seed)
      tried.ends.push_back(settled_heap(per_edge, seed, set.parts, scales, duration));
    return tried;
  };
  const int per_edge = settings.count("per_edge");
  Result result;
  Table table{"",
              {{"set", "-",
                "1 to 8: scaling; with alignment; all; all but scaling, but slow "
                "components, but settling, but turning upright, but small moves undone"},
               {"chatter", "-", "share of the boxes that chatter"},
               {"chatter_low", "-", "lower end of its interval of 95 %"},
               {"chatter_high", "-", "upper end"},
               {"rest_s", "s", "mean time at which a box last moved by more than a little"},
               {"rest_low_s", "s", "lower end of its interval of 95 %"},
               {"rest_high_s", "s", "upper end"}}};
  std::vector<Tried> tried;
  for (const PartSet& set : kSets) {
    tried.push_back(attempt(set, {}, per_edge));
    const Tried& now = tried.back();
    const Quantity share =
        over_seeds("", "-", seeds, [&](int left_out) { return now.share(chatters, left_out); });
    const Quantity rest =
        over_seeds("", "s", seeds, [&](int left_out) { return now.rest_time(left_out); });
    table.add(tried.size(), with_interval(share), with_interval(rest));
  }
  std::stable_sort(table.rows.begin(), table.rows.end(),
                   [](const auto& a, const auto& b) { return a[1] > b[1]; });
  result.tables = {table};

  // The claim's number: at the usual size, with other constants, and with few boxes.
  const auto compare = [&](const std::string& name, const Tried& scaled, const Tried& aligned,
                           const auto& has) {
    result.add(over_seeds(name, "-", seeds, [&](int left_out) {
      return scaled.share(has, left_out) - aligned.share(has, left_out);
    }));
  };
  compare(
      "boxes that chatter with the scaling of velocities only, less those with the alignment tests "
      "too, over all boxes",
      tried[0], tried[1], chatters);
  compare(
      "boxes that chatter with the scaling of velocities only, less those with the alignment tests "
      "too, over all boxes, fresh seeds",
      attempt(kSets[0], {}, per_edge, seeds), attempt(kSets[1], {}, per_edge, seeds), chatters);
  const DampedScales reported{"as_reported", 1.0, kReportedDamping};
  compare(
      "boxes that chatter with the scaling of velocities only, less those with the alignment tests "
      "too, over all boxes, as_reported",
      attempt(kSets[0], reported, per_edge, seeds), attempt(kSets[1], reported, per_edge, seeds),
      chatters);
  // Claim 5.2a. Boxes that still slide do not chatter, so that this says little where nothing rests.
  const Tried bare = attempt({"none", "none", true}, {}, per_edge, 2 * seeds);
  result.add(over_seeds("share of the boxes of heaps that chatter without any damping", "-", seeds,
                        [&](int left_out) { return bare.share(chatters, left_out); }));
  result.add(ways_of_heaps(per_edge, seeds, 2 * seeds));
  for (const DampedScales& scales : other_scales)
    compare(std::string("the same, ") + scales.words, attempt(kSets[0], scales, per_edge),
            attempt(kSets[1], scales, per_edge), chatters);
  for (const double shake : {0.05, 0.2})
    compare(shake < 0.1 ? "the same, half the shake is chatter"
                        : "the same, twice the shake is chatter",
            tried[0], tried[1], [=](const BoxEnd& end) { return end.rests && end.shake > shake; });
  compare("the same, 8 cubes", attempt(kSets[0], {}, 2), attempt(kSets[1], {}, 2), chatters);
  for (std::size_t k = 0; k < kSets.size(); ++k)
    if (kSets[k].share)
      result.add(over_seeds(std::string("share of the boxes that chatter, ") + kSets[k].words, "-",
                            seeds,
                            [&](int left_out) { return tried[k].share(chatters, left_out); }));
  return result;
}

const Registered claim_5_3b_ablation_figure{
    {.name = "claim_5_3b_ablation",
     .parameters = {whole("per_edge", 3, 2, 10, "cubes along each edge of the grid"),
                    number("duration", 3.0, 1.0, 60.0, "s", "of each run"),
                    whole("seeds", 20, 2, 1000, "heaps")},
     .quick = {"per_edge=2", "duration=2", "seeds=3"},
     .experiment = measure_ablation}};

Result measure_leaning(const Parameters& settings) {
  const int seeds = settings.count("seeds");
  const double duration = settings.number("duration");
  const auto attempt = [&](const std::string& parts, const DampedScales& scales, int after = 0) {
    Tried tried;
    for (int seed = after + 1; seed <= after + seeds; ++seed) {
      tried.ends.push_back(settled_heap(settings.count("per_edge"), seed, parts, scales, duration));
      const std::vector<BoxEnd> planks =
          settle(propped_planks(seed), damped_options(parts, scales, seed), duration);
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
  const auto caught = [&](const std::string& name, const Tried& now) {
    result.add(over_seeds(name, "-", seeds, [&](int left_out) {
      return now.count(caught_lean, left_out) / now.count(shaky_lean, left_out) /
             (now.count(caught_flat, left_out) / now.count(shaky_flat, left_out));
    }));
  };
  const Tried usual = attempt("scale", {});
  caught(
      "share of the chattering boxes that the test catches among those that lean, over the share "
      "among those that lie flat",
      usual);
  caught(
      "share of the chattering boxes that the test catches among those that lean, over the share "
      "among those that lie flat, fresh seeds",
      attempt("scale", {}, seeds));
  for (const DampedScales& scales : other_scales)
    caught(std::string("the same, ") + scales.words, attempt("scale", scales));
  const Tried all = attempt("all", {});
  const auto share = [&](const std::string& name, const Tried& of, const auto& has,
                         const auto& among) {
    result.add(over_seeds(name, "-", seeds, [&](int left_out) {
      return of.count(has, left_out) / of.count(among, left_out);
    }));
  };
  share("of these, share that the test catches", usual, caught_flat, shaky_flat);
  share("share of the boxes that lean that chatter", usual, shaky_lean, leans);
  share("of these, share that the test catches, leaning", usual, caught_lean, shaky_lean);
  share("share of the boxes that lean that chatter, all parts of the damping", all, shaky_lean,
        leans);

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
        table.add(end.tilt / degree, end.shake, !end.on_face, end.aligned,
                  tolerance::damped_aligned / degree);
  result.tables = {table};
  return result;
}

const Registered claim_5_3e_leaning_figure{
    {.name = "claim_5_3e_leaning",
     .parameters = {whole("per_edge", 3, 2, 10, "cubes along each edge of the grid"),
                    number("duration", 3.0, 1.0, 60.0, "s", "of each run"),
                    whole("seeds", 20, 2, 1000, "heaps, and sets of planks")},
     .quick = {"per_edge=2", "duration=2", "seeds=3"},
     .experiment = measure_leaning}};

}  // namespace
}  // namespace tumble::chapters
