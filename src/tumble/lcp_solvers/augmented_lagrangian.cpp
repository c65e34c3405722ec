/// \file
/// \brief Contact forces by the method of multipliers, seen from the bodies (thesis 2.6.2, 3.3.1).
#include "tumble/lcp_solvers/augmented_lagrangian.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/lcp_solvers/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

double dot(const std::vector<Vec6>& x, const std::vector<Vec6>& y) {
  double sum = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) sum += x[k].dot(y[k]);
  return sum;
}

}  // namespace

AugmentedLagrangianSolver::AugmentedLagrangianSolver(const AugmentedLagrangianOptions& options)
    : options_(options) {
  require::not_negative(options.residual, "residual");
  require::within(options.softness, tolerance::least_softness, 1.0, "softness");
  require::that(options.factorisations >= 0, "factorisations: give at least 0");
  require::that(options.rounds >= 0, "rounds: give at least 0");
}

void AugmentedLagrangianSolver::solve(const LcpProblem& problem, LcpResult& result,
                                      std::span<const int> start) {
  require_valid(problem, LcpMatrix::symmetric_semidefinite);
  require_valid_start(problem.size(), start);
  result.pivots = 0;
  multiplications_ = 0;
  if (rows_.take(problem)) {
    cholesky_.analyse(rows_);
    begin(problem, result, start);
    result.status = immovable_rows_hold(problem) ? raise_preloads(problem, result.pivots)
                                                 : LcpStatus::infeasible;
  } else {
    f_.assign(idx(problem.size()), 0.0);
    result.status = LcpStatus::not_positive_semidefinite;
  }
  result.multiplications = multiplications_ + rows_.multiplications_of_take();
  if (result.status != LcpStatus::not_positive_semidefinite)
    result.multiplications += cholesky_.multiplications();

  // Back from rows of length 1 to those of the problem.
  result.f.resize(idx(problem.size()));
  for (int i = 0; i < problem.size(); ++i)
    result.f[idx(i)] = f_[idx(i)] == 0.0 ? 0.0 : f_[idx(i)] / rows_.length(i);
  complete(problem, result);
  if (result.status == LcpStatus::solved && !(result.residual <= tolerance::usable_residual))
    result.status = LcpStatus::cap_reached;
}

// Scales b and the forces to begin with; those of contacts may not pull.
void AugmentedLagrangianSolver::begin(const LcpProblem& problem, const LcpResult& result,
                                      std::span<const int> start) {
  const std::size_t n = idx(problem.size());
  const bool warm = options_.warm && result.f.size() == n;
  softness_ = options_.softness;
  scale_ = 0.0;
  b_.assign(n, 0.0);
  f_.assign(n, 0.0);
  for (int i = 0; i < problem.size(); ++i) {
    scale_ = std::max(scale_, std::abs(problem.b[i]));
    if (rows_.length(i) > 0.0) b_[idx(i)] = problem.b[i] / rows_.length(i);
    if (!warm) continue;
    require::finite(result.f[idx(i)], "result.f, the forces to begin with");
    const double f = rows_.length(i) * result.f[idx(i)];
    f_[idx(i)] = is_equality(problem, i) ? f : std::max(0.0, f);
  }
  if (scale_ == 0.0) scale_ = 1.0;

  guess_ = !start.empty();
  factored_is_known_ = false;
  pushes_.assign(n, 0);
  for (const int i : start) pushes_[idx(i)] = 1;
  for (std::vector<double>* v : {&a_, &sag_, &sag_rate_, &change_}) v->resize(n);
  for (std::vector<Vec6>* v : {&moved_, &step_, &imbalance_}) v->resize(idx(rows_.blocks()));
  kinks_.reserve(n);
}

// Whether b alone is right where no force changes anything.
bool AugmentedLagrangianSolver::immovable_rows_hold(const LcpProblem& problem) const {
  const double allowed = tolerance::complementarity * scale_;
  for (int i = 0; i < problem.size(); ++i) {
    if (rows_.length(i) > 0.0) continue;
    const double b = problem.b[i];
    if (b < -allowed || (is_equality(problem, i) && b > allowed)) return false;
  }
  return true;
}

