/// \file
/// \brief The command line of a chapter's program.
#pragma once

namespace tumble::chapters {

// Computes figures as the command line asks: the whole `main` of a chapter's program.
//
// `[--list] [--figure NAME]... [--set KEY=VALUE]... [--quick] [--out DIR]`. Each figure leaves its
// tables, `NAME.csv` and perhaps `NAME_<table>.csv`, and `NAME_numbers.csv` with the numbers that
// it is about. Every file begins with the command, the parameters and the units.
//
// No header of the library or of the language is needed: twelve programs compile this.
int run_chapter(int argc, const char* const* argv, const char* chapter, const char* folder);

}  // namespace tumble::chapters
