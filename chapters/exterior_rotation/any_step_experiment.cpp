/// \file
/// \brief Groups moved by one twist for each body, at any step: gaps and orders (thesis 6.2).
#include "driver/experiment.hpp"
#include "exterior_rotation/falling_column.hpp"
#include "exterior_rotation/glued_runs.hpp"

namespace tumble::chapters {
namespace {

constexpr double kJudge = 1e-13;           // [-] accuracy of the solution in three dimensions
constexpr double kJudgeStep = 1.0 / 60.0;  // [s] at most
constexpr double kLongestFitted = 0.021;   // [s] steps up to this long show the order
constexpr int kBase = 60;                  // steps a second of the numbers

GluedOptions twist(GluedScheme scheme) { return glued_options(scheme, PoseUpdate::exponential); }

// One step length, all runs.
struct Row {
  double dt = 0.0;
  double separate = 0.0;          // [m] gap, semi-implicit, centre and orientation apart
  std::array<double, 3> gap{};    // [m] semi-implicit, impulses, leapfrog, in the plane
  std::array<double, 3> error{};  // [rad]
  double ball_gap = 0.0;          // [m] leapfrog on a ball joint
  double ball_apart = 0.0;        // [m] in any direction
  double ball_error = 0.0;        // [rad]
  double flight_gap = 0.0;        // [m]
  double flight_path = 0.0;       // [m] of the centre
  double flight_momentum = 0.0;   // [m/s] over the mass
  double flight_angular = 0.0;    // [-]
};

constexpr std::array kPlanar = {GluedScheme::semi_implicit, GluedScheme::impulse,
                                GluedScheme::leapfrog};

// The group in flight against free fall. Leapfrog is exact there.
void fly(int steps, double dt, Row& row) {
  const World start = column_in_flight(Vec3(2.0, 3.0, 0.5), Vec3(3.0, 1.0, 2.0));
  const GroupMotion before = motion_of(start);
  const GluedRun run = run_glued(
      start, twist(GluedScheme::leapfrog), dt, steps, [&](const World& world, const JointGap&) {
        const double t = world.time();
        const GroupMotion now = motion_of(world);
        const Vec3 centre_w =
            before.centre_w + t * before.momentum_w / before.mass + 0.5 * t * t * world.gravity_w;
        const Vec3 momentum_w = before.momentum_w + t * before.mass * world.gravity_w;
        row.flight_path = std::max(row.flight_path, (now.centre_w - centre_w).norm());
        row.flight_momentum =
            std::max(row.flight_momentum, (now.momentum_w - momentum_w).norm() / before.mass);
        row.flight_angular =
            std::max(row.flight_angular, (now.angular_about_w - before.angular_about_w).norm() /
                                             before.angular_about_w.norm());
      });
  row.flight_gap = run.gap;
}

Result measure_any_step(const Parameters& settings) {
  const double angle = settings.number("angle");
  const double duration = settings.number("duration");
  const World ball = column_on_corner(angle, settings.number("spin"));
  const auto lowest = [](const World& world) { return world.states()[1].orientation_wb; };
  const GluedOptions judge =
      glued_options(GluedScheme::dormand_prince, PoseUpdate::separate, kJudge);
  const int judge_steps = static_cast<int>(std::ceil(duration / kJudgeStep));
  const Quat truth_wb = lowest(run_glued(ball, judge, duration / judge_steps, judge_steps).world);

  const auto measured = [&](int rate) {
    Row row;
    const int steps = std::max(1, static_cast<int>(std::lround(duration * rate)));
    row.dt = duration / steps;  // all runs end at the same time
    row.separate =
        run_glued(column_world(angle), glued_options(GluedScheme::semi_implicit), row.dt, steps)
            .gap;
    for (std::size_t k = 0; k < kPlanar.size(); ++k) {
      const GluedRun run = run_glued(column_world(angle), twist(kPlanar[k]), row.dt, steps);
      row.gap[k] = run.gap;
      row.error[k] = std::abs(centre_angle(run.world) - column_angle(duration, angle));
    }
    const GluedRun run = run_glued(ball, twist(GluedScheme::leapfrog), row.dt, steps);
    row.ball_gap = run.gap;
    row.ball_apart = run.apart;
    row.ball_error = angle_between(lowest(run.world), truth_wb);
    fly(steps, row.dt, row);
    return row;
  };

  std::vector<Row> rows;
  for (const double rate :
       log_spaced(settings.count("coarsest"), settings.count("finest"), settings.count("steps")))
    rows.push_back(measured(static_cast<int>(std::lround(rate))));
  const Row base = measured(kBase);

  Table table{"",
              {{"step_s", "s", "length of a step"},
               {"separate_m", "m", "largest gap, semi-implicit, centre and orientation apart"},
               {"semi_implicit_m", "m", "largest gap, semi-implicit, one twist for each body"},
               {"impulse_m", "m", "largest gap, impulses, one twist"},
               {"leapfrog_m", "m", "largest gap, leapfrog, one twist"},
               {"ball_m", "m", "largest gap, leapfrog, one twist, on a ball joint"},
               {"flight_m", "m", "largest gap, leapfrog, one twist, in flight"},
               {"semi_implicit_rad", "rad", "error of the angle, semi-implicit, one twist"},
               {"impulse_rad", "rad", "error of the angle, impulses, one twist"},
               {"leapfrog_rad", "rad", "error of the angle, leapfrog, one twist"},
               {"ball_rad", "rad", "error of the orientation, leapfrog, one twist, ball joint"}}};
  Row most;  // over all steps
  std::vector<double> fitted_dt;
  std::array<std::vector<double>, 4> fitted;
  for (const Row& row : rows) {
    table.add(row.dt, row.separate, row.gap, row.ball_gap, row.flight_gap, row.error,
              row.ball_error);
    for (std::size_t k = 0; k < kPlanar.size(); ++k)
      most.gap[k] = std::max(most.gap[k], row.gap[k]);
    most.ball_apart = std::max(most.ball_apart, row.ball_apart);
    most.flight_gap = std::max(most.flight_gap, row.flight_gap);
    most.flight_path = std::max(most.flight_path, row.flight_path);
    most.flight_momentum = std::max(most.flight_momentum, row.flight_momentum);
    if (row.dt > kLongestFitted) continue;
    fitted_dt.push_back(row.dt);
    for (std::size_t k = 0; k < kPlanar.size(); ++k) fitted[k].push_back(row.error[k]);
    fitted[3].push_back(row.ball_error);
  }
  return {{table},
          {{"largest gap at any step, in the plane", "m",
            std::max({most.gap[0], most.gap[1], most.gap[2]})},
           {"largest distance of a corner from itself at any step, on a ball joint", "m",
            most.ball_apart},
           {"the same at 60 steps a second", "m", base.ball_apart},
           {"largest gap at any step, in flight", "m", most.flight_gap},
           {"order of the angle's error, semi-implicit", "-", fitted_order(fitted_dt, fitted[0])},
           {"order of the angle's error, impulses", "-", fitted_order(fitted_dt, fitted[1])},
           {"order of the angle's error, leapfrog", "-", fitted_order(fitted_dt, fitted[2])},
           {"order of the orientation's error on a ball joint, leapfrog", "-",
            fitted_order(fitted_dt, fitted[3])},
           {"in flight, the centre's largest distance from free fall at any step", "m",
            most.flight_path},
           {"in flight, the largest error of the centre's velocity at any step", "m/s",
            most.flight_momentum},
           {"in flight, the largest change of angular momentum over all of it, 60 steps a second",
            "-", base.flight_angular}}};
}

const Registered twist_any_step_figure{
    {.name = "twist_any_step",
     .parameters =
         Parameters{}
             .add_number("angle", 0.3, 0.01, 1.0, "rad", "of the column's centre at the start")
             .add_number("spin", 2.0, -20.0, 20.0, "rad/s",
                         "about its long axis, on the ball joint")
             .add_number("duration", 1.0, 0.1, 1.5, "s", "of each run")
             .add_whole("coarsest", 5, 2, 50, "steps a second")
             .add_whole("finest", 1000, 60, 10000, "steps a second")
             .add_whole("steps", 16, 4, 100, "lengths of a step between them"),
     .quick = {"finest=240", "steps=8"},
     .experiment = measure_any_step}};

}  // namespace
}  // namespace tumble::chapters
