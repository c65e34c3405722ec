/// \file
/// \brief A row of glued boxes.
#include "tumble/fracture/breaking_row.hpp"

#include "tumble/base/error.hpp"
#include "tumble/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace tumble {

BreakingRow::BreakingRow(World& world, const RowOptions& options, const Vec3& position_w,
                         const Vec3& velocity_w)
    : options_(options) {
  require::that(options.boxes >= 2,
                "boxes = " + std::to_string(options.boxes) + ": give at least 2");
  require::positive(options.density, "density [kg/m3]");
  require::positive(options.strength, "strength [Pa]");
  box_size_ = options.size;
  box_size_.x() /= options.boxes;
  BodyState state{.position_w = position_w,
                  .linear_momentum_w = options.density * options.size.prod() * velocity_w};
  pieces_.push_back({add(world, options.boxes, state), 0, options.boxes});
}

BodyId BreakingRow::add(World& world, int count, const BodyState& state) const {
  const Vec3 size(count * box_size_.x(), box_size_.y(), box_size_.z());
  return world.add(box_properties(size, options_.density * size.prod()), state);
}

void BreakingRow::push(World& world, const Vec3& impulse_w, double along) {
  const double at = along * options_.boxes;
  for (const Piece& piece : pieces_) {
    if (at > piece.first + piece.count) continue;
    const BodyState& state = world.states()[idx(world.index_of(piece.body))];
    const double x = (at - piece.first - 0.5 * piece.count) * box_size_.x();
    const Vec3 arm_b(x, 0.0, 0.0);
    world.push(piece.body, impulse_w, state.position_w + state.orientation_wb * arm_b);
    pushes_.push_back({piece.body, impulse_w, arm_b});
    return;
  }
}

// Forces on each box: gravity, pushes, and what its turning takes. Joints hold all six degrees of freedom, so
// the accelerations are those of the piece, and the multipliers what the joints carry.
void BreakingRow::find_loads(const World& world, const Piece& piece, double dt) {
  const std::size_t index = idx(world.index_of(piece.body));
  const BodyState& state = world.states()[index];
  const Vec3 spin_w = angular_velocity(world.bodies()[index], state);
  const Mat3 axes_w = state.orientation_wb.toRotationMatrix();
  const Vec3 along_w = box_size_.x() * axes_w.col(0);
  const BodyProperties box = box_properties(box_size_, options_.density * box_size_.prod());
  std::vector<MovingBody> boxes;
  std::vector<Vec6> forces;
  for (int k = 0; k < piece.count; ++k) {
    BodyState one = state;
    one.position_w += (k + 0.5 - 0.5 * piece.count) * along_w;
    boxes.push_back(moving_body_of(box, one));
    const Vec3 turning_w = angular_momentum(box, state.orientation_wb, spin_w);
    Vec6 force;
    force << box.mass * world.gravity_w, -spin_w.cross(turning_w);
    forces.push_back(force);
  }
  for (const Push& push : pushes_) {
    if (push.body != piece.body) continue;
    const double at = push.arm_b.x() / box_size_.x() + 0.5 * piece.count;
    const int k = std::clamp(static_cast<int>(std::floor(at)), 0, piece.count - 1);
    Vec3 arm_b = push.arm_b;  // from the centre of its box
    arm_b.x() -= (k + 0.5 - 0.5 * piece.count) * box_size_.x();
    forces[idx(k)].head<3>() += push.impulse_w / dt;
    forces[idx(k)].tail<3>() += (state.orientation_wb * arm_b).cross(push.impulse_w) / dt;
  }
  std::vector<JointRows> joints;
  std::vector<Vec6> apart;
  for (int k = 0; k + 1 < piece.count; ++k) {
    JointRows joint{.first = k, .second = k + 1, .count = 6};
    joint.on_first << -Mat3::Identity(), skew(0.5 * along_w), Mat3::Zero(), -Mat3::Identity();
    joint.on_second << Mat3::Identity(), skew(0.5 * along_w), Mat3::Zero(), Mat3::Identity();
    joints.push_back(joint);
    Vec6 turning;  // what centripetal accelerations of the two sides differ by
    turning << -spin_w.cross(spin_w.cross(along_w)), Vec3::Zero();
    apart.push_back(turning);
  }
  tree_.arrange(boxes, joints);
  require::that(tree_.factor(boxes, joints), "joints of a row depend on one another");
  tree_.solve(forces, apart);
  joints_solved_ += piece.count - 1;
  const double area = box_size_.y() * box_size_.z();
  for (int k = 0; k + 1 < piece.count; ++k) {
    JointLoad load{.joint = piece.first + k,
                   .force_b = axes_w.transpose() * apart[idx(k)].head<3>(),
                   .torque_b = axes_w.transpose() * apart[idx(k)].tail<3>()};
    if (options_.rule == RowRule::force) {
      load.share = load.force_b.norm() / (area * options_.strength);
    } else {
      const double tension = -load.force_b.x() / area;
      const double bending = 6.0 / area *
                             (std::abs(load.torque_b.z()) / box_size_.y() +
                              std::abs(load.torque_b.y()) / box_size_.z());
      load.share = (tension + bending) / options_.strength;
    }
    loads_.push_back(load);
  }
}

