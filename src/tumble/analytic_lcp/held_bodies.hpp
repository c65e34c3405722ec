/// \file
/// \brief Stable boxes as part of the scenery of the contact forces (thesis 5.4).
///
/// Uses the chapter on geometric stability.
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/dynamics/wrench.hpp"
#include "tumble/geometric_stability/stable_boxes.hpp"

#include <span>
#include <vector>

namespace tumble {

/// Leaves stable boxes out of the system of contact forces.
///
/// A box that does not accelerate whatever the forces are is, for all others, an immovable one:
/// contacts among such boxes, and with the ground, go; contacts with others stay. The force that holds
/// it up is the opposite of its weight and of what the others do to it, whatever that is. A
/// speed along which it is held, the error of an earlier flight, is led to 0 as contact forces
/// would.
/// \algorithm{Stable boxes taken for immovable: section 5.4}
/// \verified{Leaving stable boxes out changes no acceleration}
class HeldBodies {
 public:
  /// \param rule that decides which boxes are stable
  explicit HeldBodies(StableRule rule) : rule_(rule), boxes_(rule) {}

  /// Finds the held bodies.
  /// \param contacts  points that rest
  /// \return the bodies, held ones with inverse masses of 0. With the rule `off` it is `bodies`
  std::span<const MovingBody> find(const World& world, std::span<const MovingBody> bodies,
                                   std::span<const Contact> contacts);

  /// The held bodies, by body index: a Hold for each; empty with the rule `off`.
  [[nodiscard]] std::span<const char> held() const { return held_; }

  /// Whether a movable body is held.
  [[nodiscard]] bool holds(const World& world, int body) const {
    return !held_.empty() && held_[static_cast<std::size_t>(body)] != 0 &&
           world.bodies()[static_cast<std::size_t>(body)].movable();
  }

  /// Whether both bodies of a contact are held or immovable, so that no force is known there.
  /// \return false with the rule `off`
  [[nodiscard]] bool both(const Contact& contact) const {
    return !held_.empty() && held_[static_cast<std::size_t>(contact.first)] != 0 &&
           held_[static_cast<std::size_t>(contact.second)] != 0;
  }

  /// What holds them: accelerations that end their speed along which they are held, and the wrenches
  /// that do it, what the others push them with included.
  /// \param relaxation     [s] in which such a speed becomes 0
  /// \param accelerations  by body index; those of held bodies are overwritten
  /// \param wrenches       ditto
  void hold(const World& world, double relaxation, std::span<Acceleration> accelerations,
            std::span<Wrench> wrenches) const;

 private:
  StableRule rule_;
  StableBoxes boxes_;
  std::vector<char> held_;
  std::vector<MovingBody> eased_;
};

}  // namespace tumble
