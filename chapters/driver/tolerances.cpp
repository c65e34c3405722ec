/// \file
/// \brief The small numbers of the library, read from their headers.
#include "driver/tolerances.hpp"

#include "driver/csv.hpp"

#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

namespace tumble::chapters {
namespace {

const char* const kFile = "tolerances.hpp";
const std::string kBegin = "namespace tumble::tolerance {";
const std::string kEnd = "}  // namespace tumble::tolerance";

// The docstring, whose lines have been joined by blanks.
Tolerance read_docstring(const std::string& text) {
  static const std::regex form(R"( \[([^\]]+)\] (.+)\. Reason: (.+)\. \(([^()]+)\))");
  std::smatch match;
  if (!std::regex_match(text, match, form))
    throw std::invalid_argument("give /// [unit] what it decides. Reason: why. (section)");
  return Tolerance{.unit = match[1],
                   .meaning = match[2].str() + '.',
                   .reason = match[3].str() + '.',
                   .section = match[4]};
}

// Reads line after line; what a constant needs has to come before it.
class Reader {
 public:
  void read(const std::string& line) {
    static const std::regex layer("// --- (.+?) -+");
    static const std::regex constant("inline constexpr (?:double|int) (\\w+) = ([^ ;]+);");
    std::smatch match;
    if (line.starts_with("///")) {
      docstring_ += line.substr(3);
    } else if (std::regex_match(line, match, constant)) {
      Tolerance tolerance = read_docstring(docstring_);
      tolerance.layer = layer_;
      tolerance.name = match[1];
      tolerance.value = match[2];
      found.push_back(tolerance);
      docstring_.clear();
    } else if (!docstring_.empty()) {
      throw std::invalid_argument("a docstring without its constant");
    } else if (std::regex_match(line, match, layer)) {
      layer_ = match[1];
    } else if (!line.empty()) {
      throw std::invalid_argument("give inline constexpr double (or int) name = value;");
    }
  }

  std::vector<Tolerance> found;

 private:
  std::string layer_;
  std::string docstring_;
};

}  // namespace

std::vector<Tolerance> read_tolerances(const std::filesystem::path& path) {
  std::istringstream in(read_file(path));
  Reader reader;
  std::size_t number = 0;
  bool within = false;
  bool ended = false;
  for (std::string line; std::getline(in, line);) {
    ++number;
    ended = ended || line == kEnd;
    try {
      if (within && !ended) reader.read(line);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(path.string() + ':' + std::to_string(number) + ": '" + line +
                                  "': " + error.what());
    }
    within = within || line == kBegin;
  }
  if (!within || !ended || reader.found.empty())
    throw std::invalid_argument(path.string() + ": no constants between '" + kBegin + "' and '" +
                                kEnd + '\'');
  return reader.found;
}

std::vector<Tolerance> read_all_tolerances(const std::filesystem::path& library) {
  std::vector<Tolerance> all = read_tolerances(library / "base" / kFile);
  std::set<std::filesystem::path> others;  // a directory has no order
  for (const auto& folder : std::filesystem::directory_iterator(library))
    if (folder.path().filename() != "base" && std::filesystem::exists(folder.path() / kFile))
      others.insert(folder.path() / kFile);
  for (const std::filesystem::path& path : others) {
    const std::vector<Tolerance> more = read_tolerances(path);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace tumble::chapters
