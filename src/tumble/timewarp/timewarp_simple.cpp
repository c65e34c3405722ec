/// \file
/// \brief The synchronised timewarp in its simple form (thesis 5.1, A.1: SIMPLESYNCTIMEWARP).
#include "tumble/timewarp/timewarp_simple.hpp"

#include "tumble/base/index.hpp"

#include <array>

namespace tumble {

TimewarpSimple::TimewarpSimple(const TimewarpOptions& options)
    : Cloned(options, SearchMethod::discrete) {}

// | symbol        | meaning                                                  | unit |
// |---------------|----------------------------------------------------------|------|
// | valid         | states known to be correct, each at its own time         |      |
// | valid_times   | those times, since the start of the frame                | s    |
// | test          | states at the end of the frame without collisions        |      |
StepReport TimewarpSimple::step(World& world, double dt) {
  frame_.begin(world, dt, observer());
  const std::span<BodyState> valid = world.states();
  std::vector<BodyState>& test = frame_.test;
  std::vector<double>& valid_times = frame_.valid_times;

  // [SIMPLESYNCTIMEWARP:1-4]
  // Every body flies to the end of the frame, ignoring all others.
  // Valid is its state at the start.
  for (int i = 0; i < world.count(); ++i) {
    test[idx(i)] = valid[idx(i)];
    frame_.integrate_forward(test[idx(i)], i, dt);
    valid_times[idx(i)] = 0.0;
  }
  // [SIMPLESYNCTIMEWARP:1-4]

  // [SIMPLESYNCTIMEWARP:5]
  // Bodies that overlap at the end have collided; the time is searched for.
  collision_heap_.reset(world.count());
  frame_.find_all_collisions(collision_heap_);
  // [SIMPLESYNCTIMEWARP:5]
  frame_.show(watcher_, nullptr, collision_heap_);

  // [SIMPLESYNCTIMEWARP:6-7]
  // The earliest of all collisions is certain: no known collision
  // can precede it.
  while (!collision_heap_.empty()) {
    const ForeseenCollision current = collision_heap_.remove_first();
    const std::array<int, 2> both = {current.pair.first, current.pair.second};
    // [SIMPLESYNCTIMEWARP:6-7]

    // [SIMPLESYNCTIMEWARP:8-12]
    // Its two bodies go to that time, both of them before the
    // collision is resolved (T1, T2). All other collisions predicted
    // for them are invalid.
    for (const int index : both) {
      if (!frame_.movable(index)) continue;
      collision_heap_.forget(index);
      frame_.integrate_forward(valid[idx(index)], index, current.time - valid_times[idx(index)]);
      valid_times[idx(index)] = current.time;
    }
    // [SIMPLESYNCTIMEWARP:8-12]

    // [SIMPLESYNCTIMEWARP:13]
    frame_.collide({&current.pair, 1}, current.time);
    // [SIMPLESYNCTIMEWARP:13]

    // [SIMPLESYNCTIMEWARP:14-18]
    // Both fly to the end of the frame again. Only then are
    // collisions predicted for them (T3), each pair searched from
    // the later of its two valid times on (T4).
    for (const int index : both) {
      test[idx(index)] = valid[idx(index)];
      frame_.integrate_forward(test[idx(index)], index, dt - valid_times[idx(index)]);
    }
    frame_.add_collisions_of(both, collision_heap_);
    // [SIMPLESYNCTIMEWARP:14-18]
    frame_.show(watcher_, &current, collision_heap_);
  }

  // [SIMPLESYNCTIMEWARP:19-21]
  // The queue is empty: the test states are valid.
  for (int i = 0; i < world.count(); ++i) {
    valid[idx(i)] = test[idx(i)];
    valid_times[idx(i)] = dt;
  }
  // [SIMPLESYNCTIMEWARP:19-21]

  // [SIMPLESYNCTIMEWARP:22-23]
  // Missed collisions have left overlap; bodies are moved apart.
  frame_.finish();
  return frame_.report;
  // [SIMPLESYNCTIMEWARP:22-23]
}

}  // namespace tumble
