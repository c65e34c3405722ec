/// \file
/// \brief The passes over all pairs as printed and mended (thesis 4.3, 4.4, 5.2, A.2; errata RK1 to
///        RK4 and RC1 to RC4).
#include "tumble/contact/gather.hpp"
#include "tumble/contact/impacts.hpp"
#include "tumble/impulse_damped/damped.hpp"
#include "tumble/math/rotation.hpp"

#include "driver/common_numbers.hpp"
#include "impulse_damped/errata_contacts.hpp"

#include <cmath>
#include <stdexcept>

namespace tumble::chapters {
namespace {

// Cubes of 1 m one on another.
World stack_of(int cubes, double restitution) {
  World world = ground_world(restitution);
  for (int k = 0; k < cubes; ++k)
    add_box(world, Vec3::Ones(), Vec3(0.0, 0.5 + k, 0.0), Vec3::Zero(), restitution);
  return world;
}

// Contacts and nothing else: no collision passes, no pushes, no damping, nobody stable.
DampedAsPrintedOptions contacts_alone(const DampedErrata& repaired) {
  DampedAsPrintedOptions options = undamped(repaired);
  options.collision_passes = 0;
  options.numbers.eps1 = 0.0;
  options.stable_boxes = false;
  return options;
}

// RK1. By how much the top of a stack of five sinks in a second.
double sag(const DampedErrata& repaired) {
  World world = stack_of(5, 0.0);
  DampedAsPrinted technique(contacts_alone(repaired));
  run_steps(technique, world, kStep, 60);
  return 4.5 - world.states()[5].position_w.y();
}

// RK2, RK3. How fast a cube is that has lain on the ground for a number of steps.
double resting_speed(int steps, int loop_base, bool elastic) {
  World world = stack_of(1, 0.0);
  DampedAsPrintedOptions options = contacts_alone(misprints());
  options.loop_base = loop_base;
  options.elastic_contacts = elastic;
  DampedAsPrinted technique(options);
  run_steps(technique, world, kStep, steps);
  return velocity_of(world, 1).norm();
}

// RK4. Root mean square speed of a stack of five with restitution 0.9, after it has had as long to
// settle.
double unrest(Technique& technique, double seconds) {
  World world = stack_of(5, 0.9);
  const int steps = static_cast<int>(std::ceil(seconds / kStep));
  run_steps(technique, world, kStep, steps);
  double sum = 0.0;
  for (int step = 0; step < steps; ++step) {
    technique.step(world, kStep);
    for (int k = 1; k <= 5; ++k) sum += velocity_of(world, k).squaredNorm();
  }
  return std::sqrt(sum / (5.0 * steps));
}

double unrest_with_pushes(double seconds) {
  DampedAsPrintedOptions options = undamped(misprints());
  options.stable_boxes = false;
  DampedAsPrinted technique(options);
  return unrest(technique, seconds);
}

double unrest_with_shock_propagation(double seconds) {
  DampedOptions options;
  options.shock = ShockRule::velocity;
  options.stable_boxes = StableRule::off;
  options.damping = damping_parts_from("none");
  options.noise.where = Randomness::off;
  Damped technique(options);
  return unrest(technique, seconds);
}

// All contacts of a world collide at once, each with the speed of approach of the beginning.
World after_impact(World world) {
  std::vector<MovingBody> moving;
  load_moving_bodies(world, moving);
  std::vector<IndexPair> pairs;
  for (int first = 0; first < world.count(); ++first)
    for (int second = first + 1; second < world.count(); ++second) pairs.push_back({first, second});
  ContactList contacts;
  gather_contacts(world, moving, pairs, 1e-9, {}, contacts);
  ImpactOptions together;
  together.order = ImpactOrder::simultaneous;
  if (ImpactSolver().resolve(contacts, moving, together).status != ImpactStatus::done)
    throw std::runtime_error("an impact without an answer");
  store_moving_bodies(moving, world);
  return world;
}

World after_step(World world, const DampedErrata& repaired) {
  DampedAsPrintedOptions options = undamped(repaired);
  options.stable_boxes = false;
  DampedAsPrinted technique(options);
  technique.step(world, kStep);
  return world;
}

// RC1. A cube comes down with 2 m/s on one that lies on the ground; restitution 0.9, and gravity is
// left out.
World cube_on_cube() {
  World world = ground_world(0.9);
  world.gravity_w = Vec3::Zero();
  add_box(world, Vec3::Ones(), Vec3(0.0, 0.5, 0.0), Vec3::Zero(), 0.9);
  add_box(world, Vec3::Ones(), Vec3(0.0, 1.5, 0.0), Vec3(0.0, -2.0, 0.0), 0.9);
  return world;
}

// RC2. A beam flies sideways with 1 m/s. It touches a cube, which halves its speed; another cube is
// 12 mm away, and then out of its reach in this step. Returns how fast that one is afterwards.
double hit_from_afar(const DampedErrata& repaired) {
  World world;
  world.gravity_w = Vec3::Zero();
  add_box(world, Vec3(1.0, 1.0, 3.0), Vec3::Zero(), Vec3(-1.0, 0.0, 0.0));
  add_box(world, Vec3(1.0, 1.0, 0.8), Vec3(-1.0, 0.0, 0.0));
  const int far_one = add_box(world, Vec3(1.0, 1.0, 0.8), Vec3(-1.012, 0.0, 1.0));
  return velocity_of(after_step(world, repaired), far_one).norm();
}

// RC3. Two cubes run into one between them from both sides, with 1 m/s and restitution 0.9.
World squeezed_cube() {
  World world;
  world.gravity_w = Vec3::Zero();
  add_box(world, Vec3::Ones(), Vec3(-1.0, 0.0, 0.0), Vec3(1.0, 0.0, 0.0), 0.9);
  add_box(world, Vec3::Ones(), Vec3::Zero(), Vec3::Zero(), 0.9);
  add_box(world, Vec3::Ones(), Vec3(1.0, 0.0, 0.0), Vec3(-1.0, 0.0, 0.0), 0.9);
  return world;
}

// RC4. By how much a cube turns in the air in half a second at 1 rad/s.
double turned(const DampedErrata& repaired) {
  World world;
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, 0.0);
  world.add(cube,
            make_state(cube, Vec3(0.0, 9.0, 0.0), Quat::Identity(), Vec3::Zero(), Vec3::UnitY()));
  DampedAsPrinted technique(undamped(repaired));
  double angle = 0.0;
  for (int step = 0; step < 30; ++step) {
    const Quat before = world.states()[0].orientation_wb;
    technique.step(world, kStep);
    angle += angle_between(world.states()[0].orientation_wb, before);
  }
  return angle;
}

}  // namespace

