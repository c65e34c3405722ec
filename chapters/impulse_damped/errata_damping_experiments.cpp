/// \file
/// \brief The errata of DAMPENOBJECTS that show in one step (thesis 5.3, A.2; DM1 to DM5, DM8, DM9, DM13, DM15,
///        DM16).
#include "tumble/impulse_damped/tolerances.hpp"

#include "impulse_damped/errata_setup.hpp"

namespace tumble::chapters {
namespace {

// The momentum that a step leaves of a cube in contact.
Vec3 momentum_after(const Vec3& momentum_w, const PrintedNumbers& numbers,
                    const DampedErrata& mended) {
  World world = world_with_cube(momentum_w);
  dampen(world, true, numbers, mended);
  return world.states()[0].linear_momentum_w;
}

// DM1, DM2.
void add_thresholds(Result& result) {
  const DampedThresholds usual = usual_thresholds();
  PrintedNumbers numbers;
  numbers.eps.slow = usual.slow;
  numbers.eps.still = usual.still;
  numbers.k.slow = DampedNumbers{}.k5;
  const auto left_of = [&](double momentum) {
    return [&numbers, momentum](const DampedErrata& mended) {
      return momentum_after(Vec3(momentum, 0.0, 0.0), numbers, mended).x() / momentum;
    };
  };
  // A momentum just below ε5: it is slow, and what k5 leaves of it is still above ε6.
  compare(result, "DM1: share of a slow momentum left, ", "-", "one threshold twice",
          "two thresholds", DampedErrata::all(), left_of(0.9 * usual.slow));
  // A momentum that is small enough to be ended, along x.
  compare(result, "DM2: share of a small momentum along x left, ", "-", "indices 1 to 3",
          "indices 0 to 2", DampedErrata::all(), left_of(0.5 * usual.still));
}

// DM18. What a step leaves of a small momentum of a leaning cube. For level boxes only, no threshold is its own.
double leaning_momentum_left(bool for_all) {
  PrintedNumbers numbers;
  numbers.eps.slow = for_all ? usual_thresholds().slow : 0.0;
  numbers.eps.still = for_all ? usual_thresholds().still : 0.0;
  const double momentum = 0.5 * usual_thresholds().still;
  World world = world_with_cube(Vec3(momentum, 0.0, 0.0));
  world.states()[0].orientation_wb = turned_about_z(std::numbers::pi / 6.0);
  dampen(world, true, numbers, DampedErrata::all());
  return world.states()[0].linear_momentum_w.x() / momentum;
}

// DM3. What is left of a spin about the vertical, less that of its mirror image.
double one_sided_spin(const DampedErrata& mended) {
  PrintedNumbers numbers;
  numbers.eps.rising = usual_thresholds().rising;
  const double small = 0.5 * numbers.eps.rising;
  const auto left = [&](double spin) {
    World world = world_with_cube(Vec3::Zero(), spin * Vec3::UnitY());
    dampen(world, true, numbers, mended);
    return world.states()[0].angular_momentum_w.y() / spin;
  };
  return left(-small) - left(small);
}

// DM4. An upright cube that falls at 5 m/s touches something.
double fall_left(const DampedErrata& mended) {
  PrintedNumbers numbers;
  numbers.eps.settled = usual_thresholds().settled;
  return std::abs(momentum_after(Vec3(0.0, -5.0, 0.0), numbers, mended).y()) / 5.0;
}

// DM5. A cube that has had a contact is thrown up at 5 m/s. How high does it get?
double height_of_throw(double k1, bool remembered) {
  PrintedNumbers numbers;
  numbers.k.momentum = k1;
  World world = world_with_cube(Vec3(0.0, 5.0, 0.0));
  double highest = 0.0;
  for (int step = 0; step < 60; ++step) {
    add_gravity(world);
    dampen(world, remembered, numbers);
    highest = std::max(highest, world.states()[0].position_w.y());
  }
  return highest;
}

// DM8. What a second in contact leaves, in steps of 1/120 s, with the factors of a step.
double left_after_a_second(double k1, double dt) {
  DampedNumbers usual{.k1 = k1};
  PrintedNumbers numbers{.k = factors_of(usual, dt)};
  World world = world_with_cube(Vec3::UnitX());
  constexpr int steps = 120;
  for (int step = 0; step < steps; ++step)
    dampen(world, true, numbers, DampedErrata::all(), 1.0 / steps);
  return world.states()[0].linear_momentum_w.x();
}

// The largest value that a test accepts, if it accepts all below.
template <class Test>
double largest_accepted(double high, const Test& accepts) {
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
    World world = world_with_cube(Vec3::Zero(), spin * Vec3::UnitY());
    return dampen(world, true, numbers, mended).frozen == 1;
  };
  return largest_accepted(1.0, undone) / numbers.eps.frozen_angle;
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
    world.add(small_cube, Vec3::Zero(), Quat::Identity(), Vec3(speed, 0.0, 0.0));
    dampen(world, true, numbers);
    return world.states()[0].linear_momentum_w.x() == 0.0;
  };
  return largest_accepted(1e3, ended) / std::sqrt(kGravity * length);
}

