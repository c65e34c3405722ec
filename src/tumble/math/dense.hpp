/// \file
/// \brief Small dense matrices of run-time size, with a fixed order of sums.
#pragma once

#include "tumble/base/types.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

using MatRef = Eigen::Ref<const MatX>;  ///< a matrix or a block of one, not copied
using VecRef = Eigen::Ref<const VecX>;  ///< a vector or a part of one, not copied

/// Shows a std::vector as an Eigen vector, without copying.
/// \param v must outlive the view
inline Eigen::Map<const VecX> view(const std::vector<double>& v) {
  return {v.data(), static_cast<Eigen::Index>(v.size())};
}

/// y += s A(:, column), the one loop that everything here is made of.
///
/// Summing by columns, each entry of y gets its terms in the order of the columns, whether the
/// compiler takes one entry at a time or eight: the bits stay the same.
/// \param A       (m×n) the matrix
/// \param y       (m) to be added to
void add_column(double s, const MatRef& A, int column, std::span<double> y);

/// y = A x.
/// \param A  (m×n) the matrix
/// \param x  (n) the factor
/// \param y  (m) the product; must not overlap x
void multiply(const MatRef& A, std::span<const double> x, std::span<double> y);

/// The Cholesky factor of a part of a symmetric matrix that grows and shrinks by one index.
///
/// For a list C of indices it holds the lower triangular L with L Lᵀ = A(C, C). Appending is
/// a triangular solve, O(|C|²). Removing keeps the rows before the index and appends those after it
/// again, O(|C|³) at worst: dearer than a rotation of the rows and half as long, and with the 30
/// contacts of one body no matter. Storage grows to the largest size seen and stays.
class SubsetCholesky {
 public:
  /// Forgets all indices.
  /// \param size how many indices may come, the n of A
  void clear(int size);

  /// The indices held: C, in the order in which they were appended.
  [[nodiscard]] const std::vector<int>& indices() const { return indices_; }

  /// Takes an index into view: what appending it would add.
  /// \param A      (n×n) the matrix, the same in all calls since clear()
  /// \param index  not in C
  /// \return the Schur complement \f$S_{jj} = A_{jj} - A_{jC} A_{CC}^{-1} A_{Cj}\f$; it is 0 up to
  ///         rounding if row j depends on those of C, and never grows with C
  double consider(const MatRef& A, int index);

  /// How the forces of C answer a force 1 at the index in view.
  /// \param answer (|C|) \f$-A_{CC}^{-1} A_{Cj}\f$, in the order of indices()
  void answer_to_considered(std::span<double> answer) const;

  /// Appends the index in view, which must have had S_jj > 0.
  void append_considered();

  /// Takes an index out.
  /// \param A      (n×n) the matrix
  /// \param place  where in indices() it stands
  void remove(const MatRef& A, int place);

  /// Solves A(C, C) x = r.
  /// \param x (|C|) r on the way in, x on the way out, in the order of indices()
  void solve(std::span<double> x) const;

 private:
  void solve_lower(std::span<double> x) const;
  void solve_upper(std::span<double> x) const;

  MatX lower_;                // (capacity×capacity), |C| rows and columns in use
  std::vector<int> indices_;  // C
  std::vector<double> row_;   // the row of L that the index in view would get
  std::vector<int> later_;    // indices to be appended again
  double schur_ = 0.0;        // S_jj of the index in view
  int considered_ = -1;       // the index in view
};

/// The orthogonal factor of columns that come and go: G(:, P) = Q R, Qᵀ Q = 1.
///
/// Least squares through Q and R loses only as many digits as G itself deserves; the normal
/// equations G' G would lose twice as many. Columns are made orthogonal by the modified process of
/// Gram and Schmidt, and d is treated like one more column: as accurate as Householder's reflections.
/// \see Björck, "Solving linear least squares problems by Gram-Schmidt orthogonalization", BIT 7 (1967).
class OrthogonalFactor {
 public:
  /// Forgets all columns.
  /// \param rows     the m of G
  /// \param columns  how many columns may be held at once, at most
  void clear(int rows, int columns);

  /// The columns held: P, in the order in which they were appended.
  [[nodiscard]] const std::vector<int>& indices() const { return indices_; }

  /// Appends a column, unless it depends on those held (`tolerance::dependent_length`).
  /// \param G       (m×n) the matrix
  /// \param column  which column, not in P
  /// \return whether it was appended
  bool append(const MatRef& G, int column);

  /// Takes a column out.
  /// \param place  where in indices() it stands
  void remove(const MatRef& G, int place);

  /// Finds x that makes |G(:, P) x - d| least.
  /// \param d  (m) the target
  /// \param x  (|P|) the answer, in the order of indices()
  void solve(const VecRef& d, std::span<double> x);

  /// The work done, whatever the machine: multiplications and divisions since clear().
  [[nodiscard]] std::int64_t multiplications() const { return multiplications_; }

 private:
  bool append(const MatRef& G, int column, double limit);
  double take_out(int k);

  MatX q_;                    // (m×capacity) orthonormal columns
  MatX r_;                    // (capacity×capacity) upper triangular
  std::vector<int> indices_;  // P
  std::vector<int> later_;    // columns to be appended again
  std::vector<double> rest_;  // (m) what is left of a column or of d
  std::int64_t multiplications_ = 0;
};

}  // namespace tumble
