/// \file
/// \brief Included before everything else in the module of the live page: sorts that are small.
///
/// The library sorts some forty kinds of things. Unrolled and inlined as the standard library has them, sorts
/// would be a fifteenth of the module; for size they are half of that, and no step of a simulation is spent
/// on sorting to speak of.
#pragma once

#pragma clang attribute push(__attribute__((minsize)), apply_to = function)
#include <algorithm>
#pragma clang attribute pop
