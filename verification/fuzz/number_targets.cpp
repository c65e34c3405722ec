/// \file
/// \brief Fuzz targets for numbers: pairs of boxes, random worlds, complementarity problems.
#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/base/random.hpp"
#include "tumble/geometry/manifold.hpp"
#include "tumble/geometry/signed_distance.hpp"
#include "tumble/techniques.hpp"

#include "fuzz/judged_answer.hpp"
#include "fuzz/random_world.hpp"
#include "fuzz/targets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace tumble::fuzz {
namespace {

// --- boxes ------------------------------------------------------------------------------------------

constexpr double kBoundOfPoints = 1e-6;  // [longest edge] beyond the margin and half the overlap

struct Pair {
  Box first, second;
  double longest = 0.0;  // [m] edge of both
  bool nearly_aligned = true;
};

Quat turned(ByteReader& in, double angle) {
  Vec3 axis;
  for (Eigen::Index i = 0; i < 3; ++i) axis[i] = in.uniform(-1.0, 1.0);
  if (axis.norm() < 0.1) axis = Vec3::UnitY();
  return Quat(Eigen::AngleAxisd(angle, axis.normalized()));
}

// 0: aligned; 1: turned by 1e-12 to 0.1 rad; 2: by anything up to half a turn.
double relative_angle(ByteReader& in, int kind) {
  if (kind == 0) return 0.0;
  return kind == 1 ? in.power_of_ten(-12.0, -1.0) : in.uniform(0.0, 3.14159);
}

// Along one axis: anywhere within reach, or nearly touching.
double offset(ByteReader& in, double reach, double shortest) {
  const std::uint8_t kind = in.byte();
  if (kind % 4 == 0) return in.uniform(-reach, reach);
  if (kind % 4 == 1) return (kind & 8U) != 0U ? reach : -reach;
  const double gap = shortest * in.power_of_ten(-12.0, -1.0);
  const double out = kind % 4 == 2 ? reach - gap : reach + gap;
  return (kind & 8U) != 0U ? out : -out;
}

Pair pair_of(ByteReader& in) {
  const int kind = in.byte() % 3;
  Vec3 size_a, size_b, apart;
  for (Eigen::Index i = 0; i < 3; ++i) {
    size_a[i] = in.power_of_ten(-3.0, 3.0);
    size_b[i] = in.power_of_ten(-3.0, 3.0);
  }
  const double shortest = std::min(size_a.minCoeff(), size_b.minCoeff());
  const Quat whole = turned(in, in.byte() % 2 == 0 ? 0.0 : in.uniform(0.0, 3.14159));
  const Quat turn = turned(in, relative_angle(in, kind));
  for (Eigen::Index i = 0; i < 3; ++i)
    apart[i] = offset(in, 0.5 * (size_a[i] + size_b[i]), shortest);
  Pair pair;
  pair.first = make_box(Vec3::Zero(), whole, size_a);
  pair.second = make_box(whole * apart, (whole * turn).normalized(), size_b);
  pair.longest = std::max(size_a.maxCoeff(), size_b.maxCoeff());
  pair.nearly_aligned = kind != 2;
  return pair;
}

// How far apart the boxes are along a direction.
double along(const Pair& pair, const Vec3& normal_w) {
  return (pair.second.center_w - pair.first.center_w).dot(normal_w) - reach(pair.first, normal_w) -
         reach(pair.second, normal_w);
}

void require_points(const Pair& pair, const Manifold& found, double margin) {
  const double rounding = 1e-9 * pair.longest;
  const double least = along(pair, found.normal_w);
  promise(found.count <= Manifold::kMostPoints, "count = " + std::to_string(found.count));
  for (int i = 0; i < found.count; ++i) {
    const ManifoldPoint& point = found.points[idx(i)];
    const std::string name = "point " + std::to_string(i);
    promise(point.position_w.allFinite(), name + " is not finite");
    promise(point.distance >= least - rounding && point.distance <= margin + rounding,
            name + ": distance = " + shortest_text(point.distance) + ", from " +
                shortest_text(least) + " to " + shortest_text(margin));
    if (!pair.nearly_aligned) continue;  // no bound is stated for boxes turned anyhow
    const double off = std::max(signed_distance(pair.first, point.position_w).distance,
                                signed_distance(pair.second, point.position_w).distance);
    const double allowed = margin + 0.5 * std::max(-point.distance, 0.0);
    promise(off <= allowed + kBoundOfPoints * pair.longest,
            name + ": " + shortest_text(off) + " m off a box, allowed " + shortest_text(allowed));
  }
}

// --- worlds -----------------------------------------------------------------------------------------

// The slowest two would take most of the time.
int steps_of(std::string_view technique) {
  return technique == "analytic" || technique == "microcollisions" ? 5 : 20;
}

// --- complementarity --------------------------------------------------------------------------------

// A = J Jᵀ in rows of various units, f and a = A f + b known, and one of them 0 in each row.
LcpProblem known_problem(ByteReader& in) {
  Random chance(in.seed());
  const int n = 1 + in.byte() % 10;
  const int rank = 1 + in.byte() % 10;
  const std::uint8_t units = in.byte();
  const double decades =
      units < 224 ? 0.5 * (units % 7) : 2.0 * (units - 224);  // of the units of rows
  const bool equalities = in.byte() % 2 == 1;
  MatX J(n, rank);
  for (int i = 0; i < n; ++i) {
    const double unit = std::pow(10.0, chance.uniform(-decades, decades));
    for (int k = 0; k < rank; ++k) J(i, k) = unit * chance.uniform(-1.0, 1.0);
  }
  LcpProblem problem{MatX::Zero(n, n), VecX::Zero(n), {}};
  if (equalities) problem.equality.assign(idx(n), 0);
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) problem.A(i, k) = J.row(i).dot(J.row(k));
  VecX f = VecX::Zero(n), a = VecX::Zero(n);
  for (int i = 0; i < n; ++i) {
    const double size = chance.unit();
    const double kind = chance.unit();
    if (equalities && kind < 0.3) {
      problem.equality[idx(i)] = 1;
      f[i] = 2.0 * size - 1.0;
    } else if (kind < 0.65) {
      f[i] = size;
    } else {
      a[i] = size * problem.A(i, i);
    }
  }
  for (int i = 0; i < n; ++i) problem.b[i] = a[i] - problem.A.row(i).dot(f);
  return problem;
}

}  // namespace

