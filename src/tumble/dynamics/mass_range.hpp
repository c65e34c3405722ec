/// \file
/// \brief The limit on how far apart the masses of a world may be.
#pragma once

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/dynamics/body.hpp"
#include "tumble/dynamics/tolerances.hpp"

#include <limits>
#include <string>
#include <string_view>

namespace tumble {

/// The lightest and the heaviest of the movable bodies of a world.
class MassRange {
 public:
  /// Takes a body in.
  /// \param body  any; an immovable one changes nothing
  /// \throws std::invalid_argument naming the two bodies, if one would be more than
  ///         tolerance::largest_mass_ratio times as heavy as another one; nothing has changed then
  /// \verified{Masses that are too far apart are refused with both names when the world is made}
  void add(const BodyProperties& body, std::string_view name) {
    if (!body.movable()) return;
    if (body.mass > most_ && most_ > 0.0) require_near(body.mass, name, least_, lightest_);
    if (body.mass < least_ && most_ > 0.0) require_near(most_, heaviest_, body.mass, name);
    if (body.mass > most_) {
      most_ = body.mass;
      heaviest_ = name;
    }
    if (body.mass < least_) {
      least_ = body.mass;
      lightest_ = name;
    }
  }

 private:
  static void require_near(double most, std::string_view heavy, double least,
                           std::string_view light) {
    if (most / least <= tolerance::largest_mass_ratio) return;
    const auto named = [](std::string_view name, double mass) {
      std::string text = "\"";
      return text.append(name).append("\" (").append(shortest_text(mass)).append(" kg)");
    };
    refuse("mass: " + named(heavy, most) + " is more than " +
           shortest_text(tolerance::largest_mass_ratio) + " times as heavy as " +
           named(light, least) +
           ": expected less; make the heavy one a fixed box, or the light one heavier");
  }

  double least_ = std::numeric_limits<double>::infinity();  // [kg]
  double most_ = 0.0;                                       // [kg]
  std::string lightest_, heaviest_;                         // names
};

}  // namespace tumble
