/// \file
/// \brief A box turns on a box that turns, centres and orientations moved apart and together (figure 6.3).
#include "driver/played_scene.hpp"
#include "exterior_rotation/film_schemes.hpp"
#include "exterior_rotation/nested_pendulum.hpp"
#include "exterior_rotation/problem_experiments.hpp"
#include "exterior_rotation/side_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace tumble::chapters {
namespace {

constexpr int kFrames = 4;

// Schemes that can also move bodies by the exponential, and the leapfrog beside them.
const std::array<FilmScheme, 4>& both_ways() {
  static const std::array<FilmScheme, 4> kSchemes = {
      {film_schemes()[0],
       film_schemes()[1],
       film_schemes()[2],
       {"leapfrog", "leapfrog", GluedScheme::leapfrog}}};
  return kSchemes;
}

struct Nested {
  double dt = 0.0;                // [s]
  std::vector<HeldRun> separate;  // film_schemes(), then leapfrog
  std::vector<HeldRun> together;  // both_ways(), exponential
};

Nested nested_of(const Parameters& settings) {
  Nested nested;
  nested.dt = 1.0 / settings.number("rate");
  const auto steps = static_cast<int>(std::lround(settings.number("duration") / nested.dt));
  const World start = build_world(scene_with("fig6_3", {}));
  for (const FilmScheme& scheme : film_schemes())
    nested.separate.push_back(run_held(start, options_of(scheme), nested.dt, steps));
  nested.separate.push_back(run_held(start, options_of(both_ways()[3]), nested.dt, steps));
  for (const FilmScheme& scheme : both_ways())
    nested.together.push_back(
        run_held(start, options_of(scheme, PoseUpdate::exponential), nested.dt, steps));
  return nested;
}

constexpr std::size_t kLower = 0;  // of joints: on the larger box
constexpr std::size_t kUpper = 1;  // between the two that turn

Table apart_over_time(const Nested& nested) {
  Table table{"", {{"time_s", "s", "since the start"}}};
  const auto add = [&](const FilmScheme& scheme, const std::string& suffix,
                       const std::string& how) {
    for (const char* joint : {"lower", "upper"})
      table.columns.push_back({scheme.column + suffix + '_' + joint + "_m", "m",
                               std::string(joint) + " edge from itself, " + scheme.words + how});
  };
  for (const FilmScheme& scheme : film_schemes()) add(scheme, "", "");
  add(both_ways()[3], "", "");
  for (const FilmScheme& scheme : both_ways()) add(scheme, "_exp", ", exponential");
  for (std::size_t k = 0; k < nested.separate[0].frames.size(); ++k) {
    table.rows.push_back({nested.separate[0].frames[k].time});
    for (const auto* runs : {&nested.separate, &nested.together})
      for (const HeldRun& run : *runs)
        for (const std::size_t joint : {kLower, kUpper})
          table.rows.back().push_back(run.frames[k].gaps[joint].apart);
  }
  return table;
}

Vec2 flat(const Vec3& point_w) { return Vec2(point_w.x(), point_w.y()); }

void draw(const Nested& nested, const Parameters& settings, Result& result) {
  FilmLayout layout;
  layout.low = Vec2(-2.1, 1.1);
  layout.high = Vec2(2.3, 4.75);
  layout.magnification = settings.number("magnification");
  layout.bar = 0.01;
  layout.inset = 90.0;
  const double inset = layout.inset / layout.scale();
  const double margin = 2.0 / layout.scale();
  layout.inset_low = Vec2(layout.low.x() + margin, layout.high.y() - inset - margin);
  const HeldRun& shown = nested.separate.front();
  Table times{"frames",
              {{"time_s", "s", "of the frame"},
               {"lower_mm", "mm", "lower edge from itself in it, forward Euler"},
               {"upper_mm", "mm", "upper edge from itself in it, forward Euler"}}};
  for (int k = 1; k <= kFrames; ++k) {
    const double time = settings.number(std::string("t").append(std::to_string(k)));
    const HeldFrame& frame = shown.at(time);
    const HeldFrame& exact = nested.separate[5].at(time);
    // Circles and pivots are where they should be.
    const Vec2 lower = flat(held_point(shown.joints[kLower], exact.states).first_w);
    const Vec2 upper = flat(held_point(shown.joints[kUpper], exact.states).first_w);
    const JointPoint place = held_point(shown.joints[kUpper], frame.states);
    const FilmFrame film{
        frame.states, exact.states, {lower, upper}, flat(0.5 * (place.first_w + place.second_w))};
    SideView view = film_view(shown.start, layout, film);
    const auto centre = [&](std::size_t joint) {
      const int body = shown.joints[joint].second;
      return flat(exact.states[static_cast<std::size_t>(body)].position_w);
    };
    view.circle(lower, (centre(kLower) - lower).norm(), {film_colour::pivot, 1.0});
    view.circle(lower, (upper - lower).norm(), {film_colour::pivot, 1.0, true});
    view.circle(upper, (centre(kUpper) - upper).norm(), {film_colour::pivot, 1.8});
    result.drawings.push_back({"frame" + std::to_string(k), view.commands()});
    result.drawings.push_back(
        {"inset" + std::to_string(k), film_inset(shown.start, layout, film).commands()});
    times.rows.push_back(
        {frame.time, 1e3 * frame.gaps[kLower].apart, 1e3 * frame.gaps[kUpper].apart});
  }
  result.drawings.push_back(layout.drawing());
  result.tables.push_back(times);
}

double largest_apart(const HeldRun& run, std::size_t joint) {
  double largest = 0.0;
  for (const HeldFrame& frame : run.frames) largest = std::max(largest, frame.gaps[joint].apart);
  return largest;
}

}  // namespace

Result measure_nested(const Parameters& settings) {
  const Nested nested = nested_of(settings);
  Result result;
  result.tables.push_back(apart_over_time(nested));
  draw(nested, settings, result);
  const auto add = [&](const char* words, const HeldRun& run, std::size_t joint) {
    result.quantities.push_back({std::string(words), "mm", 1e3 * largest_apart(run, joint)});
  };
  add("largest distance of the lower edge from itself, forward Euler", nested.separate[0], kLower);
  result.quantities.push_back(
      {"the same, exponential", "m", largest_apart(nested.together[0], kLower)});
  add("largest distance of the upper edge from itself, forward Euler", nested.separate[0], kUpper);
  add("the same of the upper edge, forward Euler, exponential", nested.together[0], kUpper);
  add("the same of the upper edge, semi-implicit", nested.separate[1], kUpper);
  add("the same of the upper edge, semi-implicit, exponential", nested.together[1], kUpper);
  add("the same of the upper edge, impulses", nested.separate[2], kUpper);
  add("the same of the upper edge, impulses, exponential", nested.together[2], kUpper);
  add("the same of the upper edge, leapfrog", nested.separate[6], kUpper);
  add("the same of the upper edge, leapfrog, exponential", nested.together[3], kUpper);
  result.quantities.push_back(
      {"largest relative acceleration in a joint at the start of a step, over g, forward Euler",
       "-", nested.separate[0].acceleration / nested.separate[0].start.gravity_w.norm()});
  const HeldRun& reference = nested.separate[5];
  const HeldFrame& last = reference.frames.back();
  const NestedAngles found = nested_angles(reference.world(last));
  const NestedAngles judged = nested_pendulum(reference.start, last.time);
  result.quantities.push_back(
      {"larger of both angles' distances from GSL's double pendulum, reference", "rad",
       std::max(std::abs(found.lower - judged.lower), std::abs(found.upper - judged.upper))});
  return result;
}

}  // namespace tumble::chapters
