/// \file
/// \brief Joints of a world.
#include "tumble/dynamics/body_joint.hpp"

#include "tumble/base/error.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/dynamics/world.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace tumble {
namespace {

constexpr std::array kKinds = {JointKind::ball, JointKind::hinge, JointKind::fixed};

// Of two bodies, the one with the smaller id first.
std::array<BodyId, 2> in_order(BodyId a, BodyId b) {
  return a < b ? std::array{a, b} : std::array{b, a};
}

}  // namespace

std::span<const JointKind> joint_kinds() { return kKinds; }

std::string_view name_of(JointKind kind) {
  switch (kind) {
    case JointKind::ball: return "ball";
    case JointKind::hinge: return "hinge";
    case JointKind::fixed: return "fixed";
  }
  return "";
}

void World::join(JointKind kind, BodyId first, BodyId second, const Vec3& anchor_w,
                 const Vec3& axis_w, std::string name) {
  require::finite(anchor_w, "anchor_w");
  require::finite(axis_w, "axis_w");
  const bool turns = kind == JointKind::hinge;
  require::that(axis_w.isZero(0.0) != turns,
                turns ? "axis_w is 0: expected the direction of the hinge's axis"
                      : "axis_w is given: expected 0, as a " + std::string(name_of(kind)) +
                            " joint has no axis");
  require::that(first != second, "a joint of a body with itself: expected two bodies");
  if (name.empty()) name = "joint" + std::to_string(joints_.size() + 1);
  BodyJoint joint{.name = std::move(name), .kind = kind};
  joint.bodies = in_order(first, second);
  bool movable = false;
  std::array<Quat, 2> turned;
  for (std::size_t side = 0; side < 2; ++side) {
    const auto k = static_cast<std::size_t>(index_of(joint.bodies[side]));
    movable = movable || bodies_[k].movable();
    turned[side] = states_[k].orientation_wb;
    const Quat back = turned[side].conjugate();
    joint.anchors_b[side] = back * Vec3(anchor_w - states_[k].position_w);
    if (turns) joint.axes_b[side] = back * axis_w.stableNormalized();
  }
  require::that(movable, joint.name + ": both bodies are immovable: expected one at least to move");
  joint.second_in_first = turned[0].conjugate() * turned[1];
  joined_.insert(std::upper_bound(joined_.begin(), joined_.end(), joint.bodies), joint.bodies);
  joints_.push_back(std::move(joint));
}

bool World::joined(BodyId a, BodyId b) const {
  return std::binary_search(joined_.begin(), joined_.end(), in_order(a, b));
}

void leave_out_joined(const World& world, std::vector<IndexPair>& pairs) {
  if (world.joints().empty()) return;
  std::erase_if(pairs, [&](const IndexPair& pair) {
    return world.joined(world.ids()[idx(pair.first)], world.ids()[idx(pair.second)]);
  });
}

void require_joints_held(const Technique& technique, const World& world) {
  if (world.joints().empty() || technique.holds_joints()) return;
  const std::size_t count = world.joints().size();
  refuse("technique " + std::string(technique.name()) +
         " does not support joints, and the scene has " + std::to_string(count) +
         ", the first called " + world.joints().front().name +
         ": choose glued (--technique glued --set contacts=collide, so that "
         "boxes collide), or leave out "
         "[[joint]]");
}

}  // namespace tumble
