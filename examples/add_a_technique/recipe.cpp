/// \file
/// \brief The recipe of the technique: its name, its options, and how it is made.
#include "penalty.hpp"

#include <tumble/base/options.hpp>

namespace example {
namespace {

using namespace tumble;

// [make]
std::unique_ptr<Technique> make(const Parameters& p, std::uint64_t /*seed*/) {
  return std::make_unique<Penalty>(read_options<PenaltyOptions>(p));
}
// [make]

}  // namespace

// [recipe]
TechniqueRecipe penalty_recipe() {
  return {"penalty", "2.5.1", "springs and dampers where bodies overlap",
          declared_options<PenaltyOptions>, make};
}
// [recipe]

}  // namespace example
