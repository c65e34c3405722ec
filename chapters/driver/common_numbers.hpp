/// \file
/// \brief Numbers that many experiments share.
#pragma once

namespace tumble::chapters {

inline constexpr double kGravity = 9.81;       // [m/s²] of the built-in scenes
inline constexpr double kStep = 1.0 / 60.0;    // [s] the thesis's: 60 frames a second
inline constexpr double kNearNothing = 1e-17;  // errors of 0 are drawn here on a logarithmic axis

}  // namespace tumble::chapters
