/// \file
/// \brief The recipe of the technique: its name, its options, and how it is made.
#include "cushion.hpp"

#include <tumble/base/options.hpp>

namespace example {
namespace {

using namespace tumble;

// [make]
std::unique_ptr<Technique> make(const Parameters& p, std::uint64_t /*seed*/) {
  return std::make_unique<Cushion>(read_options<CushionOptions>(p));
}
// [make]

}  // namespace

// [recipe]
TechniqueRecipe cushion_recipe() {
  return {"cushion", "2.5.1", "springs and dampers where bodies overlap",
          declared_options<CushionOptions>, make};
}
// [recipe]

}  // namespace example
