/// \file
/// \brief Joints between bodies that stick where they touch.
#include "tumble/exterior_rotation/joint.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/geometry/bounding_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace tumble {
namespace {

Vec3 to_world(const BodyState& state, const Vec3& point_b) {
  return state.position_w + state.orientation_wb * point_b;
}

Vec3 to_body(const BodyState& state, const Vec3& point_w) {
  return state.orientation_wb.conjugate() * (point_w - state.position_w);
}

// The held corners: a range of indices, counted around the area.
struct Held {
  int begin = 0;
  int count = 0;
};

Held held_corners(const Joint& joint) {
  switch (joint.hold) {
    case JointHold::area: return {0, joint.count};
    case JointHold::edge: return {joint.side, 2};
    case JointHold::corner: return {joint.side, 1};
    case JointHold::nothing: break;
  }
  return {};
}

}  // namespace

Joint joint_of(const World& world, const Contact& contact) {
  require::that(contact.count > 0, "contact without a point: expected at least one to glue");
  Joint joint{.first = contact.first, .second = contact.second, .count = contact.count};
  const BodyState& first = world.states()[idx(joint.first)];
  const BodyState& second = world.states()[idx(joint.second)];
  for (int k = 0; k < contact.count; ++k) {
    const Vec3& point_w = contact.points[idx(k)].position_w;
    joint.corners_first_b[idx(k)] = to_body(first, point_w);
    joint.corners_second_b[idx(k)] = to_body(second, point_w);
  }
  joint.normal_first_b = first.orientation_wb.conjugate() * contact.normal_w;
  joint.hold = contact.count == 1   ? JointHold::corner
               : contact.count == 2 ? JointHold::edge
                                    : JointHold::area;
  return joint;
}

Joint joint_of(const World& world, const BodyJoint& made) {
  Joint joint{.first = world.index_of(made.bodies[0]),
              .second = world.index_of(made.bodies[1]),
              .of_scene = true};
  double edge = std::numeric_limits<double>::infinity();
  for (const int body : {joint.first, joint.second})
    if (world.bodies()[idx(body)].shape == Shape::box)
      edge = std::min(edge, world.bodies()[idx(body)].size.minCoeff());
  const auto add = [&](const Vec3& first_b, const Vec3& second_b) {
    joint.corners_first_b[idx(joint.count)] = made.anchors_b[0] + 0.5 * edge * first_b;
    joint.corners_second_b[idx(joint.count)] = made.anchors_b[1] + 0.5 * edge * second_b;
    ++joint.count;
  };
  switch (made.kind) {
    case JointKind::ball:
      joint.hold = JointHold::corner;
      add(Vec3::Zero(), Vec3::Zero());
      break;
    case JointKind::hinge:
      joint.hold = JointHold::edge;
      joint.normal_first_b = made.axes_b[0];
      for (const double side : {-1.0, 1.0}) add(side * made.axes_b[0], side * made.axes_b[1]);
      break;
    case JointKind::fixed:
      joint.hold = JointHold::area;
      for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
          const Vec3 along = side * Vec3::Unit(axis);
          add(along, made.second_in_first.conjugate() * along);
        }
      break;
  }
  return joint;
}

std::vector<Joint> find_joints(const World& world, double margin) {
  require::not_negative(margin, "margin");
  double size = 0.0;  // the margin of the broad phase has to cover all pairs
  for (const BodyProperties& body : world.bodies())
    if (body.shape == Shape::box) size = std::max(size, body.size.minCoeff());
  std::vector<Bounds> bounds;
  for (std::size_t k = 0; k < world.bodies().size(); ++k)
    bounds.push_back(bounds_of(world.bodies()[k], world.states()[k], 0.5 * margin * size));
  std::vector<IndexPair> pairs;
  BoundingTree().find_pairs(bounds, pairs);
  leave_out_joined(world, pairs);
  std::vector<MovingBody> moving;
  load_moving_bodies(world, moving);
  ContactList contacts;
  std::vector<Joint> joints;
  const auto edge_of = [&](int k) {
    const BodyProperties& body = world.bodies()[idx(k)];
    return body.shape == Shape::box ? body.size.minCoeff() : size;
  };
  for (const IndexPair& pair : pairs) {  // each with its own margin
    const double reach = margin * std::min(edge_of(pair.first), edge_of(pair.second));
    gather_contacts(world, moving, {&pair, 1}, reach, {}, contacts);
    const double reach_speed =
        std::sqrt(world.gravity_w.norm() * std::min(edge_of(pair.first), edge_of(pair.second)));
    const double parting =
        tolerance::resting_speed * std::max({reach_speed, moving[idx(pair.first)].velocity_w.norm(),
                                             moving[idx(pair.second)].velocity_w.norm()});
    for (const Contact& contact : contacts) {
      const auto points = std::span(contact.points).first(idx(contact.count));
      if (std::none_of(points.begin(), points.end(),
                       [&](const ContactPoint& p) { return p.approach_speed <= parting; }))
        continue;
      joints.push_back(joint_of(world, contact));
    }
  }
  return joints;
}

