/// \file
/// \brief The folder that a command writes into: made, checked, and taken away again.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace tumble {

/// A folder for files that belong together.
///
/// A folder of other origin is never written into: one that is not empty must hold the mark of
/// an earlier output of the same kind, which is then replaced.
class OutputFolder {
 public:
  /// Makes the folder if it is missing, and removes the files of an earlier output.
  /// \param path   where
  /// \param mark   the file by which an earlier output is known, for example "trajectory.csv"
  /// \param files  all files that an output of this kind may have
  /// \throws std::invalid_argument if the path is a file, or a folder that is neither empty nor has
  ///         the mark
  /// \throws CannotWrite if it cannot be made
  OutputFolder(std::filesystem::path path, std::string_view mark,
               std::span<const std::string_view> files);

  /// Where it is.
  /// \return as given
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Removes the files again, and every folder that was made for them.
  void discard() const;

 private:
  void remove_files() const;

  std::filesystem::path path_;
  std::filesystem::path before_;  // the longest part of the path that there was before
  std::span<const std::string_view> files_;
};

}  // namespace tumble
