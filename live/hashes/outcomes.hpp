/// \file
/// \brief State hashes that the module of the live page has to come to, by the library as it is compiled here.
#pragma once

#include "tumble/scenes/library.hpp"
#include "tumble/techniques.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace tumble::live {

/// A built-in scene and a technique.
struct Pair {
  const SceneRecipe& scene;          ///< of the library
  const TechniqueRecipe& technique;  ///< of the library
  Parameters settings;               ///< of the scene
  std::string size;  ///< KEY=VALUE,KEY=VALUE where a scene is smaller than by default, or "-"
};

/// Every scene with every technique.
/// \param full all scenes at the size that they have by default; else large ones are smaller, but for the default
///             technique, since in most techniques they take minutes
/// \return ordered by scene
std::vector<Pair> pairs(bool full);

/// Runs a pair at 60 steps a second.
/// \param pair   scene and technique
/// \param steps  how many
/// \return the steps done and the state hash; or `refused` and why
std::string outcome(const Pair& pair, int steps);

/// What live/ready/record.txt has of the committed page, as the present sources give it: a line for each scene and
/// technique with the names of its settings, then one for each pair: SCENE SIZE TECHNIQUE STEPS HASH, or
/// `refused` in place of the hash. Takes about five seconds: the steps of a pair are few.
/// \return the lines, without line breaks
/// \verified{The committed live page moves as these sources do}
std::vector<std::string> record();

}  // namespace tumble::live
