/// \file
/// \brief Filters that show each body at a pose which follows the computed one (thesis 5.5).
#pragma once

#include "tumble/filtering/pose_filter.hpp"

#include <vector>

namespace tumble {

/// What a following filter knows of a body.
struct FollowedBody {
  BodyId id{};                     ///< whose
  BodyState shown;                 ///< its pose as it is shown; the momenta are not used
  BodyState computed;              ///< in the frame before
  Vec3 velocity_w = Vec3::Zero();  ///< [m/s] smoothed, for filters that go by speed; world frame
  Vec3 angular_velocity_w = Vec3::Zero();  ///< [rad/s] the same, world frame
};

/// A filter that has, for each body, the pose that is shown, and moves it on from frame to frame.
///
/// The first frame of a body is shown as it is, and each frame at once: the latency is 0.
class FollowingFilter : public PoseFilter {
 protected:
  FollowingFilter() = default;

 private:
  /// Moves the pose that is shown of a body.
  /// \param now   its computed state
  /// \param dt    [s] since the frame before
  /// \param body  what is known of it; `shown` is to be changed, `computed` is still the one before
  virtual void follow(const BodyState& now, double dt, FollowedBody& body) const = 0;

  void take(const Frame& frame, const FrameSink& show) override;
  void end(const FrameSink& show) override;

  std::vector<FollowedBody> bodies_;  // those of the last frame, in its order
  double last_time_ = 0.0;            // [s] of the last frame
  std::vector<FollowedBody> next_;    // storage
  std::vector<BodyState> states_;     // storage
};

}  // namespace tumble
