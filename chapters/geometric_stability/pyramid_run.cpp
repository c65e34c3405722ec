/// \file
/// \brief How many contact forces are unknown, step by step, while a pyramid is simulated.
#include "geometric_stability/pyramid_run.hpp"

#include "tumble/analytic_lcp/analytic.hpp"
#include "tumble/base/random.hpp"

#include "driver/common_numbers.hpp"
#include "geometric_stability/resting_pile.hpp"

#include <stdexcept>

namespace tumble::chapters {
CountedRun count_run(World world, int steps, const std::function<void(const World&)>& before) {
  AnalyticOptions options;
  options.friction = AnalyticFriction::damping;
  options.stable_boxes = StableRule::corners;
  Analytic analytic(options);
  StableBoxes boxes(StableRule::corners);
  CountedRun run;
  for (int step = 0; step < steps; ++step) {
    if (before) before(world);
    const RestingPile pile = pile_now(world, kStep);
    const std::span<const char> held = boxes.find(world, pile.bodies, pile.contacts);
    const std::vector<char> nobody(held.size(), 0);
    run.all.push_back(points_without(pile, nobody));
    run.left.push_back(points_without(pile, held));
    run.stable.push_back(movable_marked(world, held));
    if (analytic.step(world, kStep).status == StepStatus::unsolved)
      throw std::runtime_error("a step of the pyramid was not solved");
  }
  return run;
}

World knocked_pyramid(int rows, double gap, double knock, std::uint64_t seed) {
  RestingPile pile = pile_of(pyramid_without_middle(rows, gap));
  StableBoxes boxes(StableRule::corners);
  const std::span<const char> held = boxes.find(pile.world, pile.bodies, pile.contacts);
  const Random random(seed);
  for (std::size_t b = 0; b < held.size(); ++b) {
    if (held[b] != 0) continue;
    Random draws = random.fork(b);
    pile.world.states()[b].linear_momentum_w = pile.world.bodies()[b].mass * draws.in_cube(knock);
  }
  return std::move(pile.world);
}

}  // namespace tumble::chapters
