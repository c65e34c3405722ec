/// \file
/// \brief Measuring the last second of a run.
#include "scene_quality.hpp"

#include "tumble/record/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scene_bench {
namespace {

using tumble::Vec3;
using tumble::World;

constexpr double kWindow = 1.0;       // [s] that is kept
constexpr double kSlack = 1e-6;       // [s] rounding in a sum of steps
constexpr double kFallen = 0.5;       // [-] shares of the shortest edge
constexpr double kSameHeight = 1e-6;  // [m] centres that start on one level

}  // namespace

void Recording::take_in(const World& world) {
  for (std::size_t k = start_w_.size(); k < world.states().size(); ++k)
    start_w_.push_back(world.states()[k].position_w);
}

// The window holds its first frame too, so that n steps have n differences.
void Recording::add(const World& world, double dt) {
  Frame frame;
  if (!frames_.empty()) {
    kept_ += dt;
    while (kept_ > kWindow + kSlack) {
      kept_ -= frames_[1].dt;
      std::swap(frame, frames_.front());  // its storage is used again
      frames_.pop_front();
    }
  }
  frame.dt = dt;
  frame.states.assign(world.states().begin(), world.states().end());
  frames_.push_back(std::move(frame));
}

Quality Recording::measure(const World& world) const {
  Quality out;
  const auto bodies = world.bodies();
  double top = 0.0;  // [m] height of the highest start
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (bodies[k].movable()) top = std::max(top, start_w_[k].y());
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (!bodies[k].movable()) continue;
    const Vec3 moved = world.states()[k].position_w - start_w_[k];
    out.drift = std::max(out.drift, moved.norm());
    if (moved.norm() > kFallen * bodies[k].size.minCoeff()) out.stands = false;
    if (start_w_[k].y() > top - kSameHeight) out.sag = std::max(out.sag, -moved.y());
  }

  // A copy of the world goes through the kept frames again.
  World shown = world;
  tumble::MetricsMeter meter;
  const Frame* before = nullptr;
  double sum = 0.0;
  double count = 0.0;
  for (const Frame& frame : frames_) {
    if (frame.states.size() != bodies.size()) continue;  // before a body came in
    std::copy(frame.states.begin(), frame.states.end(), shown.states().begin());
    shown.finish_step(frame.dt);
    const tumble::Metrics now = meter.measure(shown, {});
    out.overlap = std::max(out.overlap, now.deepest_overlap);
    out.chatter = now.chatter;
    for (std::size_t k = 0; before != nullptr && k < bodies.size(); ++k) {
      if (!bodies[k].movable()) continue;
      const Vec3 moved = frame.states[k].position_w - before->states[k].position_w;
      sum += moved.squaredNorm() / (frame.dt * frame.dt);
      count += 1.0;
    }
    before = &frame;
  }
  if (count > 0.0) out.speed = std::sqrt(sum / count);
  return out;
}

}  // namespace scene_bench
