/// \file
/// \brief A session: what can be thrown and taken away, and that looking does nothing.
#include "session.hpp"

#include "tumble/dynamics/tolerances.hpp"

#include "live/seen.hpp"
#include "support/test.hpp"

using namespace tumble::live;

TEST_CASE("Looking changes nothing of what follows", "[determinism][live]") {
  Session looked("scene projectile\nset scene.rows=3\nset scene.appears=0.1");
  Session alone("scene projectile\nset scene.rows=3\nset scene.appears=0.1");
  for (int k = 0; k < 40; ++k) {
    for (int times = 0; times < 2; ++times) looked.look(kEverything);
    step(looked, 1);
    step(alone, 1);
  }
  CHECK(looked.run().world().hash().text() == alone.run().world().hash().text());
}

TEST_CASE("Five hundred boxes can be thrown, and no more, gone or not", "[unit][live]") {
  Session session("scene line\nset scene.boxes=0:0\ntechnique timewarp_swept");
  step(session, 1);
  for (int k = 0; k < Session::kMostThrown; ++k) {
    session.throw_in(cube(Vec3(0.0, 3.0 * (k + 1), 0.0)));
    if (k == 0) step(session, 1);
    if (k == 1) session.take_away(id_of(session, "thrown1"));
  }
  CHECK(session.run().world().find("thrown500").has_value());
  CHECK(session.run().world().count() == 500);  // one of the scene, 499 of those
  const std::string scene = to_toml(session.run().scene());
  CHECK_THROWS_WITH(session.throw_in(cube(Vec3(0.0, -9.0, 0.0))),
                    Contains("500 boxes have been thrown: reset before the next one"));
  CHECK(to_toml(session.run().scene()) == scene);
}

TEST_CASE("Throws into a scene that was saved take names that are free there", "[unit][live]") {
  Session first("scene box_drop");
  first.throw_in(cube(Vec3(5.0, 5.0, 0.0)));
  step(first, 3);
  first.throw_in(cube(Vec3(8.0, 5.0, 0.0)));
  first.take_away(id_of(first, "thrown1"));
  step(first, 3);

  Session second("toml\n" + to_toml(first.run().scene()));
  second.throw_in(cube(Vec3(-5.0, 5.0, 0.0)));
  CHECK(second.run().world().find("thrown3").has_value());
  step(second, 6);
  CHECK_FALSE(second.run().world().find("thrown1").has_value());
  CHECK(second.run().world().find("thrown2").has_value());
  second.throw_in(cube(Vec3(-8.0, 5.0, 0.0)));
  CHECK(second.run().world().find("thrown4").has_value());
  second.look(0);
  for (const SeenBody& body : bodies_of(second)) {
    const std::string& name =
        second.run().world().name(second.run().world().index_of(BodyId{body.id}));
    CHECK(((body.kind & kThrown) != 0) == (name.find("thrown") == 0));
  }
}

TEST_CASE("A world with boxes as fast as they may be can be looked at", "[unit][live]") {
  Session session("scene dice\nset scene.count=2");
  StepStatus status = StepStatus::done;
  step(session, 1);
  for (int k = 0; k < 40 && status < StepStatus::unsolved; ++k) {
    SceneBox box = cube(Vec3(0.0, 3.0 + k, 0.0), Vec3(0.0, -tolerance::largest_speed, 0.0));
    session.throw_in(box);
    try {
      status = session.step(kDt);
    } catch (const std::invalid_argument&) {
      status = StepStatus::unsolved;
    }
    CHECK_NOTHROW(session.look(kEverything));
  }
  CHECK(session.bodies().size() % kBodyNumbers == 0);
}
