/// \file
/// \brief Flights and searches give the same bits with every compiler and at every optimisation.
#include "tumble/dynamics/event_search.hpp"

#include "dynamics/random_bodies.hpp"
#include "support/test.hpp"

TEST_CASE("Twenty tumbling boxes and their first collisions have the hashes of every other machine",
          "[determinism][golden][integrate]") {
  Random random(71);
  World world = ground_world();
  for (int i = 1; i < 20; ++i) {
    const BodyProperties body = random_box(random);
    world.add(body, random_state(random, body, 4.0, 5.0, 10.0));
    world.states().back().position_w.y() += 6.0;
  }
  const World start = world;
  for (int step = 0; step < 200; ++step) {
    for (std::size_t i = 0; i < world.states().size(); ++i)
      fly(world.bodies()[i], world.states()[i], world.gravity_w, 1.0 / 60.0,
          rotation_rules()[i % 4]);
    world.finish_step(1.0 / 60.0);
  }
  CHECK(world.hash().text() == "434231950d9456ff");

  std::vector<IndexPair> pairs;
  for (int i = 0; i < 20; ++i)
    for (int j = i + 1; j < 20; ++j) pairs.push_back({i, j});
  StateHash hash;
  EventSearch search;
  for (const SearchMethod method : {SearchMethod::discrete, SearchMethod::conservative}) {
    const FirstEvent& event = search.find({.bodies = start.bodies(), .states = start.states()},
                                          pairs, 0.0, 0.25, {.method = method});
    CHECK(event.status == CollisionStatus::found);
    hash.add(event.time);
    for (const IndexPair& pair : event.touching) {
      hash.add(static_cast<std::uint64_t>(pair.first));
      hash.add(static_cast<std::uint64_t>(pair.second));
    }
  }
  CHECK(hash.text() == "62caa81f0a08a6a5");
}
