/// \file
/// \brief A box turns on a box that turns, centres and orientations moved apart and together (figure 6.3).
#include "exterior_rotation/coarse_film.hpp"
#include "exterior_rotation/held_run.hpp"
#include "exterior_rotation/nested_pendulum.hpp"
#include "exterior_rotation/side_view.hpp"

namespace tumble::chapters {
namespace {

struct NestedRun {
  FilmScheme scheme;
  bool exponential = false;  // or centres and orientations apart
  HeldRun run;
};

// film_schemes() and the leapfrog; then those that can also move bodies by the exponential.
std::vector<NestedRun> nested_runs(const Parameters& settings) {
  const double dt = 1.0 / settings.number("rate");
  const auto steps = static_cast<int>(std::lround(settings.number("duration") / dt));
  const World start = build_world(make_scene("fig6_3"));
  std::vector<FilmScheme> schemes(film_schemes().begin(), film_schemes().end());
  schemes.push_back({"leapfrog", "leapfrog", GluedScheme::leapfrog});
  std::vector<NestedRun> runs;
  for (const FilmScheme& scheme : schemes)
    runs.push_back({scheme, false, run_held(start, options_of(scheme), dt, steps)});
  for (const std::size_t k : {0U, 1U, 2U, 6U})
    runs.push_back({schemes[k], true,
                    run_held(start, options_of(schemes[k], PoseUpdate::exponential), dt, steps)});
  return runs;
}
constexpr std::size_t kReference = 5;  // places in nested_runs()
constexpr std::size_t kLeapfrog = 6;
constexpr std::size_t kTogether = 7;  // forward Euler, and then in the same order

constexpr std::size_t kLower = 0;  // of joints: on the larger box
constexpr std::size_t kUpper = 1;  // between the two that turn

Table apart_over_time(const std::vector<NestedRun>& nested) {
  Table table{"", {{"time_s", "s", "since the start"}}};
  for (const NestedRun& n : nested)
    for (const std::string joint : {"lower", "upper"})
      table.columns.push_back({n.scheme.column + (n.exponential ? "_exp_" : "_") + joint + "_m",
                               "m",
                               joint + " edge from itself, " + n.scheme.words +
                                   (n.exponential ? ", exponential" : "")});
  for (std::size_t k = 0; k < nested[0].run.frames.size(); ++k) {
    std::vector<double> row;
    for (const NestedRun& n : nested)
      for (const std::size_t joint : {kLower, kUpper})
        row.push_back(n.run.frames[k].gaps[joint].apart);
    table.add(nested[0].run.frames[k].time, row);
  }
  return table;
}

void draw_nested(const std::vector<NestedRun>& nested, const Parameters& settings, Result& result) {
  FilmLayout layout{.low = Vec2(-2.1, 1.1),
                    .high = Vec2(2.3, 4.75),
                    .magnification = settings.number("magnification"),
                    .inset = 90.0,
                    .bar = 0.01};
  layout.put_inset_above();
  const HeldRun& shown = nested.front().run;
  Table times{"frames", {{"time_s", "s", "of the frame"}}};
  for (int k = 1; k <= kFilmFrames; ++k) {
    const HeldFrame& frame = shown.at(film_time(settings, k));
    const HeldFrame& exact = nested[kReference].run.at(film_time(settings, k));
    // Circles and pivots are where they should be.
    const Vec2 lower = held_point(shown.joints[kLower], exact.states).first_w.head<2>();
    const Vec2 upper = held_point(shown.joints[kUpper], exact.states).first_w.head<2>();
    const JointPoint place = held_point(shown.joints[kUpper], frame.states);
    const auto centre = [&](std::size_t joint) -> Vec2 {
      const int body = shown.joints[joint].second;
      return exact.states[static_cast<std::size_t>(body)].position_w.head<2>();
    };
    const SideViewFrame film{frame.states,
                             exact.states,
                             {lower, upper},
                             0.5 * (place.first_w + place.second_w).head<2>(),
                             {{lower, (centre(kLower) - lower).norm(), {film_colour::pivot, 1.0}},
                              {lower, (upper - lower).norm(), {film_colour::pivot, 1.0, true}},
                              {upper, (centre(kUpper) - upper).norm(), {film_colour::pivot, 1.8}}}};
    add_film_frame(shown.start, layout, film, k, result);
    times.add(frame.time);
  }
  result.drawings.push_back(layout.drawing());
  result.tables.push_back(times);
}

double largest_apart(const HeldRun& run, std::size_t joint) {
  return largest_of(run.frames, [&](const HeldFrame& frame) { return frame.gaps[joint].apart; });
}

Result measure_nested(const Parameters& settings) {
  const std::vector<NestedRun> nested = nested_runs(settings);
  Result result{.tables = {apart_over_time(nested)}};
  draw_nested(nested, settings, result);
  const auto upper = [&](std::size_t k) { return 1e3 * largest_apart(nested[k].run, kUpper); };
  result.quantities = {
      {"largest distance of the lower edge from itself, forward Euler", "mm",
       1e3 * largest_apart(nested[0].run, kLower)},
      {"the same, exponential", "m", largest_apart(nested[kTogether].run, kLower)},
      {"largest distance of the upper edge from itself, forward Euler", "mm", upper(0)},
      {"the same of the upper edge, forward Euler, exponential", "mm", upper(kTogether)},
      {"the same of the upper edge, semi-implicit", "mm", upper(1)},
      {"the same of the upper edge, semi-implicit, exponential", "mm", upper(kTogether + 1)},
      {"the same of the upper edge, impulses", "mm", upper(2)},
      {"the same of the upper edge, impulses, exponential", "mm", upper(kTogether + 2)},
      {"the same of the upper edge, leapfrog", "mm", upper(kLeapfrog)},
      {"the same of the upper edge, leapfrog, exponential", "mm", upper(kTogether + 3)}};
  const HeldRun& reference = nested[kReference].run;
  const HeldFrame& last = reference.frames.back();
  const NestedAngles found = nested_angles(reference.world(last));
  const NestedAngles judged = nested_pendulum(reference.start, last.time);
  result.add("larger of both angles' distances from GSL's double pendulum, reference", "rad",
             std::max(std::abs(found.lower - judged.lower), std::abs(found.upper - judged.upper)));
  result.film = [] {
    return coarse_film(build_world(make_scene("fig6_3")), {.step = 0.075, .steps = 8});
  };
  return result;
}

const Registered fig6_3_nested_figure{{.name = "fig6_3_nested",
                                       .parameters = film_parameters({}, 0.6, {0.0, 0.6}),
                                       .quick = {"rate=30"},
                                       .experiment = measure_nested}};

}  // namespace
}  // namespace tumble::chapters
