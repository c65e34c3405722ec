/// \file
/// \brief Equalities as contacts from both sides, for solvers that know contacts only.
#pragma once

#include "tumble/lcp_solvers/lcp.hpp"

namespace tumble {

/// A problem whose equalities have become pairs of contacts.
///
/// Glue between two bodies acts as two contacts at the same point that push against each other: one of
/// them asks for a_i >= 0, its twin for -a_i >= 0, and the force of the glue is the difference of
/// theirs. In f the twin's column is the negative column, in a the negative row, so with A the
/// larger matrix is symmetric and positive semidefinite too. It is singular, but solvers of contacts
/// have to expect that anyway, and no digit is lost as in eliminating the equalities.
class TwinProblem {
 public:
  /// Takes over a problem.
  /// \param problem a valid one with n rows, m of them equalities
  void assign(const LcpProblem& problem);

  /// \return [1/kg] (n+m, n+m) equalities first, then their twins, then all other rows; each in the
  ///         order of the problem
  [[nodiscard]] MatRef A() const { return A_.topLeftCorner(size(), size()); }
  /// \return [m/s²] (n+m) in the same order
  [[nodiscard]] VecRef b() const { return b_.head(size()); }
  /// \return n + m
  [[nodiscard]] int size() const { return static_cast<int>(rows_.size()); }

  /// Translates a list of rows to start with.
  /// \param start   rows of A(); of an equality the side that b calls for
  void start_from(const LcpProblem& problem, std::span<const int> rows,
                  std::vector<int>& start) const;

  /// Translates an answer back.
  /// \param twin_f  [N] (n+m) forces of A()
  /// \param f       [N] (n) forces of the problem
  void forces(std::span<const double> twin_f, std::vector<double>& f) const;

 private:
  struct Row {
    int original;  // row of the problem
    double sign;   // -1 for a twin
  };

  MatX A_;  // as large as the largest problem so far, like b_
  VecX b_;
  std::vector<Row> rows_;  // (n+m)
  int originals_ = 0;      // n
};

}  // namespace tumble
