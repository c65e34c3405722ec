/// \file
/// \brief Promises of every technique, those of the library and the one of the example.
#include "tumble/dynamics/tolerances.hpp"

#include "add_a_technique/cushion.hpp"
#include "impulse_damped/scene_runs.hpp"
#include "support/allocation_counter.hpp"
#include "support/changed_world.hpp"
#include "support/test.hpp"

namespace {

std::vector<TechniqueRecipe> all_techniques() {
  std::vector<TechniqueRecipe> all = technique_library();
  all.push_back(example::cushion_recipe());
  return all;
}

std::unique_ptr<Technique> made(const TechniqueRecipe& recipe, const Settings& set = {}) {
  Parameters options = recipe.options();
  for (const auto& [key, value] : set)
    if (options.has(key)) options.set(key, value);
  return recipe.make(options, 1);
}

// Chance turns normals by angles of its own, in a mirror too.
std::unique_ptr<Technique> without_chance(const TechniqueRecipe& recipe) {
  Parameters options = recipe.options();
  if (options.has("randomness")) options.set("randomness", "off");
  return recipe.make(options, 1);
}

// Rest, tumbling, sliding and a hit; short enough for every technique.
std::vector<World> small_worlds() {
  return {world_of("stack", {{"count", "3"}}), world_of("box_drop"), world_of("slide"),
          world_of("two_boxes")};
}

}  // namespace

TEST_CASE("Every technique and its copies are called what its recipe says", "[unit][technique]") {
  for (const TechniqueRecipe& recipe : all_techniques()) {
    INFO(recipe.name);
    const auto technique = made(recipe);
    CHECK(technique->name() == recipe.name);
    CHECK(technique->clone()->name() == recipe.name);
    CHECK_FALSE(recipe.section.empty());
    CHECK_FALSE(recipe.summary.empty());
  }
}

TEST_CASE("Every technique refuses a step that is not above 0 and changes nothing",
          "[unit][technique]") {
  for (const TechniqueRecipe& recipe : all_techniques()) {
    World world = world_of("stack", {{"count", "2"}});
    const std::string before = world.hash().text();
    const auto technique = made(recipe);
    for (const double dt : {0.0, -kFrame, kInfinity, kNan}) {
      INFO(recipe.name << ", dt " << dt);
      CHECK_THROWS_AS(technique->step(world, dt), std::invalid_argument);
      CHECK(world.hash().text() == before);
    }
  }
}

TEST_CASE("A step of every technique takes its time, whatever there is to step",
          "[unit][technique]") {
  World walls = ground_world();
  const BodyProperties wall = fixed_box_properties(Vec3::Ones());
  for (int k = 0; k < 2; ++k) walls.add(wall, Vec3(0.5 * k, 0.4, 0.0));
  for (const TechniqueRecipe& recipe : all_techniques()) {
    for (World world : {World(), walls, world_of("tumbling_box")}) {
      INFO(recipe.name << ", " << world.count() << " bodies");
      const auto technique = made(recipe);
      CHECK(technique->step(world, kFrame).status == StepStatus::done);
      CHECK(world.time() == kFrame);
      CHECK(world.steps() == 1);
    }
  }
}

