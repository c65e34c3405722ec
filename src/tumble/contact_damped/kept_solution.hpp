/// \file
/// \brief A solution of an island, kept while another one is tried.
#pragma once

#include "tumble/contact_damped/island.hpp"

#include <array>
#include <span>
#include <vector>

namespace tumble {

/// The impulses, velocities and targets of an island, kept so that another solution can be tried.
class KeptSolution {
 public:
  /// Keeps those of now.
  /// \param in_flight  by body index: whether a body flies its parabola; empty before that is decided
  void keep(const Island& island, std::span<const char> in_flight = {});
  /// Goes back to them.
  /// \param in_flight  as in keep()
  void restore(const Island& island, std::span<char> in_flight = {}) const;

 private:
  struct KeptPatch {
    PatchImpulses impulses;
    std::array<double, Manifold::kMostPoints> targets;
    std::array<Vec3, Manifold::kMostPoints> solver_impulses;
    bool targets_planar;
    bool solved_directly;
  };
  std::vector<KeptPatch> patches_;
  std::vector<MovingBody> velocities_;  // by its bodies
  std::vector<char> in_flight_;         // ditto
};

}  // namespace tumble
