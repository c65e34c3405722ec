/// \file
/// \brief Envelopes and bodies that are fast or nearly so (claim 5.5d).
#include "tumble/filtering/envelope_filter.hpp"
#include "tumble/filtering/one_euro_filter.hpp"

#include "filtering/settled_run.hpp"

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
  double exact = 0.0;  // that show the computed pose

  void add(const SettledRun& run, const Trajectory& shown) {
    const Envelope envelope;
    for (int f = 1; f < run.frames.count(); ++f)
      for (std::size_t k = 0; k < run.world.bodies().size(); ++k) {
        const BodyState& from = run.frames.frame(f - 1).states[k];
        const BodyState& to = run.frames.frame(f).states[k];
        if (!run.world.bodies()[k].movable() || !(size_of(from, to, envelope) > 1.0)) continue;
        all += 1.0;
        exact += same_pose(to, shown.frame(f).states[k]) ? 1.0 : 0.0;
      }
  }
};

// A clump and a tossed cube.
struct FastSeed {
  FastFrames both;    // under the thesis's envelope
  FastFrames tossed;  // the cube alone
  FastFrames soft;    // both under ours
};

SettledRun tossed_cube(std::uint64_t seed) {
  return settle_scene(make_scene("toss", {"size=1", "mass=1"}, seed), {"damped", {}}, 0.0, kTossed,
                      seed);
}

FastSeed fast_seed(const Parameters& settings, std::uint64_t seed) {
  const SettledRun clump =
      damped_clump(settings.count("per_edge"), seed, 0.0, settings.number("duration"));
  const SettledRun cube = tossed_cube(seed);
  FastSeed out;
  out.both.add(clump, filtered(clump.frames, EnvelopeFilter()));
  out.tossed.add(cube, filtered(cube.frames, EnvelopeFilter()));
  out.both.add(cube, filtered(cube.frames, EnvelopeFilter()));
  out.soft.add(clump, filtered(clump.frames, SoftEnvelopeFilter()));
  out.soft.add(cube, filtered(cube.frames, SoftEnvelopeFilter()));
  return out;
}

// One cube, tossed and landing: how far its centre is shown from where it is.
Table path_of_tossed_cube(double& worst_fast) {
  const SettledRun run = tossed_cube(1);
  const Envelope envelope;
  const std::size_t cube = first_movable(run.world);
  const std::array<Trajectory, 3> shown = {filtered(run.frames, EnvelopeFilter(envelope)),
                                           filtered(run.frames, SoftEnvelopeFilter(envelope)),
                                           filtered(run.frames, OneEuroFilter())};
  Table table{"",
              {{"time_s", "s", "since its release"},
               {"move", "-", "of the cube since the frame before, in envelopes"},
               {"thesis_mm", "mm", "from where its centre is shown to where it is: envelope"},
               {"soft_mm", "mm", "soft envelope"},
               {"euro_mm", "mm", "one-euro filter"}}};
  worst_fast = 0.0;
  for (int f = 1; f < run.frames.count(); ++f) {
    const BodyState& now = run.frames.frame(f).states[cube];
    const double move = size_of(run.frames.frame(f - 1).states[cube], now, envelope);
    std::array<double, 3> off{};  // [mm]
    for (std::size_t k = 0; k < shown.size(); ++k)
      off[k] = 1e3 * (shown[k].frame(f).states[cube].position_w - now.position_w).norm();
    table.add(run.frames.frame(f).time, move, off);
    if (move > 1.0) worst_fast = std::max(worst_fast, off[0]);
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
    table.add(f, a.exact, b.exact, c.exact, 1e3 * a.offset, 1e3 * b.offset, 1e3 * c.offset);
    const double every = std::floor(1.0 / f) + 1.0;
    const double speed = way / kStep;
    const double lag = speed / (2.0 * std::numbers::pi * (euro.cutoff + euro.gain * speed));
    for (const double one : {a.offset - (every - 1.0) * way,
                             b.offset - std::max(0.0, envelope.radius - way), c.offset - lag})
      difference = std::max(difference, std::abs(one));
  }
  return table;
}

// Chosen before the first run: a body is fast if it moved by more than a centimetre or turned by more
// than a degree, as the filter itself decides; and shown is the computed pose bit by bit.
Result follow_fast_bodies(const Parameters& settings) {
  std::vector<FastSeed> seeds;
  for (int seed = 1; seed <= settings.count("seeds"); ++seed)
    seeds.push_back(fast_seed(settings, static_cast<std::uint64_t>(seed)));
  double worst_fast = 0.0;
  const Table path = path_of_tossed_cube(worst_fast);
  double difference = 0.0;
  const Table speeds = constant_speeds(difference);
  const Ramp printed = ramp_under(EnvelopeFilter(), 0.003);
  double frames = 0.0;
  for (const FastSeed& seed : seeds) frames += seed.both.all;
  const auto share = [&](const std::string& name, FastFrames FastSeed::*scenes) {
    return ratio_of_sums(name, "-",
                         numbers_of(seeds, [&](const FastSeed& s) { return (s.*scenes).exact; }),
                         numbers_of(seeds, [&](const FastSeed& s) { return (s.*scenes).all; }));
  };
  return {{path, speeds},
          {share("share of the frames of bodies faster than the envelope in a frame which show the "
                 "computed pose",
                 &FastSeed::both),
           share("the same, tossed cubes alone", &FastSeed::tossed),
           share("the same, soft envelope", &FastSeed::soft),
           {"frames of fast bodies, of all seeds", "-", frames},
           {"largest distance from shown to computed of a tossed cube while it is fast", "mm",
            worst_fast},
           {"pop of a ramp of 3 mm a frame", "mm", 1e3 * printed.pop},
           {"frames from pop to pop of a ramp of 3 mm a frame", "-", printed.period},
           {"largest difference from closed forms at constant speed", "m", difference}}};
}

const Registered claim_5_5d_fast_figure{
    {.name = "claim_5_5d_fast",
     .parameters = {whole("seeds", 20, 1, 100, "clumps, and tossed cubes"),
                    whole("per_edge", 5, 2, 8, "cubes along each edge of the clump's grid"),
                    number("duration", 3.0, 0.5, 60.0, "s", "of a clump, from its start")},
     .quick = {"seeds=2", "per_edge=3", "duration=1"},
     .experiment = follow_fast_bodies}};

}  // namespace

}  // namespace tumble::chapters
