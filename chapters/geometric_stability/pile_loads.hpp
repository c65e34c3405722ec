/// \file
/// \brief Loads on the tops of a pile, and the bodies that move under them (thesis 5.4).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/dynamics/wrench.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// The corners of the face of a body that looks up most.
// Returns [m] world frame, in order around the face
std::array<Vec3, 4> top_of(const World& world, int body);

// A load on every movable body: straight down, at any point of its top, from a tenth of its weight
// to a hundred times as much, each power of ten as likely.
std::vector<Wrench> random_loads(const World& world, Random& random);

// Acceleration by a load of a body without contacts, its weight left out.
// Returns [m/s²] see fastest_of()
double alone(const World& world, int body, const Wrench& load);

// The bodies that move under some load, by the whole complementarity problem.
//
// Tried are the weights alone; a load of 10^4 weights on each corner of each top, one at a
// time; and loads on a random half of all corners.
// outlines: by body index, corners [m] in x and z to load instead of those of a box; may be empty, as a
// whole or for a body
std::vector<char> moves_under_loads(const World& world, std::span<const Contact> contacts,
                                    std::span<const std::vector<Vec2>> outlines = {});

}  // namespace tumble::chapters
