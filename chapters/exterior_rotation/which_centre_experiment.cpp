/// \file
/// \brief The point about which a body that sticks, slides or flies has to be turned (thesis 6.2).
#include "driver/experiment.hpp"
#include "exterior_rotation/glued_runs.hpp"
#include "exterior_rotation/group_moves.hpp"

namespace tumble::chapters {
namespace {

enum Situation { sticks, slides, flies };
// put_back: about its own centre, and then put onto the floor.
enum Turning { own_centre, touching_point, resting, put_back };

// A cube of 1 m above the floor y = 0, turned by a tilt; the middle of its lowest edge is what touches.
struct Cube {
  Situation situation = sticks;
  Vec3 x_w = Vec3::Zero();      // [m] centre
  Vec3 v_w = Vec3::Zero();      // [m/s]
  Vec3 omega_w = Vec3::Zero();  // [rad/s]
  Vec3 touch_w = Vec3::Zero();  // [m] the middle of its lowest edge, at the origin

  [[nodiscard]] Vec3 touch_velocity() const { return v_w + omega_w.cross(touch_w - x_w); }
};

Cube cube_that(Situation situation, double spin, double speed, double tilt) {
  Cube cube;
  cube.situation = situation;
  cube.x_w = rotation_from_vector(Vec3(0.0, 0.0, -tilt)) * Vec3(-0.5, 0.5, 0.0);
  cube.omega_w = Vec3(0.0, 0.0, -spin);
  const Vec3 about_touch_w = cube.omega_w.cross(cube.x_w);
  cube.v_w = situation == sticks   ? about_touch_w
             : situation == slides ? Vec3(speed * Vec3::UnitX() + about_touch_w)
                                   : Vec3(speed, speed, 0.0);
  return cube;
}

// Errors after a step.
struct Wrong {
  double gap = 0.0;   // [m] the touching point off what it touches
  double bend = 0.0;  // [m] the centre off a straight way, as far as no force can bend it

  [[nodiscard]] double most() const { return std::max(gap, bend); }
};

Vec3 centre_of(const Cube& cube, Turning way) {
  if (way == touching_point) return cube.touch_w;
  if (way == resting) return resting_point(cube.x_w, cube.v_w, cube.omega_w);
  return cube.x_w;
}

Wrong after_step(const Cube& cube, Turning way, double dt) {
  Vec3 x_w = moved_about(cube.x_w, cube.v_w, cube.omega_w, centre_of(cube, way), dt);
  const Vec3 lever_w = rotation_from_vector(dt * cube.omega_w) * (cube.touch_w - cube.x_w);
  if (way == put_back) x_w.y() -= (x_w + lever_w).y();
  const Vec3 off_w = x_w + lever_w - cube.touch_w;
  const Vec3 bent_w = x_w - (cube.x_w + dt * cube.v_w);
  if (cube.situation == sticks) return {off_w.norm(), 0.0};
  if (cube.situation == slides) return {std::abs(off_w.y()), std::abs(bent_w.x())};
  return {0.0, bent_w.norm()};
}

// The same to second order: the way of a point r from the centre c bends by h² ω × (ω × r) / 2.
Wrong predicted(const Cube& cube, Turning way, double dt) {
  const Vec3 c_w = centre_of(cube, way);
  const auto bend = [&](const Vec3& point_w) -> Vec3 {
    return 0.5 * dt * dt * cube.omega_w.cross(cube.omega_w.cross(point_w - c_w));
  };
  const Vec3 touch_w = bend(cube.touch_w);
  const Vec3 centre_w = bend(cube.x_w);
  if (cube.situation == sticks) return {touch_w.norm(), 0.0};
  if (cube.situation == flies) return {0.0, centre_w.norm()};
  if (way == put_back) return {};
  return {std::abs(touch_w.y()), std::abs(centre_w.x())};
}

struct Case {
  Situation situation;
  Turning way;
};
constexpr std::array kCases = {Case{sticks, own_centre}, Case{sticks, touching_point},
                               Case{slides, own_centre}, Case{slides, touching_point},
                               Case{slides, resting},    Case{slides, put_back},
                               Case{flies, own_centre},  Case{flies, resting}};

Result measure_which_centre(const Parameters& settings) {
  const std::vector<double> dts = log_spaced(1.0 / 1000.0, 1.0 / 5.0, settings.count("steps"));
  Table table{
      "",
      {{"situation", "-", "1 sticks, 2 slides, 3 flies"},
       {"centre", "-",
        "1 its own, 2 the touching point, 3 what is at rest, 4 its own, put back on the floor"},
       {"step_s", "s", "length of the step"},
       {"gap_m", "m", "the touching point off what it touches, after the step"},
       {"bend_m", "m", "the centre off the way that no force bends, after the step"},
       {"error_m", "m", "the larger of both; 0 is drawn as 1e-17"},
       {"predicted_m", "m", "the larger of both to second order; empty if 0"}}};
  double worst_at_finest = 0.0;
  std::vector<Wrong> base;
  for (const Case& c : kCases) {
    const Cube cube = cube_that(c.situation, settings.number("spin"), settings.number("speed"),
                                settings.number("tilt"));
    base.push_back(after_step(cube, c.way, kStep));
    for (const double dt : dts) {
      const Wrong wrong = after_step(cube, c.way, dt);
      const double expected = predicted(cube, c.way, dt).most();
      const bool right = expected < kNearNothing;
      table.add(c.situation + 1, c.way + 1, dt, wrong.gap, wrong.bend,
                std::max(wrong.most(), kNearNothing),
                right ? std::numeric_limits<double>::quiet_NaN() : expected);
      if (dt == dts.front() && !right)
        worst_at_finest = std::max(worst_at_finest, std::abs(wrong.most() / expected - 1.0));
    }
  }
  return {
      {table},
      {{"sticks, turned about its own centre: gap", "m", base[0].gap},
       {"sticks, turned about the touching point: gap", "m", base[1].gap},
       {"slides, turned about its own centre: gap", "m", base[2].gap},
       {"slides, turned about its own centre: bend", "m", base[2].bend},
       {"slides, turned about the touching point: gap", "m", base[3].gap},
       {"slides, turned about the touching point: bend", "m", base[3].bend},
       {"slides, turned about what is at rest: gap", "m", base[4].gap},
       {"slides, turned about its own centre and put back: gap or bend", "m", base[5].most()},
       {"flies, turned about its own centre: bend", "m", base[6].bend},
       {"flies, turned about what is at rest: bend", "m", base[7].bend},
       {"largest error of the prediction in the shortest step, over it", "-", worst_at_finest}}};
}

const Registered which_centre_figure{
    {.name = "which_centre",
     .parameters = Parameters{}
                       .add_number("spin", 2.0, 0.1, 20.0, "rad/s", "of the cube")
                       .add_number("speed", 1.0, 0.1, 10.0, "m/s",
                                   "of sliding, and of flight along each axis")
                       .add_number("tilt", 0.3, 0.01, 0.7, "rad", "of the cube that touches")
                       .add_whole("steps", 12, 2, 100, "lengths of a step"),
     .experiment = measure_which_centre}};

}  // namespace
}  // namespace tumble::chapters
