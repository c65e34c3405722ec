/// \file
/// \brief All bodies of a simulation, as a value.
#pragma once

#include "tumble/base/index.hpp"
#include "tumble/base/state_hash.hpp"
#include "tumble/dynamics/body.hpp"
#include "tumble/dynamics/body_joint.hpp"
#include "tumble/dynamics/mass_range.hpp"
#include "tumble/geometry/broad_phase.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// Whether a body rests, as the sleeping rule (thesis 4.5) keeps book of it.
struct SleepState {
  double quiet_time = 0.0;  ///< [s] how long it has been slower than the sleeping speed
  bool asleep = false;      ///< not simulated until something wakes it
};

class BodyView;

/// All bodies of a simulation, the ground and gravity. A value: a copy is a snapshot.
///
/// Bodies have stable ids. They also have an index, their place in the arrays of this step; ids
/// and indices are in the same order, and adding keeps indices, while removing a body moves the
/// later ones down by one. Techniques work on indices within a step and keep ids between steps.
class World {
 public:
  /// [m/s²] the only external force of the thesis (3.1).
  Vec3 gravity_w = Vec3(0.0, -9.81, 0.0);

  /// Adds the ground, the immovable half-space y <= 0.
  /// \param friction     [-] at least 0
  /// \throws std::invalid_argument naming a value out of range, or if there is a ground already
  BodyId add_ground(double friction = 0.5, double restitution = 0.0);

  /// Adds a body.
  /// \param name   its name in files; empty: "box" and its number, counted from 1 as boxes were
  ///               added (the next free one if a name is taken). Names are unique
  /// \return its id, larger than every id given before
  /// \throws std::invalid_argument for properties that contradict one another, a ground (see
  ///         add_ground()), a state that is not finite, momentum of an immovable body, a name
  ///         that is taken, a place or motion out of require_motion_limits(), or a mass too far from others (see
  ///         MassRange); the world is then as before
  BodyId add(const BodyProperties& body, const BodyState& state, std::string name = "");

  /// Adds a body without a name of its own, see make_state() for where it is and how it moves.
  BodyId add(const BodyProperties& body, const Vec3& position_w,
             const Quat& orientation_wb = Quat::Identity(), const Vec3& velocity_w = Vec3::Zero(),
             const Vec3& angular_velocity_w = Vec3::Zero()) {
    return add(body, make_state(body, position_w, orientation_wb, velocity_w, angular_velocity_w));
  }

  /// Removes a body and its joints. Its id is never given again. Whatever slept on it is the technique's to wake.
  /// \throws std::invalid_argument if there is no such body
  void remove(BodyId id);

  /// Joins two bodies as they are now. A technique holds the joint, or refuses the world: see Technique::holds_joints().
  /// \param second    the other; one of the two has to be movable
  /// \param anchor_w  [m] the joint's point
  /// \param axis_w    [-] of a hinge, of any length above 0; otherwise 0
  /// \param name      in messages; empty: "joint" and its number from 1
  /// \throws std::invalid_argument naming the value: no such body, twice the same one, both immovable, an axis that is
  ///         missing or too much, or a number that is not finite; the world is then as before
  void join(JointKind kind, BodyId first, BodyId second, const Vec3& anchor_w,
            const Vec3& axis_w = Vec3::Zero(), std::string name = "");

  /// The joints, in the order in which they were made, without those whose bodies are gone.
  [[nodiscard]] std::span<const BodyJoint> joints() const { return joints_; }

  /// Whether a joint is between two bodies. Such bodies do not collide. O(log joints)
  [[nodiscard]] bool joined(BodyId a, BodyId b) const;

  /// Changes a body's momenta by an impulse at a point and wakes it.
  /// \param point_w    [m] where it acts, world frame
  /// \throws std::invalid_argument if there is no such body, it is immovable, a value is not
  ///         finite, or the motion is out of require_motion_limits()
  void push(BodyId id, const Vec3& impulse_w, const Vec3& point_w);

  /// Gives a body new velocities and wakes it.
  /// \throws std::invalid_argument if there is no such body, it is immovable, a value is not
  ///         finite, or the motion is out of require_motion_limits()
  void set_velocity(BodyId id, const Vec3& velocity_w, const Vec3& angular_velocity_w);

  /// Puts a body somewhere else and wakes it.
  /// \throws std::invalid_argument if there is no such body, a value is not finite or out of
  ///         require_motion_limits(), an immovable body is given momentum, or the body is the ground
  void set_state(BodyId id, const BodyState& state);

  /// How many bodies there are, the ground included: the length of every array below.
  [[nodiscard]] int count() const { return static_cast<int>(states_.size()); }

  /// The place of a body in the arrays: its index, or nothing if there is no such body. O(log n).
  [[nodiscard]] std::optional<int> find(BodyId id) const;

  /// The place of a body in the arrays, its index. O(log n).
  /// \throws std::invalid_argument if there is no such body
  [[nodiscard]] int index_of(BodyId id) const;

  /// The id of the body called like this, or nothing.
  [[nodiscard]] std::optional<BodyId> find(std::string_view name) const;

  /// The place in the arrays of the body called like this, its index. O(1).
  /// \throws std::invalid_argument if there is no such body, with the closest name
  [[nodiscard]] int index_of(std::string_view name) const;

