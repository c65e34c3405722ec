/// \file
/// \brief Unknowns with limits by steps down an energy, all of them at once (thesis 2.6.4).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace tumble {

/// How far ProjectedDescent came.
struct DescentReport {
  int iterations = 0;    ///< steps down
  int products = 0;      ///< multiplications by A, the work: one or two for each step
  double step = 0.0;     ///< length of the step that would be next, \f$\sqrt{s^{\mathsf T} D s}\f$
  bool settled = false;  ///< whether that is as small as was wanted
};

/// Looks for the p among those allowed that has the least energy \f$E = \tfrac12 p^{\mathsf T}\!A p + b^{\mathsf T} p\f$.
///
/// With r = A p + b and D the diagonal of A, the target of a step is the allowed point that is nearest to \f$p - D^{-1} r\f$: there
/// every unknown would be right if all others stayed. The way to it, s, together with that of the step before (a conjugate direction), is
/// followed to the least energy on it, and put back to the nearest allowed point. If the energy does not fall by that, the
/// way s alone is followed, no further than to its end, where all of it is allowed. So each step has values for all unknowns and
/// takes the same time, the energy falls with each, and it can be ended after any of them.
///
/// A problem has
/// - `size()`, the number of unknowns;
/// - `diagonal(i)` above 0 and `constant(i)`, those of A and b;
/// - `multiply(x, out)`, A x;
/// - `allow(p)`, which moves p to the nearest allowed point. If the limits depend on p, as with friction, the energy need not fall.
template <class Problem>
class ProjectedDescent {
 public:
  /// Steps down.
  /// \param p       where to start, allowed; and the answer
  /// \param wanted  length of a step that is small enough, at least 0
  /// \param budget  steps at most, at least 0
  DescentReport solve(Problem& problem, std::span<double> p, double wanted, int budget) {
    DescentReport report;
    prepare(problem, p, report);
    bool fresh = true;
    double before = 0.0;  // sᵀ D s
    for (;; ++report.iterations) {
      // [S2.6.4:step]
      // Each unknown looks for itself where it would be right.
      double now = 0.0, both = 0.0;
      for (std::size_t i = 0; i < p.size(); ++i)
        target_[i] = p[i] - residual_[i] / problem.diagonal(i);
      problem.allow(target_);
      for (std::size_t i = 0; i < p.size(); ++i) {
        const double s = target_[i] - p[i];
        now += problem.diagonal(i) * s * s;
        both += problem.diagonal(i) * s * (s - way_[i]);
        way_[i] = s;
      }
      report.step = std::sqrt(now);
      report.settled = report.step <= wanted;
      if (report.settled || report.iterations >= budget) return report;

      // All go on together, along a conjugate direction.
      const double share = fresh || !(before > 0.0) ? 0.0 : std::max(0.0, both / before);
      double slope = 0.0;
      for (std::size_t i = 0; i < p.size(); ++i) {
        direction_[i] = way_[i] + share * direction_[i];
        slope += residual_[i] * direction_[i];
      }
      before = now;
      fresh = !go_down(problem, p, slope, report);
      if (fresh) go_towards_target(problem, p, report);
      // [S2.6.4:step]
    }
  }

 private:
  void prepare(Problem& problem, std::span<const double> p, DescentReport& report) {
    for (std::vector<double>* all : {&residual_, &target_, &way_, &direction_, &moved_, &image_}) {
      all->resize(p.size());  // assign() would ask for memory whenever there is one unknown more
      std::fill(all->begin(), all->end(), 0.0);
    }
    if (std::any_of(p.begin(), p.end(), [](double x) { return x != 0.0; })) {
      problem.multiply(p, residual_);
      ++report.products;
    }
    for (std::size_t i = 0; i < p.size(); ++i) residual_[i] += problem.constant(i);
  }

  static double dot(std::span<const double> a, std::span<const double> b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  }

  // To the least energy along the direction, with the slope that it has at the start. Returns whether the energy falls once what is not allowed is put back;
  // if not, nothing has changed.
  bool go_down(Problem& problem, std::span<double> p, double slope, DescentReport& report) {
    if (!(slope < 0.0)) return false;
    problem.multiply(direction_, image_);
    ++report.products;
    const double curvature = dot(direction_, image_);
    if (!(curvature > 0.0)) return false;
    const double t = -slope / curvature;
    for (std::size_t i = 0; i < p.size(); ++i) target_[i] = moved_[i] = p[i] + t * direction_[i];
    problem.allow(target_);
    if (std::equal(target_.begin(), target_.end(), moved_.begin())) {
      for (double& x : image_) x *= t;
      take(p);
      return true;
    }
    for (std::size_t i = 0; i < p.size(); ++i) moved_[i] = target_[i] - p[i];
    problem.multiply(moved_, image_);
    ++report.products;
    double first_order = 0.0, second_order = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      first_order += residual_[i] * moved_[i];
      second_order += moved_[i] * image_[i];
    }
    if (!(first_order + 0.5 * second_order < 0.0)) return false;
    take(p);
    return true;
  }

  // The same along the way that is allowed to its end.
  void go_towards_target(Problem& problem, std::span<double> p, DescentReport& report) {
    problem.multiply(way_, image_);
    ++report.products;
    double slope = 0.0, curvature = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      slope += residual_[i] * way_[i];
      curvature += way_[i] * image_[i];
    }
    // Without friction the slope is below 0.
    const double t = slope < 0.0 && curvature > -slope ? -slope / curvature : 1.0;
    for (std::size_t i = 0; i < p.size(); ++i) target_[i] = p[i] + t * way_[i];
    for (double& x : image_) x *= t;
    take(p);
  }

  // Goes to the target; `image_` is A times the way there.
  void take(std::span<double> p) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      p[i] = target_[i];
      residual_[i] += image_[i];
    }
  }

  std::vector<double> residual_, target_, way_, direction_, moved_, image_;
};

}  // namespace tumble
