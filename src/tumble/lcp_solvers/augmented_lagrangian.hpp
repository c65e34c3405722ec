/// \file
/// \brief Contact forces by the method of multipliers, seen from the bodies (thesis 2.6.2, 3.3.1).
#pragma once

#include "tumble/lcp_solvers/block_rows.hpp"
#include "tumble/lcp_solvers/lcp.hpp"
#include "tumble/lcp_solvers/tolerances.hpp"

namespace tumble {

/// Options of AugmentedLagrangianSolver.
struct AugmentedLagrangianOptions {
  double residual = tolerance::multiplier_residual;  ///< [-] good enough, see lcp_residual()
  double softness = tolerance::contact_softness;     ///< [-] of the springs to begin with, up to 1
  int factorisations = 1000;  ///< [-] at most, and steps in a round; at least 0
  int rounds = 1000;          ///< [-] at most; at least 0
  bool warm = false;  ///< begin with the forces in `result`, if it has n of them; else with 0
};

/// Takes contacts for springs that only push, lets the bodies come to a balance on them, and preloads
/// each spring with the force that it has come to; until nothing sags any more.
///
/// | symbol | in code | meaning | unit |
/// |---|---|---|---|
/// | g_i | BlockRows | row i of J S, scaled to length 1; W = S Sᵀ | - |
/// | z | - | what contacts add to the accelerations, in the root of masses | m kg^1/2 / s² |
/// | f, a | f_, a_ | forces and accelerations of the scaled rows, a = Gᵀ G f + b | z's |
/// | d | moved_ | how far the springs let the bodies move from z = G f | z's |
/// | \f$\varepsilon\f$ | softness_ | softness of the springs, A_ii = 1 | - |
///
/// A round looks for the d that makes the energy of masses and springs least,
/// \f[ \tfrac12 |z + d|^2 + \tfrac{1}{2\varepsilon}
///     \sum_i \max\!\left(0,\; \varepsilon f_i - a_i - g_i \cdot d\right)^2, \f]
/// without the maximum for equalities, which pull too, and then takes
/// \f$f_i \leftarrow \max(0, f_i - (a_i + g_i \cdot d)/\varepsilon)\f$. The energy is made of
/// parabolas, one for each set C of springs that push, so Newton's method with the exact minimum
/// along each step ends after finitely many: each asks for a solution with
/// \f$\varepsilon I + \sum_{i \in C} g_i g_i^{\mathsf T}\f$ (BlockCholesky). That matrix is as large as
/// there are bodies, not contacts, empty where bodies do not touch, and never singular: redundant
/// contacts share a force as equal springs do. A round takes the error to about
/// \f$\varepsilon / \sigma\f$ of what it was, \f$\sigma\f$ the smallest eigenvalue that matters; begins
/// from f alone, so that it also corrects rounding errors of earlier rounds; and costs no factorisation if C
/// stays.
/// \par How it ends
/// `solved`, at the residual asked for, or where rounding allows no smaller one (forces far
/// above \f$\max|b|/A_{ii}\f$); `infeasible` if the springs' growth proves that no solution has
/// accelerations below a million times those that any constraint asks for alone
/// (`tolerance::contradiction`); `not_positive_semidefinite`; `cap_reached`, also if rounding leaves
/// more than `tolerance::usable_residual`.
/// \par Cost
/// `pivots` counts factorisations: 1 to 3 for what rests or was solved a step before, about 10 for
/// what moves anyhow. Each is a few 6×6 products for each body and contact of a pile; without factors of
/// A the matrix is dense. No allocation for a problem whose rows touch the same bodies as before.
/// \see Rockafellar, "Augmented Lagrangians and applications of the proximal point algorithm in
///      convex programming", Mathematics of Operations Research 1 (1976); Hermans, Themelis,
///      Patrinos, "QPALM: a proximal augmented Lagrangian method for nonconvex quadratic programs",
///      Mathematical Programming Computation 14 (2022).
/// \algorithm{Contact forces by the method of multipliers: sections 2.6.2 and 3.3.1}
/// \verified{All exact solvers find one motion in 10000 contact problems with redundant contacts}
class AugmentedLagrangianSolver final : public LcpSolver {
 public:
  /// Makes a solver.
  /// \throws std::invalid_argument for an option out of its range
  explicit AugmentedLagrangianSolver(const AugmentedLagrangianOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "augmented_lagrangian"; }

  /// \copydoc LcpSolver::solve
  /// \note Factors of A are used if there are any; without them A is factored. `start` is used: with
  ///       the rows that push in the end, one factorisation is enough
  /// \throws std::invalid_argument if factors are given that make no sense or are not those of A;
  ///         with the option `warm`, if a force in `result` is not finite
  void solve(const LcpProblem& problem, LcpResult& result,
             std::span<const int> start = {}) override;

 private:
  void begin(const LcpProblem& problem, const LcpResult& result, std::span<const int> start);
  [[nodiscard]] bool immovable_rows_hold(const LcpProblem& problem) const;
  LcpStatus raise_preloads(const LcpProblem& problem, int& factorisations);
  void find_accelerations();
  [[nodiscard]] double wrong(const LcpProblem& problem, int row) const;
  [[nodiscard]] double residual(const LcpProblem& problem) const;
  bool only_rounding_is_left(const LcpProblem& problem);
  bool contradiction(const LcpProblem& problem);
  bool settle(const LcpProblem& problem, double enough, int& factorisations);
  void load_springs(const LcpProblem& problem, bool choose_set);
  double find_imbalance();
  double length_of_step(const LcpProblem& problem, bool& full);

  // Where a spring comes to push, or ceases to, along a step.
  struct Kink {
    double t;
    int row;
  };

  AugmentedLagrangianOptions options_;
  BlockRows rows_;
  BlockCholesky cholesky_;
  double softness_ = 0.0;
  double scale_ = 1.0;              // [m/s²] max |b|, or 1
  bool guess_ = false;              // whether pushes_ is a guess that the first step follows
  bool factored_is_known_ = false;  // whether the factor is that of factored_ and softness_
  std::vector<double> b_;           // (n) scaled like f_, a_ and all below
  std::vector<double> f_;           // (n) preloads
  std::vector<double> a_;           // (n) accelerations under the preloads
  std::vector<double> sag_;         // (n) g_i·d
  std::vector<double> sag_rate_;    // (n) g_i·p
  std::vector<double> change_;      // (n) the springs' forces less f_
  std::vector<char> pushes_;        // (n) C
  std::vector<char> factored_;      // (n) C of the factor
  std::vector<Vec6> moved_;         // (blocks) d
  std::vector<Vec6> step_;          // (blocks) p, Newton's step
  std::vector<Vec6> imbalance_;     // (blocks) gradient of the energy at d; also z
  std::vector<double> load_;        // (blocks) sum of sizes of forces
  std::vector<Kink> kinks_;         // (up to n) a heap
  std::int64_t multiplications_ = 0;
};

}  // namespace tumble
