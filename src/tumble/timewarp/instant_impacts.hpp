/// \file
/// \brief Impacts of some pairs at one instant, independent of all other bodies (thesis A.1:
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

/// Options for impacts of one instant.
struct InstantOptions {
  /// [s] by how much a search may end before contact; sets the distance up to which contacts are
  /// gathered
  double resolution = tolerance::event_resolution;
  bool bounce = true;   ///< with the restitution of the bodies; otherwise with none
  double dt = 0.0;      ///< [s] length of the frame, see InstantReport::status
  double margin = 0.0;  ///< [m] contacts are gathered at least up to this distance
};

/// Result of the impacts of one instant.
struct InstantReport {
  /// The worst status of all. A solver that reached its cap counts as done if the remaining approach
  /// velocity is no more than gravity adds in a frame, or closes no more in a frame than the overlap
  /// that repair permits.
  ImpactStatus status = ImpactStatus::done;
  double approach_left = 0.0;         ///< [m/s] the largest remaining approach velocity
  std::span<const Contact> contacts;  ///< with their impulses; valid until the next call
};

/// Whether an impact is negligible, as resting bodies have them in every frame.
/// \param time   [s] above 0
/// \return true if its impulse moves each body in that time by at most tolerance::rounding_overlap
///         times the body's size
[[nodiscard]] bool only_rounding(const World& world, const Event& event, double time);

/// Records an impact: all its points as contacts, and as events those that are not negligible.
/// \param contacts  with their impulses
/// \param moment    time and rewinds for all events
/// \param dt        [s] length of the frame, see only_rounding()
/// \param records   gets the points added
/// \param events    gets the collisions added
void record_impact(const World& world, std::span<const Contact> contacts, const Event& moment,
                   double dt, std::vector<ContactRecord>& records, std::vector<Event>& events);

/// Lists the movable bodies of some pairs.
/// \param pairs  by index
/// \param out    is overwritten: indices, ascending, each once
void list_movable(const World& world, std::span<const IndexPair> pairs, std::vector<int>& out);

/// Solver for the impacts of some pairs at one instant.
///
/// Only the bodies of these pairs are read: in a timewarp the others are at other times. Islands are
/// solved simultaneously, so that the order of bodies does not matter; islands with more than
/// kMostPoints points are solved sequentially in kPasses sweeps instead.
/// \par Cost
/// That of ImpactSolver for these pairs, independent of the number of bodies. No allocation once warm.
class InstantImpacts {
 public:
  /// [-] Largest island that is solved simultaneously. Reason: its problem is dense and costs the
  /// third power of this, half a millisecond at 64.
  static constexpr int kMostPoints = 64;
  /// [-] Sweeps over larger islands. Reason: the remaining error is left to the next frame.
  static constexpr int kPasses = 20;

  /// Resolves the impacts.
  /// \param world   momenta of the pairs' bodies in and out; their poses are those of the instant
  /// \param pairs   by index, first < second, each once, sorted
  /// \param report  counts and energy are added to it
  InstantReport resolve(World& world, std::span<const IndexPair> pairs,
                        const InstantOptions& options, StepReport& report);

  /// Separation velocity of two bodies after the last call of resolve().
  /// \param world  as given to it
  /// \param time   [s] separation by no more than rounding in this time counts as 0
  /// \return [m/s] smallest over the points with an impulse, or over all points if there are none; 0
  ///         if the bodies do not separate or do not touch
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
