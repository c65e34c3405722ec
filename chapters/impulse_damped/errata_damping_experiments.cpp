/// \file
/// \brief The errata of DAMPENOBJECTS that show in one step (thesis 5.3, A.2; DM1 to DM5, DM8, DM13,
///        DM15, DM16).
#include "impulse_damped/errata_damping_experiments.hpp"

#include "driver/common_numbers.hpp"
#include "impulse_damped/errata_damping_setup.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace tumble::chapters {
namespace {

using namespace errata_setup;

// The momentum that a step leaves of a cube in contact.
Vec3 momentum_after(const Vec3& momentum_w, const PrintedNumbers& numbers,
                    const DampedErrata& mended) {
  World world = world_with_cube(Vec3::Zero(), momentum_w);
  dampen(world, true, numbers, mended);
  return world.states()[0].linear_momentum_w;
}

// DM1. A momentum just below ε5: it is slow, and what k5 leaves of it is still above ε6.
void add_same_threshold(Result& result) {
  const DampedThresholds usual = usual_thresholds();
  PrintedNumbers numbers;
  numbers.eps.slow = usual.slow;
  numbers.eps.still = usual.still;
  numbers.k.slow = DampedNumbers{}.k5;
  const Vec3 slow_w(0.9 * usual.slow, 0.0, 0.0);
  const auto left = [&](const DampedErrata& mended) {
    return momentum_after(slow_w, numbers, mended).x() / slow_w.x();
  };
  add(result, "DM1: share of a slow momentum left, one threshold twice", "-", left(all_but("DM1")));
  add(result, "DM1: share of a slow momentum left, two thresholds", "-", left(DampedErrata::all()));

  // DM2. A momentum that is small enough to be ended, along x.
  const Vec3 small_w(0.5 * usual.still, 0.0, 0.0);
  const auto small_left = [&](const DampedErrata& mended) {
    return momentum_after(small_w, numbers, mended).x() / small_w.x();
  };
  add(result, "DM2: share of a small momentum along x left, indices 1 to 3", "-",
      small_left(all_but("DM2")));
  add(result, "DM2: share of a small momentum along x left, indices 0 to 2", "-",
      small_left(DampedErrata::all()));
}

// DM3. A spin about the vertical and its mirror image.
void add_one_sided_spin(Result& result) {
  PrintedNumbers numbers;
  numbers.eps.rising = usual_thresholds().rising;
  const double small = 0.5 * numbers.eps.rising;
  const auto left = [&](double spin, const DampedErrata& mended) {
    World world = world_with_cube(Vec3::Zero(), Vec3::Zero(), spin * Vec3::UnitY());
    dampen(world, true, numbers, mended);
    return world.states()[0].angular_momentum_w.y() / spin;
  };
  const auto difference = [&](const DampedErrata& mended) {
    return left(-small, mended) - left(small, mended);
  };
  add(result, "DM3: share left of a spin, less that of its mirror image, one-sided test", "-",
      difference(all_but("DM3")));
  add(result, "DM3: share left of a spin, less that of its mirror image, test of upward momentum",
      "-", difference(DampedErrata::all()));
}

// DM4. An upright cube that falls at 5 m/s touches something.
void add_signed_comparison(Result& result) {
  PrintedNumbers numbers;
  numbers.eps.settled = usual_thresholds().settled;
  const auto left = [&](const DampedErrata& mended) {
    return std::abs(momentum_after(Vec3(0.0, -5.0, 0.0), numbers, mended).y()) / 5.0;
  };
  add(result, "DM4: share left of the speed of a fall, x < eps", "-", left(all_but("DM4")));
  add(result, "DM4: share left of the speed of a fall, |x| < eps", "-", left(DampedErrata::all()));
}

// DM5. A cube that has had a contact is thrown up at 5 m/s. How high does it get?
double height_of_throw(double k1, bool remembered) {
  PrintedNumbers numbers;
  numbers.k.momentum = k1;
  World world = world_with_cube(Vec3::Zero(), Vec3(0.0, 5.0, 0.0));
  double highest = 0.0;
  for (int step = 0; step < 60; ++step) {
    add_gravity(world);
    dampen(world, remembered, numbers, DampedErrata::all());
    highest = std::max(highest, world.states()[0].position_w.y());
  }
  return highest;
}

// DM8. What a second in contact leaves, in steps of 1/120 s.
double left_after_a_second(const DampedFactors& k) {
  PrintedNumbers numbers;
  numbers.k = k;
  World world = world_with_cube(Vec3::Zero(), Vec3::UnitX());
  constexpr int steps = 120;
  for (int step = 0; step < steps; ++step)
    dampen(world, true, numbers, DampedErrata::all(), 1.0 / steps);
  return world.states()[0].linear_momentum_w.x();
}

void add_factors_of_a_step(double k1, Result& result) {
  DampedNumbers numbers;
  numbers.k1 = k1;
  const double per_step = left_after_a_second(factors_of(numbers, kStep));
  const double per_time = left_after_a_second(factors_of(numbers, 0.5 * kStep));
  add(result, "DM8: share of a momentum left after 1 s at 120 Hz, factor of a step", "-", per_step);
  add(result, "DM8: share of a momentum left after 1 s at 120 Hz, factor of a time", "-", per_time);
}

// The largest value that a test accepts, if it accepts all below.
template <class Test>
double largest(double high, const Test& accepts) {
  double low = 0.0;
  constexpr int halvings = 100;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (low + high);
    (accepts(middle) ? low : high) = middle;
  }
  return low;
}

