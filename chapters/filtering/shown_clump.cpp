/// \file
/// \brief Measuring a settled clump as it is shown.
#include "filtering/shown_clump.hpp"

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
  for (const std::size_t index : bodies) out.push_back(shake_of(path(frames, index), gravity));
  return out;
}

ChatteringClump chattering_clump(const Parameters& settings, int seed) {
  ChatteringClump clump;
  clump.run = settle_clump(settings, seed, {"damped", {}}, kAfterwards);
  clump.watched = static_cast<std::size_t>(std::lround(settings.number("watched") / kStep)) + 1;
  clump.bodies = chattering_bodies(clump.run);
  if (clump.bodies.empty())
    throw std::runtime_error("nothing chatters in the clump of seed " + std::to_string(seed) +
                             ", so there is nothing to filter");
  return clump;
}

Parameters chattering_clump_parameters() {
  return Parameters{}
      .add_whole("seeds", 8, 2, 1000, "clumps")
      .add_whole("per_edge", 5, 2, 8, "cubes along each edge of the grid at the start")
      .add_number("settling", 10.0, 1.0, 1000.0, "s", "before bodies should rest")
      .add_number("watched", 4.0, 0.5, 1000.0, "s", "after that, a multiple of 0.5");
}

Shake median_shake(const std::vector<Shake>& shakes) {
  const auto median = [&](double Shake::*number) { return median_of(numbers_of(shakes, number)); };
  return {median(&Shake::amplitude), median(&Shake::acceleration), median(&Shake::squirm)};
}

Quantity squirm_of_white_noise(std::string name, int frames, int before) {
  return {std::move(name), "-", std::sqrt(weight_of(frames) / weight_of(before))};
}

}  // namespace tumble::chapters
