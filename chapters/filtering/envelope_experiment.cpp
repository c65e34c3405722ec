/// \file
/// \brief Two envelopes and bodies that chatter (claim 5.5c).
#include "tumble/filtering/envelope_filter.hpp"
#include "tumble/record/overlap.hpp"

#include "filtering/settled_run.hpp"

namespace tumble::chapters {
namespace {

// [m] The standard one is a centimetre, with a degree; the angle is in proportion.
constexpr std::array<double, 10> kRadii = {0.001, 0.002, 0.003, 0.005, 0.007,
                                           0.010, 0.015, 0.020, 0.030, 0.050};
constexpr std::size_t kStandard = 5;
constexpr std::size_t kHalfAsLarge = 3;
constexpr std::size_t kTwiceAsLarge = 7;
constexpr int kOverlapEvery = 6;     // frames between two in which overlap is measured
constexpr double kMostFrames = 0.9;  // claim 5.5c: nine frames of ten

Envelope envelope_of(double radius) {
  return {radius, radius / kRadii[kStandard] * std::numbers::pi / 180.0};
}

// The shown motion of the bodies that chatter, in one run.
struct Shown {
  double bodies = 0.0;
  double still_bodies = 0.0;  // that do not move in any frame
  double steps = 0.0;         // of all bodies, from frame to frame
  double still = 0.0;         // steps in which nothing of the pose changes
  double pops = 0.0;          // steps at least as long as the envelope
  double largest_step = 0.0;  // [m] way of a corner
  double way = 0.0;           // [mm] of the corner that goes farthest, summed over the steps
  double overlap = 0.0;       // [m] deepest one less the computed one, largest over frames
};

bool as_long_as(const BodyState& from, const BodyState& to, const Envelope& envelope) {
  return (to.position_w - from.position_w).norm() >= envelope.radius ||
         angle_between(to.orientation_wb, from.orientation_wb) >= envelope.angle;
}

// A run, and what of it is the same for all filters.
struct Watched {
  SettledRun run;
  std::vector<std::size_t> chattering;
  std::vector<double> overlap;  // [m] deepest in every so many frames

  Watched(const Parameters& settings, int seed)
      : run(settle_clump(settings, seed)), chattering(chattering_bodies(run)) {
    overlap = overlaps_in(run.frames);
  }

  [[nodiscard]] std::vector<double> overlaps_in(const Trajectory& frames) const {
    OverlapMeter meter;
    std::vector<double> deepest;
    for (int f = run.first; f < frames.count(); f += kOverlapEvery)
      deepest.push_back(meter.look(run.world.bodies(), frames.frame(f).states));
    return deepest;
  }

  [[nodiscard]] Shown measure(const Trajectory& frames, const Envelope& envelope) const {
    Shown shown;
    for (const std::size_t body : chattering) {
      const std::vector<Corners> path = settled_path(run, frames, body);
      double still = 0.0;
      for (std::size_t f = 1; f < path.size(); ++f) {
        const int frame = run.first + static_cast<int>(f);
        const BodyState& before = frames.frame(frame - 1).states[body];
        const BodyState& now = frames.frame(frame).states[body];
        const double way = largest_displacement(path[f - 1], path[f]);
        if (same_pose(before, now)) still += 1.0;
        if (as_long_as(before, now, envelope)) shown.pops += 1.0;
        shown.largest_step = std::max(shown.largest_step, way);
        shown.way += 1e3 * way;
      }
      const double steps = static_cast<double>(path.size() - 1);
      shown.bodies += 1.0;
      shown.still_bodies += still == steps ? 1.0 : 0.0;
      shown.steps += steps;
      shown.still += still;
    }
    shown.overlap = largest_of(overlaps_in(frames), overlap, std::minus<>());
    return shown;
  }
};

// The numbers of one filter and envelope.
struct Numbers {
  Quantity still, still_bodies, pops, speed;
  double largest_step, overlap;  // [mm]

  Numbers(const std::vector<Shown>& seeds, const std::string& whose)
      : largest_step(1e3 * largest_of(seeds, &Shown::largest_step)),
        overlap(1e3 * largest_of(seeds, &Shown::overlap)) {
    const auto ratio = [&](const std::string& name, const char* unit, auto above, auto below) {
      return ratio_of_sums(name + whose, unit, numbers_of(seeds, above), numbers_of(seeds, below));
    };
    const auto minutes = [](const Shown& s) { return s.steps * kStep / 60.0; };
    still = ratio("share of frames in which bodies that chatter stand still, ", "-", &Shown::still,
                  &Shown::steps);
    still_bodies = ratio("share of bodies that chatter which never move, ", "-",
                         &Shown::still_bodies, &Shown::bodies);
    pops = ratio("pops of a body that chatters, ", "1/min", &Shown::pops, minutes);
    speed = ratio("mean speed of the fastest corner at rest, ", "mm/s", &Shown::way,
                  [](const Shown& s) { return s.steps * kStep; });
  }

