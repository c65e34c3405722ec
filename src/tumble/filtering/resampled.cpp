/// \file
/// \brief A run resampled at equal times.
#include "tumble/filtering/resampled.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/filtering/tolerances.hpp"
#include "tumble/math/rotation.hpp"

#include <cmath>

namespace tumble {
namespace {

constexpr double kMostIntervals = 1e8;

BodyState between(const BodyState& a, const BodyState& b, double share) {
  BodyState out = a;
  out.position_w += share * (b.position_w - a.position_w);
  out.linear_momentum_w += share * (b.linear_momentum_w - a.linear_momentum_w);
  out.angular_momentum_w += share * (b.angular_momentum_w - a.angular_momentum_w);
  out.orientation_wb = rotation_between(a.orientation_wb, b.orientation_wb, share);
  return out;
}

// Interpolates the bodies that both frames have.
class Mixer {
 public:
  Frame mix(const Frame& a, const Frame& b, double time) {
    const double share = (time - a.time) / (b.time - a.time);
    ids_.clear();
    states_.clear();
    std::size_t other = 0;
    for (std::size_t k = 0; k < a.ids.size(); ++k) {
      while (other < b.ids.size() && b.ids[other] < a.ids[k]) ++other;
      if (other == b.ids.size() || b.ids[other] != a.ids[k]) continue;
      ids_.push_back(a.ids[k]);
      states_.push_back(between(a.states[k], b.states[other], share));
    }
    return Frame{time, a.step, ids_, states_};
  }

 private:
  std::vector<BodyId> ids_;
  std::vector<BodyState> states_;
};

void require_in_order(const Trajectory& run) {
  for (int k = 0; k < run.count(); ++k) {
    require::finite(run.frame(k).time, "time of a frame");
    if (k > 0 && !(run.frame(k).time > run.frame(k - 1).time))
      require::that(false, "frame " + std::to_string(k) + " at " +
                               shortest_text(run.frame(k).time) + " s: expected a time after " +
                               shortest_text(run.frame(k - 1).time) +
                               " s, that of the frame before");
    for (std::size_t b = 0; b < run.frame(k).states.size(); ++b)
      if (!is_finite(run.frame(k).states[b]))
        require::that(false, "frame " + std::to_string(k) + " at " +
                                 shortest_text(run.frame(k).time) + " s, body with id " +
                                 std::to_string(number_of(run.frame(k).ids[b])) +
                                 ": its state is not finite. Resample the frames before it");
  }
}

}  // namespace

Trajectory resampled(const Trajectory& run, double interval) {
  require::positive(interval, "interval of resampled()");
  require_in_order(run);
  Trajectory out;
  if (run.count() == 0) return out;
  const double first = run.frame(0).time;
  const double near = tolerance::on_the_grid * interval;
  const double intervals = (run.frame(run.count() - 1).time - first + near) / interval;
  require::that(intervals < kMostIntervals, "interval of resampled() = " + shortest_text(interval) +
                                                " s: expected fewer than 1e8 frames");
  Mixer mixer;
  int at = 0;  // the last frame that is not after the time
  for (int k = 0; static_cast<double>(k) <= intervals; ++k) {
    const double time = first + static_cast<double>(k) * interval;
    while (at + 1 < run.count() && run.frame(at + 1).time <= time + near) ++at;
    const Frame frame = run.frame(at);
    if (time - frame.time <= near) {
      out.record(frame);
    } else if (at + 1 < run.count()) {
      out.record(mixer.mix(frame, run.frame(at + 1), time));
    }
  }
  return out;
}

}  // namespace tumble
