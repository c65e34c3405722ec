/// \file
/// \brief The runs that a corpus of motions is made of.
#include "filtering/motion_corpus.hpp"

namespace tumble::chapters {
namespace {

constexpr int kSparse = 30;  // [frame] between two moments of a body of the clump
constexpr int kDense = 6;    // ditto, of a box by itself

// A cube that meets the ground turning about a horizontal axis.
Scene tossed(Random chance) {
  Scene scene{.title = "a cube is tossed along the ground", .ground = SceneGround{0.6, 0.0}};
  SceneBox box;
  const double edge = chance.uniform(0.3, 1.0);
  const double speed = chance.uniform(1.0, 3.0);
  const double heading = chance.uniform(0.0, 2.0 * std::numbers::pi);
  const Vec3 ahead(elementary::cos(heading), 0.0, elementary::sin(heading));
  box.size = Vec3::Constant(edge);
  box.friction = 0.6;
  box.position_w = Vec3(0.0, chance.uniform(0.8, 1.2) * edge, 0.0);
  box.velocity_w = speed * ahead;
  box.angular_velocity_w = chance.uniform(1.0, 3.0) * speed / edge * Vec3::UnitY().cross(ahead);
  scene.boxes.push_back(box);
  return scene;
}

// A cube that lies flat and spins like a top, with little friction.
Scene spinning(Random chance) {
  Scene scene{.title = "a cube spins on the ground"};
  const double friction = chance.uniform(1e-4, 1e-2);
  scene.ground = SceneGround{friction, 0.0};
  SceneBox box;
  box.friction = friction;
  box.size = Vec3::Constant(chance.uniform(0.3, 1.0));
  box.position_w = Vec3(0.0, 0.5 * box.size.y(), 0.0);
  box.angular_velocity_w = Vec3(0.0, chance.uniform(0.3, 8.0), 0.0);
  scene.boxes.push_back(box);
  return scene;
}

// [m/s] from 0.02 to 0.3, slow speeds as often as fast ones: the logarithm is drawn.
double slow_speed(Random& chance) { return 0.02 * elementary::pow(15.0, chance.unit()); }

Scene sliding(Random chance) {
  return make_scene("slide", {setting("speed", slow_speed(chance)),
                              setting("friction", 3e-4 + 5e-3 * chance.unit()),
                              setting("heading", chance.uniform(-180.0, 180.0)),
                              setting("height", chance.uniform(0.3, 1.0))});
}

// Down a slope on which friction just balances gravity, so that the speed stays.
Scene down_slope(Random chance) {
  const double angle = chance.uniform(1.0, 8.0);
  const double friction = elementary::sin(angle * std::numbers::pi / 180.0) /
                          elementary::cos(angle * std::numbers::pi / 180.0);
  return make_scene("slope", {setting("angle", angle), setting("friction", friction),
                              setting("speed", slow_speed(chance)), "height=0.8"});
}

Scene rocking(Random chance) {
  return make_scene("rocking_block", {setting("width", chance.uniform(0.2, 0.8)),
                                      setting("tilt", chance.uniform(0.1, 0.6))});
}

}  // namespace

MotionCorpus corpus_of(std::uint64_t seed, int per_edge, int boxes) {
  MotionCorpus corpus;
  add_run(damped_clump(per_edge, seed, 10.0, 4.0), kSparse, Doing::creeps, corpus);

  const Random chance(seed);
  std::uint64_t name = 0;
  const auto add = [&](Scene (*scene)(Random), const char* technique, double time, Doing doing) {
    add_run(settle_scene(scene(chance.fork(++name)), {technique, {}}, 0.0, time, seed), kDense,
            doing, corpus);
  };
  for (const char* technique : {"contact_damped", "impulse"})
    for (int k = 0; k < boxes; ++k) {
      add(sliding, technique, 3.0, Doing::slides);
      add(down_slope, technique, 3.0, Doing::slides);
      add(tossed, technique, 3.0, Doing::rolls);
      add(spinning, technique, 3.0, Doing::rolls);
      add(rocking, technique, 4.0, Doing::rocks);
    }
  return corpus;
}

}  // namespace tumble::chapters
