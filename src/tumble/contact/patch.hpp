/// \file
/// \brief Pressure and friction of a contact area: all points of one contact together (thesis 3.2).
#pragma once

#include "tumble/contact/effective_mass.hpp"
#include "tumble/geometry/manifold.hpp"

#include <span>
#include <vector>

namespace tumble {

/// The most points that a contact area can have.
inline constexpr std::size_t kMostPatchPoints = Manifold::kMostPoints;

/// One point of a contact area and the impulse on the second body there.
struct PatchPoint {
  Vec3 position_w = Vec3::Zero();          ///< [m] world frame
  double normal_impulse = 0.0;             ///< [N s] along the normal, at least 0
  Vec3 friction_impulse_w = Vec3::Zero();  ///< [N s] across the normal, world frame
};

/// Spreads the normal impulses of a contact over its points as evenly as possible.
///
/// Only their sum and its centre, the centre of pressure, do anything to the bodies. With four
/// or more points they can be split in many ways, and a solver that stops at the first one loads
/// two corners of a box and leaves the others empty. Here the split with the least sum of squares
/// is taken, which does not depend on the order of the points. Its form is
/// \f$j_i = \max(0,\; \lambda_0 + \lambda\cdot s_i)\f$ with \f$s_i\f$ the place of the point in the
/// contact plane; the loaded points are found by Newton's method for the three \f$\lambda\f$.
/// \param points    normal impulses in and out; left as they are if fewer than four are there, or
///                  if the centre of pressure lies on the rim, where the split is unique
void even_out(const Vec3& normal_w, std::span<PatchPoint> points);

/// A contact area among others: whose it is and which points belong to it.
struct Patch {
  Vec3 normal_w = Vec3::UnitY();  ///< [-] from the first body to the second, world frame
  double friction = 0.0;          ///< [-] μ, at least 0
  int first = 0;                  ///< index of the first body
  int second = 0;                 ///< index of the second body
  int begin = 0;                  ///< index of its first point
  int end = 0;                    ///< index after its last point
};

/// Coulomb's friction at points whose normal impulses are known, found step by step.
///
/// A step changes the friction at each point against its slip \f$u_i\f$, in proportion to the load
/// \f$j_i\f$ that it bears, and takes it back into its cone:
/// \f[ f_i \leftarrow \operatorname{clip}(f_i - \beta\, j_i\, u_i,\; \mu\, j_i) . \f]
/// It comes to rest where each point either does not slip, or has its friction at the bound and
/// against the slip that is left. Uniform sliding then gives the force μ F against the sliding at
/// the centre of pressure, and spinning in place the torque of the loaded points.
///
/// This is descent along the gradient of the kinetic energy, and β is its step: one for all points.
/// It is first so small that it cannot overshoot: one over the sum of the points' tangential
/// inverse masses, each times its load. From the second step on, the answer of the slip to the step
/// before shows the inverse mass as it is, with all that goes with it (normal impulses solved anew,
/// other contacts), and β is one over that: the step of Barzilai and Borwein.
/// \see Barzilai, Borwein, "Two-point step size gradient methods", IMA J. Numer. Anal. 8, 1988.
class PatchFriction {
 public:
  /// Forgets earlier steps.
  void begin(std::size_t points);

  /// One step.
  /// \param bodies   their velocities include the impulses in `points`; changed with them
  /// \param points   of all contact areas; friction impulses in and out
  /// \return [N s] sum of the magnitudes of the changes
  double step(std::span<const Patch> patches, std::span<MovingBody> bodies,
              std::span<PatchPoint> points);

 private:
  struct Seen {
    Vec3 friction_w = Vec3::Zero();  // [N s]
    Vec3 slip_w = Vec3::Zero();      // [m/s]
    double load = 0.0;               // [N s]
  };
  double look(std::span<const Patch> patches, std::span<const MovingBody> bodies,
              std::span<const PatchPoint> points);

  bool stepped_ = false;       // whether there was a step before
  std::vector<Seen> before_;   // what it found
  std::vector<Seen> now_;      // what this one finds
  std::vector<double> yield_;  // [1/kg] by point: trace of the inverse mass across the normal
};

}  // namespace tumble
