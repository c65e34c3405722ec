/// \file
/// \brief The errata of the search for impacts, T5 to T7: each adds its tables and numbers to the figure.
#pragma once

#include "driver/figure.hpp"

namespace tumble::chapters {

// T5: only the end of a step is tested, and bodies pass through one another.
void add_pass_erratum(Result& result);

// T6 and T7: nothing says that a search gets any further than the one before.
void add_progress_errata(int cap, Result& result);

}  // namespace tumble::chapters
