/// \file
/// \brief The order of a step as printed and mended (thesis 5.2, A.2; errata D1 to D6).
#include "driver/common_numbers.hpp"
#include "impulse_damped/errata_contacts.hpp"

#include <algorithm>
#include <cmath>

namespace tumble::chapters {
namespace {

constexpr int kSecond = 60;  // [-] steps

// D1. By how much the heights of a resting cube differ at most in a second, between the order of
// the listing and that of 5.2.
double difference_of_orders(const DampedErrata& repaired) {
  World listed = ground_world();
  const int cube = add_box(listed, Vec3::Ones(), Vec3(0.0, 0.5, 0.0));
  World told = listed;
  DampedAsPrintedOptions options = undamped(repaired.without("D1"));
  options.stable_boxes = false;
  options.numbers.eps1 = 0.0;  // no push hides it
  DampedAsPrinted listing(options);
  options.repaired = repaired.with("D1");
  DampedAsPrinted prose(options);
  double most = 0.0;
  for (int step = 0; step < kSecond; ++step) {
    listing.step(listed, kStep);
    prose.step(told, kStep);
    const auto k = static_cast<std::size_t>(cube);
    most = std::max(most,
                    std::abs(listed.states()[k].position_w.y() - told.states()[k].position_w.y()));
  }
  return most;
}

// D2. How far a cube flies in a second at 1 m/s, in steps half as long as usual.
double flown(const DampedErrata& repaired) {
  World world;
  world.gravity_w = Vec3::Zero();
  add_box(world, Vec3::Ones(), Vec3::Zero(), Vec3::UnitX());
  DampedAsPrinted technique(undamped(repaired));
  run_steps(technique, world, 0.5 * kStep, 2 * kSecond);
  return world.states()[0].position_w.x();
}

// D3. How far a cube slides in the first step at 1 m/s, if a step in contact leaves k of its
// velocity.
double slid(double k) {
  World world = ground_world();
  const int cube = add_box(world, Vec3::Ones(), Vec3(0.0, 0.5, 0.0), Vec3::UnitX());
  DampedAsPrintedOptions options = undamped(misprints());
  options.numbers.k1 = k;
  DampedAsPrinted technique(options);
  technique.step(world, kStep);
  return world.states()[static_cast<std::size_t>(cube)].position_w.x();
}

// D4. After how many of the first ten steps a cube that lies half a push above the ground is not
// found to be stable.
double steps_unstable(const DampedErrata& repaired) {
  World world = ground_world();
  const int cube = add_box(world, Vec3::Ones(), Vec3(0.0, 0.5005, 0.0));
  DampedAsPrinted technique(undamped(repaired));
  int unstable = 0;
  for (int step = 0; step < 10; ++step) {
    technique.step(world, kStep);
    if (!technique.geometrically_stable(world.ids()[static_cast<std::size_t>(cube)])) ++unstable;
  }
  return unstable;
}

// D5. Where a cube is after falling for a second from 10 m.
double fallen_to(const DampedErrata& repaired) {
  World world;
  add_box(world, Vec3::Ones(), Vec3(0.0, 10.0, 0.0));
  DampedAsPrinted technique(undamped(repaired));
  run_steps(technique, world, kStep, kSecond);
  return world.states()[0].position_w.y();
}

// D6. How fast a cube is that has lain on the ground for a second.
double resting_speed(const DampedErrata& repaired) {
  World world = ground_world();
  const int cube = add_box(world, Vec3::Ones(), Vec3(0.0, 0.5, 0.0));
  DampedAsPrintedOptions options = undamped(repaired);
  options.stable_boxes = false;
  DampedAsPrinted technique(options);
  run_steps(technique, world, kStep, kSecond);
  return velocity_of(world, cube).norm();
}

}  // namespace

void add_step_errata(std::vector<ErratumPair>& pairs) {
  const DampedErrata mended = misprints();
  pairs.push_back({"D1: heights in two orders, with C1 to C3 as printed",
                   "D1: heights in two orders, with C1 to C3 mended", "m",
                   difference_of_orders(mended.without("C1").without("C2").without("C3")),
                   difference_of_orders(mended)});
  pairs.push_back({"D2: way of 1 s at 1 m/s in steps of 1/120 s, step not handed on",
                   "D2: way of 1 s at 1 m/s in steps of 1/120 s, step handed on", "m",
                   flown(mended.without("D2")), flown(mended)});
  pairs.push_back({"D3: first step of a slide, damped before the move",
                   "D3: first step of a slide, damped after the move", "m",
                   slid(DampedNumbers{}.k1), slid(1.0)});
  pairs.push_back({"D4: steps of 10 in which a cube in reach is not stable, old contacts",
                   "D4: steps of 10 in which a cube in reach is not stable, fresh contacts", "-",
                   steps_unstable(mended.without("D4")), steps_unstable(mended)});
  pairs.push_back({"D5: height after a fall of 1 s, gravity twice",
                   "D5: height after a fall of 1 s, gravity once", "m",
                   fallen_to(mended.without("D5")), fallen_to(mended)});
  pairs.push_back({"D6: speed at rest after 1 s, gravity for all",
                   "D6: speed at rest after 1 s, gravity for movable bodies", "m/s",
                   resting_speed(mended.without("D6")), resting_speed(mended)});
}

}  // namespace tumble::chapters
