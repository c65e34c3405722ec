/// \file
/// \brief Joints of scenes: a crane swings a box into a wall; periods and energies of pendulums (thesis 2.6.5).
#include "tumble/exterior_rotation/joint.hpp"
#include "tumble/pictures/world_picture.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

const PlayedTechnique kCollide{"glued", {"contacts=collide"}};

// [m] the largest distance of the two sides of a joint, at its corners.
double largest_gap(const World& world) {
  return largest_of(world.joints(), [&](const BodyJoint& joint) {
    return gap_of(joint_of(world, joint), world.states()).apart;
  });
}

// Bricks that have left their places by more than half their height.
int moved_bricks(const PlayedScene& crane) {
  int moved = 0;
  for (const SceneBox& box : crane.scene().boxes)
    if (box.name.starts_with("brick") &&
        (crane.body(box.name).position_w() - box.position_w).norm() > 0.5 * box.size.y())
      ++moved;
  return moved;
}

// Period of a link on a hinge over that of a physical pendulum with this amplitude.
double period_ratio() {
  constexpr double amplitude = 0.02;  // [rad]
  Simulation link(make_scene("pendulum", {"count=1", setting("angle", amplitude)}), "glued");
  const SceneBox& box = link.scene().boxes[1];
  constexpr double dt = 1.0 / 240.0;
  std::vector<double> turns;  // when the spin changes its sign
  double before = 0.0;
  while (turns.size() < 11 && link.world().time() < 60.0) {
    finished(link.step(dt));
    const double now = link.body("link1").angular_velocity_w().z();
    if (before != 0.0 && (now > 0.0) != (before > 0.0))
      turns.push_back(link.world().time() - dt * now / (now - before));
    before = now;
  }
  const double length = box.size.y(), thick = box.size.x();
  const double inertia = (length * length + thick * thick) / 12.0 + 0.25 * length * length;
  const double exact = 2.0 * std::numbers::pi * std::sqrt(inertia / (kGravity * 0.5 * length)) *
                       (1.0 + amplitude * amplitude / 16.0);
  return (turns.back() - turns.front()) / (0.5 * static_cast<double>(turns.size() - 1)) / exact;
}

// The largest change of a double pendulum's energy in two seconds, over m g L of a link.
double energy_change(int rate) {
  Simulation two(make_scene("pendulum"), "glued");
  const double start = energy_of(two.world()).total();
  double most = 0.0;
  for (int k = 0; k < 2 * rate; ++k) {
    finished(two.step(1.0 / rate));
    most = std::max(most, std::abs(energy_of(two.world()).total() - start));
  }
  const SceneBox& box = two.scene().boxes[1];
  return most / (box.mass * kGravity * box.size.y());
}

Result measure_crane(const Parameters& settings) {
  PlayedScene crane(make_scene("crane"), kCollide);
  Table table{"",
              {{"time_s", "s", "time"},
               {"speed_m_s", "m/s", "speed of the wrecking box"},
               {"moved", "-", "bricks that have moved by more than half their height"},
               {"gap_m", "m", "largest distance of the two sides of a joint"}}};
  Table shown{"shown", {{"time_s", "s", "time of a picture"}}};
  shown.add(0.0);
  std::vector<std::vector<PictureBox>> pictures{picture_boxes(crane.world())};
  std::vector<PictureBox> all = pictures[0];
  double gap = 0.0, fastest = 0.0;
  for (int frame = 1; frame <= 3; ++frame) {
    crane.advance(frame * settings.number("interval"), [&](const StepReport&) {
      const double speed = crane.body("wrecker").velocity_w().norm();
      gap = std::max(gap, largest_gap(crane.world()));
      fastest = std::max(fastest, speed);
      table.add(crane.world().time(), speed, moved_bricks(crane), largest_gap(crane.world()));
    });
    shown.add(crane.world().time());
    pictures.push_back(picture_boxes(crane.world()));
    all.insert(all.end(), pictures.back().begin(), pictures.back().end());
  }
  const Camera camera = camera_for(all, Vec3(1.0, 0.35, 0.45), 300.0, 260.0, true);
  Result result{.tables = {table, shown}};
  for (std::size_t k = 0; k < pictures.size(); ++k)
    result.drawings.push_back(
        {"frame" + std::to_string(k + 1), to_gnuplot(draw_boxes(pictures[k], camera, true, all))});
  result.add("bricks that have moved by more than half their height, of 21", "-",
             moved_bricks(crane));
  result.add("largest speed of the wrecking box", "m/s", fastest);
  result.add("largest distance of the two sides of a joint", "pm", 1e12 * gap);
  result.add("period of a link on a hinge over that of a physical pendulum", "-", period_ratio());
  const double coarse = energy_change(120), fine = energy_change(240);
  result.add("largest change of a double pendulum's energy at 120 steps a second, over m g L", "-",
             coarse);
  result.add("the same over that at 240", "-", coarse / fine);
  return result;
}

const Registered crane_figure{
    {.name = "joint_crane",
     .parameters = {number("interval", 0.7, 0.1, 10.0, "s", "from picture to picture")},
     .quick = {"interval=0.3"},
     .experiment = measure_crane}};

}  // namespace
}  // namespace tumble::chapters
