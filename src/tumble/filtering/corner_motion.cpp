/// \file
/// \brief Measures of unwanted motion at rest, from a body's corners.
#include "tumble/filtering/corner_motion.hpp"

#include "tumble/base/error.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

std::vector<Corners> corner_path(const Trajectory& run, BodyId id, const BodyProperties& body) {
  std::vector<Corners> path;
  for (const Sample& sample : run.samples(id))
    path.push_back(corners_of(box_of(body, sample.state)));
  return path;
}

double largest_excursion(std::span<const Corners> path, double least) {
  double largest = least;
  for (std::size_t c = 0; c < 8 && !path.empty(); ++c) {
    // The diagonal of the bounds of a corner's positions is an upper limit of their distances.
    Vec3 low = path[0][c];
    Vec3 high = low;
    for (const Corners& corners : path) {
      low = low.cwiseMin(corners[c]);
      high = high.cwiseMax(corners[c]);
    }
    if (!((high - low).norm() > largest)) continue;
    for (std::size_t f = 1; f < path.size(); ++f)
      for (std::size_t e = 0; e < f; ++e)
        largest = std::max(largest, (path[f][c] - path[e][c]).norm());
  }
  return largest;
}

double rms_second_difference(std::span<const Corners> path) {
  if (path.size() < 3) return 0.0;
  double sum = 0.0;
  for (std::size_t f = 2; f < path.size(); ++f)
    for (std::size_t c = 0; c < 8; ++c)
      sum += ((path[f][c] - path[f - 1][c]) - (path[f - 1][c] - path[f - 2][c])).squaredNorm();
  return std::sqrt(sum / (8.0 * static_cast<double>(path.size() - 2)));
}

double squirm(std::span<const Corners> path, double interval) {
  require::positive(interval, "interval of squirm()");
  constexpr std::size_t half = kSquirmFrames / 2;
  constexpr double squares = 110.0;  // Σ j² for j = -5 ... 5
  if (path.size() < kSquirmFrames) return 0.0;
  double largest = 0.0;
  for (std::size_t c = 0; c < 8; ++c) {
    double sum = 0.0;
    for (std::size_t f = half; f + half < path.size(); ++f) {
      Vec3 slope = Vec3::Zero();
      for (std::size_t j = 1; j <= half; ++j)
        slope += static_cast<double>(j) * (path[f + j][c] - path[f - j][c]);
      sum += slope.squaredNorm();
    }
    largest = std::max(largest, sum);
  }
  const double frames = static_cast<double>(path.size() - 2 * half);
  return std::sqrt(largest / frames) / (squares * interval);
}

double largest_displacement(const Corners& from, const Corners& to) {
  double largest = 0.0;
  for (std::size_t c = 0; c < 8; ++c) largest = std::max(largest, (to[c] - from[c]).norm());
  return largest;
}

Pops pops(std::span<const Corners> shown, std::span<const Corners> computed, double least) {
  require::that(shown.size() == computed.size(),
                "pops of " + std::to_string(shown.size()) + " shown frames and " +
                    std::to_string(computed.size()) + " computed ones: expected as many");
  require::positive(least, "least of pops()");
  Pops out;
  for (std::size_t f = 1; f < shown.size(); ++f) {
    const double step = largest_displacement(shown[f - 1], shown[f]);
    if (step < least || !(step > largest_displacement(computed[f - 1], computed[f]))) continue;
    ++out.count;
    out.largest = std::max(out.largest, step);
  }
  return out;
}

}  // namespace tumble
