/// \file
/// \brief Runs of the glued column of figure 6.1, and their errors at the end (thesis 6.2).
#pragma once

#include "tumble/exterior_rotation/glued.hpp"

#include "driver/experiment.hpp"
#include "exterior_rotation/falling_column.hpp"

namespace tumble::chapters {

// A way to integrate the column.
struct ColumnScheme {
  std::string column;  // of tables
  std::string words;   // for readers
  GluedScheme scheme;  // how the motion is integrated
  PoseUpdate pose;     // how bodies are moved
  int order;           // that the angle's error should have
  int stages;          // force solves in a step
};

// The schemes with centres and orientations moved each by itself, and those of several stages.
std::span<const ColumnScheme> separate_schemes();

// The schemes that move bodies by the exponential of their twists.
std::span<const ColumnScheme> exponential_schemes();

// The scheme of a column of tables.
const ColumnScheme& column_scheme(std::string_view column);

// A fall to run.
struct ColumnFall {
  double phi0 = 0.3;  // [rad] of the centre at the start
  double time = 1.0;  // [s] that it falls, from rest
  int count = 4;      // cubes
};

// Settings of a figure for a fall.
// time: [s] that it falls
Parameters fall_parameters(double time);

// The end of a run.
struct ColumnRun {
  double angle_error = 0.0;    // [rad] of the centre at the end, less that of the closed form
  double gap = 0.0;            // [m] column_gap() at the end
  double largest_gap = 0.0;    // [m] largest magnitude of column_gap() after any step
  double largest_apart = 0.0;  // [m] largest distance of any glued point from itself
  int solves = 0;              // systems of joint forces solved: the work
};

// Lets the column fall in equal steps, its joints held.
ColumnRun run_column(const ColumnScheme& scheme, int steps, const ColumnFall& fall = {});

// Lets the column fall in steps as long as an accuracy allows, by dormand_prince.
// accuracy: [-] error allowed in a step
ColumnRun run_column_accurately(double accuracy, const ColumnFall& fall = {});

}  // namespace tumble::chapters