// [S2.6.2:multipliers]
// Round after round. One that gains less than a digit meets contacts that hardly differ: their springs
// have to be harder.
LcpStatus AugmentedLagrangianSolver::raise_preloads(const LcpProblem& problem,
                                                    int& factorisations) {
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0;; ++round) {
    find_accelerations();
    const double now = residual(problem);
    if (now <= options_.residual) return LcpStatus::solved;
    if (round > 0 && contradiction(problem)) return LcpStatus::infeasible;
    if (!(now <= tolerance::slow_round * before)) {
      if (only_rounding_is_left(problem)) return LcpStatus::solved;
      if (softness_ > tolerance::least_softness) {
        softness_ = std::max(tolerance::hardening * softness_, tolerance::least_softness);
        factored_is_known_ = false;
      }
    }
    before = now;
    if (round == options_.rounds ||
        !settle(problem, tolerance::balance * now * scale_, factorisations))
      return LcpStatus::cap_reached;
  }
}
// [S2.6.2:multipliers]

// a = Gᵀ G f + b
void AugmentedLagrangianSolver::find_accelerations() {
  rows_.gather(f_, imbalance_);
  rows_.project(imbalance_, a_);
  for (std::size_t i = 0; i < a_.size(); ++i) a_[i] += b_[i];
  multiplications_ += 2 * rows_.multiplications();
}

// What has to be 0.
double AugmentedLagrangianSolver::wrong(const LcpProblem& problem, int row) const {
  return std::abs(is_equality(problem, row) ? a_[idx(row)] : std::min(f_[idx(row)], a_[idx(row)]));
}

// As lcp_residual(), with A_ii = ℓ_i².
double AugmentedLagrangianSolver::residual(const LcpProblem& problem) const {
  double worst = 0.0;
  for (int i = 0; i < problem.size(); ++i) {
    const double here = rows_.length(i) * wrong(problem, i);
    if (!(here <= worst)) worst = here;
    if (std::isnan(worst)) break;  // the next row would hide it
  }
  return worst / scale_;
}

// Whether each row is as right as sums of these forces can be.
bool AugmentedLagrangianSolver::only_rounding_is_left(const LcpProblem& problem) {
  const std::vector<int>& begin = rows_.begin_of_rows();
  const std::vector<int>& block = rows_.blocks_of_rows();
  load_.assign(idx(rows_.blocks()), 0.0);
  for (std::size_t i = 0; i < f_.size(); ++i)
    for (int p = begin[i]; p < begin[i + 1]; ++p)
      load_[idx(block[idx(p)])] += std::abs(f_[i]) * rows_.parts()[idx(p)].norm();
  for (int i = 0; i < problem.size(); ++i) {
    double sizes = std::abs(b_[idx(i)]);
    for (int p = begin[idx(i)]; p < begin[idx(i) + 1]; ++p)
      sizes += load_[idx(block[idx(p)])] * rows_.parts()[idx(p)].norm();
    if (!(wrong(problem, i) <= tolerance::rounding * sizes)) return false;
  }
  return true;
}

// Whether the last round's growth r of the forces proves that there is no solution. With r >= 0, any z
// that obeys the contacts has r·(Gᵀ z + b) >= 0, so it is at least as long as -b·r / |G r|; for
// contradicting contacts r tends to G r = 0 and -b·r > 0.
bool AugmentedLagrangianSolver::contradiction(const LcpProblem& problem) {
  double gain = 0.0;
  double sizes = 0.0;
  double farthest = 0.0;  // how long z has to be for the worst contact alone
  for (int i = 0; i < problem.size(); ++i) {
    double& r = change_[idx(i)];
    if (!is_equality(problem, i)) r = std::max(0.0, r);
    gain -= b_[idx(i)] * r;
    sizes += std::abs(b_[idx(i)] * r);
    farthest = std::max(farthest, is_equality(problem, i) ? std::abs(b_[idx(i)]) : -b_[idx(i)]);
  }
  if (gain <= tolerance::rounding * sizes) return false;
  rows_.gather(change_, imbalance_);
  multiplications_ += 2 * problem.size() + rows_.multiplications();
  return gain * tolerance::contradiction > std::sqrt(dot(imbalance_, imbalance_)) * farthest;
}

