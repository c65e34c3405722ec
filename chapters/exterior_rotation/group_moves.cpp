/// \file
/// \brief Ways to move bodies over a step with given velocities, written out.
#include "exterior_rotation/group_moves.hpp"

#include "tumble/math/rotation.hpp"

#include <algorithm>

namespace tumble::chapters {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// All states after the step, given where the centre of a movable body goes.
template <class Centre>
std::vector<BodyState> moved(const World& world, double dt, const Centre& centre) {
  std::vector<BodyState> states(world.states().begin(), world.states().end());
  for (std::size_t k = 0; k < states.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable()) continue;
    const Vec3 v_w = velocity(body, states[k]);
    const Vec3 omega_w = angular_velocity(body, states[k]);
    states[k].position_w = centre(states[k].position_w, v_w, omega_w);
    states[k].orientation_wb = turned(states[k].orientation_wb, omega_w, dt);
  }
  return states;
}

}  // namespace

Vec3 moved_about(const Vec3& x_w, const Vec3& v_w, const Vec3& omega_w, const Vec3& c_w,
                 double dt) {
  const Vec3 lever_w = x_w - c_w;
  return c_w + dt * (v_w - omega_w.cross(lever_w)) + rotation_from_vector(dt * omega_w) * lever_w;
}

Vec3 resting_point(const Vec3& x_w, const Vec3& v_w, const Vec3& omega_w) {
  return x_w + omega_w.cross(v_w) / omega_w.squaredNorm();
}

std::vector<BodyState> moved_in_frame(const World& world, const GroupFrame& frame, double dt) {
  const Vec3& turning_w = frame.angular_velocity_w;
  return moved(world, dt, [&](const Vec3& x_w, const Vec3& v_w, const Vec3&) -> Vec3 {
    const Vec3 lever_w = x_w - frame.centre_w;
    return x_w + dt * (v_w - turning_w.cross(lever_w)) +
           (rotation_from_vector(dt * turning_w) * lever_w - lever_w);
  });
}

std::vector<BodyState> moved_by_own_twist(const World& world, double dt) {
  return moved(world, dt, [dt](const Vec3& x_w, const Vec3& v_w, const Vec3& omega_w) -> Vec3 {
    return x_w + along_arc(dt * omega_w, dt * v_w);
  });
}

std::vector<BodyState> moved_in_tree(const World& world, std::span<const Joint> joints, double dt) {
  std::vector<BodyState> states =
      moved(world, dt,
            [dt](const Vec3& x_w, const Vec3& v_w, const Vec3&) -> Vec3 { return x_w + dt * v_w; });
  std::vector<char> placed;
  for (const BodyProperties& body : world.bodies()) placed.push_back(body.movable() ? 0 : 1);

  // From what is placed already to the bodies that stand on it: the held point, as the body below has
  // it after the step, is where the body above has it, too.
  for (bool more = true; more;) {
    more = false;
    for (const Joint& joint : joints) {
      if (joint.hold == JointHold::nothing) continue;
      if (placed[at(joint.first)] == placed[at(joint.second)]) continue;
      const bool first_below = placed[at(joint.first)] != 0;
      const int above = first_below ? joint.second : joint.first;
      const JointPoint point = held_point(joint, states);
      const Vec3 off_w =
          first_below ? Vec3(point.first_w - point.second_w) : Vec3(point.second_w - point.first_w);
      states[at(above)].position_w += off_w;
      placed[at(above)] = 1;
      more = true;
    }
  }
  return states;
}

double mismatch(std::span<const Joint> joints, std::span<const BodyState> states) {
  double largest = 0.0;
  for (const Joint& joint : joints) {
    const JointPoint point = held_point(joint, states);
    largest = std::max(largest, (point.second_w - point.first_w).norm());
  }
  return largest;
}

}  // namespace tumble::chapters
