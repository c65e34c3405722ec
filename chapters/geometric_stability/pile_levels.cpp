/// \file
/// \brief All ways to classify boxes as stable.
#include "geometric_stability/pile_levels.hpp"

#include "tumble/contact/tolerances.hpp"
#include "tumble/geometric_stability/as_printed/set_geometrically_stable_as_printed.hpp"
#include "tumble/geometric_stability/load_proof.hpp"
#include "tumble/geometric_stability/stable_boxes.hpp"
#include "tumble/geometric_stability/static_equilibrium.hpp"
#include "tumble/geometric_stability/tolerances.hpp"
#include "tumble/geometric_stability/towers.hpp"

namespace tumble::chapters {
namespace {

std::vector<char> by_rule(StableRule rule, const World& world, std::span<const Contact> contacts) {
  return verdict_of(rule, world, contacts, 0).all;
}

// Stable bodies, and those that they carry, directly or over others.
std::vector<char> with_towers(const World& world, std::span<const Contact> contacts) {
  const std::vector<char> firm = by_rule(StableRule::hull, world, contacts);
  Towers towers;
  towers.run(world, contacts, firm);
  std::vector<char> stable = firm;
  for (int b = 0; b < world.count(); ++b) {
    int under = b;
    while (towers.supports()[static_cast<std::size_t>(under)] >= 0)
      under = towers.supports()[static_cast<std::size_t>(under)];
    if (firm[static_cast<std::size_t>(under)] != 0) stable[static_cast<std::size_t>(b)] = 1;
  }
  return stable;
}

}  // namespace

RuleVerdict verdict_of(StableRule rule, const World& world, std::span<const Contact> contacts,
                       int body) {
  GeometricStability rules({tolerance::exact_vertical, tolerance::exact_corner});
  RuleVerdict verdict;
  rules.run(world, contacts, rule, tolerance::resting_speed, verdict.all);
  verdict.stable = verdict.all[static_cast<std::size_t>(body)] != 0;
  verdict.reason = explanation(world, contacts, rules.verdict(world, body));
  return verdict;
}

std::string name_of(StabilityLevel level) {
  switch (level) {
    case StabilityLevel::corners:
      return "corners";
    case StabilityLevel::hull:
      return "hull";
    case StabilityLevel::towers:
      return "hull and towers";
    case StabilityLevel::load_proof:
      return "every load on top";
    case StabilityLevel::balance:
      return "balance of islands";
    case StabilityLevel::hierarchy:
      break;
  }
  return "hull, towers, balance";
}

std::vector<char> called_stable(StabilityLevel level, const World& world,
                                std::span<const Contact> contacts) {
  std::vector<char> stable;
  switch (level) {
    case StabilityLevel::corners:
      return by_rule(StableRule::corners, world, contacts);
    case StabilityLevel::hull:
      return by_rule(StableRule::hull, world, contacts);
    case StabilityLevel::towers:
      return with_towers(world, contacts);
    case StabilityLevel::load_proof:
      LoadProof().run(world, contacts, stable);
      return stable;
    case StabilityLevel::balance: {
      StaticEquilibrium equilibrium;
      equilibrium.solve(world, {.contacts = contacts, .loads = {}, .held = {}});
      stable.assign(equilibrium.balanced().begin(), equilibrium.balanced().end());
      return stable;
    }
    case StabilityLevel::hierarchy:
      break;
  }
  std::vector<MovingBody> moving;
  load_moving_bodies(world, moving);
  StableBoxes boxes(StableRule::equilibrium);
  const std::span<const char> held = boxes.find(world, moving, contacts);
  stable.assign(held.begin(), held.end());
  return stable;
}

std::vector<char> called_stable_as_printed(const World& world, std::span<const Contact> contacts,
                                           bool vetoes) {
  std::vector<PrintedStability> bodies(world.bodies().size());
  const PrintedStabilityRepairs repairs{
      .both_bodies = vetoes, .vetoes_last = vetoes, .immovable = vetoes, .tolerances = true};
  set_geometrically_stable_as_printed(world, contacts, repairs, bodies);
  std::vector<char> stable;
  for (const PrintedStability& body : bodies) stable.push_back(body.stable ? 1 : 0);
  return stable;
}

}  // namespace tumble::chapters
