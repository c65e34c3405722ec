/// \file
/// \brief Boxes that settle under damped integration, seen as a viewer sees them (thesis 5.3).
#pragma once

#include "tumble/filtering/corner_motion.hpp"
#include "tumble/impulse_damped/damped.hpp"
#include "tumble/record/chatter.hpp"
#include "tumble/record/overlap.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// [-] Of free fall: a box that rests and shakes more chatters.
inline constexpr double kShake = 0.1;
inline constexpr double kStill = 5e-4;  // [-] a corner that moves less in a step, in edges, rests
inline constexpr double kPlay = 1e-3;   // [m] between a plank or block and what stops it

// How a box ends a run; its last half second, seen on frames of 1/60 s.
struct BoxEnd {
  bool rests = false;      // it touches others all the time and gets nowhere: see ChatterMeter
  double shake = 0.0;      // [-] of a box that rests: its acceleration, see Chatter
  double rest_time = 0.0;  // [s] when one of its corners last moved by more than a little
  bool on_face = false;    // a face of it has lain on another body; otherwise it leans
  double tilt = 0.0;       // [rad] between the vertical and its nearest axis
  bool aligned = false;    // what the alignment test says, with its ε2

  // Whether it chatters: it rests, but shakes by more than a tenth of free fall.
  [[nodiscard]] bool chatters() const { return rests && shake > kShake; }
};

// Bodies that touch, and those that have a face on what is below: a normal within 45 degrees of up that is across
// one of its own faces, within 10 degrees. This knows nothing of the alignment test.
inline void mark(const World& world, const Contact& contact, std::vector<char>& touches,
                 std::vector<BoxEnd>& ends) {
  const auto first = static_cast<std::size_t>(contact.first);
  const auto second = static_cast<std::size_t>(contact.second);
  double distance = std::numeric_limits<double>::infinity();
  for (int p = 0; p < contact.count; ++p)
    distance = std::min(distance, contact.points[idx(p)].distance);
  if (!(distance <= touching_distance(world.bodies()[first], world.bodies()[second]))) return;
  touches[first] = 1;
  touches[second] = 1;
  if (!(std::abs(contact.normal_w.y()) > elementary::cos(std::numbers::pi / 4.0))) return;
  const std::size_t upper = contact.normal_w.y() > 0.0 ? second : first;
  const Mat3 axes_w = world.states()[upper].orientation_wb.toRotationMatrix();
  const double nearest = (axes_w.transpose() * contact.normal_w).cwiseAbs().maxCoeff();
  if (nearest > elementary::cos(std::numbers::pi / 18.0)) ends[upper].on_face = true;
}

// Runs a world under damped integration with steps of 1/60 s.
// duration: [s] at least a second
// \par Cost
// That of the steps; contacts are looked for again in the last half second.
inline std::vector<BoxEnd> settle(World world, const DampedOptions& options, double duration) {
  Damped technique(options);
  PairGatherer areas(NormalRule::separation, PointRule::area);
  ContactList contacts;
  const auto count = static_cast<std::size_t>(world.count());
  std::vector<BoxEnd> ends(count);
  ChatterMeter meter;
  double margin = 0.0;  // [m] of the largest box
  for (const BodyProperties& body : world.bodies())
    if (body.movable()) margin = std::max(margin, touching_distance(body, body));

  const int steps = static_cast<int>(std::lround(duration / kStep));
  for (int n = 1; n <= steps; ++n) {
    const std::vector<BodyState> before(world.states().begin(), world.states().end());
    finished(technique.step(world, kStep));
    for (std::size_t k = 0; k < count; ++k) {
      const BodyProperties& body = world.bodies()[k];
      if (!body.movable()) continue;
      const double way = largest_displacement(corners_of(box_of(body, before[k])),
                                              corners_of(box_of(body, world.states()[k])));
      if (!(way <= kStill * body.size.minCoeff())) ends[k].rest_time = world.time();
    }
    if (n <= steps - ChatterMeter::kWindow) continue;
    std::vector<char> touches(count, 0);
    areas.gather(world, world.states(), world.states(), nullptr, margin, contacts);
    for (const Contact& contact : contacts) mark(world, contact, touches, ends);
    meter.add(world, touches);
  }

  for (const BodyChatter& chatter : meter.each(world.gravity_w.norm())) {
    BoxEnd& end = ends[static_cast<std::size_t>(world.index_of(chatter.id))];
    end.rests = true;
    end.shake = chatter.acceleration;
  }
  std::vector<BoxEnd> movable;
  for (std::size_t k = 0; k < count; ++k) {
    if (!world.bodies()[k].movable()) continue;
    BoxEnd& end = ends[k];
    const Quat& turned = world.states()[k].orientation_wb;
    const double upright = turned.toRotationMatrix().row(1).cwiseAbs().maxCoeff();
    end.tilt = elementary::acos(std::min(1.0, upright));
    const DampedThresholds eps =
        thresholds_of(options.numbers, world.bodies()[k], world.gravity_w.norm(), kStep);
    end.aligned = check_y_axis_alignment(turned, eps.aligned);
    movable.push_back(end);
  }
  return movable;
}

// Figure 6.7 with few cubes, 1.75 m from centre to centre, so that they meet soon.
inline World clump(int per_edge, int seed) {
  return build_world(make_scene("fig6_7", {"per_edge=" + std::to_string(per_edge), "spacing=1.75"},
                                static_cast<std::uint64_t>(seed)));
}

// The scene `leaning` at a random angle of 50 to 75 degrees: three planks, each on its block.
//
// Damped integration has no friction, so a kerb keeps each plank's foot from sliding away, and a
// wall each block.
inline World propped_planks(int seed) {
  Random random(static_cast<std::uint64_t>(seed));
  const double degrees = random.uniform(50.0, 75.0);
  const SceneRecipe& recipe = scene_recipe("leaning");
  Parameters p = recipe.parameters();
  p.set("angle", std::to_string(degrees));
  Scene scene = recipe.build(p, random);
  const std::vector<SceneBox> boxes = scene.boxes;
  for (const SceneBox& box : boxes) {
    const auto corners = corners_of(make_box(box.position_w, box.orientation_wb, box.size));
    double left = corners[0].x();
    double right = left;
    for (const Vec3& corner : corners) {
      left = std::min(left, corner.x());
      right = std::max(right, corner.x());
    }
    const bool plank = box.name.starts_with("plank");
    SceneBox stop{
        .name = "stop_" + box.name, .size = Vec3(0.2, plank ? 0.2 : 1.0, 0.5), .fixed = true};
    const double x = plank ? right + kPlay + 0.1 : left - kPlay - 0.1;
    stop.position_w = Vec3(x, 0.5 * stop.size.y(), box.position_w.z());
    scene.boxes.push_back(stop);
  }
  return build_world(scene);
}

}  // namespace tumble::chapters
