/// \file
/// \brief The tables that scenes.cpp prints.
#pragma once

#include "scene_list.hpp"
#include "scene_run.hpp"

#include <cstdio>
#include <string>
#include <vector>

namespace scene_bench {

// What the columns of the tables mean.
std::string legend();

// Prints a scene's table, at most 100 characters wide.
void print_table(const SceneChoice& scene, const std::vector<Outcome>& runs,
                 const std::string& reference);

// Writes the names of the columns of write_csv().
void write_csv_head(std::FILE* file);

// Writes a line for each run, with all digits.
void write_csv(std::FILE* file, const SceneChoice& scene, const std::vector<Outcome>& runs);

}  // namespace scene_bench
