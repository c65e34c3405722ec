/// \file
/// \brief The lists of the page: scenes, techniques and their settings.
#pragma once

#include <string>

namespace tumble::live {

/// All scenes and techniques with their settings.
/// \return JSON: `version`, `default_technique`, `numbers` (Session::number_names()), `scenes` and
///         `techniques`, each with name, section, summary and settings (key, kind, value, unit, meaning,
///         low, high, choices)
std::string catalogue();

}  // namespace tumble::live
