/// \file
/// \brief Contact forces that push but never pull: the linear complementarity problem.
#include "tumble/math/complementarity.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/math/complementarity_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::int64_t count(const std::vector<int>& indices) {
  return static_cast<std::int64_t>(indices.size());
}

double largest(const VecRef& b) {
  double size = 0.0;
  for (int i = 0; i < b.size(); ++i) size = std::max(size, std::abs(b[i]));
  return size;
}

// An exchange of dependent contacts is worth its work if it is with twice the force at least.
constexpr double worthwhile = 2.0;

}  // namespace

// How far the driven force may grow, and which contact then changes places; -1: none ever does.
struct ComplementaritySolver::Step {
  double length = infinity;
  int contact = -1;
};

// How contacts in C answer a unit force at another one; their forces are in subset_.
struct ComplementaritySolver::Answer {
  double root;   // √A_jj of that contact
  double schur;  // what the force changes at its own contact
  double size;   // Σ |force_i| √A_ii, the unit force included

  // What may be rounding: of the sums that lead to it, and of A itself, which v·A v sees through v.
  [[nodiscard]] double least_schur() const {
    return tolerance::dependent * root * root + tolerance::matrix_rounding * size * size;
  }
  [[nodiscard]] bool independent() const { return schur > least_schur(); }
};

void ComplementaritySolver::solve(const MatRef& A, const VecRef& b, ComplementarityResult& result,
                                  std::span<const int> start) {
  const bool plausible = may_be_semidefinite(A, b);
  const int n = static_cast<int>(b.size());
  multiplications_ = 0;
  exchanges_ = 0;
  begin(A, b, start);
  result.status = ComplementarityStatus::solved;
  result.pivots = 0;
  result.ray.clear();
  result.ray.reserve(idx(n));
  result.pushing.reserve(idx(n));
  result.f.assign(idx(n), 0.0);
  settle(A, b, result);
  if (!plausible) result.status = ComplementarityStatus::not_positive_semidefinite;

  // While some contact sinks, drive it. Forces are computed afresh from the set of pushing contacts
  // after each drive: rounding does not pile up, and nothing has to be clamped (3.3.1).
  while (result.status == ComplementarityStatus::solved) {
    int d = 0;
    while (d < n && (result.a[idx(d)] >= -slack_ || place_[idx(d)] == Place::left_out)) ++d;
    if (d == n) break;
    if (drive_to_zero(A, b, d, result)) settle(A, b, result);
  }

  result.pushing.assign(factor_.indices().begin(), factor_.indices().end());
  std::sort(result.pushing.begin(), result.pushing.end());
  result.residual = complementarity_residual(A, b, view(result.f));
  result.multiplications = multiplications_;
}

// Makes room, and puts the contacts of the warm start among the pushing ones.
void ComplementaritySolver::begin(const MatRef& A, const VecRef& b, std::span<const int> start) {
  const int n = static_cast<int>(b.size());
  factor_.clear(n);
  place_.assign(idx(n), Place::parted);
  df_.resize(idx(n));
  da_.resize(idx(n));
  subset_.reserve(idx(n));
  root_.resize(idx(n));
  for (int i = 0; i < n; ++i) root_[idx(i)] = std::sqrt(std::abs(A(i, i)));

  start_.reserve(idx(n));
  start_.assign(start.begin(), start.end());
  for (auto j = start_.begin(); j != start_.end(); ++j) {
    require::that(*j >= 0 && *j < n, "start: expected indices from 0 to n - 1");
    require::that(std::find(start_.begin(), j, *j) == j, "start: expected each index once");
    change_place(A, *j);
  }
}

