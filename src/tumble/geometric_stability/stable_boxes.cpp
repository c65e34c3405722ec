/// \file
/// \brief From the thesis's rule to static equilibrium, cheapest first, with a memory.
#include "tumble/geometric_stability/stable_boxes.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/geometric_stability/tolerances.hpp"
#include "tumble/geometric_stability/upright.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace tumble {
namespace {

// Motion of a body, as far as equilibrium is concerned.
enum Motion : char {
  kStill = 0,  // none
  kSlides,     // along the ground
  kSpins,      // about the vertical
  kUnsettled   // rises, sinks or tips, or has a gap to close
};

constexpr char hold(Hold how) { return static_cast<char>(how); }

}  // namespace

std::span<const char> StableBoxes::find(const World& world, std::span<const MovingBody> bodies,
                                        std::span<const Contact> contacts) {
  if (bodies.size() != world.bodies().size())
    refuse("bodies: " + std::to_string(bodies.size()) + " entries; " +
           std::to_string(world.bodies().size()) + " are needed");
  for (const Contact& contact : contacts)
    require_bodies({contact.first, contact.second}, world.count());
  find_motion(world, bodies, contacts);
  report_ = {};
  report_.remembered = unchanged(world, contacts);
  if (!report_.remembered) {
    search(world, contacts);
    basis_.gravity_w = world.gravity_w;
    basis_.ids.assign(world.ids().begin(), world.ids().end());
    basis_.inverse_masses.clear();
    for (const BodyProperties& body : world.bodies())
      basis_.inverse_masses.push_back(body.inverse_mass);
    basis_.motion = motion_;
    basis_.states.assign(world.states().begin(), world.states().end());
    basis_.contacts.assign(contacts.begin(), contacts.end());
    known_ = true;
  }
  for (std::size_t b = 0; b < held_.size(); ++b)
    if (held_[b] != hold(Hold::free) && world.bodies()[b].movable()) ++report_.stable;
  return held_;
}

void StableBoxes::find_motion(const World& world, std::span<const MovingBody> bodies,
                              std::span<const Contact> contacts) {
  motion_.clear();
  const double g = world.gravity_w.norm();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Vec3& v = bodies[b].velocity_w;
    const Vec3& omega = bodies[b].angular_velocity_w;
    const double reach = 0.5 * world.bodies()[b].size.norm();
    const double unit = std::sqrt(g * world.bodies()[b].size.minCoeff());
    const double slow = tolerance::resting_speed * unit;
    char& motion = motion_.emplace_back(kUnsettled);  // stays so for NaN
    if (std::abs(v.y()) + reach * Vec2(omega.x(), omega.z()).norm() <= slow) motion = kSpins;
    if (std::abs(v.y()) + reach * omega.norm() <= slow) motion = kSlides;
    if (v.norm() + reach * omega.norm() <= tolerance::standstill * unit) motion = kStill;
    if (!world.bodies()[b].movable()) motion = kStill;
  }
  // Contact forces let a gap close; a held body would hover above it.
  for (const Contact& contact : contacts) {
    const double size =
        shortest_edge(world.bodies()[idx(contact.first)], world.bodies()[idx(contact.second)]);
    for (int p = 0; p < contact.count; ++p) {
      if (contact.points[idx(p)].distance <= tolerance::contact_gap * size) continue;
      for (const int b : {contact.first, contact.second})
        if (world.bodies()[idx(b)].movable()) motion_[idx(b)] = kUnsettled;
    }
  }
}

// Whether the input of the last search is unchanged.
bool StableBoxes::unchanged(const World& world, std::span<const Contact> contacts) const {
  if (!known_ || contacts.size() != basis_.contacts.size() || motion_ != basis_.motion ||
      world.gravity_w != basis_.gravity_w ||
      !std::equal(world.ids().begin(), world.ids().end(), basis_.ids.begin(), basis_.ids.end()))
    return false;
  for (std::size_t b = 0; b < basis_.inverse_masses.size(); ++b)
    if (world.bodies()[b].inverse_mass != basis_.inverse_masses[b]) return false;
  // Poses are compared, too: contact points on a small support do not determine the pose of a large body.
  const auto stays = [&](int body) {
    const BodyState& now = world.states()[idx(body)];
    const BodyState& then = basis_.states[idx(body)];
    return now.position_w == then.position_w &&
           now.orientation_wb.coeffs() == then.orientation_wb.coeffs();
  };
  const auto same = [&](const Contact& now, const Contact& then) {
    if (now.first != then.first || now.second != then.second || now.count != then.count)
      return false;
    if (!stays(now.first) || !stays(now.second)) return false;
    if (now.normal_w != then.normal_w) return false;
    for (int p = 0; p < now.count; ++p)
      if (now.points[idx(p)].position_w != then.points[idx(p)].position_w) return false;
    return true;
  };
  return std::equal(contacts.begin(), contacts.end(), basis_.contacts.begin(), same);
}

