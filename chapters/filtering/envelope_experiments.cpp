/// \file
/// \brief What two envelopes show of bodies that chatter (claim 5.5c).
#include "filtering/envelope_experiments.hpp"

#include "tumble/filtering/envelope_filter.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/record/overlap.hpp"

#include "driver/statistics.hpp"
#include "filtering/settled_run.hpp"
#include "filtering/shown_clump.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <numbers>
#include <string>

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

// What is shown of the bodies that chatter, in one run.
struct Shown {
  double bodies = 0.0;
  double still_bodies = 0.0;  // that do not move in any frame
  double steps = 0.0;         // of all bodies, from frame to frame
  double still = 0.0;         // steps in which nothing of the pose changes
  double pops = 0.0;          // steps at least as long as the envelope
  double corner_pops = 0.0;   // the same by the way of a corner, and longer than what is computed
  double largest_step = 0.0;  // [m] way of a corner
  double way = 0.0;           // [mm] of the corner that goes farthest, summed over the steps
  double overlap = 0.0;       // [m] deepest one less the computed one, largest over frames

  [[nodiscard]] double minutes(double interval) const { return steps * interval / 60.0; }
};

bool as_long_as(const BodyState& from, const BodyState& to, const Envelope& envelope) {
  return (to.position_w - from.position_w).norm() >= envelope.radius ||
         angle_between(to.orientation_wb, from.orientation_wb) >= envelope.angle;
}

// A run, and what of it is the same for all filters.
struct Watched {
  SettledRun run;
  std::vector<std::size_t> chattering;
  std::vector<std::vector<Corners>> computed;  // their paths
  std::vector<double> overlap;                 // [m] deepest in every so many frames

  explicit Watched(const SettledRequest& request)
      : run(settle_clump(request)), chattering(chattering_bodies(run)) {
    for (const std::size_t k : chattering) computed.push_back(settled_path(run, run.frames, k));
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
    for (std::size_t n = 0; n < chattering.size(); ++n) {
      const std::vector<Corners> path = settled_path(run, frames, chattering[n]);
      double still = 0.0;
      for (std::size_t f = 1; f < path.size(); ++f) {
        const int frame = run.first + static_cast<int>(f);
        const BodyState& before = frames.frame(frame - 1).states[chattering[n]];
        const BodyState& now = frames.frame(frame).states[chattering[n]];
        const double way = largest_way(path[f - 1], path[f]);
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
      shown.corner_pops += pops(path, computed[n], envelope.radius).count;
    }
    const std::vector<double> deepest = overlaps_in(frames);
    for (std::size_t k = 0; k < deepest.size(); ++k)
      shown.overlap = std::max(shown.overlap, deepest[k] - overlap[k]);
    return shown;
  }
};

// Ratio of two sums over seeds, with its interval.
Quantity ratio(std::string name, std::string unit, const std::vector<Shown>& seeds,
               const std::function<double(const Shown&)>& above,
               const std::function<double(const Shown&)>& below) {
  std::vector<double> a;
  std::vector<double> b;
  for (const Shown& shown : seeds) {
    a.push_back(above(shown));
    b.push_back(below(shown));
  }
  return over_seeds(std::move(name), std::move(unit), static_cast<int>(seeds.size()),
                    [&](int out) { return sum_without(a, out) / sum_without(b, out); });
}

double largest(const std::vector<Shown>& seeds, double Shown::*what) {
  double largest = 0.0;
  for (const Shown& shown : seeds) largest = std::max(largest, shown.*what);
  return largest;
}

// The numbers of one filter and envelope.
struct Numbers {
  Quantity still, still_bodies, pops, corner_pops, speed;
  double largest_step, overlap;

  Numbers(const std::vector<Shown>& seeds, double interval, const std::string& whose)
      : still(ratio(
            "share of frames in which bodies that chatter stand still, " + whose, "-", seeds,
            [](const Shown& s) { return s.still; }, [](const Shown& s) { return s.steps; })),
        still_bodies(ratio(
            "share of bodies that chatter which never move, " + whose, "-", seeds,
            [](const Shown& s) { return s.still_bodies; },
            [](const Shown& s) { return s.bodies; })),
        pops(ratio(
            "pops of a body that chatters, " + whose, "1/min", seeds,
            [](const Shown& s) { return s.pops; },
            [=](const Shown& s) { return s.minutes(interval); })),
        corner_pops(ratio(
            "the same by way of a corner, " + whose, "1/min", seeds,
            [](const Shown& s) { return s.corner_pops; },
            [=](const Shown& s) { return s.minutes(interval); })),
        speed(ratio(
            "mean speed of the fastest corner at rest, " + whose, "mm/s", seeds,
            [](const Shown& s) { return s.way; },
            [=](const Shown& s) { return s.steps * interval; })),
        largest_step(largest(seeds, &Shown::largest_step)),
        overlap(largest(seeds, &Shown::overlap)) {}

