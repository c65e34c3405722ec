/// \file
/// \brief Native state hashes of every built-in scene under every technique, for comparison with the module.
#include "hashes/outcomes.hpp"

#include <cstdio>
#include <cstdlib>

using namespace tumble::live;

/// Prints a line for each scene and technique: SCENE SIZE TECHNIQUE STEPS HASH, or `refused` and why in place
/// of the last two. SIZE has the settings of a scene that is smaller than by default.
/// \param count      of the arguments
/// \param arguments  steps; then `full` for all scenes at the size that they have by default. The default
///                   technique always gets that. Then a scene and a technique for these alone. Or `record`, for
///                   tumble::live::record()
/// \return 0, or 2 for other arguments
int main(int count, char** arguments) {
  if (count == 2 && std::string_view(arguments[1]) == "record") {
    for (const std::string& line : record()) std::printf("%s\n", line.c_str());
    return 0;
  }
  const int steps = count > 1 ? std::atoi(arguments[1]) : 0;
  const bool full = count > 2 && std::string_view(arguments[2]) == "full";
  const bool alone = count == 5;
  if (steps < 1 || (count != 2 && !(full && (count == 3 || alone)))) {
    std::fprintf(stderr, "usage: live_hashes STEPS [full [SCENE TECHNIQUE]] | record\n");
    return 2;
  }
  for (const Pair& pair : pairs(full)) {
    if (alone && (pair.scene.name != arguments[3] || pair.technique.name != arguments[4])) continue;
    std::string line(pair.scene.name);
    line.append(" ").append(pair.size).append(" ").append(pair.technique.name).append(" ");
    line.append(outcome(pair, steps));
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
  }
  return 0;
}
