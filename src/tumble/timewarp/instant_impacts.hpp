/// \file
/// \brief Collisions of pairs of bodies at one instant, the others left alone (thesis A.1:
///        collideTwoObjects).
#pragma once

#include "tumble/base/tolerances.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/contact/impacts.hpp"
#include "tumble/contact/islands.hpp"
#include "tumble/dynamics/technique.hpp"

#include <span>
#include <vector>

namespace tumble {

/// How collisions of an instant are resolved.
struct InstantOptions {
  /// [s] how much before they touch a search may have stopped: contact reaches as far as bodies
  /// come in that time
  double resolution = tolerance::event_resolution;
  bool bounce = true;   ///< with the restitution of the bodies; else with none
  double dt = 0.0;      ///< [s] length of the frame, see InstantReport::status
  double margin = 0.0;  ///< [m] contact reaches at least as far as this
};

/// What collisions of an instant did.
struct InstantReport {
  /// How the worst of them ended. A solver that meets its cap counts as done if the approach that it
  /// leaves brings bodies no closer in a frame than repair leaves them, or is as slow as what gravity
  /// does in a frame.
  ImpactStatus status = ImpactStatus::done;
  double approach_left = 0.0;         ///< [m/s] the fastest
  std::span<const Contact> contacts;  ///< with their impulses; valid until the next call
};

/// By how much an impact changes the speed of some point of a body, at most.
/// \param body    its constant part
/// \param before  how it moved
/// \param after   how it moves
/// \return [m/s] the change of its centre's velocity, and that of its spin times half its diagonal
[[nodiscard]] double speed_change(const BodyProperties& body, const MovingBody& before,
                                  const MovingBody& after);

/// Whether a collision is one of rounding, as bodies that rest on each other have it in every frame.
/// \param world  the bodies
/// \param event  their collision
/// \param time   [s] to look ahead, above 0
/// \return true if its impulse moves neither by more than tolerance::rounding_overlap of its size
///         in that time
[[nodiscard]] bool only_rounding(const World& world, const Event& event, double time);

/// What is told of an impact: all its points, and its collisions but for those of rounding.
/// \param world     the bodies
/// \param contacts  with their impulses
/// \param moment    time and rewinds of all of it
/// \param dt        [s] length of the frame, see only_rounding()
/// \param records   gets the points added
/// \param events    gets the collisions added
void tell_impact(const World& world, std::span<const Contact> contacts, const Event& moment,
                 double dt, std::vector<ContactRecord>& records, std::vector<Event>& events);

/// The bodies of some pairs that can be pushed.
/// \param world  the bodies
/// \param pairs  by index
/// \param out    is overwritten: indices, ascending, each once
void list_movable(const World& world, std::span<const IndexPair> pairs, std::vector<int>& out);

/// Resolves the collisions of some pairs at one instant.
///
/// Only the bodies of these pairs are looked at: in a timewarp the others are at other times. Pairs
/// that hang together through movable bodies are resolved at one stroke, so that the order of
/// bodies does not matter; heaps with more than kMostPoints points are resolved pair by pair in
/// kPasses passes instead.
/// \par Cost
/// That of ImpactSolver for these pairs, however many bodies there are. No allocation once warm.
class InstantImpacts {
 public:
  /// [-] Largest heap that is resolved at one stroke. Reason: its problem is dense and takes the
  /// third power of this, half a millisecond at 64.
  static constexpr int kMostPoints = 64;
  /// [-] Passes over larger heaps. Reason: what they leave is a matter of the next frame.
  static constexpr int kPasses = 20;

  /// Resolves.
  /// \param world    momenta of the pairs' bodies in and out; their poses are those of the instant
  /// \param pairs    by index, first < second, each once, sorted
  /// \param options  see there
  /// \param report   gets counts and energy added
  /// \return what happened
  InstantReport resolve(World& world, std::span<const IndexPair> pairs,
                        const InstantOptions& options, StepReport& report);

  /// How fast two bodies part after the last call.
  /// \param world  as it was given
  /// \param pair   one of its pairs
  /// \param time   [s] who parts by no more than rounding in this time does not part
  /// \return [m/s] where they were pushed, at the slowest such place; if they were not, at the slowest
  ///         of all; 0 if they do not part or do not touch
  [[nodiscard]] double separation_speed(const World& world, const IndexPair& pair,
                                        double time) const;

 private:
  [[nodiscard]] double slowest_separation(const IndexPair& pair, bool pushed_only) const;
  void resolve_island(std::span<const int> members, InstantReport& out, StepReport& report);
  void resolve_together(std::span<Contact> contacts, InstantReport& out, StepReport& report);

  std::vector<MovingBody> moving_;  // by index; those of the pairs are loaded
  ContactList contacts_;
  ContactList island_contacts_;
  Islands islands_;
  ImpactSolver solver_;
};

}  // namespace tumble
