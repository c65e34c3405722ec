/// \file
/// \brief A small cube thrown at a thin plank: does it pass through?
#include "filtering/thin_plank.hpp"

#include "driver/played_scene.hpp"

#include <memory>

namespace tumble::chapters {

double share_through(double speed, int throws, const AdaptiveStepOptions& options) {
  const TechniqueRecipe& recipe = technique_recipe("damped");
  const double step = kStep;
  int through = 0;
  for (int k = 0; k < throws; ++k) {
    World world;
    world.add(fixed_box_properties(Vec3(0.05, 20.0, 20.0)), BodyState{});
    const BodyProperties cube = box_properties(Vec3::Constant(0.2), 1.0);
    const double distance = 0.5 + speed * step * (k + 0.5) / throws;  // [m] of the centres
    const BodyId id = world.add(
        cube, make_state(cube, Vec3(-distance, 0.0, 0.0), Quat::Identity(), Vec3(speed, 0.0, 0.0)));
    AdaptiveStep technique(recipe.make(recipe.options(), 1), options);
    // Until it would be half a metre behind it, and some frames.
    const double end = (distance + 0.5) / speed + 4.0 * step;
    while (world.time() < end) technique.step(world, step);
    const auto index = static_cast<std::size_t>(world.index_of(id));
    through += world.states()[index].position_w.x() > 0.0 ? 1 : 0;
  }
  return static_cast<double>(through) / throws;
}

}  // namespace tumble::chapters
