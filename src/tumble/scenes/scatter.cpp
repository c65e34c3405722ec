/// \file
/// \brief Piles whose boxes are a little off their places.
#include "tumble/geometry/swept.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/scenes/recipes.hpp"

#include <numbers>

namespace tumble::recipes {
namespace {

bool one_above_the_other(const Bounds& a, const Bounds& b) {
  return a.low.x() <= b.high.x() && b.low.x() <= a.high.x() && a.low.z() <= b.high.z() &&
         b.low.z() <= a.high.z();
}

// The height of a box's centre when it has been lowered on the boxes before it, or on the ground.
double lowered(Box box, const std::vector<Box>& before, const std::vector<Bounds>& bounds) {
  const double below = reach(box, Vec3::UnitY());
  double height = below;  // on the ground
  box.center_w.y() = 0.0;
  const Bounds own = bounds_of(box);
  for (std::size_t k = 0; k < before.size(); ++k) {
    if (!one_above_the_other(own, bounds[k])) continue;
    // From a place over the other box down to the height found so far, not turning: exact.
    const double start = bounds[k].high.y() + 2.0 * below;
    if (start <= height) continue;
    box.center_w.y() = start;
    const Vec3 down(0.0, height - start, 0.0);
    const SweepResult fall = sweep(box, down, before[k], Vec3::Zero());
    if (fall.status == SweepStatus::hit) height = start + fall.enter * down.y();
  }
  return height;
}

}  // namespace

Parameters with_scatter(Parameters p) {
  p.add(
      number("scatter", 0.0, 0.0, 0.1, "m", "how far each box is off its place, along each axis"));
  return p.add(number("scatter_angle", 0.0, 0.0, 10.0, "deg",
                      "largest rotation of each box, about any axis"));
}

void scatter(const Parameters& p, const Random& random, Scene& scene) {
  const double distance = p.number("scatter");
  const double angle = p.number("scatter_angle") * std::numbers::pi / 180.0;
  if (distance == 0.0 && angle == 0.0) return;
  std::vector<Box> before;
  std::vector<Bounds> bounds;
  for (std::size_t k = 0; k < scene.boxes.size(); ++k) {
    SceneBox& box = scene.boxes[k];
    Random chance = random.fork(k);
    const Vec3 shift = chance.in_cube(distance);
    const double turn = chance.uniform(0.0, angle);
    box.orientation_wb = rotation_from_vector(turn * chance.direction());
    box.position_w += Vec3(shift.x(), 0.0, shift.z());
    const Box shape = make_box(box.position_w, box.orientation_wb, box.size);
    box.position_w.y() = lowered(shape, before, bounds) + std::abs(shift.y());
    before.push_back(make_box(box.position_w, box.orientation_wb, box.size));
    bounds.push_back(bounds_of(before.back()));
  }
}

}  // namespace tumble::recipes
