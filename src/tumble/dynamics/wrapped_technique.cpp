/// \file
/// \brief Common parts of techniques that wrap another one.
#include "tumble/dynamics/wrapped_technique.hpp"

#include "tumble/base/error.hpp"

#include <utility>

namespace tumble {

WrappedTechnique::WrappedTechnique(std::unique_ptr<Technique> inner) : inner_(std::move(inner)) {
  require::that(inner_ != nullptr, "a technique that goes around another one got none");
}

}  // namespace tumble
