/// \file
/// \brief Telling from earlier frames whether a body chatters, rests or goes somewhere (thesis 6.3.1).
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

/// How a body moves, as its last frames tell.
enum class Motion : std::uint8_t {
  rests,     ///< it stays where it is
  chatters,  ///< it goes to and fro, fast, and gets nowhere
  moves      ///< it goes somewhere, swings slowly, or there are too few frames to tell
};

/// Numbers of the ChatterDetector.
///
/// Lengths are in shortest edges L of the body, speeds in \f$V=\sqrt{gL}\f$, time in frames: the
/// same film of a scene of another size is told alike.
struct ChatterDetectorOptions {
  int window = 30;                          ///< [frame] W that are looked at, 2 to 120
  int reversals = 3;                        ///< Z: that often a body must turn round in them
  double rest = tolerance::rest_excursion;  ///< [-] excursion of a body that rests, in L
  double swing = tolerance::chatter_swing;  ///< [-] least swing, in L
  double drift = tolerance::chatter_drift;  ///< [-] largest drift, as a speed, in V
  double speed = tolerance::chatter_speed;  ///< [-] largest mean speed along its path, in V
  double share = tolerance::chatter_share;  ///< [-] least swing, in drifts: the rule's threshold
  double contact = tolerance::chatter_contact;  ///< [-] least share of the frames in contact
  double frame_rate = 60.0;                     ///< [1/s] frames a second
};

/// Tells bodies that chatter from those that rest and those that move, from their last frames.
///
/// The thesis would like to know from earlier steps who is chattering; how is ours. A body is looked at
/// in the last W + 1 frames. With its MotionHistory and h the time between two frames it
/// - *rests* if its excursion is at most `rest` L;
/// - *chatters* if, else, all of these hold:
///   its swing A for `reversals` is at least `swing` L and at least `share` times its drift,
///   its drift is at most `drift` V W h, its path at most `speed` V W h,
///   and it was in contact in the share `contact` of these frames;
/// - *moves* in all other cases.
///
/// What slides has no swing, whatever its speed; what falls, flies or spins is too fast; what creeps
/// while it shakes gets too far. What swings, on an edge or from wall to wall, does not turn round
/// three times in half a second; if it takes less than a quarter of a second from side to side, it can no
/// longer be told from chatter. Chatter is seen from a tenth of a cycle in a frame on. Without
/// gravity nobody is told to chatter, and a body that has not been there for W frames moves.
///
/// Each body is told by itself and by its id: it does not matter who else comes or goes, and in which
/// order.
/// \par Frames
/// At multiples of 1/`frame_rate`, whatever the steps are: a pose between two steps lies on
/// the line between them, as in ChatterMeter. A body is in contact in a frame if it is in any step since
/// the frame before: what hops at smaller steps is no more in the air for that.
/// \par Cost
/// A step costs O(1) for a body, telling O(W Z) to O(W² Z).
class ChatterDetector {
 public:
  /// Starts with an empty memory.
  /// \param options its numbers
  /// \throws std::invalid_argument for a number out of range
  explicit ChatterDetector(const ChatterDetectorOptions& options = {});

  /// Takes in the world after a step (and at the start).
  /// \param world       the bodies
  /// \param in_contact  by index, not 0: touches another body. Sleepers count as touching
  /// \throws std::invalid_argument for another number of bodies in in_contact, or a time before the
  ///         last one
  void add(const World& world, std::span<const char> in_contact);

  /// How a body moves.
  /// \param id the body
  /// \return Motion::moves for one that is not there or immovable too
  [[nodiscard]] Motion motion(BodyId id) const;

  /// Features of the last W + 1 frames of a body.
  /// \param id the body
  /// \return with its swing; nothing if it has not been there for as long
  [[nodiscard]] std::optional<MotionHistory> history(BodyId id) const;

  /// How clearly a body chatters: its swing over its drift, which the rule compares with `share`.
  /// \param id the body
  /// \return [-] 0 if any other part of the rule says that it does not chatter; infinite without drift
  [[nodiscard]] double clearness(BodyId id) const;

  /// Its numbers.
  /// \return as given to the constructor
  [[nodiscard]] const ChatterDetectorOptions& options() const { return options_; }

 private:
  struct Track {
    BodyId id{};
    double edge = 0.0;       // [m] L
    std::int64_t since = 0;  // the first frame that it was there in
    Placement last;          // [m] at the last step
    std::vector<Placement>
        places{};                  // frame n is at n mod (W + 1), and once more after W + 1 places
    std::vector<char> touching{};  // ditto, once
    bool touched = false;          // in a step since the last frame
  };
  [[nodiscard]] const Track* find(BodyId id) const;
  [[nodiscard]] std::span<const Placement> window(const Track& track) const;
  [[nodiscard]] double clearness(const Track& track, const MotionHistory& history) const;
  void take_frames(const Placement& place, bool touches, Track& track) const;

  ChatterDetectorOptions options_;
  DisplayFrames frames_;
  std::vector<Track> tracks_;  // movable bodies, ascending by id
  double gravity_ = 0.0;       // [m/s²] of the last step
};

/// Who touches another body, from the contacts that a technique tells.
/// \param world       the bodies
/// \param contacts    of the last step
/// \param in_contact  by index: 1 for those that are named in a contact, else 0
void mark_contacts(const World& world, std::span<const ContactRecord> contacts,
                   std::vector<char>& in_contact);

}  // namespace tumble
