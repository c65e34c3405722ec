/// \file
/// \brief Writing whole lines.
#include "tumble/record/table_file.hpp"

#include "tumble/base/number_text.hpp"
#include "tumble/record/csv_cells.hpp"

#include <cerrno>
#include <cstring>

namespace tumble {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 16U;  // bytes handed to the system at once

[[noreturn]] void fail(const std::filesystem::path& path, int reason) {
  throw CannotWrite("tumble: cannot write " + path.string() + ": " + std::strerror(reason));
}

}  // namespace

std::string full_text(double value) { return rounded_text(value, 17); }

void write_file(const std::filesystem::path& path, std::string_view text) {
  errno = 0;
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) fail(path, errno);
  const bool all = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  int reason = all ? 0 : errno;
  if (std::fclose(file) != 0 && reason == 0) reason = errno;
  if (reason == 0) return;
  std::error_code ignored;  // the first error is reported
  if (std::filesystem::symlink_status(path, ignored).type() == std::filesystem::file_type::regular)
    std::filesystem::remove(path, ignored);
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
  pending_ += full_text(value);
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
      std::error_code ignored;  // the first error is reported
      std::filesystem::resize_file(path_, written_, ignored);
    }
  }
  const std::size_t whole = row_begin_;
  pending_.erase(0, whole);
  row_begin_ = 0;
  if (failure_ != 0) fail(path_, failure_);
  written_ += whole;
}

}  // namespace tumble
