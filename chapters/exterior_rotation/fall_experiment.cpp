/// \file
/// \brief A column, or one box, falls over the edge of a larger one (figures 6.1 and 6.2).
#include "exterior_rotation/coarse_film.hpp"
#include "exterior_rotation/falling_column.hpp"
#include "exterior_rotation/glued_runs.hpp"
#include "exterior_rotation/held_run.hpp"
#include "exterior_rotation/side_view.hpp"

namespace tumble::chapters {
namespace {

constexpr double kMostAngle = 1.0;  // [rad] that a scene can begin with

// The settings, and the runs.
struct Fall {
  int boxes = 4;
  double angle = 0.3;  // [rad]
  double dt = 0.0;     // [s]
  std::vector<HeldRun> runs;
};

World world_at(int boxes, double angle, double rate) {
  if (boxes > 1) return column_world(angle, rate, boxes);
  return build_world(make_scene("fig6_2", {setting("angle", angle), setting("spin", rate)}));
}

Fall fall_of(const Parameters& settings) {
  Fall fall;
  fall.boxes = settings.count("boxes");
  fall.angle = settings.number("angle");
  fall.dt = 1.0 / settings.number("rate");
  const World start = world_at(fall.boxes, fall.angle, 0.0);
  const auto steps = static_cast<int>(std::lround(settings.number("duration") / fall.dt));
  for (const FilmScheme& scheme : film_schemes())
    fall.runs.push_back(run_held(start, options_of(scheme), fall.dt, steps));
  return fall;
}

// The gap that the figure is about: in the column's glue, or at the edge if there is one box.
double gap(const Fall& fall, const HeldRun& run, const HeldFrame& frame) {
  return widest(run, frame, fall.boxes > 1 ? JointHold::area : JointHold::edge);
}

Table gaps_over_time(const Fall& fall) {
  Table table{"", {{"time_s", "s", "since the start"}}};
  for (const FilmScheme& scheme : film_schemes()) {
    table.columns.push_back({scheme.column + "_mm", "mm", "gap, below 0 overlap, " + scheme.words});
    table.columns.push_back(
        {scheme.column + "_apart_m", "m", "largest distance of a corner from itself, same scheme"});
  }
  for (std::size_t k = 0; k < fall.runs[0].frames.size(); ++k) {
    std::vector<double> row;
    for (const HeldRun& run : fall.runs)
      row.insert(row.end(), {1e3 * gap(fall, run, run.frames[k]), farthest_apart(run.frames[k])});
    table.add(fall.runs[0].frames[k].time, row);
  }
  return table;
}

// [m] Length of the line along which a joint comes apart.
double joint_line(const Fall& fall) { return fall.boxes > 1 ? 1.0 : std::sqrt(0.5); }

// The gap that one step makes of an exact state, by schemes whose error can be seen.
Table gaps_of_steps(const Fall& fall) {
  Table table{"steps",
              {{"time_s", "s", "of the exact state that the step starts from"},
               {"arc_mm", "mm", "omega^2 h^2 s / 2"}}};
  for (std::size_t s = 0; s < kSeenSchemes; ++s)
    table.columns.push_back({film_schemes()[s].column + "_mm", "mm",
                             "gap after one step, below 0 overlap, " + film_schemes()[s].words});
  for (const HeldFrame& frame : fall.runs[0].frames) {
    const double angle = column_angle(frame.time, fall.angle, fall.boxes);
    if (angle > kMostAngle) break;
    const double rate = column_rate(frame.time, fall.angle, fall.boxes);
    const World exact = world_at(fall.boxes, angle, rate);
    std::vector<double> gaps;
    for (std::size_t s = 0; s < kSeenSchemes; ++s)
      gaps.push_back(1e3 * gap_of_step(exact, options_of(film_schemes()[s]), fall.dt));
    table.add(frame.time, 1e3 * 0.5 * rate * rate * fall.dt * fall.dt * joint_line(fall), gaps);
  }
  return table;
}

FilmLayout layout_of(const Fall& fall, const Parameters& settings) {
  FilmLayout layout;
  const double top = column_pivot().y();
  layout.magnification = settings.number("magnification");
  if (fall.boxes > 1) {
    const double long_ = fall.boxes;
    layout.low = Vec2(-2.1, top - 1.0);
    layout.high = Vec2(long_ + 0.25, top + long_ + 0.15);
    layout.bar = 0.01;
  } else {
    layout.low = Vec2(-1.65, top - 0.75);
    layout.high = Vec2(1.35, top + 1.65);
    layout.bar = 0.005;
  }
  layout.put_inset_above();
  return layout;
}

void draw(const Fall& fall, const Parameters& settings, Result& result) {
  const FilmLayout layout = layout_of(fall, settings);
  const HeldRun& shown = fall.runs.front();
  const HeldRun& exact = fall.runs.back();
  const Vec2 pivot = column_pivot().head<2>();
  Table times{"frames", {{"time_s", "s", "of the frame"}}};
  for (int k = 1; k <= kFilmFrames; ++k) {
    const HeldFrame& frame = shown.at(film_time(settings, k));
    const Joint& joint = shown.joints.back();
    // The inset shows the end of the joint on the pivot's side, or the pivot.
    Vec3 middle_w = held_point(joint, frame.states).first_w;
    if (joint.hold == JointHold::area) {
      const double inside = 0.3 * layout.seen();  // [m] from that end
      middle_w += frame.states[static_cast<std::size_t>(joint.first)].orientation_wb *
                  Vec3(0.5 - inside, 0.0, 0.0);
    }
    SideViewFrame film{
        frame.states, exact.at(film_time(settings, k)).states, {pivot}, middle_w.head<2>()};
    for (int n = 0; n < fall.boxes; ++n) {
      const bool highest = n + 1 == fall.boxes;
      film.circles.push_back(
          {pivot, std::hypot(0.5, n + 0.5), {film_colour::pivot, highest ? 1.8 : 0.8, false}});
    }
    add_film_frame(shown.start, layout, film, k, result);
    times.add(frame.time);
  }
  result.drawings.push_back(layout.drawing());
  result.tables.push_back(times);
}

// A run's gap by the angle through which its centre has turned.
double gap_after_turn(const Fall& fall, double turn) {
  const HeldRun& run = fall.runs.front();
  double before = 0.0;
  double gap_before = 0.0;
  for (const HeldFrame& frame : run.frames) {
    const double turned = centre_angle(run.world(frame)) - fall.angle;
    const double apart = farthest_apart(frame);
    if (turned >= turn)
      return gap_before + (apart - gap_before) * (turn - before) / (turned - before);
    before = turned;
    gap_before = apart;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

Result measure_fall(const Parameters& settings) {
  const Fall fall = fall_of(settings);
  Result result{.tables = {gaps_over_time(fall), gaps_of_steps(fall)}};
  draw(fall, settings, result);

  const bool column = fall.boxes > 1;
  const HeldFrame& end = fall.runs[5].frames.back();  // of the reference
  for (std::size_t s = 0; s < (column ? kSeenSchemes : 2); ++s)
    result.add("gap at the end, " + film_schemes()[s].words, "mm",
               1e3 * gap(fall, fall.runs[s], fall.runs[s].frames.back()));
  result.add(
      "angle at the end less that of the closed form, reference", "rad",
      centre_angle(fall.runs[5].world(end)) - column_angle(end.time, fall.angle, fall.boxes));
  if (!column) {
    Fall four = fall;
    four.boxes = 4;
    four.runs = {run_held(column_world(fall.angle), options_of(film_schemes()[0]), fall.dt,
                          static_cast<int>(std::lround(1.0 / fall.dt)))};
    constexpr double kTurn = 0.3;  // [rad] that both have turned
    result.add(
        "farthest apart after turning by 0.3 rad, forward Euler, over that of the column of four",
        "-", gap_after_turn(fall, kTurn) / gap_after_turn(four, kTurn));
    return result;
  }
  result.add("largest distance of a corner from itself at the end, rk4", "m",
             farthest_apart(fall.runs[4].frames.back()));
  result.add(
      "largest relative acceleration in a joint at the start of a step, over g, forward Euler", "-",
      fall.runs[0].acceleration / fall.runs[0].start.gravity_w.norm());
  const std::vector<double>& last = result.tables[1].rows.back();
  for (std::size_t s = 0; s < 2; ++s)
    result.add("gap that the last step makes over half the square of the turn times the spacing, " +
                   film_schemes()[s].words,
               "-", last[2 + s] / last[1]);
  return result;
}

std::string fall_film(const Parameters& settings, const CoarseSteps& coarse) {
  return coarse_film(world_at(settings.count("boxes"), settings.number("angle"), 0.0), coarse);
}

const Registered fig6_1_column_figure{
    {.name = "fig6_1_column",
     .parameters = film_parameters(
         Parameters{whole("boxes", 4, 2, 8, "cubes in the column"),
                    number("angle", 0.3, 0.05, 0.9, "rad", "of the column's centre at the start")},
         1.0, {0.0, 1.0}),
     .quick = {"rate=30"},
     .experiment = [](const Parameters& settings) {
       Result result = measure_fall(settings);
       result.film = [settings] { return fall_film(settings, {}); };
       return result;
     }}};

const Registered fig6_2_one_box_figure{
    {.name = "fig6_2_one_box",
     .parameters = film_parameters(
         Parameters{whole("boxes", 1, 1, 1, "one"),
                    number("angle", 0.3, 0.05, 0.9, "rad", "of the box's centre at the start")},
         0.45, {0.0, 0.45}),
     .quick = {"rate=30"},
     .experiment = [](const Parameters& settings) {
       Result result = measure_fall(settings);
       result.film = [settings] {
         return fall_film(settings, {.step = 0.075, .steps = 6, .enlarged = 10.0});
       };
       return result;
     }}};

}  // namespace
}  // namespace tumble::chapters