  // Of the claim's two sayings those that hold.
  [[nodiscard]] int holds() const {
    return (still.value >= kMostFrames ? 1 : 0) + (pops.value > 0.0 ? 1 : 0);
  }
  // The cells of the table of the sweep.
  [[nodiscard]] std::array<double, 9> cells() const {
    return {still.value, still.low,    still.high,  pops.value, pops.low,
            pops.high,   largest_step, speed.value, overlap};
  }
};

Table table_of_sweep() {
  Table table{"", {{"radius_mm", "mm", "of the envelope; its angle is a degree per centimetre"}}};
  for (const std::string whose : {"thesis", "soft"}) {
    add_interval_columns(whose + "_still", "-", "share of frames shown at rest", table);
    add_interval_columns(whose + "_pops", "1/min", "pops of a body", table);
    table.columns.push_back({whose + "_step_mm", "mm", "longest way of a corner in a frame"});
    table.columns.push_back({whose + "_speed_mm_s", "mm/s", "of the fastest corner, mean"});
    table.columns.push_back({whose + "_overlap_mm", "mm", "largest overlap made by filtering"});
  }
  return table;
}

// Chosen before the first run: frames of all bodies and seeds are one pool, and filtering begins
// with the run, ten seconds before the frames that count.
Result sweep_envelope(const Parameters& settings) {
  std::array<std::vector<Shown>, kRadii.size()> thesis;
  std::array<std::vector<Shown>, kRadii.size()> soft;
  std::vector<Shown> raw;
  for (int seed = 1; seed <= settings.count("seeds"); ++seed) {
    const Watched watched(settings, seed);
    raw.push_back(watched.measure(watched.run.frames, envelope_of(kRadii[kStandard])));
    for (std::size_t k = 0; k < kRadii.size(); ++k) {
      const Envelope envelope = envelope_of(kRadii[k]);
      const auto under = [&](const PoseFilter& filter) {
        return watched.measure(filtered(watched.run.frames, filter), envelope);
      };
      thesis[k].push_back(under(EnvelopeFilter(envelope)));
      soft[k].push_back(under(SoftEnvelopeFilter(envelope)));
    }
  }

  Table table = table_of_sweep();
  for (std::size_t k = 0; k < kRadii.size(); ++k)
    table.add(1e3 * kRadii[k], Numbers(thesis[k], "").cells(), Numbers(soft[k], "").cells());
  const Numbers computed(raw, "computed");
  Table unfiltered{"raw",
                   {{"speed_mm_s", "mm/s", "of the fastest corner, mean"},
                    {"step_mm", "mm", "longest way of a corner in a frame"},
                    {"standard_mm", "mm", "radius of the envelope of the claim"}}};
  unfiltered.add(computed.speed.value, computed.largest_step, 1e3 * kRadii[kStandard]);

  const Numbers as_thesis(thesis[kStandard], "envelope of the thesis");
  const Numbers as_soft(soft[kStandard], "soft envelope");
  // The thesis gives the envelope no size: the same two sayings for half of ours and for twice.
  const Numbers half(thesis[kHalfAsLarge], "half the envelope");
  const Numbers twice(thesis[kTwiceAsLarge], "twice the envelope");
  double bodies = 0.0;
  for (const Shown& shown : raw) bodies += shown.bodies;
  return {{table, unfiltered},
          {{"of two sayings about the envelope filter those that hold: bodies that chatter stand "
            "still in nine frames of ten or more, and there are pops",
            "-", as_thesis.holds()},
           {"bodies that chatter, of all seeds", "-", bodies},
           as_thesis.still,
           as_soft.still,
           as_thesis.still_bodies,
           as_thesis.pops,
           as_soft.pops,
           {"largest pop, envelope of the thesis", "mm", as_thesis.largest_step},
           computed.speed,
           as_thesis.speed,
           {"largest overlap made by filtering, envelope of the thesis", "mm", as_thesis.overlap},
           {"the same sayings, half the envelope", "-", half.holds()},
           {"the same sayings, twice the envelope", "-", twice.holds()},
           half.still,
           twice.still,
           half.pops,
           twice.pops}};
}

const Registered claim_5_5c_envelope_figure{
    {.name = "claim_5_5c_envelope",
     .parameters = {whole("seeds", 8, 1, 100, "clumps"),
                    whole("per_edge", 5, 2, 8, "cubes along each edge of the grid at the start"),
                    number("settling", 10.0, 0.5, 60.0, "s", "before cubes should rest"),
                    number("watched", 4.0, 0.5, 60.0, "s", "after that")},
     .quick = {"seeds=2", "per_edge=4", "settling=6", "watched=2"},
     .experiment = sweep_envelope}};

}  // namespace
}  // namespace tumble::chapters
