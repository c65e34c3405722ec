/// \file
/// \brief The command line of a chapter's program.
#pragma once

#include "driver/figure.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace tumble::chapters {

/// Computes figures as the command line asks: the whole `main` of a chapter's program.
///
/// `[--list] [--figure NAME] [--set KEY=VALUE]... [--quick] [--out DIR]`. Each figure leaves its
/// tables, `NAME.csv` and perhaps `NAME_<table>.csv`, and `NAME_numbers.csv` with the numbers that
/// it is about. Every file begins with the command, the parameters and the units.
///
/// \param argc     as main got it
/// \param argv     as main got it
/// \param chapter  its name: the program is `reproduce_<chapter>`
/// \param folder   of the chapter's sources, with figures.toml
/// \return the exit code: 0 done, 2 bad input, 3 no such result exists, 4 cannot read or write
int run_chapter(int argc, const char* const* argv, const std::string& chapter,
                const std::filesystem::path& folder);

/// The comment lines that every file of a figure begins with.
/// \param program   the program's name
/// \param figure    the figure
/// \param settings  its parameters in this run
/// \param quick     whether --quick was given
/// \return lines that begin with "# "; the settings are shown as "default" if nothing was changed
std::string head_of(std::string_view program, const Figure& figure, const Parameters& settings,
                    bool quick);

/// The numbers of a figure as a file, with everything that the index page shows of it.
/// \param head    from head_of()
/// \param figure  the figure
/// \param result  what was computed
/// \return the bytes of `NAME_numbers.csv`
std::string numbers_file(const std::string& head, const Figure& figure, const Result& result);

}  // namespace tumble::chapters
