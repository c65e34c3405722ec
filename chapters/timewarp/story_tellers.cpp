/// \file
/// \brief What the forms of the timewarp tell of a frame, held against the truth (thesis 5.1).
#include "timewarp/story_tellers.hpp"

namespace tumble::chapters {
namespace {

// Any options with the tolerance of the search set.
template <class Options>
Options with(double resolution) {
  Options options;
  options.resolution = resolution;
  return options;
}

}  // namespace

void StoryTally::add(const StoryDifference& difference) {
  ++frames;
  if (difference.missed + difference.misordered > 0) ++told_wrong;
  reference += difference.reference;
  missed += difference.missed;
  misordered += difference.misordered;
}

void StoryTally::add(const StoryTally& other) {
  frames += other.frames;
  told_wrong += other.told_wrong;
  reference += other.reference;
  missed += other.missed;
  misordered += other.misordered;
}

StoryTellers::StoryTellers(double resolution)
    : simple_(with<TimewarpOptions>(resolution)),
      safer_(with<TimewarpOptions>(resolution)),
      swept_(with<TimewarpSweptOptions>(resolution)),
      reference_(search_over_all(resolution)),
      finer_(search_over_all(0.1 * resolution)),
      discrete_(with<BasicOptions>(resolution)) {}

std::vector<Collision> StoryTellers::truth(const World& world, double dt) {
  return story_of(*reference_, world, dt);
}

std::vector<Collision> StoryTellers::finer(const World& world, double dt) {
  return story_of(*finer_, world, dt);
}

std::vector<Collision> StoryTellers::in_steps(const World& world, double dt, int steps) {
  return story_of(discrete_, world, dt / steps, steps);
}

void StoryTellers::hear(const World& world, double dt, const std::vector<Collision>& truth,
                        StoryForms& forms) {
  const std::array<Technique*, 3> tellers = {&simple_, &safer_, &swept_};
  for (std::size_t k = 0; k < forms.size(); ++k)
    forms[k].add(compare_stories(truth, story_of(*tellers[k], world, dt)));
}

}  // namespace tumble::chapters
