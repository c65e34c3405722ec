/// \file
/// \brief A column without glue that falls, and the moments at which its joints open.
#include "exterior_rotation/unilateral_run.hpp"

#include "driver/finished.hpp"
#include "exterior_rotation/falling_column.hpp"
#include "exterior_rotation/glued_runs.hpp"

namespace tumble::chapters {
namespace {

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

}  // namespace

GluedOptions unilateral(GluedScheme scheme, GluedEvents events, double accuracy) {
  GluedOptions options = glued_options(scheme, PoseUpdate::separate, accuracy);
  options.joints = GluedJoints::unilateral;
  options.events = events;
  return options;
}

UnilateralRun run_unilateral(World world, const GluedOptions& options, double end, int steps,
                             const std::function<void(const World&, const Glued&)>& after) {
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

double farthest_corner(const World& world, const World& other) {
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

double pressed_at(const Joint& joint, const Wrench& push, std::span<const BodyState> states) {
  const BodyState& lower = states[static_cast<std::size_t>(joint.first)];
  const Vec3 normal_w = lower.orientation_wb * joint.normal_first_b;
  const Vec3 point_w = held_point(joint, states).first_w +
                       normal_w.cross(push.torque_w) / push.force_w.dot(normal_w);
  // The pivot's side is that of the frame's positive x.
  return 0.5 - (lower.orientation_wb.conjugate() * (point_w - lower.position_w)).x();
}

}  // namespace tumble::chapters