  // Of the claim's two sayings those that hold.
  [[nodiscard]] double holds() const {
    return (still.value >= kMostFrames ? 1.0 : 0.0) + (pops.value > 0.0 ? 1.0 : 0.0);
  }
};

Table table_of_sweep() {
  Table table{"", {{"radius_mm", "mm", "of the envelope; its angle is a degree per centimetre"}}};
  for (const std::string whose : {"thesis", "soft"}) {
    for (const std::string end : {"", "_low", "_high"})
      table.columns.push_back({whose + "_still" + end, "-",
                               end.empty() ? "share of frames shown at rest" : "95 % interval"});
    for (const std::string end : {"", "_low", "_high"})
      table.columns.push_back(
          {whose + "_pops" + end, "1/min", end.empty() ? "pops of a body" : "95 % interval"});
    table.columns.push_back({whose + "_step_mm", "mm", "longest way of a corner in a frame"});
    table.columns.push_back({whose + "_speed_mm_s", "mm/s", "of the fastest corner, mean"});
    table.columns.push_back({whose + "_overlap_mm", "mm", "largest overlap made by filtering"});
  }
  return table;
}

void append(std::vector<double>& row, const Numbers& n) {
  for (const Quantity* q : {&n.still, &n.pops})
    for (const double value : {q->value, q->low, q->high}) row.push_back(value);
  for (const double value : {1e3 * n.largest_step, n.speed.value, 1e3 * n.overlap})
    row.push_back(value);
}

}  // namespace

Result sweep_envelope(const Parameters& settings) {
  SettledRequest request;
  request.per_edge = settings.count("per_edge");
  request.settling = settings.number("settling");
  request.watched = settings.number("watched");
  const int seeds = settings.count("seeds");
  std::array<std::vector<Shown>, kRadii.size()> thesis;
  std::array<std::vector<Shown>, kRadii.size()> soft;
  std::vector<Shown> raw;
  for (int seed = 1; seed <= seeds; ++seed) {
    request.seed = static_cast<std::uint64_t>(seed);
    const Watched watched(request);
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

  constexpr double interval = kStep;
  Table table = table_of_sweep();
  for (std::size_t k = 0; k < kRadii.size(); ++k) {
    table.rows.push_back({1e3 * kRadii[k]});
    append(table.rows.back(), Numbers(thesis[k], interval, ""));
    append(table.rows.back(), Numbers(soft[k], interval, ""));
  }
  const Numbers computed(raw, interval, "computed");
  const Table unfiltered{
      "raw",
      {{"speed_mm_s", "mm/s", "of the fastest corner, mean"},
       {"step_mm", "mm", "longest way of a corner in a frame"},
       {"standard_mm", "mm", "radius of the envelope of the claim"}},
      {{computed.speed.value, 1e3 * computed.largest_step, 1e3 * kRadii[kStandard]}}};

  // Chosen before the first run: frames of all bodies and seeds are one pool, and filtering begins
  // with the run, ten seconds before the frames that count.
  const Numbers as_thesis(thesis[kStandard], interval, "envelope of the thesis");
  const Numbers as_soft(soft[kStandard], interval, "soft envelope");
  // The thesis gives the envelope no size: the same two sayings for half of ours and for twice.
  const Numbers half(thesis[kHalfAsLarge], interval, "half the envelope");
  const Numbers twice(thesis[kTwiceAsLarge], interval, "twice the envelope");
  double bodies = 0.0;
  for (const Shown& shown : raw) bodies += shown.bodies;
  return {
      {table, unfiltered},
      {{"of two sayings about the envelope filter those that hold: bodies that chatter stand "
        "still in nine frames of ten or more, and there are pops",
        "-", as_thesis.holds()},
       {"bodies that chatter, of all seeds", "-", bodies},
       as_thesis.still,
       as_soft.still,
       as_thesis.still_bodies,
       as_thesis.pops,
       as_soft.pops,
       as_thesis.corner_pops,
       {"largest pop, envelope of the thesis", "mm", 1e3 * as_thesis.largest_step},
       computed.speed,
       as_thesis.speed,
       {"largest overlap made by filtering, envelope of the thesis", "mm", 1e3 * as_thesis.overlap},
       {"the same sayings, half the envelope", "-", half.holds()},
       {"the same sayings, twice the envelope", "-", twice.holds()},
       half.still,
       twice.still,
       half.pops,
       twice.pops,
       {"largest pop, twice the envelope", "mm", 1e3 * twice.largest_step}},
      {}};
}

}  // namespace tumble::chapters
