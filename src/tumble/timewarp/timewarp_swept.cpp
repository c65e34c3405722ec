/// \file
/// \brief The synchronised timewarp with swept volumes, which misses no collision (thesis 5.1).
#include "tumble/timewarp/timewarp_swept.hpp"

#include "tumble/base/index.hpp"

#include <algorithm>

namespace tumble {

TimewarpSwept::TimewarpSwept(const TimewarpSweptOptions& options)
    : Cloned(options, SearchMethod::conservative), options_(options) {}

// [S5.1:swept]
// As in the simple form: test states at the end of the frame, a queue, the earliest collision first,
// only its bodies rolled back. The queue is filled by a different search.
StepReport TimewarpSwept::step(World& world, double dt) {
  frame_.begin(world, dt, observer());
  const std::span<BodyState> valid = world.states();
  for (int i = 0; i < world.count(); ++i) {
    frame_.test[idx(i)] = valid[idx(i)];
    frame_.integrate_forward(frame_.test[idx(i)], i, dt);
    frame_.valid_times[idx(i)] = 0.0;
  }
  collision_heap_.reset(world.count());
  frame_.find_all_collisions(collision_heap_);
  frame_.show(watcher_, nullptr, collision_heap_);

  while (!collision_heap_.empty()) {
    take_moment(world);
    for (const int index : bodies_) {
      collision_heap_.forget(index);
      frame_.integrate_forward(valid[idx(index)], index,
                               first_.time - frame_.valid_times[idx(index)]);
      frame_.valid_times[idx(index)] = first_.time;
    }
    frame_.collide(pairs_, first_.time);
    for (const int index : bodies_) {
      frame_.test[idx(index)] = valid[idx(index)];
      frame_.integrate_forward(frame_.test[idx(index)], index, dt - first_.time);
    }
    frame_.add_collisions_of(bodies_, collision_heap_);
    frame_.show(watcher_, &first_, collision_heap_);
  }

  for (int i = 0; i < world.count(); ++i) {
    valid[idx(i)] = frame_.test[idx(i)];
    frame_.valid_times[idx(i)] = dt;
  }
  frame_.finish();
  return frame_.report;
}
// [S5.1:swept]

// Takes the earliest collision, and all predicted within a resolution of it.
void TimewarpSwept::take_moment(const World& world) {
  first_ = collision_heap_.remove_first();
  pairs_.assign(1, first_.pair);
  const double last = first_.time + options_.resolution;
  while (options_.ties == TieRule::together && !collision_heap_.empty() &&
         collision_heap_.first().time <= last)
    pairs_.push_back(collision_heap_.remove_first().pair);
  std::sort(pairs_.begin(), pairs_.end());
  list_movable(world, pairs_, bodies_);
}

}  // namespace tumble
