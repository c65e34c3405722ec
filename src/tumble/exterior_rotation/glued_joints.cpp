/// \file
/// \brief The joints of the glued technique: which there are, how they are closed, and what they carry.
#include "tumble/base/index.hpp"
#include "tumble/contact/contact_records.hpp"
#include "tumble/exterior_rotation/glued.hpp"
#include "tumble/exterior_rotation/tolerances.hpp"

#include <algorithm>
#include <utility>

namespace tumble {

void Glued::find(const World& world) {
  joints_.clear();
  if (options_.contacts == GluedContacts::stick)
    joints_ = find_joints(world, tolerance::glue_margin);
  add_made(world);
  found_for_.assign(world.ids().begin(), world.ids().end());
  try_dt_ = 0.0;
}

// Joints of the scene, behind those of touch.
void Glued::add_made(const World& world) {
  made_ = world.joints().size();
  for (const BodyJoint& joint : world.joints()) joints_.push_back(joint_of(world, joint));
}

// Adds joints of new bodies and removes those of removed bodies. Returns whether there are any, as in the
// first step; `fresh` receives the new joints.
bool Glued::join(const World& world, std::vector<Joint>& fresh) {
  const auto was_there = [&](int body) {
    return std::binary_search(found_for_.begin(), found_for_.end(), world.ids()[idx(body)]);
  };
  const bool known =
      std::equal(found_for_.begin(), found_for_.end(), world.ids().begin(), world.ids().end()) &&
      made_ == world.joints().size();
  if (known && forces_.solves() > 0) return false;
  if (known) {  // find() was called before the first step
    fresh = joints_;
    return true;
  }
  std::vector<Joint> now;
  if (options_.contacts == GluedContacts::stick)
    now = renewed_joints(joints_, found_for_, world, tolerance::glue_margin);
  joints_ = std::move(now);
  const bool new_ones = world.joints().size() > made_;
  add_made(world);
  fresh = joints_;
  std::erase_if(fresh, [&](const Joint& joint) {
    return was_there(joint.first) && was_there(joint.second) && !(joint.of_scene && new_ones);
  });
  found_for_.assign(world.ids().begin(), world.ids().end());
  try_dt_ = 0.0;
  return true;
}

// Joints of the scene are closed, and velocities are those that they permit.
void Glued::close(World& world) {
  if (made_ == 0) return;
  forces_.close(joints_, world);
  load_moving_bodies(world, moving_);
  forces_.project(moving_, joints_, world.states());
  store_moving_bodies(moving_, world);
}

void Glued::record(const World& world) {
  load_moving_bodies(world, moving_);
  record_forces_.hold(world, moving_, joints_, wrenches_);
  records_.clear();
  add_records(meeting_.impacts(), world.time(), records_);
  add_records(meeting_.contacts(), world.time(), records_);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const Joint& joint = joints_[j];
    if (joint.hold == JointHold::nothing) continue;
    const Wrench& push = record_forces_.on_second(static_cast<int>(j));
    const JointPoint held = held_point(joint, world.states());
    ContactRecord record;
    record.time = world.time();
    record.first = world.ids()[idx(joint.first)];
    record.second = world.ids()[idx(joint.second)];
    record.normal_w = world.states()[idx(joint.first)].orientation_wb * joint.normal_first_b;
    record.point_w = 0.5 * (held.first_w + held.second_w);
    record.push_w = push.force_w;
    record.is_impulse = false;
    record.state = ContactState::stick;
    // The centre of pressure: the point about which the moment has no component across the normal.
    const double normal = push.force_w.dot(record.normal_w);
    if (normal > 0.0 && !joint.of_scene)
      record.point_w += record.normal_w.cross(push.torque_w) / normal;
    records_.push_back(record);
  }
}

}  // namespace tumble
