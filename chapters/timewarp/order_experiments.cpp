/// \file
/// \brief Figure 5.1: in which order five cubes meet, by four techniques (thesis 5.1).
#include "timewarp/order_experiments.hpp"

#include "tumble/base/random.hpp"
#include "tumble/scenes/library.hpp"

#include "driver/settings.hpp"
#include "timewarp/bands.hpp"
#include "timewarp/event_story.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace tumble::chapters {
namespace {

constexpr double kMilliseconds = 1e3;  // [ms/s]

// How a technique tells one frame.
struct Telling {
  std::vector<Collision> story;
  std::vector<Way> ways;  // by body
  std::vector<Outline> overlaps;
};

Telling tell(const World& start, Technique& technique, double frame, int steps = 1) {
  World world = start;
  const EventLog events = events_of(technique, world, frame / steps, steps);

  // [m] cubes that touch are nearer than the rounding of their places.
  constexpr double least = 1e-9;
  Telling telling{story_of(events, start), ways_of(start, events, frame), {}};
  const double width = start.bodies().front().size.x();
  for (std::size_t a = 0; a < telling.ways.size(); ++a) {
    for (std::size_t b = a + 1; b < telling.ways.size(); ++b) {
      auto areas = overlaps_of(telling.ways[a], telling.ways[b], width, least);
      std::move(areas.begin(), areas.end(), std::back_inserter(telling.overlaps));
    }
  }
  return telling;
}

// [s] for which two bodies overlap, summed over pairs of bodies.
double time_of_overlap(const Telling& telling) {
  double time = 0.0;
  for (const Outline& area : telling.overlaps) {
    const auto [first, last] = std::minmax_element(
        area.begin(), area.end(), [](const Knot& a, const Knot& b) { return a.time < b.time; });
    time += last->time - first->time;
  }
  return time;
}

bool goes_wrong(const StoryDifference& difference) {
  return difference.missed + difference.misordered + difference.invented > 0;
}

// [s] the largest difference of times of collisions with the same place in both stories.
double largest_difference(const Telling& tested, const Telling& reference) {
  double largest = 0.0;
  for (std::size_t k = 0; k < std::min(tested.story.size(), reference.story.size()); ++k)
    largest = std::max(largest, std::abs(tested.story[k].time - reference.story[k].time));
  return largest;
}

Table scene_table(const World& start, const Telling& free) {
  Table table{"scene",
              {{"body", "-", "0 is A"},
               {"place_edges", "edges", "centre at the start"},
               {"end_edges", "edges", "centre at the end of the frame if it meets nobody"},
               {"speed_m_s", "m/s", "along x"},
               {"frame_ms", "ms", "length of the frame"},
               {"edge_m", "m", "of a cube"}}};
  const double edge = start.bodies().front().size.x();
  for (std::size_t k = 0; k < free.ways.size(); ++k) {
    const Way& way = free.ways[k];
    const double speed = velocity(start.bodies()[k], start.states()[k]).x();
    table.rows.push_back({static_cast<double>(k), way.front().place / edge, way.back().place / edge,
                          speed, way.back().time * kMilliseconds, edge});
  }
  return table;
}

}  // namespace

Result measure_order_of_five(const Parameters& settings) {
  const World start = build_world(checked(scene_recipe("fig5_1").build(settings, Random(1))));
  const double frame = settings.number("frame");
  const double edge = settings.number("size");
  std::vector<Telling> tellings;
  for (const char* name : {"timewarp_simple", "timewarp_safer", "timewarp_swept"})
    tellings.push_back(tell(start, *make_technique(name), frame));
  tellings.push_back(tell(start, *search_over_all(), frame, settings.count("reference_steps")));
  const Telling& reference = tellings.back();
  const std::vector<std::string> names = {"simple", "safer", "swept", "reference"};

  Table events{"",
               {{"panel", "-", "0 simple, 1 safer, 2 swept, 3 reference"},
                {"number", "-", "when it was resolved, from 1"},
                {"first", "-", "body, 0 is A"},
                {"second", "-", "body"},
                {"place_edges", "edges", "halfway between the two"},
                {"time_ms", "ms", "since the start of the frame"},
                {"wrong", "-", "1: not in its place in the story of the reference"}}};
  Table bands{"bands",
              {{"panel", "-", "as in the main table"},
               {"body", "-", "0 is A"},
               {"place_edges", "edges", "of a corner of its band"},
               {"time_ms", "ms", "ditto"}}};
  Table overlaps{"overlaps",
                 {{"panel", "-", "as in the main table"},
                  {"area", "-", "which, from 0"},
                  {"place_edges", "edges", "of a corner of an area where two bands overlap"},
                  {"time_ms", "ms", "ditto"}}};
  const auto add_outline = [&](Table& table, std::size_t panel, std::size_t which,
                               const Outline& outline) {
    for (const Knot& corner : outline)
      table.rows.push_back({static_cast<double>(panel), static_cast<double>(which),
                            corner.place / edge, corner.time * kMilliseconds});
  };

  std::vector<StoryDifference> differences;
  std::vector<Quantity> quantities;
  for (std::size_t panel = 0; panel < tellings.size(); ++panel) {
    const Telling& telling = tellings[panel];
    differences.push_back(compare_stories(reference.story, telling.story));
    for (std::size_t k = 0; k < telling.story.size(); ++k) {
      const auto [time, first, second] = telling.story[k];
      const double place = 0.5 * (place_at(telling.ways[static_cast<std::size_t>(first)], time) +
                                  place_at(telling.ways[static_cast<std::size_t>(second)], time));
      events.rows.push_back({static_cast<double>(panel), static_cast<double>(k + 1),
                             static_cast<double>(first), static_cast<double>(second), place / edge,
                             time * kMilliseconds,
                             static_cast<double>(differences.back().wrong[k])});
    }
    for (std::size_t body = 0; body < telling.ways.size(); ++body)
      add_outline(bands, panel, body, band_of(telling.ways[body], edge));
    for (std::size_t area = 0; area < telling.overlaps.size(); ++area)
      add_outline(overlaps, panel, area, telling.overlaps[area]);
  }

  const double holding = static_cast<double>(goes_wrong(differences[0])) +
                         static_cast<double>(goes_wrong(differences[1])) +
                         static_cast<double>(!goes_wrong(differences[2]));
  quantities.push_back(
      {"of three sayings about figure 5.1 those that hold: simple goes wrong, safer goes wrong, "
       "swept volumes do not",
       "-", holding});
  quantities.push_back(
      {"collisions of the reference", "-", static_cast<double>(reference.story.size())});
  for (std::size_t k = 0; k < 3; ++k) {
    const auto wrong = std::count(differences[k].wrong.begin(), differences[k].wrong.end(), 1);
    quantities.push_back({"collisions out of place, " + names[k], "-", static_cast<double>(wrong)});
  }
  quantities.push_back({"collisions of the reference that simple has none for", "-",
                        static_cast<double>(differences[0].missed)});
  quantities.push_back({"largest difference of the times of collisions, swept and reference", "s",
                        largest_difference(tellings[2], reference)});
  for (std::size_t k = 0; k < 3; ++k)
    quantities.push_back(
        {"time for which pairs of cubes overlap, " + names[k], "s", time_of_overlap(tellings[k])});
  return {{events, bands, overlaps, scene_table(start, {{}, ways_of(start, {}, frame), {}})},
          quantities};
}

}  // namespace tumble::chapters
