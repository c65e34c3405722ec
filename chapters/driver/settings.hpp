/// \file
/// \brief Settings as a command line has them, for experiments and tests.
#pragma once

#include "tumble/base/parameters.hpp"
#include "tumble/techniques.hpp"

#include <string>
#include <vector>

namespace tumble::chapters {

// Changes several parameters.
inline void set_all(Parameters& parameters, const std::vector<std::string>& settings) {
  for (const std::string& setting : settings) parameters.assign(setting);
}

}  // namespace tumble::chapters
