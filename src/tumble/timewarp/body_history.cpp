/// \file
/// \brief The trajectory of one body, and the time until which it is known (Mirtich 2000).
#include "tumble/timewarp/body_history.hpp"

namespace tumble {
namespace {

Bounds both(const Bounds& a, const Bounds& b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

}  // namespace

Bounds bounds_from(const Milestone& milestone, double until, const BodyProperties& body,
                   const Vec3& gravity_w) {
  return bounds_of_flight(body, milestone.state, gravity_w, until - milestone.time,
                          0.5 * body.size.norm());
}

void BodyHistory::begin(const Milestone& milestone) {
  milestones_.assign(1, milestone);
  known_until_ = milestone.time;
}

void BodyHistory::add(const Milestone& milestone, const BodyProperties& body,
                      const Vec3& gravity_w) {
  bounds_ = both(bounds_, bounds_from(milestones_.back(), milestone.time, body, gravity_w));
  milestones_.push_back(milestone);
  known_until_ = milestone.time;
}

void BodyHistory::forget_before(double time) {
  std::size_t last = 0;
  while (last + 1 < milestones_.size() && milestones_[last + 1].time < time) ++last;
  milestones_.erase(milestones_.begin(), milestones_.begin() + static_cast<std::ptrdiff_t>(last));
}

void BodyHistory::shift(double by) {
  for (Milestone& milestone : milestones_) milestone.time -= by;
  known_until_ -= by;
}

void BodyHistory::measure(const BodyProperties& body, const Vec3& gravity_w) {
  for (std::size_t k = 0; k < milestones_.size(); ++k) {
    const double until = k + 1 < milestones_.size() ? milestones_[k + 1].time : known_until_;
    const Bounds part = body.movable() ? bounds_from(milestones_[k], until, body, gravity_w)
                                       : bounds_of(body, milestones_[k].state);
    bounds_ = k == 0 ? part : both(bounds_, part);
  }
}

const Milestone& BodyHistory::before(double time) const {
  std::size_t last = 0;
  while (last + 1 < milestones_.size() && milestones_[last + 1].time < time) ++last;
  return milestones_[last];
}

}  // namespace tumble
