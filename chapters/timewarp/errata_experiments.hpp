/// \file
/// \brief The errata of the listings of the synchronised timewarp, each with two numbers (thesis 5.1,
///        A.1).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// T1 to T10: SIMPLESYNCTIMEWARP.
/// \param settings  `cap`
/// \return for each erratum two numbers, and the ways of the cubes or what else shows it
[[nodiscard]] Result measure_simple_errata(const Parameters& settings);

/// F1 to F9: SAFERSYNCTIMEWARP and the caption of figure 5.1.
/// \param settings  `cap`
/// \return as measure_simple_errata()
[[nodiscard]] Result measure_safer_errata(const Parameters& settings);

/// The figures of both: `errata_timewarp_simple` and `errata_timewarp_safer`.
/// \return in this order
[[nodiscard]] std::vector<Figure> errata_figures();

}  // namespace tumble::chapters
