/// \file
/// \brief The listing FIXCONTACTCONSTRAINTS.
#include "tumble/impulse_damped/fix_contact_constraints.hpp"

#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"

#include <algorithm>
#include <tuple>

namespace tumble {
namespace {

// How deep two bodies overlap now, and the normal from the first to the second.
Separation separation_of(const World& world, int first, int second) {
  const auto box = [&](int b) { return box_of(world.bodies()[idx(b)], world.states()[idx(b)]); };
  const auto above_ground = [&](int b) {
    const Box it = box(b);
    return Separation{it.center_w.y() - reach(it, Vec3::UnitY()), Vec3::UnitY(), kNoAxis};
  };
  if (world.bodies()[idx(first)].shape == Shape::ground) return above_ground(second);
  if (world.bodies()[idx(second)].shape == Shape::ground) {
    Separation found = above_ground(first);
    found.normal_w = -found.normal_w;
    return found;
  }
  return separation(box(first), box(second));
}

// [m] overlap below it is rounding
double rounding_of(const World& world, int first, int second) {
  double size = 0.0;
  for (const int b : {first, second})
    if (world.bodies()[idx(b)].shape == Shape::box)
      size = std::max(size, world.bodies()[idx(b)].size.maxCoeff());
  return tolerance::rounding_overlap * size;
}

}  // namespace

FixReport FixContactConstraints::run(World& world, std::span<const Contact> contacts,
                                     const DampedNumbers& numbers, double dt) {
  FixReport report;
  // [FIXCONTACTCONSTRAINTS:1]
  // From the ground up: contact points by height, of equals the
  // older pair first.
  sorted_.clear();
  for (std::size_t c = 0; c < contacts.size(); ++c)
    for (int p = 0; p < contacts[c].count; ++p)
      sorted_.push_back({contacts[c].points[idx(p)].position_w.y(), static_cast<int>(c), p});
  std::sort(sorted_.begin(), sorted_.end(), [](const Point& a, const Point& b) {
    return std::tie(a.height, a.contact, a.point) < std::tie(b.height, b.contact, b.point);
  });
  // [FIXCONTACTCONSTRAINTS:1]

  const auto can_move = [&](int b) {
    return world.bodies()[idx(b)].movable() && !world.sleep_states()[idx(b)].asleep;
  };
  // What was found of a pair holds for its other points until one of the two is pushed.
  known_.assign(contacts.size(), Known{});
  pushes_.assign(world.bodies().size(), 0);
  const auto separation_now = [&](int contact) {
    const int first = contacts[idx(contact)].first, second = contacts[idx(contact)].second;
    const std::array<int, 2> pushes{pushes_[idx(first)], pushes_[idx(second)]};
    Known& known = known_[idx(contact)];
    if (known.pushes != pushes) known = {separation_of(world, first, second), pushes};
    ++report.pair_tests;
    return known.found;
  };
  // [FIXCONTACTCONSTRAINTS:2-5]
  for (const Point& visited : sorted_) {
    // The upper body is the one towards which the normal rises.
    // If that one cannot move, the lower one does, downwards.
    const Contact& contact = contacts[idx(visited.contact)];
    Separation found = separation_now(visited.contact);
    const bool second_is_upper = found.normal_w.y() >= 0.0;
    int moving_object = second_is_upper ? contact.second : contact.first;
    int stable_object = second_is_upper ? contact.first : contact.second;
    if (!can_move(moving_object)) std::swap(moving_object, stable_object);
    if (!can_move(moving_object)) continue;
    const bool along = moving_object == contact.second;
    const Vec3 offset_vector_w = along ? found.normal_w : Vec3(-found.normal_w);
    // [FIXCONTACTCONSTRAINTS:2-5]
    // [FIXCONTACTCONSTRAINTS:6-7]
    // Small pushes until they are apart.
    const BodyProperties& body = world.bodies()[idx(moving_object)];
    const double push = thresholds_of(numbers, body, world.gravity_w.norm(), dt).push;
    const double rounding = rounding_of(world, moving_object, stable_object);
    int pushes = 0;
    while (found.distance < -rounding && pushes < kMostPushes) {
      world.states()[idx(moving_object)].position_w += push * offset_vector_w;
      report.energy -= body.mass * push * world.gravity_w.dot(offset_vector_w);
      ++pushes_[idx(moving_object)];
      found = separation_now(visited.contact);
      ++pushes;
    }
    // [FIXCONTACTCONSTRAINTS:6-7]
    report.pushes += pushes;
    report.given_up += found.distance < -rounding ? 1 : 0;
  }
  // [FIXCONTACTCONSTRAINTS:8]
  return report;
  // [FIXCONTACTCONSTRAINTS:8]
}

}  // namespace tumble
