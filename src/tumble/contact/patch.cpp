/// \file
/// \brief Pressure and friction of a contact area: all points of one contact together.
#include "tumble/contact/patch.hpp"

#include "tumble/contact/tolerances.hpp"

#include <algorithm>
#include <array>

namespace tumble {
namespace {

// How many times longer than the safe step one may be. The safe one adds up the points of a contact
// area and of all others, so that a good one is longer by about their number; far beyond that it is
// only the quotient of two rounding errors.
constexpr double kLongestStep = 1000.0;

// Sum of the normal impulses [N s] and where it acts.
struct Pressure {
  double force = 0.0;
  Vec3 center_w = Vec3::Zero();
};

Pressure pressure_of(std::span<const PatchPoint> points) {
  Pressure p;
  for (const PatchPoint& point : points) {
    p.force += point.normal_impulse;
    p.center_w += point.normal_impulse * point.position_w;
  }
  if (p.force > 0.0) p.center_w /= p.force;
  return p;
}

// even_out() of at most so many points with a force.
template <int kRows>
void even_out_rows(const Vec3& normal_w, const Pressure& pressure, std::span<PatchPoint> points) {
  using Column = Eigen::Matrix<double, kRows, 1>;
  const std::size_t count = points.size();

  // Places in the contact plane from the centre of pressure, in units of the widest: the columns of
  // G are 1, x, y. Wanted: j = max(0, G λ) with G' j = (F, 0, 0).
  const Tangents t = tangents_of(normal_w);
  std::array<Column, 3> g = {Column::Zero(), Column::Zero(), Column::Zero()};
  double widest = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 arm = points[i].position_w - pressure.center_w;
    const Eigen::Index row = static_cast<Eigen::Index>(i);
    g[0][row] = 1.0;
    g[1][row] = t.first_w.dot(arm);
    g[2][row] = t.second_w.dot(arm);
    widest = std::max(widest, arm.norm());
  }
  if (!(widest > 0.0)) return;
  g[1] /= widest;
  g[2] /= widest;

  // Newton: solve with the points that are loaded now, see which ones λ loads, until they agree.
  Column loaded = g[0];
  for (std::size_t round = 0; round <= 2 * kMostPatchPoints; ++round) {
    // G = Q R on the loaded points, by Gram and Schmidt; the least j is Q y with R' y = (F, 0, 0).
    std::array<Column, 3> q;
    Mat3 r = Mat3::Zero();
    Vec3 y(pressure.force, 0.0, 0.0);
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Index column = static_cast<Eigen::Index>(k);
      q[k] = g[k].cwiseProduct(loaded);
      for (std::size_t earlier = 0; earlier < k; ++earlier) {
        const Eigen::Index row = static_cast<Eigen::Index>(earlier);
        r(row, column) = q[earlier].dot(q[k]);
        q[k] -= r(row, column) * q[earlier];
        y[column] -= r(row, column) * y[row];
      }
      r(column, column) = q[k].norm();
      if (r(column, column) <= tolerance::thin_patch) return;
      q[k] /= r(column, column);
      y[column] /= r(column, column);
    }
    Vec3 lambda = y;  // R λ = y, from the last row up
    lambda[2] /= r(2, 2);
    lambda[1] = (lambda[1] - r(1, 2) * lambda[2]) / r(1, 1);
    lambda[0] = (lambda[0] - r(0, 1) * lambda[1] - r(0, 2) * lambda[2]) / r(0, 0);

    const Column bears = lambda[0] * g[0] + lambda[1] * g[1] + lambda[2] * g[2];
    const Column now = (bears.array() > 0.0).template cast<double>();
    if (now == loaded) {
      const Column j = y[0] * q[0] + y[1] * q[1] + y[2] * q[2];
      for (std::size_t i = 0; i < count; ++i)
        points[i].normal_impulse = std::max(0.0, j[static_cast<Eigen::Index>(i)]);
      return;
    }
    loaded = now;
  }
}

}  // namespace

void even_out(const Vec3& normal_w, std::span<PatchPoint> points) {
  const std::size_t count = points.size();
  const Pressure pressure = pressure_of(points);
  if (count < 4 || count > kMostPatchPoints || !(pressure.force > 0.0)) return;
  if (count == 4) return even_out_rows<4>(normal_w, pressure, points);  // nearly always
  even_out_rows<kMostPatchPoints>(normal_w, pressure, points);
}

void PatchFriction::begin(std::size_t points) {
  stepped_ = false;
  before_.assign(points, {});
  now_.assign(points, {});
  yield_.resize(points);
}

// Notes how the points slip, and returns β for the step.
double PatchFriction::look(std::span<const Patch> patches, std::span<const MovingBody> bodies,
                           std::span<const PatchPoint> points) {
  double yield = 0.0;   // sum of j times the tangential inverse mass
  double size = 0.0;    // of the step before, each point's as a share of its load
  double answer = 0.0;  // and how the slip answered to it
  for (const Patch& patch : patches) {
    const MovingBody& first = bodies[static_cast<std::size_t>(patch.first)];
    const MovingBody& second = bodies[static_cast<std::size_t>(patch.second)];
    const Vec3& n = patch.normal_w;
    if (patch.friction == 0.0) continue;
    for (std::size_t i = static_cast<std::size_t>(patch.begin);
         i < static_cast<std::size_t>(patch.end); ++i) {
      const Vec3 u = relative_velocity(first, second, points[i].position_w);
      now_[i] = {points[i].friction_impulse_w, u - n.dot(u) * n, points[i].normal_impulse};
      if (!stepped_) {  // places and masses stay
        const Mat3 k = inverse_mass_at(first, second, points[i].position_w);
        yield_[i] = k.trace() - n.dot(k * n);
      }
      yield += now_[i].load * yield_[i];
      const Vec3 df = now_[i].friction_w - before_[i].friction_w;
      const double load = std::max(now_[i].load, before_[i].load);
      if (load > 0.0) size += df.squaredNorm() / load;
      answer += df.dot(now_[i].slip_w - before_[i].slip_w);
    }
  }
  const double safe = yield > 0.0 ? 1.0 / yield : 0.0;
  const bool answered = stepped_ && answer > 0.0;
  return answered ? std::clamp(size / answer, safe, kLongestStep * safe) : safe;
}

double PatchFriction::step(std::span<const Patch> patches, std::span<MovingBody> bodies,
                           std::span<PatchPoint> points) {
  const double beta = look(patches, bodies, points);
  double change = 0.0;
  for (const Patch& patch : patches) {
    if (patch.friction == 0.0) continue;
    for (std::size_t i = static_cast<std::size_t>(patch.begin);
         i < static_cast<std::size_t>(patch.end); ++i) {
      // Against the slip, and back into the cone.
      PatchPoint& point = points[i];
      const double bound = patch.friction * point.normal_impulse;
      Vec3 wanted = now_[i].friction_w - beta * now_[i].load * now_[i].slip_w;
      const double length = wanted.norm();
      if (length > bound) wanted *= bound / length;
      const Vec3 more = wanted - point.friction_impulse_w;
      if (more.isZero(0.0)) continue;
      apply_impulse(bodies[static_cast<std::size_t>(patch.first)],
                    bodies[static_cast<std::size_t>(patch.second)], point.position_w, more);
      point.friction_impulse_w = wanted;
      change += more.norm();
    }
  }
  stepped_ = true;
  before_.swap(now_);
  return change;
}

}  // namespace tumble