// DM16. The largest tilt of a cube that counts as aligned: line 9 then ends its spin.
double aligned_tilt(const DampedErrata& mended) {
  PrintedNumbers numbers;
  numbers.eps.aligned = usual_thresholds().aligned;
  numbers.eps.settled = 1.0;
  numbers.k.settled_spin = 0.0;
  const auto aligned = [&](double tilt) {
    World world = world_with_cube(Vec3::Zero(), Vec3::UnitY());
    world.states()[0].orientation_wb = turned_about_z(tilt);
    dampen(world, true, numbers, mended);
    return world.states()[0].angular_momentum_w.y() == 0.0;
  };
  return largest_accepted(0.5, aligned);
}

// DM9. Components of angular momentum that are set to 0.

constexpr double kSmaller = 0.98;  // [-] largest of the smaller component, the other one being 1

// What is left of the kinetic energy of a box, turned about z by an angle, that spins with
// L = (1, y, 0): set to 0 is the component along y, or all of L if all of it is small.
double energy_left(const BodyProperties& box, double angle, double y, bool whole) {
  World world;
  world.add(box, Vec3::Zero(), turned_about_z(angle));
  BodyState& state = world.states()[0];
  state.angular_momentum_w = Vec3(1.0, y, 0.0);
  const double before = kinetic_energy(box, state);
  PrintedNumbers numbers;
  numbers.eps.still_spin = 0.99;
  // The length of L = (1, ...) is not below 0.99, so that the test of the whole ends nothing.
  if (whole && !(state.angular_momentum_w.norm() < numbers.eps.still_spin))
    numbers.eps.still_spin = 0.0;
  dampen(world, true, numbers);
  return kinetic_energy(box, state) / before;
}

// The same for the y that makes it largest: the one that minimises the energy before, or the closest
// to it at which y is the smaller component.
double most_energy_left(const BodyProperties& box, double angle, bool whole) {
  const Mat3 inverse = inverse_inertia_w(box, turned_about_z(angle));
  const double y = std::clamp(-inverse(0, 1) / inverse(1, 1), -kSmaller, kSmaller);
  return energy_left(box, angle, y, whole);
}

