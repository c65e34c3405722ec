/// \file
/// \brief Contact with friction as one linear complementarity problem.
#include "tumble/analytic_lcp/friction_pyramid.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"

#include <cmath>
#include <string>

namespace tumble {
namespace {

void require_index(int index, std::size_t count, std::string_view name) {
  if (index < 0 || idx(index) >= count)
    refuse(std::string(name) + " = " + std::to_string(index) + ": expected an index below " +
           std::to_string(count));
}

void require_valid(std::span<const MovingBody> bodies, std::span<const Contact> contacts,
                   const FrictionPoint& point) {
  require_index(point.contact, contacts.size(), "points: contact");
  const Contact& contact = contacts[idx(point.contact)];
  require_index(point.point, idx(contact.count), "points: point");
  require_index(contact.first, bodies.size(), "contact.first");
  require_index(contact.second, bodies.size(), "contact.second");
  require::not_negative(contact.friction, "contact.friction");
  require::finite(point.normal_constant, "normal_constant");
  require::finite(point.tangential_constant_w, "tangential_constant_w");
  if (!point.sliding_w.isZero(0.0)) require::unit(point.sliding_w, "sliding_w");
}

// A complex number, since those of the library may be rounded otherwise elsewhere.
struct Complex {
  double re = 0.0;
  double im = 0.0;
};

Complex square(const Complex& z) { return {z.re * z.re - z.im * z.im, 2.0 * z.re * z.im}; }

// The root of a number of length 1 with a real part of at least 0, from the larger of its parts.
Complex root(const Complex& z) {
  if (z.re >= 0.0) {
    const double re = std::sqrt(0.5 * (1.0 + z.re));
    return {re, 0.5 * z.im / re};
  }
  const double im = std::copysign(std::sqrt(0.5 * (1.0 - z.re)), z.im);
  return {0.5 * z.im / im, im};
}

// How a body's push at r_push moves its point at r_look: diag(1/m) - [r_look] I^-1 [r_push].
Mat3 yield_of(const MovingBody& body, const Vec3& look_w, const Vec3& push_w) {
  const Vec3 r_look = look_w - body.position_w;
  const Vec3 r_push = push_w - body.position_w;
  Mat3 yield;
  for (int k = 0; k < 3; ++k) {
    const Vec3 e = Vec3::Unit(k);
    yield.col(k) = body.inverse_mass.cwiseProduct(e) +
                   (body.inverse_inertia_w * r_push.cross(e)).cross(r_look);
  }
  return yield;
}

// How a push at one point moves another one, both between a first and a second body. A body that
// is the first of the one and the second of the other is pushed against its sense there.
Mat3 yield_between(std::span<const MovingBody> bodies, const Contact& look, const Vec3& look_w,
                   const Contact& push, const Vec3& push_w) {
  Mat3 yield = Mat3::Zero();
  if (look.first == push.first) yield += yield_of(bodies[idx(look.first)], look_w, push_w);
  if (look.second == push.second) yield += yield_of(bodies[idx(look.second)], look_w, push_w);
  if (look.first == push.second) yield -= yield_of(bodies[idx(look.first)], look_w, push_w);
  if (look.second == push.first) yield -= yield_of(bodies[idx(look.second)], look_w, push_w);
  return yield;
}

bool is_rough(const Contact& contact, const FrictionPoint& point, int directions) {
  return point.rough && directions > 0 && contact.friction > 0.0;
}

}  // namespace

int FrictionPyramid::unknowns(std::span<const Contact> contacts,
                              std::span<const FrictionPoint> points, int directions) {
  int sum = 0;
  bool any = false;
  for (const FrictionPoint& point : points) {
    const bool rough = is_rough(contacts[idx(point.contact)], point, directions);
    any = any || rough;
    sum += rough && point.sliding_w.isZero(0.0) ? directions + 2 : 1;
  }
  return any ? sum : 0;
}

Tangents pyramid_axes(const Vec3& normal_w) {
  const Tangents t = tangents_of(normal_w);
  Complex sum;
  for (int k = 0; k < 3; ++k) {
    const Complex fourth = square(square({t.first_w[k], -t.second_w[k]}));
    sum.re += fourth.re;
    sum.im += fourth.im;
  }
  const double length = std::sqrt(sum.re * sum.re + sum.im * sum.im);
  if (length <= tolerance::rounding) return t;  // a space diagonal: no direction stands out
  const Complex turn = root(root({sum.re / length, -sum.im / length}));
  return {turn.re * t.first_w + turn.im * t.second_w, turn.re * t.second_w - turn.im * t.first_w};
}

// Without friction, or where it is known to act against the sliding, c pushes along n - mu T and
// is the only unknown.
void FrictionPyramid::list_unknowns(std::span<const Contact> contacts,
                                    std::span<const FrictionPoint> points, int directions) {
  unknowns_.clear();
  ranges_.clear();
  has_friction_ = false;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Contact& contact = contacts[idx(points[p].contact)];
    const Vec3& n = contact.normal_w;
    const bool rough = is_rough(contact, points[p], directions);
    const bool slides = rough && !points[p].sliding_w.isZero(0.0);
    const int place = static_cast<int>(p);
    Range& range = ranges_.emplace_back();
    range.first = static_cast<int>(unknowns_.size());
    range.directions = rough && !slides ? directions : 0;
    has_friction_ = has_friction_ || rough;
    Vec3 push_w = n;
    if (slides) push_w -= contact.friction * points[p].sliding_w;
    unknowns_.push_back({place, n, push_w});
    if (range.directions == 0) continue;

    const Tangents axes = pyramid_axes(n);
    const double diagonal = std::sqrt(0.5);
    const auto add_pair = [&](const Vec3& t) {
      unknowns_.push_back({place, t, t});
      unknowns_.push_back({place, -t, -t});
    };
    add_pair(axes.first_w);
    if (directions == 8) add_pair(diagonal * (axes.first_w + axes.second_w));
    add_pair(axes.second_w);
    if (directions == 8) add_pair(diagonal * (axes.second_w - axes.first_w));
    unknowns_.push_back({place, Vec3::Zero(), Vec3::Zero()});  // lambda
  }
}

