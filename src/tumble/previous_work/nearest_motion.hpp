/// \file
/// \brief The motion nearest to a wanted one with which no contact point goes in: the quadratic program of thesis 2.7.
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/math/projected_descent.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// Finds the motion q of all bodies with
/// \f[ \tfrac12 (q - q^*)^{\mathsf T} M (q - q^*) \quad\text{least for}\quad J q + d \ge 0 , \f]
/// in which the motions are displacements or velocities: q* is wanted, d is how far each contact point may go in. The multipliers f of the points,
/// with \f$M (q - q^*) = J^{\mathsf T} f\f$, are found as \f$f \ge 0\f$ with the least \f$\tfrac12 f^{\mathsf T} A f + b^{\mathsf T} f\f$, where
/// \f$A = J M^{-1} J^{\mathsf T}\f$ and \f$b = J q^* + d\f$: the complementarity problem of the same contacts. Friction is left out.
/// \par Cost
/// O(points) for each step of ProjectedDescent; A is never made.
/// \algorithm{Nearest poses and momenta: section 2.7}
/// \verified{The nearest motion of a cube above the ground stops at the ground}
class NearestMotion {
 public:
  /// Solves the problem.
  /// \param bodies    q* as velocities, and the inverse masses; receive q
  /// \param contacts  points and normals; receive f as normal impulses, from which they start
  /// \param gaps      d, for each point in the order of the contacts
  /// \param wanted    [-] step at which to end, over the one from no forces at all
  /// \param budget    steps at most
  DescentReport solve(std::span<MovingBody> bodies, std::span<Contact> contacts,
                      std::span<const double> gaps, double wanted, int budget);

  /// \return one for each point
  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  /// \return [1/kg] A_ii
  [[nodiscard]] double diagonal(std::size_t i) const { return rows_[i].yield; }
  /// \return b_i
  [[nodiscard]] double constant(std::size_t i) const { return rows_[i].constant; }
  /// What forces change of the motions of all points.
  /// \param out  A f, is overwritten
  void multiply(std::span<const double> f, std::span<double> out);
  /// Contacts push.
  /// \param f  in and out: at least 0
  static void allow(std::span<double> f);

  /// Multiplications since construction, as if the products were made with a full matrix A.
  [[nodiscard]] std::int64_t multiplications() const { return multiplications_; }

 private:
  struct Row {
    int first = 0, second = 0;
    Vec3 normal_w, arm_first_w, arm_second_w;  // [-], [m] arm × normal
    double yield = 0.0;                        // [1/kg] A_ii
    double constant = 0.0;                     // b_i
  };
  void take(std::span<const MovingBody> bodies, std::span<const Contact> contacts,
            std::span<const double> gaps);
  void push(std::span<const double> f);

  std::span<const MovingBody> bodies_;
  std::vector<Row> rows_;
  std::vector<double> forces_;
  std::vector<Vec3> linear_w_, angular_w_;  // what forces change, by body index
  ProjectedDescent<NearestMotion> descent_;
  std::int64_t multiplications_ = 0;
};

}  // namespace tumble
