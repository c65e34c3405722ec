/// \file
/// \brief The map of the thesis: all of its sections, in order, each with a place or a reason.
#include "driver/thesis_map.hpp"

#include "chapters/scratch.hpp"
#include "support/test.hpp"

namespace tumble::chapters {
namespace {

std::vector<ThesisSection> map_of(const std::string& text) {
  const Scratch scratch("thesis_map");
  return read_thesis_map(scratch.file("thesis_map.toml", text));
}

std::string section(const std::string& id, const std::string& lines) {
  return "[[section]]\nid = \"" + id + "\"\ntitle = \"Falling\"\n" + lines;
}

const std::string kHere = "state = \"here\"\nabout = \"Fall.\"\npages = \"falling falling_2_1\"\n";

Findings findings_of_a_claim() {
  const Scratch scratch("thesis_map_findings");
  const auto folder = scratch.figure("claim_2_1a_fall", "speed,m/s,3,,,0\n");
  return read_findings(folder,
                       {scratch.file("falling/expected.csv",
                                     "figure,quantity,unit,value,tolerance,reason\n"
                                     "claim_2_1a_fall,speed,m/s,3,0.5,exact\n"),
                        scratch.file("falling/claims.toml", claim_on_speed("It is fast."))});
}

}  // namespace

TEST_CASE("The map of the thesis has each of its sections once and in order", "[unit][ledger]") {
  const auto sections = read_thesis_map(chapters_folder() / "thesis_map.toml");
  std::vector<std::string> ids;
  std::set<std::string> figures;
  for (const ThesisSection& one : sections) {
    ids.push_back(one.id);
    for (const std::string& name : one.figures)
      figures.insert(name.substr(0, name.find('_', name.find('_') + 1)));
  }
  CHECK(ids == std::vector<std::string>{
                   "1.1",   "1.2",   "2.1",   "2.2",   "2.3",   "2.4.1", "2.4.2", "2.4.3",
                   "2.5.1", "2.5.2", "2.6.1", "2.6.2", "2.6.3", "2.6.4", "2.6.5", "2.7.1",
                   "2.7.2", "3.1",   "3.2",   "3.3",   "3.3.1", "3.3.2", "4.1",   "4.2",
                   "4.3",   "4.4",   "4.5",   "5.1",   "5.2",   "5.3",   "5.4",   "5.5",
                   "6.1",   "6.2",   "6.3.1", "6.3.2", "6.4",   "A.1",   "A.2"});
  CHECK(figures == std::set<std::string>{"fig5_1", "fig5_2", "fig5_3", "fig5_4", "fig5_5", "fig5_6",
                                         "fig6_1", "fig6_2", "fig6_3", "fig6_4", "fig6_5", "fig6_6",
                                         "fig6_7"});
}

TEST_CASE("From chapter 3 on every section of the thesis is in this book", "[unit][ledger]") {
  for (const ThesisSection& one : read_thesis_map(chapters_folder() / "thesis_map.toml")) {
    INFO(one.id);
    if (one.id >= "3") CHECK(one.state == "here");
  }
}

TEST_CASE("A section of the map shows its pages, claims, verdicts and tests", "[unit][ledger]") {
  const std::string page =
      thesis_map_page(map_of(section("2.1", kHere) + section("2.2", "state = \"not yet\"\n")),
                      findings_of_a_claim());
  CHECK_THAT(page, Contains("\\anchor map_2_1 <strong>2.1</strong> Falling"));
  CHECK_THAT(page, Contains("Fall.<br>\\ref falling; \\ref falling_2_1"));
  CHECK_THAT(page, Contains("<a href=\"ledger.html#claim_2_1a\">2.1a</a> <span class=\"verdict "));
  CHECK_THAT(page, Contains("<summary>1 test</summary>"));
  CHECK_THAT(page, Contains("<strong>not yet</strong>"));
}

TEST_CASE("A map with a wrong state, no reason or another order is refused", "[unit][ledger]") {
  CHECK_THROWS_WITH(map_of(section("2.1", "state = \"maybe\"\n")),
                    Contains("2.1") && Contains("state 'maybe'"));
  CHECK_THROWS_WITH(map_of(section("2.1", "state = \"here\"\n")), Contains("give pages and about"));
  CHECK_THROWS_WITH(map_of(section("2.1", "state = \"out of scope\"\n")), Contains("because"));
  CHECK_THROWS_WITH(map_of(section("2.1", kHere) + section("1.1", kHere)),
                    Contains("does not come after 2.1"));
}

TEST_CASE("A map without a claim's section or with an unknown figure is refused",
          "[unit][ledger]") {
  const Findings findings = findings_of_a_claim();
  CHECK_THROWS_WITH(thesis_map_page(map_of(section("2.2", kHere)), findings),
                    Contains("no section 2.1"));
  CHECK_THROWS_WITH(
      thesis_map_page(map_of(section("2.1", kHere + "figures = \"fig9_9_none\"\n")), findings),
      Contains("no figure is called fig9_9_none"));
}

}  // namespace tumble::chapters
