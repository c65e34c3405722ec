/// \file
/// \brief Choices that the thesis leaves open: reading, verdicts of other values, refusals.
#include "driver/choices.hpp"

#include "chapters/scratch.hpp"
#include "driver/pages.hpp"
#include "support/test.hpp"

namespace tumble::chapters {
namespace {

const char* const kExpectedOfFall =
    "figure,quantity,unit,value,tolerance,reason\n"
    "claim_2_1a_fall,speed,m/s,3,0.5,exact\n"
    "claim_2_1a_fall,\"the same, half\",m/s,0.5,0.5,exact\n"
    "claim_2_1a_fall,\"the same, double\",m/s,6,0.5,exact\n"
    "claim_2_1a_fall,depth,m,1,0.5,exact\n";
const char* const kRows =
    "speed,m/s,3,2,4,20\n\"the same, half\",m/s,0.5,,,0\n\"the same, "
    "double\",m/s,6,,,0\ndepth,m,1,,,0\n";

std::string choice_with(const std::string& keys) {
  return "[[choice]]\nid = \"height\"\nsection = \"2.1\"\nwhat = \"How <high>\"\nwhy = \"So.\"\n" +
         keys;
}

std::string varied_with(const std::string& keys) {
  return "[[varied]]\nid = \"one\"\nchoice = \"height\"\nfigure = \"claim_2_1a_fall\"\nchosen = "
         "\"speed\"\n" +
         keys;
}

const std::string kHalf = "half = \"the same, half\"\ndouble = \"the same, double\"\n";

Findings findings_with(const std::string& choices, const std::string& rows = kRows) {
  const Scratch scratch("choices");
  const auto folder = scratch.figure("claim_2_1a_fall", rows);
  return read_findings(folder, {scratch.file("falling/expected.csv", kExpectedOfFall),
                                scratch.file("falling/claims.toml", claim_on_speed("It falls.")),
                                scratch.file("falling/choices.toml", choices)});
}

std::vector<ChosenValue> values_from(const std::string& from) {
  Choice choice{.from = from, .place = "choices.toml:1: choice height: "};
  DrawnFigure figure{.name = "fall"};
  figure.head["title"] = "Fall";
  figure.parameters = {"rows = 5 [-] of the pyramid", "speed = 2 [m/s] of it"};
  return chosen_values(choice,
                       {{{"base", "slow", "1e-3", "m/s", "It is slow.", "So.", "2.1"}}, {figure}});
}

}  // namespace

TEST_CASE("A claim gets a verdict for half and twice the value of a choice", "[unit][ledger]") {
  const Findings findings = findings_with(choice_with("value = \"1 m\"\n") + varied_with(kHalf));
  REQUIRE(findings.choices.size() == 1);
  REQUIRE(findings.choices[0].numbers.size() == 1);
  const VariedEntry& entry = findings.choices[0].numbers[0];
  CHECK(entry.claim == "2.1a");
  CHECK(entry.chosen.verdict == Verdict::confirmed);
  REQUIRE(entry.changed.size() == 2);
  CHECK(entry.changed[0].change == "half");
  CHECK(entry.changed[0].number.value == 0.5);
  CHECK(entry.changed[0].verdict == Verdict::refuted);
  CHECK(entry.changed[1].verdict == Verdict::confirmed);
  CHECK(entry.changes_verdict());
  const std::string page = left_open_page(findings, {});
  CHECK(page.starts_with("# What the thesis leaves open {#left_open}\n"));
  CHECK_THAT(page, Contains("There are 1 choice; 1 of them"));
  CHECK_THAT(
      page,
      Contains("is confirmed; other values of \\ref choice_height \"height\" give refuted (half)"));
  CHECK_THAT(page, Contains("How &lt;high&gt;"));
  CHECK_THAT(page, Contains("href=\"ledger.html#claim_2_1a\""));
}

TEST_CASE("A number that decides nothing is shown without a verdict", "[unit][ledger]") {
  const Findings findings = findings_with(
      choice_with("value = \"1 m\"\n") +
      "[[varied]]\nid = \"one\"\nchoice = \"height\"\nfigure = \"claim_2_1a_fall\"\nchosen = "
      "\"the same, half\"\nother = \"the same, double\"\nchange = \"twelve times\"\n");
  const VariedEntry& entry = findings.choices.at(0).numbers.at(0);
  CHECK(entry.claim.empty());
  CHECK(entry.chosen.verdict == Verdict::not_comparable);
  CHECK_FALSE(entry.changes_verdict());
  CHECK_THAT(left_open_page(findings, {}), Contains("twelve times:"));
}

TEST_CASE("A choice whose numbers were not computed says what to run", "[unit][ledger]") {
  const Findings findings =
      findings_with(choice_with("value = \"1 m\"\n") + varied_with(kHalf), "depth,m,1,,,0\n");
  const VariedEntry& entry = findings.choices.at(0).numbers.at(0);
  CHECK(entry.chosen.verdict == Verdict::not_measured);
  CHECK_FALSE(entry.changes_verdict());
  CHECK_THAT(left_open_page(findings, {}), Contains("make figures"));
}

TEST_CASE("Values of a choice are read where they are defined", "[unit][ledger]") {
  const auto values = values_from(
      "scene fig6_6: rows; technique damped: contact_passes; constants: slow; figure fall: speed");
  REQUIRE(values.size() == 4);
  CHECK(values[0].name == "rows");
  CHECK(values[1].value == "10");
  CHECK(values[2].value == "1e-3");
  CHECK(values[2].unit == "m/s");
  CHECK(values[3].value == "2");
  CHECK(values[3].unit == "m/s");
  CHECK(values[3].meaning == "of it");
  CHECK(values_from("").empty());
  for (const auto& [from, message] :
       {std::pair{"scene fig6_6: lines", "fig6_6 has no setting 'lines'"},
        {"constants: fast", "no constant 'fast'"},
        {"figure fall: mass", "no parameter 'mass'"},
        {"place x: y", "give scene, technique, constants or figure"}})
    CHECK_THROWS_WITH(values_from(from),
                      Contains("choices.toml:1: choice height: from: ") && Contains(message));
}

TEST_CASE("A choice with a mistake is refused with file and entry", "[unit][ledger]") {
  const std::string good = choice_with("value = \"1 m\"\n");
  const auto refused = [](const std::string& choices, const std::string& message) {
    CHECK_THROWS_WITH(findings_with(choices), Contains("choices.toml:") && Contains(message));
  };
  refused(choice_with(""), "choice height: give a value");
  refused(good, "choice height: no [[varied]] names it");
  refused(choice_with("value = \"1 m\"\nunmeasured = \"Dear.\"\n") + varied_with(kHalf),
          "choice height: it was varied");
  refused(good + varied_with(""), "varied one: give half, double or other");
  refused(good + varied_with("half = \"depth\"\n"), "varied one: 'depth' is in m");
}

TEST_CASE("Every choice of the chapters has a value, a reason, and numbers or a reason for none",
          "[structure][ledger]") {
  std::set<std::filesystem::path> files;
  for (const char* name : {"expected.csv", "claims.toml", "choices.toml"})
    for (const std::filesystem::path& file : files_of_chapters(name)) files.insert(file);
  const Findings findings = read_findings("/nowhere", {files.begin(), files.end()});
  CHECK(findings.choices.size() > 30);
  const auto constants = read_all_tolerances(chapters_folder() / "../src/tumble");
  for (const ChoiceEntry& entry : findings.choices) {
    INFO(entry.choice.place);
    const auto values = chosen_values(entry.choice, {constants, findings.figures});
    CHECK((!values.empty() || !entry.choice.value.empty()));
  }
  CHECK_THAT(left_open_page(findings, constants), Contains("{#left_open_impulse_damped}"));
}

}  // namespace tumble::chapters
