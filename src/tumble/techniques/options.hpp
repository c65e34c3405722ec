/// \file
/// \brief How the techniques of the larger chapters are set: for the list of techniques only.
#pragma once

#include "tumble/base/parameters.hpp"
#include "tumble/dynamics/technique.hpp"

#include <cstdint>
#include <memory>

namespace tumble {

// Each technique has its options with their defaults, and a function that makes it of them. `seed` is used
// by those with chance in them.

Parameters impulse_options();           ///< \return options of `impulse`
Parameters damped_options();            ///< \return options of `damped`
Parameters contact_damped_options();    ///< \return options of `contact_damped`
Parameters timewarp_listing_options();  ///< \return options of `timewarp_simple`, `timewarp_safer`
Parameters timewarp_swept_options();    ///< \return options of `timewarp_swept`
Parameters timewarp_full_options();     ///< \return options of `timewarp_full`
Parameters glued_options();             ///< \return options of `glued`

/// Declares the option `pose` of techniques that can carry bodies (PivotUpdate).
/// \param p gets it
void add_pose(Parameters& p);

/// \param p     its options
/// \param seed  not used
/// \return `impulse`
std::unique_ptr<Technique> make_impulse(const Parameters& p, std::uint64_t seed);
/// \param p     its options
/// \param seed  of chance in fast collisions
/// \return `damped`
/// \throws std::invalid_argument for options that do not go together
std::unique_ptr<Technique> make_damped(const Parameters& p, std::uint64_t seed);
/// \param p     its options
/// \param seed  not used
/// \return `contact_damped`
std::unique_ptr<Technique> make_contact_damped(const Parameters& p, std::uint64_t seed);
/// \param p     its options
/// \param seed  not used
/// \return `timewarp_simple`
/// \throws std::invalid_argument for options that do not go together
std::unique_ptr<Technique> make_timewarp_simple(const Parameters& p, std::uint64_t seed);
/// \param p     its options
/// \param seed  not used
/// \return `timewarp_safer`
/// \throws std::invalid_argument for options that do not go together
std::unique_ptr<Technique> make_timewarp_safer(const Parameters& p, std::uint64_t seed);
/// \param p     its options
/// \param seed  not used
/// \return `timewarp_swept`
std::unique_ptr<Technique> make_timewarp_swept(const Parameters& p, std::uint64_t seed);
/// \param p     its options
/// \param seed  not used
/// \return `timewarp_full`
std::unique_ptr<Technique> make_timewarp_full(const Parameters& p, std::uint64_t seed);
/// \param p     its options
/// \param seed  not used
/// \return `glued`
/// \throws std::invalid_argument for options that do not go together
std::unique_ptr<Technique> make_glued(const Parameters& p, std::uint64_t seed);

}  // namespace tumble