void StableBoxes::search(const World& world, std::span<const Contact> contacts) {
  held_.assign(world.bodies().size(), hold(Hold::free));
  if (gravity_is_down(world)) {
    apart_.clear();
    for (const char motion : motion_) apart_.push_back(motion == kUnsettled ? 1 : 0);
    geometric_.set_tolerances({exact_vertical(world), tolerance::exact_corner});
    geometric_.run(world, contacts, rule_, tolerance::resting_speed, stable_, {}, apart_);
    for (std::size_t b = 0; b < held_.size(); ++b)
      if (stable_[b] != 0) held_[b] = hold(Hold::upright);
  }
  for (std::size_t b = 0; b < held_.size(); ++b)
    if (!world.bodies()[b].movable()) held_[b] = hold(Hold::still);
  // Without gravity every island is trivially in equilibrium.
  if (rule_ == StableRule::equilibrium && !world.gravity_w.isZero(0.0))
    add_balanced(world, contacts);
}

// Adds towers on stable bodies, and islands in equilibrium.
void StableBoxes::add_balanced(const World& world, std::span<const Contact> contacts) {
  apart_ = held_;
  for (std::size_t b = 0; b < apart_.size(); ++b)
    if (motion_[b] > kSlides) apart_[b] = 1;
  towers_.run(world, contacts, apart_);

  // Towers become loads on their supports; the other bodies are examined in whole islands.
  const auto is_load = [&](int b) { return towers_.states()[idx(b)] == TowerState::supported; };
  left_.clear();
  for (const Contact& contact : contacts)
    if (contact.count > 0 && !is_load(contact.first) && !is_load(contact.second))
      left_.push_back(contact);
  loads_.clear();
  for (int b = 0; b < world.count(); ++b) {
    if (held_[idx(b)] != hold(Hold::free) || is_load(b)) continue;
    TowerLoad load = towers_.loads()[idx(b)];
    const double mass = world.bodies()[idx(b)].mass;
    load.moment -= mass * world.states()[idx(b)].position_w;
    load.mass -= mass;
    if (load.mass > 0.0) loads_.push_back({b, load.centre_w(), load.mass * world.gravity_w});
  }
  take_islands(world);
  take_towers(world);
}

// Drops the contacts of islands that cost more to examine than to solve, so that they are not held. The
// remaining islands are in islands_.
void StableBoxes::drop_large_islands(const World& world) {
  islands_.build(world.bodies(), left_, held_);
  drop_.assign(left_.size(), 0);
  for (int i = 0; i < islands_.count(); ++i) {
    const std::span<const int> touches = islands_.contacts(i);
    int points = 0;
    for (const int c : touches) points += left_[idx(c)].count;
    if (points <= most_points_) continue;
    for (const int c : touches) drop_[idx(c)] = 1;
  }
  std::size_t kept = 0;
  for (std::size_t c = 0; c < left_.size(); ++c)
    if (drop_[c] == 0) left_[kept++] = left_[c];
  if (kept == left_.size()) return;
  left_.resize(kept);
  islands_.build(world.bodies(), left_, held_);
}

// Holds whole islands that are in equilibrium and do not move.
void StableBoxes::take_islands(const World& world) {
  drop_large_islands(world);
  const BalanceReport& found =
      equilibrium_.solve(world, {.contacts = left_, .loads = loads_, .held = held_});
  report_.pivots = found.pivots;
  report_.multiplications = found.multiplications;
  const double vertical = exact_vertical(world);
  for (int i = 0; i < islands_.count(); ++i) {
    const std::span<const int> members = islands_.bodies(i);
    const std::span<const int> touches = islands_.contacts(i);
    const bool upright = std::all_of(touches.begin(), touches.end(), [&](int c) {
      return is_vertical(left_[idx(c)].normal_w, vertical);
    });
    const char fastest = upright ? kSlides : kStill;
    const bool in_balance = std::all_of(members.begin(), members.end(), [&](int b) {
      return equilibrium_.balanced()[idx(b)] != 0 && motion_[idx(b)] <= fastest &&
             towers_.states()[idx(b)] != TowerState::supported;
    });
    if (!in_balance) continue;
    for (const int b : members) held_[idx(b)] = hold(upright ? Hold::upright : Hold::still);
  }
}

// Holds towers whose support is held.
void StableBoxes::take_towers(const World& world) {
  for (int b = 0; b < world.count(); ++b) {
    int under = b;
    while (towers_.supports()[idx(under)] >= 0) under = towers_.supports()[idx(under)];
    if (under != b && held_[idx(under)] != hold(Hold::free)) held_[idx(b)] = hold(Hold::upright);
  }
}

}  // namespace tumble
