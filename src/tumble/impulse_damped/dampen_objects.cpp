/// \file
/// \brief The listing DAMPENOBJECTS.
#include "tumble/impulse_damped/dampen_objects.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/suggestion.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/math/elementary.hpp"
#include "tumble/math/rotation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace tumble {
namespace {

bool is_small(double value, double epsilon) { return std::abs(value) < epsilon; }

// The axis of a box that is nearest to the vertical: its number and its height component.
int nearest_axis(const Mat3& axes_w) {
  int axis = 0;
  axes_w.row(1).cwiseAbs().maxCoeff(&axis);
  return axis;
}

// Lines 3 to 21 for one body in contact. Returns whether it is aligned.
bool dampen(const DampedThresholds& eps, const DampedFactors& k, const DampingParts& parts,
            BodyState& o) {
  Vec3& linear_momentum = o.linear_momentum_w;
  Vec3& angular_momentum = o.angular_momentum_w;
  // [DAMPENOBJECTS:3-5]
  // Friction slows things down: momenta shrink.
  const bool y_axis_aligned = check_y_axis_alignment(o.orientation_wb, eps.aligned);
  if (parts.scale) {
    linear_momentum *= k.momentum;
    angular_momentum *= k.spin;
  }
  // [DAMPENOBJECTS:3-5]
  // [DAMPENOBJECTS:6-10]
  // A box that lies nearly flat and hardly moves up or down is
  // coming to rest on this face: stop it, let it spin less, and
  // turn it a little more upright.
  if (y_axis_aligned) {
    if (parts.align && is_small(linear_momentum.y(), eps.settled)) {
      linear_momentum.y() = 0.0;
      angular_momentum *= k.settled_spin;
    }
    if (parts.tilt) o.orientation_wb = tilted_towards_y_axis(o.orientation_wb, eps.tilt);
  }
  // [DAMPENOBJECTS:6-10]
  if (!parts.small) return y_axis_aligned;
  // [DAMPENOBJECTS:11-19]
  // Component by component: what is slow gets slower, and what
  // is slower still stops.
  for (int i = 0; i < 3; ++i) {
    if (is_small(linear_momentum[i], eps.slow)) linear_momentum[i] *= k.slow;
    if (is_small(linear_momentum[i], eps.still)) linear_momentum[i] = 0.0;
    if (is_small(angular_momentum[i], eps.slow_spin)) angular_momentum[i] *= k.slow_spin;
    if (is_small(angular_momentum[i], eps.still_spin)) angular_momentum[i] = 0.0;
  }
  // [DAMPENOBJECTS:11-19]
  // [DAMPENOBJECTS:20-21]
  // A small hop is none.
  if (is_small(linear_momentum.y(), eps.rising) && linear_momentum.y() >= 0.0)
    linear_momentum.y() = 0.0;
  // [DAMPENOBJECTS:20-21]
  return y_axis_aligned;
}

}  // namespace

DampingParts damping_parts_from(std::string_view names) {
  static constexpr std::array<std::string_view, 7> kNames{"all",   "none", "scale", "small",
                                                          "align", "tilt", "freeze"};
  if (names == "all") return {};
  DampingParts parts{false, false, false, false, false};
  if (names == "none") return parts;
  const std::array<bool*, 5> flags{&parts.scale, &parts.small, &parts.align, &parts.tilt,
                                   &parts.freeze};
  while (true) {
    const std::size_t end = names.find('+');
    const std::string_view name = names.substr(0, end);
    const auto found = std::find(kNames.begin() + 2, kNames.end(), name);
    require::that(found != kNames.end(),
                  "damping = " + std::string(name) + ": " + expected_names(name, kNames));
    *flags[static_cast<std::size_t>(found - kNames.begin()) - 2] = true;
    if (end == std::string_view::npos) return parts;
    names.remove_prefix(end + 1);
  }
}

std::vector<Word<DampingParts>> damping_words() {
  std::vector<Word<DampingParts>> words;
  for (const std::string_view names :
       {"all", "none", "scale", "small", "align", "tilt", "freeze", "scale+small",
        "scale+small+align", "scale+small+align+tilt", "small+align+tilt+freeze",
        "scale+align+tilt+freeze", "scale+small+tilt+freeze", "scale+small+align+freeze"})
    words.push_back({names, damping_parts_from(names)});
  return words;
}

