/// \file
/// \brief From the top down: a box that rests on one body becomes a load on it.
#include "tumble/geometric_stability/towers.hpp"

#include "tumble/base/index.hpp"
#include "tumble/geometric_stability/support_polygon.hpp"
#include "tumble/geometric_stability/tolerances.hpp"
#include "tumble/geometric_stability/upright.hpp"

namespace tumble {
namespace {

constexpr int kNone = -1;
constexpr int kSeveral = -2;

}  // namespace

void Towers::run(const World& world, std::span<const Contact> contacts,
                 std::span<const char> held) {
  count_neighbours(world, contacts, held);
  if (!gravity_is_down(world)) return;
  ready_.clear();
  for (int b = 0; b < world.count(); ++b)
    if (above_[idx(b)] == 0) ready_.push_back(b);
  // [S6.3.1:tower]
  // From the top down: a body whose load is known becomes, with its
  // load, a load on the body below.
  while (!ready_.empty()) {
    const int body = ready_.back();
    ready_.pop_back();
    if (no_tower_[idx(body)] != 0 || below_[idx(body)] < 0) continue;
    settle(world, contacts, body);
    if (states_[idx(body)] != TowerState::supported) continue;
    const int under = below_[idx(body)];
    supports_[idx(body)] = under;
    loads_[idx(under)].mass += loads_[idx(body)].mass;
    loads_[idx(under)].moment += loads_[idx(body)].moment;
    for (int c = contact_of_[idx(body)]; c >= 0; c = next_contact_[idx(c)])
      if (--above_[idx(under)] == 0) ready_.push_back(under);
  }
  // [S6.3.1:tower]
}

// Finds the body below each body, and counts the contacts above it.
void Towers::count_neighbours(const World& world, std::span<const Contact> contacts,
                              std::span<const char> held) {
  const std::size_t count = world.bodies().size();
  states_.assign(count, TowerState::none);
  supports_.assign(count, kNone);
  loads_.assign(count, {});
  below_.assign(count, kNone);
  above_.assign(count, 0);
  no_tower_.assign(count, 0);
  contact_of_.assign(count, -1);
  next_contact_.assign(contacts.size(), -1);
  for (std::size_t b = 0; b < count; ++b) {
    const BodyProperties& body = world.bodies()[b];
    if (!body.movable() || (!held.empty() && held[b] != 0)) no_tower_[b] = 1;
    if (body.movable()) loads_[b] = {body.mass, body.mass * world.states()[b].position_w};
  }
  const double vertical = exact_vertical(world);
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Contact& contact = contacts[c];
    if (contact.count == 0) continue;
    if (!is_vertical(contact.normal_w, vertical)) {
      no_tower_[idx(contact.first)] = 1;
      no_tower_[idx(contact.second)] = 1;
      continue;
    }
    const bool second_is_top = contact.normal_w.y() > 0.0;
    const int top = second_is_top ? contact.second : contact.first;
    const int bottom = second_is_top ? contact.first : contact.second;
    ++above_[idx(bottom)];
    int& below = below_[idx(top)];
    below = below == kNone || below == bottom ? bottom : kSeveral;
    next_contact_[c] = contact_of_[idx(top)];
    contact_of_[idx(top)] = static_cast<int>(c);
  }
}

// Compares the centre of a body and its load with the hull of its support.
void Towers::settle(const World& world, std::span<const Contact> contacts, int body) {
  points_.clear();
  for (int c = contact_of_[idx(body)]; c >= 0; c = next_contact_[idx(c)])
    for (int p = 0; p < contacts[idx(c)].count; ++p) {
      const Vec3& point_w = contacts[idx(c)].points[idx(p)].position_w;
      points_.emplace_back(point_w.x(), point_w.z());
    }
  convex_hull(points_, hull_);
  const Vec3 centre_w = loads_[idx(body)].centre_w();
  const double margin = tolerance::exact_balance * world.bodies()[idx(body)].size.minCoeff();
  states_[idx(body)] = hull_contains(hull_, Vec2(centre_w.x(), centre_w.z()), margin)
                           ? TowerState::supported
                           : TowerState::tips;
}

}  // namespace tumble
