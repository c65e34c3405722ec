/// \file
/// \brief A column without glue that falls, and the moments at which its joints open (footnote of thesis
///        6.2).
#pragma once

#include "tumble/exterior_rotation/glued.hpp"

#include "driver/experiment.hpp"
#include "exterior_rotation/falling_column.hpp"
#include "exterior_rotation/glued_runs.hpp"

namespace tumble::chapters {

// A moment of a fall.
struct JointMoment {
  World world;                // the bodies
  std::vector<Joint> joints;  // and their holds
};

// A change of a joint.
struct JointEvent {
  double time = 0.0;                    // [s] since the start
  int joint = 0;                        // its place; of a column 0 is the pivot, 1 the lowest area
  JointHold hold = JointHold::nothing;  // the hold from now on
  double angle = 0.0;                   // [rad] centre_angle() of all that moves, then
  JointMoment after;                    // just after it
};

// A fall with joints that push only.
struct UnilateralRun {
  World world;                     // at the end
  std::vector<Joint> joints;       // at the end
  std::vector<JointEvent> events;  // in the order of time
  int solves = 0;                  // systems of joint forces that were solved
};

// Options of a fall without glue.
// accuracy: [-] of dormand_prince
inline GluedOptions unilateral(GluedScheme scheme, GluedEvents events, double accuracy = 1e-12) {
  GluedOptions options = glued_options(scheme, PoseUpdate::separate, accuracy);
  options.joints = GluedJoints::unilateral;
  options.events = events;
  return options;
}

// Notes each event with the angle at which the bodies are just then.
class EventNotes : public Observer {
 public:
  EventNotes(const World& world, const Glued& technique) : world_(world), technique_(technique) {}

  void on_event(const Event& event) override {
    const std::span<const Joint> joints = technique_.joints();
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const bool it = event.first == world_.ids()[static_cast<std::size_t>(joints[j].first)] &&
                      event.second == world_.ids()[static_cast<std::size_t>(joints[j].second)];
      if (!it) continue;
      notes.push_back({event.time,
                       static_cast<int>(j),
                       joints[j].hold,
                       centre_angle(world_),
                       {world_, {joints.begin(), joints.end()}}});
    }
  }

  std::vector<JointEvent> notes;

 private:
  const World& world_;
  const Glued& technique_;
};

// Lets a world fall.
// end: [s] length of the fall
inline UnilateralRun run_unilateral(
    World world, const GluedOptions& options, double end, int steps,
    const std::function<void(const World&, const Glued&)>& after = {}) {
  UnilateralRun run;
  run.world = std::move(world);
  Glued technique(options);
  EventNotes notes(run.world, technique);
  technique.observe(&notes);
  technique.find(run.world);
  if (after) after(run.world, technique);
  for (int n = 0; n < steps; ++n) {
    finished(technique.step(run.world, end / steps));
    if (after) after(run.world, technique);
  }
  run.joints.assign(technique.joints().begin(), technique.joints().end());
  run.events = notes.notes;
  run.solves = technique.solves();
  return run;
}

// Distance of two worlds with the same bodies.
// Returns [m] largest distance of a corner of a movable box in the one from itself in the other
inline double farthest_corner(const World& world, const World& other) {
  double farthest = 0.0;
  for (std::size_t k = 0; k < world.bodies().size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable()) continue;
    const auto here = corners_of(box_of(body, world.states()[k]));
    const auto there = corners_of(box_of(body, other.states()[k]));
    for (std::size_t c = 0; c < here.size(); ++c)
      farthest = std::max(farthest, (here[c] - there[c]).norm());
  }
  return farthest;
}

// Where an area is pressed.
// Returns [m] centre of pressure across the column, from the edge on the pivot's side: 0 to 1 while no part
// has to pull
inline double pressed_at(const Joint& joint, const Wrench& push,
                         std::span<const BodyState> states) {
  const BodyState& lower = states[static_cast<std::size_t>(joint.first)];
  const Vec3 normal_w = lower.orientation_wb * joint.normal_first_b;
  const Vec3 point_w = held_point(joint, states).first_w +
                       normal_w.cross(push.torque_w) / push.force_w.dot(normal_w);
  // The pivot's side is that of the frame's positive x.
  return 0.5 - (lower.orientation_wb.conjugate() * (point_w - lower.position_w)).x();
}

}  // namespace tumble::chapters
