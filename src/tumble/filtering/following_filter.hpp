/// \file
/// \brief Filters whose displayed pose follows the computed one (thesis 5.5).
#pragma once

#include "tumble/filtering/pose_filter.hpp"

#include <vector>

namespace tumble {

/// State of a following filter for one body.
struct FollowedBody {
  BodyId id{};                     ///< the body
  BodyState shown;                 ///< displayed pose; the momenta are not used
  BodyState computed;              ///< computed state in the last frame
  Vec3 velocity_w = Vec3::Zero();  ///< [m/s] smoothed, for filters that use speed; world frame
  Vec3 angular_velocity_w = Vec3::Zero();  ///< [rad/s] the same, world frame
};

/// A filter that keeps a displayed pose for each body and updates it frame by frame.
///
/// The first frame of a body is displayed as computed, and each frame at once: the latency is 0.
class FollowingFilter : public PoseFilter {
 protected:
  FollowingFilter() = default;

 private:
  /// Updates the displayed pose of a body.
  /// \param dt    [s] since the last frame
  /// \param body  `shown` in and out; `computed` is that of the last frame
  virtual void follow(const BodyState& now, double dt, FollowedBody& body) const = 0;

  void take(const Frame& frame, const FrameSink& show) override;
  void end(const FrameSink& show) override;

  std::vector<FollowedBody> bodies_;  // those of the last frame, in its order
  double last_time_ = 0.0;            // [s] of the last frame
  std::vector<FollowedBody> next_;    // storage
  std::vector<BodyState> states_;     // storage
};

}  // namespace tumble
