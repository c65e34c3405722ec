/// \file
/// \brief `tumble lcp`: a linear complementarity problem from files, solved.
#include "tumble/base/error.hpp"
#include "tumble/base/suggestion.hpp"
#include "tumble/lcp_solvers/lcp.hpp"
#include "tumble/record/json.hpp"
#include "tumble/record/matrix_market.hpp"

#include "request.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <string_view>
#include <system_error>

namespace tumble::app {
namespace {

void write_list(Json& json, std::string_view name, const std::vector<double>& values) {
  json.key(name).begin_list();
  for (const double value : values) json.item(value);
  json.end_list();
}

std::string size_text(const MatX& matrix) {
  return std::to_string(matrix.rows()) + " by " + std::to_string(matrix.cols());
}

// A row of --equalities, from 0.
int row_of(std::string_view text, int size) {
  int row = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), row);
  require::that(error == std::errc{} && end == text.data() + text.size() && row >= 1 && row <= size,
                "--equalities: " + (text.empty() ? "a row is missing" : one_line(text)) +
                    ": expected rows from 1 to " + std::to_string(size) + ", as in 2,5-7");
  return row - 1;
}

// Marks the rows of "2,5-7".
std::vector<char> equalities_of(const std::string& text, int size) {
  std::vector<char> marks;
  if (text.empty()) return marks;
  marks.assign(static_cast<std::size_t>(size), 0);
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    const std::string_view item = std::string_view(text).substr(at, comma - at);
    const std::size_t dash = item.find('-');
    const int first = row_of(item.substr(0, dash), size);
    const int last = dash == std::string_view::npos ? first : row_of(item.substr(dash + 1), size);
    require::that(first <= last, "--equalities: " + std::string(item) +
                                     ": expected the smaller row first, as in 2,5-7");
    for (int row = first; row <= last; ++row) marks[static_cast<std::size_t>(row)] = 1;
    at = comma + 1;
  }
  return marks;
}

LcpProblem read_problem(const LcpRequest& request) {
  require::that(!request.matrix.empty() && !request.vector.empty(),
                "--matrix and --vector are needed, a Matrix Market file each");
  LcpProblem problem{.A = read_matrix_market(request.matrix)};
  require::that(problem.A.rows() == problem.A.cols(),
                request.matrix + ": " + size_text(problem.A) + ": expected a square matrix");
  const MatX b = read_matrix_market(request.vector);
  require::that(b.rows() == problem.A.rows() && b.cols() == 1,
                request.vector + ": " + size_text(b) + ": expected " +
                    std::to_string(problem.A.rows()) + " by 1, a row for each of " +
                    request.matrix);
  problem.b = b.col(0);
  problem.equality = equalities_of(request.equalities, problem.size());
  return problem;
}

}  // namespace

int solve_lcp(const LcpRequest& request) {
  const std::unique_ptr<LcpSolver> solver = make_lcp_solver(request.solver);
  const LcpProblem problem = read_problem(request);
  LcpResult result;
  solver->solve(problem, result);

  Json json;
  json.begin();
  json.field("solver", solver->name());
  json.field("status", name_of(result.status));
  json.field("pivots", std::int64_t{result.pivots});
  json.field("residual", result.residual);
  write_list(json, "f", result.f);
  write_list(json, "a", result.a);
  json.end();
  std::printf("%s", json.text().c_str());
  return result.status == LcpStatus::solved ? kDone : kMathematical;
}

}  // namespace tumble::app
