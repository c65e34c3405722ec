/// \file
/// \brief Normals and restitution varied at random.
#include "tumble/contact/collision_noise.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/math/elementary.hpp"
#include "tumble/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tumble {
namespace {

constexpr int kMostHalvings = 8;

// [m/s] normal velocity of a contact's only point; below 0: approach
double normal_speed(const Contact& contact, std::span<const MovingBody> bodies) {
  return contact.normal_w.dot(relative_velocity(
      bodies[idx(contact.first)], bodies[idx(contact.second)], contact.points[0].position_w));
}

}  // namespace

// [S4.2]
NoisyCollision vary(const Contact& contact, std::span<const MovingBody> bodies,
                    const NoiseOptions& options, const Random& random) {
  Random stream = random.fork(number_of(contact.first_id)).fork(number_of(contact.second_id));
  const double shift = stream.uniform(-1.0, 1.0);
  const double radius = stream.unit();
  const double turn = stream.unit();
  NoisyCollision result{contact.normal_w, contact.restitution};
  result.restitution = std::clamp(contact.restitution + options.restitution * shift, 0.0, 1.0);

  // Two Gaussian numbers at once (Box and Muller): an angle and its direction.
  const double angle =
      options.normal * std::min(3.0, std::sqrt(-2.0 * elementary::log(1.0 - radius)));
  const elementary::SinCos way = elementary::sincos(2.0 * std::numbers::pi * turn);
  const Tangents across = tangents_of(contact.normal_w);
  Vec3 rotation_w = angle * (way.cos * across.first_w + way.sin * across.second_w);

  const MovingBody& first = bodies[idx(contact.first)];
  const MovingBody& second = bodies[idx(contact.second)];
  const Vec3& point_w = contact.points[0].position_w;
  const Vec3 u_w = relative_velocity(first, second, point_w);
  const Mat3 k_w = inverse_mass_at(first, second, point_w);
  for (int halving = 0; halving < kMostHalvings; ++halving, rotation_w *= 0.5) {
    const Vec3 n_w = (rotation_from_vector(rotation_w) * contact.normal_w).normalized();
    const double yield = n_w.dot(k_w * n_w);
    if (!(n_w.dot(u_w) < 0.0) || !(yield > 0.0)) continue;
    const double impulse = -(1.0 + result.restitution) * n_w.dot(u_w) / yield;
    if (contact.normal_w.dot(u_w + impulse * (k_w * n_w)) < 0.0) continue;
    result.normal_w = n_w;
    break;
  }
  return result;
}

bool left_to_chance(const Contact& contact, std::span<const MovingBody> bodies, const World& world,
                    const NoiseOptions& options) {
  if (options.where == Randomness::off || contact.count != 1) return false;
  const double approach = -normal_speed(contact, bodies);
  if (!(approach > 0.0)) return false;
  const double length =
      shortest_edge(world.bodies()[idx(contact.first)], world.bodies()[idx(contact.second)]);
  const bool fast = approach > options.speed * std::sqrt(world.gravity_w.norm() * length);
  return options.where == Randomness::all || fast == (options.where == Randomness::fast);
}
// [S4.2]

}  // namespace tumble
