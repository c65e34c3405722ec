/// \file
/// \brief The page of what the thesis leaves open.
#pragma once

#include "driver/findings.hpp"
#include "driver/tolerances.hpp"

#include <string>
#include <vector>

namespace tumble::chapters {

/// Every choice: value, reason, and what becomes of the numbers with half and twice the value.
///
/// Other pages refer to it by `\ref left_open`, to a choice by `\ref choice_passes "passes"`.
/// \param findings   from read_findings()
/// \param constants  from read_all_tolerances()
/// \return the bytes of `left_open.md`
/// \throws std::invalid_argument as chosen_values() does
std::string left_open_page(const Findings& findings, const std::vector<Tolerance>& constants);

}  // namespace tumble::chapters
