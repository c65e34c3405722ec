/// \file
/// \brief Sleep for islands that only chatter (thesis 4.5, 6.3.1).
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/dynamics/wrapped_technique.hpp"
#include "tumble/filtering/chatter_detector.hpp"

#include <memory>
#include <vector>

namespace tumble {

/// Bodies classified as resting or chattering that have not left their place since.
///
/// A body becomes calm in a frame in which a ChatterDetector does not classify it as moving, and stays
/// calm until its corners are, in the root mean square, farther than tolerance::resting_movement of its
/// shortest edge from their places in that frame. Then it must be classified again. So a single doubtful
/// window does not disturb a pile, and a moving body does not stay calm for long.
class CalmBodies {
 public:
  /// Starts with an empty memory.
  /// \throws std::invalid_argument for a number out of range
  explicit CalmBodies(const ChatterDetectorOptions& options = {});

  /// Adds the world after a step (and at the start).
  /// \param in_contact  see ChatterDetector::add()
  /// \throws std::invalid_argument as ChatterDetector::add()
  void add(const World& world, std::span<const char> in_contact);

  /// Whether a body is calm; false also for a body that is absent or immovable.
  [[nodiscard]] bool calm(BodyId id) const;

  /// The detector, as of the last step.
  [[nodiscard]] const ChatterDetector& detector() const { return detector_; }

 private:
  struct Anchor {
    BodyId id{};
    Placement place;  // [m] where the body became calm
  };

  ChatterDetector detector_;
  std::vector<Anchor> anchors_;  // of the calm bodies, ascending by id
  std::vector<Anchor> next_;     // storage
};

/// A technique in which islands that only chatter fall asleep.
///
/// Calm bodies (CalmBodies) count as slow for the technique's SleepingRule, at any speed: an island
/// sleeps once all of its bodies have been slow or calm for tolerance::sleeping_time and it touches an
/// immovable body. The rest is that rule's: the lost energy is booked as damping, and the island wakes
/// when touched or pushed. Poses do not change in the frame in which it falls asleep.
///
/// The technique must have its own sleeping switched on, otherwise this one has no effect. AdaptiveStep
/// must wrap this technique: inside it, only contacts of the last sub-step would be seen. If a world's
/// time is before that of the last step, as in an earlier copy, the memory is cleared: no body is calm.
/// \par Cost
/// A step of the detector for each body, asleep or not; a classification for each that is not calm.
/// \algorithm{Chatter detected from earlier steps: section 6.3.1}
/// \verified{An island that only chatters falls asleep if chatter is detected from history, and not otherwise}
class FreezeOnChatter : public Cloned<WrappedTechnique, FreezeOnChatter> {
 public:
  /// Wraps a technique.
  /// \param technique  with sleeping on; owned by the wrapper
  /// \throws std::invalid_argument for no technique, or a number out of range
  explicit FreezeOnChatter(std::unique_ptr<Technique> technique,
                           const ChatterDetectorOptions& options = {});

  StepReport step(World& world, double dt) override;

  /// The calm bodies, as of the last step.
  [[nodiscard]] const CalmBodies& calm_bodies() const { return calm_; }

 private:
  CalmBodies calm_;
  double last_time_ = 0.0;        // [s] world time after the last step
  std::vector<char> in_contact_;  // storage
  std::vector<char> slow_;        // storage: the calm bodies by index
};

}  // namespace tumble