void add_pass_errata(double seconds, std::vector<ErratumPair>& pairs) {
  const DampedErrata mended = misprints();
  pairs.push_back({"RK1: sag of a stack of five in 1 s, quotient of integers",
                   "RK1: sag of a stack of five in 1 s, real quotient", "m",
                   sag(mended.without("RK1")), sag(mended)});
  pairs.push_back({"RK2: creep of a cube at rest, passes 0 to 9",
                   "RK2: creep of a cube at rest, passes 1 to 10", "m/s",
                   resting_speed(60, 0, false), resting_speed(60, 1, false)});
  pairs.push_back({"RK3: speed of a cube at rest after a step, elastic contacts",
                   "RK3: speed of a cube at rest after a step, inelastic contacts", "m/s",
                   resting_speed(1, 1, true), resting_speed(1, 1, false)});
  pairs.push_back({"RK4: unrest of a stack of five, bodies pushed",
                   "RK4: unrest of a stack of five, velocities by levels", "m/s",
                   unrest_with_pushes(seconds), unrest_with_shock_propagation(seconds)});
  const World column = cube_on_cube();
  pairs.push_back({"RC1: rebound from a cube on the ground, restitution at each pass",
                   "RC1: rebound from a cube on the ground, restitution once", "m/s",
                   velocity_of(after_step(column, mended), 2).y(),
                   velocity_of(after_impact(column), 2).y()});
  pairs.push_back({"RC2: speed of a cube out of reach, pairs of the pass",
                   "RC2: speed of a cube out of reach, pairs looked at again", "m/s",
                   hit_from_afar(mended), hit_from_afar(mended.with("RC2"))});
  const World row = squeezed_cube();
  pairs.push_back({"RC3: speed of a cube hit from both sides, one pair after the other",
                   "RC3: speed of a cube hit from both sides, both at once", "m/s",
                   velocity_of(after_step(row, mended), 1).norm(),
                   velocity_of(after_impact(row), 1).norm()});
  pairs.push_back({"RC4: angle turned in 0.5 s at 1 rad/s, positions put back",
                   "RC4: angle turned in 0.5 s at 1 rad/s, poses put back", "rad",
                   turned(mended.without("RC4")), turned(mended)});
}

}  // namespace tumble::chapters
