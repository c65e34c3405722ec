/// \file
/// \brief SAFERSYNCTIMEWARP, one statement for each printed line (thesis A.1).
#include "tumble/base/index.hpp"
#include "tumble/timewarp/as_printed/timewarp_as_printed.hpp"

#include <algorithm>

namespace tumble {

// | symbol        | meaning                                                      | unit |
// |---------------|--------------------------------------------------------------|------|
// | valid         | validObjects: states known to be right                       |      |
// | valid_times   | validTimes: their times, since the start of the frame        | s    |
// | test          | testObjects: states at the end of the frame, or of line 12   |      |
// | current       | curCollision                                                 |      |
// | near          | nearIndices                                                  |      |
// | both          | number of bodies in `current`: 2, or more with T9 mended     |      |
void TimewarpAsPrinted::safer(World& world, double dt) {
  const TimewarpErrata& repaired = options_.repaired;
  const bool test_states_first = repaired.has("T3");
  const bool collides_valid = repaired.has("F1");
  const bool advances_times = repaired.has("F2");
  const bool each_neighbour = repaired.has("F3");
  const bool to_the_end = repaired.has("F4");
  const bool nothing_lost = repaired.has("F5");
  const std::span<BodyState> valid = world.states();
  std::vector<BodyState>& test = queries_.test;
  std::vector<double>& valid_times = queries_.valid_times;
  PrintedMoment& current = current_;
  std::vector<int> near;
  std::vector<BodyState> scratch;

  // [SAFERSYNCTIMEWARP:1-4]
  // All bodies fly to the end of the frame.
  for (int i = 0; i < world.count(); ++i) {
    test[idx(i)] = valid[idx(i)];
    queries_.integrate_forward(test[idx(i)], i, dt);
    valid_times[idx(i)] = 0.0;
  }
  // [SAFERSYNCTIMEWARP:1-4]
  // [SAFERSYNCTIMEWARP:5]
  // Collisions are searched for in their test states.
  queries_.find_all_collisions(collision_heap_);
  // [SAFERSYNCTIMEWARP:5]

  // [SAFERSYNCTIMEWARP:6]
  // While a collision is predicted,
  while (!collision_heap_.empty()) {
    // [SAFERSYNCTIMEWARP:6]
    if (given_up()) break;
    // [SAFERSYNCTIMEWARP:7-8]
    // take the first one, and find the near bodies.
    queries_.remove_first_collision(collision_heap_, current);
    queries_.find_near_objects(current, near);
    // [SAFERSYNCTIMEWARP:7-8]
    const int both = static_cast<int>(current.indices.size());
    if (nothing_lost) scratch = test;
    // [SAFERSYNCTIMEWARP:9-12]
    // They fly to that time.
    for (std::size_t i = 0; i < near.size(); ++i) {
      const int index = near[i];
      test[idx(index)] = valid[idx(index)];
      queries_.integrate_forward(test[idx(index)], index, current.time - valid_times[idx(index)]);
    }
    // [SAFERSYNCTIMEWARP:9-12]
    // [SAFERSYNCTIMEWARP:13-14]
    // Has one of them collided by then?
    const std::optional<ForeseenCollision> earlier =
        queries_.find_collisions_for_group(near, current);
    if (earlier) {
      // [SAFERSYNCTIMEWARP:13-14]
      // [SAFERSYNCTIMEWARP:15]
      // Then that collision comes next.
      collision_heap_.insert(*earlier);
      // [SAFERSYNCTIMEWARP:15]
      ++queries_.report.restarts;
      // Erratum F5: the present collision and the test states are lost.
      // Mended: both are put back.
      if (nothing_lost) {
        for (const IndexPair& pair : current.pairs) collision_heap_.insert({current.time, pair});
        for (const int index : near) test[idx(index)] = scratch[idx(index)];
      }
      // [SAFERSYNCTIMEWARP:16]
      // If not:
    } else {
      // [SAFERSYNCTIMEWARP:16]
      int index = 0;
      // [SAFERSYNCTIMEWARP:17-19]
      // the two are removed from the neighbours, ...
      for (int i = 0; i < both; ++i) {
        index = current.indices[idx(i)];
        near.erase(std::remove(near.begin(), near.end(), index), near.end());
        // [SAFERSYNCTIMEWARP:17-19]
        if (!queries_.stamped(index)) continue;  // erratum T10 mended
        // [SAFERSYNCTIMEWARP:20]
        // ... and all other collisions predicted for them are dropped.
        collision_heap_.forget(index);
        // [SAFERSYNCTIMEWARP:20]
        // Erratum F1 mended: its valid state goes to the time of the
        // collision. F2: so does its valid time.
        if (collides_valid)
          queries_.integrate_forward(valid[idx(index)], index,
                                     current.time - valid_times[idx(index)]);
        if (advances_times) valid_times[idx(index)] = current.time;
      }
      // [SAFERSYNCTIMEWARP:21]
      // For each neighbour
      for (std::size_t i = 0; i < near.size(); ++i) {
        // [SAFERSYNCTIMEWARP:21]
        // Erratum F3: the index of line 18. Mended: the neighbour's.
        if (each_neighbour) index = near[i];
        // Erratum F4: to the collision. Mended: to the end of the frame.
        const double until = to_the_end ? dt : current.time;
        // [SAFERSYNCTIMEWARP:22-23]
        // a body flies, from its valid state.
        test[idx(index)] = valid[idx(index)];
        queries_.integrate_forward(test[idx(index)], index, until - valid_times[idx(index)]);
        // [SAFERSYNCTIMEWARP:22-23]
      }
      // Erratum F1: the collided test states are overwritten by line 27.
      const CollidedObjects whose = collides_valid ? CollidedObjects::valid : CollidedObjects::test;
      // [SAFERSYNCTIMEWARP:24]
      // Resolve the collision of the two.
      queries_.collide_two_objects(whose, current);
      // [SAFERSYNCTIMEWARP:24]
      // [SAFERSYNCTIMEWARP:25-28]
      // Both fly to the end of the frame again.
      for (int i = 0; i < both; ++i) {
        const int moved = current.indices[idx(i)];
        test[idx(moved)] = valid[idx(moved)];
        queries_.integrate_forward(test[idx(moved)], moved, dt - current.time);
        // [SAFERSYNCTIMEWARP:25-28]
        // Erratum T3: at once, while the other's test state is the old one.
        if (test_states_first) continue;
        // [SAFERSYNCTIMEWARP:29]
        // Predict new collisions of the body.
        queries_.add_collisions_for({&moved, 1}, collision_heap_);
        // [SAFERSYNCTIMEWARP:29]
      }
      if (test_states_first) queries_.add_collisions_for(current.indices, collision_heap_);
    }
  }
  main_loop_ended();

  // [SAFERSYNCTIMEWARP:30-32]
  // Test states become valid.
  for (int i = 0; i < world.count(); ++i) {
    valid[idx(i)] = test[idx(i)];
    valid_times[idx(i)] = dt;
  }
  // [SAFERSYNCTIMEWARP:30-32]
  // [SAFERSYNCTIMEWARP:33-34]
  // Move overlapping bodies apart.
  queries_.fix_interpenetration();
  return;
  // [SAFERSYNCTIMEWARP:33-34]
}

}  // namespace tumble
