/// \file
/// \brief Envelope filters: what they show of chatter and of fast bodies, and one corner's path under
///        every filter (thesis 5.5).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// The figures on envelopes: "corner_path", "claim_5_5c_envelope" and "claim_5_5d_fast".
/// \return them
std::vector<Figure> envelope_figures();

/// The path of one corner of the cube that chatters most, as computed and as shown by five filters.
/// \param settings  per_edge, seed, settling, watched
/// \return tables "" (place in the plane by frame and filter), "envelope" (the circle) and "frame"
///         (what is to be seen); the clump as a drawing; numbers about the path
/// \throws std::runtime_error if no cube chatters
Result draw_corner_path(const Parameters& settings);

/// Claim 5.5c: what both envelopes show of bodies that chatter, by the size of the envelope.
/// \param settings  seeds, per_edge, settling, watched
/// \return tables "" (by radius) and "raw" (without a filter); the claim's number
Result sweep_envelope(const Parameters& settings);

/// Claim 5.5d: what both envelopes show of fast bodies.
/// \param settings  seeds, per_edge, duration
/// \return tables "" (one tossed cube by time) and "speeds" (constant speeds); the claim's number
Result follow_fast_bodies(const Parameters& settings);

}  // namespace tumble::chapters
