/// \file
/// \brief Values that were chosen, read where they are defined.
#pragma once

#include "driver/check.hpp"
#include "driver/choices.hpp"
#include "driver/tolerances.hpp"

#include <string>
#include <vector>

namespace tumble::chapters {

// A value with its name.
struct ChosenValue {
  std::string name;     // of the setting or constant
  std::string value;    // as it is defined; empty for a figure that was not drawn here
  std::string unit;     // "-" without one
  std::string meaning;  // one line
};

// Where values can come from.
struct ValueSources {
  const std::vector<Tolerance>& constants;  // from read_all_tolerances()
  const std::vector<DrawnFigure>& figures;  // from check_figures()
};

// Reads the values that a choice's `from` names, with blanks between keys and `;` between sources:
// "scene fig6_6: rows speed; technique damped: contact_passes; constants: damped_push; figure
// claim_2_4_3b_synchronising: cages". Scenes and techniques give their defaults.
std::vector<ChosenValue> chosen_values(const Choice& choice, const ValueSources& sources);

}  // namespace tumble::chapters
