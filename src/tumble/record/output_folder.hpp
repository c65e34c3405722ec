/// \file
/// \brief The folder that a command writes into: locked, marked, and replaced only as a whole.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace tumble {

/// A folder for files that belong together.
///
/// Files are written into a folder `.unfinished` within it, and publish() moves them to their places: until then
/// an earlier output stays as it was, and whatever happens before leaves it alone. The folder is marked by a file
/// `.tumble`, which is locked as long as this object lives: one that is not empty and has no mark of the same kind
/// is refused, and so is one that another process writes into.
class OutputFolder {
 public:
  /// Makes the folder if it is missing, marks and locks it.
  /// \param kind   of the output, one word, for the mark
  /// \param files  all files that an output of this kind may have
  /// \throws std::invalid_argument if the path is a file, a folder that is neither empty nor has the mark, or one
  ///         that another process writes into
  /// \throws CannotWrite if it cannot be made
  OutputFolder(std::filesystem::path path, std::string_view kind,
               std::span<const std::string_view> files);
  /// Takes away what was not published, and every folder that was made for it.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where to write now: the folder, or before publish() the one within it.
  [[nodiscard]] std::filesystem::path path() const;

  /// Removes the files of an earlier output and moves those of this one to their places. Files that are open go on
  /// being written. Nothing happens the second time.
  /// \throws CannotWrite if a file cannot be moved
  void publish();

 private:
  void lock(std::string_view kind);

  std::filesystem::path path_;
  std::filesystem::path before_;  // the longest part of the path that there was before
  std::span<const std::string_view> files_;
  bool empty_ = false;  // at the start
  bool published_ = false;
  int lock_ = -1;  // descriptor of the mark
};

}  // namespace tumble
