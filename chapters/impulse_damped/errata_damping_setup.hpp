/// \file
/// \brief What the experiments with the errata of the listings of A.2 have in common.
#pragma once

#include "tumble/dynamics/world.hpp"
#include "tumble/impulse_damped/as_printed/dampen_objects_as_printed.hpp"
#include "tumble/impulse_damped/damped_numbers.hpp"

#include "driver/common_numbers.hpp"
#include "driver/figure.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// Setups of the experiments with errata.
namespace tumble::chapters::errata_setup {

/// One more number of an experiment.
/// \param result  gets it
/// \param name    what it is
/// \param unit    "-" for none
/// \param value   in that unit
inline void add(Result& result, const std::string& name, const std::string& unit, double value) {
  result.quantities.push_back({name, unit, value});
}

/// A cube of 1 m and 1 kg: what the thesis's boxes all are.
/// \return its properties
inline BodyProperties unit_cube() { return box_properties(Vec3::Ones(), 1.0); }

/// The thresholds of that cube in a step, as the technique has them by default.
/// \return in SI units
inline DampedThresholds usual_thresholds() {
  return thresholds_of(DampedNumbers{}, unit_cube(), kGravity, kStep);
}

/// A listing in which one erratum is left, and all others are mended.
/// \param id  of the erratum
/// \return the others
inline DampedErrata all_but(std::string_view id) { return DampedErrata::all().without(id); }

/// A world with one cube.
/// \param position_w  [m] world frame
/// \param momentum_w  [kg m/s] world frame
/// \param spin_w      [kg m²/s] angular momentum, world frame
/// \return the world; the cube has index 0
inline World world_with_cube(const Vec3& position_w, const Vec3& momentum_w,
                             const Vec3& spin_w = Vec3::Zero()) {
  World world;
  const BodyProperties cube = unit_cube();
  BodyState state = make_state(cube, position_w);
  state.linear_momentum_w = momentum_w;
  state.angular_momentum_w = spin_w;
  world.add(cube, state);
  return world;
}

/// DAMPENOBJECTS on all bodies.
/// \param world    in and out
/// \param touched  whether each body has had a contact
/// \param numbers  ε and k; as made, all ε are 0 and all k are 1, so that only what is set acts
/// \param mended   errata
/// \param dt       [s] the step
/// \return what it reports
inline DampenReport dampen(World& world, bool touched, const PrintedNumbers& numbers,
                           const DampedErrata& mended, double dt = kStep) {
  const std::vector<std::uint8_t> flags(world.states().size(), touched ? 1 : 0);
  return dampen_objects_as_printed(world, flags, numbers, dt, RotationRule::splitting, mended);
}

/// What gravity gives to all movable bodies in a step: line 3 of DAMPEDINTEGRATION.
/// \param world  in and out
/// \param dt     [s] the step
inline void add_gravity(World& world, double dt = kStep) {
  for (std::size_t k = 0; k < world.states().size(); ++k)
    if (world.bodies()[k].movable())
      world.states()[k].linear_momentum_w += world.bodies()[k].mass * dt * world.gravity_w;
}

}  // namespace tumble::chapters::errata_setup
