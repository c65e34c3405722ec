/// \file
/// \brief A step and its passes over all pairs, as printed and mended (thesis 4.3, 4.4, 5.2, A.2; errata D1 to
///        D6, RK1 to RK4 and RC1 to RC4).
#include "tumble/contact/impacts.hpp"
#include "tumble/impulse_damped/damped.hpp"

#include "impulse_damped/errata_setup.hpp"

namespace tumble::chapters {
namespace {

constexpr int kSecond = 60;  // [-] steps

// D1. By how much the heights of a resting cube differ at most in a second, between the order of
// the listing and that of 5.2.
double difference_of_orders(const DampedErrata& repaired) {
  World listed = cube_on_ground();
  World in_prose = listed;
  DampedAsPrintedOptions options = undamped(repaired.without("D1"), false);
  options.numbers.eps1 = 0.0;  // no push hides it
  DampedAsPrinted listing(options);
  options.repaired = repaired.with("D1");
  DampedAsPrinted prose(options);
  double most = 0.0;
  for (int step = 0; step < kSecond; ++step) {
    finished(listing.step(listed, kStep));
    finished(prose.step(in_prose, kStep));
    most = std::max(
        most, std::abs(listed.states()[1].position_w.y() - in_prose.states()[1].position_w.y()));
  }
  return most;
}

// D2. How far a cube flies in a second at 1 m/s, in steps half as long as usual.
double flown(const DampedErrata& repaired) {
  World world;
  world.gravity_w = Vec3::Zero();
  add_box(world, Vec3::Ones(), Vec3::Zero(), Vec3::UnitX());
  world = stepped(world, DampedAsPrinted(undamped(repaired)), 2 * kSecond, 0.5 * kStep);
  return world.states()[0].position_w.x();
}

// D3. How far a cube slides in the first step at 1 m/s, if a step in contact leaves k of its
// velocity.
double slid(double k) {
  DampedAsPrintedOptions options = undamped(misprints());
  options.numbers.k1 = k;
  return stepped(cube_on_ground(Vec3::UnitX()), DampedAsPrinted(options))
      .states()[1]
      .position_w.x();
}

// D4. After how many of the first ten steps a cube that lies half a push above the ground is not
// found to be stable.
double steps_unstable(const DampedErrata& repaired) {
  World world = ground_world();
  add_box(world, Vec3::Ones(), Vec3(0.0, 0.5005, 0.0));
  DampedAsPrinted technique(undamped(repaired));
  int unstable = 0;
  for (int step = 0; step < 10; ++step) {
    finished(technique.step(world, kStep));
    if (!technique.geometrically_stable(world.ids()[1])) ++unstable;
  }
  return unstable;
}

// D5. Where a cube is after falling for a second from 10 m.
double fallen_to(const DampedErrata& repaired) {
  World world;
  add_box(world, Vec3::Ones(), Vec3(0.0, 10.0, 0.0));
  world = stepped(world, DampedAsPrinted(undamped(repaired)), kSecond);
  return world.states()[0].position_w.y();
}

// D6. How fast a cube is that has lain on the ground for a second.
double speed_at_rest(const DampedErrata& repaired) {
  return BodyView(stepped(cube_on_ground(), DampedAsPrinted(undamped(repaired, false)), kSecond), 1)
      .velocity_w()
      .norm();
}

// Cubes of 1 m one on another.
World stack_of(int cubes, double restitution) {
  World world = ground_world(restitution);
  for (int k = 0; k < cubes; ++k)
    add_box(world, Vec3::Ones(), Vec3(0.0, 0.5 + k, 0.0), Vec3::Zero(), restitution);
  return world;
}

// Contacts and nothing else: no collision passes, no pushes, no damping, no stable boxes.
DampedAsPrintedOptions contacts_alone(const DampedErrata& repaired) {
  DampedAsPrintedOptions options = undamped(repaired, false);
  options.collision_passes = 0;
  options.numbers.eps1 = 0.0;
  return options;
}

// RK1. By how much the top of a stack of five sinks in a second.
double sag(const DampedErrata& repaired) {
  const World world = stepped(stack_of(5, 0.0), DampedAsPrinted(contacts_alone(repaired)), kSecond);
  return 4.5 - world.states()[5].position_w.y();
}

// RK2, RK3. How fast a cube is that has lain on the ground for a number of steps.
double resting_speed(int steps, int loop_base, bool elastic) {
  DampedAsPrintedOptions options = contacts_alone(misprints());
  options.loop_base = loop_base;
  options.elastic_contacts = elastic;
  return BodyView(stepped(stack_of(1, 0.0), DampedAsPrinted(options), steps), 1)
      .velocity_w()
      .norm();
}

// RK4. Root mean square speed of a stack of five with restitution 0.9, after it has had as long to
// settle.
double unrest(Technique&& technique, double seconds) {
  World world = stack_of(5, 0.9);
  const int steps = static_cast<int>(std::ceil(seconds / kStep));
  for (int step = 0; step < steps; ++step) finished(technique.step(world, kStep));
  double sum = 0.0;
  for (int step = 0; step < steps; ++step) {
    finished(technique.step(world, kStep));
    for (int k = 1; k <= 5; ++k) sum += BodyView(world, k).velocity_w().squaredNorm();
  }
  return std::sqrt(sum / (5.0 * steps));
}

Damped shock_propagation() {
  DampedOptions options{.shock = ShockRule::velocity,
                        .stable_boxes = StableRule::off,
                        .damping = damping_parts_from("none")};
  options.noise.where = Randomness::off;
  return Damped(options);
}

// All contacts of a world collide at once, each with the speed of approach of the beginning.
World after_impact(World world) {
  std::vector<MovingBody> moving;
  load_moving_bodies(world, moving);
  ContactList contacts = contacts_within(world, 1e-9);
  if (ImpactSolver().resolve(contacts, moving, {.order = ImpactOrder::simultaneous}).status !=
      ImpactStatus::done)
    throw std::runtime_error("an impact without an answer");
  store_moving_bodies(moving, world);
  return world;
}

World after_step(const World& world, const DampedErrata& repaired) {
  return stepped(world, DampedAsPrinted(undamped(repaired, false)));
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
  return BodyView(after_step(world, repaired), far_one).velocity_w().norm();
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
  world.add(box_properties(Vec3::Ones(), 1.0, 0.0), Vec3(0.0, 9.0, 0.0), Quat::Identity(),
            Vec3::Zero(), Vec3::UnitY());
  DampedAsPrinted technique(undamped(repaired));
  double angle = 0.0;
  for (int step = 0; step < 30; ++step) {
    const Quat before = world.states()[0].orientation_wb;
    finished(technique.step(world, kStep));
    angle += angle_between(world.states()[0].orientation_wb, before);
  }
  return angle;
}

void add_step_errata(Result& result) {
  const DampedErrata mended = misprints();
  result.add("D1: heights in two orders, with C1 to C3 as printed", "m",
             difference_of_orders(mended.without("C1").without("C2").without("C3")));
  result.add("D1: heights in two orders, with C1 to C3 mended", "m", difference_of_orders(mended));
  compare(result, "D2: way of 1 s at 1 m/s in steps of 1/120 s, ", "m", "step not handed on",
          "step handed on", mended, flown);
  result.add("D3: first step of a slide, damped before the move", "m", slid(DampedNumbers{}.k1));
  result.add("D3: first step of a slide, damped after the move", "m", slid(1.0));
  compare(result, "D4: steps of 10 in which a cube in reach is not stable, ", "-", "old contacts",
          "fresh contacts", mended, steps_unstable);
  compare(result, "D5: height after a fall of 1 s, ", "m", "gravity twice", "gravity once", mended,
          fallen_to);
  compare(result, "D6: speed at rest after 1 s, ", "m/s", "gravity for all",
          "gravity for movable bodies", mended, speed_at_rest);
}

void add_pass_errata(double seconds, Result& result) {
  const DampedErrata mended = misprints();
  compare(result, "RK1: sag of a stack of five in 1 s, ", "m", "quotient of integers",
          "real quotient", mended, sag);
  result.add("RK2: creep of a cube at rest, passes 0 to 9", "m/s",
             resting_speed(kSecond, 0, false));
  result.add("RK2: creep of a cube at rest, passes 1 to 10", "m/s",
             resting_speed(kSecond, 1, false));
  result.add("RK3: speed of a cube at rest after a step, elastic contacts", "m/s",
             resting_speed(1, 1, true));
  result.add("RK3: speed of a cube at rest after a step, inelastic contacts", "m/s",
             resting_speed(1, 1, false));
  result.add("RK4: unrest of a stack of five, bodies pushed", "m/s",
             unrest(DampedAsPrinted(undamped(mended, false)), seconds));
  result.add("RK4: unrest of a stack of five, velocities by levels", "m/s",
             unrest(shock_propagation(), seconds));
  const World column = cube_on_cube();
  result.add("RC1: rebound from a cube on the ground, restitution at each pass", "m/s",
             BodyView(after_step(column, mended), 2).velocity_w().y());
  result.add("RC1: rebound from a cube on the ground, restitution once", "m/s",
             BodyView(after_impact(column), 2).velocity_w().y());
  compare(result, "RC2: speed of a cube out of reach, ", "m/s", "pairs of the pass",
          "pairs looked at again", mended.with("RC2"), hit_from_afar);
  const World row = squeezed_cube();
  result.add("RC3: speed of a cube hit from both sides, one pair after the other", "m/s",
             BodyView(after_step(row, mended), 1).velocity_w().norm());
  result.add("RC3: speed of a cube hit from both sides, both at once", "m/s",
             BodyView(after_impact(row), 1).velocity_w().norm());
  compare(result, "RC4: angle turned in 0.5 s at 1 rad/s, ", "rad", "positions put back",
          "poses put back", mended, turned);
}

Result measure_contact_errata(const Parameters& settings) {
  Result result;
  add_step_errata(result);
  add_collide_errata(result);
  add_pass_errata(settings.number("seconds"), result);
  Table table{"",
              {{"row", "-", "number of the erratum, in the order of the listings"},
               {"failure", "as the number's name says", "with the text taken literally"},
               {"mended", "as the number's name says", "under the other reading"}}};
  const std::vector<Quantity>& numbers = result.quantities;
  for (std::size_t k = 0; k + 1 < numbers.size(); k += 2)
    table.add(k / 2, std::abs(numbers[k].value), std::abs(numbers[k + 1].value));
  result.tables.push_back(table);
  return result;
}

const Registered errata_contacts_figure{
    {.name = "errata_contacts",
     .parameters = {number("seconds", 5.0, 0.1, 600.0, "s",
                           "for which the stack of RK4 is watched, after as long to settle")},
     .quick = {"seconds=1"},
     .experiment = measure_contact_errata}};

}  // namespace
}  // namespace tumble::chapters
