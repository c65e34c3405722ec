/// \file
/// \brief Classification of motion from earlier frames: chatter, rest or movement (thesis 6.3.1).
#include "tumble/filtering/chatter_detector.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace tumble {
namespace {

constexpr int kLargestWindow = static_cast<int>(kMostPlaces) - 1;

}  // namespace

ChatterDetector::ChatterDetector(const ChatterDetectorOptions& options)
    : options_(options), frames_(options.frame_rate, options.window + 1) {
  require::that(options.window >= 2 && options.window <= kLargestWindow,
                "window = " + std::to_string(options.window) + ": expected 2 to 120 frames");
  require::that(options.reversals >= 1,
                "reversals = " + std::to_string(options.reversals) + ": expected at least 1");
  require::not_negative(options.rest, "rest");
  require::positive(options.swing, "swing");
  require::not_negative(options.drift, "drift");
  require::not_negative(options.speed, "speed");
  require::not_negative(options.share, "share");
  require::within(options.contact, 0.0, 1.0, "contact");
  require::positive(options.frame_rate, "frame_rate");
}

void ChatterDetector::add(const World& world, std::span<const char> in_contact) {
  // Messages are built only when needed: this is called in every step.
  if (in_contact.size() != world.states().size())
    refuse("in_contact has " + std::to_string(in_contact.size()) + " bodies, the world " +
           std::to_string(world.count()));
  const double now = world.time();
  if (frames_.begun() && !(now >= frames_.now()))
    refuse("the world's time " + shortest_text(now) + " s is before the last one");
  frames_.advance(now);
  forget_removed(world, tracks_);
  const auto frames = static_cast<std::size_t>(options_.window + 1);
  std::size_t place = 0;  // bodies and tracks are both sorted by id
  for (int i = 0; i < world.count(); ++i) {
    const BodyProperties& body = world.bodies()[idx(i)];
    if (!body.movable()) continue;
    const BodyId id = world.ids()[idx(i)];
    const Placement now_at = placement_of(body, world.states()[idx(i)]);
    if (place == tracks_.size() || tracks_[place].id != id) {
      Track track{id, body.size.minCoeff(), frames_.frame_from(now), now_at};
      track.places.assign(2 * frames, now_at);
      track.touching.assign(frames, 0);
      tracks_.insert(tracks_.begin() + static_cast<std::ptrdiff_t>(place), track);
    }
    const bool touches = in_contact[idx(i)] != 0 || world.sleep_states()[idx(i)].asleep;
    take_frames(now_at, touches, tracks_[place]);
    ++place;
  }
  gravity_ = world.gravity_w.norm();
}

// Adds the frames between the last step and this one, interpolated linearly.
void ChatterDetector::take_frames(const Placement& place, bool touches, Track& track) const {
  const auto frames = static_cast<std::size_t>(options_.window + 1);
  track.touched = track.touched || touches;
  for (std::int64_t n = frames_.first(); n < frames_.end(); ++n) {
    const auto k = static_cast<std::size_t>(n) % frames;
    track.places[k] = place + (1.0 - frames_.share(n)) * (track.last - place);
    track.places[k + frames] = track.places[k];
    track.touching[k] = track.touched ? 1 : 0;
    track.touched = touches;  // later frames belong to this step alone
  }
  if (frames_.first() < frames_.end()) track.touched = false;
  track.last = place;
}

const ChatterDetector::Track* ChatterDetector::find(BodyId id) const {
  const auto found = std::lower_bound(tracks_.begin(), tracks_.end(), id,
                                      [](const Track& track, BodyId b) { return track.id < b; });
  const bool known = found != tracks_.end() && found->id == id;
  return known && frames_.end() - found->since > options_.window ? &*found : nullptr;
}

std::span<const Placement> ChatterDetector::window(const Track& track) const {
  const auto frames = static_cast<std::size_t>(options_.window + 1);
  return std::span(track.places).subspan(static_cast<std::size_t>(frames_.end()) % frames, frames);
}

std::optional<MotionHistory> ChatterDetector::history(BodyId id) const {
  const Track* track = find(id);
  if (track == nullptr) return {};
  MotionHistory history = history_of(window(*track));
  history.swing = swing_of(window(*track), options_.reversals);
  return history;
}

// [S6.3.1:chatter]
// The cheap conditions come first; a comparison with NaN fails. Without gravity every path is too long.
double ChatterDetector::swing_ratio(const Track& track, const MotionHistory& history) const {
  const double frames = options_.window;
  const double unit = std::sqrt(gravity_ * track.edge) * frames / options_.frame_rate;  // [m] V W h
  const auto touched =
      static_cast<double>(std::count(track.touching.begin(), track.touching.end(), 1));
  if (!(history.path <= options_.speed * unit && history.drift <= options_.drift * unit &&
        touched >= options_.contact * (frames + 1.0)))
    return 0.0;
  const double swing = swing_of(window(track), options_.reversals);
  if (!(swing >= options_.swing * track.edge)) return 0.0;
  return history.drift > 0.0 ? swing / history.drift : std::numeric_limits<double>::infinity();
}
// [S6.3.1:chatter]

double ChatterDetector::swing_ratio(BodyId id) const {
  const Track* track = find(id);
  return track == nullptr ? 0.0 : swing_ratio(*track, history_of(window(*track)));
}

Motion ChatterDetector::motion(BodyId id) const {
  const Track* track = find(id);
  if (track == nullptr) return Motion::moves;
  const MotionHistory history = history_of(window(*track));
  if (!std::isfinite(history.path)) return Motion::moves;  // maxima ignore NaN
  if (history.excursion <= options_.rest * track->edge) return Motion::rests;
  const double clear = swing_ratio(*track, history);
  return clear > 0.0 && clear >= options_.share ? Motion::chatters : Motion::moves;
}

void mark_contacts(const World& world, std::span<const ContactRecord> contacts,
                   std::vector<char>& in_contact) {
  in_contact.assign(world.states().size(), 0);
  for (const ContactRecord& contact : contacts)
    for (const BodyId id : {contact.first, contact.second})
      if (const auto index = world.find(id)) in_contact[idx(*index)] = 1;
}

}  // namespace tumble
