/// \file
/// \brief Boxes on a line as bands in a plane of place and time.
#pragma once

#include "tumble/dynamics/event_log.hpp"
#include "tumble/dynamics/world.hpp"

#include <vector>

namespace tumble::chapters {

/// A point of the plane.
struct Knot {
  double time = 0.0;   ///< [s]
  double place = 0.0;  ///< [m] along x, world frame
};

/// Where a centre is: straight lines from knot to knot, their times ascending.
using Way = std::vector<Knot>;

/// A closed line around an area of the plane; the last knot is the first one again.
using Outline = std::vector<Knot>;

/// The ways of bodies that fly freely between events, without gravity.
///
/// They know nothing but the start and the impulses: each event changes the momenta of its two
/// bodies. What a technique does besides, such as ending overlap, is not in them.
/// \param start   the bodies at the start; they move along x and do not turn
/// \param events  of each body in the order of their times
/// \param end     [s] since the start, where the ways end
/// \return by index of the body; times are since the start
/// \throws std::invalid_argument for gravity, and for events of a body that go back in time
std::vector<Way> ways_of(const World& start, const EventLog& events, double end);

/// Where a centre is at a time.
/// \param way   at least one knot
/// \param time  [s] before its first knot and after its last one the centre stays
/// \return [m] along x
double place_at(const Way& way, double time);

/// The area that a body passes over.
/// \param way    of its centre, at least one knot
/// \param width  [m] of the body
/// \return the area
Outline band_of(const Way& way, double width);

/// Where two bands lie on one another.
/// \param first   a way
/// \param second  another one, over the same time
/// \param width   [m] of both bodies, above 0
/// \param least   [m] overlap that counts, above 0: bodies that touch do not overlap
/// \return the areas, one for each span of time in which they overlap
std::vector<Outline> overlaps_of(const Way& first, const Way& second, double width, double least);

}  // namespace tumble::chapters
