/// \file
/// \brief Invariance of glued steps under displacement, motion, units, reflection and order.

#include "exterior_rotation/cases.hpp"
#include "support/test.hpp"

namespace {

// The scenes in a plane, and one in which three axes take part.
std::vector<World> worlds() {
  World group = flying_group(Vec3(0.0, -9.81, 0.0));
  return {world_of("fig6_1"), world_of("fig6_3"), std::move(group)};
}

World stepped(World world, const GluedOptions& options, int steps, double dt = kFrame) {
  Glued technique(options);
  run(world, technique, steps, dt);
  return world;
}

}  // namespace

TEST_CASE("A group that is turned about the vertical does the same, turned",
          "[exact][exterior_rotation]") {
  const Quat yaw = rotation_from_vector(Vec3(0.0, std::numbers::pi / 6.0, 0.0));
  const auto turned_world = [&](const World& world) {
    return changed(world, [&](BodyProperties&, BodyState& state) {
      state.position_w = yaw * state.position_w;
      state.orientation_wb = normalised(yaw * state.orientation_wb);
      state.linear_momentum_w = yaw * state.linear_momentum_w;
      state.angular_momentum_w = yaw * state.angular_momentum_w;
    });
  };
  for (const GluedOptions& options : all_ways())
    for (const World& world : worlds()) {
      INFO(text_of(options));
      const World one = turned_world(stepped(world, options, 60));
      const World other = stepped(turned_world(world), options, 60);
      CHECK(apart(one, other) < 1e-11);  // [m, -] rounding of 60 steps
    }
}

TEST_CASE("A group in free flight does the same in a moving frame", "[exact][exterior_rotation]") {
  const Vec3 boost(3.0, -2.0, 1.0);
  for (const GluedOptions& options : all_ways()) {
    INFO(text_of(options));
    const World world = flying_group(Vec3(0.0, -9.81, 0.0));
    const World one = stepped(world, options, 60);
    World other = changed(world, [&](BodyProperties& body, BodyState& state) {
      state.linear_momentum_w += body.mass * boost;
    });
    other = stepped(other, options, 60);
    for (BodyState& state : other.states()) state.position_w -= other.time() * boost;
    CHECK(apart(one, other) < 1e-11);  // [m, -] rounding of 60 steps
    CHECK(apart(one, world) > 0.1);    // it tumbles
  }
}

TEST_CASE(
    "Bodies that stick do the same to the last bit at four times the length, twice the time and "
    "any "
    "power of two of the mass",
    "[determinism][exterior_rotation]") {
  for (const GluedJoints joints : {GluedJoints::bilateral, GluedJoints::unilateral})
    for (GluedOptions options : all_ways()) {
      options.joints = joints;
      for (const double mass : {1.0, 2.0, 0x1p-10})
        for (World& world : worlds()) {
          INFO(text_of(options) << ", mass times " << mass);
          World other = in_other_units(world, mass);
          world = stepped(world, options, 40);
          other = stepped(other, options, 40, 2.0 * kFrame);
          int differ = 0;
          for (std::size_t k = 0; k < world.states().size(); ++k) {
            BodyState state = world.states()[k];
            state.position_w *= 4.0;
            state.linear_momentum_w *= 2.0 * mass;
            state.angular_momentum_w *= 8.0 * mass;
            if (!(state == other.states()[k])) ++differ;
          }
          CHECK(differ == 0);
        }
    }
}

TEST_CASE("The order in which bodies that stick are added does not matter",
          "[exact][exterior_rotation]") {
  for (const GluedOptions& options : all_ways())
    // Except the group in flight: of its three joints one is redundant, and the order decides which one is
    // left out; results differ by its gap.
    for (const World& world : {world_of("fig6_1"), world_of("fig6_3")}) {
      INFO(text_of(options));
      World backwards;
      backwards.gravity_w = world.gravity_w;
      for (std::size_t k = world.states().size(); k-- > 0;) {
        const BodyProperties& body = world.bodies()[k];
        if (body.shape == Shape::ground)
          backwards.add_ground(body.friction);
        else
          backwards.add(body, world.states()[k], world.name(static_cast<int>(k)));
      }
      const World one = stepped(world, options, 60);
      World other = stepped(backwards, options, 60);
      std::ranges::reverse(other.states());
      CHECK(apart(one, other) < 1e-11);  // [m, -] rounding of 60 steps
    }
}
