/// \file
/// \brief Reading the project's own text files.
#include "structure/source_tree.hpp"

#include "support/catch.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace tumble::structure {
namespace fs = std::filesystem;
namespace {

// What the project keeps at its top; anything else there belongs to the user. So is what npm installs.
bool belongs(const std::string& path) {
  static constexpr std::array folders{"src/",          "apps/",  "chapters/", "figures/",
                                      "verification/", "bench/", "examples/", "site/",
                                      "live/",         "cmake/", ".ci/"};
  if (path.find('/') == std::string::npos) return path != ".git";  // a file in a worktree
  if (path.starts_with("live/node_modules/")) return false;
  return std::ranges::any_of(folders, [&](const char* folder) { return path.starts_with(folder); });
}

bool is_text(const fs::path& path) {
  static constexpr std::array endings{".hpp", ".cpp",   ".md",  ".txt",  ".json", ".toml", ".csv",
                                      ".gp",  ".cmake", ".cff", ".html", ".css",  ".js",   ".mjs",
                                      ".in",  ".xml",   ".yml", ".mtx",  ""};
  return std::ranges::find(endings, path.extension().string()) != endings.end();
}

// Where the scanner of code_of() is.
enum class Inside { code, line_comment, block_comment, text, character, raw_text };

}  // namespace

std::vector<SourceFile> project_files() {
  const fs::path root = TUMBLE_SOURCE_DIR;
  if (!fs::exists(root / "CMakeLists.txt"))
    throw std::runtime_error("no project at " + root.string());
  std::vector<SourceFile> files;
  const fs::recursive_directory_iterator end;
  for (fs::recursive_directory_iterator entry(root); entry != end; ++entry) {
    const std::string path = fs::relative(entry->path(), root).generic_string();
    if (entry->is_directory()) {
      if (!belongs(path + '/')) entry.disable_recursion_pending();
      continue;
    }
    if (!entry->is_regular_file() || !belongs(path) || !is_text(entry->path())) continue;
    std::ifstream in(entry->path(), std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) throw std::runtime_error("cannot read " + path);
    files.push_back({path, text.str()});
  }
  std::ranges::sort(files,
                    [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

const SourceFile& file_called(const std::vector<SourceFile>& files, const std::string& path) {
  const auto found =
      std::ranges::find_if(files, [&](const SourceFile& file) { return file.path == path; });
  if (found == files.end()) throw std::runtime_error("there is no " + path);
  return *found;
}

std::vector<SourceFile> code_in(const std::vector<SourceFile>& files, std::string_view folder) {
  std::vector<SourceFile> chosen;
  for (const SourceFile& file : files) {
    const std::string ending = fs::path(file.path).extension().string();
    if (file.path.starts_with(folder) && (ending == ".hpp" || ending == ".cpp"))
      chosen.push_back(file);
  }
  return chosen;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string code_of(const std::string& text) {
  std::string code = text;
  Inside inside = Inside::code;
  std::string raw_end;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const char next = i + 1 < text.size() ? text[i + 1] : '\0';
    bool keep = false;
    switch (inside) {
      case Inside::code:
        keep = true;
        if (c == '/' && next == '/') {
          inside = Inside::line_comment;
          keep = false;
        } else if (c == '/' && next == '*') {
          inside = Inside::block_comment;
          keep = false;
        } else if (c == '"' && i > 0 && text[i - 1] == 'R') {
          inside = Inside::raw_text;  // ends with a bracket, what stands before the first, a quote
          raw_end = ')' + text.substr(i + 1, text.find('(', i) - i - 1) + '"';
        } else if (c == '"') {
          inside = Inside::text;
        } else if (c == '\'' &&
                   (i == 0 || !std::isalnum(static_cast<unsigned char>(text[i - 1])))) {
          inside = Inside::character;  // not the separator of 1'000
        }
        break;
      case Inside::line_comment:
        if (c == '\n') inside = Inside::code;
        break;
      case Inside::block_comment:
        if (c == '/' && text[i - 1] == '*') inside = Inside::code;
        break;
      case Inside::text:
      case Inside::character: {
        const char quote = inside == Inside::text ? '"' : '\'';
        if (c == '\\') {
          code[i] = ' ';
          ++i;  // whatever is escaped does not end the literal
        } else if (c == quote) {
          inside = Inside::code;
          keep = true;
        }
        break;
      }
      case Inside::raw_text:
        if (c == '"' && i + 1 >= raw_end.size() &&
            text.compare(i + 1 - raw_end.size(), raw_end.size(), raw_end) == 0) {
          inside = Inside::code;
          keep = true;
        }
        break;
    }
    if (!keep && i < text.size() && text[i] != '\n') code[i] = ' ';
  }
  return code;
}

std::vector<std::string> comments_of(const std::string& text) {
  // A comment is where the code has been blanked from "//" on.
  const std::vector<std::string> all = lines_of(text);
  const std::vector<std::string> code = lines_of(code_of(text));
  std::vector<std::string> comments(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t from = code[i].find_last_not_of(' ');
    const std::size_t start = all[i].find("//", from == std::string::npos ? 0 : from + 1);
    if (start != std::string::npos) comments[i] = all[i].substr(start + 2);
  }
  return comments;
}

bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::size_t line_at(const std::string& text, std::size_t offset) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text.size()));
  return 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n'));
}

std::string place(const SourceFile& file, std::size_t line) {
  return file.path + ':' + std::to_string(line) + ": ";
}

void expect_none(const Complaints& complaints) {
  for (const std::string& complaint : complaints) FAIL_CHECK(complaint);
}

}  // namespace tumble::structure
