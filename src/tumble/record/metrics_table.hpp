/// \file
/// \brief The columns of metrics.csv, which summary.json has again at the end and at worst.
#pragma once

#include "tumble/record/metrics.hpp"

#include <span>
#include <string_view>

namespace tumble {

/// One number of a step, as files have it.
struct MetricsColumn {
  std::string_view name;  ///< with its unit at the end, where it has one
  bool whole = false;     ///< a count
  /// Its value.
  double (*value)(const Metrics& metrics, const StepReport& report) = nullptr;
};

/// All numbers of a step, in the order of the file.
std::span<const MetricsColumn> metrics_columns();

}  // namespace tumble
