/// \file
/// \brief The order in which a technique resolves collisions, held against another order (thesis
///        5.1).
#pragma once

#include "tumble/base/number_text.hpp"
#include "tumble/dynamics/trajectory.hpp"

#include "driver/experiment.hpp"

#include <tuple>

namespace tumble::chapters {

// A collision that was resolved.
struct Collision {
  double time = 0.0;  // [s] since the start of the story
  int first = 0;      // index of a body
  int second = 0;     // index of the other one, above the first
};

// The reference of stories: a search over all bodies that misses nothing, all of them taken back for
// each collision. Meant for steps much smaller than a frame.
// resolution: [s] how exactly collisions are searched for
inline std::unique_ptr<Technique> search_over_all(double resolution = 1e-9) {
  return make_technique("basic", {"search=conservative", "event_cap=100000",
                                  "resolution=" + shortest_text(resolution)});
}

// Runs a technique and keeps its events.
inline EventLog events_of(Technique& technique, World& world, double dt, int frames = 1) {
  EventRecorder recorder;
  technique.observe(&recorder);
  for (int frame = 0; frame < frames; ++frame) finished(technique.step(world, dt));
  technique.observe(nullptr);
  return recorder.events();
}

// Events as a story.
inline std::vector<Collision> story_of(const EventLog& events, const World& start) {
  std::vector<Collision> story;
  for (const Event& event : events) {
    const int first = start.index_of(event.first);
    const int second = start.index_of(event.second);
    story.push_back({event.time - start.time(), std::min(first, second), std::max(first, second)});
  }
  return story;
}

// Runs a technique and writes down the collisions.
inline std::vector<Collision> story_of(Technique& technique, World world, double dt,
                                       int frames = 1) {
  const World start = world;
  return story_of(events_of(technique, world, dt, frames), start);
}

// The difference of a story from another one that is taken for true.
//
// The k-th collision of a pair in one story and the k-th of the same pair in the other are
// *partners*. The partners that both stories have in the same order, as many as there can be, are
// *in place* (the longest common subsequence). Times are not compared.
struct StoryDifference {
  int reference = 0;        // collisions of the true story
  int missed = 0;           // of the true story, without a partner
  int misordered = 0;       // with a partner, and not in place
  int invented = 0;         // of the tested story, without a partner
  std::vector<char> wrong;  // by collision of the tested story: 1 if it is not in place, else 0
};

// The pair of a collision, and its number among the collisions of this pair.
using Name = std::tuple<int, int, int>;

inline std::vector<Name> names_of(const std::vector<Collision>& story) {
  std::map<std::pair<int, int>, int> met;
  std::vector<Name> names;
  for (const Collision& collision : story)
    names.emplace_back(collision.first, collision.second,
                       met[{collision.first, collision.second}]++);
  return names;
}

// Places of a longest ascending choice of different numbers.
inline std::vector<std::size_t> longest_ascending(const std::vector<std::size_t>& numbers) {
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t>
      last;  // by length - 1: place of the least number that ends such a choice
  std::vector<std::size_t> before(numbers.size(), kNone);
  for (std::size_t place = 0; place < numbers.size(); ++place) {
    const auto longer = std::lower_bound(
        last.begin(), last.end(), numbers[place],
        [&](std::size_t other, std::size_t number) { return numbers[other] < number; });
    if (longer != last.begin()) before[place] = *(longer - 1);
    if (longer == last.end())
      last.push_back(place);
    else
      *longer = place;
  }
  std::vector<std::size_t> places;
  if (!last.empty())
    for (std::size_t place = last.back(); place != kNone; place = before[place])
      places.push_back(place);
  return places;
}

// Holds a story against another one.
//
// Where several choices have as many collisions in place, the one is taken whose last collision
// comes first in the true story.
// \par Cost
// n log n
inline StoryDifference compare_stories(const std::vector<Collision>& reference,
                                       const std::vector<Collision>& tested) {
  std::map<Name, std::size_t> place_of;
  for (const Name& name : names_of(reference)) place_of.emplace(name, place_of.size());

  std::vector<std::size_t>
      partner_places;                      // in the true story, of tested collisions with a partner
  std::vector<std::size_t> tested_places;  // in the tested story, of the same
  const std::vector<Name> names = names_of(tested);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto partner = place_of.find(names[k]);
    if (partner == place_of.end()) continue;
    partner_places.push_back(partner->second);
    tested_places.push_back(k);
  }

  StoryDifference difference;
  difference.wrong.assign(tested.size(), 1);
  const std::vector<std::size_t> in_place = longest_ascending(partner_places);
  for (const std::size_t k : in_place) difference.wrong[tested_places[k]] = 0;
  difference.reference = static_cast<int>(reference.size());
  difference.missed = static_cast<int>(reference.size() - partner_places.size());
  difference.misordered = static_cast<int>(partner_places.size() - in_place.size());
  difference.invented = static_cast<int>(tested.size() - partner_places.size());
  return difference;
}

}  // namespace tumble::chapters
