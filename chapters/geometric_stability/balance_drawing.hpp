/// \file
/// \brief Structures from the side, and how they start to move, as tables for gnuplot.
#pragma once

#include "tumble/dynamics/wrench.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// A table of boxes seen along z.
Table boxes_table();

// Adds the boxes of a world.
void add_boxes(const World& world, double view, std::span<const Acceleration> motion, Table& table);

// Start of a motion of boxes, seen along z.
struct StartOfMotion {
  Table outlines;     // "outlines": edges of the boxes a moment later, as vectors
  Table arrows;       // "arrows": from each centre that moves, along its way, longer
  double time = 0.0;  // [s] that moment: the way of a point is a t²/2
};

// Draws the start of a motion from rest.
// way: [m] of the fastest corner until the moment that is drawn
StartOfMotion start_of_motion(const World& world, std::span<const Acceleration> motion, double way);

}  // namespace tumble::chapters
