/// \file
/// \brief Points near each other, and the move, of methods that move bodies by trust regions (thesis 2.7).
#pragma once

#include "tumble/contact/gather.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/geometry/bounding_tree.hpp"

#include <span>
#include <vector>

namespace tumble {

/// Contact points of all bodies that may meet while none moves farther than its reach.
///
/// Where edges cross, corners of the faces beside them are points too (add_face_points()), so that all half spaces are there
/// that keep two boxes apart.
class NearPoints {
 public:
  /// Finds them, with the impulses that the same points had before.
  /// \param margin  [m] points up to this far apart count, at least 0
  /// \param report  pair tests are added, the deepest overlap is overwritten
  void find(const World& world, std::span<const MovingBody> bodies, double margin,
            StepReport& report);
  /// \return of the last search, sorted by id; impulses may be changed
  [[nodiscard]] ContactList& contacts() { return contacts_; }
  /// \return of the last search, sorted by id
  [[nodiscard]] const ContactList& contacts() const { return contacts_; }
  /// \return [m] of each point, in the order of the contacts; below 0 for overlap
  [[nodiscard]] std::span<const double> gaps() const { return gaps_; }
  /// The impulses to start from, times a factor.
  /// \param factor  [-]
  void scale_impulses(double factor);

 private:
  ContactList contacts_, previous_;
  BoundingTree near_;
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> pairs_;
  std::vector<double> gaps_;
};

/// How far a corner goes at most.
/// \param moving  their displacements, as velocities
/// \return [m] the displacement of the centre and half the diagonal times the turn, of the body for which this is most
[[nodiscard]] double farthest_move(const World& world, std::span<const MovingBody> moving);

/// How far apart two points may be that meet within a step, up to `tolerance::faure_reach` of the shortest edge.
/// \param bodies  their velocities at the start of the step, by index
/// \return [m] twice the way of the fastest point
[[nodiscard]] double meeting_margin(const World& world, std::span<const MovingBody> bodies,
                                    double dt);

/// Moves all movable bodies.
/// \param moving  displacements, as velocities
/// \param share   [-] of them
/// \param world   poses in and out
void move_bodies(std::span<const MovingBody> moving, double share, World& world);

}  // namespace tumble
