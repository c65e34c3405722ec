/// \file
/// \brief Runs of the upper box of figure 5.4.
#include "geometric_stability/sliding_run.hpp"

#include "tumble/analytic_lcp/analytic.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/geometric_stability/geometrically_stable.hpp"
#include "tumble/impulse_damped/damped.hpp"
#include "tumble/impulse_damped/tolerances.hpp"

#include "driver/csv.hpp"
#include "driver/played_scene.hpp"

namespace tumble::chapters {
namespace {

constexpr std::size_t kLower = 1;  // indices; the ground is 0
constexpr std::size_t kUpper = 2;

World start_of(const SlideSetup& setup) {
  Scene scene =
      make_scene("fig5_4", {setting("offset", setup.offset), setting("speed", setup.speed)});
  for (SceneBox& box : scene.boxes) {
    box.size *= setup.scale;
    box.position_w *= setup.scale;
    box.velocity_w *= setup.scale;
    box.mass *= setup.scale * setup.scale * setup.scale;
  }
  return build_world(scene);
}

std::unique_ptr<Technique> technique_of(const SlideSetup& setup) {
  if (setup.slider == Slider::damped || setup.slider == Slider::damped_unmarked) {
    DampedOptions options;
    options.stable_boxes = setup.slider == Slider::damped ? StableRule::corners : StableRule::off;
    options.numbers.k_scale = setup.k_scale;
    return std::make_unique<Damped>(options);
  }
  AnalyticOptions options;
  options.friction =
      setup.slider == Slider::analytic_damping ? AnalyticFriction::damping : AnalyticFriction::none;
  options.stable_boxes = StableRule::corners;
  return std::make_unique<Analytic>(options);
}

// Whether a technique has the upper box marked after its step.
bool marks(const Technique& technique, const World& world) {
  if (const auto* damped = dynamic_cast<const Damped*>(&technique)) {
    const std::span<const BodyId> ids = damped->stable_bodies();
    return std::ranges::find(ids, world.ids()[kUpper]) != ids.end();
  }
  const std::span<const char> held = dynamic_cast<const Analytic&>(technique).held();
  return !held.empty() && held[kUpper] != 0;
}

double overhang(const World& world) {
  const std::array<Vec2, 4> corners =
      lower_corners(box_of(world.bodies()[kUpper], world.states()[kUpper]));
  double foremost = corners[0].x();
  for (const Vec2& corner : corners) foremost = std::max(foremost, corner.x());
  return foremost - world.states()[kLower].position_w.x() - 0.5 * world.bodies()[kLower].size.x();
}

double level(const World& world) {
  return world.states()[kUpper].orientation_wb.toRotationMatrix()(1, 1);
}

}  // namespace

int SlideRun::counted() const {
  return static_cast<int>(
      std::count_if(steps.begin(), steps.begin() + until(),
                    [](const SlideStep& step) { return step.counted_stable && step.slowed; }));
}

std::vector<char> stable_by_corners(const World& world) {
  std::vector<MovingBody> moving;
  load_moving_bodies(world, moving);
  const std::vector<IndexPair> pairs{{0, 1}, {0, 2}, {1, 2}};
  const double size =
      std::max(world.bodies()[kLower].size.minCoeff(), world.bodies()[kUpper].size.minCoeff());
  ContactList contacts;
  gather_contacts(world, moving, pairs, tolerance::stability_margin * size, {}, contacts);
  std::vector<char> stable;
  GeometricStability().run(world, contacts, StableRule::corners, tolerance::damped_rising, stable);
  return stable;
}

double speed_of_upper(const World& world) {
  return velocity(world.bodies()[kUpper], world.states()[kUpper]).x();
}

SlideRun slide(const SlideSetup& setup) {
  World world = start_of(setup);
  const std::unique_ptr<Technique> technique = technique_of(setup);
  const bool damped = dynamic_cast<const Damped*>(technique.get()) != nullptr;
  SlideRun run;
  run.worlds.push_back(world);
  bool marked = false;
  for (int k = 0; k < setup.steps; ++k) {
    const double before = speed_of_upper(world);
    const StepReport report = finished(technique->step(world, kStep));
    SlideStep step{.speed = speed_of_upper(world), .overhang = overhang(world)};
    // Damped integration goes by the mark that the step before has left; the other one looks
    // before it finds its forces.
    step.counted_stable = damped ? marked : marks(*technique, world);
    marked = marks(*technique, world);
    step.slowed = before > 0.0 && step.speed < before && report.energy.damping < 0.0;
    if (run.leaves < 0 && step.overhang > 0.0) run.leaves = k;
    run.steps.push_back(step);
    run.worlds.push_back(world);
  }
  return run;
}

double held_overhang(double seconds) {
  const World start = start_of({});
  const double half = 0.5 * start.bodies()[kUpper].size.x();
  const double edge = 0.5 * start.bodies()[kLower].size.x();
  double held = 0.0;
  for (double falls = half; falls - held > 1e-3;) {
    const double trial = 0.5 * (held + falls);
    World world = start;
    BodyState state = world.states()[kUpper];
    state.position_w.x() = edge + trial;
    world.set_state(world.ids()[kUpper], state);
    Damped damped;
    while (world.time() < seconds - 0.5 * kStep) finished(damped.step(world, kStep));
    constexpr double kLevel = 0.999;  // [-] cosine of 2.6 degrees
    (level(world) > kLevel ? held : falls) = trial;
  }
  return held;
}

}  // namespace tumble::chapters
