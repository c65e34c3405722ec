/// \file
/// \brief Contact forces that push but never pull: the linear complementarity problem.
#pragma once

#include "tumble/math/dense.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// How a problem with forces f >= 0 ended.
enum class ComplementarityStatus {
  solved,       ///< f holds a solution
  infeasible,   ///< there is none; `ray` proves it
  cap_reached,  ///< not done after as many pivots as allowed; f holds the state reached
  not_positive_semidefinite  ///< noticed that A is not; not every such A is noticed
};

/// Answer of ComplementaritySolver; keep it, its storage is used again.
struct ComplementarityResult {
  ComplementarityStatus status = ComplementarityStatus::solved;  ///< how it ended
  std::vector<double> f;                                         ///< [N] (n) forces, f >= 0
  std::vector<double> a;  ///< [m/s²] (n) a = A f + b as computed; unique where f is not
  std::vector<double>
      ray;  ///< infeasible: r >= 0 with A r = 0 and b·r < 0, to rounding; else empty
  std::vector<int> pushing;  ///< indices of forces in use, ascending: a start for the next solve
  int pivots = 0;            ///< how often a contact began or ceased to push
  double residual = 0.0;     ///< [-] see complementarity_residual()
  std::int64_t multiplications = 0;  ///< [-] the work done, whatever the machine
};

/// The number that judges any answer, however it was computed.
/// \param A (n×n) the matrix
/// \param b (n) the constant part
/// \return [-] \f$\max_i|\min(A_{ii}f_i, a_i)| / \max_i|b_i|\f$ with a = A f + b; the numerator if
///         b = 0
/// \throws std::invalid_argument if the sizes differ
double complementarity_residual(const MatRef& A, const VecRef& b, const VecRef& f);

/// Finds f >= 0 with a = A f + b >= 0 and f·a = 0, for symmetric positive semidefinite A.
///
/// Such problems come from resting contacts, A = J W Jᵀ: a contact either pushes or parts, never
/// both. A is singular as soon as contacts are redundant (four corners of one box); then f is not
/// unique, but a and the net force on every body are. With b in the range of J a solution exists.
///
/// Baraff's pivoting without friction: contacts are taken up one after the other, and each new force
/// grows until its contact stops sinking, while those taken up before keep their conditions. The
/// matrix of the pushing contacts stays positive definite even if A is singular, so a growing
/// Cholesky factor is all the linear algebra there is.
/// \par Digits
/// With \f$\varepsilon\f$ the rounding and \f$\lambda\f$ the smallest eigenvalue of that matrix in units of
/// its diagonal, a is good to about \f$\varepsilon/\sqrt\lambda\f$ of max |b|, `residual` shows it. In piles of
/// bodies with a dozen contacts each in any direction that can be 1e-5 and worse. A caller with J and W has
/// more digits than A: the solvers of the chapter on linear complementarity use them.
/// \par Cost and determinism
/// About n pivots of O(n²), more where contacts cease to push; no allocation for a problem no larger
/// than one before. Of equal candidates the lowest index is taken: the same input, the same bits.
/// \see Baraff, "Fast contact force computation for nonpenetrating rigid bodies", SIGGRAPH 1994, 4.
/// \algorithm{Forces of resting contacts: section 3.3.1}
/// \verified{The solver agrees with trying everything on 10000 singular problems}
class ComplementaritySolver {
 public:
  static constexpr int kPivotsEach = 50;  ///< pivots for each contact, after which it gives up

  /// Makes a solver.
  /// \param pivots_each pivots for each contact, after which a problem ends as `cap_reached`
  explicit ComplementaritySolver(int pivots_each = kPivotsEach) : pivots_each_(pivots_each) {}

  /// Solves one problem.
  /// \param A      [1/kg] (n×n) symmetric positive semidefinite
  /// \param b      [m/s²] (n) what a would be without forces
  /// \param result the answer; all of it is overwritten. n = 0 gives `solved`
  /// \param start  indices to begin with as pushing, for example `pushing` of a similar problem;
  ///               a bad guess costs pivots, not correctness; may be `result.pushing` itself
  /// \throws std::invalid_argument if sizes differ, a number is not finite, A is asymmetric by
  ///         more than `tolerance::symmetry`, or an index of start is out of range or given twice
  void solve(const MatRef& A, const VecRef& b, ComplementarityResult& result,
             std::span<const int> start = {});

 private:
  enum class Place : std::uint8_t { parted, pushing, left_out };
  struct Step;
  struct Answer;

  void begin(const MatRef& A, const VecRef& b, std::span<const int> start);
  void settle(const MatRef& A, const VecRef& b, ComplementarityResult& result);
  bool drive_to_zero(const MatRef& A, const VecRef& b, int d, ComplementarityResult& result);
  [[nodiscard]] Step longest_step(int d, const Answer& answer,
                                  const ComplementarityResult& result) const;
  [[nodiscard]] bool sinks_with_pushing(const VecRef& b) const;
  void change_place(const MatRef& A, int j);
  Answer answer_to(const MatRef& A, int j);

  SubsetCholesky factor_;        // of A(C, C), C = the pushing contacts
  std::vector<Place> place_;     // (n) where each contact stands
  std::vector<double> root_;     // (n) √A_ii, the scale of row i
  std::vector<double> subset_;   // (|C|) forces or changes of forces, in the factor's order
  std::vector<double> df_, da_;  // (n) change of f and a per unit force at the driven contact
  std::vector<int> start_;       // copy of the warm start
  double slack_ = 0.0;           // [m/s²] a >= -slack_ counts as not negative
  double unsure_ = 0.0;          // [m/s²] the same for a contact that depends on others, per force
  std::int64_t multiplications_ = 0;
  int exchanges_ = 0;  // of contacts that only seemed to sink
  int pivots_each_ = kPivotsEach;
};

}  // namespace tumble
