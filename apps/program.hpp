/// \file
/// \brief Running other programs.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tumble::app {

/// The exit code of a program that does not exist, as in a shell.
inline constexpr int kNoProgram = 127;

/// Input of a program: hands on some bytes, and returns whether they were taken.
using Feeder = std::function<bool(std::string_view bytes)>;

/// Runs a program and waits for its end. No shell reads the words, so none needs quotes.
/// \param words   the program, looked up in PATH, and its arguments; at least one
/// \param feed    called with what writes to the program's standard input, which ends when this returns or
///                throws; empty: the input is ours
/// \return its exit code, 128 + signal if it was killed, kNoProgram if there is no such program
/// \throws CannotWrite if no process can be made, and whatever `feed` throws, after the program has ended
int run_program(const std::vector<std::string>& words, const std::filesystem::path& folder,
                const std::function<void(const Feeder&)>& feed = {});

}  // namespace tumble::app
