/// \file
/// \brief Labels that look at the whole of a run, and rules that look at its past.
#include "filtering/motion_corpus.hpp"

#include "tumble/contact/tolerances.hpp"
#include "tumble/filtering/freezing.hpp"
#include "tumble/impulse_damped/damped_numbers.hpp"

namespace tumble::chapters {
namespace {

constexpr std::size_t kHalfSecond = 30;  // [frame] half a second
constexpr std::size_t kFuture = 120;     // [frame] for which what chatters has to rest on
constexpr double kTurns = 0.2;           // [rad] in a second, of what rolls
constexpr double kSlow = 0.3;            // [m/s] of slow sliding

// A body through a run.
class Track {
 public:
  Track(const SettledRun& run, std::size_t index)
      : run_(run), index_(index), body_(run.world.bodies()[index]), edge_(body_.size.minCoeff()) {
    for (int k = 0; k < run.frames.count(); ++k)
      path_.push_back(corners_of(box_of(body_, state(static_cast<std::size_t>(k)))));
  }

  [[nodiscard]] std::size_t frames() const { return path_.size(); }

  // Whether it gets somewhere, or rocks, before and after a frame. Needs half a second on both sides.
  [[nodiscard]] bool moves(std::size_t frame, Doing scene) const {
    const double far = tolerance::resting_movement * edge_;
    if (scene == Doing::rocks)
      return largest_excursion(part(frame - kHalfSecond)) >= far &&
             largest_excursion(part(frame)) >= far;
    return way(frame - kHalfSecond) >= far && way(frame) >= far;
  }

  [[nodiscard]] Doing doing(std::size_t frame, Doing scene) const {
    if (moves(frame, scene)) {
      if (scene == Doing::rocks) return Doing::rocks;
      if (2 * touching(frame - kHalfSecond, frame) < kHalfSecond) return Doing::falls;
      const Quat turned = state(frame + kHalfSecond).orientation_wb *
                          state(frame - kHalfSecond).orientation_wb.conjugate();
      if (rotation_vector(turned).norm() >= kTurns) return Doing::rolls;
      const double longest = kSlow * static_cast<double>(kHalfSecond) * kStep;
      if (std::max(way(frame - kHalfSecond), way(frame)) > longest) return Doing::speeds;
      return scene == Doing::creeps ? Doing::creeps : Doing::slides;
    }
    // A box that slides out to a stop by itself gets no farther in the end, and does not chatter.
    if (scene != Doing::creeps || !rests(frame - kHalfSecond, frame + kFuture))
      return Doing::nothing;
    const double seen = kChatters * edge_;
    return largest_excursion(part(frame - kHalfSecond)) >= seen &&
                   largest_excursion(part(frame)) >= seen
               ? Doing::chatters
               : Doing::nothing;
  }

  // Speed of the fastest point at most, over half a second, as a share of sqrt(g L).
  [[nodiscard]] double fastest(std::size_t frame) const {
    double speed = 0.0;
    for (std::size_t k = frame - kHalfSecond; k <= frame; ++k)
      speed =
          std::max(speed, velocity(body_, state(k)).norm() +
                              angular_velocity(body_, state(k)).norm() * 0.5 * body_.size.norm());
    return speed / std::sqrt(run_.world.gravity_w.norm() * edge_);
  }

  [[nodiscard]] bool small(std::size_t frame) const {
    const DampedThresholds eps =
        thresholds_of(DampedNumbers{}, body_, run_.world.gravity_w.norm(), kStep);
    for (std::size_t k = frame - kHalfSecond; k <= frame; ++k)
      if (state(k).linear_momentum_w.cwiseAbs().maxCoeff() >= eps.slow ||
          state(k).angular_momentum_w.cwiseAbs().maxCoeff() >= eps.slow_spin)
        return false;
    return true;
  }

