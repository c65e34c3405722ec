/// \file
/// \brief The direction of includes: layers, licences, the form of headers.
#pragma once

#include "structure/source_tree.hpp"

namespace tumble::structure {

/// Includes that point upwards, or across between programs that share only the library.
///
/// base < math < geometry < dynamics < contact < chapters' folders < techniques, scenes, record, pictures <
/// apps, chapters, live, verification, bench. Tests may include the experiments of chapters.
/// \param files C++ files with their paths in the project
/// \return a complaint for each include that is not allowed, and for folders of src that no
///         layer is known for
Complaints upward_includes(const std::vector<SourceFile>& files);

/// Names of chapters and of their ideas in the layers below them, comments included; in base also ids of
/// errata.
/// \param files C++ files
/// \return a complaint for each line that has one
Complaints chapters_named_below(const std::vector<SourceFile>& files);

/// Folders of the same height in src that include one another in a circle.
/// \param files C++ files
/// \return a complaint naming a circle
Complaints include_circles(const std::vector<SourceFile>& files);

/// Includes that would bring a licence or a dependency where it must not be: GSL and Catch2 in src
/// or apps, toml++ in headers and outside scenes and chapters, CLI11 outside apps, tinygltf outside
/// pictures.
/// \param files C++ files
/// \return a complaint for each
Complaints misplaced_dependencies(const std::vector<SourceFile>& files);

/// Files that do not begin with their \\file and \\brief lines, headers whose first directive is
/// not `#pragma once`.
/// \param files C++ files
/// \return a complaint for each
Complaints unnamed_files(const std::vector<SourceFile>& files);

}  // namespace tumble::structure
