/// \file
/// \brief All ways to classify boxes as stable, from the thesis's rule to balance (thesis 5.4, 6.3.1).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/geometric_stability/geometrically_stable.hpp"

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
std::string name_of(StabilityLevel level);

// The verdict of a rule on one body.
struct RuleVerdict {
  bool stable = false;    // whether it is geometrically stable
  std::string reason;     // in words
  std::vector<char> all;  // by body index: whether that body is stable
};

// Asks a rule, with exact supports.
RuleVerdict verdict_of(StableRule rule, const World& world, std::span<const Contact> contacts,
                       int body);

// The bodies that a way calls stable.
std::vector<char> called_stable(StabilityLevel level, const World& world,
                                std::span<const Contact> contacts);

// The bodies that the listing SETGEOMETRICALLYSTABLE calls stable as it is printed.
//
// Its comparisons get the tolerances of `damped`, without which boxes that are turned have no corner
// anywhere.
std::vector<char> called_stable_as_printed(const World& world, std::span<const Contact> contacts,
                                           bool vetoes = false);

}  // namespace tumble::chapters