 private:
  [[nodiscard]] const BodyState& state(std::size_t frame) const {
    return run_.frames.frame(static_cast<int>(frame)).states[index_];
  }
  [[nodiscard]] std::span<const Corners> part(std::size_t begin) const {
    return std::span(path_).subspan(begin, kHalfSecond + 1);
  }
  [[nodiscard]] double way(std::size_t begin) const {
    return largest_displacement(path_[begin], path_[begin + kHalfSecond]);
  }
  [[nodiscard]] std::size_t touching(std::size_t begin, std::size_t end) const {
    std::size_t count = 0;
    for (std::size_t k = begin; k <= end; ++k) count += run_.touches[k][index_] != 0 ? 1 : 0;
    return count;
  }
  [[nodiscard]] bool rests(std::size_t begin, std::size_t end) const {
    if (end >= frames() || touching(begin, end) != end - begin + 1) return false;
    for (std::size_t k = begin; k + kHalfSecond <= end; k += kHalfSecond)
      if (way(k) >= tolerance::resting_movement * edge_) return false;
    return true;
  }

  const SettledRun& run_;
  std::size_t index_;
  BodyProperties body_;
  double edge_;
  std::vector<Corners> path_;
};

ChatterDetectorOptions with_window(int window) { return ChatterDetectorOptions{.window = window}; }

// P/D for the rule that asks for nothing else than contact and a limit on the speed.
double path_over_way(const ChatterDetector& detector, BodyId id, double edge, double gravity,
                     bool touches) {
  const auto history = detector.history(id);
  const double frames = detector.options().window;
  if (!history || !touches ||
      history->path > detector.options().speed * std::sqrt(gravity * edge) * frames * kStep)
    return 0.0;
  return history->displacement > 0.0 ? history->path / history->displacement
                                     : std::numeric_limits<double>::infinity();
}

}  // namespace

void add_run(const SettledRun& run, int every, Doing scene, MotionCorpus& corpus) {
  World world = run.world;
  World clock;  // starts at 0, as the run did
  clock.gravity_w = world.gravity_w;
  for (std::size_t k = 0; k < world.ids().size(); ++k)
    if (world.bodies()[k].shape == Shape::ground)
      clock.add_ground();
    else
      clock.add(world.bodies()[k], run.frames.frame(0).states[k]);

  std::vector<Track> tracks;
  for (std::size_t k = 0; k < world.ids().size(); ++k)
    if (world.bodies()[k].movable()) tracks.emplace_back(run, k);
  CalmBodies calm;
  std::vector<ChatterDetector> others;
  for (const int window : kWindows) others.emplace_back(with_window(window));
  std::vector<int> calm_for(tracks.size(), 0);

  for (std::size_t frame = 0; frame < run.touches.size(); ++frame) {
    const auto states = run.frames.frame(static_cast<int>(frame)).states;
    if (frame > 0) clock.finish_step(kStep);
    std::copy(states.begin(), states.end(), clock.states().begin());
    calm.add(clock, run.touches[frame]);
    for (ChatterDetector& other : others) other.add(clock, run.touches[frame]);
    if (frame < kHalfSecond || frame + kHalfSecond >= run.touches.size()) continue;
    std::size_t t = 0;
    for (std::size_t k = 0; k < clock.ids().size(); ++k) {
      const BodyProperties& body = clock.bodies()[k];
      if (!body.movable()) continue;
      const Track& track = tracks[t];
      const BodyId id = clock.ids()[k];
      calm_for[t] = calm.calm(id) ? calm_for[t] + 1 : 0;
      if (track.moves(frame, scene)) {
        corpus.moving += kStep;
        if (calm_for[t] == static_cast<int>(kHalfSecond)) ++corpus.false_freezes;
      }
      ++t;
      if (frame % static_cast<std::size_t>(every) != 0) continue;
      Moment moment{.doing = track.doing(frame, scene)};
      if (moment.doing == Doing::nothing) continue;
      const ChatterDetector& detector = calm.detector();
      moment.verdict = detector.motion(id);
      moment.swing_ratio = detector.swing_ratio(id);
      moment.path_over_way = path_over_way(detector, id, body.size.minCoeff(),
                                           clock.gravity_w.norm(), run.touches[frame][k] != 0);
      moment.fastest = track.fastest(frame);
      moment.small = track.small(frame);
      for (std::size_t w = 0; w < others.size(); ++w) moment.others[w] = others[w].motion(id);
      corpus.moments.push_back(moment);
    }
  }
}

}  // namespace tumble::chapters
