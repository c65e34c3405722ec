/// \file
/// \brief Heaps that only chatter are put to sleep (thesis 4.5, 6.3.1).
#pragma once

#include "tumble/dynamics/wrapped_technique.hpp"
#include "tumble/filtering/chatter_detector.hpp"

#include <memory>
#include <string_view>
#include <vector>

namespace tumble {

/// Bodies that were told to rest or chatter, and have not got away since.
///
/// A body becomes calm in a frame in which a ChatterDetector does not tell that it moves, and is so
/// until its corners are, in the root mean square, farther than tolerance::resting_movement of its
/// shortest edge from where they were in that frame. Then it has to be told anew. So a single doubtful
/// window does not unsettle a heap, and nobody who goes somewhere stays calm for long.
class CalmBodies {
 public:
  /// Starts with an empty memory.
  /// \param options of the detector
  /// \throws std::invalid_argument for a number out of range
  explicit CalmBodies(const ChatterDetectorOptions& options = {});

  /// Takes in the world after a step (and at the start).
  /// \param world       the bodies
  /// \param in_contact  see ChatterDetector::add()
  /// \throws std::invalid_argument as ChatterDetector::add()
  void add(const World& world, std::span<const char> in_contact);

  /// Whether a body is calm.
  /// \param id the body
  /// \return false for an immovable one or one that is not there too
  [[nodiscard]] bool calm(BodyId id) const;

  /// Who tells how bodies move.
  /// \return as of the last step
  [[nodiscard]] const ChatterDetector& detector() const { return detector_; }

 private:
  struct Anchor {
    BodyId id{};
    Placement place;  // [m] where it became calm
  };

  ChatterDetector detector_;
  std::vector<Anchor> anchors_;  // of the calm bodies, ascending by id
  std::vector<Anchor> next_;     // storage
};

/// A technique in which heaps fall asleep that do nothing but chatter.
///
/// Calm bodies (CalmBodies) count as slow for the technique's SleepingRule, whatever their speed: so
/// an island sleeps once all of its bodies have been slow or calm for tolerance::sleeping_time, and it
/// touches something immovable. All else is that rule's: the energy that is lost is booked as damping,
/// and the island wakes when something touches or pushes it. Poses stay as they are in the
/// frame in which it falls asleep: nothing jumps.
///
/// The technique must have its own sleeping switched on; without it nothing is changed. With adaptive
/// steps, AdaptiveStep goes around this one: the other way round only contacts of the last sub-step
/// would be seen. A world whose time is before the last one, as of a copy from earlier, is told anew:
/// nobody in it is calm.
/// \par Cost
/// A step of the detector for each body, asleep or not; telling for each that is not calm.
/// \algorithm{Chatter told from earlier steps: section 6.3.1}
/// \verified{A heap that only chatters falls asleep if chatter is detected from history, and not otherwise}
class FreezeOnChatter : public WrappedTechnique {
 public:
  /// Wraps a technique.
  /// \param technique  with sleeping on; the wrapper's own from here on
  /// \param options    of the detector
  /// \throws std::invalid_argument for no technique, or a number out of range
  explicit FreezeOnChatter(std::unique_ptr<Technique> technique,
                           const ChatterDetectorOptions& options = {});

  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::unique_ptr<Technique> clone() const override;

  /// Who is calm.
  /// \return as of the last step
  [[nodiscard]] const CalmBodies& calm_bodies() const { return calm_; }

 private:
  CalmBodies calm_;
  double last_time_ = 0.0;        // [s] of the world after the last step
  std::vector<char> in_contact_;  // storage
  std::vector<char> slow_;        // storage: the calm bodies by index
};

}  // namespace tumble
