/// \file
/// \brief Joints without glue as a simulator keeps them, which knows of a contact only what it sees (thesis
///        6.2).
#pragma once

#include "tumble/exterior_rotation/joint_events.hpp"
#include "tumble/exterior_rotation/runge_kutta.hpp"
#include "tumble/exterior_rotation/simple_steps.hpp"
#include "tumble/exterior_rotation/tolerances.hpp"

#include "driver/experiment.hpp"

#include <bit>
#include <cstdlib>

namespace tumble::chapters {

// The contact of a joint, by geometry.
struct ContactSet {
  int touching = 0;         // bit k: corner k of the area touches the other body
  bool overlapped = false;  // a test for collisions would find the bodies in each other

  // Whether two looks are the same.
  bool operator==(const ContactSet& other) const = default;
};

// Looks at a joint.
//
// A corner of the area touches while its two bodies have it at most a tolerance apart along the normal,
// or in each other. The joint is overlapped if a corner is deeper than the tolerance.
// tolerance: [m] above 0
inline ContactSet contact_set_of(const Joint& joint, std::span<const BodyState> states,
                                 double tolerance) {
  const Vec3 normal_w = states[idx(joint.first)].orientation_wb * joint.normal_first_b;
  ContactSet seen;
  for (int k = 0; k < joint.count; ++k) {
    const JointPoint corner = corner_of(joint, k, states);
    const double distance = normal_w.dot(corner.second_w - corner.first_w);
    if (distance <= tolerance) seen.touching |= 1 << k;
    if (distance < -tolerance) seen.overlapped = true;
  }
  return seen;
}

inline bool touches(const ContactSet& seen, int corner) {
  return ((seen.touching >> corner) & 1) != 0;
}

// The hold of corners that touch.
inline void hold_what_touches(const ContactSet& seen, Joint& joint) {
  const int count = std::popcount(static_cast<unsigned>(seen.touching));
  joint.hold = joint.is_area() ? JointHold::area : JointHold::edge;
  joint.side = 0;
  if (count == joint.count) return;
  if (count == 0) joint.hold = JointHold::nothing;
  for (int k = 0; k < joint.count; ++k) {
    const bool alone = count == 1 && touches(seen, k);
    const bool side = count == 2 && touches(seen, k) && touches(seen, (k + 1) % joint.count);
    if (!alone && !side) continue;
    joint.hold = alone ? JointHold::corner : JointHold::edge;
    joint.side = k;
    return;
  }
}

// A way to step.
struct ContactScheme {
  std::string name;                                   // as figures call it
  const ButcherTable* table = nullptr;                // of several stages, or nullptr
  SimpleScheme simple = SimpleScheme::forward_euler;  // else
  PoseUpdate pose = PoseUpdate::separate;             // of a simple scheme
};

// The schemes that are compared: five that move centre and orientation apart, four that do not.
inline const std::vector<ContactScheme>& contact_schemes() {
  constexpr PoseUpdate exponential = PoseUpdate::exponential;
  static const std::vector<ContactScheme> schemes = {
      {"forward Euler", nullptr, SimpleScheme::forward_euler},
      {"semi-implicit", nullptr, SimpleScheme::semi_implicit},
      {"impulse", nullptr, SimpleScheme::impulse},
      {"midpoint", &midpoint_table()},
      {"rk4", &classical_table()},
      {"forward Euler, exponential", nullptr, SimpleScheme::forward_euler, exponential},
      {"semi-implicit, exponential", nullptr, SimpleScheme::semi_implicit, exponential},
      {"impulse, exponential", nullptr, SimpleScheme::impulse, exponential},
      {"leapfrog, exponential", nullptr, SimpleScheme::leapfrog, exponential}};
  return schemes;
}

// Bodies whose contacts are found by geometry in every step.
//
// `Glued` remembers which joints hold, and opens one when its force says so. A simulator has no such
// memory: it looks where bodies are, and takes what touches for a contact. Each step
// 1. looks at every joint, and lets the corners that touch hold;
// 2. where corners have come back, ends the velocity that is left in the joints, without rebound;
// 3. releases what would have to pull, as joint_margin() says;
// 4. makes a step of the scheme with what holds.
// Friction is never too small. Joints are those of the start; nothing pushes overlap out.
class GeometricContacts {
 public:
  // Makes it.
  // tolerance: [-] surfaces that are up to this apart touch, over the shortest edge of the pair
  explicit GeometricContacts(ContactScheme scheme, double tolerance, bool glue = false)
      : scheme_(std::move(scheme)), tolerance_(tolerance), glue_(glue) {
    require::positive(tolerance, "tolerance");
  }

  // Finds the joints now instead of in the first step.
  void find(const World& world) {
    joints_ = find_joints(world, tolerance::glue_margin);
    reach_.clear();
    for (const Joint& joint : joints_)
      reach_.push_back(tolerance_ * std::min(world.bodies()[idx(joint.first)].size.minCoeff(),
                                             world.bodies()[idx(joint.second)].size.minCoeff()));
    seen_ = look(world);
  }

