/// \file
/// \brief Boxes on a line as bands in a plane of place and time.
#pragma once

#include "driver/experiment.hpp"

namespace tumble::chapters {

// A point of the plane.
struct Knot {
  double time = 0.0;   // [s]
  double place = 0.0;  // [m] along x, world frame
};

// Where a centre is: straight lines from knot to knot, their times ascending.
using Way = std::vector<Knot>;

// A closed line around an area of the plane; the last knot is the first one again.
using Outline = std::vector<Knot>;

// The ways of bodies that fly freely between events, without gravity.
//
// They know nothing but the start and the impulses: each event changes the momenta of its two
// bodies. What a technique does besides, such as ending overlap, is not in them.
// end: [s] since the start, where the ways end
inline std::vector<Way> ways_of(const World& start, const EventLog& events, double end) {
  require::that(start.gravity_w.isZero(0.0), "bands have no gravity");
  std::vector<Way> ways;
  std::vector<double> momenta;  // [kg m/s] along x
  for (const BodyState& state : start.states()) {
    ways.push_back({{0.0, state.position_w.x()}});
    momenta.push_back(state.linear_momentum_w.x());
  }
  const auto go_on = [&](std::size_t body, double time) {
    const Knot last = ways[body].back();
    require::that(time >= last.time, "the events of a body go back in time");
    const double speed = momenta[body] * start.bodies()[body].inverse_mass;
    ways[body].push_back({time, last.place + speed * (time - last.time)});
  };
  for (const Event& event : events) {
    const auto first = static_cast<std::size_t>(start.index_of(event.first));
    const auto second = static_cast<std::size_t>(start.index_of(event.second));
    for (const std::size_t body : {first, second}) go_on(body, event.time - start.time());
    momenta[first] -= event.impulse_w.x();
    momenta[second] += event.impulse_w.x();
  }
  for (std::size_t body = 0; body < ways.size(); ++body) go_on(body, end);
  return ways;
}

// Where a centre is at a time.
// time: [s] before its first knot and after its last one the centre stays
// Returns [m] along x
inline double place_at(const Way& way, double time) {
  const auto after = std::upper_bound(way.begin(), way.end(), time,
                                      [](double t, const Knot& knot) { return t < knot.time; });
  if (after == way.begin()) return way.front().place;
  if (after == way.end()) return way.back().place;
  const Knot& before = *(after - 1);
  const double share = (time - before.time) / (after->time - before.time);
  return before.place + share * (after->place - before.place);
}

// Both edges of an area at a time.
struct Span {
  double time = 0.0;   // [s]
  double left = 0.0;   // [m]
  double right = 0.0;  // [m]
};

inline Outline outline_of(const std::vector<Span>& spans) {
  Outline outline;
  for (const Span& span : spans) outline.push_back({span.time, span.left});
  for (auto span = spans.rbegin(); span != spans.rend(); ++span)
    outline.push_back({span->time, span->right});
  if (!outline.empty()) outline.push_back(outline.front());
  return outline;
}

// The area that a body passes over.
// width: [m] of the body
inline Outline band_of(const Way& way, double width) {
  std::vector<Span> spans;
  for (const Knot& knot : way)
    spans.push_back({knot.time, knot.place - 0.5 * width, knot.place + 0.5 * width});
  return outline_of(spans);
}

// Where two bands lie on one another.
// width: [m] of both bodies, above 0
// least: [m] overlap that counts, above 0: bodies that touch do not overlap
inline std::vector<Outline> overlaps_of(const Way& first, const Way& second, double width,
                                        double least) {
  const auto apart = [&](double time) { return place_at(second, time) - place_at(first, time); };
  // Between two of these times both ways are straight, and neither overlap nor sides change.
  std::vector<double> times;
  for (const Way* way : {&first, &second})
    for (const Knot& knot : *way) times.push_back(knot.time);
  std::ranges::sort(times);
  for (std::size_t k = times.size(); k-- > 1;) {
    const double from = times[k - 1];
    const double to = times[k];
    for (const double level : {-width, 0.0, width}) {
      const double before = apart(from) - level;
      const double after = apart(to) - level;
      if (before * after < 0.0) times.push_back(from + (to - from) * before / (before - after));
    }
  }
  std::ranges::sort(times);

  std::vector<Outline> areas;
  std::vector<Span> spans;
  const auto add = [&](double time) {
    const double left = std::max(place_at(first, time), place_at(second, time)) - 0.5 * width;
    const double right = std::min(place_at(first, time), place_at(second, time)) + 0.5 * width;
    spans.push_back({time, left, std::max(left, right)});
  };
  const auto close = [&] {
    if (!spans.empty()) areas.push_back(outline_of(spans));
    spans.clear();
  };
  for (std::size_t k = 1; k < times.size(); ++k) {
    if (!(std::abs(apart(0.5 * (times[k - 1] + times[k]))) < width - least)) {
      close();
      continue;
    }
    if (spans.empty()) add(times[k - 1]);
    add(times[k]);
  }
  close();
  return areas;
}

}  // namespace tumble::chapters
