/// \file
/// \brief Quantities with their intervals as columns of a table.
#pragma once

#include "driver/figure.hpp"

#include <array>
#include <string>

namespace tumble::chapters {

// A quantity as three cells of a row.
inline std::array<double, 3> with_interval(const Quantity& quantity) {
  return {quantity.value, quantity.low, quantity.high};
}

// The columns of with_interval(): the name, and with "_low" and "_high".
inline void add_interval_columns(const std::string& name, const std::string& unit,
                                 const std::string& meaning, Table& table) {
  for (const char* end : {"", "_low", "_high"})
    table.columns.push_back({name + end, unit, meaning});
}

}  // namespace tumble::chapters
