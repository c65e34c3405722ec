/// \file
/// \brief Complementarity problems that others collected, read from the test data of Siconos.
#pragma once

#include "tumble/lcp_solvers/lcp.hpp"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace tumble::test {

// A problem and its known solutions.
struct SiconosProblem {
  std::string name;    // of the file, for example "lcp_mmc"
  LcpProblem problem;  // the problem, no equalities
  bool semidefinite;   // A is symmetric and positive semidefinite
  bool solvable;       // it has a solution
  // The solutions at corners of the solution set, all of them, found by trying all cases; empty if
  // there is none or the problem is too large for that
  std::vector<std::vector<double>> solutions;
};

// Reads a file of Siconos in its dense format: n, 0, rows, columns, both again, the matrix column by
// column, the vector, and remarks, which are not read.
inline LcpProblem read_siconos(const std::filesystem::path& file) {
  std::ifstream in(file);
  int n = 0;
  int sparse = 0;
  int rows[2] = {};
  int columns[2] = {};
  in >> n >> sparse >> rows[0] >> columns[0] >> rows[1] >> columns[1];
  for (int k = 0; k < 2; ++k)
    if (!in || n < 1 || n > 1000 || sparse != 0 || rows[k] != n || columns[k] != n)
      throw std::runtime_error(file.string() + ": no square matrix in Siconos' dense format");
  LcpProblem problem{MatX(n, n), VecX(n), {}};
  for (int column = 0; column < n; ++column)
    for (int row = 0; row < n; ++row) in >> problem.A(row, column);
  for (int row = 0; row < n; ++row) in >> problem.b[row];
  if (!in) throw std::runtime_error(file.string() + ": not enough numbers");
  return problem;
}

// Reads all problems that are given as dense matrices.
inline std::vector<SiconosProblem> siconos_problems(const std::filesystem::path& folder) {
  // An LCP is solvable if it says so here; the lists are those that trying all cases gave.
  std::vector<SiconosProblem> all = {
      {"lcp_CPS_1", {}, true, true, {{1, 0}, {0, 1}}},
      {"lcp_CPS_2", {}, false, true, {{0, 1, 3}}},
      {"lcp_CPS_3",
       {},
       false,
       true,
       {{0.1, 0, 0.1, 0}, {0, 1.0 / 15, 0, 1.0 / 15}, {1.0 / 90, 2.0 / 45, 1.0 / 90, 2.0 / 45}}},
      {"lcp_CPS_4", {}, false, true, {{2, 2, 2, 92}}},
      {"lcp_CPS_4bis", {}, false, true, {{3, 3, 0, 83}}},
      {"lcp_CPS_5", {}, true, true, {{0, 1}}},
      {"lcp_Pang_isolated_sol", {}, false, true, {{1, 0, 0}}},
      {"lcp_Pang_isolated_sol_perturbed", {}, false, false, {}},
      {"lcp_deudeu", {}, true, true, {{4.0 / 3, 7.0 / 3}}},
      {"lcp_enum_fails", {}, false, true, {}},
      {"lcp_exp_murty", {}, false, true, {{0, 0, 0, 0, 0, 1}}},
      {"lcp_exp_murty2", {}, false, true, {{0, 0, 0, 0, 0, 64}}},
      {"lcp_inf_sol_perturbed", {}, false, true, {{1, 0, 1e-4}}},
      {"lcp_mmc", {}, true, true, {}},
      {"lcp_ortiz", {}, false, true, {{2.0 / 3, 0, 1.0 / 3, 0}}},
      {"lcp_tobenna", {}, false, true, {}},
      {"lcp_trivial",
       {},
       true,
       true,
       {{1, 0.5, 1.0 / 3, 0.25, 0.2, 1.0 / 6, 1.0 / 7, 0.125, 1.0 / 9}}},
  };
  for (SiconosProblem& one : all) one.problem = read_siconos(folder / (one.name + ".dat"));
  return all;
}

}  // namespace tumble::test