// DM13. The largest turn in a step that is undone, over the threshold.
double undone_turn(const DampedErrata& mended) {
  PrintedNumbers numbers;
  numbers.eps.frozen = 1.0;
  numbers.eps.frozen_angle = usual_thresholds().frozen_angle;
  const auto undone = [&](double turn) {
    const double spin = turn / kStep * unit_cube().inertia_b.y();
    World world = world_with_cube(Vec3::Zero(), Vec3::Zero(), spin * Vec3::UnitY());
    return dampen(world, true, numbers, mended).frozen == 1;
  };
  return largest(1.0, undone) / numbers.eps.frozen_angle;
}

// DM15. The fastest slide that is ended at once, over sqrt(g L), of a cube a tenth as long and with
// a thousandth of the mass.
double ended_slide(bool own_thresholds) {
  constexpr double length = 0.1;  // [m]
  const BodyProperties small_cube = box_properties(Vec3::Constant(length), 1e-3);
  PrintedNumbers numbers;
  numbers.eps.still = own_thresholds
                          ? thresholds_of(DampedNumbers{}, small_cube, kGravity, kStep).still
                          : usual_thresholds().still;
  const auto ended = [&](double speed) {
    World world;
    world.add(small_cube,
              make_state(small_cube, Vec3::Zero(), Quat::Identity(), Vec3(speed, 0.0, 0.0)));
    dampen(world, true, numbers, DampedErrata::all());
    return world.states()[0].linear_momentum_w.x() == 0.0;
  };
  return largest(1e3, ended) / std::sqrt(kGravity * length);
}

// DM16. The largest tilt of a cube that counts as aligned: line 9 then ends its spin.
double aligned_tilt(const DampedErrata& mended) {
  PrintedNumbers numbers;
  numbers.eps.aligned = usual_thresholds().aligned;
  numbers.eps.settled = 1.0;
  numbers.k.settled_spin = 0.0;
  const auto aligned = [&](double tilt) {
    World world = world_with_cube(Vec3::Zero(), Vec3::Zero(), Vec3::UnitY());
    world.states()[0].orientation_wb = Quat(std::cos(0.5 * tilt), 0.0, 0.0, std::sin(0.5 * tilt));
    dampen(world, true, numbers, mended);
    return world.states()[0].angular_momentum_w.y() == 0.0;
  };
  return largest(0.5, aligned);
}

}  // namespace

void add_momentum_errata(double k1, Result& result) {
  add_same_threshold(result);
  add_one_sided_spin(result);
  add_signed_comparison(result);
  add(result, "DM5: height of a throw at 5 m/s, contact remembered for ever", "m",
      height_of_throw(k1, true));
  add(result, "DM5: height of a throw at 5 m/s, contact forgotten", "m",
      height_of_throw(k1, false));
  add_factors_of_a_step(k1, result);
  add(result, "DM13: largest turn undone over its threshold, four numbers subtracted", "-",
      undone_turn(all_but("DM13")));
  add(result, "DM13: largest turn undone over its threshold, angle", "-",
      undone_turn(DampedErrata::all()));
  add(result, "DM15: fastest slide ended over sqrt(gL), small cube, thresholds of a large one", "-",
      ended_slide(false));
  add(result, "DM15: fastest slide ended over sqrt(gL), small cube, its own thresholds", "-",
      ended_slide(true));
  add(result, "DM16: largest tilt that counts as aligned, no tolerance", "rad",
      aligned_tilt(all_but("DM16")));
  add(result, "DM16: largest tilt that counts as aligned, with one", "rad",
      aligned_tilt(DampedErrata::all()));
}

Result measure_damping_errata(const Parameters& settings) {
  Result result;
  add_momentum_errata(settings.number("k1"), result);
  add_motion_errata(settings.number("k1"), settings.number("eps10"), result);
  add_energy_erratum(result);
  add_repair_errata(settings.count("cap"), result);
  add_stack_erratum(settings.number("duration"), result);
  return result;
}

}  // namespace tumble::chapters
