/// \file
/// \brief Bodies that turn about the points on which they stand (thesis 6.2).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/dynamics/pose_update.hpp"
#include "tumble/dynamics/world.hpp"
#include "tumble/dynamics/wrench.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace tumble {

/// Knowledge about the motion of two bodies that push each other, besides their velocities.
enum class PushedState : std::uint8_t {
  unknown,  ///< nothing
  held,     ///< forces hold them together: what velocity is left is an error, and no motion
  slips     ///< friction gives way, or will: they do not stick, however slow they are
};

/// Two bodies that push each other.
struct PushedPair {
  int first = 0;                  ///< index of a body
  int second = 0;                 ///< index of another one
  Vec3 point_w = Vec3::Zero();    ///< [m] where: the mean of the points, by normal impulse
  Vec3 normal_w = Vec3::UnitY();  ///< [-] world frame, length 1
  PushedState state = PushedState::unknown;  ///< by its impulses
};

/// A contact's push from one body on another; nothing if no point is pushed.
std::optional<PushedPair> pushed_pair(const Contact& contact);

/// At which end of a move the velocities of bodies that stick agree where they touch.
enum class RigidAt : std::uint8_t {
  start,  ///< solved at the poses from which bodies move
  end     ///< solved at the poses to which they move
};

/// Moves bodies by the exponentials of their own twists about the points on which they stand.
///
/// A technique knows one velocity v and one angular velocity ω of each body for a step h. If it moves
/// the centre by h v and turns the body about it by \f$Q = \exp[h\omega]_\times\f$, bodies that turn
/// together about a point p outside of them leave their circles by \f$(\omega h)^2/2\f$ times their
/// distance from p. Force and torque over a step cannot be blamed: v and ω name the right motion, and
/// only the point about which it is carried out is wrong.
///
/// **Which body stands on which.** A pair that pushes *sticks* if its two material points at p move alike
/// (tolerance::carried_slip). Along pairs that stick, breadth first from the immovable bodies, each
/// body b gets one parent a and one pivot p. With the material velocity
/// \f$v_b(p) = v_b + \omega_b\times(p - x_b)\f$ at any time t of the move
/// \f[ p(t) = a\text{'s motion applied to } p + t\,(v_b(p) - v_a(p)), \qquad
///     x_b(t) = p(t) + Q_b(t)\,(x_b - p), \qquad q_b(t) = Q_b(t)\,q_b. \f]
/// An immovable parent has no motion. The difference of velocities is what the solver has left, a gap
/// that closes or a slow slide; for PushedState::held it is left out. With
/// \f$A_b(t) = Q_b(t) - 1 - t[\omega_b]_\times\f$, by which an arc leaves its tangent, this is
/// the straight way and an *offset*,
/// \f[ x_b(t) = x_b + t\,v_b + e_b, \qquad e_b = e_a + A_a\,(p - x_a) + A_b\,(x_b - p), \f]
/// which is computed in this form: it is 0 to the last bit for a body that does not turn.
///
/// **Bodies that stand on nothing immovable.** Bodies that stick to each other have the one with the smallest
/// index as their root; then all get the same shift, so that their centre of mass goes straight. If one
/// of them *slides* on an immovable body with the normal n, the group is shifted along n so that its
/// material point does not leave the plane that it moves in. A body by itself that does neither is not
/// carried.
///
/// **Forces known as well.** With accelerations a and α (accelerate()) the way by itself is a parabola,
/// \f$Q = \exp[t\omega + \tfrac12 t^2\alpha]_\times\f$, and the offset is less by \f$\tfrac12 t^2 a_b\f$: what
/// sticks has no acceleration at its pivot, so the circle has a in it.
///
/// **Velocities that agree at the end** of the move (RigidAt::end): the same with
/// \f$A = Q - 1 - t[\omega]_\times Q\f$, which takes v(p) at the point's place in the end.
///
/// **Exactness.** Bodies that turn as one keep all its distances, at any step; so do bodies with spins
/// of their own, as long as pairs that stick make a tree. Moving each by the exponential of its twist
/// about the origin, which is right for a group that turns as one, leaves
/// \f$h^2|\Delta\omega||v_p|/2\f$ at a joint that moves.
///
/// **Remaining error.** A body that stands on two others with different motions follows one of them, and the
/// other contact opens or closes by a length of second order. So do bodies that slide on movable ones,
/// and a plank that turns while it slides over an edge, as n is taken for fixed.
///
/// **Turning** is by a constant spin, or one that grows evenly: a technique's RotationRule has no say for
/// bodies that are carried, which have to turn alike where they turn as one.
///
/// **Momenta** stay as they are, so linear momentum is kept. They are not turned: of the momentum about a
/// pivot a step takes the part \f$(\omega h)^2/2\f$, which is of the order of the techniques' own error. For
/// groups in flight the offset's share \f$e_b\times m_b(v_b - V)\f$, V being the velocity of their
/// centre of mass, goes into the spin, so that angular momentum is kept as well.
/// \par Cost and determinism
/// Linear in bodies and pairs: a sine and a cosine for each body carried. No allocation once warm.
/// \algorithm{Exterior rotation: section 6.2}
/// \deviation{The thesis asks for one frame for each group that rotates, and finds none; here each body turns about the point it stands on.}
/// \verified{A column that turns about an edge keeps its shape at any step}
class PivotUpdate {
 public:
  /// Finds the bodies that are carried.
  /// \param moving    where bodies are, their velocities in the move, and which are immovable in it (inverse
  ///                  masses of 0), by index
  /// \param pairs     the pushes; an earlier one of a body with two parents is taken
  /// \param rigid_at  where velocities agree
  /// \throws std::invalid_argument if there is not one of `moving` for each body, or a pair names a body
  ///         that there is not
  void find(std::span<const BodyProperties> bodies, std::span<const MovingBody> moving,
            std::span<const PushedPair> pairs, RigidAt rigid_at = RigidAt::start);

