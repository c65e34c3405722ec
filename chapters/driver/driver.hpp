/// \file
/// \brief The command line of a chapter's program.
#pragma once

#include "driver/figure.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace tumble::chapters {

// Computes figures as the command line asks: the whole `main` of a chapter's program.
//
// `[--list] [--figure NAME] [--set KEY=VALUE]... [--quick] [--out DIR]`. Each figure leaves its
// tables, `NAME.csv` and perhaps `NAME_<table>.csv`, and `NAME_numbers.csv` with the numbers that
// it is about. Every file begins with the command, the parameters and the units.
int run_chapter(int argc, const char* const* argv, const std::string& chapter,
                const std::filesystem::path& folder);

// The comment lines that every file of a figure begins with.
std::string head_of(std::string_view program, const Figure& figure, const Parameters& settings,
                    bool quick);

// The numbers of a figure as a file, with everything that the index page shows of it.
std::string numbers_file(const std::string& head, const Figure& figure, const Result& result);

}  // namespace tumble::chapters