void BreakingRow::divide(World& world, std::size_t piece, int count) {
  const Piece whole = pieces_[piece];
  const std::size_t index = idx(world.index_of(whole.body));
  const BodyProperties body = world.bodies()[index];
  const BodyState state = world.states()[index];
  const Vec3 velocity_w = velocity(body, state), spin_w = angular_velocity(body, state);
  world.remove(whole.body);
  const Vec3 along_w = state.orientation_wb * Vec3(box_size_.x(), 0.0, 0.0);
  const auto part = [&](int first, int boxes) {
    const Vec3 size(boxes * box_size_.x(), box_size_.y(), box_size_.z());
    const BodyProperties own = box_properties(size, options_.density * size.prod());
    BodyState its = state;
    const Vec3 arm_w = (first + 0.5 * boxes - 0.5 * whole.count) * along_w;
    its.position_w += arm_w;
    its.linear_momentum_w = own.mass * (velocity_w + spin_w.cross(arm_w));
    its.angular_momentum_w = angular_momentum(own, state.orientation_wb, spin_w);
    return Piece{add(world, boxes, its), whole.first + first, boxes};
  };
  pieces_[piece] = part(0, count);
  pieces_.insert(pieces_.begin() + static_cast<std::ptrdiff_t>(piece) + 1,
                 part(count, whole.count - count));
}

// Pushes of contacts at the poses that they belong to: those of the start of the step or of its end.
void BreakingRow::take_pushes(const World& world, const Technique& technique, double dt) {
  for (const ContactRecord& contact : technique.contacts()) {
    const bool at_start = contact.time < world.time() - 0.5 * dt;
    const Vec3 impulse_w = contact.is_impulse ? contact.push_w : Vec3(dt * contact.push_w);
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      const Piece& piece = pieces_[k];
      if (piece.body != contact.first && piece.body != contact.second) continue;
      const BodyState& state =
          at_start ? starts_[k] : world.states()[idx(world.index_of(piece.body))];
      pushes_.push_back({piece.body, piece.body == contact.second ? impulse_w : Vec3(-impulse_w),
                         state.orientation_wb.conjugate() * (contact.point_w - state.position_w)});
    }
  }
}

StepReport BreakingRow::step(World& world, Technique& technique, double dt) {
  starts_.clear();
  for (const Piece& piece : pieces_)
    starts_.push_back(world.states()[idx(world.index_of(piece.body))]);
  // [S2.4.1:glued]
  StepReport report = technique.step(world, dt);
  take_pushes(world, technique, dt);
  loads_.clear();
  report.events = 0;
  for (std::size_t k = pieces_.size(); k-- > 0;) {
    if (pieces_[k].count < 2) continue;
    const std::size_t from = loads_.size();
    find_loads(world, pieces_[k], dt);
    const auto most =
        std::max_element(loads_.begin() + static_cast<std::ptrdiff_t>(from), loads_.end(),
                         [](const JointLoad& a, const JointLoad& b) { return a.share < b.share; });
    if (most->share <= 1.0) continue;
    divide(world, k, most->joint + 1 - pieces_[k].first);
    ++report.events;
  }
  // [S2.4.1:glued]
  std::sort(loads_.begin(), loads_.end(),
            [](const JointLoad& a, const JointLoad& b) { return a.joint < b.joint; });
  pushes_.clear();
  return report;
}

}  // namespace tumble
