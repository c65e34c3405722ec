/// \file
/// \brief The project's own text files, as the structure tests read them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tumble::structure {

/// A text file of the project.
struct SourceFile {
  std::string path;  ///< from the root of the project, with slashes
  std::string text;  ///< all of it
};

/// What a check has to say: one sentence for each fault, "path:line: fault". A rule holds
/// if there are none.
using Complaints = std::vector<std::string>;

/// Every text file that belongs to the project, in the order of their paths. Folders that are made
/// by building or running (build, runs) and hidden ones other than .ci are left out.
/// \throws std::runtime_error if the source folder has gone or a file cannot be read
std::vector<SourceFile> project_files();

/// The file with a path.
/// \throws std::runtime_error if there is none
const SourceFile& file_called(const std::vector<SourceFile>& files, const std::string& path);

/// The C++ files of one folder, .hpp and .cpp.
/// \param folder  the beginning of their paths, for example "src/"
std::vector<SourceFile> code_in(const std::vector<SourceFile>& files, std::string_view folder);

/// The lines of a text, without their ends.
std::vector<std::string> lines_of(const std::string& text);

/// C++ without its comments and without the insides of its string and character literals, which
/// become blanks: lines and columns stay where they were.
/// \param text C++ source; raw strings are understood
std::string code_of(const std::string& text);

/// The comments of a C++ text, line by line: what follows `//`.
/// \return one string for each line, empty where there is no such comment
std::vector<std::string> comments_of(const std::string& text);

/// Whether a character can be in the middle of a name of C++.
/// \return true for letters, digits and underscores
bool in_name(char c);

/// Which line a place in a text is on, from 1.
std::size_t line_at(const std::string& text, std::size_t offset);

/// How a complaint begins: "path:line: ".
std::string place(const SourceFile& file, std::size_t line);

/// Fails the test with each complaint.
void expect_none(const Complaints& complaints);

}  // namespace tumble::structure
