/// \file
/// \brief From the numbers of bodies and rows, which are ints, to places in the standard library's containers.
#pragma once

#include <cstddef>

namespace tumble {

/// A number as a place in a container: `bodies[idx(k)]`.
constexpr std::size_t idx(int number) { return static_cast<std::size_t>(number); }

}  // namespace tumble
