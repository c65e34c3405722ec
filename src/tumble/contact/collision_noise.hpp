/// \file
/// \brief A little chance in collisions, so that no die bounces straight up (thesis 4.2).
#pragma once

#include "tumble/base/random.hpp"
#include "tumble/contact/contact.hpp"
#include "tumble/contact/tolerances.hpp"

namespace tumble {

/// Which collisions are left to chance.
enum class Randomness : std::uint8_t {
  off,   ///< none
  fast,  ///< those above the threshold: the thesis's
  slow,  ///< those below it
  all    ///< all
};

/// How much is left to chance, and when.
struct NoiseOptions {
  Randomness where = Randomness::fast;      ///< see there
  double speed = tolerance::noisy_speed;    ///< [-] of approach, as a share of sqrt(g L)
  double normal = tolerance::noisy_normal;  ///< [rad] standard deviation of the normal's angle
  double restitution = tolerance::noisy_restitution;  ///< [-] half the range around the pair's e
};

/// What chance makes of a collision.
struct NoisyCollision {
  Vec3 normal_w = Vec3::UnitY();  ///< [-] length 1, along which the impulse acts
  double restitution = 0.0;       ///< [-] 0 to 1
};

/// Varies normal and restitution of a collision at random.
///
/// The normal is turned by a Gaussian angle in a random direction, of three standard deviations at
/// most, and restitution is moved within its range and to 0 to 1. An impulse of Newton's law along
/// any normal along which the bodies approach changes the energy by
/// \f$-\tfrac{1-e^2}{2}\,(n'\cdot u)^2 / (n'\cdot K n') \le 0\f$, so energy cannot rise. But along
/// the true normal the bodies must part afterwards, \f$n\cdot(u + K n' j) \ge 0\f$: the turn is
/// halved until they do, and after some halvings left out.
///
/// Numbers are drawn from a stream that is named by what it is for: the same for all passes of
/// a step, whatever else was drawn.
/// \param contact  a contact of one point, whose bodies approach
/// \param random   the stream of this step; see Random::fork()
/// \see Barzel, Hughes, Wood, "Plausible motion simulation for computer graphics animation", 1996.
/// \algorithm{Random variation of collisions: section 4.2}
/// \verified{Chance never adds energy to a collision and never lets the bodies go on approaching}
[[nodiscard]] NoisyCollision vary(const Contact& contact, std::span<const MovingBody> bodies,
                                  const NoiseOptions& options, const Random& random);

/// Whether a collision is one that is left to chance.
/// \param bodies   how the bodies move; sizes are in `world`
/// \return false for bodies that part
[[nodiscard]] bool left_to_chance(const Contact& contact, std::span<const MovingBody> bodies,
                                  const World& world, const NoiseOptions& options);

}  // namespace tumble
