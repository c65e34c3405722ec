/// \file
/// \brief The basic technique on a cube that bounces, and on one that comes to rest (thesis 2.1).
#include "tumble/basic_colliding/basic.hpp"
#include "tumble/contact/tolerances.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

constexpr int kCube = 1;       // its index: the ground comes first
constexpr double kHalf = 0.5;  // [m] half its edge

// The library's scene of a cube that is dropped flat.
World bouncing_cube(double height, double restitution) {
  Scene scene = make_scene("bouncing_box");
  scene.ground->restitution = scene.boxes[0].restitution = restitution;
  scene.boxes[0].position_w.y() = height + kHalf;
  return build_world(scene);
}

double height_of(const World& world) { return world.states()[kCube].position_w.y() - kHalf; }
double speed_of(const World& world) {
  return velocity(world.bodies()[kCube], world.states()[kCube]).y();
}

struct Impact {
  double time;    // [s] as the technique reports it
  double energy;  // [J] right after it, over that of the cube at rest on the ground
};

// Watches the cube: its impacts, and its way as a curve.
class Watcher : public Observer {
 public:
  explicit Watcher(const World& world) : world_(world) { land(0.0); }

  void on_event(const Event& event) override {
    const double at_rest = kGravity * world_.bodies()[kCube].mass * kHalf;
    impacts.push_back({event.time, energy_of(world_).total() - at_rest});
    fly_to(event.time);
    land(event.time);
  }

  // To be called after each step, for what came after its last impact, and for the repair.
  void end_step() {
    fly_to(world_.time());
    land(world_.time());
  }

  std::vector<Impact> impacts;
  Table path{"path", {{"time_s", "s", "time"}, {"height_m", "m", "height of the lower face"}}};

 private:
  // The parabola since the last impact or step.
  void fly_to(double time) {
    constexpr int pieces = 10;
    const double all = time - since_;
    for (int k = 1; k <= pieces && all > 0.0; ++k) {
      const double t = all * k / pieces;
      path.add(since_ + t, height_ + t * (speed_ - 0.5 * kGravity * t));
    }
  }
  // Where the technique has put it now.
  void land(double time) {
    const bool moved = path.rows.empty() || path.rows.back()[1] != height_of(world_);
    if (moved) path.add(time, height_of(world_));
    since_ = time;
    height_ = height_of(world_);
    speed_ = speed_of(world_);
  }

  const World& world_;
  double since_ = 0.0;   // [s] when it was here:
  double height_ = 0.0;  // [m]
  double speed_ = 0.0;   // [m/s] upwards
};

Result measure_impact_times(const Parameters& settings) {
  const double height = settings.number("height");
  const double restitution = settings.number("restitution");
  const int wanted = settings.count("impacts");
  BasicOptions options{.resolution = settings.number("resolution")};
  constexpr double accepted = 5.0;  // resolutions for each impact: the claim's rule
  constexpr int most_steps = 100000;

  World world = bouncing_cube(height, restitution);
  Watcher watcher(world);
  Basic basic(options);
  basic.observe(&watcher);
  std::int64_t rewinds = 0;
  std::int64_t searches = 0;
  while (static_cast<int>(watcher.impacts.size()) < wanted) {
    if (world.steps() == most_steps) throw std::runtime_error("too few impacts in 100000 steps");
    const StepReport step = finished(basic.step(world, settings.number("step")));
    watcher.end_step();
    rewinds += step.rewinds;
    searches += step.searches;
  }

  // Closed form: impact k comes at t1 (1 + 2 (e + ... + e^(k-1))) and leaves e^(2k) of the energy.
  Table table{"",
              {{"impact", "-", "its number"},
               {"time_s", "s", "time of the technique's event"},
               {"exact_s", "s", "time in closed form"},
               {"error_s", "s", "how far they are apart"},
               {"accepted_s", "s", "error accepted: five resolutions for each impact"},
               {"energy", "-", "energy after it, over that at first"},
               {"exact_energy", "-", "the same in closed form"}}};
  double flight = std::sqrt(2.0 * height / kGravity);
  double exact_time = 0.0;
  double exact_energy = 1.0;
  double worst_time = 0.0;
  double worst_energy = 0.0;
  for (int k = 1; k <= wanted; ++k) {
    const Impact& found = watcher.impacts[static_cast<std::size_t>(k - 1)];
    exact_time += flight;
    flight *= k == 1 ? 2.0 * restitution : restitution;
    exact_energy *= restitution * restitution;
    const double error = std::abs(found.time - exact_time);
    const double energy = found.energy / (kGravity * world.bodies()[kCube].mass * height);
    table.add(k, found.time, exact_time, error, accepted * k * options.resolution, energy,
              exact_energy);
    worst_time = std::max(worst_time, error / (k * options.resolution));
    worst_energy = std::max(worst_energy, std::abs(energy / exact_energy - 1.0));
  }
  return {
      {table, watcher.path},
      {{"largest error of an impact time, over the search's resolution times the impact's number",
        "-", worst_time},
       {"time of the last impact", "s", table.rows.back()[1]},
       {"largest relative error of the energy after an impact", "-", worst_energy},
       {"bodies put back in time, for each impact", "-",
        static_cast<double>(rewinds) / static_cast<double>(watcher.impacts.size())},
       {"separations computed to find an impact, on average", "-",
        static_cast<double>(searches) / static_cast<double>(watcher.impacts.size())}}};
}

