/// \file
/// \brief Time and residual of contact forces of pyramids, beside the solvers of installed engines.
///
/// Prints for each size, at rest and with noise:
///   - our method of multipliers on the matrix as it is, from scratch with a new solver, and from the
///     step before: the next step's problem with the rows that pushed;
///   - the engines' solvers on the matrix as it is, which is singular, and, if they pivot, with 1e-4
///     of the mean diagonal added, which is what they need;
///   - one dense Cholesky factorisation of the rows that push in the end (with the same added):
///     ours and Eigen's.
/// All in one process, compiled with the same flags; the engines are those of their packages, found
/// at build time: ODE, Bullet, DART and Siconos (`TUMBLE_HAVE_ODE` and so on).
///
/// Run `lcp [largest n]`.
#include "tumble/lcp_solvers/augmented_lagrangian.hpp"

#include "lcp_peers.hpp"
#include "lcp_solvers/pyramid_problem.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace {

using tumble::LcpProblem;
using tumble::LcpResult;

// [µs] The median of at least 3 runs, 0.2 s of them if they are short.
double time_of(const std::function<void()>& prepare, const std::function<void()>& run) {
  std::vector<double> times;
  double sum = 0.0;
  while (times.size() < 3 || (times.size() < 1000 && sum < 2e5)) {
    prepare();
    const auto start = std::chrono::steady_clock::now();
    run();
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
    times.push_back(took.count());
    sum += took.count();
  }
  std::ranges::sort(times);
  return times[times.size() / 2];
}

LcpProblem made_definite(LcpProblem problem) {
  const double added = 1e-4 * problem.A.diagonal().mean();
  for (int i = 0; i < problem.size(); ++i) problem.A(i, i) += added;
  problem.factors = {};
  return problem;
}

void print(const char* name, double us, double residual, const char* remark) {
  std::printf("  %-38s %10.1f us  residual %7.1e  %s\n", name, us, residual, remark);
}

// Ours; returns the times from scratch and from the step before, and the rows that push.
void run_ours(const tumble::chapters::PyramidProblem& pyramid, double& cold, double& warm,
              std::vector<int>& pushing) {
  LcpResult result;
  cold = time_of([] {},
                 [&] {
                   tumble::AugmentedLagrangianSolver solver;
                   solver.solve(pyramid.problem, result);
                 });
  const std::string work = std::to_string(result.pivots) + " factorisations, " +
                           std::to_string(result.multiplications) + " multiplications";
  print("tumble augmented_lagrangian, cold", cold, result.residual, work.c_str());

  pushing = result.pushing;
  const auto next = tumble::chapters::next_step(pyramid, result.f);
  tumble::AugmentedLagrangianSolver solver;
  solver.solve(pyramid.problem, result);
  warm = time_of([] {}, [&] { solver.solve(next.problem, result, pushing); });
  const std::string warm_work = std::to_string(result.pivots) + " factorisations, " +
                                std::to_string(result.multiplications) + " multiplications";
  print("tumble augmented_lagrangian, warm", warm, result.residual, warm_work.c_str());
}

// One dense factorisation of the rows that push, ours and Eigen's: the time of each.
void run_dense(const LcpProblem& definite, const std::vector<int>& rows, double& ours,
               double& eigens) {
  tumble::SubsetCholesky cholesky;
  ours = time_of([] {},
                 [&] {
                   cholesky.clear(definite.size());
                   for (const int row : rows) {
                     cholesky.consider(definite.A, row);
                     cholesky.append_considered();
                   }
                 });
  const auto n = static_cast<Eigen::Index>(rows.size());
  tumble::MatX part(n, n);
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index i = 0; i < n; ++i)
      part(i, j) = definite.A(rows[static_cast<std::size_t>(i)], rows[static_cast<std::size_t>(j)]);
  Eigen::LLT<tumble::MatX> eigen(n);
  eigens = time_of([] {}, [&] { eigen.compute(part); });
  std::printf("  %-38s %10.1f us  %zu rows\n", "dense Cholesky, tumble", ours, rows.size());
  std::printf("  %-38s %10.1f us\n", "dense Cholesky, Eigen LLT", eigens);
}

void compare(int n, double noise) {
  const auto pyramid = tumble::chapters::pyramid_problem(n, noise, 1);
  const LcpProblem definite = made_definite(pyramid.problem);
  std::printf("\nn = %d, %s\n", n, noise > 0.0 ? "noisy" : "at rest");
  double cold = 0.0, warm = 0.0, dense = 0.0, eigen = 0.0;
  std::vector<int> pushing;
  run_ours(pyramid, cold, warm, pushing);

  for (const lcp_bench::Peer& peer : lcp_bench::peers()) {
    for (const LcpProblem* problem : {&pyramid.problem, &definite}) {
      const bool singular = problem == &pyramid.problem;
      if (!singular && !peer.pivots) continue;
      const double us = time_of([&] { peer.take(*problem); }, peer.solve);
      const double residual = tumble::lcp_residual(*problem, peer.forces());
      const std::string name = peer.name + (singular ? ", as it is" : ", made definite");
      const std::string ratio = "cold / this: " + std::to_string(cold / us);
      print(name.c_str(), us, residual,
            residual > 1e-3 || residual != residual ? "WRONG" : ratio.c_str());
    }
  }
  run_dense(definite, pushing, dense, eigen);
  std::printf("  warm / dense Cholesky: %.3f of tumble's, %.3f of Eigen's\n", warm / dense,
              warm / eigen);
}

}  // namespace

// Runs all sizes.
int main(int argc, char** argv) {
  const int largest = argc > 1 ? std::atoi(argv[1]) : 1024;
  for (const int n : {16, 40, 64, 256, 512, 1024})
    for (const double noise : {0.0, 0.1})
      if (n <= largest) compare(n, noise);
  return 0;
}
