/// \file
/// \brief The order in which a technique resolves collisions, held against another order (thesis
///        5.1).
#include "timewarp/event_story.hpp"

#include "tumble/base/number_text.hpp"
#include "tumble/dynamics/trajectory.hpp"

#include "driver/finished.hpp"

#include <tuple>

namespace tumble::chapters {
namespace {

// The pair of a collision, and its number among the collisions of this pair.
using Name = std::tuple<int, int, int>;

std::vector<Name> names_of(const std::vector<Collision>& story) {
  std::map<std::pair<int, int>, int> met;
  std::vector<Name> names;
  for (const Collision& collision : story)
    names.emplace_back(collision.first, collision.second,
                       met[{collision.first, collision.second}]++);
  return names;
}

// Places of a longest ascending choice of different numbers.
std::vector<std::size_t> longest_ascending(const std::vector<std::size_t>& numbers) {
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

}  // namespace

std::unique_ptr<Technique> search_over_all(double resolution) {
  return make_technique("basic", {"search=conservative", "event_cap=100000",
                                  "resolution=" + shortest_text(resolution)});
}

EventLog events_of(Technique& technique, World& world, double dt, int frames) {
  EventRecorder recorder;
  technique.observe(&recorder);
  for (int frame = 0; frame < frames; ++frame) finished(technique.step(world, dt));
  technique.observe(nullptr);
  return recorder.events();
}

std::vector<Collision> story_of(const EventLog& events, const World& start) {
  std::vector<Collision> story;
  for (const Event& event : events) {
    const int first = start.index_of(event.first);
    const int second = start.index_of(event.second);
    story.push_back({event.time - start.time(), std::min(first, second), std::max(first, second)});
  }
  return story;
}

std::vector<Collision> story_of(Technique& technique, World world, double dt, int frames) {
  const World start = world;
  return story_of(events_of(technique, world, dt, frames), start);
}

StoryDifference compare_stories(const std::vector<Collision>& reference,
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
