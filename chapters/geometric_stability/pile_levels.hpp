/// \file
/// \brief All ways to classify boxes as stable, from the thesis's rule to balance (thesis 5.4, 6.3.1).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/geometric_stability/as_printed/set_geometrically_stable_as_printed.hpp"
#include "tumble/geometric_stability/geometrically_stable.hpp"
#include "tumble/geometric_stability/load_proof.hpp"
#include "tumble/geometric_stability/stable_boxes.hpp"
#include "tumble/geometric_stability/static_equilibrium.hpp"
#include "tumble/geometric_stability/tolerances.hpp"
#include "tumble/geometric_stability/towers.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// A way to classify boxes as stable. All with exact supports.
enum class StabilityLevel : std::uint8_t {
  corners,     // four corners on stable bodies: GeometricStability
  hull,        // the hull of the supports covers the outline: GeometricStability
  towers,      // hull, and towers on stable boxes: Towers
  load_proof,  // every load on top can be balanced: LoadProof
  balance,     // whole islands in balance as they are: StaticEquilibrium
  hierarchy    // hull, towers and balance of the rest: StableBoxes
};

// All of them.
inline constexpr std::array<StabilityLevel, 6> kStabilityLevels{
    StabilityLevel::corners,    StabilityLevel::hull,    StabilityLevel::towers,
    StabilityLevel::load_proof, StabilityLevel::balance, StabilityLevel::hierarchy};

// A level in words.
inline std::string name_of(StabilityLevel level) {
  static constexpr std::array names{"corners",
                                    "hull",
                                    "hull and towers",
                                    "every load on top",
                                    "balance of islands",
                                    "hull, towers, balance"};
  return names[static_cast<std::size_t>(level)];
}

// The verdict of a rule on one body.
struct RuleVerdict {
  bool stable = false;    // whether it is geometrically stable
  std::string reason;     // in words
  std::vector<char> all;  // by body index: whether that body is stable
};

// Asks a rule, with exact supports.
inline RuleVerdict verdict_of(StableRule rule, const World& world,
                              std::span<const Contact> contacts, int body) {
  GeometricStability rules({tolerance::exact_vertical, tolerance::exact_corner});
  RuleVerdict verdict;
  rules.run(world, contacts, rule, tolerance::resting_speed, verdict.all);
  verdict.stable = verdict.all[idx(body)] != 0;
  verdict.reason = explanation(world, contacts, rules.verdict(world, body));
  return verdict;
}

inline std::vector<char> by_rule(StableRule rule, const World& world,
                                 std::span<const Contact> contacts) {
  return verdict_of(rule, world, contacts, 0).all;
}

// Stable bodies, and those that they carry, directly or over others.
inline std::vector<char> with_towers(const World& world, std::span<const Contact> contacts) {
  const std::vector<char> firm = by_rule(StableRule::hull, world, contacts);
  Towers towers;
  towers.run(world, contacts, firm);
  std::vector<char> stable = firm;
  for (int b = 0; b < world.count(); ++b) {
    int under = b;
    while (towers.supports()[idx(under)] >= 0) under = towers.supports()[idx(under)];
    if (firm[idx(under)] != 0) stable[idx(b)] = 1;
  }
  return stable;
}

// The bodies that a way calls stable.
inline std::vector<char> called_stable(StabilityLevel level, const World& world,
                                       std::span<const Contact> contacts) {
  if (level == StabilityLevel::corners) return by_rule(StableRule::corners, world, contacts);
  if (level == StabilityLevel::hull) return by_rule(StableRule::hull, world, contacts);
  if (level == StabilityLevel::towers) return with_towers(world, contacts);
  std::vector<char> stable;
  if (level == StabilityLevel::load_proof) {
    LoadProof().run(world, contacts, stable);
  } else if (level == StabilityLevel::balance) {
    StaticEquilibrium equilibrium;
    equilibrium.solve(world, {.contacts = contacts, .loads = {}, .held = {}});
    stable.assign(equilibrium.balanced().begin(), equilibrium.balanced().end());
  } else {
    std::vector<MovingBody> moving;
    load_moving_bodies(world, moving);
    StableBoxes boxes(StableRule::equilibrium);
    const std::span<const char> held = boxes.find(world, moving, contacts);
    stable.assign(held.begin(), held.end());
  }
  return stable;
}

// The bodies that the listing SETGEOMETRICALLYSTABLE calls stable as it is printed.
//
// Its comparisons get the tolerances of `damped`, without which boxes that are turned have no corner
// anywhere.
inline std::vector<char> called_stable_as_printed(const World& world,
                                                  std::span<const Contact> contacts,
                                                  bool vetoes = false) {
  std::vector<PrintedStability> bodies(world.bodies().size());
  const PrintedStabilityRepairs repairs{
      .both_bodies = vetoes, .vetoes_last = vetoes, .immovable = vetoes, .tolerances = true};
  set_geometrically_stable_as_printed(world, contacts, repairs, bodies);
  std::vector<char> stable;
  for (const PrintedStability& body : bodies) stable.push_back(body.stable ? 1 : 0);
  return stable;
}

}  // namespace tumble::chapters
