/// \file
/// \brief The synchronised timewarp that also tests neighbours (thesis 5.1, A.1: SAFERSYNCTIMEWARP).
#include "tumble/timewarp/timewarp_safer.hpp"

#include "tumble/base/index.hpp"

#include <array>

namespace tumble {

TimewarpSafer::TimewarpSafer(const TimewarpOptions& options)
    : Cloned(options, SearchMethod::discrete) {}

// | symbol        | meaning                                                  | unit |
// |---------------|----------------------------------------------------------|------|
// | valid         | states known to be correct, each at its own time         |      |
// | valid_times   | those times, since the start of the frame                | s    |
// | test          | states at the end of the frame without collisions;       |      |
// |               | those near a collision: temporarily at its time          |      |
StepReport TimewarpSafer::step(World& world, double dt) {
  frame_.begin(world, dt, observer());
  const std::span<BodyState> valid = world.states();
  std::vector<BodyState>& test = frame_.test;
  std::vector<double>& valid_times = frame_.valid_times;
  // Flies a body from its valid state to a time of the frame.
  const auto test_at = [&](int index, double time) {
    test[idx(index)] = valid[idx(index)];
    frame_.integrate_forward(test[idx(index)], index, time - valid_times[idx(index)]);
  };

  // [SAFERSYNCTIMEWARP:1-4]
  // Every body flies to the end of the frame, ignoring all others.
  for (int i = 0; i < world.count(); ++i) {
    valid_times[idx(i)] = 0.0;
    test_at(i, dt);
  }
  // [SAFERSYNCTIMEWARP:1-4]

  // [SAFERSYNCTIMEWARP:5-7]
  // Bodies that overlap at the end have collided; the earliest first.
  collision_heap_.reset(world.count());
  frame_.find_all_collisions(collision_heap_);
  frame_.show(watcher_, nullptr, collision_heap_);
  while (!collision_heap_.empty()) {
    const ForeseenCollision current = collision_heap_.remove_first();
    // [SAFERSYNCTIMEWARP:5-7]

    // [SAFERSYNCTIMEWARP:8-13]
    // Every body that may have touched one of the two by then, the
    // two included, flies to that time. Do some of them overlap
    // there, other than the two themselves (F6)?
    const std::span<const int> near = frame_.find_near(current);
    for (const int index : near) test_at(index, current.time);
    const std::optional<ForeseenCollision> earlier = frame_.first_of_group(near, current);
    // [SAFERSYNCTIMEWARP:8-13]

    // [SAFERSYNCTIMEWARP:21-23]
    // In any case (F5) they get back their test states at the end
    // of the frame (F3, F4).
    for (const int index : near) test_at(index, dt);
    // [SAFERSYNCTIMEWARP:21-23]

    // [SAFERSYNCTIMEWARP:14-16]
    // An earlier collision comes first. The present one returns to
    // the queue: it is invalid only if one of its bodies changes (F5).
    if (earlier) {
      collision_heap_.insert(*earlier);
      collision_heap_.insert(current);
      ++frame_.report.restarts;
      continue;
    }
    // [SAFERSYNCTIMEWARP:14-16]

    // [SAFERSYNCTIMEWARP:17-20]
    // No earlier one: all other collisions predicted for the two are
    // invalid, and their valid states become those at the time of
    // this collision (F1, F2).
    const std::array<int, 2> both = {current.pair.first, current.pair.second};
    for (const int index : both) {
      if (!frame_.movable(index)) continue;
      collision_heap_.forget(index);
      frame_.integrate_forward(valid[idx(index)], index, current.time - valid_times[idx(index)]);
      valid_times[idx(index)] = current.time;
    }
    // [SAFERSYNCTIMEWARP:17-20]

    // [SAFERSYNCTIMEWARP:24]
    frame_.collide({&current.pair, 1}, current.time);
    // [SAFERSYNCTIMEWARP:24]

    // [SAFERSYNCTIMEWARP:25-29]
    // Both fly to the end of the frame again; then collisions are
    // predicted for them.
    for (const int index : both) test_at(index, dt);
    frame_.add_collisions_of(both, collision_heap_);
    // [SAFERSYNCTIMEWARP:25-29]
    frame_.show(watcher_, &current, collision_heap_);
  }

  // [SAFERSYNCTIMEWARP:30-32]
  // The queue is empty: the test states are valid.
  for (int i = 0; i < world.count(); ++i) {
    valid[idx(i)] = test[idx(i)];
    valid_times[idx(i)] = dt;
  }
  // [SAFERSYNCTIMEWARP:30-32]

  // [SAFERSYNCTIMEWARP:33-34]
  // Missed collisions have left overlap; bodies are moved apart.
  frame_.finish();
  return frame_.report;
  // [SAFERSYNCTIMEWARP:33-34]
}

}  // namespace tumble