// The block of A in which the rows of one point see the pushes of another one, and its opposite.
void FrictionPyramid::couple(int i, int j, const Mat3& yield) {
  const Range& rows = ranges_[idx(i)];
  const Range& columns = ranges_[idx(j)];
  for (int c = columns.first; c < columns.first + columns.count(); ++c) {
    for (int r = rows.first; r < rows.first + rows.count(); ++r) {
      const Unknown& row = unknowns_[idx(r)];
      const Unknown& column = unknowns_[idx(c)];
      lcp_.A(r, c) = row.look_w.dot(yield * column.push_w);
      if (i != j) lcp_.A(c, r) = row.push_w.dot(yield * column.look_w);
    }
  }
}

// The rows and columns of lambda, in units of s.
void FrictionPyramid::add_sliding(int point, double friction) {
  const Range& range = ranges_[idx(point)];
  if (range.directions == 0) return;
  const int c = range.first;
  const int lambda = c + range.directions + 1;
  const double own = lcp_.A(c, c);
  const double s = own > 0.0 ? own : 1.0;  // where nothing moves along the normal any unit will do
  lcp_.A(lambda, c) = s * friction;
  for (int k = c + 1; k < lambda; ++k) {
    lcp_.A(k, lambda) = s;
    lcp_.A(lambda, k) = -s;
  }
}

void FrictionPyramid::assemble(std::span<const MovingBody> bodies,
                               std::span<const Contact> contacts,
                               std::span<const FrictionPoint> points, int directions) {
  if (directions != 0 && directions != 4 && directions != 8)
    refuse("directions = " + std::to_string(directions) + ": expected 4, 8, or 0 for none");
  for (const FrictionPoint& point : points) require_valid(bodies, contacts, point);
  list_unknowns(contacts, points, directions);
  const auto size = static_cast<Eigen::Index>(unknowns_.size());
  lcp_.A.resize(size, size);
  lcp_.b.resize(size);

  for (Eigen::Index k = 0; k < size; ++k) {
    const Unknown& unknown = unknowns_[static_cast<std::size_t>(k)];
    const FrictionPoint& point = points[idx(unknown.point)];
    const bool is_normal = ranges_[idx(unknown.point)].first == static_cast<int>(k);
    lcp_.b[k] = is_normal ? point.normal_constant : unknown.look_w.dot(point.tangential_constant_w);
  }
  const auto place_of = [&](int point) {
    return contacts[idx(points[idx(point)].contact)]
        .points[idx(points[idx(point)].point)]
        .position_w;
  };
  for (int j = 0; j < static_cast<int>(points.size()); ++j) {
    const Contact& push = contacts[idx(points[idx(j)].contact)];
    for (int i = 0; i <= j; ++i) {
      const Contact& look = contacts[idx(points[idx(i)].contact)];
      couple(i, j, yield_between(bodies, look, place_of(i), push, place_of(j)));
    }
    add_sliding(j, push.friction);
  }
}

void FrictionPyramid::pushes(std::span<const double> f, std::vector<Vec3>& push) const {
  if (f.size() != unknowns_.size())
    refuse("f has " + std::to_string(f.size()) + " entries: give " +
           std::to_string(unknowns_.size()));
  push.assign(ranges_.size(), Vec3::Zero());
  for (std::size_t k = 0; k < f.size(); ++k) {
    const Unknown& unknown = unknowns_[k];
    push[idx(unknown.point)] += f[k] * unknown.push_w;
  }
}

}  // namespace tumble
