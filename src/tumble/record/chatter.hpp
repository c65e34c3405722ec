/// \file
/// \brief The measure of chatter: how much a body shakes that should rest (thesis 3.3.2, 5.5).
#pragma once

#include "tumble/dynamics/world.hpp"
#include "tumble/filtering/corner_motion.hpp"
#include "tumble/filtering/display_frames.hpp"

#include <array>
#include <span>
#include <vector>

namespace tumble {

/// How much the resting bodies of a scene shake.
struct Chatter {
  double amplitude = 0.0;  ///< [m] of the body with the largest
  /// [-] of the body with the largest; 1 is as much as a free fall
  double acceleration = 0.0;
  int bodies = 0;  ///< how many bodies rest and were measured
};

/// How much one body that rests shakes.
struct BodyChatter {
  BodyId id{};                ///< the body
  double amplitude = 0.0;     ///< [m] largest distance between two places of a corner
  double acceleration = 0.0;  ///< [-] 1 is as much as a free fall
};

/// Measures chatter from the poses that a viewer sees.
///
/// A body rests if it is in contact on every frame of the last half second and each of its corners
/// is at the end of that window within 1 % of the body's shortest edge of where it was at the
/// beginning. Two numbers measure its shaking:
/// - the amplitude, the largest distance between two places of a corner within the window;
/// - the acceleration, the root mean square of the second differences \f$x_{k+1}-2x_k+x_{k-1}\f$ of
///   its corners from frame to frame, over \f$g/60^2\f$.
///
/// Frames are those of a 60 Hz display whatever the time step is, at multiples of 1/60 s. A corner
/// between two steps is interpolated linearly; whether the body is in contact there is decided by
/// the later step.
class ChatterMeter {
 public:
  /// [1/s] Frames per second.
  static constexpr double kFrameRate = 60.0;
  /// Frames in the window, both ends included: half a second.
  static constexpr int kWindow = 31;

  /// Adds the world after a step, or at the start. The window of a body that appears later begins with the first frame
  /// after it was first added.
  /// \param in_contact  by index: whether the body touches another one
  void add(const World& world, std::span<const char> in_contact);

  /// Measures over the last half second.
  /// \param gravity  [m/s²] size of the gravity that accelerations are divided by, above 0
  /// \return the largest values of each(); all zero before half a second has passed or while no body rests
  /// \par Cost
  /// O(bodies); bounds of its corners exclude a body that cannot have the largest value.
  [[nodiscard]] Chatter measure(double gravity) const;

  /// Measures every body that rests over the last half second.
  /// \return one for each body that rests, by id; none before half a second has passed
  [[nodiscard]] std::vector<BodyChatter> each(double gravity) const;

 private:
  struct Track {
    BodyId id{};
    double limit = 0.0;      // [m] net movement up to which the body rests
    std::int64_t since = 0;  // the first frame that it was seen in
    Corners last;            // [m] at the last step
    Corners start;           // [m] in that frame
    // Those in contact. Frame n is at place n mod kWindow and again kWindow places on, so that any window lies in a
    // row. 12 kB; empty until there is a second frame in contact.
    std::vector<Corners> frames;
    std::array<char, kWindow> touching{};  // whether it was in contact then
  };

  static void keep(std::int64_t frame, const Corners& corners, Track& track);
  void take_frames(const Corners& corners, bool touches, Track& track) const;
  [[nodiscard]] std::span<const Corners> window(const Track& track) const;
  [[nodiscard]] bool rests(const Track& track) const;

  std::vector<Track> tracks_;  // by id, ascending
  DisplayFrames frames_{kFrameRate, kWindow};
};

}  // namespace tumble
