/// \file
/// \brief Every way to tell who stands firm, from the thesis's rule to balance (thesis 5.4, 6.3.1).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/dynamics/world.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace tumble::chapters {

/// A way to tell who stands firm. All with exact supports.
enum class StabilityLevel : std::uint8_t {
  corners,     ///< four corners on stable bodies: GeometricStability
  hull,        ///< the hull of the supports covers the outline: GeometricStability
  towers,      ///< hull, and towers on what is stable: Towers
  load_proof,  ///< every load on top can be balanced: LoadProof
  balance,     ///< whole islands in balance as they are: StaticEquilibrium
  hierarchy    ///< hull, towers and balance of what is left: StableBoxes
};

/// All of them.
inline constexpr std::array<StabilityLevel, 6> kStabilityLevels{
    StabilityLevel::corners,    StabilityLevel::hull,    StabilityLevel::towers,
    StabilityLevel::load_proof, StabilityLevel::balance, StabilityLevel::hierarchy};

/// A level in words.
/// \param level  which
/// \return for example "towers on top"
std::string name_of(StabilityLevel level);

/// Who stands firm.
/// \param level     by which way
/// \param world     bodies at rest
/// \param contacts  what touches, in any order
/// \return one for each body index, not 0 if it is called stable; immovable bodies are
std::vector<char> called_stable(StabilityLevel level, const World& world,
                                std::span<const Contact> contacts);

/// Who stands firm by the listing SETGEOMETRICALLYSTABLE as it is printed.
///
/// Its comparisons get the tolerances of `damped`, without which boxes that are turned have no corner
/// anywhere.
/// \param world     bodies at rest
/// \param contacts  what touches; their order matters
/// \param vetoes    whether what speaks against a body counts for both bodies of a contact, never for
///                  immovable ones, and cannot be overruled later: errata G2, G3 and G4 mended
/// \return one for each body index
std::vector<char> called_stable_as_printed(const World& world, std::span<const Contact> contacts,
                                           bool vetoes = false);

}  // namespace tumble::chapters
