/// \file
/// \brief Figure 5.1: the order in which five cubes meet, by four techniques (thesis 5.1).
#include "timewarp/bands.hpp"
#include "timewarp/event_story.hpp"

#include <iterator>

namespace tumble::chapters {
namespace {

constexpr double kMilliseconds = 1e3;  // [ms/s]

// One frame as a technique resolves it.
struct FrameStory {
  std::vector<Collision> collisions;
  std::vector<Way> ways;  // by body
  std::vector<Outline> overlaps;
};

FrameStory frame_story(const World& start, Technique& technique, double frame, int steps = 1) {
  World world = start;
  const EventLog events = events_of(technique, world, frame / steps, steps);

  // [m] cubes that touch are nearer than the rounding of their places.
  constexpr double least = 1e-9;
  FrameStory story{story_of(events, start), ways_of(start, events, frame), {}};
  const double width = start.bodies().front().size.x();
  for (std::size_t a = 0; a < story.ways.size(); ++a) {
    for (std::size_t b = a + 1; b < story.ways.size(); ++b) {
      auto areas = overlaps_of(story.ways[a], story.ways[b], width, least);
      std::move(areas.begin(), areas.end(), std::back_inserter(story.overlaps));
    }
  }
  return story;
}

// [s] for which two bodies overlap, summed over pairs of bodies.
double time_of_overlap(const FrameStory& story) {
  double time = 0.0;
  for (const Outline& area : story.overlaps) {
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
double largest_difference(const std::vector<Collision>& tested,
                          const std::vector<Collision>& reference) {
  double largest = 0.0;
  for (std::size_t k = 0; k < std::min(tested.size(), reference.size()); ++k)
    largest = std::max(largest, std::abs(tested[k].time - reference[k].time));
  return largest;
}

Table scene_table(const World& start, double frame) {
  Table table{"scene",
              {{"body", "-", "0 is A"},
               {"place_edges", "edges", "centre at the start"},
               {"end_edges", "edges", "centre at the end of the frame without collisions"},
               {"speed_m_s", "m/s", "along x"},
               {"frame_ms", "ms", "length of the frame"}}};
  const double edge = start.bodies().front().size.x();
  const std::vector<Way> free = ways_of(start, {}, frame);
  for (std::size_t k = 0; k < free.size(); ++k)
    table.add(k, free[k].front().place / edge, free[k].back().place / edge,
              velocity(start.bodies()[k], start.states()[k]).x(),
              free[k].back().time * kMilliseconds);
  return table;
}

// Figure 5.1 and claim 5.1b: one frame of five cubes on a line. Panels count the techniques from 0.
Result measure_order_of_five(const Parameters& settings) {
  static constexpr std::array<const char*, 3> names = {"simple", "safer", "swept"};
  const World start = build_world(checked(scene_recipe("fig5_1").build(settings, Random(1))));
  const double frame = settings.number("frame");
  const double edge = settings.number("size");
  std::vector<FrameStory> stories;
  for (const char* name : names)
    stories.push_back(frame_story(start, *make_technique(std::string("timewarp_") + name), frame));
  stories.push_back(
      frame_story(start, *search_over_all(), frame, settings.count("reference_steps")));
  const std::vector<Collision> reference = stories.back().collisions;

  Table events{"",
               {{"panel", "-", "0 simple, 1 safer, 2 swept, 3 reference"},
                {"number", "-", "when it was resolved, from 1"},
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
      table.add(panel, which, corner.place / edge, corner.time * kMilliseconds);
  };

  std::vector<StoryDifference> differences;
  for (std::size_t panel = 0; panel < stories.size(); ++panel) {
    const FrameStory& story = stories[panel];
    differences.push_back(compare_stories(reference, story.collisions));
    for (std::size_t k = 0; k < story.collisions.size(); ++k) {
      const auto [time, first, second] = story.collisions[k];
      const double place = 0.5 * (place_at(story.ways[static_cast<std::size_t>(first)], time) +
                                  place_at(story.ways[static_cast<std::size_t>(second)], time));
      events.add(panel, k + 1, place / edge, time * kMilliseconds, differences.back().wrong[k]);
    }
    for (std::size_t body = 0; body < story.ways.size(); ++body)
      add_outline(bands, panel, body, band_of(story.ways[body], edge));
    for (std::size_t area = 0; area < story.overlaps.size(); ++area)
      add_outline(overlaps, panel, area, story.overlaps[area]);
  }

  std::vector<Quantity> quantities = {
      {"of three sayings about figure 5.1 those that hold: simple goes wrong, safer goes wrong, "
       "swept volumes do not",
       "-", goes_wrong(differences[0]) + goes_wrong(differences[1]) + !goes_wrong(differences[2])},
      {"collisions of the reference", "-", reference.size()},
      {"collisions of the reference that simple has none for", "-", differences[0].missed},
      {"largest difference of the times of collisions, swept and reference", "s",
       largest_difference(stories[2].collisions, reference)}};
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::vector<char>& wrong = differences[k].wrong;
    quantities.push_back(
        {std::string("collisions out of place, ") + names[k], "-", std::ranges::count(wrong, 1)});
    quantities.push_back({std::string("time for which pairs of cubes overlap, ") + names[k], "s",
                          time_of_overlap(stories[k])});
  }
  return {{events, bands, overlaps, scene_table(start, frame)}, quantities};
}

std::vector<Figure> figure_of_five() {
  Parameters parameters = scene_recipe("fig5_1").parameters();
  parameters.add(number("frame", 1.0 / 60.0, 1e-4, 1.0, "s", "length of the frame"))
      .add(whole("reference_steps", 1000, 1, 100000, "steps of the reference in the frame"));
  return {{.name = "fig5_1_order", .parameters = parameters, .experiment = measure_order_of_five}};
}
const Registered fig5_1_order_figure(figure_of_five);

}  // namespace
}  // namespace tumble::chapters
