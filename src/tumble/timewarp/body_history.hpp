/// \file
/// \brief The trajectory of one body, and the time until which it is known (Mirtich 2000).
#pragma once

#include "tumble/dynamics/flight.hpp"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace tumble {

/// A state of a body; its trajectory from here to the next milestone is free flight.
struct Milestone {
  /// [s] time of the state
  double time = 0.0;
  BodyState state;  ///< at that time
  /// Number of the collision that produced it; kNoCollision if the body was only integrated to here.
  std::int64_t collision = kNoCollision;
  /// [s] micro-step of the flight from here; kept so that the flight is reproducible
  double micro_step = std::numeric_limits<double>::infinity();
  static constexpr std::int64_t kNoCollision = -1;  ///< see collision
};

/// The trajectory of one body: milestones, free flight between them, and the body's local time.
///
/// Times are counted from the start of the frame; those of earlier frames are negative.
class BodyHistory {
 public:
  /// Starts a new history.
  void begin(const Milestone& milestone);

  /// Appends a milestone, whose time becomes the local time.
  /// \param milestone  not before the local time
  void add(const Milestone& milestone, const BodyProperties& body, const Vec3& gravity_w);

  /// Sets the local time back. Milestones stay.
  /// \param time  [s] not before the last milestone
  void end_at(double time) { known_until_ = time; }

  /// Removes the last milestone; the local time stays.
  void remove_last() { milestones_.pop_back(); }

  /// Removes all milestones before a time except the last of them.
  /// \param time  [s]
  void forget_before(double time);

  /// Moves the origin of time.
  /// \param by  [s] subtracted from all times
  void shift(double by);

  /// Bounds of the trajectory from the first milestone to the local time; updated by measure(). World frame.
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }

  /// Recomputes the bounds.
  void measure(const BodyProperties& body, const Vec3& gravity_w);

  /// The local time, until which the trajectory is known [s]; infinite for a body that cannot move.
  [[nodiscard]] double known_until() const { return known_until_; }

  /// All milestones, in order of time; at least one.
  [[nodiscard]] std::span<const Milestone> milestones() const { return milestones_; }

  /// The milestone from which the body flies at a time.
  /// \param time  [s] not before the first one
  /// \return the last one before the time, or the first one if there is none before
  [[nodiscard]] const Milestone& before(double time) const;

 private:
  std::vector<Milestone> milestones_;
  double known_until_ = 0.0;
  Bounds bounds_;
};

/// Bounds of a body's flight from a milestone.
/// \param until      [s] its end
/// \return world frame
[[nodiscard]] Bounds bounds_from(const Milestone& milestone, double until,
                                 const BodyProperties& body, const Vec3& gravity_w);

}  // namespace tumble
