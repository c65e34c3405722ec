/// \file
/// \brief A program that steps, reads, changes and copies worlds, and uses several threads.
#include <cstdio>
#include <stdexcept>
#include <thread>
#include <tumble/tumble.hpp>

namespace {

using namespace tumble;

// [world]
// Two crates on top of each other; SI units, y up, sizes are full edges.
World two_crates() {
  World world;
  world.add_ground(0.5);  // friction; the ground is y <= 0
  const BodyProperties crate = box_properties(Vec3(1.0, 0.5, 1.0), 10.0);
  world.add(crate, make_state(crate, Vec3(0.0, 0.25, 0.0)), "lower");
  world.add(crate, make_state(crate, Vec3(0.1, 0.75, 0.0)), "upper");
  return world;
}
// [world]

// [step]
// One second, in sixty steps. False if a step was not simulated to its end.
bool run_one_second(World& world, Technique& technique) {
  for (int k = 0; k < 60; ++k) {
    const StepReport report = technique.step(world, 1.0 / 60.0);
    if (report.status != StepStatus::done) return false;
  }
  return true;
}
// [step]

// [read]
void print_body(const BodyView& body) {
  const Vec3& at = body.position_w();  // [m]
  std::printf("%s: at (%.3f, %.3f, %.3f) m, %.3f m/s, %.3f rad/s\n", body.name().c_str(), at.x(),
              at.y(), at.z(), body.velocity_w().norm(), body.angular_velocity_w().norm());
}
// [read]

// [contacts]
// [N] Push of the ground: impulses of the last step, over its length.
double push_of_ground(const World& world, const Technique& technique, double dt) {
  double sum = 0.0;
  for (const ContactRecord& contact : technique.contacts()) {
    if (contact.first != world.find("ground")) continue;
    const double push = contact.push_w.dot(contact.normal_w);
    sum += contact.is_impulse ? push / dt : push;
  }
  return sum;
}
// [contacts]

// [errors]
// The message of a refusal has name and value, and nothing has changed.
void make_mistakes(World world, Technique& technique) {
  const std::string before = world.hash().text();
  try {
    technique.step(world, -0.1);
  } catch (const std::invalid_argument& error) {
    std::printf("refused: %s\n", error.what());
  }
  try {
    world.add(box_properties(Vec3(1.0, 0.0, 1.0), 10.0), BodyState());
  } catch (const std::invalid_argument& error) {
    std::printf("refused: %s\n", error.what());
  }
  std::printf("changed: %s\n", world.hash().text() == before ? "no" : "yes");
}
// [errors]

// [snapshot]
// A copy of the world and a clone of the technique go on with the same bits.
void go_on_twice(const World& world, const Technique& technique) {
  Snapshot kept(world, technique);
  Snapshot again = kept;
  for (int k = 0; k < 60; ++k) kept.step(1.0 / 60.0);
  for (int k = 0; k < 60; ++k) again.step(1.0 / 60.0);
  std::printf("twice the same: %s\n",
              kept.world().hash().text() == again.world().hash().text() ? "yes" : "no");
}
// [snapshot]

// [threads]
// Each thread has a world and a technique of its own, and nothing else.
void run_in_threads() {
  std::string hashes[2];
  const auto work = [&hashes](int number) {
    World world = two_crates();
    ContactDamped technique;
    run_one_second(world, technique);
    hashes[number] = world.hash().text();
  };
  std::thread other(work, 1);
  work(0);
  other.join();
  std::printf("in two threads the same: %s\n", hashes[0] == hashes[1] ? "yes" : "no");
}
// [threads]

}  // namespace

/// Runs each of these once and prints the outcome, the same on every machine.
/// \return 0, or 3 if a step was not simulated to its end
int main() {
  World world = two_crates();

  // [technique]
  ContactDampedOptions options;
  options.sleeping = true;
  ContactDamped technique(options);
  // [technique]

  if (!run_one_second(world, technique)) return 3;
  print_body(world.body("upper"));
  std::printf("the ground pushes with %.1f N\n", push_of_ground(world, technique, 1.0 / 60.0));

  // [named]
  const std::unique_ptr<Technique> other = make_technique("damped", {"damping=none"});
  // [named]
  std::printf("made by name: %s\n", std::string(other->name()).c_str());

  // [change]
  // Between steps: hit the upper one, add one, take the lower one away.
  const BodyId upper = *world.find("upper");
  world.push(upper, Vec3(20.0, 0.0, 0.0), Vec3(-0.4, 0.75, 0.0));  // [N s] at a point [m]
  const BodyProperties cube = box_properties(Vec3(0.2, 0.2, 0.2), 1.0);
  world.add(cube, make_state(cube, Vec3(2.0, 1.0, 0.0)), "cube");
  world.remove(*world.find("lower"));
  // [change]
  if (!run_one_second(world, technique)) return 3;
  print_body(world.body(upper));
  print_body(world.body("cube"));

  make_mistakes(world, technique);
  go_on_twice(world, technique);
  run_in_threads();
  std::printf("state hash %s\n", world.hash().text().c_str());
  return 0;
}
