/// \file
/// \brief What a body has been through, and how far it is known (Mirtich 2000).
#pragma once

#include "tumble/dynamics/flight.hpp"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace tumble {

/// A state of a body from which its way is known until the next one.
struct Milestone {
  /// [s] when
  double time = 0.0;
  BodyState state;  ///< from here on
  /// Number of the collision that has made it; kNoCollision if the body has merely been flown here.
  std::int64_t collision = kNoCollision;
  /// [s] micro-steps of the flight from here, so that it is the same whenever it is looked at
  double micro_step = std::numeric_limits<double>::infinity();
  static constexpr std::int64_t kNoCollision = -1;  ///< see collision
};

/// The way of one body: milestones, between them free flight, and a local time until which it holds.
///
/// Times are counted from the start of the frame, so that those of the past are below 0.
class BodyHistory {
 public:
  /// Begins anew.
  /// \param milestone  its first one
  void begin(const Milestone& milestone);

  /// Goes on to a milestone, which becomes the local time.
  /// \param milestone  not before the local time
  /// \param body       the body's constant part
  /// \param gravity_w  [m/s²] world frame
  void add(const Milestone& milestone, const BodyProperties& body, const Vec3& gravity_w);

  /// Makes the local time an earlier one. Milestones stay.
  /// \param time  [s] not before the last milestone
  void end_at(double time) { known_until_ = time; }

  /// Takes the last milestone away; the local time stays.
  void remove_last() { milestones_.pop_back(); }

  /// Forgets all milestones but the last one before a time, and those after it.
  /// \param time  [s]
  void forget_before(double time);

  /// Counts times from another moment.
  /// \param by  [s] is taken off all of them
  void shift(double by);

  /// Bounds of the way from the first milestone to the local time; made anew by measure().
  /// \return world frame
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }

  /// Makes the bounds anew.
  /// \param body       the body's constant part
  /// \param gravity_w  [m/s²] world frame
  void measure(const BodyProperties& body, const Vec3& gravity_w);

  /// The local time: until when the way is known.
  /// \return [s]; infinite for a body that cannot move
  [[nodiscard]] double known_until() const { return known_until_; }

  /// All milestones.
  /// \return in the order of their times; at least one
  [[nodiscard]] std::span<const Milestone> milestones() const { return milestones_; }

  /// The milestone from which the body flies at a time.
  /// \param time  [s] not before the first one
  /// \return the last one before the time, or the first one of all
  [[nodiscard]] const Milestone& before(double time) const;

 private:
  std::vector<Milestone> milestones_;
  double known_until_ = 0.0;
  Bounds bounds_;
};

/// Bounds of a body's flight from a milestone.
/// \param milestone  where it begins
/// \param until      [s] its end
/// \param body       the body's constant part
/// \param gravity_w  [m/s²] world frame
/// \return world frame
[[nodiscard]] Bounds bounds_from(const Milestone& milestone, double until,
                                 const BodyProperties& body, const Vec3& gravity_w);

}  // namespace tumble
