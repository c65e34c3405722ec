/// \file
/// \brief What envelopes show of bodies that are fast, and of those that are nearly so (claim 5.5d).
#include "tumble/filtering/envelope_filter.hpp"
#include "tumble/filtering/one_euro_filter.hpp"
#include "tumble/math/rotation.hpp"

#include "driver/common_numbers.hpp"
#include "driver/statistics.hpp"
#include "filtering/envelope_experiments.hpp"
#include "filtering/settled_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace tumble::chapters {
namespace {

constexpr double kTossed = 2.0;  // [s] by then the cube rests

// [envelopes] How long a move is.
double size_of(const BodyState& from, const BodyState& to, const Envelope& envelope) {
  return std::max((to.position_w - from.position_w).norm() / envelope.radius,
                  angle_between(to.orientation_wb, from.orientation_wb) / envelope.angle);
}

// Frames of movable bodies that moved by more than the envelope since the frame before.
struct FastFrames {
  double all = 0.0;
  double exact = 0.0;    // that show the computed pose
  double centres = 0.0;  // whose centre alone moved by more
  double centres_exact = 0.0;

  void add(const World& world, const Trajectory& computed, const Trajectory& shown,
           const Envelope& envelope) {
    for (int f = 1; f < computed.count(); ++f) {
      const Frame before = computed.frame(f - 1);
      const Frame now = computed.frame(f);
      const Frame seen = shown.frame(f);
      for (std::size_t k = 0; k < now.states.size(); ++k) {
        if (!world.bodies()[k].movable()) continue;
        const BodyState& from = before.states[k];
        const BodyState& to = now.states[k];
        if (!(size_of(from, to, envelope) > 1.0)) continue;
        const double same = same_pose(to, seen.states[k]) ? 1.0 : 0.0;
        const bool centre = (to.position_w - from.position_w).norm() > envelope.radius;
        all += 1.0;
        exact += same;
        centres += centre ? 1.0 : 0.0;
        centres_exact += centre ? same : 0.0;
      }
    }
  }
};

// By seed: under the thesis's envelope and under ours, the clump and the tossed cube.
struct Scenes {
  std::vector<FastFrames> clump, tossed, soft;
};

SettledRun tossed_cube(std::uint64_t seed) {
  return settle_scene(scene_with("toss", {"size=1", "mass=1"}, seed), {"damped", {}}, 0.0, kTossed,
                      seed);
}

Scenes scenes_of(const Parameters& settings) {
  Scenes scenes;
  for (int seed = 1; seed <= settings.count("seeds"); ++seed) {
    SettledRequest request;
    request.per_edge = settings.count("per_edge");
    request.seed = static_cast<std::uint64_t>(seed);
    request.settling = 0.0;
    request.watched = settings.number("duration");
    for (auto* list : {&scenes.clump, &scenes.tossed, &scenes.soft}) list->emplace_back();
    for (const bool clump : {true, false}) {
      const SettledRun run = clump ? settle_clump(request) : tossed_cube(request.seed);
      (clump ? scenes.clump : scenes.tossed)
          .back()
          .add(run.world, run.frames, filtered(run.frames, EnvelopeFilter()), {});
      scenes.soft.back().add(run.world, run.frames, filtered(run.frames, SoftEnvelopeFilter()), {});
    }
  }
  return scenes;
}

// A ratio of two sums over the frames of some scenes.
Quantity share(std::string name, const std::vector<const std::vector<FastFrames>*>& scenes,
               double FastFrames::*above, double FastFrames::*below) {
  const std::size_t seeds = scenes[0]->size();
  std::vector<double> a(seeds, 0.0);
  std::vector<double> b(seeds, 0.0);
  for (const auto* list : scenes)
    for (std::size_t k = 0; k < seeds; ++k) {
      a[k] += (*list)[k].*above;
      b[k] += (*list)[k].*below;
    }
  return over_seeds(std::move(name), "-", static_cast<int>(seeds),
                    [&](int out) { return sum_without(a, out) / sum_without(b, out); });
}

// One cube, tossed and landing: how far its centre is shown from where it is.
Table path_of_tossed_cube(double& worst_fast) {
  const SettledRun run = tossed_cube(1);
  const Envelope envelope;
  std::size_t cube = 0;
  while (!run.world.bodies()[cube].movable()) ++cube;
  const std::array<Trajectory, 3> shown = {filtered(run.frames, EnvelopeFilter(envelope)),
                                           filtered(run.frames, SoftEnvelopeFilter(envelope)),
                                           filtered(run.frames, OneEuroFilter())};
  Table table{"",
              {{"time_s", "s", "since it was let go"},
               {"move", "-", "of the cube since the frame before, in envelopes"},
               {"thesis_mm", "mm", "from where its centre is shown to where it is: envelope"},
               {"soft_mm", "mm", "soft envelope"},
               {"euro_mm", "mm", "one-euro filter"}}};
  worst_fast = 0.0;
  for (int f = 1; f < run.frames.count(); ++f) {
    const BodyState& now = run.frames.frame(f).states[cube];
    const double move = size_of(run.frames.frame(f - 1).states[cube], now, envelope);
    table.rows.push_back({run.frames.frame(f).time, move});
    for (const Trajectory& frames : shown)
      table.rows.back().push_back(
          1e3 * (frames.frame(f).states[cube].position_w - now.position_w).norm());
    if (move > 1.0) worst_fast = std::max(worst_fast, table.rows.back()[2]);
  }
  return table;
}

// A body at a constant speed, as shown.
struct Ramp {
  double exact = 0.0;   // share of the frames that show the computed place
  double offset = 0.0;  // [m] largest, once the filter has swung in
  double pop = 0.0;     // [m] largest displayed step
  double period = 0.0;  // frames from one displayed step to the next
};

Ramp ramp_under(const PoseFilter& filter, double way) {
  constexpr int frames = 2400;
  Trajectory computed;
  const std::vector<BodyId> ids = {BodyId{}};
  std::vector<BodyState> states(1);
  for (int n = 0; n <= frames; ++n) {
    states[0].position_w.x() = n * way;
    computed.record(Frame{n * kStep, n, ids, states});
  }
  const Trajectory shown = filtered(computed, filter);
  const auto place = [](const Trajectory& run, int n) {
    return run.frame(n).states[0].position_w.x();
  };
  Ramp ramp;
  double steps = 0.0;
  for (int n = frames / 2 + 1; n <= frames; ++n) {
    const double step = place(shown, n) - place(shown, n - 1);
    if (place(shown, n) == place(computed, n)) ramp.exact += 2.0 / frames;
    if (step > 0.0) steps += 1.0;
    ramp.offset = std::max(ramp.offset, std::abs(place(shown, n) - place(computed, n)));
    ramp.pop = std::max(ramp.pop, step);
  }
  ramp.period = 0.5 * frames / steps;
  return ramp;
}

// Constant speeds against what the rules say of them: by f envelopes a frame the envelope of the
// thesis fires in every k-th frame, the first with k f > 1, and is k - 1 moves behind at most; ours is
// 1 - f envelopes behind, or not at all; the one-euro filter lags by v / (2π (cutoff + gain v)).
Table constant_speeds(double& difference) {
  const Envelope envelope;
  Table table{"speeds",
              {{"speed", "-", "way in a frame over the radius of the envelope"},
               {"thesis_exact", "-", "share of the frames shown as computed: envelope"},
               {"soft_exact", "-", "soft envelope"},
               {"euro_exact", "-", "one-euro filter"},
               {"thesis_offset_mm", "mm", "largest distance from shown to computed: envelope"},
               {"soft_offset_mm", "mm", "soft envelope"},
               {"euro_offset_mm", "mm", "one-euro filter"}}};
  difference = 0.0;
  constexpr int speeds = 80;
  for (int k = 0; k < speeds; ++k) {
    const double f = 2.0 * (k + 0.5) / speeds;  // never on a jump
    const double way = f * envelope.radius;
    const OneEuroOptions euro;
    const Ramp a = ramp_under(EnvelopeFilter(envelope), way);
    const Ramp b = ramp_under(SoftEnvelopeFilter(envelope), way);
    const Ramp c = ramp_under(OneEuroFilter(euro), way);
    table.rows.push_back(
        {f, a.exact, b.exact, c.exact, 1e3 * a.offset, 1e3 * b.offset, 1e3 * c.offset});
    const double every = std::floor(1.0 / f) + 1.0;
    const double speed = way / kStep;
    const double lag = speed / (2.0 * std::numbers::pi * (euro.cutoff + euro.gain * speed));
    for (const double one : {a.offset - (every - 1.0) * way,
                             b.offset - std::max(0.0, envelope.radius - way), c.offset - lag})
      difference = std::max(difference, std::abs(one));
  }
  return table;
}

}  // namespace

