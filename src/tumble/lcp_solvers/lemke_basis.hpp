/// \file
/// \brief The linear algebra of Lemke's method: a basis whose unknowns are exchanged one by one.
#pragma once

#include "tumble/lcp_solvers/lcp.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// Numbers that know how far rounding may have moved them. One that may as well be 0 is 0.
struct Rounded {
  std::vector<double> x;      ///< the numbers
  std::vector<double> bound;  ///< in the same units, positive
};

/// The equations a - A f - z 1 = b, solved for n of their 2n + 1 unknowns, the basis.
///
/// Unknown i < n is the acceleration a_i, unknown n + i the force f_i, unknown 2n the lift z, which
/// does not act on equalities. The inverse of the matrix B of the basis is kept and updated at each
/// exchange. Everything computed with it is corrected once by its residual, and comes with
/// the bound \f$|B^{-1}|\,(|B|\,|x| + |c|)\f$ units of rounding for \f$x = B^{-1} c\f$, which does not
/// depend on the units of rows and unknowns. If a correction shows that the inverse has lost half of
/// its digits, it is made anew from the basis of accelerations, the largest pivots first: the way
/// that the exchanges took may have led through a basis that was nearly singular.
/// \par Cost
/// O(n²); making the inverse anew takes that for each force in the basis. No allocation for a problem no larger than one before.
/// \see Higham, "Accuracy and stability of numerical algorithms", 2002, 7.2 (the bound) and 14.4
///      (Gauss and Jordan's elimination).
class LemkeBasis {
 public:
  /// Starts with the accelerations as basis.
  /// \param problem has to outlive the calls below
  void begin(const LcpProblem& problem);

  /// The unknowns of the basis: (n) the unknown that each row has been solved for.
  [[nodiscard]] const std::vector<int>& unknowns() const { return unknowns_; }

  /// The values of the unknowns of the basis while all others are 0.
  /// \param values (n) B⁻¹ b
  void values(Rounded& values);

  /// How the unknowns of the basis answer to another one.
  /// \param unknown its number, in the basis or not
  /// \param answer  (n) B⁻¹ times its column: what each unknown of the basis falls by for each unit that
  ///                this one grows. Of a_j it is column j of B⁻¹
  void answer_to(int unknown, Rounded& answer);

  /// Exchanges an unknown of the basis for another one.
  /// \param row      whose unknown leaves
  /// \param entering the other one
  /// \param answer   of answer_to(entering), not 0 in that row
  void exchange(int row, int entering, const Rounded& answer);

  /// The work so far: multiplications since begin().
  [[nodiscard]] std::int64_t multiplications() const { return multiplications_; }

 private:
  void set_column(int unknown, std::vector<double>& column) const;
  void subtract_product(std::span<const double> x, std::vector<double>& rest,
                        std::vector<double>* sizes);
  void add_inverse_times(std::span<const double> c, std::vector<double>& y);
  void add_inverse_sizes_times(std::span<const double> c, std::vector<double>& y);
  bool solve(Rounded& out);
  void start_with_accelerations();
  void solve_or_invert(int unknown, Rounded& out);
  void invert();

  const LcpProblem* problem_ = nullptr;
  MatX inverse_;                      // (capacity×capacity) B⁻¹ in the first n rows, columns
  std::vector<int> unknowns_;         // (n)
  std::vector<int> wanted_;           // (n) unknowns_ while the inverse is made anew
  std::vector<char> is_wanted_;       // (n) ditto, of accelerations
  Rounded entering_;                  // ditto
  std::vector<double> right_, rest_;  // (n) c, and what B x leaves of it
  std::vector<double> sizes_, correction_;  // (n) |B| |x| + |c|, and B⁻¹ times the rest
  std::int64_t multiplications_ = 0;
};

}  // namespace tumble
