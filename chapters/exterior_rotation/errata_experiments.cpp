/// \file
/// \brief Errata P15 and P15b: one force and one torque, and boxes that stay together (thesis 6.2).
#include "tumble/exterior_rotation/glued.hpp"

#include "exterior_rotation/falling_column.hpp"
#include "exterior_rotation/glued_runs.hpp"
#include "exterior_rotation/held_run.hpp"
#include "exterior_rotation/unilateral_run.hpp"

namespace tumble::chapters {
namespace {

// The column, turning about the edge with nothing else acting on it: its circles are exact.
World turning_column(double speed) {
  World world = column_world(0.3, speed);
  world.gravity_w.setZero();
  return world;
}

// A step of the library, with the force and the torque of its start.
World stepped(PoseUpdate pose, double speed, double dt) {
  World world = turning_column(speed);
  finished(Glued(glued_options(GluedScheme::forward_euler, pose)).step(world, dt));
  return world;
}

// The most that a force which is held can do for a centre that goes its own way: the parabola.
World on_parabola(double speed, double dt) {
  World world = turning_column(speed);
  Glued glue;
  glue.find(world);
  const HeldInstant held(world, glue.joints());
  for (std::size_t k = 0; k < held.moving.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable()) continue;
    BodyState& state = world.states()[k];
    state.position_w +=
        dt * held.moving[k].velocity_w + 0.5 * dt * dt * body.inverse_mass * held.rates[k].force_w;
    state.orientation_wb = turned(state.orientation_wb, held.moving[k].angular_velocity_w, dt);
  }
  return world;
}

// How far the top cube's centre is from its place on the circle, after a step along the parabola: a second measurement
// of claim 6.2d. The circle is exact.
double top_off_circle(double speed, double dt) {
  const World start = turning_column(speed);
  const World end = on_parabola(speed, dt);
  const std::size_t top = start.states().size() - 1;
  const Vec3 arm_w = start.states()[top].position_w - column_pivot();
  const Vec3 spin_w = angular_velocity(start.bodies()[top], start.states()[top]);
  const Vec3 place_w = column_pivot() + rotation_from_vector(Vec3(dt * spin_w)) * arm_w;
  return (end.states()[top].position_w - place_w).norm();
}

// [N] That a joint has to pull with: at the far side of an area for one that holds an area, and along the
// normal for an edge.
double pull_in(const World& world, std::span<const Joint> joints) {
  const HeldInstant held(world, joints);
  JointChange change;
  const double margin = joint_margin(joints, world, held.moving, held.forces, change);
  return std::max(0.0, -margin) * world.gravity_w.norm();  // cubes of 1 kg with edges of 1 m
}

// A fall with joints of one kind, by time: the pull, and the joints that hold an area at the end.
struct PullRun {
  std::vector<double> time;  // [s]
  std::vector<double> pull;  // [N]
  std::int64_t areas = 0;
};

PullRun pull_run(GluedJoints kind, double angle, double rate, double duration) {
  GluedOptions options{.joints = kind};
  PullRun seen;
  run_unilateral(column_world(angle), options, duration,
                 static_cast<int>(std::lround(duration * rate)),
                 [&](const World& world, const Glued& glued) {
                   const std::span<const Joint> joints = glued.joints();
                   seen.time.push_back(world.time());
                   seen.pull.push_back(pull_in(world, joints));
                   seen.areas = std::ranges::count_if(
                       joints, [](const Joint& joint) { return joint.hold == JointHold::area; });
                 });
  return seen;
}

double largest(const std::vector<double>& values) { return *std::ranges::max_element(values); }

Result measure_rotation_errata(const Parameters& settings) {
  const double speed = settings.number("speed");
  const double rate = settings.number("rate");
  Result result;

  Table gaps{"",
             {{"turn_rad", "rad", "by which the column turns in the step"},
              {"euler_m", "m", "gap after it, centres moved along tangents"},
              {"parabola_m", "m", "centres moved along parabolas"},
              {"exponential_m", "m", "bodies moved by the exponential of their twist"}}};
  const int turns = settings.count("turns");
  const auto size = [](const World& world) {
    return std::max(kNearNothing, std::abs(column_gap(world)));
  };
  for (int k = 0; k <= turns; ++k) {
    const double turn = std::pow(10.0, -2.0 + 2.0 * k / turns);
    const double dt = turn / speed;
    gaps.add(turn, size(stepped(PoseUpdate::separate, speed, dt)), size(on_parabola(speed, dt)),
             size(stepped(PoseUpdate::exponential, speed, dt)));
  }
  result.tables.push_back(gaps);

  const double angle = settings.number("angle");
  const double duration = settings.number("duration");
  const PullRun glue = pull_run(GluedJoints::bilateral, angle, rate, duration);
  const PullRun dry = pull_run(GluedJoints::unilateral, angle, rate, duration);
  Table pulls{"pull",
              {{"time_s", "s", "since the column was released"},
               {"glue_N", "N", "pull of the joint that pulls most, glue"},
               {"dry_N", "N", "the same, friction without glue"}}};
  for (std::size_t n = 0; n < glue.time.size(); ++n)
    pulls.add(glue.time[n], glue.pull[n], dry.pull[n]);
  result.tables.push_back(pulls);

  const auto after = [&](PoseUpdate pose) {
    return std::abs(column_gap(stepped(pose, speed, 1.0 / rate)));
  };
  result.quantities = {
      {"P15: gap after a step with one force and torque, centres moved along tangents", "m",
       after(PoseUpdate::separate)},
      {"P15: gap after a step with one force and torque, bodies moved by their twist", "m",
       after(PoseUpdate::exponential)},
      {"the same, centres moved along parabolas", "m",
       std::abs(column_gap(on_parabola(speed, 1.0 / rate)))},
      {"distance of the top cube's centre from its place on the circle after a step under one held "
       "force, over an edge",
       "-", top_off_circle(speed, 1.0 / rate)},
      {"P15b: largest pull in a joint while the column falls, boxes that stay connected", "N",
       largest(glue.pull)},
      {"P15b: largest pull in a joint while the column falls, boxes that can come apart", "N",
       largest(dry.pull)},
      {"joints that hold an area at the end, boxes that can come apart", "-", dry.areas}};
  return result;
}

const Registered errata_exterior_rotation_figure{
    {.name = "errata_exterior_rotation",
     .parameters = {number("speed", 2.0, 0.1, 20.0, "rad/s", "of the column that turns"),
                    number("rate", 60.0, 10.0, 1e4, "1/s", "steps a second"),
                    number("angle", 0.3, 0.05, 0.6, "rad",
                           "at which the column that falls is released"),
                    number("duration", 1.0, 0.1, 2.0, "s", "of its fall"),
                    whole("turns", 40, 2, 1000, "steps in the sweep, less one")},
     .quick = {"turns=4"},
     .experiment = measure_rotation_errata}};

}  // namespace
}  // namespace tumble::chapters
