/// \file
/// \brief The command line of a chapter's program.
#pragma once

#include <filesystem>
#include <string>

namespace tumble::chapters {

// Computes figures as the command line asks: the whole `main` of a chapter's program.
//
// `[--list] [--figure NAME] [--set KEY=VALUE]... [--quick] [--out DIR]`. Each figure leaves its
// tables, `NAME.csv` and perhaps `NAME_<table>.csv`, and `NAME_numbers.csv` with the numbers that
// it is about. Every file begins with the command, the parameters and the units.
int run_chapter(int argc, const char* const* argv, const std::string& chapter,
                const std::filesystem::path& folder);

}  // namespace tumble::chapters
