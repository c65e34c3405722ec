/// \file
/// \brief Events of joints without glue: opening, separation and closing.
#include "tumble/exterior_rotation/joint_events.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/exterior_rotation/tolerances.hpp"

#include <algorithm>

namespace tumble {
namespace {

// The lighter movable body of a joint, by which its forces are measured.
struct LighterBody {
  double size = 1.0;
  double mass = 1.0;
};

LighterBody lighter_body(const Joint& joint, const World& world) {
  const BodyProperties& first = world.bodies()[idx(joint.first)];
  const BodyProperties& second = world.bodies()[idx(joint.second)];
  const BodyProperties& body = first.mass < second.mass ? first : second;
  return {body.size.minCoeff(), body.mass};
}

}  // namespace

double joint_margin(std::span<const Joint> joints, const World& world,
                    std::span<const MovingBody> moving, const JointForces& forces,
                    JointChange& change) {
  const std::span<const BodyState> states = world.states();
  double least = 1.0;
  change = {};
  const auto look = [&](double value, const JointChange& then) {
    if (value >= least) return;
    least = value;
    change = then;
  };
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = joints[j];
    if (joint.hold == JointHold::nothing || joint.of_scene) continue;
    const int place = static_cast<int>(j);
    const LighterBody lighter = lighter_body(joint, world);
    const double weight = lighter.mass * std::max(world.gravity_w.norm(), 1.0);
    const Vec3 normal_w = states[idx(joint.first)].orientation_wb * joint.normal_first_b;
    const Wrench& push = forces.on_second(place);
    const JointPoint held = held_point(joint, states);
    // [S6.2:events]
    if (joint.hold == JointHold::area) {
      // Moments about the sides. Corners are in order; the centre defines the inward direction.
      for (int k = 0; k < joint.count; ++k) {
        const Vec3 from_w = corner_of(joint, k, states).second_w;
        Vec3 along_w = (corner_of(joint, k + 1, states).second_w - from_w).normalized();
        if (normal_w.cross(along_w).dot(held.second_w - from_w) < 0.0) along_w = -along_w;
        const double moment =
            ((held.second_w - from_w).cross(push.force_w) + push.torque_w).dot(along_w);
        look(moment / (weight * lighter.size), {place, JointHold::edge, k});
      }
      continue;
    }
    // An edge or a corner that would have to pull separates.
    look(push.force_w.dot(normal_w) / weight, {place, JointHold::nothing, 0});
    if (joint.hold != JointHold::edge || !joint.is_area()) continue;
    // An open area closes once the bodies overlap again and approach.
    Vec3 middle_w = Vec3::Zero();
    for (int k = 0; k < joint.count; ++k)
      middle_w += corner_of(joint, k, states).second_w / joint.count;
    const double speed = normal_w.dot(
        relative_velocity(moving[idx(joint.first)], moving[idx(joint.second)], middle_w));
    if (speed < 0.0)
      look(opened(joint, states) / lighter.size + tolerance::closed_area,
           {place, JointHold::area, 0});
    // [S6.2:events]
  }
  return least;
}

}  // namespace tumble
