/// \file
/// \brief What the forms of the timewarp tell of a frame, held against the truth (thesis 5.1).
#pragma once

#include "tumble/basic_colliding/basic.hpp"
#include "tumble/timewarp/timewarp_safer.hpp"
#include "tumble/timewarp/timewarp_simple.hpp"
#include "tumble/timewarp/timewarp_swept.hpp"

#include "timewarp/event_story.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace tumble::chapters {

/// How stories of frames depart from the true ones, in all.
struct StoryTally {
  std::int64_t frames = 0;      ///< stories
  std::int64_t told_wrong = 0;  ///< those with a collision missed or out of order
  double reference = 0.0;       ///< collisions of the true stories
  double missed = 0.0;          ///< see StoryDifference
  double misordered = 0.0;      ///< ditto

  /// Adds a frame.
  /// \param difference  of its story
  void add(const StoryDifference& difference);
  /// Adds frames.
  /// \param other  theirs
  void add(const StoryTally& other);
  /// Collisions that are not where they belong.
  /// \return missed and out of order
  [[nodiscard]] double wrong() const { return missed + misordered; }
};

/// One for each form of the timewarp: simple, safer, swept.
using StoryForms = std::array<StoryTally, 3>;

/// The forms of the timewarp and two references, all with one tolerance.
class StoryTellers {
 public:
  /// Makes them.
  /// \param resolution  [s] of every search for collisions, above 0
  explicit StoryTellers(double resolution);

  /// The true story of a frame: a search over all bodies that misses nothing.
  /// \param world  at its start
  /// \param dt     [s] its length
  /// \return the collisions
  [[nodiscard]] std::vector<Collision> truth(const World& world, double dt);

  /// The same with a tenth of the tolerance.
  /// \param world  at its start
  /// \param dt     [s] its length
  /// \return the collisions
  [[nodiscard]] std::vector<Collision> finer(const World& world, double dt);

  /// The other reference: all bodies are tested at the end of each of many small steps.
  /// \param world  at the frame's start
  /// \param dt     [s] its length
  /// \param steps  how many
  /// \return the collisions
  [[nodiscard]] std::vector<Collision> in_steps(const World& world, double dt, int steps);

  /// Lets the three forms tell a frame.
  /// \param world  at its start
  /// \param dt     [s] its length
  /// \param truth  its true story
  /// \param forms  gets how they depart from it
  void hear(const World& world, double dt, const std::vector<Collision>& truth, StoryForms& forms);

 private:
  TimewarpSimple simple_;
  TimewarpSafer safer_;
  TimewarpSwept swept_;
  std::unique_ptr<Technique> reference_;
  std::unique_ptr<Technique> finer_;
  Basic discrete_;
};

}  // namespace tumble::chapters