// Forces and accelerations that belong to the set of pushing contacts: A_CC f_C = -b_C. Where some of
// them would have to pull, f goes towards them as far as it can without, the contact that ends the
// way leaves the set, and so on. On this way f·A f / 2 + b·f only falls, as it does in drives, so no
// set comes back. After a drive a pull is rounding; after a start whose forces are 0 it is not.
void ComplementaritySolver::settle(const MatRef& A, const VecRef& b,
                                   ComplementarityResult& result) {
  const std::vector<int>& pushing = factor_.indices();
  while (true) {
    subset_.clear();
    for (const int c : pushing) subset_.push_back(-b[c]);
    factor_.solve(subset_);
    multiplications_ += count(pushing) * (count(pushing) + 1);

    double share = infinity;
    int first = -1;
    for (int k = 0; k < static_cast<int>(pushing.size()); ++k) {
      const double wanted = subset_[idx(k)];
      if (wanted >= 0.0) continue;
      const double f = result.f[idx(pushing[idx(k)])];
      const double way = f / (f - wanted);
      if (way > share || (way == share && wanted >= subset_[idx(first)])) continue;
      share = way;
      first = k;
    }
    if (first < 0) break;
    for (int k = 0; k < static_cast<int>(pushing.size()); ++k) {
      double& f = result.f[idx(pushing[idx(k)])];
      f = k == first ? 0.0 : f + share * (subset_[idx(k)] - f);
    }
    multiplications_ += 2 * count(pushing);
    change_place(A, pushing[idx(first)]);
    ++result.pivots;
  }

  multiplications_ += 2 * std::int64_t{b.size()} * count(pushing);  // a, and its terms
  result.f.assign(place_.size(), 0.0);
  result.a.assign(b.data(), b.data() + b.size());
  std::fill(da_.begin(), da_.end(), 0.0);  // here: how large the terms of each a are
  for (std::size_t k = 0; k < subset_.size(); ++k) {
    const int c = pushing[k];
    result.f[idx(c)] = subset_[k];
    add_column(subset_[k], A, c, result.a);
    for (int i = 0; i < b.size(); ++i) da_[idx(i)] += std::abs(A(i, c)) * subset_[k];
  }

  // Heavy bodies on light ones have terms far larger than b; a is no better than their rounding.
  const double terms = da_.empty() ? 0.0 : *std::max_element(da_.begin(), da_.end());
  unsure_ = tolerance::dependent_sinking * largest(b) + tolerance::rounding * terms;
  slack_ = tolerance::complementarity * largest(b) + tolerance::rounding * terms;
}

// Lets the force at a sinking contact d grow until d stops sinking. Returns false, with the status
// set, if that does not happen.
bool ComplementaritySolver::drive_to_zero(const MatRef& A, const VecRef& b, int d,
                                          ComplementarityResult& result) {
  const int n = static_cast<int>(place_.size());
  const int cap = pivots_each_ * (n + 1);
  const std::vector<int>& pushing = factor_.indices();
  int newest = -1;  // the one that began to push in the last step, if any did
  while (result.pivots < cap) {
    // A unit force at d, and the forces of C that keep C neither sinking nor separating:
    // df_d = 1, df_C = -A_CC^{-1} A_Cd, da = A df. At d itself da_d is the Schur complement, and if
    // that is 0, so is all of da.
    const Answer answer = answer_to(A, d);
    if (answer.schur < -answer.least_schur()) {
      result.status = ComplementarityStatus::not_positive_semidefinite;
      return false;
    }
    std::fill(df_.begin(), df_.end(), 0.0);
    std::fill(da_.begin(), da_.end(), 0.0);
    df_[idx(d)] = 1.0;
    for (std::size_t k = 0; k < subset_.size(); ++k) df_[idx(pushing[k])] = subset_[k];
    if (answer.independent()) {
      multiplications_ += (count(pushing) + 2) * n;  // da, f and a
      for (std::size_t k = 0; k <= pushing.size(); ++k) {
        const int i = k == 0 ? d : pushing[k - 1];
        add_column(df_[idx(i)], A, i, da_);
      }
    }

    // If d depends on C, no acceleration changes, and d sinks unless a contact of C gives way to it. Or
    // it only seems to sink, by rounding. Then the exchange is done where it makes C less dependent,
    // as it multiplies the determinant of A_CC by df_j² A_jj / A_dd, in units of its own diagonal. Else
    // d comes to rest together with the newest one of C, whose place it takes as it has a force; and
    // before it has one, it is left to the forces of C.
    const Step step = longest_step(d, answer, result);
    if (!answer.independent()) {
      const int j = step.contact;
      if (sinks_with_pushing(b)) {
        if (j < 0) {
          result.status = ComplementarityStatus::infeasible;
          result.ray.assign(df_.begin(), df_.end());
          return false;
        }
      } else if (j < 0 || exchanges_ >= n ||
                 -df_[idx(j)] * root_[idx(j)] < worthwhile * answer.root) {
        if (newest >= 0) change_place(A, newest);
        change_place(A, d);
        return true;
      } else {
        ++exchanges_;
      }
    }
    for (int i = 0; i < n; ++i) {
      result.f[idx(i)] += step.length * df_[idx(i)];
      result.a[idx(i)] += step.length * da_[idx(i)];
    }
    // The one that ended the step stands at f = 0 = a exactly, or at a = 0 if it is d.
    const int j = step.contact;
    result.a[idx(j)] = 0.0;
    if (place_[idx(j)] == Place::pushing) result.f[idx(j)] = 0.0;
    change_place(A, j);
    ++result.pivots;
    if (j == d) return true;
    newest = place_[idx(j)] == Place::pushing ? j : -1;
  }
  result.status = ComplementarityStatus::cap_reached;
  return false;
}