const Registered claim_2_1a_impacts_figure{
    {.name = "claim_2_1a_impacts",
     .parameters = {number("height", 1.0, 0.01, 100.0, "m", "free height at the start"),
                    number("restitution", 0.9, 0.5, 1.0, "-", "rebound speed over impact speed"),
                    whole("impacts", 20, 1, 100, "how many are compared"),
                    number("step", 1.0 / 60.0, 1e-4, 0.1, "s", "time step"),
                    number("resolution", 1e-9, 1e-12, 1e-4, "s",
                           "how closely impact times are found")},
     .quick = {"impacts=8"},
     .experiment = measure_impact_times}};

struct Settling {
  Table steps;        // what each step did
  Table path;         // the way of the cube
  int at_rest = 0;    // steps that end after the moment of rest
  int capped = 0;     // those of them that end at the cap
  double sunk = 0.0;  // [m] in the last step, before the repair
};

// Runs the cube. With `clear` above 0, a cube that is in the ground after a step is put that high
// above it, instead of where the technique's repair has left it.
Settling settle(const Parameters& settings, double rest, double clear) {
  const double dt = settings.number("step");
  BasicOptions options{.resolution = settings.number("resolution"),
                       .event_cap = settings.count("cap")};
  World world = bouncing_cube(settings.number("height"), settings.number("restitution"));
  Watcher watcher(world);
  Basic basic(options);
  basic.observe(&watcher);

  Settling result;
  result.steps = {"",
                  {{"time_s", "s", "end of the step"},
                   {"impacts", "-", "collisions resolved in it; empty if there were none"},
                   {"separations", "-", "computed to find them"},
                   {"capped", "-", "the impacts again, if it ended at the cap; else empty"},
                   {"before_mm", "mm", "height of the lower face before the repair of overlap"},
                   {"after_mm", "mm", "the same after it"}}};
  const auto none = std::numeric_limits<double>::quiet_NaN();
  const auto steps = static_cast<int>(std::lround(settings.number("duration") / dt));
  for (int k = 0; k < steps; ++k) {
    const double from = height_of(world);
    const StepReport step = basic.step(world, dt);
    const double before = step.deepest_overlap > 0.0 ? -step.deepest_overlap : height_of(world);
    if (clear > 0.0 && height_of(world) < 0.0) world.states()[kCube].position_w.y() = kHalf + clear;
    watcher.end_step();

    const bool capped = step.status == StepStatus::event_cap;
    const auto impacts = static_cast<double>(step.events);
    result.steps.add(world.time(), step.events > 0 ? impacts : none, step.searches,
                     capped ? impacts : none, 1e3 * before, 1e3 * height_of(world));
    if (world.time() > rest) {
      ++result.at_rest;
      result.capped += capped ? 1 : 0;
    }
    result.sunk = from - before;
  }
  result.path = watcher.path;
  return result;
}

Result measure_rest(const Parameters& settings) {
  const double restitution = settings.number("restitution");
  const double rest = std::sqrt(2.0 * settings.number("height") / kGravity) * (1.0 + restitution) /
                      (1.0 - restitution);
  Settling found = settle(settings, rest, 0.0);
  if (found.at_rest == 0)
    throw std::runtime_error("the run ends before the cube rests; take a longer duration");
  Settling cleared = settle(settings, rest, settings.number("clear"));
  cleared.steps.suffix = "cleared";
  const auto share = [](int some, const Settling& all) {
    return static_cast<double>(some) / static_cast<double>(all.at_rest);
  };
  const Table exact{"rest",
                    {{"rest_s", "s", "moment of rest, closed form"},
                     {"cap", "-", "impacts allowed in a step"},
                     {"left_mm", "mm", "height at which the repair of overlap leaves the cube"}},
                    {{rest, settings.number("cap"), -1e3 * tolerance::repair_slop}}};
  return {{found.steps, found.path, cleared.steps, exact},
          {{"share of the steps after that moment that end at the cap", "-",
            share(found.capped, found)},
           {"the same share, with overlap lifted clear of the ground", "-",
            share(cleared.capped, cleared)},
           {"sinking in a step at the end", "m", found.sunk}}};
}

const Registered claim_2_1b_rest_figure{
    {.name = "claim_2_1b_rest",
     .parameters = {number("height", 1.0, 0.01, 100.0, "m", "free height at the start"),
                    number("restitution", 0.5, 0.0, 0.9, "-", "rebound speed over impact speed"),
                    number("duration", 2.0, 0.1, 60.0, "s", "length of the run"),
                    number("step", 1.0 / 60.0, 1e-4, 0.1, "s", "time step"),
                    number("resolution", 1e-9, 1e-12, 1e-4, "s",
                           "how closely impact times are found"),
                    whole("cap", 1000, 1, 100000, "impacts allowed in a step"),
                    number("clear", 1e-9, 1e-12, 1e-3, "m",
                           "how high overlap is lifted in the second run")},
     .quick = {"duration=1.6"},
     .experiment = measure_rest}};

}  // namespace
}  // namespace tumble::chapters
