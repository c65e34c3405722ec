/// \file
/// \brief All that a run needs to go on as if nothing had happened.
#pragma once

#include "tumble/dynamics/technique.hpp"

#include <memory>
#include <utility>

namespace tumble {

/// A world and a technique with its memory; a copy is a deep one.
///
/// Going on from a copy gives the same bits as going on from the original. The technique's observer
/// is not part of the state: a copy calls the same one, see Technique::observe().
class Snapshot {
 public:
  /// Keeps a copy of both.
  /// \param technique  what steps them, with its memory
  Snapshot(World world, const Technique& technique)
      : world_(std::move(world)), technique_(technique.clone()) {}

  /// A deep copy. \param other the original
  Snapshot(const Snapshot& other) : Snapshot(other.world_, *other.technique_) {}
  /// A deep copy. \param other the original \return this
  Snapshot& operator=(const Snapshot& other) {
    Snapshot copy(other);
    std::swap(world_, copy.world_);
    std::swap(technique_, copy.technique_);
    return *this;
  }
  ~Snapshot() = default;

  /// Goes on by one step.
  /// \throws std::invalid_argument as the technique does
  StepReport step(double dt) { return technique_->step(world_, dt); }

  /// The bodies; they may be pushed, added and removed between steps.
  [[nodiscard]] World& world() { return world_; }
  /// The bodies as they are now.
  [[nodiscard]] const World& world() const { return world_; }
  /// What steps them, with its memory.
  [[nodiscard]] Technique& technique() { return *technique_; }
  /// What steps them, with its memory.
  [[nodiscard]] const Technique& technique() const { return *technique_; }

 private:
  World world_;
  std::unique_ptr<Technique> technique_;
};

}  // namespace tumble
