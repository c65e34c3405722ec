/// \file
/// \brief Complementarity problems that others collected, read from the test data of Siconos.
#pragma once

#include "tumble/lcp_solvers/lcp.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
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

// One of the problems.
struct NormalProblem {
  std::string name;       // of the file
  LcpProblem problem;     // rows and columns of the normals only, made symmetric
  std::vector<double> a;  // [m/s] what it comes to, unique
};

// The next number of a file.
template <class Number>
Number next(std::istream& in) {
  Number value{};
  if (!(in >> value)) throw std::runtime_error("a Siconos file ended early");
  return value;
}

// Reads the matrix in either of its formats: dense by columns, or blocks listed row by row.
inline MatX read_matrix(std::istream& in, int d) {
  const int format = next<int>(in);
  const int rows = next<int>(in);
  const int columns = next<int>(in);
  MatX W = MatX::Zero(rows, columns);
  if (format == 0) {
    next<int>(in);
    next<int>(in);
    for (int column = 0; column < columns; ++column)
      for (int row = 0; row < rows; ++row) W(row, column) = next<double>(in);
    return W;
  }
  const int blocks = next<int>(in);
  const int block_rows = next<int>(in);
  const int block_columns = next<int>(in);
  for (int k = 0; k < block_rows + block_columns; ++k) next<int>(in);  // where they end
  std::vector<int> begin_of_row(static_cast<std::size_t>(next<int>(in)));
  std::vector<int> column_of_block(static_cast<std::size_t>(next<int>(in)));
  for (int& value : begin_of_row) value = next<int>(in);
  for (int& value : column_of_block) value = next<int>(in);
  int block_row = 0;
  for (int k = 0; k < blocks; ++k) {
    while (begin_of_row.at(static_cast<std::size_t>(block_row) + 1) <= k) ++block_row;
    const int block_column = column_of_block.at(static_cast<std::size_t>(k));
    next<int>(in);  // k
    for (int column = 0; column < d; ++column)
      for (int row = 0; row < d; ++row)
        W(d * block_row + row, d * block_column + column) = next<double>(in);
  }
  return W;
}

// Reads a file of a problem with friction, and keeps the normals.
inline LcpProblem read_normal_problem(const std::filesystem::path& file) {
  std::ifstream in(file);
  const int d = next<int>(in);
  const int n = next<int>(in);
  const MatX W = read_matrix(in, d);
  LcpProblem problem{MatX(n, n), VecX(n), {}};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) problem.A(i, j) = 0.5 * (W(d * i, d * j) + W(d * j, d * i));
  for (int k = 0; k < d * n; ++k) {
    const auto value = next<double>(in);
    if (k % d == 0) problem.b[k / d] = value;
  }
  return problem;
}

// Reads all of them, with the expected answers.
inline std::vector<NormalProblem> siconos_normal_problems(const std::filesystem::path& folder) {
  std::ifstream in(folder / "expected_normal_lcp.json");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::vector<NormalProblem> all;
  for (std::size_t at = text.find(".dat\""); at != std::string::npos;
       at = text.find(".dat\"", at + 1)) {
    const std::size_t quote = text.rfind('"', at);
    NormalProblem one{.name = text.substr(quote + 1, at + 3 - quote)};
    one.problem = read_normal_problem(folder / one.name);
    const std::size_t list = text.find('[', text.find("\"w\"", at));
    std::istringstream numbers(text.substr(list + 1, text.find(']', list) - list - 1));
    char comma = ' ';
    for (double value = 0.0; numbers >> value; numbers >> comma) one.a.push_back(value);
    all.push_back(one);
  }
  if (all.empty()) throw std::runtime_error("no expected answers in " + folder.string());
  return all;
}

}  // namespace tumble::test
