/// \file
/// \brief A program that reads scenes from TOML, simulates them, and records runs that can be drawn.
#include <array>
#include <cstdio>
#include <stdexcept>
#include <tumble/tumble.hpp>

namespace {

using namespace tumble;

// [text]
constexpr const char* kTower = R"(title = "two cubes, and one that comes later"
[ground]
friction = 0.6

[[box]]
name = "foot"
size = [1.0, 1.0, 1.0]
mass = 2.0
position = [0.0, 0.5, 0.0]

[[box]]
name = "head"
size = [0.8, 0.8, 0.8]
mass = 1.0
position = [0.0, 1.4, 0.0]

[[box]]
name = "late"
size = [0.5, 0.5, 0.5]
mass = 0.5
position = [0.1, 3.0, 0.0]
appears = 0.5
)";
// [text]

// [mistake]
// The message of a mistake has file, line, key and the values that are accepted.
void read_a_bad_scene() {
  std::string text = kTower;
  text.replace(text.find("2.0"), 3, "-2.0");
  try {
    parse_scene(text, "tower.toml");
  } catch (const std::invalid_argument& error) {
    std::printf("refused: %s\n", error.what());
  }
}
// [mistake]

// [play]
// With a box thrown in and one taken away. Both are written into the scene that is returned.
Scene play() {
  Simulation run(parse_scene(kTower, "tower.toml"));
  MetricsMeter meter;
  run.observe(meter);
  run.run_for(1.5);
  SceneBox ball;
  ball.size = Vec3(0.3, 0.3, 0.3);
  ball.position_w = Vec3(-3.0, 1.5, 0.0);
  ball.velocity_w = Vec3(6.0, 1.0, 0.0);
  const std::string name = run.throw_in(ball);
  run.run_for(1.5);
  run.take_away("foot");
  run.run_for(2.0);
  std::printf("played: threw %s, overlap at the end %s 1 mm, state hash %s\n", name.c_str(),
              meter.metrics().deepest_overlap < 1e-3 ? "below" : "above",
              run.world().hash().text().c_str());
  return run.scene();
}
// [play]

// [record]
// The same as `tumble run` of this scene; `tumble render runs/tower --as svg` draws the files.
std::string record(const Scene& scene) {
  ContactDamped technique;
  RunDescription description;
  description.scene = "tower";
  description.technique = technique.name();
  description.run.duration = 5.0;
  description.contacts = true;
  RunFiles files("runs/tower", description, scene);
  const std::array<RunObserver*, 1> observers = {&files};
  const RunResult result = run_scene(scene, technique, description.run, observers);
  files.finish(result);
  return result.state_hash;
}
// [record]

// [builtin]
// A built-in scene with a setting changed, as with --set count=5.
Scene stack_of_five() { return make_scene("stack", {"count=5"}); }
// [builtin]

}  // namespace

/// Runs each of these once and leaves the folder runs/tower.
/// \return 0, or 4 if the folder cannot be written
int main() try {
  read_a_bad_scene();
  const Scene played = play();
  std::printf("recorded: state hash %s\n", record(played).c_str());
  std::printf("a stack of %zu\n", stack_of_five().boxes.size());
  return 0;
} catch (const CannotWrite& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 4;
}
