/// \file
/// \brief Appendix A beside the source: reading, findings, refusals.
#include "driver/appendix_a.hpp"

#include "chapters/scratch.hpp"
#include "support/test.hpp"

namespace tumble::chapters {
namespace {

const std::string kMeant =
    "// [COLLIDE:1-3]\n  // Why.\n  if (a <\n      b)\n    c();\n  d();\n// [COLLIDE:1-3]\n";
const std::string kPrinted =
    "// [COLLIDE:1]\n  if (a && b) {\n// [COLLIDE:1]\n// [COLLIDE:2-3]\n  c();  // it is\n  "
    "d();\n// [COLLIDE:2-3]\n";

std::string listing_with(const std::string& second_line) {
  return "[[listing]]\nid = \"COLLIDE\"\nsection = \"5.2\"\nchapter = \"falling\"\nabout = \"It "
         "falls.\"\n"
         "[[line]]\nid = \"COLLIDE 1\"\nsays = \"If & so.\"\nmeant = \"if (a\"\nerrata = \"C1\"\n" +
         second_line + "[[line]]\nid = \"COLLIDE 3\"\nsays = \"Then.\"\nmeant = \"d()\"\n" +
         "printed = \"d()\"\n";
}

std::string second(const std::string& keys) {
  return "[[line]]\nid = \"COLLIDE 2\"\nsays = \"See.\"\n" + keys;
}

std::vector<AppendixListing> read(const std::string& toml, const std::string& meant = kMeant,
                                  const std::string& printed = kPrinted) {
  const Scratch scratch("appendix");
  const auto folder = scratch.file("src/collide.cpp", meant).parent_path();
  static_cast<void>(scratch.file("src/as_printed/collide_as_printed.cpp", printed));
  return read_appendix(scratch.file("appendix_a.toml", toml), sources_in(folder));
}

std::vector<ErratumEntry> one_erratum() {
  ErratumEntry entry;
  entry.erratum.id = "C1";
  entry.erratum.kind = "misprint";
  entry.erratum.section = "A.2";
  entry.erratum.printed = "No &.";
  entry.erratum.reading = "Times <dt>.";
  return {entry};
}

}  // namespace

TEST_CASE("A printed line gets the statement that its entry points at", "[unit][ledger]") {
  const auto listings = read(listing_with(second("meant = \"c()\"\n")));
  REQUIRE(listings.size() == 1);
  REQUIRE(listings[0].lines.size() == 3);
  const AppendixLine& first = listings[0].lines[0];
  REQUIRE(first.meant.size() == 1);
  CHECK(first.meant[0].first == 3);
  CHECK(first.meant[0].lines == std::vector<std::string>{"if (a <", "    b)", "  c();"});
  REQUIRE(first.printed.size() == 1);
  CHECK(first.printed[0].first == 2);
  CHECK(first.printed[0].lines == std::vector<std::string>{"if (a && b) {"});
  const AppendixLine& next = listings[0].lines[1];
  CHECK(next.printed[0].lines == std::vector<std::string>{"c();  // it is", "d();"});
  CHECK(next.meant[0].lines == std::vector<std::string>{"c();"});
}

TEST_CASE("The page of appendix A links each line to its source and its erratum",
          "[unit][ledger]") {
  const auto listings = read(listing_with(second("meant = \"c()\"\n")));
  const std::string page = appendix_page(listings, one_erratum());
  CHECK(page.starts_with("# Appendix A side by side {#appendix_a}\n"));
  CHECK_THAT(page, Contains("1 listings, 3 numbered lines"));
  CHECK_THAT(page, Contains("## COLLIDE {#appendix_a_collide}"));
  CHECK_THAT(page, Contains("<tbody id=\"collide_1\">"));
  CHECK_THAT(page, Contains("<a href=\"collide_8cpp_source.html#l00003\">line 3</a>"));
  CHECK_THAT(page, Contains("href=\"collide__as__printed_8cpp_source.html#l00002\""));
  CHECK_THAT(page, Contains("if (a &amp;&amp; b) {"));
  CHECK_THAT(page, Contains("<a href=\"errata.html#erratum_C1\">C1</a> (misprint): No &amp;."));
  CHECK_THAT(page, Contains("<strong>Read as:</strong> Times &lt;dt&gt;."));
  CHECK_THAT(page, Contains("<a href=\"#collide_3\">3</a>"));
  CHECK_THROWS_WITH(appendix_page(listings, {}),
                    Contains("COLLIDE 1") && Contains("no erratum 'C1'"));
}

TEST_CASE("A listing with a mistake is refused with file and line", "[unit][ledger]") {
  const std::string good = second("meant = \"c()\"\n");
  CHECK_THROWS_WITH(read(listing_with(second("meant = \"e()\"\n"))),
                    Contains("appendix_a.toml:") && Contains("line COLLIDE 2: ") &&
                        Contains("meant: 'e()' stands in 0 lines"));
  CHECK_THROWS_WITH(read(listing_with("")), Contains("'COLLIDE 2' should stand here"));
  CHECK_THROWS_WITH(read(listing_with(good), "// [COLLIDE:1-2]\nif (a) c();\n// [COLLIDE:1-2]\n"),
                    Contains("line COLLIDE 3: no mark covers it as meant"));
  CHECK_THROWS_WITH(read(listing_with(good), kMeant + "// [COLLIDE:4]\ne();\n// [COLLIDE:4]\n"),
                    Contains("the marks go on to line 4"));
}

TEST_CASE("Every line of appendix A stands beside its source as printed and as meant",
          "[structure][ledger]") {
  const std::filesystem::path root = TUMBLE_SOURCE_DIR;
  const auto listings =
      read_appendix(root / "chapters/appendix_a.toml", sources_in(root / "src/tumble"));
  std::size_t lines = 0;
  std::set<std::string> named;
  for (const AppendixListing& listing : listings) {
    lines += listing.lines.size();
    const std::filesystem::path chapter = root / "chapters" / listing.chapter;
    CHECK((std::filesystem::exists(chapter / "page.md") ||
           std::filesystem::exists(chapter / "algorithm.md")));
    for (const AppendixLine& line : listing.lines)
      named.insert(line.errata.begin(), line.errata.end());
  }
  CHECK(listings.size() == 9);
  CHECK(lines == 151);

  std::set<std::string> known;
  for (const Erratum& erratum : read_of_chapters("errata.toml", read_errata)) {
    known.insert(erratum.id);
    const bool of_appendix = erratum.section.find("A.") != std::string::npos;
    INFO(erratum.place << "no line of chapters/appendix_a.toml names it");
    CHECK((!of_appendix || named.count(erratum.id) == 1));
  }
  for (const std::string& id : named) {
    INFO(id);
    CHECK(known.count(id) == 1);
  }
}

TEST_CASE("Doxygen shows no two files under the name of one that appendix A links to",
          "[structure][ledger]") {
  const std::filesystem::path root = TUMBLE_SOURCE_DIR;
  std::multiset<std::string> names;
  for (const char* folder : {"src", "chapters", "live"})
    for (const auto& path : sources_in(root / folder)) names.insert(path.filename().string());
  const auto listings =
      read_appendix(root / "chapters/appendix_a.toml", sources_in(root / "src/tumble"));
  std::set<std::string> linked;
  for (const AppendixListing& listing : listings)
    for (const AppendixLine& line : listing.lines)
      for (const auto& excerpts : {line.printed, line.meant})
        for (const SourceExcerpt& code : excerpts)
          linked.insert(std::filesystem::path(code.path).filename().string());
  CHECK(linked.size() > 10);
  for (const std::string& name : linked) {
    INFO(name);
    CHECK(names.count(name) == 1);
  }
}

}  // namespace tumble::chapters