void fuzz_boxes(Bytes bytes) {
  ByteReader in(bytes);
  const Pair pair = pair_of(in);
  const double shortest = 2.0 * std::min(pair.first.half.minCoeff(), pair.second.half.minCoeff());
  const double margin = in.byte() % 4 == 0 ? 0.0 : shortest * in.power_of_ten(-6.0, -1.0);
  SeparationOptions all;
  all.prefer_faces = false;
  all.enough = std::numeric_limits<double>::infinity();
  const Separation exact = separation(pair.first, pair.second, all);
  promise(std::isfinite(exact.distance), "distance = " + shortest_text(exact.distance));
  Manifold found;
  const bool touches = collide(pair.first, pair.second, margin, kNoAxis, found);
  promise(std::abs(found.normal_w.norm() - 1.0) < 1e-12,
          "length of the normal = " + shortest_text(found.normal_w.norm()));
  promise(touches == (found.count > 0), "count = " + std::to_string(found.count));
  const double rounding = 1e-12 * pair.longest;
  promise(touches || exact.distance > -rounding,
          "no point, at a distance of " + shortest_text(exact.distance));
  promise(!touches || exact.distance <= margin + rounding, "touches at a distance of " +
                                                               shortest_text(exact.distance) +
                                                               ", margin " + shortest_text(margin));
  require_points(pair, found, margin);
}

void fuzz_world(Bytes bytes) {
  ByteReader in(bytes);
  const std::vector<TechniqueRecipe>& all = technique_library();
  const WorldPromise kept = promise_of(all[in.byte() % all.size()].name);
  const std::uint64_t seed = in.seed();
  const std::string what =
      std::string(kept.technique) + ", random world " + std::to_string(seed) + ": ";
  const WorldVerdict verdict =
      judge(random_world(seed), kept.technique, {}, steps_of(kept.technique));
  promise(verdict.thrown.empty(), what + verdict.thrown);
  promise(verdict.finite, what + "a step that is done, with a state that is not finite");
  promise(verdict.momentum_change <= kept.momentum,
          what + "momentum changed by " + shortest_text(verdict.momentum_change));
  promise(verdict.unbooked_rise <= kept.unbooked,
          what + "energy rose unbooked by " + shortest_text(verdict.unbooked_rise));
  promise(verdict.overlap <= kept.overlap, what + "at the end a body is in another one by " +
                                               shortest_text(verdict.overlap) + " of its edge");
}

void fuzz_complementarity(Bytes bytes) {
  ByteReader in(bytes);
  require_honest_solvers(known_problem(in));
}

}  // namespace tumble::fuzz
