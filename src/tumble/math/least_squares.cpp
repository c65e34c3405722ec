/// \file
/// \brief Least squares with forces that cannot pull: the nearest point of a cone.
#include "tumble/math/least_squares.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

double length_of(const VecRef& v) {
  double square = 0.0;
  for (int i = 0; i < v.size(); ++i) square += v[i] * v[i];
  return std::sqrt(square);
}

void check(const MatRef& G, const VecRef& d) {
  require::that(d.size() == G.rows(), "d: expected as many entries as G has rows");
  for (int i = 0; i < d.size(); ++i) require::finite(d[i], "d");
  for (int j = 0; j < G.cols(); ++j)
    for (int i = 0; i < G.rows(); ++i) require::finite(G(i, j), "G");
}

}  // namespace

void NonNegativeLeastSquares::solve(const MatRef& G, const VecRef& d, LeastSquaresResult& result,
                                    std::span<const int> start) {
  check(G, d);
  const int n = static_cast<int>(G.cols());
  const int cap = 50 * n + 50;
  begin(G, start);
  size_of_target_ = length_of(d);
  result.status = ComplementarityStatus::solved;
  result.pivots = 0;
  result.multiplications = std::int64_t{n} * G.rows();  // the lengths of the columns
  result.pushing.reserve(idx(n));
  result.f.assign(idx(n), 0.0);

  // A start may ask for negative factors. Taken from f = 0, the way to them leads nowhere: columns
  // with such factors are dropped at once.
  descend(G, d, result);
  mark(-1);
  while (true) {
    update_rest(G, d, result);
    const int j = steepest(G, result);
    // The rest takes the columns in use and a length, the slopes at most all the others.
    result.multiplications += std::int64_t{n + 1} * G.rows();
    if (j < 0) break;
    if (result.pivots >= cap) {
      result.status = ComplementarityStatus::cap_reached;
      break;
    }

    // A column that depends on those in use, or is dropped again at once, had a slope of rounding
    // only: it is of no use until another one has come to stay.
    if (factor_.append(G, j)) {
      ++result.pivots;
      descend(G, d, result);
    }
    mark(j);
  }

  result.pushing.assign(factor_.indices().begin(), factor_.indices().end());
  std::sort(result.pushing.begin(), result.pushing.end());
  result.multiplications += factor_.multiplications();
}

// Makes room, and puts the columns of the warm start to use.
void NonNegativeLeastSquares::begin(const MatRef& G, std::span<const int> start) {
  const int n = static_cast<int>(G.cols());
  factor_.clear(static_cast<int>(G.rows()), n);
  columns_.assign(idx(n), Column::free);
  target_.reserve(idx(n));
  length_.resize(idx(n));
  for (int j = 0; j < n; ++j) length_[idx(j)] = length_of(G.col(j));

  start_.reserve(idx(n));
  start_.assign(start.begin(), start.end());
  for (const int j : start_) {
    require::that(j >= 0 && j < n, "start: expected indices from 0 to n - 1");
    require::that(columns_[idx(j)] == Column::free, "start: expected each index once");
    columns_[idx(j)] = Column::used;
    factor_.append(G, j);
  }
}

// Notes which columns are in use, and whether the one just tried is not; -1 after the start.
void NonNegativeLeastSquares::mark(int tried) {
  const std::vector<int>& used = factor_.indices();
  const bool stays = tried < 0 || std::find(used.begin(), used.end(), tried) != used.end();
  for (Column& column : columns_)
    if (stays || column == Column::used) column = Column::free;
  for (const int j : used) columns_[idx(j)] = Column::used;
  if (!stays) columns_[idx(tried)] = Column::useless;
}

// The column along which the distance shrinks fastest, by the cosine of its angle to the rest; -1
// if none shrinks it, and then f is the answer (the conditions of Karush, Kuhn and Tucker).
int NonNegativeLeastSquares::steepest(const MatRef& G, const LeastSquaresResult& result) const {
  int best = -1;
  double best_slope = tolerance::complementarity * size_of_target_;
  for (int j = 0; j < static_cast<int>(columns_.size()); ++j) {
    if (columns_[idx(j)] != Column::free || length_[idx(j)] == 0.0) continue;
    double slope = 0.0;
    for (int i = 0; i < G.rows(); ++i) slope += G(i, j) * result.rest[idx(i)];
    slope /= length_[idx(j)];
    if (slope > best_slope) {
      best_slope = slope;
      best = j;
    }
  }
  return best;
}

// Goes from f towards the best factors for the columns in use. Where one would become negative, it
// stops, drops the columns that stand at 0, and sets out again: the distance only shrinks.
void NonNegativeLeastSquares::descend(const MatRef& G, const VecRef& d,
                                      LeastSquaresResult& result) {
  const std::vector<int>& used = factor_.indices();
  while (true) {
    target_.resize(used.size());
    factor_.solve(d, target_);

    double part = 1.0;  // how much of the way all factors stay >= 0
    int blocking = -1;
    for (std::size_t k = 0; k < used.size(); ++k) {
      if (target_[k] > 0.0) continue;
      const double f = result.f[idx(used[k])];
      const double reach = f > 0.0 ? f / (f - target_[k]) : 0.0;
      if (blocking >= 0 && reach >= part) continue;
      part = reach;
      blocking = static_cast<int>(k);
    }
    for (std::size_t k = 0; k < used.size(); ++k) {
      double& f = result.f[idx(used[k])];
      f = blocking < 0 ? target_[k] : std::max(0.0, f + part * (target_[k] - f));
    }
    if (blocking < 0) return;
    result.f[idx(used[idx(blocking)])] = 0.0;
    factor_.remove(G, blocking);
    ++result.pivots;
  }
}

void NonNegativeLeastSquares::update_rest(const MatRef& G, const VecRef& d,
                                          LeastSquaresResult& result) const {
  result.rest.assign(d.data(), d.data() + d.size());
  for (const int j : factor_.indices()) add_column(-result.f[idx(j)], G, j, result.rest);
  result.distance = length_of(view(result.rest));
}

}  // namespace tumble
