/// \file
/// \brief Measuring a settled clump as it is shown.
#include "filtering/shown_clump.hpp"

#include "driver/statistics.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace tumble::chapters {
namespace {

constexpr double kAfterwards = 0.5;  // [s] more than half of the widest window, 15 frames

// The sum of squares of the weights with which samples enter a slope after a box filter.
double weight_of(int frames) {
  constexpr int kReach = kSquirmFrames / 2;
  double sum = 0.0;
  for (int n = -kReach - frames / 2; n <= kReach + frames / 2; ++n) {
    double weight = 0.0;
    for (int k = -(frames / 2); k <= frames / 2; ++k)
      if (std::abs(n - k) <= kReach) weight += static_cast<double>(n - k) / frames;
    sum += weight * weight;
  }
  return sum;
}

}  // namespace

std::vector<Corners> ChatteringClump::path(const Trajectory& frames, std::size_t index) const {
  std::vector<Corners> corners = settled_path(run, frames, index);
  corners.resize(watched);
  return corners;
}

std::vector<Shake> ChatteringClump::shakes(const Trajectory& frames) const {
  const double gravity = run.world.gravity_w.norm();
  std::vector<Shake> out;
  for (const std::size_t index : bodies)
    out.push_back(shake_of(path(frames, index), gravity, run.interval));
  return out;
}

ChatteringClump chattering_clump(SettledRequest request) {
  ChatteringClump clump;
  const double watched = request.watched;
  request.watched += kAfterwards;
  clump.run = settle_clump(request);
  clump.watched = static_cast<std::size_t>(std::lround(watched / clump.run.interval)) + 1;
  clump.bodies = chattering_bodies(clump.run);
  if (clump.bodies.empty())
    throw std::runtime_error("nothing chatters in the clump of seed " +
                             std::to_string(request.seed) + ", so there is nothing to filter");
  return clump;
}

SettledRequest clump_request(const Parameters& settings, int seed) {
  SettledRequest request;
  request.per_edge = settings.count("per_edge");
  request.seed = static_cast<std::uint64_t>(seed);
  request.settling = settings.number("settling");
  request.watched = settings.number("watched");
  return request;
}

Shake median_shake(const std::vector<Shake>& shakes) {
  std::vector<double> amplitudes;
  std::vector<double> accelerations;
  std::vector<double> squirms;
  for (const Shake& shake : shakes) {
    amplitudes.push_back(shake.amplitude);
    accelerations.push_back(shake.acceleration);
    squirms.push_back(shake.squirm);
  }
  return {median_of(amplitudes), median_of(accelerations), median_of(squirms)};
}

Quantity squirm_of_white_noise(std::string name, int frames, int before) {
  return {std::move(name), "-", std::sqrt(weight_of(frames) / weight_of(before))};
}

}  // namespace tumble::chapters
