/// \file
/// \brief Filters that run live: the same frames, and how late they are seen (thesis 5.5).
#include "tumble/filtering/box_filter.hpp"

#include "filtering/live_runs.hpp"
#include "filtering/settled_run.hpp"

namespace tumble::chapters {
namespace {

// The filters, as live_filters() has them.
constexpr std::size_t kBox = 0;
constexpr std::size_t kCausal = 1;
constexpr std::size_t kEnvelope = 2;
constexpr std::size_t kSoft = 3;
constexpr std::size_t kOneEuro = 4;
constexpr std::array<const char*, 5> kNames = {"box", "causal", "envelope", "soft", "one_euro"};

constexpr int kSteadyFrames = 960;  // of a body at constant speed; the second half is measured
constexpr int kBefore = 8;          // frames that are drawn before the landing
constexpr int kAfter = 14;          // and after it
constexpr int kCreepFrames = 40;    // that are drawn

using Filters = std::vector<std::unique_ptr<PoseFilter>>;

struct Row {
  int held_back = 0;
  double slow = 0.0;     // [frames]
  double fast = 0.0;     // [frames]
  double landing = 0.0;  // [frames]
};

// Bits that differ between filtering live, or in pieces, and filtering afterwards.
struct Bits {
  BitCount live, pieces;
};

// The causal box filter against the centred one two frames before, poses alone: the momenta are those
// of each frame. For runs in which no body comes or goes.
BitCount causal_against_centred(const LiveRun& run) {
  const int late = BoxFilter(5).latency();
  Trajectory centred;
  Trajectory causal;
  const auto poses = [](const Frame& frame, double time, Trajectory& out) {
    std::vector<BodyState> states;
    for (const BodyState& state : frame.states)
      states.push_back({state.position_w, state.orientation_wb});
    out.record(Frame{time, 0, frame.ids, states});
  };
  for (int k = 2 * late; k < run.computed.count(); ++k) {
    const Frame now = run.live[kCausal].frame(k);
    poses(run.live[kBox].frame(k - late), now.time, centred);
    poses(now, now.time, causal);
  }
  return differing_bits(centred, causal);
}

// Filters a run piece by piece, 1 to 10 frames each. At each cut the filter goes on as a copy of itself, as
// a program does that saves its state.
Trajectory filtered_in_pieces(const Trajectory& run, const PoseFilter& filter, std::uint64_t seed) {
  Trajectory shown;
  const FrameSink show = [&](const Frame& frame) { shown.record(frame); };
  Random chance(seed);
  std::unique_ptr<PoseFilter> own = filter.clone();
  for (int k = 0; k < run.count();) {
    own = own->clone();
    const int end = std::min(run.count(), k + 1 + static_cast<int>(chance.below(10)));
    for (; k < end; ++k) own->add(run.frame(k), show);
  }
  own->finish(show);
  return shown;
}

LiveRun count_bits(PlayedScene scene, const Filters& filters, double duration, double removal,
                   int pieces, std::vector<Row>& rows, Bits& bits) {
  LiveRun run = play_live(scene, filters, duration, removal);
  for (std::size_t k = 0; k < filters.size(); ++k) {
    const Trajectory afterwards = filtered(run.computed, *filters[k]);
    bits.live.add(differing_bits(run.live[k], afterwards));
    for (int cut = 1; cut <= pieces; ++cut)
      bits.pieces.add(differing_bits(
          filtered_in_pieces(run.computed, *filters[k], static_cast<std::uint64_t>(cut)),
          afterwards));
    rows[k].held_back = std::max(rows[k].held_back, run.held_back[k]);
  }
  return run;
}

// The run of one cube that falls and lands flat, the ground left out.
Trajectory fall(double height, double duration) {
  PlayedScene scene(make_scene("bouncing_box", {setting("height", height), "restitution=0"}),
                    {"contact_damped"});
  Trajectory run;
  const auto record = [&] {
    const std::size_t cube = scene.index("cube");
    run.record(Frame{scene.world().time(), scene.world().steps(),
                     scene.world().ids().subspan(cube, 1),
                     scene.world().states().subspan(cube, 1)});
  };
  record();
  scene.advance(duration, [&](const StepReport&) { record(); });
  return run;
}

// The first frame in which a body is near the height at which it comes to rest, or their number.
int landing_frame(const std::vector<BodyState>& seen, double rest, double within) {
  const auto landed = std::ranges::find_if(seen, [&](const BodyState& state) {
    return std::abs(state.position_w.y() - rest) <= within;
  });
  return static_cast<int>(landed - seen.begin());
}

// One column for what is computed and one for each filter.
std::vector<Column> height_columns(const std::string& what) {
  std::vector<Column> columns = {{"frame", "-", "frame, counted from " + what},
                                 {"computed_m", "m", "as computed"}};
  for (const char* name : kNames)
    columns.push_back({std::string(name) + "_m", "m", std::string("seen live, ") + name});
  return columns;
}

Table landing_table(const Parameters& settings, const Filters& filters, std::vector<Row>& rows) {
  const double near = settings.number("near");
  const Trajectory run = fall(settings.number("height"), 2.0);
  std::vector<BodyState> computed;
  for (int k = 0; k < run.count(); ++k) computed.push_back(run.frame(k).states[0]);
  const double rest = computed.back().position_w.y();
  const int landing = landing_frame(computed, rest, near);
  std::vector<std::vector<BodyState>> seen = {computed};
  for (std::size_t k = 0; k < filters.size(); ++k) {
    seen.push_back(seen_live(run, *filters[k]));
    rows[k].landing = landing_frame(seen.back(), rest, near) - landing;
  }
  Table table{"landing", height_columns("that of the landing")};
  for (int f = std::max(0, landing - kBefore); f < std::min(landing + kAfter, run.count()); ++f) {
    std::vector<double> heights;
    for (const auto& path : seen)
      heights.push_back(path[static_cast<std::size_t>(f)].position_w.y() - rest);
    table.add(f - landing, heights);
  }
  return table;
}

Table creep_table(double speed, const Filters& filters) {
  const Trajectory run = steady_run(speed, kSteadyFrames);
  std::vector<std::vector<BodyState>> seen;
  for (const auto& filter : filters) seen.push_back(seen_live(run, *filter));
  Table table{"creep", height_columns("some time after the start")};
  const int first = kSteadyFrames - kCreepFrames;
  const double begin = run.frame(first).states[0].position_w.x();
  for (int f = first; f < kSteadyFrames; ++f) {
    std::vector<double> places = {run.frame(f).states[0].position_w.x() - begin};
    for (const auto& path : seen)
      places.push_back(path[static_cast<std::size_t>(f)].position_w.x() - begin);
    table.add(f - first, places);
  }
  return table;
}

Table filter_table(const Filters& filters, const std::vector<Row>& rows) {
  Table table{"",
              {{"filter", "-", "box, causal box, envelope, soft envelope, one-euro"},
               {"held_back", "-", "frames that wait after a step, measured"},
               {"needed", "-", "later frames that a shown frame depends on, measured"},
               {"slow", "-", "frames by which a creeping body is seen late"},
               {"fast", "-", "frames by which a fast body is seen late"},
               {"landing", "-", "frames by which a landing is seen late"}}};
  for (std::size_t k = 0; k < rows.size(); ++k)
    table.add(k + 1, rows[k].held_back, later_frames_needed(*filters[k]), rows[k].slow,
              rows[k].fast, rows[k].landing);
  return table;
}

Result measure_live(const Parameters& settings) {
  const Filters filters = live_filters();
  std::vector<Row> rows(filters.size());
  const double duration = settings.number("duration");
  const int pieces = settings.count("pieces");
  Bits bits;
  // The claim is about the thesis's two filters; all five are summed, so that none counts for less.
  const LiveRun clump =
      count_bits(PlayedScene(clump_scene(settings.count("cubes")), {"damped"}), filters, duration,
                 std::numeric_limits<double>::infinity(), pieces, rows, bits);
  const BitCount causal = causal_against_centred(clump);
  count_bits(PlayedScene(make_scene("projectile", {"rows=3", setting("appears", 0.2 * duration)}),
                         {"contact_damped"}),
             filters, duration, 0.5 * duration, pieces, rows, bits);
  for (std::size_t k = 0; k < filters.size(); ++k) {
    rows[k].slow = steady_delay(settings.number("creep"), kSteadyFrames, *filters[k]);
    rows[k].fast = steady_delay(settings.number("fast"), kSteadyFrames, *filters[k]);
  }
  Table landing = landing_table(settings, filters, rows);
  return {
      {filter_table(filters, rows), std::move(landing),
       creep_table(settings.number("creep"), filters)},
      {{"bits of the displayed frames that differ between filtering live and filtering afterwards, "
        "the delay taken off",
        "-", bits.live.different},
       {"bits compared, live and afterwards", "-", bits.live.compared},
       {"bits that differ between filtering in pieces and whole", "-", bits.pieces.different},
       {"later frames that a shown frame depends on, box of five", "-",
        later_frames_needed(*filters[kBox])},
       {"time for which frames wait at 60 Hz, box of five", "s", rows[kBox].held_back * kStep},
       {"bits of poses that differ between the causal box and the centred one two frames before",
        "-", causal.different},
       {"frames by which a creeping body is seen late, envelope", "-", rows[kEnvelope].slow},
       {"frames by which a creeping body is seen late, soft envelope", "-", rows[kSoft].slow},
       {"frames by which a landing is seen late, box of five", "-", rows[kBox].landing},
       {"frames by which a landing is seen late, one-euro", "-", rows[kOneEuro].landing}}};
}

const Registered claim_5_5e_live_figure{
    {.name = "claim_5_5e_live",
     .parameters = {whole("cubes", 5, 1, 6, "along each edge of the clump that is filtered live"),
                    number("duration", 12.0, 0.5, 60.0, "s", "of each run that is filtered live"),
                    whole("pieces", 5, 1, 100, "ways to cut each run into pieces"),
                    number("height", 1.0, 0.01, 100.0, "m", "from which the cube falls"),
                    number("creep", 0.08, 0.001, 0.5, "m/s", "speed of the body that creeps"),
                    number("fast", 3.0, 0.7, 100.0, "m/s", "speed of the body that is fast"),
                    number("near", 0.01, 1e-4, 0.1, "m",
                           "from its place at rest a cube has landed")},
     .quick = {"cubes=2", "duration=1", "pieces=2"},
     .experiment = measure_live}};

}  // namespace
}  // namespace tumble::chapters
