/// \file
/// \brief One measure of how well an engine holds a scene, from poses alone.
#pragma once

#include "tumble/dynamics/world.hpp"
#include "tumble/record/chatter.hpp"

#include <deque>
#include <vector>

namespace scene_bench {

// What the last second of a run looks like.
struct Quality {
  double overlap = 0.0;     // [m] deepest, over all pairs, the ground too, and all steps
  double speed = 0.0;       // [m/s] root mean square over bodies and steps, from pose to pose
  double drift = 0.0;       // [m] largest distance of a centre from its start, at the end
  double sag = 0.0;         // [m] how far the highest bodies of the start sank at most, at the end
  tumble::Chatter chatter;  // over the last half second
  bool stands = true;       // no box is further than half its shortest edge from its start
};

// Keeps the poses of the last second of a run, to be measured after it.
class Recording {
 public:
  // Takes in new bodies: where they are now is their start.
  void take_in(const tumble::World& world);

  // Keeps a copy of the poses after a step.
  // dt: [s] the step
  void add(const tumble::World& world, double dt);

  // Measures what was kept.
  //
  // Overlap and chatter are those of record/metrics.hpp: the least translation over the 15 axes
  // that parts two boxes, the depth of the lowest corner under the ground, and the way of the
  // corners of bodies that rest.
  [[nodiscard]] Quality measure(const tumble::World& world) const;

 private:
  struct Frame {
    double dt = 0.0;  // [s] since the frame before
    std::vector<tumble::BodyState> states;
  };
  std::vector<tumble::Vec3> start_w_;  // [m] centres, by index
  std::deque<Frame> frames_;           // ascending in time
  double kept_ = 0.0;                  // [s] from the first frame to the last
};

}  // namespace scene_bench
