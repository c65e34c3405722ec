/// \file
/// \brief Making, locking and replacing a folder.
#include "tumble/record/output_folder.hpp"

#include "tumble/base/error.hpp"
#include "tumble/record/table_file.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace tumble {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kMark = ".tumble";

// Something else than a file may have no end, or no writer.
bool is_marked(const fs::path& folder, std::string_view kind) {
  std::error_code none;
  if (!fs::is_regular_file(fs::symlink_status(folder / kMark, none))) return false;
  std::string word(kind.size() + 1, '\0');
  std::ifstream mark(folder / kMark);
  mark.read(word.data(), static_cast<std::streamsize>(word.size()));
  return mark && word == std::string(kind) + "\n";
}

}  // namespace

OutputFolder::OutputFolder(std::filesystem::path path, std::string_view kind,
                           std::span<const std::string_view> files)
    : path_(std::move(path)), files_(files) {
  std::error_code failed;
  empty_ = true;
  if (fs::exists(path_, failed)) {
    require::that(fs::is_directory(path_, failed),
                  path_.string() + " is a file: give a folder with --out");
    empty_ = fs::is_empty(path_, failed);
    require::that(empty_ || is_marked(path_, kind),
                  path_.string() + " is not empty and not the folder of a " + std::string(kind) +
                      ": give another folder with --out, or empty it");
  }
  for (before_ = path_; !before_.empty() && !fs::exists(before_, failed);)
    before_ = before_.parent_path();
  fs::create_directories(path_, failed);
  if (std::error_code unknown; !fs::is_directory(path_, unknown))
    throw CannotWrite("tumble: cannot make the folder " + path_.string() + ": " + failed.message());
  lock(kind);
  fs::remove_all(path_ / kUnfinishedFolder, failed);  // of a process that was killed
  fs::create_directory(path_ / kUnfinishedFolder, failed);
  if (failed)
    throw CannotWrite("tumble: cannot write into the folder " + path_.string() + ": " +
                      failed.message());
}

void OutputFolder::lock(std::string_view kind) {
  const fs::path mark = path_ / kMark;
  constexpr int all_may_write = 0666;
  lock_ = open(mark.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, all_may_write);
  if (lock_ < 0)
    throw CannotWrite("tumble: cannot write " + mark.string() + ": " + std::strerror(errno));
  if (flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    close(lock_);
    refuse(path_.string() +
           " is being written by another tumble: wait for its end, or give "
           "another folder with --out");
  }
  const std::string text = std::string(kind) + "\n";
  if (ftruncate(lock_, 0) != 0 || write(lock_, text.data(), text.size()) < 0) {
    const std::string reason = std::strerror(errno);
    close(lock_);
    throw CannotWrite("tumble: cannot write " + mark.string() + ": " + reason);
  }
}

OutputFolder::~OutputFolder() {
  std::error_code failed;
  fs::remove_all(path_ / kUnfinishedFolder, failed);
  if (!published_ && empty_) {
    fs::remove(path_ / kMark, failed);
    for (fs::path made = path_; made != before_ && !failed; made = made.parent_path())
      fs::remove(made, failed);  // fails where something else lies by now
  }
  close(lock_);
}

std::filesystem::path OutputFolder::path() const {
  return published_ ? path_ : path_ / kUnfinishedFolder;
}

void OutputFolder::publish() {
  if (published_) return;
  for (const std::string_view file : files_) {
    std::error_code failed;
    fs::remove(path_ / file, failed);
    const fs::path made = path_ / kUnfinishedFolder / file;
    if (!fs::exists(made, failed)) continue;
    fs::rename(made, path_ / file, failed);
    if (failed)
      throw CannotWrite("tumble: cannot write " + (path_ / file).string() + ": " +
                        failed.message());
  }
  std::error_code ignored;
  fs::remove_all(path_ / kUnfinishedFolder, ignored);
  published_ = true;
}

}  // namespace tumble
