/// \file
/// \brief Experiments on one body that hits the ground (thesis 2.1, 4.3).
#include "tumble/contact/collision_law.hpp"
#include "tumble/dynamics/event_search.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

struct Rebound {
  double time;     // [s] since the start
  double rebound;  // [m/s] upwards, right after it
};

// Drops a cube flat onto the ground until it rebounds slowly. Each flight is searched for its
// impact, the cube is put there, and it bounces.
std::vector<Rebound> bounces(double height, double restitution, double threshold, double resolution,
                             Table& path) {
  constexpr double half = 0.5;            // [m] half the edge of the cube
  constexpr int samples_per_flight = 40;  // of the curve
  World world;
  world.add_ground();
  const BodyProperties cube = box_properties(Vec3::Constant(2.0 * half), 1.0);
  world.add(cube, Vec3(0.0, height + half, 0.0));
  const IndexPair ground_and_cube{0, 1};

  // Any flight is shorter than twice the first fall, so that the cube is below the ground at the
  // end of the interval: what the discrete search looks for.
  const double fall = std::sqrt(2.0 * height / kGravity);
  SearchOptions options{.resolution = resolution};
  EventSearch search;
  std::vector<MovingBody> moving;
  std::vector<Rebound> impacts;
  double now = 0.0;
  do {
    // All times of a flight count from its start.
    const Flight flight{world.bodies(), world.states()};
    const FirstEvent& event = search.find(flight, {&ground_and_cube, 1}, 0.0, 3.0 * fall, options);
    if (event.status != CollisionStatus::found) throw std::runtime_error("an impact was missed");
    for (int k = 0; k <= samples_per_flight; ++k) {
      const double later = event.time * k / samples_per_flight;
      path.add(now + later, state_at(flight, 1, later).position_w.y() - half);
    }
    const BodyState landed = state_at(flight, 1, event.time);
    world.states()[1] = landed;
    now += event.time;

    // The impulses of the four corners have their resultant below the centre.
    load_moving_bodies(world, moving);
    collide_at_point(moving[0], moving[1], Vec3::Zero(), Vec3::UnitY(), 0.0, restitution);
    store_moving_bodies(moving, world);
    impacts.push_back({now, moving[1].velocity_w.y()});
  } while (impacts.back().rebound > threshold);
  return impacts;
}

Result measure_zeno(const Parameters& settings) {
  const double height = settings.number("height");
  const double restitution = settings.number("restitution");
  const double threshold = settings.number("threshold");
  const double resolution = settings.number("resolution");

  Table path{"", {{"time_s", "s", "time"}, {"height_m", "m", "height of the lower face"}}};
  const std::vector<Rebound> impacts = bounces(height, restitution, threshold, resolution, path);

  // Closed form: impact k comes at t1 (1 + 2 (e + ... + e^(k-1))) and leaves e^k of the speed.
  const double first = std::sqrt(2.0 * height / kGravity);
  const double rest = first * (1.0 + restitution) / (1.0 - restitution);
  Table table{"impacts",
              {{"impact", "-", "its number"},
               {"time_s", "s", "time found by the event search"},
               {"exact_s", "s", "time in closed form"},
               {"rebound_m_s", "m/s", "speed after it"},
               {"exact_m_s", "m/s", "the same in closed form"},
               {"rest_s", "s", "limit of the times"},
               {"threshold_m_s", "m/s", "speed at which bodies stick"},
               {"accepted_s", "s", "error of the time accepted: impact · 3 resolution / e"}}};
  double exact_time = first;
  double exact_rebound = kGravity * first;
  for (const Rebound& impact : impacts) {
    exact_rebound *= restitution;
    // An impact found early by less than a resolution shifts all later ones by up to 3/e of that.
    const auto number = static_cast<double>(table.rows.size() + 1);
    table.add(number, impact.time, exact_time, impact.rebound, exact_rebound, rest, threshold,
              number * 3.0 * resolution / restitution);
    exact_time += 2.0 * exact_rebound / kGravity;
  }
  return {{path, table}, {{"impacts until the threshold", "-", impacts.size()}}};
}

const Registered zeno_figure{
    {.name = "zeno",
     .parameters = {number("height", 1.0, 0.01, 100.0, "m", "free height at the start"),
                    number("restitution", 0.5, 0.05, 0.95, "-", "rebound speed over impact speed"),
                    number("threshold", 0.01, 1e-4, 1.0, "m/s",
                           "rebound speed at which bodies stick"),
                    number("resolution", 1e-9, 1e-12, 1e-3, "s",
                           "how closely impact times are found")},
     .quick = {"threshold=0.1"},
     .experiment = measure_zeno}};

}  // namespace
}  // namespace tumble::chapters
