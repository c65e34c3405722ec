/// \file
/// \brief The signed distance and the closest face of a box, with every operation counted.
#include "basic_colliding/counted.hpp"

namespace tumble::chapters {
namespace {

CountedVector counted(const Vec3& v, Operations& counts) {
  return {Counted{v[0], &counts}, Counted{v[1], &counts}, Counted{v[2], &counts}};
}

// The order of the sums is that of the library's matrix products.
Counted dot(const CountedVector& a, const CountedVector& b) {
  return a[0] * b[0] + (a[1] * b[1] + a[2] * b[2]);
}

// A box and a point in its frame, folded into the octant of positive coordinates.
struct Folded {
  std::array<CountedVector, 3> axes_w;
  CountedVector side;  // 1 or -1
  CountedVector q;     // how far beyond the face
};

Counted absolute(const Counted& a) {
  ++a.counts->choices;
  return {std::abs(a.value), a.counts};
}

Folded fold(const Box& box, const Vec3& point_w, Operations& counts) {
  const CountedVector center_w = counted(box.center_w, counts);
  const CountedVector half = counted(box.half, counts);
  const CountedVector y = counted(point_w, counts);
  const CountedVector d = {y[0] - center_w[0], y[1] - center_w[1], y[2] - center_w[2]};
  const Counted zero{0.0, &counts};
  Folded out;
  for (std::size_t k = 0; k < 3; ++k) {
    out.axes_w[k] = counted(box.axes_w.col(static_cast<int>(k)), counts);
    const Counted p = dot(out.axes_w[k], d);
    out.side[k] = Counted{p < zero ? -1.0 : 1.0, &counts};
    out.q[k] = absolute(p) - half[k];
  }
  return out;
}

std::size_t largest(const CountedVector& q) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (q[best] < q[k]) best = k;
  return best;
}

CountedVector scaled(const Counted& factor, const CountedVector& v) {
  return {factor * v[0], factor * v[1], factor * v[2]};
}

}  // namespace

CountedNormal counted_signed_distance(const Box& box, const Vec3& point_w, Operations& counts) {
  const Folded folded = fold(box, point_w, counts);
  const Counted zero{0.0, &counts};
  CountedVector beyond;
  for (std::size_t k = 0; k < 3; ++k) beyond[k] = folded.q[k] < zero ? zero : folded.q[k];
  Counted distance = dot(beyond, beyond);
  ++counts.roots;
  distance.value = std::sqrt(distance.value);
  if (zero < distance) {
    CountedVector gradient_b;
    for (std::size_t k = 0; k < 3; ++k) gradient_b[k] = folded.side[k] * (beyond[k] / distance);
    CountedVector normal_w;
    for (std::size_t i = 0; i < 3; ++i)
      normal_w[i] =
          dot({folded.axes_w[0][i], folded.axes_w[1][i], folded.axes_w[2][i]}, gradient_b);
    return {distance, normal_w};
  }
  const std::size_t nearest = largest(folded.q);
  return {folded.q[nearest], scaled(folded.side[nearest], folded.axes_w[nearest])};
}

CountedNormal counted_closest_face(const Box& box, const Vec3& point_w, Operations& counts) {
  // Only the side of the closest face is asked for; folding looked at all three.
  const Folded folded = fold(box, point_w, counts);
  counts.choices -= 2;
  const std::size_t nearest = largest(folded.q);
  return {folded.q[nearest], scaled(folded.side[nearest], folded.axes_w[nearest])};
}

}  // namespace tumble::chapters
