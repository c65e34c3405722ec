/// \file
/// \brief The small numbers of `record`.
#pragma once

namespace tumble::tolerance {

// --- record -------------------------------------------------------------------------------

/// [-] Up to this gap two bodies count as touching in measurements of chatter, as a share of the
/// shortest edge of the two. Reason: too small to be seen, well above the gaps that techniques
/// leave. (3.3.2)
inline constexpr double touching = 5e-3;

/// [-] A duration that is this part of a step longer than a whole number of steps is one of whole
/// steps. Reason: rounding of 10 s / (1/60 s), well below any remainder that a user asks for. (2.1)
inline constexpr double step_remainder = 1e-9;

/// [-] Energy that a run may gain, as a share of the kinetic energy at the start and the sum of m g L. Reason: ten times
/// what the default technique gains in all but one of a thousand random worlds. (3.3.2)
inline constexpr double energy_gain = 0.05;

/// [-] The same that is not booked, with the largest kinetic energy so far. Reason: twenty times what the techniques leave that
/// book all they do. (3.3.2)
inline constexpr double unbooked_gain = 0.01;

/// [-] How deep a body may be left in another one, as a share of the shortest edge. Reason: seen in any picture; springs
/// let a box sink in by a tenth of it. (2.5.1)
inline constexpr double deep_overlap = 0.1;

/// [-] A body stays in place if it moves by less than this share of what it would fall from rest meanwhile. Reason: free
/// flight within three steps covers thirty times that. (5.3)
inline constexpr double hang_move = 0.01;

/// [-] Steps for which it has to, at least. Reason: in two a body may rise and fall back to where it was. (5.3)
inline constexpr double hang_steps = 2.5;

/// [rad] A body that turns by more in a step is reported. Reason: above it the energy of free bodies changes by
/// percents and their contacts are found where they no longer are. (3.1)
inline constexpr double most_turn = 1.0;

/// [-] Share of a body's edges that counts when it is asked whether one body went through another. Reason: two
/// that slide along each other, or touch, do not. (2.1)
inline constexpr double core_share = 0.9;

/// [-] How far a corner turns in a part of a step, as a share of the shortest edge. Reason: a fifth of what `core_share`
/// leaves out. (2.1)
inline constexpr double turn_in_part = 0.02;

/// [-] Parts of a step in which a body turns, at most. Reason: a rod of twenty widths that turns by two radians takes as
/// many. (2.1)
inline constexpr int most_parts_of_way = 1000;

}  // namespace tumble::tolerance
