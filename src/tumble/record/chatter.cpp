/// \file
/// \brief Chatter on display frames.
#include "tumble/record/chatter.hpp"

#include "tumble/contact/tolerances.hpp"

#include <algorithm>

namespace tumble {
namespace {

constexpr std::size_t place_of(std::int64_t frame) {
  return static_cast<std::size_t>(frame % ChatterMeter::kWindow);
}

// A second difference [m] as a share of the one of a free fall.
double in_free_falls(double second_difference, double gravity) {
  return second_difference * ChatterMeter::kFrameRate * ChatterMeter::kFrameRate / gravity;
}

}  // namespace

void ChatterMeter::add(const World& world, std::span<const char> in_contact) {
  const bool begun = frames_.begun();
  frames_.advance(world.time());
  forget_removed(world, tracks_);
  std::size_t place = 0;  // bodies and tracks are both in the order of ids
  for (int i = 0; i < world.count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable()) continue;
    const BodyId id = world.ids()[k];
    const Corners corners = corners_of(box_of(body, world.states()[k]));
    if (place == tracks_.size() || tracks_[place].id != id) {
      Track track;
      track.id = id;
      track.limit = tolerance::resting_movement * body.size.minCoeff();
      track.since = begun ? frames_.end() : frames_.first();
      track.last = corners;
      track.start = corners;
      tracks_.insert(tracks_.begin() + static_cast<std::ptrdiff_t>(place), track);
    }
    take_frames(corners, in_contact[k] != 0, tracks_[place]);
    ++place;
  }
}

void ChatterMeter::keep(std::int64_t frame, const Corners& corners, Track& track) {
  track.frames[place_of(frame)] = corners;
  track.frames[place_of(frame) + kWindow] = corners;
}

// The frames between the last step and this one; all of them lie on the line between the two. One without contact is
// not kept: no window with it is measured.
void ChatterMeter::take_frames(const Corners& corners, bool touches, Track& track) const {
  for (std::int64_t n = frames_.first(); n < frames_.end(); ++n) {
    track.touching[place_of(n)] = touches ? 1 : 0;
    if (!touches) continue;
    const double share = frames_.share(n);
    Corners out;
    for (std::size_t c = 0; c < corners.size(); ++c)
      out[c] = track.last[c] + share * (corners[c] - track.last[c]);
    if (n == track.since) {
      track.start = out;
      continue;
    }
    if (track.frames.empty()) {
      track.frames.resize(std::size_t{2} * kWindow);
      keep(track.since, track.start, track);
    }
    keep(n, out, track);
  }
  track.last = corners;
}

// The frames of the last half second, the oldest first.
std::span<const Corners> ChatterMeter::window(const Track& track) const {
  return std::span(track.frames).subspan(place_of(frames_.end()), kWindow);
}

bool ChatterMeter::rests(const Track& track) const {
  if (frames_.end() - track.since < kWindow) return false;
  for (const char touches : track.touching)
    if (touches == 0) return false;
  const Corners& begin = window(track).front();
  const Corners& end = window(track).back();
  for (std::size_t c = 0; c < begin.size(); ++c)
    if (!((end[c] - begin[c]).norm() < track.limit)) return false;  // nor one that is not finite
  return true;
}

Chatter ChatterMeter::measure(double gravity) const {
  Chatter out;
  double farthest = 0.0;  // [m] the largest second difference
  for (const Track& track : tracks_) {
    if (!rests(track)) continue;
    ++out.bodies;
    out.amplitude = largest_excursion(window(track), out.amplitude);
    farthest = std::max(farthest, rms_second_difference(window(track)));
  }
  out.acceleration = in_free_falls(farthest, gravity);
  return out;
}

std::vector<BodyChatter> ChatterMeter::each(double gravity) const {
  std::vector<BodyChatter> out;
  for (const Track& track : tracks_)
    if (rests(track))
      out.push_back({track.id, largest_excursion(window(track)),
                     in_free_falls(rms_second_difference(window(track)), gravity)});
  return out;
}

}  // namespace tumble
