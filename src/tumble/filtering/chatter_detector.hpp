/// \file
/// \brief Classification of motion from earlier frames: chatter, rest or movement (thesis 6.3.1).
#pragma once

#include "tumble/dynamics/technique.hpp"
#include "tumble/filtering/display_frames.hpp"
#include "tumble/filtering/motion_history.hpp"
#include "tumble/filtering/tolerances.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tumble {

/// How a body moves, judged by its last frames.
enum class Motion : std::uint8_t {
  rests,     ///< it stays where it is
  chatters,  ///< it oscillates fast and stays where it is
  moves      ///< it travels, swings slowly, or has too few frames
};

/// Thresholds of the ChatterDetector.
///
/// Lengths are in shortest edges L of the body, speeds in \f$V=\sqrt{gL}\f$, time in frames, so that
/// the classification is independent of the size of the scene.
struct ChatterDetectorOptions {
  int window = 30;                              ///< [frame] W, frames examined, 2 to 120
  int reversals = 3;                            ///< Z, least number of reversals in them
  double rest = tolerance::rest_excursion;      ///< [-] largest excursion of a resting body, in L
  double swing = tolerance::chatter_swing;      ///< [-] least swing, in L
  double drift = tolerance::chatter_drift;      ///< [-] largest drift, as a speed, in V
  double speed = tolerance::chatter_speed;      ///< [-] largest mean speed along its path, in V
  double share = tolerance::chatter_share;      ///< [-] least ratio of swing to drift
  double contact = tolerance::chatter_contact;  ///< [-] least share of the frames in contact
  double frame_rate = 60.0;                     ///< [1/s] frames per second
};

/// Classifies bodies by their last frames: chattering, resting or moving.
///
/// The thesis suggests detecting chatter from earlier steps but gives no rule; this rule is ours. With
/// the MotionHistory of its last W + 1 frames, and h the time between two frames, a body
/// - *rests* if its excursion is at most `rest` L;
/// - *chatters* if not, and all of these hold:
///   its swing A for `reversals` is at least `swing` L and at least `share` times its drift,
///   its drift is at most `drift` V W h, its path at most `speed` V W h,
///   and it was in contact in at least the share `contact` of these frames;
/// - *moves* in all other cases.
///
/// A sliding body has no swing at any speed; a falling, flying or spinning one is too fast; one that
/// creeps while it shakes drifts too far. A body that rocks on an edge or between walls does not
/// reverse three times in half a second; if it takes less than a quarter of a second from side to side,
/// it cannot be distinguished from chatter. Chatter is detected from a tenth of a cycle per frame on.
/// Without gravity no body is classified as chattering, and a body present for fewer than W frames moves.
///
/// Each body is classified on its own and by its id, independent of other bodies and of their order.
/// \par Frames
/// At multiples of 1/`frame_rate`, independent of the steps: poses between two steps are interpolated
/// linearly, as in ChatterMeter. A body is in contact in a frame if it is in any step since the frame
/// before, so that the classification of hopping does not depend on the step.
/// \par Cost
/// A step costs O(1) for a body, its classification O(W Z) to O(W² Z).
class ChatterDetector {
 public:
  /// Starts with an empty memory.
  /// \throws std::invalid_argument for a number out of range
  explicit ChatterDetector(const ChatterDetectorOptions& options = {});

  /// Adds the world after a step (and at the start).
  /// \param in_contact  by index, not 0: touches another body. Sleeping bodies count as touching
  /// \throws std::invalid_argument for another number of bodies in in_contact, or a time before the
  ///         last one
  void add(const World& world, std::span<const char> in_contact);

  /// Classification of a body; Motion::moves also for a body that is absent or immovable.
  [[nodiscard]] Motion motion(BodyId id) const;

  /// Features of the last W + 1 frames of a body, with its swing; nothing if it has fewer frames.
  [[nodiscard]] std::optional<MotionHistory> history(BodyId id) const;

  /// Ratio of a body's swing to its drift, which the rule compares with `share`.
  /// \return [-] 0 if another condition for chatter fails; infinite without drift
  [[nodiscard]] double swing_ratio(BodyId id) const;

  /// Its thresholds.
  [[nodiscard]] const ChatterDetectorOptions& options() const { return options_; }

 private:
  struct Track {
    BodyId id{};
    double edge = 0.0;       // [m] L
    std::int64_t since = 0;  // its first frame
    Placement last;          // [m] at the last step
    std::vector<Placement>
        places{};                  // frame n is at n mod (W + 1), and once more after W + 1 places
    std::vector<char> touching{};  // frame n is at n mod (W + 1)
    bool touched = false;          // in a step since the last frame
  };
  [[nodiscard]] const Track* find(BodyId id) const;
  [[nodiscard]] std::span<const Placement> window(const Track& track) const;
  [[nodiscard]] double swing_ratio(const Track& track, const MotionHistory& history) const;
  void take_frames(const Placement& place, bool touches, Track& track) const;

  ChatterDetectorOptions options_;
  DisplayFrames frames_;
  std::vector<Track> tracks_;  // movable bodies, ascending by id
  double gravity_ = 0.0;       // [m/s²] of the last step
};

/// Marks the bodies in contact, from the contacts that a technique reports.
/// \param in_contact  by index: 1 for bodies in a contact, otherwise 0
void mark_contacts(const World& world, std::span<const ContactRecord> contacts,
                   std::vector<char>& in_contact);

}  // namespace tumble
