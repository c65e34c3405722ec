/// \file
/// \brief Writing whole lines.
#include "tumble/record/table_file.hpp"

#include "tumble/base/number_text.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace tumble {

namespace {

constexpr std::size_t kBlock = std::size_t{1} << 16U;  // bytes handed to the system at once

// Where a file will be when it is published.
std::filesystem::path published_path(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.parent_path();
  return folder.filename() == kUnfinishedFolder ? folder.parent_path() / path.filename() : path;
}

[[noreturn]] void fail(const std::filesystem::path& path, int reason) {
  throw CannotWrite("tumble: cannot write " + published_path(path).string() + ": " +
                    std::strerror(reason));
}

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view text) {
  // What is no file, such as a pipe, is written as it is. A file is made under another name and renamed, so that
  // there is always a whole one, and so that a link is replaced and not followed.
  std::error_code ignored;
  const bool renamed =
      !std::filesystem::exists(path, ignored) || std::filesystem::is_regular_file(path, ignored);
  std::filesystem::path part = path;
  if (renamed) std::filesystem::remove(part += ".part", ignored);
  errno = 0;
  constexpr int all_may_write = 0666;
  const int made =
      renamed ? O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC : O_WRONLY | O_NOCTTY | O_CLOEXEC;
  const int descriptor = open(part.c_str(), made, all_may_write);
  if (descriptor < 0) fail(path, errno);
  std::FILE* file = fdopen(descriptor, "wb");
  const bool all = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  int reason = all ? 0 : errno;
  if (std::fclose(file) != 0 && reason == 0) reason = errno;
  if (reason == 0 && renamed && std::rename(part.c_str(), path.c_str()) != 0) reason = errno;
  if (reason == 0) return;
  if (renamed) std::filesystem::remove(part, ignored);
  fail(path, reason);
}

TableFile::TableFile(std::filesystem::path path, std::string_view header)
    : path_(std::move(path)), file_(nullptr, std::fclose) {
  errno = 0;
  file_.reset(std::fopen(path_.c_str(), "wb"));
  if (file_ == nullptr) fail(path_, errno);
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);  // blocks are kept here, where rows are known
  pending_.reserve(2 * kBlock);
  pending_.append(header).append("\n");
  row_begin_ = pending_.size();
  flush();
}

TableFile::~TableFile() {
  try {
    flush();
  } catch (const CannotWrite&) {
    // Already cut back to whole rows; errors are reported by flush().
  }
}

void TableFile::separate() {
  if (pending_.size() > row_begin_) pending_ += ',';
}

TableFile& TableFile::cell(double value) {
  separate();
  pending_ += shortest_text(value);
  return *this;
}

TableFile& TableFile::cell(std::int64_t value) {
  separate();
  pending_ += std::to_string(value);
  return *this;
}

TableFile& TableFile::cell(std::string_view value) {
  separate();
  pending_ += csv_cell(value);
  return *this;
}

TableFile& TableFile::cell(const Vec3& value) {
  return cell(value.x()).cell(value.y()).cell(value.z());
}

void TableFile::end_row() {
  pending_ += '\n';
  row_begin_ = pending_.size();
  if (pending_.size() >= kBlock) flush();
}

void TableFile::flush() {
  if (failure_ == 0) {
    errno = 0;
    const std::size_t done = std::fwrite(pending_.data(), 1, row_begin_, file_.get());
    if (done != row_begin_) {
      failure_ = errno != 0 ? errno : EIO;
      // The file may have been renamed since. The first error is reported.
      if (ftruncate(fileno(file_.get()), static_cast<off_t>(written_)) != 0) errno = 0;
    }
  }
  const std::size_t whole = row_begin_;
  pending_.erase(0, whole);
  row_begin_ = 0;
  if (failure_ != 0) fail(path_, failure_);
  written_ += whole;
}

std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
  std::string cell(1, '"');
  for (const char c : text) cell.append(c == '"' ? 2 : 1, c);
  return cell += '"';
}

std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const char c = line[k];
    if (c == '"' && quoted && k + 1 < line.size() && line[k + 1] == '"') {
      cells.back() += c;  // two quotes within quotes are one
      ++k;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

}  // namespace tumble
