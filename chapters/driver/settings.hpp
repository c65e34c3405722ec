/// \file
/// \brief Settings as a command line has them, for experiments and tests.
#pragma once

#include "tumble/base/parameters.hpp"
#include "tumble/techniques.hpp"

#include <string>
#include <vector>

namespace tumble::chapters {

/// Changes several parameters.
/// \param parameters  in and out
/// \param settings    each as key=value
/// \throws std::invalid_argument as Parameters::set()
inline void set_all(Parameters& parameters, const std::vector<std::string>& settings) {
  for (const std::string& setting : settings) parameters.assign(setting);
}

}  // namespace tumble::chapters