// If d depends on C, a_d = b·df whatever the forces. Where b comes from bodies that is 0 but for
// rounding.
bool ComplementaritySolver::sinks_with_pushing(const VecRef& b) const {
  double sinking = 0.0;
  double sizes = 0.0;
  for (int i = 0; i < b.size(); ++i) {
    sinking += b[i] * df_[idx(i)];
    sizes += std::abs(df_[idx(i)]);
  }
  return sinking < -unsure_ * sizes;
}

// The first of these to happen: d stops sinking, a pushing contact has no force left, a parted
// one would start to sink. Contacts that sank already when the drive began are not looked at, and
// d comes before those that would end the step when it has all but stopped. Of a d that depends on C
// only forces are changed.
ComplementaritySolver::Step ComplementaritySolver::longest_step(
    int d, const Answer& answer, const ComplementarityResult& result) const {
  Step step;
  double limit = infinity;
  if (answer.independent()) {
    step = {-result.a[idx(d)] / answer.schur, d};
    limit = (-result.a[idx(d)] - slack_) / answer.schur;
  }

  const double least = tolerance::dependent * answer.size;
  for (int i = 0; i < static_cast<int>(place_.size()); ++i) {
    double length = infinity;
    if (place_[idx(i)] == Place::pushing) {
      if (df_[idx(i)] * root_[idx(i)] < -least) length = result.f[idx(i)] / -df_[idx(i)];
    } else if (place_[idx(i)] == Place::parted && i != d && result.a[idx(i)] >= -slack_) {
      if (da_[idx(i)] < -least * root_[idx(i)])
        length = std::max(0.0, result.a[idx(i)]) / -da_[idx(i)];
    }
    if (length < limit) {  // strictly: the lowest index of equal ones
      step = {length, i};
      limit = length;
    }
  }
  return step;
}

// A pushing contact parts. A parted one pushes, unless its row depends on the rows of C: then they
// carry it along, its acceleration is 0 with theirs, and it is left out until C changes.
void ComplementaritySolver::change_place(const MatRef& A, int j) {
  const std::vector<int>& pushing = factor_.indices();
  const bool leaves = place_[idx(j)] == Place::pushing;
  if (!leaves && !answer_to(A, j).independent()) {
    place_[idx(j)] = Place::left_out;
    return;
  }
  if (leaves) {
    const auto where = std::find(pushing.begin(), pushing.end(), j);
    factor_.remove(A, static_cast<int>(where - pushing.begin()));
    // Each row after it takes a triangular solve and its own length.
    for (auto k = where - pushing.begin(); k < count(pushing); ++k)
      multiplications_ += k * (k + 1) / 2 + k;
  } else {
    factor_.append_considered();
  }
  std::replace(place_.begin(), place_.end(), Place::left_out, Place::parted);
  place_[idx(j)] = leaves ? Place::parted : Place::pushing;
}

// How C answers a force 1 at j. With v = (1 at j, df_C) the Schur complement is v·A v.
ComplementaritySolver::Answer ComplementaritySolver::answer_to(const MatRef& A, int j) {
  const std::vector<int>& pushing = factor_.indices();
  Answer answer{root_[idx(j)], factor_.consider(A, j), root_[idx(j)]};
  subset_.resize(pushing.size());
  factor_.answer_to_considered(subset_);
  multiplications_ += count(pushing) * (count(pushing) + 3);  // two triangles, and two sums
  for (std::size_t k = 0; k < subset_.size(); ++k)
    answer.size += std::abs(subset_[k]) * root_[idx(pushing[k])];
  return answer;
}

}  // namespace tumble
