/// \file
/// \brief The largest load-proof set, by removing bodies that break a condition.
#include "tumble/geometric_stability/load_proof.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/geometric_stability/tolerances.hpp"
#include "tumble/geometric_stability/upright.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

void LoadProof::run(const World& world, std::span<const Contact> contacts,
                    std::vector<char>& stable) {
  vertical_ = exact_vertical(world);
  rule_.set_tolerances({vertical_, tolerance::exact_corner, tolerance::resting_speed});
  rule_.run(world, contacts, StableRule::hull, tolerance::resting_speed, known_);
  stable.assign(world.bodies().size(), gravity_is_down(world) ? 1 : 0);
  const double g = world.gravity_w.norm();
  for (std::size_t b = 0; b < stable.size(); ++b) {
    const BodyProperties& body = world.bodies()[b];
    if (!body.movable()) stable[b] = 1;
    const double slow = tolerance::resting_speed * std::sqrt(g * body.size.minCoeff());
    if (body.movable() && tipping_speed(body, world.states()[b]) > slow) stable[b] = 0;
  }
  const auto undecided = [&](int b) { return stable[idx(b)] != 0 && known_[idx(b)] == 0; };

  // [S6.3.1:load_proof]
  // All are members at first. A body that a body outside the set
  // pushes from below or from the side, or that has an unsupported
  // corner, is removed; then others may break a condition.
  for (bool lost = true; lost;) {
    lost = false;
    for (int b = 0; b < world.count(); ++b) {
      if (!undecided(b) || !touched_from_outside(contacts, stable, b)) continue;
      stable[idx(b)] = 0;
      lost = true;
    }
    if (lost) continue;
    collect(contacts, stable);
    for (int b = 0; b < world.count() && !lost; ++b) {
      if (!undecided(b) || carries_corners(world, b)) continue;
      stable[idx(b)] = 0;
      lost = true;
    }
  }
  // [S6.3.1:load_proof]
}

// The contacts among members.
void LoadProof::collect(std::span<const Contact> contacts, std::span<const char> members) {
  within_.clear();
  for (const Contact& contact : contacts)
    if (members[idx(contact.first)] != 0 && members[idx(contact.second)] != 0)
      within_.push_back(contact);
}

bool LoadProof::touched_from_outside(std::span<const Contact> contacts,
                                     std::span<const char> members, int body) const {
  return std::any_of(contacts.begin(), contacts.end(), [&](const Contact& contact) {
    if (contact.count == 0 || (contact.first != body && contact.second != body)) return false;
    const int other = contact.first == body ? contact.second : contact.first;
    if (members[idx(other)] != 0) return false;
    // The push on the body.
    const double up = contact.second == body ? contact.normal_w.y() : -contact.normal_w.y();
    return up > 0.0 || !is_vertical(contact.normal_w, vertical_);
  });
}

// Whether contacts among members balance a weight on any corner of a body's outline.
bool LoadProof::carries_corners(const World& world, int body) {
  const double height = world.states()[idx(body)].position_w.y();
  corners_from_above(box_of(world.bodies()[idx(body)], world.states()[idx(body)]), outline_);
  convex_hull(outline_, hull_);
  return std::all_of(hull_.begin(), hull_.end(), [&](const Vec2& corner) {
    const Load load{body, Vec3(corner.x(), height, corner.y()),
                    Vec3(0.0, -world.bodies()[idx(body)].mass, 0.0)};
    const BalanceTask task{
        .contacts = within_, .loads = {&load, 1}, .held = known_, .weight = false};
    return equilibrium_.solve(world, task).balanced;
  });
}

}  // namespace tumble
