/// \file
/// \brief The layers together: the same bits on every build, and no memory asked for when warm.
#include "tumble/dynamics/snapshot.hpp"

#include "support/allocation_counter.hpp"
#include "support/layer_stepper.hpp"
#include "support/test.hpp"

namespace {

using namespace tumble;
using tumble::test::bouncing_clump;
using tumble::test::LayerStepper;

std::string hash_after(World world, Technique& technique, int steps, double dt) {
  for (int k = 0; k < steps; ++k) technique.step(world, dt);
  return world.hash().text();
}

}  // namespace

TEST_CASE("A bouncing clump of 8 boxes has the golden hash after 1000 steps",
          "[determinism][golden][clump]") {
  // Committed once; the same for g++ and clang++ at -O0 and -O3. If a change to the layers is meant
  // to change bits, say so in CHANGELOG.md under "Changed numbers" and put the new value here.
  const std::string golden = "1c1d681af26c79fc";
  LayerStepper stepper;
  CHECK(hash_after(bouncing_clump(2), stepper, 1000, 1.0 / 60.0) == golden);
}

TEST_CASE("A bouncing clump of 27 boxes has its golden hash after 1000 steps",
          "[determinism][clump]") {
  // Larger, and so for optimised builds only: without optimisation it takes five minutes.
  LayerStepper stepper;
  CHECK(hash_after(bouncing_clump(3), stepper, 1000, 1.0 / 60.0) == "1664464225bfb293");
}

TEST_CASE("A bouncing clump settles on the ground and loses energy on the way", "[unit][clump]") {
  // So that the golden hash is that of boxes that do what boxes do.
  World world = bouncing_clump(3);
  const double start = energy_of(world).total();
  LayerStepper stepper;
  for (int k = 0; k < 1000; ++k) stepper.step(world, 1.0 / 60.0);
  CHECK(energy_of(world).total() < 0.5 * start);
  int low = 0;
  for (const BodyState& state : world.states()) {
    REQUIRE(state.position_w.allFinite());
    if (state.position_w.y() > -0.1 && state.position_w.y() < 4.0) ++low;
  }
  CHECK(low == world.count());
}

TEST_CASE("Any broad phase gives the same bits", "[determinism][clump]") {
  LayerStepper reference("all_pairs");
  const std::string expected = hash_after(bouncing_clump(3), reference, 150, 1.0 / 60.0);
  for (const std::string_view name : broad_phase_names()) {
    INFO(name);
    LayerStepper stepper(name);
    CHECK(hash_after(bouncing_clump(3), stepper, 150, 1.0 / 60.0) == expected);
  }
}
