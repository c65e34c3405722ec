/// \file
/// \brief A chapter has one page or three, in the order of the side bar, and none is too long.
#include "structure/source_tree.hpp"
#include "support/catch.hpp"

#include <regex>

namespace tumble::structure {
namespace {

constexpr std::size_t kMostWords = 5000;        // on a page, those that are folded included
constexpr std::size_t kMostWordsOfIdea = 2100;  // a quarter of an hour

const std::vector<std::string> kThree{"algorithm.md", "idea.md", "measured.md"};

// Words that a reader sees: no comments, formulas, drawings or rules of tables.
std::size_t words_of(std::string page) {
  static const std::vector<std::regex> hidden{
      std::regex(R"(<!--[\s\S]*?-->)"), std::regex(R"(\\f\[[\s\S]*?\\f\])"),
      std::regex(R"(\\f\$[\s\S]*?\\f\$)"), std::regex(R"(<[^>]*>)")};
  static const std::regex word(R"([A-Za-z0-9][\w'.%-]*)");
  for (const std::regex& one : hidden) page = std::regex_replace(page, one, " ");
  return static_cast<std::size_t>(
      std::distance(std::sregex_iterator(page.begin(), page.end(), word), std::sregex_iterator()));
}

// The pages of each chapter: names of files by folder, in alphabetical order.
std::map<std::string, std::vector<std::string>> pages_of(const std::vector<SourceFile>& files) {
  static const std::regex page(R"(chapters/(\w+)/(\w+\.md))");
  std::map<std::string, std::vector<std::string>> pages;
  for (const SourceFile& file : files) {
    std::smatch match;
    if (std::regex_match(file.path, match, page)) pages[match[1]].push_back(match[2]);
  }
  for (auto& [chapter, names] : pages) std::ranges::sort(names);
  return pages;
}

Complaints incomplete_chapters(const std::vector<SourceFile>& files) {
  Complaints complaints;
  for (const auto& [chapter, names] : pages_of(files))
    if (names != kThree && names != std::vector<std::string>{"page.md"})
      complaints.push_back("chapters/" + chapter +
                           ": give idea.md, algorithm.md and measured.md, or page.md alone");
  return complaints;
}

Complaints long_pages(const std::vector<SourceFile>& files) {
  Complaints complaints;
  for (const SourceFile& file : files) {
    const std::string name = file.path.substr(file.path.rfind('/') + 1);
    if (file.path.rfind("chapters/", 0) != 0 || std::ranges::count(kThree, name) == 0) continue;
    const std::size_t most = name == "idea.md" ? kMostWordsOfIdea : kMostWords;
    if (const std::size_t words = words_of(file.text); words > most)
      complaints.push_back(file.path + ": " + std::to_string(words) + " words, more than " +
                           std::to_string(most));
  }
  return complaints;
}

}  // namespace

TEST_CASE("A chapter has one page or three", "[structure]") {
  const SourceFile idea{"chapters/falling/idea.md", ""};
  const SourceFile algorithm{"chapters/falling/algorithm.md", ""};
  const SourceFile measured{"chapters/falling/measured.md", ""};
  const SourceFile page{"chapters/falling/page.md", ""};
  CHECK(incomplete_chapters({idea, measured, algorithm}).empty());
  CHECK(incomplete_chapters({page}).empty());
  CHECK(incomplete_chapters({idea, measured}).size() == 1);
  CHECK(incomplete_chapters({idea, measured, algorithm, page}).size() == 1);

  expect_none(incomplete_chapters(project_files()));
}

TEST_CASE("No page of a chapter of three pages has more than 5000 words, no idea more than 2100",
          "[structure]") {
  const std::string unseen = R"(\f$ a b \f$ \f[ c \f] <b> <!-- figure: its number --> | --- |)";
  for (const auto& [page, most] : {std::pair<std::string, std::size_t>{"idea.md", kMostWordsOfIdea},
                                   {"measured.md", kMostWords}}) {
    INFO(page);
    std::string words;
    for (std::size_t i = 0; i < most; ++i) words += "word ";
    CHECK(long_pages({{"chapters/falling/" + page, words + unseen}}).empty());
    CHECK(long_pages({{"chapters/falling/" + page, words + "more"}}).size() == 1);
    CHECK(long_pages({{"chapters/falling/page.md", words + "more"}}).empty());
  }

  expect_none(long_pages(project_files()));
}

TEST_CASE("Each page of a chapter is read by Doxygen", "[structure]") {
  const auto files = project_files();
  const std::string& doxyfile = file_called(files, "Doxyfile").text;
  for (const auto& [chapter, names] : pages_of(files)) {
    for (const std::string& name : names) {
      INFO("chapters/" << chapter << '/' << name);
      CHECK(doxyfile.find("chapters/" + chapter + '/' + name + ' ') != std::string::npos);
    }
  }
}

}  // namespace tumble::structure
