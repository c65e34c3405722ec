/// \file
/// \brief The page of what the thesis leaves open.
#pragma once

#include "driver/findings.hpp"
#include "driver/tolerances.hpp"

#include <string>
#include <vector>

namespace tumble::chapters {

// Every choice: value, reason, and what becomes of the numbers with half and twice the value.
//
// Other pages refer to it by `\ref left_open`, to a choice by `\ref choice_passes "passes"`.
std::string left_open_page(const Findings& findings, const std::vector<Tolerance>& constants);

}  // namespace tumble::chapters
