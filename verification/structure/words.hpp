/// \file
/// \brief Words that may not stand in the sources: functions whose bits differ between machines, tabs,
///        paths of one machine, files too long to read.
#pragma once

#include "structure/source_tree.hpp"

namespace tumble::structure {

/// Calls that make bits depend on compiler, C library or chance, in code of the library.
///
/// The C library's transcendental functions (elementary:: has ours), Eigen's functions that call
/// them, the standard's distributions, hashes and unordered containers, clocks (programs in apps/ may
/// ask them: they write timing.csv), and what em++ 3.1.6 cannot compile. Comments and texts are not looked at.
/// \param files C++ files
/// \return a complaint for each
Complaints forbidden_calls(const std::vector<SourceFile>& files);

/// Files over the limit.
/// \param files  any
/// \param limit  lines
/// \return a complaint for each
Complaints long_files(const std::vector<SourceFile>& files, std::size_t limit);

/// Tabs outside Makefiles, carriage returns, blanks at the end of a line, no end of the last line.
/// \param files any
/// \return a complaint for the first place in each file
Complaints untidy_text(const std::vector<SourceFile>& files);

/// Words that only make sense on the machine or in the notes of their authors.
/// \param files any
/// \return a complaint for each
Complaints private_words(const std::vector<SourceFile>& files);

}  // namespace tumble::structure