  /// The body called like this, to be read. O(1).
  /// \throws std::invalid_argument if there is no such body, with the closest name
  /// \verified{A body is read by its name, and a name that is missing is answered with the closest one}
  [[nodiscard]] BodyView body(std::string_view name) const;

  /// A body, to be read. O(log n).
  /// \throws std::invalid_argument if there is no such body
  [[nodiscard]] BodyView body(BodyId id) const;

  /// The constant parts, by index.
  [[nodiscard]] std::span<const BodyProperties> bodies() const { return bodies_; }
  /// The ids, by index, ascending.
  [[nodiscard]] std::span<const BodyId> ids() const { return ids_; }
  /// The states, by index.
  [[nodiscard]] std::span<const BodyState> states() const { return states_; }
  /// The states, by index, for techniques.
  [[nodiscard]] std::span<BodyState> states() { return states_; }
  /// Which bodies sleep, by index.
  [[nodiscard]] std::span<const SleepState> sleep_states() const { return sleep_states_; }
  /// Which bodies sleep, by index, for techniques.
  [[nodiscard]] std::span<SleepState> sleep_states() { return sleep_states_; }
  /// The name of a body.
  [[nodiscard]] const std::string& name(int index) const {
    return names_[static_cast<std::size_t>(index)];
  }

  /// The time that has been simulated [s].
  [[nodiscard]] double time() const { return time_; }
  /// How many steps have been done.
  [[nodiscard]] std::int64_t steps() const { return steps_; }
  /// Advances the time and counts a step; for techniques, at the end of each step or part of a step.
  void finish_step(double dt) {
    time_ += dt;
    ++steps_;
  }

  /// A hash over all that changes: gravity, time, steps, ids, states and rests.
  /// \return equal for equal bits
  [[nodiscard]] StateHash hash() const;

 private:
  BodyId append(const BodyProperties& body, const BodyState& state, std::string name);
  [[nodiscard]] int index_of_movable(BodyId id) const;
  [[nodiscard]] std::size_t place_of(std::string_view name) const;
  void fill_places();

  std::vector<BodyId> ids_;
  std::vector<BodyProperties> bodies_;
  std::vector<BodyState> states_;
  std::vector<SleepState> sleep_states_;
  std::vector<std::string> names_;
  // A hash table of the names: an index, or -1 for an empty place. A power of two, at most half of it in use. It decides
  // nothing but where a name is found.
  std::vector<std::int32_t> places_;
  std::vector<BodyJoint> joints_;
  std::vector<std::array<BodyId, 2>> joined_;  // their bodies, sorted
  MassRange masses_;
  double time_ = 0.0;
  std::int64_t steps_ = 0;
  std::uint32_t next_id_ = 0;
  std::uint32_t boxes_added_ = 0;  // for the default names
};

/// One body of a world, to be read: pose, velocities, energy. It shows the world as it is when it is asked, and
/// is valid until a body is added or removed, or the world is moved.
class BodyView {
 public:
  /// The body at a place in the arrays.
  /// \param index  its place, at least 0 and below the count
  BodyView(const World& world, int index) : world_(&world), index_(index) {}

  /// \return its id
  [[nodiscard]] BodyId id() const { return world_->ids()[idx(index_)]; }
  /// \return its name
  [[nodiscard]] const std::string& name() const { return world_->name(index_); }
  /// \return what never changes about it
  [[nodiscard]] const BodyProperties& properties() const { return world_->bodies()[idx(index_)]; }
  /// \return its state
  [[nodiscard]] const BodyState& state() const { return world_->states()[idx(index_)]; }
  /// \return whether it sleeps
  [[nodiscard]] bool asleep() const { return world_->sleep_states()[idx(index_)].asleep; }

  /// \return [m] its centre of mass
  [[nodiscard]] const Vec3& position_w() const { return state().position_w; }
  /// \return [-] its orientation, body to world
  [[nodiscard]] const Quat& orientation_wb() const { return state().orientation_wb; }
  /// \return [m/s] velocity of its centre of mass
  [[nodiscard]] Vec3 velocity_w() const { return velocity(properties(), state()); }
  /// \return [rad/s] its angular velocity
  [[nodiscard]] Vec3 angular_velocity_w() const { return angular_velocity(properties(), state()); }
  /// \return [J] of translation and rotation
  [[nodiscard]] double kinetic_energy() const {
    return tumble::kinetic_energy(properties(), state());
  }
  /// \return [J] in gravity, 0 with the centre of mass at the origin; 0 for an immovable body
  [[nodiscard]] double potential_energy() const {
    return properties().movable() ? -properties().mass * world_->gravity_w.dot(position_w()) : 0.0;
  }

 private:
  const World* world_;
  int index_;
};

/// Leaves out pairs of bodies that a joint joins.
/// \param pairs  by index, in and out, in the same order
void leave_out_joined(const World& world, std::vector<IndexPair>& pairs);

/// Refuses a gravity that would make a body faster than tolerance::largest_speed within a second.
/// \throws std::invalid_argument naming the value, the limit and the remedy
void require_gravity(const Vec3& gravity_w);

/// Whether all states are finite; after a step that failed they may not be.
/// \return false if a position, an orientation or a momentum is infinite or NaN
[[nodiscard]] bool all_finite(const World& world);

}  // namespace tumble
