/// \file
/// \brief Making and checking a folder.
#include "tumble/record/output_folder.hpp"

#include "tumble/base/error.hpp"
#include "tumble/record/table_file.hpp"

#include <utility>

namespace tumble {
namespace fs = std::filesystem;

OutputFolder::OutputFolder(fs::path path, std::string_view mark,
                           std::span<const std::string_view> files)
    : path_(std::move(path)), files_(files) {
  std::error_code failed;
  if (fs::exists(path_, failed)) {
    require::that(fs::is_directory(path_, failed),
                  path_.string() + " is a file: give a folder with --out");
    const bool free = fs::is_empty(path_, failed) || fs::exists(path_ / mark, failed);
    require::that(free, path_.string() + " is not empty and has no " + std::string(mark) +
                            ": give another folder with --out, or empty it");
  }
  for (before_ = path_; !before_.empty() && !fs::exists(before_, failed);)
    before_ = before_.parent_path();
  fs::create_directories(path_, failed);
  if (std::error_code unknown; !fs::is_directory(path_, unknown))
    throw CannotWrite("tumble: cannot make the folder " + path_.string() + ": " + failed.message());
  remove_files();  // old ones would not belong to the new output
}

void OutputFolder::remove_files() const {
  std::error_code ignored;
  for (const std::string_view file : files_) fs::remove(path_ / file, ignored);
}

void OutputFolder::discard() const {
  remove_files();
  std::error_code failed;
  for (fs::path made = path_; made != before_ && !failed; made = made.parent_path())
    fs::remove(made, failed);  // fails where something else lies by now
}

}  // namespace tumble
