/// \file
/// \brief Contact with friction by sweeps over the points (thesis 2.6.3).
#pragma once

#include "tumble/analytic_lcp/friction_pyramid.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// What FrictionSweeps did.
struct FrictionSweepReport {
  int sweeps = 0;      ///< over all points
  double error = 0.0;  ///< [m/s] largest change that the last sweep would make at a point
};

/// Pushes with Coulomb's friction, found point by point, again and again.
///
/// For groups of bodies that are too large for one dense problem, and for those that Lemke's method
/// does not solve. With K the inverse mass at a point, u its motion and all other pushes as they are,
/// \f[ p_n \leftarrow \max\Bigl(0,\; p_n - \frac{r_n}{n^{\mathsf T} K n}\Bigr), \qquad
///     r_n = n\cdot u - \text{floor}, \f]
/// and then p_t becomes what stops the point, if \f$\mu\,p_n\f$ allows for that, and else the point of the disc
/// of that radius that is nearest to \f$p_t - u_t/k\f$ with k the largest answer across the normal. Where
/// nothing changes any more, nothing sinks and friction is within Coulomb's round cone, against the sliding.
///
/// Between sweeps, pushes go on along a conjugate direction: the change of the last sweep counts as a
/// descent of the energy, and the direction is begun anew when the change grows.
///
/// That it settles is not certain where friction couples strongly to normal pushes. It always ends: after
/// kMostSweeps, or as many visits of points as kMostVisits, with the pushes that were closest to settled.
/// Momentum is kept whatever is reached.
/// \par Cost and determinism
/// O(points) a sweep. No allocation once warm. The order is that of the points.
/// \see Jean, "The non-smooth contact dynamics method", Computer Methods in Applied Mechanics and
///      Engineering 177, 1999; Silcowitz, Niebe, Erleben, "A nonsmooth nonlinear conjugate gradient method
///      for interactive contact force problems", The Visual Computer 26, 2010.
/// \algorithm{Contact with friction by sweeps: section 2.6.3}
/// \deviation{The thesis solves all points of a group together only; this is for what that does not solve.}
/// \verified{Sweeps find Coulomb's law for a plate that slides, in any direction}
class FrictionSweeps {
 public:
  static constexpr int kMostSweeps = 4000;  ///< over all points
  static constexpr std::int64_t kMostVisits =
      400'000;                              ///< of points, but at least kLeastSweeps sweeps
  static constexpr int kLeastSweeps = 200;  ///< that are always allowed

  /// Looks for the pushes.
  /// \param points    the points that can push; `sliding_w` and `tangential_constant_w` are not read
  /// \param wanted    [m/s] a change that is small enough
  /// \param pushes    [N s] one for each point, on the second body, world frame: where to start, and the answer
  FrictionSweepReport solve(std::span<const MovingBody> bodies, std::span<const Contact> contacts,
                            std::span<const FrictionPoint> points, double wanted,
                            std::span<Vec3> pushes);

 private:
  struct Row {
    int first = 0;
    int second = 0;
    Vec3 place_w = Vec3::Zero();
    Vec3 normal_w = Vec3::Zero();
    Vec3 free_w = Vec3::Zero();     // [m/s] motion without any push
    double constant = 0.0;          // [m/s] of the normal motion, see FrictionPoint
    double friction = 0.0;          // [-]
    Mat3 yield_w = Mat3::Zero();    // [1/kg] K
    Mat3 stop_w = Mat3::Zero();     // [kg] inverse of K across the normal
    double normal_yield = 0.0;      // [1/kg]
    double slip_yield = 0.0;        // [1/kg] largest across the normal
    Vec3 push_w = Vec3::Zero();     // [N s]
    Vec3 before_w = Vec3::Zero();   // [N s] before the sweep
    Vec3 way_w = Vec3::Zero();      // [N s] the conjugate direction
    Vec3 closest_w = Vec3::Zero();  // [N s] of the best sweep so far
  };

  void load(std::span<const Contact> contacts, std::span<const FrictionPoint> points,
            std::span<const Vec3> pushes);
  double settle(Row& row);
  void push(Row& row, const Vec3& change_w);
  double go_on(double slope_before);

  std::vector<MovingBody> bodies_;  // with the present pushes
  std::vector<Row> rows_;
};

}  // namespace tumble
