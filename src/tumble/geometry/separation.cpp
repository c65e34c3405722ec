/// \file
/// \brief The separating axis test for two boxes.
#include "tumble/geometry/separation.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/geometry/separation_pair.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>

namespace tumble {
namespace {

// One of the axes and the separation along it.
struct Candidate {
  double distance;
  AxisIndex axis;
};

// s(A_0), s(A_1), s(A_2)
inline Lanes faces_of_first(const BoxPair& s) {
  const std::array<double, 3> reach_second{(s.b * s.abs_c[0]).sum(), (s.b * s.abs_c[1]).sum(),
                                           (s.b * s.abs_c[2]).sum()};
  return s.d_first.abs() - (s.a + Lanes::of(reach_second.data()));
}

// s(B_0), s(B_1), s(B_2)
inline Lanes faces_of_second(const BoxPair& s) {
  return s.d_second.abs() -
         (s.b + (s.a[0] * s.abs_c[0] + s.a[1] * s.abs_c[1] + s.a[2] * s.abs_c[2]));
}

// An edge axis n = A_i x B_j, not yet of length 1. In the frame of the first box, with i, k, l its
// axes in cyclic order, n has the components (0, -c_lj, c_kj).
struct EdgeAxis {
  double along;    // n.d
  double gap;      // |n| s(n)
  double length2;  // |n|^2
};

// x |x| grows with x like x itself: comparing these compares separations without a square root.
inline double signed_square(double x) { return x * std::abs(x); }

// Which lanes are above those of another: bit 0 for the first lane, bit 1 and bit 2 for the others.
inline unsigned above(const Lanes& p, const Lanes& q) {
  const Lanes::Bits bits = (Lanes::Bits(p.xy > q.xy) & Lanes::Bits{1, 2}) |
                           (Lanes::Bits(p.z_ > q.z_) & Lanes::Bits{4, 0});
  return static_cast<unsigned>(bits[0] | bits[1]);
}

// Which of the three A_i x B_j may have a separation above the bar, bit by bit for j. That C is a
// rotation makes the second box reach along n by |B_p.n| = |c_iq| and |B_q.n| = |c_ip|, for j, p, q
// in cyclic order. This is quick but, for almost parallel edges, only good to rounding.
inline unsigned may_beat(const BoxPair& s, std::size_t i, double bar, double rounding) {
  const std::size_t k = kCycle[i + 1], l = kCycle[i + 2];
  const Lanes reach_first = s.a[k] * s.abs_c[l] + s.a[l] * s.abs_c[k];
  const Lanes reach_second = s.b.next() * s.abs_c[i].after() + s.b.after() * s.abs_c[i].next();
  const Lanes gap = (s.d_first[l] * s.c[k] - s.d_first[k] * s.c[l]).abs() -
                    (reach_first + reach_second) + rounding;
  const Lanes length2 = s.c[k] * s.c[k] + s.c[l] * s.c[l];
  return above(gap * gap.abs(), signed_square(bar) * length2);
}

// An edge axis with care: B_p.n and B_q.n come from the components of n itself. Rounding then is
// relative to |n|, however short n is for edges that are almost parallel.
inline EdgeAxis measured(const BoxPair& s, std::size_t i, std::size_t j) {
  const std::size_t k = kCycle[i + 1], l = kCycle[i + 2], p = kCycle[j + 1], q = kCycle[j + 2];
  const double n_k = -s.c[l][j], n_l = s.c[k][j];
  const double along = s.d_first[k] * n_k + s.d_first[l] * n_l;
  const double reach_first = s.a[k] * std::abs(n_k) + s.a[l] * std::abs(n_l);
  const double reach_second = s.b[p] * std::abs(s.c[k][p] * n_k + s.c[l][p] * n_l) +
                              s.b[q] * std::abs(s.c[k][q] * n_k + s.c[l][q] * n_l);
  return {along, std::abs(along) - (reach_first + reach_second), n_k * n_k + n_l * n_l};
}

bool are_parallel(const EdgeAxis& axis) {
  return axis.length2 < tolerance::parallel_edges * tolerance::parallel_edges;
}

// The separation along any of the 15, for the remembered one. Parallel edges have no direction:
// their axis loses against every other.
double along_axis(const BoxPair& pair, AxisIndex axis) {
  if (axis < 3) return faces_of_first(pair)[idx(axis)];
  if (axis < 6) return faces_of_second(pair)[idx(axis) - 3];
  const EdgeAxis edge = measured(pair, idx(axis - 6) / 3, idx(axis - 6) % 3);
  return are_parallel(edge) ? -HUGE_VAL : edge.gap / std::sqrt(edge.length2);
}

// +1 or -1; the sum turns a negative zero into a positive one.
double sign_of(double x) { return std::copysign(1.0, x + 0.0); }

// The normal: the axis, of length 1, in the world, turned so that it points from first to second.
Separation result(const BoxPair& pair, Candidate best) {
  Separation out{.distance = best.distance, .axis = best.axis};
  if (best.axis < 6) {
    const Box& owner = best.axis < 3 ? pair.first : pair.second;
    const Vec3 axis_w = owner.axes_w.col(best.axis % 3);
    out.normal_w = sign_of(pair.d_w.dot(axis_w)) * axis_w;
  } else {
    const std::size_t i = idx(best.axis - 6) / 3, j = idx(best.axis - 6) % 3;
    const std::size_t k = kCycle[i + 1], l = kCycle[i + 2];
    const EdgeAxis edge = measured(pair, i, j);
    const double scale = sign_of(edge.along) / std::sqrt(edge.length2);
    out.normal_w = scale * pair.c[k][j] * pair.first.axes_w.col(static_cast<int>(l)) -
                   scale * pair.c[l][j] * pair.first.axes_w.col(static_cast<int>(k));
  }
  return out;
}

// Of three faces of one box the first one that comes within a tie of the best. Which one it is
// cannot be foreseen, so the choice is written without branches.
Candidate best_of(const Lanes& s, AxisIndex offset, double tie) {
  const double s_0 = s.xy[0], s_1 = s.xy[1], s_2 = s.z_[0];
  const double cut = std::max(s_0, std::max(s_1, s_2)) - tie;
  const int not_0 = static_cast<int>(s_0 < cut), not_1 = static_cast<int>(s_1 < cut);
  const int i = not_0 + (not_0 & not_1);
  return {s[idx(i)], offset + i};
}

// Which of two faces that tie is the reference: a rule that does not ask which box came first. The
// larger one, since more of the other lies over it; of equal ones that of the lower box, then of
// the one farther back along x, then z.
bool first_is_reference(const BoxPair& pair, std::size_t i, std::size_t j) {
  const double area_first = pair.a[kCycle[i + 1]] * pair.a[kCycle[i + 2]];
  const double difference = area_first - pair.b[kCycle[j + 1]] * pair.b[kCycle[j + 2]];
  if (std::abs(difference) > tolerance::face_tie * area_first) return difference > 0.0;
  if (pair.d_w.y() != 0.0) return pair.d_w.y() > 0.0;
  if (pair.d_w.x() != 0.0) return pair.d_w.x() > 0.0;
  return pair.d_w.z() >= 0.0;
}

// The best of the six face axes.
Candidate best_face(const BoxPair& pair, double tie) {
  const Candidate of_first = best_of(faces_of_first(pair), 0, tie);
  const Candidate of_second = best_of(faces_of_second(pair), 3, tie);
  const double lead = of_first.distance - of_second.distance;
  bool take_first = lead > 0.0;
  if (std::abs(lead) <= tie)
    take_first = first_is_reference(pair, idx(of_first.axis), idx(of_second.axis - 3));
  return take_first ? of_first : of_second;
}

// The best of the nine edge axes if it beats the bar, else `best`.
Candidate best_edge(const BoxPair& pair, Candidate best, double bar) {
  const double rounding = pair.rounding();
  unsigned may_win = may_beat(pair, 0, bar, rounding) | may_beat(pair, 1, bar, rounding) << 3U |
                     may_beat(pair, 2, bar, rounding) << 6U;
  for (; may_win != 0; may_win &= may_win - 1) {
    const int n = std::countr_zero(may_win);
    const EdgeAxis edge = measured(pair, idx(n) / 3, idx(n) % 3);
    if (signed_square(edge.gap) <= signed_square(bar) * edge.length2 || are_parallel(edge))
      continue;
    bar = edge.gap / std::sqrt(edge.length2);
    best = {bar, 6 + n};
  }
  return best;
}

}  // namespace

BoxPair::BoxPair(const Box& one, const Box& other)
    : first(one), second(other), d_w(other.center_w - one.center_w) {
  // Matrices are stored column by column: rows x, y, z of the world begin at 0, 1, 2.
  const double* axes = one.axes_w.data();
  const double* d = d_w.data();
  const Lanes first_x = Lanes::of(axes, 3), first_y = Lanes::of(axes + 1, 3),
              first_z = Lanes::of(axes + 2, 3);
  const double* others = other.axes_w.data();
  const Lanes second_x = Lanes::of(others, 3), second_y = Lanes::of(others + 1, 3),
              second_z = Lanes::of(others + 2, 3);
  d_first = d[0] * first_x + d[1] * first_y + d[2] * first_z;
  d_second = d[0] * second_x + d[1] * second_y + d[2] * second_z;
  for (std::size_t i = 0; i < 3; ++i) {
    c[i] = axes[3 * i] * second_x + axes[3 * i + 1] * second_y + axes[3 * i + 2] * second_z;
    abs_c[i] = c[i].abs();
  }
  a = Lanes::of(one.half.data());
  b = Lanes::of(other.half.data());
}

Separation separation(const BoxPair& pair, const SeparationOptions& options) {
  // The axis that separated or touched a step ago most likely still does.
  Candidate kept{-HUGE_VAL, options.remembered};
  if (kept.axis != kNoAxis) {
    kept.distance = along_axis(pair, kept.axis);
    if (kept.distance > options.enough) return result(pair, kept);
  }

  const Lanes& a = pair.a;
  const Lanes& b = pair.b;
  const double shortest =
      std::min(std::min(a[0], std::min(a[1], a[2])), std::min(b[0], std::min(b[1], b[2])));
  const double tie = options.prefer_faces ? tolerance::face_tie * shortest : 0.0;
  Candidate best = best_face(pair, tie);
  if (best.distance > options.enough) return result(pair, best);
  if (best.distance + 2.0 * tie > options.enough) {  // one that ties with it may be beyond
    const Candidate sharp = best_face(pair, 0.0);
    if (sharp.distance > options.enough) return result(pair, sharp);
  }

  // A preferred axis is left only for one that is clearly better.
  const auto clearly_above = [shortest](double s) {
    return s + tolerance::face_preference * std::abs(s) +
           tolerance::face_preference_length * shortest;
  };
  double bar = options.prefer_faces ? clearly_above(best.distance) : best.distance;
  if (kept.distance > -HUGE_VAL && best.distance <= clearly_above(kept.distance)) {
    best = kept;
    bar = clearly_above(best.distance);
  }
  // An edge axis that separates always counts, however little it beats the preferred one.
  return result(pair, best_edge(pair, best, std::min(bar, options.enough)));
}

Separation separation(const Box& first, const Box& second, const SeparationOptions& options) {
  if (options.remembered < kNoAxis || options.remembered > 14)
    refuse("remembered = " + std::to_string(options.remembered) +
           ": expected kNoAxis or an axis from 0 to 14");
  if (std::isnan(options.enough)) refuse("enough = nan: expected a distance or infinity");
  return separation(BoxPair(first, second), options);
}

}  // namespace tumble
