/// \file
/// \brief SIMPLESYNCTIMEWARP, one statement for each printed line (thesis A.1).
#include "tumble/base/index.hpp"
#include "tumble/timewarp/as_printed/timewarp_as_printed.hpp"

namespace tumble {

// | symbol        | meaning                                                      | unit |
// |---------------|--------------------------------------------------------------|------|
// | valid         | validObjects: states known to be right, each at its own time |      |
// | valid_times   | validTimes: those times, since the start of the frame        | s    |
// | test          | testObjects: states at the end of the frame                  |      |
// | current       | curCollision                                                 |      |
// | both          | number of its bodies: 2, or more with T9 mended              |      |
void TimewarpAsPrinted::simple(World& world, double dt) {
  const bool own_counter = options_.repaired.has("T2");
  const bool both_first = options_.repaired.has("T1");
  const bool test_states_first = options_.repaired.has("T3");
  const std::span<BodyState> valid = world.states();
  std::vector<BodyState>& test = queries_.test;
  std::vector<double>& valid_times = queries_.valid_times;
  PrintedMoment& current = current_;

  // [SIMPLESYNCTIMEWARP:1-4]
  // All bodies fly to the end of the frame.
  for (int i = 0; i < world.count(); ++i) {
    test[idx(i)] = valid[idx(i)];
    queries_.integrate_forward(test[idx(i)], i, dt);
    valid_times[idx(i)] = 0.0;
  }
  // [SIMPLESYNCTIMEWARP:1-4]
  // [SIMPLESYNCTIMEWARP:5]
  // Collisions are searched for in their test states.
  queries_.find_all_collisions(collision_heap_);
  // [SIMPLESYNCTIMEWARP:5]

  // [SIMPLESYNCTIMEWARP:6]
  // While a collision is predicted,
  while (!collision_heap_.empty()) {
    // [SIMPLESYNCTIMEWARP:6]
    if (given_up()) break;
    // [SIMPLESYNCTIMEWARP:7]
    // take the first one.
    queries_.remove_first_collision(collision_heap_, current);
    // [SIMPLESYNCTIMEWARP:7]
    const int both = static_cast<int>(current.indices.size());
    int i = 0;
    // Erratum T2: the inner loop uses the counter i of the outer one, which
    // ends when the inner one does. Mended: each has its own.
    int own = 0;
    int& inner = own_counter ? own : i;
    // [SIMPLESYNCTIMEWARP:8-9]
    // For each of its two bodies:
    for (i = 0; i < both; ++i) {
      const int index = current.indices[idx(i)];
      // [SIMPLESYNCTIMEWARP:8-9]
      if (queries_.stamped(index)) {  // erratum T10: immovable ones, too
        // [SIMPLESYNCTIMEWARP:10-12]
        // drop all other collisions predicted for it, and move it to the
        // time of the collision.
        collision_heap_.forget(index);
        queries_.integrate_forward(valid[idx(index)], index,
                                   current.time - valid_times[idx(index)]);
        valid_times[idx(index)] = current.time;
        // [SIMPLESYNCTIMEWARP:10-12]
      }
      // Erratum T1: the rest is done for each of the two, before the other
      // one is at that time. Mended: once, when both are.
      if (both_first && i + 1 < both) continue;
      // [SIMPLESYNCTIMEWARP:13]
      // Resolve the collision of the two.
      queries_.collide_two_objects(CollidedObjects::valid, current);
      // [SIMPLESYNCTIMEWARP:13]
      // [SIMPLESYNCTIMEWARP:14-17]
      // Both fly to the end of the frame again.
      for (inner = 0; inner < both; ++inner) {
        const int moved = current.indices[idx(inner)];
        test[idx(moved)] = valid[idx(moved)];
        queries_.integrate_forward(test[idx(moved)], moved, dt - current.time);
        // [SIMPLESYNCTIMEWARP:14-17]
        // Erratum T3: at once, while the other's test state is the old one.
        if (test_states_first) continue;
        // [SIMPLESYNCTIMEWARP:18]
        // Predict new collisions of the body.
        queries_.add_collisions_for({&moved, 1}, collision_heap_);
        // [SIMPLESYNCTIMEWARP:18]
      }
      if (test_states_first) queries_.add_collisions_for(current.indices, collision_heap_);
    }
  }
  main_loop_ended();

  // [SIMPLESYNCTIMEWARP:19-21]
  // Test states become valid.
  for (int i = 0; i < world.count(); ++i) {
    valid[idx(i)] = test[idx(i)];
    valid_times[idx(i)] = dt;
  }
  // [SIMPLESYNCTIMEWARP:19-21]
  // [SIMPLESYNCTIMEWARP:22-23]
  // Move overlapping bodies apart; this may move the states that line 20
  // has made valid (T10).
  queries_.fix_interpenetration();
  return;
  // [SIMPLESYNCTIMEWARP:22-23]
}

}  // namespace tumble