std::vector<Joint> renewed_joints(std::span<const Joint> joints, std::span<const BodyId> before,
                                  const World& world, double margin) {
  std::vector<Joint> now;
  for (Joint joint : joints) {
    if (joint.of_scene) continue;
    const std::optional<int> first = world.find(before[idx(joint.first)]);
    const std::optional<int> second = world.find(before[idx(joint.second)]);
    if (!first || !second) continue;
    joint.first = *first;
    joint.second = *second;
    now.push_back(joint);
  }
  const auto is_new = [&](int body) {
    return !std::binary_search(before.begin(), before.end(), world.ids()[idx(body)]);
  };
  for (const Joint& joint : find_joints(world, margin))
    if (is_new(joint.first) || is_new(joint.second)) now.push_back(joint);
  std::sort(now.begin(), now.end(), [](const Joint& a, const Joint& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  });
  return now;
}

JointPoint corner_of(const Joint& joint, int corner, std::span<const BodyState> states) {
  const std::size_t k = idx(corner % joint.count);
  return {to_world(states[idx(joint.first)], joint.corners_first_b[k]),
          to_world(states[idx(joint.second)], joint.corners_second_b[k])};
}

JointPoint held_point(const Joint& joint, std::span<const BodyState> states) {
  const Held held = held_corners(joint);
  JointPoint mean;
  for (int k = 0; k < held.count; ++k) {
    const JointPoint corner = corner_of(joint, held.begin + k, states);
    mean.first_w += corner.first_w / held.count;
    mean.second_w += corner.second_w / held.count;
  }
  return mean;
}

JointGap gap_of(const Joint& joint, std::span<const BodyState> states) {
  const Vec3 normal_w = states[idx(joint.first)].orientation_wb * joint.normal_first_b;
  const Held held = held_corners(joint);
  JointGap gap;
  for (int k = 0; k < held.count; ++k) {
    const JointPoint corner = corner_of(joint, held.begin + k, states);
    const Vec3 away_w = corner.second_w - corner.first_w;
    const double distance = normal_w.dot(away_w);
    gap.opening = std::max(gap.opening, distance);
    gap.overlap = std::max(gap.overlap, -distance);
    gap.apart = std::max(gap.apart, away_w.norm());
  }
  return gap;
}

JointGap gap_of(std::span<const Joint> joints, std::span<const BodyState> states) {
  JointGap largest;
  for (const Joint& joint : joints) {
    const JointGap gap = gap_of(joint, states);
    largest.opening = std::max(largest.opening, gap.opening);
    largest.overlap = std::max(largest.overlap, gap.overlap);
    largest.apart = std::max(largest.apart, gap.apart);
  }
  return largest;
}

Vec3 turned_in(const Joint& joint, std::span<const BodyState> states) {
  const JointPoint held = held_point(joint, states);
  Vec3 sum_w = Vec3::Zero();
  double squares = 0.0;  // [m²]
  for (int k = 0; k < joint.count; ++k) {
    const JointPoint corner = corner_of(joint, k, states);
    const Vec3 arm_w = corner.first_w - held.first_w;
    sum_w += arm_w.cross(corner.second_w - held.second_w);
    squares += arm_w.squaredNorm();
  }
  // Arms r, turned by a small θ: the sum of r × (θ × r). Along three axes alike that is two thirds of r² θ.
  return sum_w / (joint.hold == JointHold::edge ? squares : squares * 2.0 / 3.0);
}

double opened(const Joint& joint, std::span<const BodyState> states) {
  const Vec3 normal_w = states[idx(joint.first)].orientation_wb * joint.normal_first_b;
  const JointPoint held = held_point(joint, states);
  Vec3 away_w = held.first_w - held.second_w;
  for (int k = 0; k < joint.count; ++k) {
    const JointPoint corner = corner_of(joint, k, states);
    away_w += (corner.second_w - corner.first_w) / joint.count;
  }
  return normal_w.dot(away_w);
}

}  // namespace tumble
