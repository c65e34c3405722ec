/// \file
/// \brief Scenes run for a while and drawn as boxes in three dimensions.
#include "tumble/basic_colliding/basic.hpp"
#include "tumble/math/bracket.hpp"
#include "tumble/pictures/world_picture.hpp"
#include "tumble/record/metrics.hpp"

#include "driver/experiment.hpp"
#include "driver/side_by_side.hpp"

namespace tumble::chapters {
namespace {

constexpr std::uint64_t kSeed = 1;  // the one of `tumble run`

Table pose_table(const std::string& suffix) {
  return {suffix,
          {{"time_s", "s", "time"},
           {"box", "-", "its number, from 1"},
           {"px_m", "m", "centre, x"},
           {"py_m", "m", "centre, y"},
           {"pz_m", "m", "centre, z"},
           {"qw", "-", "orientation, body to world, real part"},
           {"qx", "-", "its x"},
           {"qy", "-", "its y"},
           {"qz", "-", "its z"}}};
}

void add_poses(const World& world, Table& table) {
  double number = 0.0;
  for (int k = 0; k < world.count(); ++k) {
    if (world.bodies()[idx(k)].shape == Shape::ground) continue;
    const BodyState& state = world.states()[idx(k)];
    const Vec3& p = state.position_w;
    const Quat& q = state.orientation_wb;
    table.add(world.time(), ++number, p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z());
  }
}

// The technique steps until a time; boxes that appear later are added on the way.
void advance(const Scene& scene, Technique& technique, double step, double until, World& world,
             StepReport& totals) {
  while (world.time() < until - 0.5 * step) {
    const double before = due_until(world.time(), step);
    const StepReport report = technique.step(world, step);
    // At a cap a picture shows what there is; a strip, which measures, refuses it.
    if (ended_at_cap(report)) totals.status = StepStatus::event_cap;
    totals.energy.restitution += report.energy.restitution;
    totals.energy.friction += report.energy.friction;
    totals.energy.damping += report.energy.damping;
    totals.energy.repair += report.energy.repair;
    update_boxes(scene, before, due_until(world.time(), step), world);
  }
}

double lowest_point(const PictureBox& drawn) {
  return drawn.box.center_w.y() - reach(drawn.box, Vec3::UnitY());
}

// When a cube that flies and turns touches the ground. Its moments of inertia are equal, so that it
// turns about a fixed axis at a fixed rate, and its lowest corner is at a known height.
double first_touch(const World& world) {
  const BodyProperties& body = world.bodies().back();
  const BodyState& start = world.states().back();
  const Vec3 velocity_w = velocity(body, start);
  const Vec3 omega_w = angular_velocity(body, start);
  const auto height = [&](double time) {
    BodyState later = start;
    later.position_w += time * velocity_w + 0.5 * time * time * world.gravity_w;
    later.orientation_wb = turned(start.orientation_wb, omega_w, time);
    return lowest_point({box_of(body, later)});
  };
  // It may go up and down on the way, so the first millisecond that ends below the ground is taken.
  constexpr double sample = 1e-3;  // [s]
  for (int k = 0; k < 100000; ++k)
    if (height((k + 1) * sample) < 0.0)
      return bisect(height, Bracket{k * sample, (k + 1) * sample}, 0.0, 100).bracket.low;
  throw std::runtime_error("the die has not touched the ground after 100 s");
}

// Keeps the times of impacts.
struct ImpactTimes : Observer {
  std::vector<double> times;
  void on_event(const Event& event) override { times.push_back(event.time); }
};

// The walls of a cage that are between it and the viewer are left out.
void open_towards(const Vec3& direction_w, std::vector<PictureBox>& boxes, const World& world) {
  std::vector<PictureBox> kept;
  std::size_t body = 0;
  for (const PictureBox& drawn : boxes) {
    while (world.bodies()[body].shape == Shape::ground) ++body;
    const bool wall = !world.bodies()[body++].movable();
    if (!wall || drawn.box.center_w.dot(direction_w) < 0.0) kept.push_back(drawn);
  }
  boxes = std::move(kept);
}

const Vec3 kDiceView_w(0.35, 0.45, 1.0);  // from the die to the eye

// A thrown die under the basic technique, in six frames.
Result measure_dice_strip(const Parameters& settings) {
  constexpr int frames = 6;
  std::vector<std::string> changes = {"count=1"};
  for (const char* key : {"speed", "spin", "restitution"})
    changes.push_back(setting(key, settings.number(key)));
  const Scene scene =
      make_scene("dice", changes, static_cast<std::uint64_t>(settings.whole("seed")));
  World world = build_world(scene);
  const double exact_touch = first_touch(world);

  Basic technique;
  ImpactTimes impacts;
  technique.observe(&impacts);
  MetricsMeter meter;
  meter.begin(world);
  Table table = pose_table("");
  StepReport totals;
  std::vector<std::vector<PictureBox>> pictures;
  for (int k = 0; k < frames; ++k) {
    advance(scene, technique, settings.number("step"),
            settings.number("first") + k * settings.number("interval"), world, totals);
    add_poses(world, table);
    pictures.push_back(picture_boxes(world));
    for (PictureBox& drawn : pictures.back()) drawn.colour = 0xd55e00;
  }
  finished(totals);
  const double error = meter.measure(world, totals).energy_error;

  // One camera for all frames.
  std::vector<PictureBox> all;
  for (const auto& boxes : pictures) all.insert(all.end(), boxes.begin(), boxes.end());
  const Camera camera = camera_for(all, kDiceView_w, 300.0, 160.0, true);
  std::vector<Drawing> drawings;
  for (std::size_t k = 0; k < pictures.size(); ++k)
    drawings.push_back(
        {"frame" + std::to_string(k + 1), to_gnuplot(draw_boxes(pictures[k], camera, true, all))});

  const double size = scene.boxes.front().size.x();
  const double unit = scene.boxes.front().mass * world.gravity_w.norm() * size;
  if (impacts.times.empty()) throw std::runtime_error("the die has not met the ground yet");
  const auto film = [scene, last = world.time()] {
    const auto red = [](std::vector<PictureBox>& boxes) { boxes.back().colour = 0xd55e00; };
    return to_gif(film_of(frames_of_run(scene, {"basic"}, 0.0, last, 0.0, red, 1), kDiceView_w, 480,
                          320, true),
                  15.0);
  };
  return {{table},
          {{"time of the first impact", "s", impacts.times.front()},
           {"the same from the exact flight", "s", exact_touch},
           {"energy change not booked, over m g L", "-", std::abs(error) / unit}},
          drawings,
          film};
}

const Registered dice_strip_figure{
    {.name = "dice_strip",
     .parameters = {number("speed", 0.5, 0.0, 10.0, "m/s", "sideways, at the start"),
                    number("spin", 15.0, 0.0, 100.0, "rad/s", "at the start, about a random axis"),
                    number("restitution", 0.4, 0.0, 1.0, "-", "rebound speed over impact speed"),
                    whole("seed", 1, 0, 1000000, "of orientation and axis of spin"),
                    number("first", 0.22, 0.0, 10.0, "s", "time of the first frame"),
                    number("interval", 0.08, 0.001, 10.0, "s", "from frame to frame"),
                    number("step", 0.01, 1e-4, 0.1, "s", "time step")},
     .experiment = measure_dice_strip}};

// How a scene is shown in the gallery.
struct Shot {
  std::string_view scene;
  std::vector<std::string> change;  // settings that differ from the defaults of the scene
  double time;                      // [s] since the start
  std::array<double, 3> view;       // from the boxes to the eye
};

const std::array<Shot, 30> kShots = {{
    {"box_drop", {}, 0.4, {0.4, 0.4, 1.0}},
    {"bouncing_box", {}, 0.8, {0.6, 0.4, 1.0}},
    {"tumbling_box", {}, 2.8, {0.5, 0.6, 1.0}},
    {"two_boxes", {}, 1.2, {-0.4, 0.5, 1.0}},
    {"crate_off_table", {}, 0.9, {0.6, 0.45, 1.0}},
    {"cradle", {}, 0.0, {0.4, 0.5, 1.0}},
    {"stack", {}, 0.0, {0.6, 0.35, 1.0}},
    {"pyramid", {}, 0.0, {0.35, 0.3, 1.0}},
    {"pyramid3d", {"rows=6"}, 0.0, {0.5, 0.5, 1.0}},
    {"wall", {"courses=12", "bricks=9"}, 0.0, {0.5, 0.35, 1.0}},
    {"clump", {}, 0.6, {0.6, 0.5, 1.0}},
    {"projectile", {"rows=8", "appears=0"}, 0.7, {0.7, 0.4, -1.0}},
    {"dice", {}, 0.35, {0.3, 0.5, 1.0}},
    {"slide", {}, 0.0, {0.6, 0.5, 1.0}},
    {"slope", {}, 0.0, {0.3, 0.4, 1.0}},
    {"sled", {}, 0.0, {0.5, 0.5, 1.0}},
    {"rocking_block", {}, 0.0, {0.4, 0.3, 1.0}},
    {"seesaw", {}, 0.0, {0.4, 0.4, 1.0}},
    {"leaning", {}, 0.0, {0.8, 0.5, 1.0}},
    {"table", {}, 0.0, {0.5, 0.4, 1.0}},
    {"toss", {}, 0.0, {0.5, 0.5, 1.0}},
    {"line", {}, 0.3, {0.3, 0.4, 1.0}},
    {"cage", {}, 2.0, {0.6, 0.5, 1.0}},
    // The basic technique knows no joints: these are shown as they begin.
    {"chain", {}, 0.0, {0.3, 0.3, 1.0}},
    {"pendulum", {}, 0.0, {0.3, 0.3, 1.0}},
    {"crane", {}, 0.0, {1.0, 0.35, 0.45}},
    {"plank_bridge", {}, 0.0, {0.3, 0.45, 1.0}},
    // Figures of the thesis that run in the book: these are their still pictures.
    {"fig5_1", {}, 0.0, {0.3, 0.4, 1.0}},
    {"fig5_6", {"rows=9"}, 0.0, {0.35, 0.3, 1.0}},
    {"fig6_1", {}, 0.0, {0.35, 0.3, 1.0}},
}};

// A picture of a built-in scene after a run with the basic technique.
Result measure_gallery(std::string_view name, const Parameters& settings) {
  const Scene scene = scene_recipe(name).build(settings, Random(kSeed));
  World world = build_world(scene);
  Basic technique({.event_cap = settings.count("event_cap")});
  StepReport totals;
  advance(scene, technique, 1.0 / 60.0, settings.number("time"), world, totals);
  Table table = pose_table("");
  add_poses(world, table);

  std::vector<PictureBox> boxes = picture_boxes(world);
  const auto movable = std::ranges::count_if(
      world.bodies(), [](const BodyProperties& body) { return body.movable(); });

  const Vec3 direction_w(settings.number("view_x"), settings.number("view_y"),
                         settings.number("view_z"));
  if (name == "cage") open_towards(direction_w, boxes, world);
  const bool floor = has_ground(world);
  const Picture picture =
      draw_boxes(boxes, camera_for(boxes, direction_w, 600.0, 400.0, floor), floor);
  return {{table}, {{"movable boxes", "-", movable}}, {{"boxes", to_gnuplot(picture)}}};
}

Figure gallery_figure(const Shot& shot) {
  Figure figure{.name = "gallery_" + std::string(shot.scene),
                .parameters = scene_recipe(shot.scene).parameters(),
                .experiment = [name = shot.scene](const Parameters& settings) {
                  return measure_gallery(name, settings);
                }};
  set_all(figure.parameters, shot.change);
  figure.parameters.add(number("time", shot.time, 0.0, 60.0, "s", "when the picture is taken"))
      .add(whole("event_cap", 20, 1, 1000000, "moments of impact allowed in one step"))
      .add(number("view_x", shot.view[0], -1e3, 1e3, "-", "direction to the eye, x"))
      .add(number("view_y", shot.view[1], -1e3, 1e3, "-", "direction to the eye, y"))
      .add(number("view_z", shot.view[2], -1e3, 1e3, "-", "direction to the eye, z"));
  return figure;
}

std::vector<Figure> gallery_figures() {
  std::vector<Figure> figures;
  for (const Shot& shot : kShots) figures.push_back(gallery_figure(shot));
  return figures;
}

const Registered gallery_pictures(gallery_figures);

}  // namespace
}  // namespace tumble::chapters