TEST_CASE("A scene at the limits of its values is stepped, or refused for a value that was given",
          "[unit][technique]") {
  // With the longest step a spin is refused as a rotation.
  const double most = tolerance::largest_speed;
  SceneBox box{.position_w = Vec3(0.0, 0.6, 0.0)};
  SceneBox beside = box;
  beside.position_w.x() = 2.0;
  Scene still{.ground = SceneGround{}};
  still.boxes = {box, beside};
  std::vector<Scene> scenes(4, still);
  scenes[0].gravity_w *= most / 10.0;
  scenes[1].boxes[0].velocity_w = Vec3(0.7 * most, -0.7 * most, 0.0);
  scenes[2].boxes[0].angular_velocity_w = Vec3(0.0, 0.8 * most, 0.8 * most);
  scenes[3].boxes[0].position_w = Vec3(tolerance::farthest, tolerance::farthest, 0.0);
  for (const TechniqueRecipe& recipe : all_techniques()) {
    for (std::size_t k = 0; k < scenes.size(); ++k) {
      for (const double dt : {tolerance::shortest_step, kFrame, tolerance::longest_step}) {
        INFO(recipe.name << ", scene " << k << ", dt " << dt);
        Simulation run(scenes[k], made(recipe));
        std::string refusal;
        try {
          for (int step = 0; step < 3 && run.step(dt).status < StepStatus::unsolved;) ++step;
        } catch (const std::invalid_argument& error) {
          refusal = error.what();
        } catch (const StepFault& fault) {
          refusal = fault.what();
        }
        INFO(refusal);
        CHECK(refusal.find("margin") == std::string::npos);
        CHECK(refusal.find("= nan") == std::string::npos);
        CHECK(refusal.find("= inf") == std::string::npos);
      }
    }
  }
}

TEST_CASE("Every technique goes through the same bits again, and from a copy on",
          "[determinism][technique]") {
  const auto go_on = [](World& world, Technique& technique, int steps) {
    for (int k = 0; k < steps; ++k) technique.step(world, k % 2 == 0 ? kFrame : 0.01);
  };
  std::vector<World> starts = small_worlds();
  starts.push_back(world_of("crate_off_table"));
  for (const TechniqueRecipe& recipe : all_techniques()) {
    for (const Settings& set : {Settings{},
                                {{"sleeping", "on"}},
                                {{"pose", "exponential"}, {"scheme", "impulse"}},
                                {{"reading", "as_printed"}, {"repaired", "all"}}}) {
      if (!set.empty() && !recipe.options().has(set[0].first)) continue;
      for (const World& start : starts) {
        World world = start;
        World again = start;
        const auto technique = made(recipe, set);
        go_on(world, *technique, 20);
        World copy = world;
        const auto clone = technique->clone();
        const bool same_contacts = clone->contacts().size() == technique->contacts().size();
        go_on(world, *technique, 20);
        go_on(copy, *clone, 20);
        go_on(again, *made(recipe, set), 40);
        INFO(recipe.name << (set.empty() ? "" : ", " + set[0].first) << ", "
                         << start.name(start.count() - 1));
        CHECK(same_contacts);
        CHECK(copy.hash().text() == world.hash().text());
        CHECK(again.hash().text() == world.hash().text());
      }
    }
  }
}

TEST_CASE("A warm step of every technique but two asks for no memory",
          "[unit][technique][allocation]") {
  const World stack = world_of("stack", {{"count", "4"}});
  const std::pair<World, Settings> cases[] = {{stack, {}},
                                              {world_of("pyramid", {{"rows", "4"}}), {}},
                                              {stack, {{"pose", "exponential"}}},
                                              {stack, {{"shock", "position"}}}};
  for (const TechniqueRecipe& recipe : all_techniques()) {
    // These ask for some in each step (measured), and do not promise otherwise.
    if (recipe.name == "glued" || recipe.name == "timewarp_full") continue;
    for (const auto& [start, set] : cases) {
      if (!set.empty() && !recipe.options().has(set[0].first)) continue;
      World world = start;
      const auto technique = made(recipe, set);
      run(world, *technique, 0.5);
      const AllocationCount count;
      for (int k = 0; k < 10; ++k) technique->step(world, kFrame);
      const auto asked = count.value();  // before the message, which asks for some itself
      INFO(recipe.name << ", " << world.count() << " bodies"
                       << (set.empty() ? "" : ", " + set[0].first));
      CHECK(asked == 0);
    }
  }
}

