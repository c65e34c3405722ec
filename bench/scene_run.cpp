/// \file
/// \brief Making and timing the steps of a run, and measuring its last second.
#include "scene_run.hpp"

#include "tumble/record/metrics.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <exception>
#include <utility>

namespace scene_bench {
namespace {

constexpr std::size_t kWarmSteps = 10;  // not counted: storage grows, caches fill

// The value that a share of the values does not exceed; 0 without values.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::ranges::sort(values);
  const double place = std::ceil(share * static_cast<double>(values.size())) - 1.0;
  return values[static_cast<std::size_t>(std::max(place, 0.0))];
}

double median(const std::vector<double>& values) { return quantile(values, 0.5); }

// [s] Time that the processor has worked for this program, all threads together.
double worked() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// [s] The time that a call takes. Of two clocks the smaller one counts: the clock on the wall runs
// on while other programs have the processor, and reading the processor's clock takes half a
// microsecond itself.
template <typename Call>
double time_of(Call call) {
  const double before = worked();
  const auto start = std::chrono::steady_clock::now();
  call();
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  return std::min(passed.count(), worked() - before);
}

}  // namespace

Run::Run(const EngineChoice& choice, const SceneChoice& scene, double budget)
    : name_(choice.name),
      substeps_(choice.substeps),
      scene_(scene),
      budget_(budget),
      world_(build_world(scene.scene)),
      engine_(choice.make(world_, scene.sleeping)),
      wanted_(static_cast<int>(std::lround(scene.seconds / kStep))) {}

// The clock runs while the engine works and stands still while poses are copied.
void Run::step() {
  update_boxes(scene_.scene, entered_, world_.time(), world_);
  entered_ = world_.time();
  engine_->take_in(world_);
  recording_.take_in(world_);
  const double dt = kStep / substeps_;
  double took = 0.0;  // [s]
  for (int k = 0; k < substeps_; ++k) {
    took += time_of([&] { engine_->advance(world_, dt); });
    if (!engine_->write_back(world_, dt)) {
      finite_ = false;
      end_ = "a pose is not finite";
      return;
    }
    recording_.add(world_, dt);
  }
  total_ += took;
  ms_.push_back(1e3 * took);
  awake_.push_back(engine_->asleep(world_) == 0 ? 1 : 0);
  if (engine_->failed()) end_ = engine_->note();
}

bool Run::advance(int steps) {
  const auto more = [this] { return end_.empty() && static_cast<int>(ms_.size()) < wanted_; };
  try {
    for (int k = 0; k < steps && more(); ++k) {
      step();
      if (total_ > budget_ && more()) end_ = "the time for a run is used up";
    }
  } catch (const std::exception& error) {
    end_ = error.what();
  }
  return more();
}

Outcome Run::outcome() const {
  Outcome out;
  out.engine = name_;
  out.steps = static_cast<int>(ms_.size());
  out.wanted = wanted_;
  out.boxes = static_cast<int>(scene_.scene.boxes.size());
  const std::size_t first = ms_.size() > kWarmSteps ? kWarmSteps : 0;
  std::vector<double> all;
  std::vector<double> awake;
  for (std::size_t k = first; k < ms_.size(); ++k) {
    all.push_back(ms_[k]);
    if (awake_[k] != 0) awake.push_back(ms_[k]);
  }
  const auto second = std::min(ms_.size(), static_cast<std::size_t>(std::lround(1.0 / kStep)));
  out.median_ms = median(all);
  out.p99_ms = quantile(all, 0.99);
  out.total_s = total_;
  out.awake_ms = median(awake);
  out.last_second_ms =
      median(std::vector<double>(ms_.end() - static_cast<std::ptrdiff_t>(second), ms_.end()));
  out.asleep = engine_->asleep(world_);
  out.finite = finite_ && !ms_.empty();
  if (out.finite) out.quality = recording_.measure(world_);
  out.note = end_.empty() ? engine_->note() : end_;
  return out;
}

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
