/// \file
/// \brief The filters, by name.
#pragma once

#include "tumble/filtering/pose_filter.hpp"

#include <memory>
#include <span>
#include <string_view>

namespace tumble {

/// A filter that can be selected by name.
struct FilterRecipe {
  std::string_view name;     ///< its name
  std::string_view form;     ///< with its parameters, for example "box[:FRAMES=5[,causal]]"
  std::string_view summary;  ///< one line
};

/// All filters, in the order of the chapter.
std::span<const FilterRecipe> filter_library();

/// Makes a filter from its text form: a name, a colon, parameters with their units.
///
/// `box:5`, `box:5,causal`, `envelope:0.01m,1deg`, `soft_envelope:10mm,0.02rad`,
/// `one_euro:1Hz`, `one_euro:1Hz,16`, `one_euro:1Hz,16,1Hz`. Omitted parameters have their defaults;
/// a name alone is enough. Lengths are in `m` or `mm`, angles in `deg` or `rad`, cutoffs in `Hz`; the
/// gain of the one-euro filter is written without its unit.
/// \return the filter; its text() gives the same filter again
/// \throws std::invalid_argument naming the mistake and the correct form
std::unique_ptr<PoseFilter> filter_of(std::string_view text);

}  // namespace tumble
