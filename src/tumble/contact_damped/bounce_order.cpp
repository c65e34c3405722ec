/// \file
/// \brief Bounces that follow each other within a step.
#include "tumble/contact_damped/bounce_order.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/contact_patches/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

// When the first point of a patch arrives [s], with the mean of its speeds at the start of the step and on arrival.
double arrival(const Island& island, const ContactPatch& patch) {
  const Six start =
      motion_of(patch, island.start[idx(patch.first)], island.start[idx(patch.second)]);
  double first = std::numeric_limits<double>::infinity();
  for (const ContactPatchPoint& p : patch.used()) {
    const double speed = -0.5 * (velocity_at(p.along, p.across, start).z() + p.approach);
    const double way = std::max(0.0, p.gap - tolerance::contact_slop * patch.size);
    if (speed > 0.0) first = std::min(first, way / speed);
  }
  return first;
}

// Whether a patch is open after a time [s] in which its bodies move as at the start.
bool is_open_after(const Island& island, const ContactPatch& patch, double time) {
  const Six start =
      motion_of(patch, island.start[idx(patch.first)], island.start[idx(patch.second)]);
  const std::span<const ContactPatchPoint> points = patch.used();
  return std::all_of(points.begin(), points.end(), [&](const ContactPatchPoint& p) {
    return is_apart(p.gap + time * velocity_at(p.along, p.across, start).z(),
                    tolerance::contact_slop * patch.size);
  });
}

}  // namespace

double slowest_bounce(double gravity, double size, double dt) {
  return gravity > 0.0 ? tolerance::sticky_speed * std::sqrt(gravity * size)
                       : tolerance::sticky_speed_weightless * size / dt;
}

bool was_hit(const ContactPatch& patch, double slowest) {
  return std::any_of(patch.used().begin(), patch.used().end(), [&](const ContactPatchPoint& p) {
    return p.impulse > 0.0 && p.approach < -slowest;
  });
}

double time_to_first_bounce(const Island& island, double step) {
  const double g = island.world.gravity_w.norm();
  double first = island.dt;
  const auto bounces = [&](const ContactPatch& patch) {
    return patch.restitution > 0.0 && was_hit(patch, slowest_bounce(g, patch.size, step));
  };
  for (const int contact : island.patch_indices) {
    const ContactPatch& patch = island.all_patches[idx(contact)];
    if (!bounces(patch)) continue;
    const double end = arrival(island, patch) + kSimultaneous * step;
    if (!(end < first)) continue;
    const bool goes_on =
        std::any_of(island.patch_indices.begin(), island.patch_indices.end(), [&](int other) {
          return other != contact && is_open_after(island, island.all_patches[idx(other)], end);
        });
    if (goes_on) first = end;
  }
  return first;
}

void release_open_patches(const Island& island, double time) {
  for (const int contact : island.patch_indices) {
    ContactPatch& patch = island.all_patches[idx(contact)];
    if (!is_open_after(island, patch, time)) continue;
    for (ContactPatchPoint& p : patch.used()) p.target = -std::numeric_limits<double>::infinity();
    patch.targets_planar = false;
  }
}

}  // namespace tumble
