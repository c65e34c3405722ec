/// \file
/// \brief Anderson acceleration of the sweeps over an island.
#include "tumble/contact_damped/island_acceleration.hpp"

#include "tumble/base/index.hpp"

#include <algorithm>

namespace tumble {

void IslandAcceleration::start(const Island& island) {
  acceleration_.start();
  keep_velocities(island);
}

void IslandAcceleration::keep_velocities(const Island& island) {
  before_.clear();
  for (const int k : island.bodies) before_.push_back(island.now[idx(k)]);
}

double IslandAcceleration::largest_change(const Island& island) const {
  double most = 0.0;
  for (std::size_t i = 0; i < before_.size(); ++i) {
    const int k = island.bodies[i];
    const MovingBody& now = island.now[idx(k)];
    most = std::max(most, fastest_point_speed(
                              island.world.bodies()[idx(k)], now.velocity_w - before_[i].velocity_w,
                              now.angular_velocity_w - before_[i].angular_velocity_w));
  }
  return most;
}

void IslandAcceleration::extrapolate(const Island& island) {
  change_.resize(6 * std::ssize(before_));
  for (std::size_t i = 0; i < before_.size(); ++i) {
    const int k = island.bodies[i];
    const MovingBody& now = island.now[idx(k)];
    const BodyProperties& body = island.world.bodies()[idx(k)];
    const Vec3 turn_b = island.start_wb[idx(k)].conjugate() *
                        (now.angular_velocity_w - before_[i].angular_velocity_w);
    const auto row = static_cast<Eigen::Index>(6 * i);
    change_.segment<3>(row) = std::sqrt(body.mass) * (now.velocity_w - before_[i].velocity_w);
    change_.segment<3>(row + 3) = body.inertia_b.cwiseSqrt().cwiseProduct(turn_b);
  }
  constexpr auto kEach = static_cast<Eigen::Index>(std::tuple_size_v<PatchImpulses>);
  impulses_.resize(kEach * std::ssize(island.patch_indices));
  const auto of_patch = [&](std::size_t i) {
    return impulses_.segment<kEach>(kEach * static_cast<Eigen::Index>(i));
  };
  for (std::size_t i = 0; i < island.patch_indices.size(); ++i) {
    const PatchImpulses had = impulses_in(island.all_patches[idx(island.patch_indices[i])]);
    of_patch(i) = Eigen::Map<const Eigen::Vector<double, kEach>>(had.data());
  }
  acceleration_.extrapolate(change_, impulses_);
  for (std::size_t i = 0; i < island.patch_indices.size(); ++i) {
    PatchImpulses next;
    Eigen::Map<Eigen::Vector<double, kEach>>(next.data()) = of_patch(i);
    go_back(next, 0.0, island.all_patches[idx(island.patch_indices[i])]);
  }
  velocities_from_impulses(island);
  keep_velocities(island);
}

}  // namespace tumble
