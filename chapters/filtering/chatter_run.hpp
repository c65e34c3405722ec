/// \file
/// \brief Shaking of the bodies of a scene under a technique once they should rest (thesis 5.5).
#pragma once

#include "tumble/record/chatter.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// What became of a scene that should come to rest. The same measure for all techniques:
// contact follows from the poses, within the distance of `tolerance::touching`.
struct ChatterRun {
  // Those that rest, half second by half second, from the settling to the end: see ChatterMeter.
  // Their measures are means over the half seconds.
  std::vector<BodyChatter> resting;
  int bodies = 0;                    // how many can move
  double displaced = 0.0;            // [m] from its start, of the centre that got farthest
  bool solved = true;                // false: a step was not solved, and nothing rests
  std::int64_t steps = 0;            // that were done
  std::int64_t capped = 0;           // steps that met the cap of events
  std::int64_t last_collisions = 0;  // that were resolved while the bodies were watched

  // The largest amplitude of a body that rests.
  // Returns [m] NaN if nothing rests
  [[nodiscard]] double amplitude() const;
  // The largest acceleration of a body that rests.
  // Returns [-] 1 is a free fall; NaN if nothing rests
  [[nodiscard]] double acceleration() const;
  // How many do not rest.
  [[nodiscard]] int restless() const { return bodies - static_cast<int>(resting.size()); }
};

// Simulates a scene of cubes with 60 steps a second and measures its chatter.
// settling: [s] before bodies should rest
// watched: [s] after that, half a second or more
ChatterRun chatter_of(const Scene& scene, const PlayedTechnique& played, double settling,
                      double watched, std::uint64_t seed = 1);

}  // namespace tumble::chapters
