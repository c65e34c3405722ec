/// \file
/// \brief Particles and rods held by relaxation (thesis 2.3).
#pragma once

#include "tumble/base/types.hpp"

#include <array>
#include <vector>

namespace tumble {

/// A rod between two particles.
struct Rod {
  int first = 0;        ///< index of a particle
  int second = 0;       ///< index of another one
  double length = 1.0;  ///< [m]
};

/// Jakobsen's particles: positions and no velocities, held together by rods.
///
/// The velocity of a particle is its way of the last step. Verlet's rule continues that way,
/// \f[ x^+ = 2x - x^- + h^2 a , \f]
/// and whatever moves a particle afterwards has changed its velocity too. A rod that has not its length moves both ends along
/// itself, each by the share of its inverse mass. One rod disturbs the next, so all of them are gone through several times.
///
/// Each rod keeps the centre of mass of its two particles, and with that the linear momentum. It moves them along its new direction and
/// not along the one before the step, so the angular momentum and the energy of a spin shrink.
/// \par Cost
/// O(rods) for a pass.
/// \see Jakobsen, "Advanced character physics", Game Developers Conference, 2001.
/// \algorithm{Rods held by relaxation: section 2.3}
/// \verified{A rod gets its length back and its centre of mass stays}
struct RodParticles {
  std::vector<Vec3> now_w;           ///< [m] positions
  std::vector<Vec3> before_w;        ///< [m] positions a step before
  std::vector<double> inverse_mass;  ///< [1/kg] 0: held fast
  std::vector<Rod> rods;             ///< between them

  /// Moves all particles on, each by itself.
  /// \param acceleration_w  [m/s²] of all of them
  /// \param dt              [s] of the step, and of the one before
  void advance(const Vec3& acceleration_w, double dt);
  /// Gives each rod its length, one after the other, once.
  void relax();
};

/// Four particles of equal mass in place of a box: total mass, centre of mass and inertia are the same.
///
/// They are at every second corner of a box √3 times smaller. With the half edges h and the signs s of these corners the second moments
/// are \f$\sum \tfrac m4 (s_k h_k/\sqrt3)^2 = m h_k^2/3\f$, those of a box of uniform density, and the mixed ones cancel out.
inline constexpr std::array<std::array<double, 3>, 4> kTetrahedron{
    {{1.0, 1.0, 1.0}, {1.0, -1.0, -1.0}, {-1.0, 1.0, -1.0}, {-1.0, -1.0, 1.0}}};

/// Where the particles of a box are.
/// \param half  [m] half edges
/// \param k     0 to 3
/// \return [m] body frame
Vec3 particle_of_box(const Vec3& half, std::size_t k);

/// A point of a box as a mean of its four particles, with weights that add up to 1.
/// \param point_b  [m] body frame
/// \return [-] weights; some are below 0 for points outside of the tetrahedron, as corners are
std::array<double, 4> weights_of(const Vec3& half, const Vec3& point_b);

/// The nearest box to four particles.
struct FittedBox {
  Vec3 centre_w = Vec3::Zero();  ///< [m] the mean
  Quat orientation_wb =
      Quat::Identity();  ///< [-] the rotation nearest to how the particles are turned
  bool found = false;    ///< false: they are turned inside out, flat, or no numbers
};

/// Fits a box to four particles.
/// \param half       [m] half edges
/// \param particles  [m] world frame
/// \return by polar decomposition
FittedBox fit_box(const Vec3& half, const std::array<Vec3, 4>& particles);

}  // namespace tumble
