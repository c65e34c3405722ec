/// \file
/// \brief The listings of the thesis's appendix A beside the source lines that do them.
#include "driver/appendix_a.hpp"

#include "driver/csv.hpp"
#include "driver/records.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>

namespace tumble::chapters {
namespace {

const RecordForm kListingForm{
    "listing", {"id", "section", "chapter", "about"}, {"mends"}, {}, "line"};
const RecordForm kLineForm{
    "line", {"id", "says"}, {"printed", "meant", "errata", "why"}, {}, "listing"};
constexpr std::size_t kMostLines = 10;  // of a region that is shown as a whole

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// All marked source, by path.
struct MarkedSource {
  std::map<std::string, std::vector<std::string>> lines;
  std::vector<MarkedRegion> regions;
};

MarkedSource read_marked(const std::vector<std::filesystem::path>& sources) {
  MarkedSource all;
  for (const std::filesystem::path& source : sources) {
    const std::string text = read_file(source);
    std::vector<std::string> complaints;
    const std::vector<MarkedRegion> regions = marked_regions(source.string(), text, complaints);
    if (!complaints.empty()) throw std::invalid_argument(complaints.front());
    if (regions.empty()) continue;
    all.lines[source.string()] = lines_of(text);
    all.regions.insert(all.regions.end(), regions.begin(), regions.end());
  }
  return all;
}

bool is_comment(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(' ');
  return begin == std::string::npos || line.compare(begin, 2, "//") == 0;
}

// Whether a statement or the head of a block is over at the end of this line.
bool ends_statement(const std::string& line) {
  const std::string code = line.substr(0, line.find("//"));
  const std::size_t last = code.find_last_not_of(' ');
  return last != std::string::npos && std::string(";{}").find(code[last]) != std::string::npos;
}

void move_left(std::vector<std::string>& lines) {
  if (lines.empty()) return;
  const std::size_t indent = lines.front().find_first_not_of(' ');
  for (std::string& line : lines)
    line.erase(0, std::min(indent, std::min(line.find_first_not_of(' '), line.size())));
}

// All statements of a region.
SourceExcerpt whole_region(const MarkedRegion& region, const std::vector<std::string>& text) {
  SourceExcerpt excerpt{region.path, 0, {}, false};
  for (std::size_t number = region.from + 1; number < region.to; ++number) {
    const std::string& line = text[number - 1];
    if (excerpt.first == 0 && is_comment(line)) continue;
    if (excerpt.first == 0) excerpt.first = number;
    excerpt.cut = excerpt.lines.size() == kMostLines;
    if (excerpt.cut) break;
    excerpt.lines.push_back(line);
  }
  move_left(excerpt.lines);
  return excerpt;
}

// The statement that begins in line `number`.
SourceExcerpt statement_at(std::size_t number, const MarkedRegion& region,
                           const std::vector<std::string>& text) {
  SourceExcerpt excerpt{region.path, number, {}, false};
  for (; number < region.to; ++number) {
    excerpt.lines.push_back(text[number - 1]);
    if (ends_statement(text[number - 1])) break;
  }
  move_left(excerpt.lines);
  return excerpt;
}

// What does a line in one reading.
std::vector<SourceExcerpt> find_code(const MarkedSource& source, const std::string& listing,
                                     const AppendixLine& line, bool as_printed,
                                     const std::string& pieces) {
  const std::string reading = as_printed ? "as printed" : "as meant";
  std::vector<const MarkedRegion*> regions;
  for (const MarkedRegion& region : source.regions) {
    if (region.name == listing && region.as_printed() == as_printed &&
        region.first_line <= line.number && line.number <= region.last_line)
      regions.push_back(&region);
  }
  if (regions.empty())
    throw std::invalid_argument(line.place + "no mark covers it " + reading + ": give one, // [" +
                                listing + ':' + std::to_string(line.number) + ']');
  std::vector<SourceExcerpt> code;
  if (pieces == "-") {
    code.push_back({regions.front()->path, regions.front()->from, {}, false});
    return code;
  }
  if (pieces.empty()) {
    for (const MarkedRegion* region : regions) {
      code.push_back(whole_region(*region, source.lines.at(region->path)));
      if (code.back().lines.empty())
        throw std::invalid_argument(line.place + "there is no code between the marks " + reading);
    }
    return code;
  }
  for (const std::string& piece : lines_of(pieces)) {
    std::size_t found = 0;
    for (const MarkedRegion* region : regions) {
      const std::vector<std::string>& text = source.lines.at(region->path);
      for (std::size_t number = region->from + 1; number < region->to; ++number) {
        const std::string& here = text[number - 1];
        if (is_comment(here) || here.find(piece) == std::string::npos) continue;
        if (++found == 1) code.push_back(statement_at(number, *region, text));
      }
    }
    if (found != 1)
      throw std::invalid_argument(line.place + (as_printed ? "printed" : "meant") + ": '" + piece +
                                  "' stands in " + std::to_string(found) +
                                  " lines between the marks, not in one");
  }
  return code;
}

}  // namespace

std::vector<std::filesystem::path> sources_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> sources;
  try {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.path().extension() == ".cpp") sources.push_back(entry.path());
  } catch (const std::filesystem::filesystem_error&) {
    throw FileError("cannot read the folder " + folder.string());
  }
  std::ranges::sort(sources);
  return sources;
}

std::vector<AppendixListing> read_appendix(const std::filesystem::path& path,
                                           const std::vector<std::filesystem::path>& sources) {
  const MarkedSource source = read_marked(sources);
  std::vector<AppendixListing> listings;
  for (Record& record : read_records(path, kListingForm)) {
    std::map<std::string, std::string>& texts = record.texts;
    listings.push_back(
        {texts["id"], texts["section"], texts["chapter"], texts["about"], texts["mends"], {}});
  }
  for (Record& record : read_records(path, kLineForm)) {
    std::map<std::string, std::string>& texts = record.texts;
    const std::string name = texts["id"].substr(0, texts["id"].find(' '));
    const auto listing = std::ranges::find_if(
        listings, [&](const AppendixListing& one) { return one.name == name; });
    if (listing == listings.end())
      throw std::invalid_argument(record.place + "there is no [[listing]] called '" + name + '\'');
    AppendixLine line{.number = static_cast<int>(listing->lines.size()) + 1, .place = record.place};
    const std::string expected = name + ' ' + std::to_string(line.number);
    if (texts["id"] != expected)
      throw std::invalid_argument(record.place + '\'' + expected + "' should stand here");
    line.says = texts["says"];
    line.errata = words_of(texts["errata"]);
    line.why = texts["why"];
    if ((texts["printed"] == "-" || texts["meant"] == "-") && line.why.empty())
      throw std::invalid_argument(record.place + "'-' needs a why");
    line.printed = find_code(source, name, line, true, texts["printed"]);
    line.meant = find_code(source, name, line, false, texts["meant"]);
    listing->lines.push_back(line);
  }
  for (const AppendixListing& listing : listings) {
    if (listing.lines.empty())
      throw std::invalid_argument(path.string() + ": listing " + listing.name + " has no [[line]]");
    int last = 0;
    for (const MarkedRegion& region : source.regions)
      if (region.name == listing.name) last = std::max(last, region.last_line);
    if (last != static_cast<int>(listing.lines.size()))
      throw std::invalid_argument(listing.lines.back().place + "the marks go on to line " +
                                  std::to_string(last));
  }
  return listings;
}

}  // namespace tumble::chapters
