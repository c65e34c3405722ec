/// \file
/// \brief Chatter on display frames.
#include "tumble/record/chatter.hpp"

#include "tumble/base/tolerance.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

constexpr std::size_t place_of(std::int64_t frame) {
  return static_cast<std::size_t>(frame % ChatterMeter::kWindow);
}

}  // namespace

void ChatterMeter::add(const World& world, std::span<const char> in_contact) {
  const double now = world.time();
  const double frames_passed = now * kFrameRate;
  if (!begun_) {
    next_frame_ = static_cast<std::int64_t>(std::ceil(frames_passed - tolerance::frame_slack));
    last_time_ = now;
  }
  const auto end =
      std::max(next_frame_,
               static_cast<std::int64_t>(std::floor(frames_passed + tolerance::frame_slack)) + 1);
  const std::int64_t first = std::max(next_frame_, end - kWindow);  // older ones are out of sight

  // Bodies and tracks are both in the order of ids.
  std::size_t place = 0;
  for (int i = 0; i < world.count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable()) continue;
    const BodyId id = world.ids()[k];
    const auto at = [&] { return tracks_.begin() + static_cast<std::ptrdiff_t>(place); };
    while (place < tracks_.size() && tracks_[place].id < id) tracks_.erase(at());  // removed
    const Corners corners = corners_of(box_of(body, world.states()[k]));
    if (place == tracks_.size() || tracks_[place].id != id) {
      Track track;
      track.id = id;
      track.limit = tolerance::resting_movement * body.size.minCoeff();
      track.since = begun_ ? end : first;
      track.last = corners;
      tracks_.insert(at(), track);
    }
    take_frames(corners, in_contact[k] != 0, now, first, end, tracks_[place]);
    ++place;
  }
  tracks_.resize(place);
  begun_ = true;
  next_frame_ = end;
  last_time_ = now;
}

// The frames between the last step and this one; all of them lie on the line between the two.
void ChatterMeter::take_frames(const Corners& corners, bool touches, double now, std::int64_t first,
                               std::int64_t end, Track& track) const {
  const double step = now - last_time_;
  for (std::int64_t n = first; n < end; ++n) {
    const double since_last = static_cast<double>(n) / kFrameRate - last_time_;
    const double share = step > 0.0 ? std::clamp(since_last / step, 0.0, 1.0) : 1.0;
    Corners& out = track.frames[place_of(n)];
    for (std::size_t c = 0; c < corners.size(); ++c)
      out[c] = track.last[c] + share * (corners[c] - track.last[c]);
    track.touching[place_of(n)] = touches ? 1 : 0;
  }
  track.last = corners;
}

// By its place in the window: 0 is the oldest frame.
const ChatterMeter::Corners& ChatterMeter::frame(const Track& track, int place) const {
  return track.frames[place_of(next_frame_ - kWindow + place)];
}

bool ChatterMeter::rests(const Track& track) const {
  if (next_frame_ - track.since < kWindow) return false;
  for (const char touches : track.touching)
    if (touches == 0) return false;
  const Corners& begin = frame(track, 0);
  const Corners& end = frame(track, kWindow - 1);
  for (std::size_t c = 0; c < begin.size(); ++c)
    if (!((end[c] - begin[c]).norm() < track.limit)) return false;
  return true;
}

// Largest distance between two places of a corner; looked for only if it can be above a bound.
double ChatterMeter::amplitude(const Track& track, double above) const {
  double largest = above;
  for (std::size_t c = 0; c < 8; ++c) {
    Vec3 low = frame(track, 0)[c];
    Vec3 high = low;
    for (int f = 1; f < kWindow; ++f) {
      low = low.cwiseMin(frame(track, f)[c]);
      high = high.cwiseMax(frame(track, f)[c]);
    }
    if (!((high - low).norm() > largest)) continue;
    for (int f = 1; f < kWindow; ++f)
      for (int e = 0; e < f; ++e)
        largest = std::max(largest, (frame(track, f)[c] - frame(track, e)[c]).norm());
  }
  return largest;
}

double ChatterMeter::second_difference(const Track& track) const {
  double sum = 0.0;
  for (int f = 2; f < kWindow; ++f) {
    const Corners& a = frame(track, f - 2);
    const Corners& b = frame(track, f - 1);
    const Corners& c = frame(track, f);
    for (std::size_t k = 0; k < c.size(); ++k) sum += ((c[k] - b[k]) - (b[k] - a[k])).squaredNorm();
  }
  return std::sqrt(sum / (8.0 * (kWindow - 2)));
}

Chatter ChatterMeter::measure(double gravity) const {
  Chatter out;
  for (const Track& track : tracks_) {
    if (!rests(track)) continue;
    ++out.bodies;
    out.amplitude = amplitude(track, out.amplitude);
    out.acceleration =
        std::max(out.acceleration, second_difference(track) * kFrameRate * kFrameRate / gravity);
  }
  return out;
}

}  // namespace tumble
