/// \file
/// \brief Errata of collisions and contacts in damped integration, measured (thesis A.2).
#pragma once

#include "driver/figure.hpp"

namespace tumble::chapters {

/// D1 to D6, C1 to C11, RK1 to RK4 and RC1 to RC4: each misprint alone in a reading that mends all
/// others, and each choice beside its alternative.
/// \param settings  seconds
/// \return table "": a row for each erratum, in this order, with both numbers; the numbers
Result measure_contact_errata(const Parameters& settings);

/// The figure "errata_contacts".
/// \return with its parameters and caption
Figure contact_errata_figure();

}  // namespace tumble::chapters
