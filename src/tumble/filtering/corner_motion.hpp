/// \file
/// \brief Measures of unwanted motion at rest, from a body's corners: amplitude, acceleration, squirm
///        and pops (thesis 5.5).
#pragma once

#include "tumble/dynamics/trajectory.hpp"
#include "tumble/geometry/box.hpp"

#include <array>
#include <span>
#include <vector>

namespace tumble {

/// The corners of a box in one frame, in the order of Box [m], world frame.
using Corners = std::array<Vec3, 8>;

/// The corners of a body, frame by frame.
/// \param body  its constant part, a box
/// \return one for each frame that has the body, in order of time
std::vector<Corners> corner_path(const Trajectory& run, BodyId id, const BodyProperties& body);

/// The largest distance between two positions of a corner: the amplitude of chatter, peak to peak.
/// \param path   corners in successive frames
/// \param least  [m] smaller distances need not be computed, which saves work
/// \return [m] at least `least`
/// \par Cost
/// O(n) where bounds show that it is below `least`, O(n²) else.
double largest_excursion(std::span<const Corners> path, double least = 0.0);

/// The root mean square of the second differences \f$x_{k+1} - 2x_k + x_{k-1}\f$ of all corners.
/// Over \f$g\,\Delta t^2\f$ this is the acceleration of chatter; a free fall has 1.
/// \return [m] 0 for fewer than three frames
double rms_second_difference(std::span<const Corners> path);

/// Frames in the line fit of squirm(); at 60 Hz a sixth of a second from end to end.
inline constexpr int kSquirmFrames = 11;

/// Squirm: the speed of slow motion, as the eye sees it when it cannot follow chatter.
///
/// A straight line is fitted to each corner's positions in kSquirmFrames successive frames; its slope is
/// the corner's slow velocity in the middle frame,
/// \f[ u_k = \frac{\sum_{j=-5}^{5} j\, x_{k+j}}{110\,\Delta t}. \f]
/// Squirm is the root mean square of \f$u_k\f$ over all frames that have five on each side, for the
/// corner where it is largest. A drift counts with its speed; a swing of amplitude a and frequency f
/// well below 1/(11 Δt) with its speed \f$\sqrt2\,\pi f a\f$; an oscillation frame by frame as 0.
/// \param interval  [s] between frames, above 0
/// \return [m/s] 0 for fewer than kSquirmFrames frames
double squirm(std::span<const Corners> path, double interval);

/// The largest displacement of a corner between two poses [m].
double largest_displacement(const Corners& from, const Corners& to);

/// Frames in which a displayed body jumps.
struct Pops {
  int count = 0;         ///< number of such frames
  double largest = 0.0;  ///< [m] largest displacement of a corner in one
};

/// Counts pops: displayed steps that are larger than the computed step between the same two frames, and
/// at least as large as a given length. The size of a step is the largest displacement of a corner.
/// \param least     [m] size of the smallest pop that counts, above 0
/// \throws std::invalid_argument if the two have different lengths
Pops pops(std::span<const Corners> shown, std::span<const Corners> computed, double least);

}  // namespace tumble
