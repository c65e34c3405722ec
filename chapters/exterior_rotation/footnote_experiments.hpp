/// \file
/// \brief The footnote answered for joints without glue: where they open, what order is left across that,
///        and contacts that a simulator gets wrong (thesis 6.2; claim 6.2f).
#pragma once

#include "driver/figure.hpp"

namespace tumble::chapters {

/// Where the joints of the falling column open, and what happens then.
/// \param settings  angle, seconds, rate
/// \return tables "" (by time: centres of pressure, their closed forms and errors, angles of the
///         hinges), "events" and "frames" (times of the drawings); drawings "frame1" to "frame6"
Result measure_joint_openings(const Parameters& settings);

/// Errors of poses and of the first opening against the step, before, after and across openings.
/// \param settings  angle, before, after, late, fewest, most
/// \return tables "" (by step and end: errors of rk4, midpoint and semi-implicit Euler, openings
///         located and noticed at the end of a step), "moment" and "adaptive"; orders
Result measure_event_order(const Parameters& settings);

/// Claim 6.2f: changes of contact that the right motion does not have.
/// \param settings  angle, seconds, rate, tolerance, within, per_decade
/// \return tables "" (by scheme: wrong and missed changes), "changes" (one by one) and "sweep" (by
///         tolerance); the claim's number
Result measure_wrong_contacts(const Parameters& settings);

}  // namespace tumble::chapters
