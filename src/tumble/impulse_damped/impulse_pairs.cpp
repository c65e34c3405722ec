/// \file
/// \brief Pairs of bodies that overlap at the poses they are about to have.
#include "tumble/impulse_damped/impulse_pairs.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/impulse_damped/tolerances.hpp"

#include <algorithm>

namespace tumble {
namespace {

// Hands impulses on to the points found anew: by name; those of points that are gone are spread
// over all, so that the contact as a whole has pushed as before.
void hand_on(const Contact& before, Contact& now) {
  double lost = 0.0;
  Vec3 lost_w = Vec3::Zero();
  for (int k = 0; k < before.count; ++k) {
    const ContactPoint& old = before.points[idx(k)];
    ContactPoint* same = nullptr;
    for (int i = 0; i < now.count; ++i)
      if (now.points[idx(i)].feature == old.feature) same = &now.points[idx(i)];
    if (same != nullptr) {
      same->normal_impulse += old.normal_impulse;
      same->friction_impulse_w += old.friction_impulse_w;
    } else {
      lost += old.normal_impulse;
      lost_w += old.friction_impulse_w;
    }
  }
  for (int i = 0; i < now.count; ++i) {
    now.points[idx(i)].normal_impulse += lost / now.count;
    now.points[idx(i)].friction_impulse_w += lost_w / now.count;
  }
}

}  // namespace

void ImpulsePairs::begin(double margin) {
  margin_ = margin;
  pairs_.clear();
  sorted_.clear();
  tests_ = 0;
}

std::span<int> ImpulsePairs::find(const World& world, const ImpulseBodies& bodies,
                                  const SleepingRule* sleeping) {
  bounds_.resize(world.bodies().size());
  for (std::size_t k = 0; k < bounds_.size(); ++k)
    bounds_[k] = bounds_of(world.bodies()[k], bodies.predicted()[k], margin_);
  broad_phase_.find_pairs(bounds_, near_);
  add_new(world, sleeping);
  found_.clear();
  for (const int number : sorted_)
    if (look(world, bodies, number).overlaps) found_.push_back(number);
  return found_;
}

// Both lists ascend, so that one walk along them finds the pairs that are new.
void ImpulsePairs::add_new(const World& world, const SleepingRule* sleeping) {
  const auto before = [&](int a, int b) { return pairs_[idx(a)].bodies < pairs_[idx(b)].bodies; };
  const std::size_t known = sorted_.size();
  std::size_t next = 0;
  for (const IndexPair& pair : near_) {
    while (next < known && pairs_[idx(sorted_[next])].bodies < pair) ++next;
    if (next < known && pairs_[idx(sorted_[next])].bodies == pair) continue;
    const BodyProperties& a = world.bodies()[idx(pair.first)];
    const BodyProperties& b = world.bodies()[idx(pair.second)];
    if (!a.movable() && !b.movable()) continue;
    if (sleeping != nullptr && !sleeping->needs_test(pair.first, pair.second)) continue;
    sorted_.push_back(static_cast<int>(pairs_.size()));
    ImpulsePair& added = pairs_.emplace_back();
    added.bodies = pair;
    added.size = shortest_edge(a, b);
    added.contact = contact_of(world, pair);
  }
  std::sort(sorted_.begin(), sorted_.end(), before);
}

ImpulsePair& ImpulsePairs::look(const World& world, const ImpulseBodies& bodies, int number) {
  ImpulsePair& pair = pairs_[idx(number)];
  const int first = bodies.version(pair.bodies.first);
  const int second = bodies.version(pair.bodies.second);
  if (pair.first_version == first && pair.second_version == second) return pair;
  pair.first_version = first;
  pair.second_version = second;
  ++tests_;
  Manifold manifold;
  // A face that lands flat lands with all its corners, wherever rounding has put each.
  const double flat = tolerance::impulse_even * pair.size;
  pair.near = touch_pair(world, bodies.predicted(), pair.bodies, std::max(margin_, flat), kNoAxis,
                         manifold);
  pair.overlaps = false;
  pair.depth = 0.0;
  if (!pair.near) return pair;
  pair.near_normal_w = manifold.normal_w;
  Contact now = pair.contact;
  now.normal_w = manifold.normal_w;
  now.axis = manifold.axis;
  now.count = 0;
  for (int i = 0; i < manifold.count; ++i) {
    const ManifoldPoint& from = manifold.points[idx(i)];
    if (from.distance > flat) continue;
    now.points[idx(now.count++)] =
        ContactPoint{from.position_w, from.distance, from.feature, 0.0, 0.0, Vec3::Zero()};
    pair.depth = std::max(pair.depth, -from.distance);
    pair.overlaps = pair.overlaps || from.distance <= 0.0;
  }
  if (!pair.overlaps) return pair;  // the contact stays as it was last seen
  hand_on(pair.contact, now);
  pair.contact = now;
  return pair;
}

void ImpulsePairs::list_near(ContactList& out) const {
  out.clear();
  for (const int number : sorted_) {
    const ImpulsePair& pair = pairs_[idx(number)];
    if (!pair.near) continue;
    out.push_back(pair.contact);
    out.back().normal_w = pair.near_normal_w;
  }
}

}  // namespace tumble
