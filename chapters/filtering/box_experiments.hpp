/// \file
/// \brief What the box filter does: its response, spectra, widths, and means of orientations (thesis
///        5.5; claims 5.5a and 5.5b).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// The figures on the box filter: "box_response", "claim_5_5a_spectra", "claim_5_5b_width" and
/// "errata_filtering".
/// \return them
std::vector<Figure> box_figures();

/// By what the filter multiplies motions of one frequency, measured on bodies that move and turn.
/// \param settings  frames, frequencies, rate
/// \return tables "" (by frequency: measured, exact, errors) and "marks" (zeros, minimum, -3 dB);
///         largest errors, the marks, the delay of the causal form
Result measure_box_response(const Parameters& settings);

/// Claim 5.5a: the settled clump raw and filtered, amplitude, squirm and spectrum.
/// \param settings  seeds, per_edge, settling, watched
/// \return tables "" (by frequency: amplitude of the bodies that chatter, raw and under each filter) and "measures" (by filter: amplitude and squirm over those computed); the claim's
///         number
Result measure_box_spectra(const Parameters& settings);

/// Claim 5.5b: widths from 1 to 15 frames.
/// \param settings  seeds, per_edge, settling, watched, flying, piles
/// \return tables "" (by width: amplitude, squirm, sharpness and overlap) and "impact" (by time: height
///         of a falling cube as computed and as shown); the claim's number
Result measure_box_widths(const Parameters& settings);

/// Erratum P13: means of the components of quaternions, beside means of rotation vectors.
/// \param settings  speeds, fastest, rate
/// \return tables "" (by speed: errors of the means) and "flip" (by frame: the angle shown while the
///         sign of the quaternion changes); the numbers of the erratum
Result measure_component_means(const Parameters& settings);

}  // namespace tumble::chapters