void add_energy_erratum(Result& result) {
  // Moments 2, 17, 17 kg m²; and 1, 2.5, 2.5 times 2/12 kg m².
  const BodyProperties beam = box_properties(Vec3(4.0, 1.0, 1.0), 12.0);
  const BodyProperties brick = box_properties(Vec3(2.0, 1.0, 1.0), 1.0);
  constexpr double quarter = 0.78539816339744831;  // [rad] 45 degrees

  Table table{"energy",
              {{"angle_deg", "deg", "how far the box is turned about a horizontal axis"},
               {"beam_printed", "-", "largest ratio of energies, 4×1×1, components ended"},
               {"brick_printed", "-", "the same, 2×1×1"},
               {"beam_mended", "-", "4×1×1, whole spin"}}};
  for (int degrees = 0; degrees <= 90; ++degrees) {
    const double angle = degrees * quarter / 45.0;
    table.add(degrees, most_energy_left(beam, angle, false), most_energy_left(brick, angle, false),
              most_energy_left(beam, angle, true));
  }
  result.tables.push_back(table);
  const std::string ratio = "DM9: kinetic energy after a step over that before, ";
  result.add(ratio + "component ended, 4x1x1 box", "-", most_energy_left(beam, quarter, false));
  result.add(ratio + "whole spin, 4x1x1 box", "-", most_energy_left(beam, quarter, true));
  result.add(ratio + "component ended, 4x1x1 box with spin (1, -0.5, 0)", "-",
             energy_left(beam, quarter, -0.5, false));
  result.add(ratio + "component ended, 2x1x1 box", "-", most_energy_left(brick, quarter, false));
}

void add_momentum_errata(double k1, Result& result) {
  const DampedErrata all = DampedErrata::all();
  add_thresholds(result);
  compare(result, "DM3: share left of a spin, less that of its mirror image, ", "-",
          "one-sided test", "test of upward momentum", all, one_sided_spin);
  compare(result, "DM4: share left of the speed of a fall, ", "-", "x < eps", "|x| < eps", all,
          fall_left);
  result.add("DM5: height of a throw at 5 m/s, contact remembered for ever", "m",
             height_of_throw(k1, true));
  result.add("DM5: height of a throw at 5 m/s, contact forgotten", "m", height_of_throw(k1, false));
  const std::string left = "DM8: share of a momentum left after 1 s at 120 Hz, ";
  result.add(left + "factor of a step", "-", left_after_a_second(k1, kStep));
  result.add(left + "factor of a time", "-", left_after_a_second(k1, 0.5 * kStep));
  compare(result, "DM13: largest turn undone over its threshold, ", "-", "four numbers subtracted",
          "angle", all, undone_turn);
  const std::string slide = "DM15: fastest slide ended over sqrt(gL), small cube, ";
  result.add(slide + "thresholds of a large one", "-", ended_slide(false));
  result.add(slide + "its own thresholds", "-", ended_slide(true));
  compare(result, "DM16: largest tilt that counts as aligned, ", "rad", "no tolerance", "with one",
          all, aligned_tilt);
  const std::string leaning =
      "DM18: share of a small momentum left of a leaning cube, lines 11 to 21 for ";
  result.add(leaning + "level boxes only", "-", leaning_momentum_left(false));
  result.add(leaning + "all", "-", leaning_momentum_left(true));
}

// A misprint is put back into a listing in which all others are mended; what the author meant is compared
// with a cure of a few lines here.
Result measure_damping_errata(const Parameters& settings) {
  Result result;
  add_momentum_errata(settings.number("k1"), result);
  add_motion_errata(settings.number("k1"), settings.number("eps10"), result);
  add_energy_erratum(result);
  add_repair_errata(settings.count("cap"), settings.number("duration"), result);
  return result;
}

const Registered errata_damping_figure{
    {.name = "errata_damping",
     .parameters = {number("k1", tolerance::damped_momentum_factor, 0.0, 1.0, "-",
                           "what a step in contact leaves of momentum"),
                    number("eps10", 5e-3, 1e-9, 1.0, "m", "a move in a step that is undone"),
                    whole("cap", 100000, 100, 10000000,
                          "pushes after which an endless loop is left"),
                    number("duration", 10.0, 0.1, 600.0, "s", "of the stack's rest")},
     .quick = {"cap=1000", "duration=1"},
     .experiment = measure_damping_errata}};

}  // namespace
}  // namespace tumble::chapters
