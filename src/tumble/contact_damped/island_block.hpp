/// \file
/// \brief The block of an island that sweeps leave unsolved (thesis 6.3.1).
#pragma once

#include "tumble/contact_damped/island.hpp"

#include <utility>
#include <vector>

namespace tumble {

/// Finds the bodies of a large island whose patches sweeps still change, so that these can be solved together.
///
/// In a pile that comes to rest sweeps settle most bodies, but not a tower in it that sways. Its patches are a block of
/// Gauss-Seidel like the patches of sweeps, only larger: the impulses of all other patches are held meanwhile.
class IslandBlock {
 public:
  /// \return where a sweep over the island is to note its changes, for find()
  std::span<double> changes(const Island& island);

  /// Finds all patches of the few bodies whose patches have changed most.
  /// \return these patches and all their bodies; `free` are velocities without the impulses of these patches. It is empty if no
  ///         patch has changed much, and valid until the next call
  Island find(const Island& island);

 private:
  void choose(const Island& island);

  std::vector<double> changes_;  // [m/s] by contact, in the last sweep
  // Of the block.
  std::vector<std::pair<double, int>> most_;  // [m/s] of bodies, with their indices
  std::vector<char> chosen_;                  // by body index
  std::vector<int> bodies_;
  std::vector<int> patches_;
  std::vector<int> upward_;
  std::vector<MovingBody> free_;  // by body index
};

}  // namespace tumble