  /// Says how motion changes; after find() with RigidAt::start.
  /// \param rates  accelerations by body index, for all of the move
  void accelerate(std::span<const Acceleration> rates);

  /// Gives carried bodies other velocities; the bodies that carry them stay the same.
  /// \param moving  by body index; velocities are read
  void set_velocities(std::span<const MovingBody> moving);

  /// Gives one body other velocities. Those that it carries follow at the next set_velocities().
  /// \param body    its index, one that is carried
  /// \param moving  velocities are read
  void set_velocity(int body, const MovingBody& moving);

  /// The carried bodies by index, a body before those that it carries.
  [[nodiscard]] std::span<const int> bodies() const { return carried_; }

  /// Carries no body.
  void clear();

  /// Whether a body is carried.
  [[nodiscard]] bool carries(int body) const {
    const auto b = static_cast<std::size_t>(body);
    return b < node_of_.size() && node_of_[b] >= 0;
  }

  /// On which point a body stands.
  /// \return [m] from its pivot to its centre at the start of the move, world frame; nothing for a body
  ///         that is not carried, or that all others of its group are carried by
  [[nodiscard]] std::optional<Vec3> arm_w(int body) const;

  /// Where a body is beside the way it would go by itself.
  /// \param body  its index, one that is carried
  /// \param time  [s] since the start of the move
  /// \return [m] world frame; a continuous function of the time
  [[nodiscard]] Vec3 offset_w(int body, double time) const;

  /// Carries a body whose centre has gone its own way already.
  ///
  /// Adds offset_w(), turns the body, and moves angular momentum in a group in flight.
  /// \param time   [s] since the start of the move
  /// \param state  position and momenta as without carrying, orientation of the start; in and out
  /// \throws std::invalid_argument if the spin is not finite
  void carry(int body, double time, BodyState& state) const;

  /// Moves a body: straight with its momentum, and carried.
  /// \param time   [s] of the move
  /// \param world  its state is that of the start; in and out
  /// \return [J] energy that it has got by not going straight
  double move(int body, double time, World& world) const;

 private:
  struct Node {
    int body = 0;
    int parent = -1;  // a node; -1: it stands on an immovable body, or is a root
    int group = -1;   // in flight or sliding; -1: it stands
    double mass = 0.0;
    Vec3 arm_w = Vec3::Zero();    // [m] from the pivot to its centre
    Vec3 joint_w = Vec3::Zero();  // [m] from the parent's centre to the pivot
    Vec3 slip_w = Vec3::Zero();   // [m/s] at the pivot, left out
    Vec3 velocity_w = Vec3::Zero();
    Vec3 spin_w = Vec3::Zero();
    Acceleration rate;
  };
  struct Group {
    double mass = 0.0;
    bool slides = false;
    Vec3 velocity_w = Vec3::Zero();  // of the centre of mass
    Vec3 acceleration_w = Vec3::Zero();
    Vec3 shift_w = Vec3::Zero();
  };
  struct Slide {
    int node = 0;
    Vec3 joint_w = Vec3::Zero();  // [m] from the body's centre to the point
    Vec3 normal_w = Vec3::UnitY();
  };
  // How far a node has turned at the time looked at.
  struct Turn {
    Vec3 vector_w = Vec3::Zero();  // [rad]
    double sine = 0.0;             // sin(x)/x of its length x
    double cosine = 0.0;           // (1 - cos(x))/x²
  };

  void sort_pairs(std::span<const BodyProperties> bodies, std::span<const MovingBody> moving,
                  std::span<const PushedPair> pairs);
  void grow(std::span<const BodyProperties> bodies, std::span<const MovingBody> moving,
            std::span<const PushedPair> pairs, int group);
  void add_node(const BodyProperties& body, const MovingBody& moving, int index, int group);
  void weigh_groups();
  void place(double time) const;
  [[nodiscard]] static Turn turn_of(const Node& node, double time);
  [[nodiscard]] Vec3 bend(const Node& node, const Turn& turn, double time, const Vec3& arm_w) const;

  RigidAt rigid_at_ = RigidAt::start;
  std::vector<Node> nodes_;   // parents first
  std::vector<int> node_of_;  // by body index; -1: not carried
  std::vector<int> carried_;  // the nodes' bodies
  std::vector<Group> groups_;
  std::vector<Slide> slides_;
  // Storage of find().
  std::vector<int> stuck_start_;  // of a body's pairs in stuck_
  std::vector<int> stuck_;        // pairs that stick
  std::vector<char> sticks_;      // by pair
  std::vector<char> on_wall_;     // by body: it slides on an immovable one
  std::vector<int> queue_;        // bodies whose pairs are to be looked at
  // Where all are at one time: the last one that was asked for.
  mutable double placed_at_ = std::numeric_limits<double>::quiet_NaN();
  mutable std::vector<Turn> turns_;      // by node
  mutable std::vector<Vec3> offsets_w_;  // by node
  mutable std::vector<Group> placed_;    // groups with their shifts
};

}  // namespace tumble
