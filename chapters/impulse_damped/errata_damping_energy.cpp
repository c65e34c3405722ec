/// \file
/// \brief Components of angular momentum set to 0, and the energy that it adds (thesis 5.3, A.2; DM9).
#include "impulse_damped/errata_damping_experiments.hpp"
#include "impulse_damped/errata_damping_setup.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace tumble::chapters {
namespace {

using namespace errata_setup;

constexpr double kSmaller = 0.98;  // [-] largest of the smaller component, the other one being 1

// What is left of the kinetic energy of a box, turned about z by an angle, that spins with
// L = (1, y, 0): set to 0 is the component along y, or all of L if all of it is small.
double energy_left(const BodyProperties& box, double angle, double y, bool whole) {
  World world;
  world.add(box, make_state(box, Vec3::Zero(),
                            Quat(std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle))));
  BodyState& state = world.states()[0];
  state.angular_momentum_w = Vec3(1.0, y, 0.0);
  const double before = kinetic_energy(box, state);
  PrintedNumbers numbers;
  numbers.eps.still_spin = 0.99;
  // The length of L = (1, ...) is not below 0.99, so that the test of the whole ends nothing.
  if (whole && !(state.angular_momentum_w.norm() < numbers.eps.still_spin))
    numbers.eps.still_spin = 0.0;
  dampen(world, true, numbers, DampedErrata::all());
  return kinetic_energy(box, state) / before;
}

// The same for the y that makes it largest: the one that minimises the energy before, or the closest
// to it at which y is the smaller component.
double most_energy_left(const BodyProperties& box, double angle, bool whole) {
  const Mat3 inverse =
      inverse_inertia_w(box, Quat(std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle)));
  const double y = std::clamp(-inverse(0, 1) / inverse(1, 1), -kSmaller, kSmaller);
  return energy_left(box, angle, y, whole);
}

}  // namespace

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
    table.rows.push_back({static_cast<double>(degrees), most_energy_left(beam, angle, false),
                          most_energy_left(brick, angle, false),
                          most_energy_left(beam, angle, true)});
  }
  result.tables.push_back(table);
  const std::string ratio = "DM9: kinetic energy after a step over that before, ";
  result.quantities.push_back(
      {ratio + "component ended, 4x1x1 box", "-", most_energy_left(beam, quarter, false)});
  result.quantities.push_back(
      {ratio + "whole spin, 4x1x1 box", "-", most_energy_left(beam, quarter, true)});
  result.quantities.push_back({ratio + "component ended, 4x1x1 box with spin (1, -0.5, 0)", "-",
                               energy_left(beam, quarter, -0.5, false)});
  result.quantities.push_back(
      {ratio + "component ended, 2x1x1 box", "-", most_energy_left(brick, quarter, false)});
}

}  // namespace tumble::chapters
