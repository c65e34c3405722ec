/// \file
/// \brief Reading a file of text, with a limit.
#include "tumble/base/text_file.hpp"

#include "tumble/base/error.hpp"

#include <fstream>
#include <vector>

namespace tumble {

std::string read_text(const std::filesystem::path& path, const std::string& wanted,
                      std::size_t most_mib) {
  const std::size_t most_bytes = most_mib << 20U;
  std::error_code failed;
  const auto kind = std::filesystem::status(path, failed).type();
  require::that(kind != std::filesystem::file_type::not_found,
                path.string() + ": cannot be read: there is no such file");
  require::that(kind != std::filesystem::file_type::directory,
                path.string() + ": is a folder: give " + wanted);
  // Piece by piece: a pipe has no size to ask for.
  std::ifstream in(path, std::ios::binary);
  std::string text;
  std::vector<char> piece(std::size_t{1} << 16U);
  while (in && text.size() <= most_bytes) {
    in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    text.append(piece.data(), static_cast<std::size_t>(in.gcount()));
  }
  require::that(in.eof() || text.size() > most_bytes, path.string() + ": cannot be read");
  require::that(text.size() <= most_bytes, path.string() + ": " + wanted + " has at most " +
                                               std::to_string(most_mib) +
                                               " MiB, this one has more");
  return text;
}

}  // namespace tumble