Result follow_fast_bodies(const Parameters& settings) {
  // Chosen before the first run: fast is who moved by more than a centimetre or turned by more than
  // a degree, as the filter itself decides; and shown is the computed pose bit by bit.
  const Scenes scenes = scenes_of(settings);
  double worst_fast = 0.0;
  const Table path = path_of_tossed_cube(worst_fast);
  double difference = 0.0;
  const Table speeds = constant_speeds(difference);
  const Ramp printed = ramp_under(EnvelopeFilter(), 0.003);
  double frames = 0.0;
  for (const auto* list : {&scenes.clump, &scenes.tossed})
    for (const FastFrames& seed : *list) frames += seed.all;
  const auto all = [&](const std::string& name, auto above, auto below) {
    return share(name, {&scenes.clump, &scenes.tossed}, above, below);
  };
  return {{path, speeds},
          {all("share of the frames of bodies faster than the envelope in a frame which show the "
               "computed pose",
               &FastFrames::exact, &FastFrames::all),
           all("the same, fast by their centres alone", &FastFrames::centres_exact,
               &FastFrames::centres),
           share("the same, tossed cubes alone", {&scenes.tossed}, &FastFrames::exact,
                 &FastFrames::all),
           share("the same, soft envelope", {&scenes.soft}, &FastFrames::exact, &FastFrames::all),
           {"frames of fast bodies, of all seeds", "-", frames},
           {"largest distance from shown to computed of a tossed cube while it is fast", "mm",
            worst_fast},
           {"pop of a ramp of 3 mm a frame", "mm", 1e3 * printed.pop},
           {"frames from pop to pop of a ramp of 3 mm a frame", "-", printed.period},
           {"largest difference from closed forms at constant speed", "m", difference}},
          {}};
}

}  // namespace tumble::chapters
