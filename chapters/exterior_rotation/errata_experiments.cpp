/// \file
/// \brief Errata P15 and P15b: one force and one torque, and boxes that stay together (thesis 6.2).
#include "exterior_rotation/errata_experiments.hpp"

#include "tumble/exterior_rotation/glued.hpp"
#include "tumble/math/rotation.hpp"

#include "driver/common_numbers.hpp"
#include "exterior_rotation/falling_column.hpp"

#include <algorithm>
#include <cmath>

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
  GluedOptions options;
  options.scheme = GluedScheme::forward_euler;
  options.pose = pose;
  Glued(options).step(world, dt);
  return world;
}

// The most that a force which is held can do for a centre that goes its own way: the parabola.
World on_parabola(double speed, double dt) {
  World world = turning_column(speed);
  Glued glue;
  glue.find(world);
  std::vector<MovingBody> moving;
  load_moving_bodies(world, moving);
  std::vector<Wrench> rates;
  JointForces().hold(world, moving, glue.joints(), rates);
  for (std::size_t k = 0; k < moving.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable()) continue;
    BodyState& state = world.states()[k];
    state.position_w +=
        dt * moving[k].velocity_w + 0.5 * dt * dt * body.inverse_mass * rates[k].force_w;
    state.orientation_wb = turned(state.orientation_wb, moving[k].angular_velocity_w, dt);
  }
  return world;
}

// What a joint has to pull with: at the far side of an area for one that holds an area, and along the
// normal for an edge.
class PullGauge {
 public:
  double pull(const World& world, std::span<const Joint> joints) {
    load_moving_bodies(world, moving_);
    forces_.hold(world, moving_, joints, rates_);
    JointChange change;
    const double margin = joint_margin(joints, world, moving_, forces_, change);
    return std::max(0.0, -margin) * world.gravity_w.norm();  // cubes of 1 kg with edges of 1 m
  }

 private:
  std::vector<MovingBody> moving_;
  std::vector<Wrench> rates_;
  JointForces forces_;
};

// A fall with joints of one kind, by time: the pull, and the joints that still hold an area.
struct Fall {
  std::vector<double> time;   // [s]
  std::vector<double> pull;   // [N]
  std::vector<double> areas;  // [-]
};

Fall fall(GluedJoints kind, double angle, double rate, double duration) {
  World world = column_world(angle);
  GluedOptions options;
  options.joints = kind;
  Glued glued(options);
  glued.find(world);
  PullGauge gauge;
  Fall told;
  const auto tell = [&] {
    told.time.push_back(world.time());
    told.pull.push_back(gauge.pull(world, glued.joints()));
    told.areas.push_back(static_cast<double>(
        std::count_if(glued.joints().begin(), glued.joints().end(),
                      [](const Joint& joint) { return joint.hold == JointHold::area; })));
  };
  tell();
  const int steps = static_cast<int>(std::lround(duration * rate));
  for (int n = 0; n < steps; ++n) {
    glued.step(world, 1.0 / rate);
    tell();
  }
  return told;
}

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

}  // namespace

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
    gaps.rows.push_back({turn, size(stepped(PoseUpdate::separate, speed, dt)),
                         size(on_parabola(speed, dt)),
                         size(stepped(PoseUpdate::exponential, speed, dt))});
  }
  result.tables.push_back(gaps);

  const double angle = settings.number("angle");
  const double duration = settings.number("duration");
  const Fall glue = fall(GluedJoints::bilateral, angle, rate, duration);
  const Fall dry = fall(GluedJoints::unilateral, angle, rate, duration);
  Table pulls{"pull",
              {{"time_s", "s", "since the column was released"},
               {"glue_N", "N", "pull of the joint that pulls most, glue"},
               {"dry_N", "N", "the same, friction without glue"},
               {"glue_areas", "-", "joints that hold an area, glue"},
               {"dry_areas", "-", "joints that hold an area, friction without glue"}}};
  for (std::size_t n = 0; n < glue.time.size(); ++n)
    pulls.rows.push_back({glue.time[n], glue.pull[n], dry.pull[n], glue.areas[n], dry.areas[n]});
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
      {"P15b: largest pull in a joint while the column falls, boxes that stay connected", "N",
       largest(glue.pull)},
      {"P15b: largest pull in a joint while the column falls, boxes that can come apart", "N",
       largest(dry.pull)},
      {"joints that hold an area at the end, boxes that can come apart", "-", dry.areas.back()}};
  return result;
}

std::vector<Figure> rotation_errata_figures() {
  Figure figure;
  figure.name = "errata_exterior_rotation";
  figure.section = "6.2";
  figure.title = "Can one force hold a body on a circle, and friction a column together?";
  figure.caption =
      "Above, the column turns steadily, and takes one step with the force and torque of its "
      "start. "
      "Centres that are moved along tangents open it; along parabolas, the most that a constant "
      "force can do by itself, still; moved by the twist, not at all, however long the step. "
      "Below, "
      "the column falls. If its boxes stay connected, a joint has to pull from 0.8 s on, which "
      "friction cannot do. Without glue joints open then and nothing pulls.";
  figure.parameters.add_number("speed", 2.0, 0.1, 20.0, "rad/s", "of the column that turns")
      .add_number("rate", 60.0, 10.0, 1e4, "1/s", "steps a second")
      .add_number("angle", 0.3, 0.05, 0.6, "rad", "at which the column that falls is released")
      .add_number("duration", 1.0, 0.1, 2.0, "s", "of its fall")
      .add_whole("turns", 40, 2, 1000, "steps in the sweep, less one");
  figure.quick = {"turns=4"};
  figure.experiment = measure_rotation_errata;
  return {figure};
}

}  // namespace tumble::chapters
