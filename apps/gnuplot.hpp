/// \file
/// \brief Drawing by gnuplot, which runs as a program of its own.
#pragma once

#include <filesystem>
#include <string>

namespace tumble::app {

/// Draws a picture. The script stays beside it, so that it can be changed by hand; a picture that
/// cannot be finished is not left half drawn.
/// \param folder    where script and picture go
/// \param script    name of the script file
/// \param commands  gnuplot commands, from the terminal on; they need not set the output
/// \param picture   name of the picture's file
/// \throws CannotWrite if gnuplot is missing, naming its package, or fails
void draw_with_gnuplot(const std::filesystem::path& folder, const std::string& script,
                       const std::string& commands, const std::string& picture);

}  // namespace tumble::app
