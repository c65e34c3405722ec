/// \file
/// \brief A solution of an island, kept while another one is tried.
#include "tumble/contact_damped/kept_solution.hpp"

#include "tumble/base/index.hpp"

namespace tumble {

void KeptSolution::keep(const Island& island, std::span<const char> in_flight) {
  patches_.clear();
  velocities_.clear();
  in_flight_.clear();
  for (const int contact : island.patch_indices) {
    const ContactPatch& patch = island.all_patches[idx(contact)];
    KeptPatch& kept = patches_.emplace_back(
        KeptPatch{impulses_in(patch), {}, {}, patch.targets_planar, patch.solved_directly});
    for (int i = 0; i < patch.count; ++i) {
      kept.targets[idx(i)] = patch.points[idx(i)].target;
      kept.solver_impulses[idx(i)] = patch.points[idx(i)].solver_impulse;
    }
  }
  for (const int body : island.bodies) {
    velocities_.push_back(island.now[idx(body)]);
    if (!in_flight.empty()) in_flight_.push_back(in_flight[idx(body)]);
  }
}

void KeptSolution::restore(const Island& island, std::span<char> in_flight) const {
  for (std::size_t i = 0; i < patches_.size(); ++i) {
    ContactPatch& patch = island.all_patches[idx(island.patch_indices[i])];
    go_back(patches_[i].impulses, 0.0, patch);
    patch.targets_planar = patches_[i].targets_planar;
    patch.solved_directly = patches_[i].solved_directly;
    for (int k = 0; k < patch.count; ++k) {
      patch.points[idx(k)].target = patches_[i].targets[idx(k)];
      patch.points[idx(k)].solver_impulse = patches_[i].solver_impulses[idx(k)];
    }
  }
  for (std::size_t i = 0; i < velocities_.size(); ++i) {
    island.now[idx(island.bodies[i])] = velocities_[i];
    if (!in_flight.empty()) in_flight[idx(island.bodies[i])] = in_flight_[i];
  }
}

}  // namespace tumble
