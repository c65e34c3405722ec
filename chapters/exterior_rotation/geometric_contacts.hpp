/// \file
/// \brief Joints without glue as a simulator keeps them, which knows of a contact only what it sees (thesis
///        6.2).
#pragma once

#include "tumble/exterior_rotation/runge_kutta.hpp"
#include "tumble/exterior_rotation/simple_steps.hpp"

#include "driver/experiment.hpp"

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
ContactSet contact_set_of(const Joint& joint, std::span<const BodyState> states, double tolerance);

// The hold of corners that touch.
void hold_what_touches(const ContactSet& seen, Joint& joint);

// A way to step.
struct ContactScheme {
  std::string name;                                   // as figures call it
  const ButcherTable* table = nullptr;                // of several stages, or nullptr
  SimpleScheme simple = SimpleScheme::forward_euler;  // else
  PoseUpdate pose = PoseUpdate::separate;             // of a simple scheme
};

// The schemes that are compared: five that move centre and orientation apart, four that do not.
const std::vector<ContactScheme>& contact_schemes();

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
  explicit GeometricContacts(ContactScheme scheme, double tolerance, bool glue = false);

  // Finds the joints now instead of in the first step.
  void find(const World& world);

  // One step.
  // dt: [s] above 0
  void advance(World& world, double dt);

  // Looks at all joints.
  [[nodiscard]] std::vector<ContactSet> look(const World& world) const;

  // The joints with what held in the last step.
  [[nodiscard]] std::span<const Joint> joints() const { return joints_; }

 private:
  void release(const World& world, bool impulses);

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
std::vector<ContactChange> changes_of(const std::vector<std::vector<ContactSet>>& looks);

// The changes that another run does not have.
//
// Each change of the other run answers for one change at most, the first one that is within reach.
std::vector<ContactChange> changes_not_in(const std::vector<ContactChange>& changes,
                                          const std::vector<ContactChange>& other, int within);

}  // namespace tumble::chapters
