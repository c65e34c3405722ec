/// \file
/// \brief A number that counts the operations on it, and two functions of a box written with it.
#pragma once

#include "driver/experiment.hpp"

namespace tumble::chapters {

// How many operations were done.
struct Operations {
  std::int64_t sums = 0;       // additions and subtractions
  std::int64_t products = 0;   // multiplications
  std::int64_t divisions = 0;  // divisions
  std::int64_t roots = 0;      // square roots
  std::int64_t choices = 0;    // comparisons, and what stands for one: absolute values, maxima

  // What counts as arithmetic: all but the choices.
  [[nodiscard]] std::int64_t arithmetic() const { return sums + products + divisions + roots; }
};

// A double that counts its operations.
struct Counted {
  double value = 0.0;            // as a double would have it
  Operations* counts = nullptr;  // the counter; not null
};

// Counts a sum.
inline Counted operator+(const Counted& a, const Counted& b) {
  ++a.counts->sums;
  return {a.value + b.value, a.counts};
}
// Counts a difference.
inline Counted operator-(const Counted& a, const Counted& b) {
  ++a.counts->sums;
  return {a.value - b.value, a.counts};
}
// Counts a product.
inline Counted operator*(const Counted& a, const Counted& b) {
  ++a.counts->products;
  return {a.value * b.value, a.counts};
}
// Counts a quotient.
inline Counted operator/(const Counted& a, const Counted& b) {
  ++a.counts->divisions;
  return {a.value / b.value, a.counts};
}
// Counts a choice.
inline bool operator<(const Counted& a, const Counted& b) {
  ++a.counts->choices;
  return a.value < b.value;
}

// Three counted numbers.
using CountedVector = std::array<Counted, 3>;

// A distance and a direction.
struct CountedNormal {
  Counted distance;        // [m] as SignedDistance has it; of the closest face's plane
  CountedVector normal_w;  // [-] world frame, length 1
};

// signed_distance() of the library, operation for operation.
CountedNormal counted_signed_distance(const Box& box, const Vec3& point_w, Operations& counts);

// The face that is closest to a point, as the thesis takes it for a normal: the one whose plane the
// point is least deep below, or farthest above.
CountedNormal counted_closest_face(const Box& box, const Vec3& point_w, Operations& counts);

}  // namespace tumble::chapters