  // One step.
  void advance(World& world, double dt) {
    require::positive(dt, "dt");
    if (joints_.empty()) find(world);
    // Joints that touch, and those that touch again.
    const std::vector<ContactSet> now = look(world);
    bool back = false;
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      hold_what_touches(now[j], joints_[j]);
      back = back || (now[j].touching & ~seen_[j].touching) != 0;
    }
    seen_ = now;
    if (back) {
      const std::vector<Joint> held = joints_;
      load_moving_bodies(world, moving_);
      release(world, true);
      forces_.project(moving_, joints_, world.states());
      store_moving_bodies(moving_, world);
      joints_ = held;
    }
    load_moving_bodies(world, moving_);
    const bool impulses = scheme_.table == nullptr && scheme_.simple == SimpleScheme::impulse;
    if (impulses)
      for (std::size_t k = 0; k < moving_.size(); ++k)
        if (world.bodies()[k].movable()) moving_[k].velocity_w += dt * world.gravity_w;
    release(world, impulses);
    if (scheme_.table != nullptr)
      runge_kutta_.step(*scheme_.table, dt, joints_, forces_, world);
    else
      simple_.step(scheme_.simple, scheme_.pose, dt, joints_, forces_, world);
    world.finish_step(dt);
  }

  // Looks at all joints.
  [[nodiscard]] std::vector<ContactSet> look(const World& world) const {
    std::vector<ContactSet> seen;
    for (std::size_t j = 0; j < joints_.size(); ++j)
      seen.push_back(contact_set_of(joints_[j], world.states(), reach_[j]));
    return seen;
  }

  // The joints with what held in the last step.
  [[nodiscard]] std::span<const Joint> joints() const { return joints_; }

 private:
  // Opens joints, or takes them apart, until no force or impulse has to pull. None closes here, so that this
  // ends: a face can only become an edge, and an edge nothing.
  void release(const World& world, bool impulses) {
    if (glue_) return;
    for (;;) {
      if (impulses) {
        trial_ = moving_;
        forces_.project(trial_, joints_, world.states());
      } else {
        forces_.hold(world, moving_, joints_, wrenches_);
      }
      // Here geometry decides that a joint closes: such answers are passed over.
      std::vector<Joint> asked = joints_;
      JointChange change;
      double margin = joint_margin(asked, world, moving_, forces_, change);
      while (margin < 0.0 && change.hold == JointHold::area) {
        asked[idx(change.joint)].hold = JointHold::nothing;
        margin = joint_margin(asked, world, moving_, forces_, change);
      }
      if (!(margin < 0.0)) return;
      joints_[idx(change.joint)].hold = change.hold;
      joints_[idx(change.joint)].side = change.side;
    }
  }

  ContactScheme scheme_;
  double tolerance_;
  bool glue_;
  std::vector<Joint> joints_;
  std::vector<double> reach_;       // [m] of the tolerance, by joint
  std::vector<ContactSet> seen_;    // in the step before
  std::vector<MovingBody> moving_;  // and whatever else a step works with
  std::vector<MovingBody> trial_;
  std::vector<Wrench> wrenches_;
  JointForces forces_;
  RungeKutta runge_kutta_;
  SimpleSteps simple_;
};

// Kinds of changes of a joint.
enum class ChangeKind : std::uint8_t {
  lost,     // corners touch no longer
  found,    // corners touch again; also if others were lost in the same step
  overlap,  // the bodies are found in each other
  cleared   // they are no longer
};

// A joint is seen otherwise than in the step before.
struct ContactChange {
  int step = 0;                        // after which it is first seen, from 1
  int joint = 0;                       // its place
  ChangeKind kind = ChangeKind::lost;  // what it is
  int touching = 0;                    // of a change of touching: the corners that do now

  // Whether two are the same, but for the step.
  [[nodiscard]] bool same(const ContactChange& other) const {
    return joint == other.joint && kind == other.kind && touching == other.touching;
  }
};

// The changes of contact of a run.
inline std::vector<ContactChange> changes_of(const std::vector<std::vector<ContactSet>>& looks) {
  std::vector<ContactChange> changes;
  for (std::size_t n = 1; n < looks.size(); ++n) {
    for (std::size_t j = 0; j < looks[n].size(); ++j) {
      const ContactSet& before = looks[n - 1][j];
      const ContactSet& now = looks[n][j];
      ContactChange change{static_cast<int>(n), static_cast<int>(j)};
      if (now.touching != before.touching) {
        change.kind = (now.touching & ~before.touching) != 0 ? ChangeKind::found : ChangeKind::lost;
        change.touching = now.touching;
        changes.push_back(change);
      }
      if (now.overlapped == before.overlapped) continue;
      change.kind = now.overlapped ? ChangeKind::overlap : ChangeKind::cleared;
      change.touching = 0;
      changes.push_back(change);
    }
  }
  return changes;
}

// The changes that another run does not have.
//
// Each change of the other run answers for one change at most, the first one that is within reach.
inline std::vector<ContactChange> changes_not_in(const std::vector<ContactChange>& changes,
                                                 const std::vector<ContactChange>& other,
                                                 int within) {
  std::vector<char> used(other.size(), 0);
  std::vector<ContactChange> left;
  for (const ContactChange& change : changes) {
    std::size_t k = 0;
    while (k < other.size() && (used[k] != 0 || !change.same(other[k]) ||
                                std::abs(change.step - other[k].step) > within))
      ++k;
    if (k == other.size())
      left.push_back(change);
    else
      used[k] = 1;
  }
  return left;
}

}  // namespace tumble::chapters