bool check_y_axis_alignment(const Quat& orientation_wb, double tolerance) {
  const Mat3 axes_w = orientation_wb.toRotationMatrix();
  return axes_w.row(1).cwiseAbs().maxCoeff() >= elementary::cos(tolerance);
}

Quat tilted_towards_y_axis(const Quat& orientation_wb, double most) {
  const Mat3 axes_w = orientation_wb.toRotationMatrix();
  const int nearest = nearest_axis(axes_w);
  const Vec3 axis_w = axes_w(1, nearest) < 0.0 ? Vec3(-axes_w.col(nearest)) : axes_w.col(nearest);
  const Vec3 across_w = axis_w.cross(Vec3::UnitY());  // sin of the tilt, along the axis of the turn
  const double sine = across_w.norm();
  if (!(sine > 0.0)) return orientation_wb;
  const double tilt = elementary::asin(std::min(1.0, sine));
  const Vec3 turn_w = std::min(tilt, most) / sine * across_w;
  return normalised(rotation_from_vector(turn_w) * orientation_wb);
}

DampingReport ObjectDamping::run(World& world, std::span<const char> touched,
                                 const DampedNumbers& numbers, const DampingParts& parts, double dt,
                                 RotationRule rotation) {
  const std::span<const BodyProperties> bodies = world.bodies();
  const std::span<BodyState> objects = world.states();
  require::that(touched.size() == objects.size(), "touched: one entry for each body is needed");
  const double gravity = world.gravity_w.norm();
  const DampedFactors k = factors_of(numbers, dt);
  const auto stays = [&](std::size_t o) {
    return !bodies[o].movable() || world.sleep_states()[o].asleep;
  };
  DampingReport report;
  // [DAMPENOBJECTS:1-2]
  // Only bodies that were held up or stopped by another body in this step.
  for (std::size_t o = 0; o < objects.size(); ++o) {
    if (touched[o] == 0 || stays(o)) continue;
    const DampedThresholds eps = thresholds_of(numbers, bodies[o], gravity, dt);
    const double before = kinetic_energy(bodies[o], objects[o]);
    report.aligned += dampen(eps, k, parts, objects[o]) ? 1 : 0;
    report.energy += kinetic_energy(bodies[o], objects[o]) - before;
  }
  // [DAMPENOBJECTS:1-2]

  // [DAMPENOBJECTS:22]
  // All bodies move, with the velocities that are left.
  old_.assign(objects.begin(), objects.end());
  for (std::size_t o = 0; o < objects.size(); ++o) {
    if (stays(o)) continue;
    advance_pose(bodies[o], objects[o], dt, rotation);
    ++report.moved;
  }
  // [DAMPENOBJECTS:22]

  // [DAMPENOBJECTS:23-28]
  // A body that has hardly moved or turned counts as one that has not moved.
  for (std::size_t o = 0; parts.freeze && o < objects.size(); ++o) {
    if (stays(o)) continue;
    const double delta_position = (objects[o].position_w - old_[o].position_w).norm();
    const double delta_rotation = angle_between(objects[o].orientation_wb, old_[o].orientation_wb);
    const DampedThresholds eps = thresholds_of(numbers, bodies[o], gravity, dt);
    const double still = touched[o] != 0 ? eps.frozen : eps.frozen_in_flight;
    if (is_small(delta_position, still) && is_small(delta_rotation, eps.frozen_angle)) {
      const double before = energy_of(bodies[o], objects[o], world.gravity_w).total();
      objects[o].position_w = old_[o].position_w;
      objects[o].orientation_wb = old_[o].orientation_wb;
      report.energy += energy_of(bodies[o], objects[o], world.gravity_w).total() - before;
      if (delta_position > 0.0 || delta_rotation > 0.0) ++report.frozen;
    }
  }
  // [DAMPENOBJECTS:23-28]
  // [DAMPENOBJECTS:29]
  return report;
  // [DAMPENOBJECTS:29]
}

}  // namespace tumble
