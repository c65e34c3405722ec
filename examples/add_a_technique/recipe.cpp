/// \file
/// \brief The technique as a user names and sets it.
#include "penalty.hpp"

namespace example {
namespace {

using namespace tumble;

// [options]
Parameters options() {
  const PenaltyOptions standard;
  Parameters p;
  p.add_number("spring", standard.spring, 1e-6, 4.0, "-",
               "share of its overlap that a point alone ends in a substep");
  p.add_number("damper", standard.damper, 0.0, 2.0, "-",
               "share of its approach that a point alone ends in a substep");
  p.add_whole("substeps", standard.substeps, 1, 10000, "in which a step is done");
  return p;
}
// [options]

// [make]
std::unique_ptr<Technique> make(const Parameters& p, std::uint64_t /*seed*/) {
  PenaltyOptions options;
  options.spring = p.number("spring");
  options.damper = p.number("damper");
  options.substeps = p.count("substeps");
  return std::make_unique<Penalty>(options);
}
// [make]

}  // namespace

// [recipe]
TechniqueRecipe penalty_recipe() {
  return {"penalty", "2.5.1", "springs and dampers where bodies overlap", options, make};
}
// [recipe]

}  // namespace example