TEST_CASE("Under every technique but one a box that meets no other falls as gravity says",
          "[exact][technique]") {
  for (const TechniqueRecipe& recipe : all_techniques()) {
    if (recipe.name == "settling") continue;  // knows no velocities
    World world;
    world.add(box_properties(Vec3(1.0, 0.5, 0.2), 2.0), Vec3::Zero(), Quat::Identity(),
              Vec3(1.0, 2.0, 0.0), Vec3(0.3, 1.0, -0.5));
    const Vec3 spin_w = world.states()[0].angular_momentum_w;
    run(world, *made(recipe), 0.5);
    const double t = world.time();
    const BodyState& state = world.states()[0];
    INFO(recipe.name);
    CHECK(state.position_w.x() == near(t, 1e-12));
    // [m] A rule of first order is off by g t h/2.
    CHECK(state.position_w.y() ==
          near(2.0 * t - 0.5 * kGravity * t * t, 0.51 * kGravity * t * kFrame));
    CHECK(state.linear_momentum_w.y() == near(2.0 * (2.0 - kGravity * t), 1e-12));
    if (recipe.name == "relaxation") continue;  // rods let a spin die out
    CHECK((state.angular_momentum_w - spin_w).norm() < 1e-12);
  }
}

TEST_CASE("Under every technique but one boxes that meet in free space keep their momentum",
          "[exact][technique]") {
  for (const TechniqueRecipe& recipe : all_techniques()) {
    if (recipe.name == "settling") continue;  // knows no velocities
    World world = world_of("two_boxes");
    const Vec3 before = linear_momentum(world);
    run(world, *made(recipe), 1.0);
    INFO(recipe.name);
    CHECK((linear_momentum(world) - before).norm() < 1e-12);  // [kg m/s] of 2
  }
}

TEST_CASE("Under every technique without chance a scene in the mirror does what its image does",
          "[exact][technique]") {
  for (const TechniqueRecipe& recipe : all_techniques()) {
    if (recipe.name == "relaxation")
      continue;  // the four particles of a box are not their own image
    for (const World& start : small_worlds()) {
      World world = start;
      World image = mirrored(start);
      run(world, *without_chance(recipe), 0.5);
      run(image, *without_chance(recipe), 0.5);
      INFO(recipe.name << ", " << start.name(start.count() - 1));
      CHECK(distance_of(mirrored(world), image) < 1e-9);  // [m]
    }
  }
}

TEST_CASE("Contacts of every technique name bodies that are there and do not pull",
          "[unit][technique]") {
  for (const TechniqueRecipe& recipe : all_techniques()) {
    World world = world_of("stack", {{"count", "3"}});
    const auto technique = made(recipe);
    for (int k = 0; k < 20; ++k) {
      const double begin = world.time();
      technique->step(world, kFrame);
      for (const ContactRecord& contact : technique->contacts()) {
        INFO(recipe.name << ", step " << k);
        CHECK(contact.first < contact.second);
        CHECK(world.find(contact.first).has_value());
        CHECK(world.find(contact.second).has_value());
        CHECK(contact.normal_w.norm() == near(1.0, 1e-12));
        CHECK(contact.push_w.dot(contact.normal_w) >= -1e-12);
        CHECK(contact.time >= begin);
        CHECK(contact.time <= world.time());
      }
    }
  }
}

TEST_CASE("Every technique steps the scenes that are compared, or refuses them by its name",
          "[unit][technique]") {
  struct Compared {
    const char* scene;
    int steps;  // exact times take a second for one step of the pyramid of figure 6.6
  };
  for (const auto& [scene, steps] :
       {Compared{"bouncing_box", 30}, Compared{"stack", 3}, Compared{"dice", 3},
        Compared{"fig6_6", 1}, Compared{"fig6_7", 3}}) {
    for (const TechniqueRecipe& recipe : technique_library()) {
      INFO(scene << ", " << recipe.name);
      World world = world_of(scene);
      const double before = world.time();
      const auto technique = make_technique(recipe.name);
      const std::string refusal = refusal_of([&, count = steps] {
        for (int k = 0; k < count; ++k)
          CHECK(technique->step(world, kFrame).status < StepStatus::unsolved);
      });
      if (refusal.empty()) {
        CHECK(world.time() == near(before + steps * kFrame, 1e-12));
        for (const BodyState& state : world.states()) CHECK(state.position_w.allFinite());
      } else {
        CHECK(refusal.find("technique " + std::string(recipe.name)) != std::string::npos);
      }
    }
  }
}