// Lets the bodies move until they are in balance with the springs, or as good as; then takes over
// the springs' forces. Returns false at the cap, which holds for steps too.
bool AugmentedLagrangianSolver::settle(const LcpProblem& problem, double enough,
                                       int& factorisations) {
  std::fill(moved_.begin(), moved_.end(), Vec6(Vec6::Zero()));
  std::fill(sag_.begin(), sag_.end(), 0.0);
  // In numbers too far apart for sums, steps with factors that are known may change nothing for ever.
  int steps = 0;
  for (bool full = false;;) {
    if (steps++ > options_.factorisations) return false;
    const bool guessed = guess_;
    guess_ = false;
    load_springs(problem, !guessed);

    // A full step within one parabola has found its minimum.
    const bool known = factored_is_known_ && pushes_ == factored_;
    if (full && known) break;
    if (find_imbalance() <= enough && !guessed) break;
    if (!known) {
      if (factorisations == options_.factorisations) return false;
      ++factorisations;
      factored_ = pushes_;
      cholesky_.factor(rows_, factored_, softness_);
      factored_is_known_ = true;
    }
    for (std::size_t k = 0; k < step_.size(); ++k) step_[k] = -softness_ * imbalance_[k];
    cholesky_.solve(step_);
    rows_.project(step_, sag_rate_);

    // A guess says where to begin, be the energy there lower or not.
    full = true;
    const double t = guessed ? 1.0 : length_of_step(problem, full);
    for (std::size_t k = 0; k < moved_.size(); ++k) moved_[k] += t * step_[k];
    for (std::size_t i = 0; i < sag_.size(); ++i) sag_[i] += t * sag_rate_[i];
    multiplications_ += rows_.multiplications() + 12 * rows_.blocks() + problem.size();
  }
  for (std::size_t i = 0; i < f_.size(); ++i) f_[i] += change_[i];
  return true;
}

// How much the springs push beyond their preloads, and which of them do push. The difference is
// computed as such, because it gets small while the forces do not.
void AugmentedLagrangianSolver::load_springs(const LcpProblem& problem, bool choose_set) {
  for (int i = 0; i < problem.size(); ++i) {
    const double change = -(a_[idx(i)] + sag_[idx(i)]) / softness_;
    if (choose_set) pushes_[idx(i)] = is_equality(problem, i) || change >= -f_[idx(i)] ? 1 : 0;
    change_[idx(i)] = pushes_[idx(i)] != 0 ? change : -f_[idx(i)];
  }
  multiplications_ += problem.size();
}

// The gradient d - G (change of f); its largest entry.
double AugmentedLagrangianSolver::find_imbalance() {
  rows_.gather(change_, imbalance_);
  multiplications_ += rows_.multiplications();
  double largest = 0.0;
  for (std::size_t k = 0; k < imbalance_.size(); ++k) {
    imbalance_[k] = moved_[k] - imbalance_[k];
    largest = std::max(largest, imbalance_[k].cwiseAbs().maxCoeff());
  }
  return largest;
}

// The t at which the energy along d + t p is least. Its slope is value + t rate, rising, with a kink
// where a spring comes to push or ceases to; kinks are passed in their order while the slope is negative.
double AugmentedLagrangianSolver::length_of_step(const LcpProblem& problem, bool& full) {
  double value = dot(step_, moved_);
  double rate = dot(step_, step_);
  kinks_.clear();
  for (int i = 0; i < problem.size(); ++i) {
    const double q = sag_rate_[idx(i)];
    const bool pushes = pushes_[idx(i)] != 0;
    value -= q * change_[idx(i)];
    if (pushes) rate += q * q / softness_;
    if (!is_equality(problem, i) && (pushes ? q > 0.0 : q < 0.0))
      kinks_.push_back({(softness_ * f_[idx(i)] - a_[idx(i)] - sag_[idx(i)]) / q, i});
  }
  multiplications_ += 12 * rows_.blocks() + 5 * problem.size();

  const auto later = [](const Kink& x, const Kink& y) {
    return x.t > y.t || (x.t == y.t && x.row > y.row);
  };
  std::make_heap(kinks_.begin(), kinks_.end(), later);
  while (!kinks_.empty() && value + kinks_.front().t * rate < 0.0) {
    const Kink kink = kinks_.front();
    std::pop_heap(kinks_.begin(), kinks_.end(), later);
    kinks_.pop_back();
    const double q = sag_rate_[idx(kink.row)];
    const double change = (pushes_[idx(kink.row)] != 0 ? -q : q) * q / softness_;
    rate += change;
    value -= change * kink.t;
    multiplications_ += 4;
    full = false;
  }
  return full ? 1.0 : -value / rate;
}

}  // namespace tumble
