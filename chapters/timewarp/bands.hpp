/// \file
/// \brief Boxes on a line as bands in a plane of place and time.
#pragma once

#include "driver/experiment.hpp"

namespace tumble::chapters {

// A point of the plane.
struct Knot {
  double time = 0.0;   // [s]
  double place = 0.0;  // [m] along x, world frame
};

// Where a centre is: straight lines from knot to knot, their times ascending.
using Way = std::vector<Knot>;

// A closed line around an area of the plane; the last knot is the first one again.
using Outline = std::vector<Knot>;

// The ways of bodies that fly freely between events, without gravity.
//
// They know nothing but the start and the impulses: each event changes the momenta of its two
// bodies. What a technique does besides, such as ending overlap, is not in them.
// end: [s] since the start, where the ways end
std::vector<Way> ways_of(const World& start, const EventLog& events, double end);

// Where a centre is at a time.
// time: [s] before its first knot and after its last one the centre stays
// Returns [m] along x
double place_at(const Way& way, double time);

// The area that a body passes over.
// width: [m] of the body
Outline band_of(const Way& way, double width);

// Where two bands lie on one another.
// width: [m] of both bodies, above 0
// least: [m] overlap that counts, above 0: bodies that touch do not overlap
std::vector<Outline> overlaps_of(const Way& first, const Way& second, double width, double least);

}  // namespace tumble::chapters
