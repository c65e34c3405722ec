/// \file
/// \brief Running filters live, and comparing frames bit by bit.
#include "filtering/live_runs.hpp"

#include "tumble/filtering/filters.hpp"

#include <bit>

namespace tumble::chapters {
namespace {

constexpr int kMoved = 30;         // the frame whose pose is changed
constexpr int kMovedFrames = 61;   // of the run around it
constexpr double kMovedBy = 1e-3;  // [m]
constexpr double kFast = 3.0;      // [m/s] five envelopes a frame, so that no filter stands still

using Words = std::vector<std::uint64_t>;

void add_words(const BodyState& state, Words& words) {
  const Quat& q = state.orientation_wb;
  for (const double value : {q.w(), q.x(), q.y(), q.z()})
    words.push_back(std::bit_cast<std::uint64_t>(value));
  for (const Vec3& v : {state.position_w, state.linear_momentum_w, state.angular_momentum_w})
    for (int k = 0; k < 3; ++k) words.push_back(std::bit_cast<std::uint64_t>(v[k]));
}

Words words_of(const Frame& frame) {
  Words words = {std::bit_cast<std::uint64_t>(frame.time), static_cast<std::uint64_t>(frame.step)};
  for (std::size_t k = 0; k < frame.ids.size(); ++k) {
    words.push_back(number_of(frame.ids[k]));
    add_words(frame.states[k], words);
  }
  return words;
}

// Takes away the second body that moves.
void remove_one(World& world) {
  int movable = 0;
  for (std::size_t k = 0; k < world.bodies().size(); ++k)
    if (world.bodies()[k].movable() && ++movable == 2) return world.remove(world.ids()[k]);
}

}  // namespace

std::vector<std::unique_ptr<PoseFilter>> live_filters() {
  std::vector<std::unique_ptr<PoseFilter>> filters;
  for (const char* text : {"box:5", "box:5,causal", "envelope", "soft_envelope", "one_euro"})
    filters.push_back(filter_of(text));
  return filters;
}

void BitCount::add(const BitCount& other) {
  different += other.different;
  compared += other.compared;
}

BitCount differing_bits(const Trajectory& a, const Trajectory& b) {
  constexpr std::int64_t bits = 64;
  BitCount out;
  for (int f = 0; f < std::max(a.count(), b.count()); ++f) {
    const Words first = f < a.count() ? words_of(a.frame(f)) : Words();
    const Words second = f < b.count() ? words_of(b.frame(f)) : Words();
    const std::size_t both = std::min(first.size(), second.size());
    const std::size_t all = std::max(first.size(), second.size());
    for (std::size_t k = 0; k < both; ++k) out.different += std::popcount(first[k] ^ second[k]);
    out.different += bits * static_cast<std::int64_t>(all - both);
    out.compared += bits * static_cast<std::int64_t>(all);
  }
  return out;
}

LiveRun play_live(PlayedScene& played, const std::vector<std::unique_ptr<PoseFilter>>& filters,
                  double duration, double removal) {
  LiveRun run;
  std::vector<FilteringObserver> viewers;
  for (const auto& filter : filters) viewers.emplace_back(played.world(), *filter);
  run.computed.record(played.world());
  run.held_back.assign(filters.size(), 0);
  played.advance(duration, [&](const StepReport& report) {
    if (played.world().time() > removal) {
      remove_one(played.world());
      removal = std::numeric_limits<double>::infinity();
    }
    run.computed.record(played.world());
    for (std::size_t k = 0; k < viewers.size(); ++k) {
      viewers[k].on_step(played.world(), report);
      run.held_back[k] =
          std::max(run.held_back[k], run.computed.count() - viewers[k].shown().count());
    }
  });
  for (FilteringObserver& viewer : viewers) {
    viewer.finish();
    run.live.push_back(viewer.shown());
  }
  return run;
}

std::vector<BodyState> seen_live(const Trajectory& run, const PoseFilter& filter) {
  std::vector<BodyState> seen;
  BodyState newest = run.frame(0).states.front();
  const std::unique_ptr<PoseFilter> own = filter.clone();
  for (int k = 0; k < run.count(); ++k) {
    own->add(run.frame(k), [&](const Frame& frame) { newest = frame.states.front(); });
    seen.push_back(newest);
  }
  return seen;
}

Trajectory steady_run(double speed, int frames) {
  Trajectory run;
  const std::array<BodyId, 1> ids = {BodyId{0}};
  std::array<BodyState, 1> states;
  for (int k = 0; k < frames; ++k) {
    const double time = k * kStep;
    states[0].position_w.x() = speed * time;
    run.record(Frame{time, k, ids, states});
  }
  return run;
}

double steady_delay(double speed, int frames, const PoseFilter& filter) {
  const Trajectory run = steady_run(speed, frames);
  const std::vector<BodyState> seen = seen_live(run, filter);
  double sum = 0.0;
  for (int k = frames / 2; k < frames; ++k)
    sum += (run.frame(k).states[0].position_w - seen[static_cast<std::size_t>(k)].position_w).x();
  return sum / ((frames - frames / 2) * speed * kStep);
}

int later_frames_needed(const PoseFilter& filter) {
  const Trajectory run = steady_run(kFast, kMovedFrames);
  Trajectory moved;
  for (int k = 0; k < run.count(); ++k) {
    const Frame frame = run.frame(k);
    std::array<BodyState, 1> states = {frame.states[0]};
    if (k == kMoved) states[0].position_w.y() += kMovedBy;
    moved.record(Frame{frame.time, frame.step, frame.ids, states});
  }
  const Trajectory shown = filtered(run, filter);
  const Trajectory shown_moved = filtered(moved, filter);
  for (int k = 0; k < kMoved; ++k)
    if (!(shown.frame(k).states[0] == shown_moved.frame(k).states[0])) return kMoved - k;
  return 0;
}

}  // namespace tumble::chapters
