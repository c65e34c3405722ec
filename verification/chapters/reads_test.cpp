/// \file
/// \brief The second word of a claim, second measurements, and the verdicts that pages state.
#include "driver/reads.hpp"

#include "chapters/scratch.hpp"
#include "driver/csv.hpp"
#include "driver/findings.hpp"
#include "driver/pages.hpp"
#include "support/test.hpp"

namespace tumble::chapters {
namespace {

const std::string kExpectedSpeeds =
    "figure,quantity,unit,value,tolerance,reason\nclaim_2_1a_fall,speed,m/s,3,0,exact\n"
    "claim_2_1a_fall,speed at half,m/s,2,0,exact\nclaim_2_1a_fall,speed at twice,m/s,0,0,exact\n";

const std::string kSpeedRows =
    "speed,m/s,3,,,0\nspeed at half,m/s,2,,,0\nspeed at twice,m/s,0,,,0\n";

const std::string kChoice =
    "[[choice]]\nid = \"height\"\nsection = \"2.1\"\nwhat = \"w\"\nvalue = \"v\"\nwhy = \"y\"\n\n"
    "[[varied]]\nid = \"height, one\"\nchoice = \"height\"\nfigure = \"claim_2_1a_fall\"\n"
    "chosen = \"speed\"\nhalf = \"speed at half\"\n";

const std::string kSecond = R"(
[[second]]
id = "2.1a again"
claim = "2.1a"
scene = "A lower drop."
control = "None falls."
otherwise = "A drop of nothing."
quantity = "speed at half"
unit = "m/s"
confirmed = ">= 3"
refuted = "< 1"
ruled = "2026-11-25"
run = "2026-11-26"
figure = "claim_2_1a_fall"
)";

std::string reading(const std::string& word) {
  return replaced(claim_on_speed("It falls."), "\"stands\"", '"' + word + '"');
}

Findings found(const std::string& claims, const std::string& choices = kChoice,
               const std::string& page = "") {
  const Scratch scratch("reads");
  return read_findings(
      scratch.figure("claim_2_1a_fall", kSpeedRows),
      {scratch.file("falling/expected.csv", kExpectedSpeeds),
       scratch.file("falling/claims.toml", claims), scratch.file("falling/choices.toml", choices),
       scratch.file("falling/page.md", page)});
}

// What the numbers that were written down would give.
std::vector<DrawnFigure> as_expected(const std::vector<std::filesystem::path>& expected) {
  std::vector<DrawnFigure> figures = expected_figures(expected);
  for (DrawnFigure& figure : figures)
    for (CheckedNumber& number : figure.numbers) number.value = number.expected;
  return figures;
}

// Words with one space between them.
std::string unbroken(const std::string& text) {
  std::string words;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n';
    if (!blank) words += c;
    if (blank && !words.empty() && words.back() != ' ') words += ' ';
  }
  return words;
}

}  // namespace

TEST_CASE("A second word that is missing or unknown is refused with file, claim and remedy",
          "[unit][ledger]") {
  const std::string remedy = "give reads = \"stands\", \"rule misread the sentence\" or";
  CHECK_THROWS_WITH(found(replaced(reading("stands"), "reads = \"stands\"\n", "")),
                    Contains("claims.toml:1: claim 2.1a: the key 'reads' is missing: " + remedy));
  CHECK_THROWS_WITH(found(reading("fine")), Contains("claim 2.1a: reads 'fine': " + remedy));
  CHECK_THROWS_WITH(found(reading("hangs on ")), Contains("reads 'hangs on '"));
  CHECK_THROWS_WITH(found(replaced(reading("stands"), "reads_because = \"Because.\"\n", "")),
                    Contains("the key 'reads_because' is missing: say in a sentence"));
  CHECK_THROWS_WITH(found(reading("hangs on colour")),
                    Contains("claim 2.1a: hangs on 'colour': no choice has this id"));
  CHECK(found(reading("rule misread the sentence")).stale.empty());
  CHECK(found(reading("hangs on height")).stale.empty());
}

TEST_CASE("A verdict that another value of a choice changes does not stand", "[unit][ledger]") {
  const std::string changing = replaced(kChoice, "speed at half", "speed at twice");
  CHECK(found(reading("stands")).stale.empty());
  const auto stale = found(reading("stands"), changing).stale;
  REQUIRE(stale.size() == 1);
  CHECK_THAT(stale[0], Contains("reads 'stands', but another value of 'height' changes"));
  CHECK(found(reading("hangs on height"), changing).stale.empty());
}

TEST_CASE("A page gives a verdict and its second word as the ledger does", "[unit][ledger]") {
  const std::string claim = "Claim \\ref claim_2_1a\n\"2.1a\" is ";
  const auto stale = [&](const std::string& page) {
    return found(reading("hangs on height"), kChoice, page).stale;
  };
  CHECK(stale(claim + "**confirmed (hangs on\nheight)**.\n").empty());
  CHECK_THAT(stale(claim + "**confirmed**.\n").at(0), Contains("reads 'hangs on height'"));
  CHECK_THAT(stale(claim + "**refuted (hangs on height)**.\n").at(0), Contains("is confirmed"));
  CHECK_THAT(stale("It is **confirmed (stands)**.\n").at(0), Contains("refer to the claim"));
}

TEST_CASE("A second measurement has its own rule and stands beside the first", "[unit][ledger]") {
  const std::string claims = reading("stands") + kSecond;
  const LedgerEntry entry = found(claims).ledger.at(0);
  CHECK(entry.verdict == Verdict::confirmed);
  REQUIRE(entry.seconds.size() == 1);
  CHECK(entry.seconds[0].verdict == Verdict::qualified);
  CHECK(seconds_text(entry.seconds) == "speed at half: 2 m/s, qualified on 2026-11-26");
  const std::string page = ledger_page(found(claims));
  CHECK_THAT(page, Contains("A lower drop. Control: None falls. Rule of 2026-11-25"));

  const std::string unrun =
      replaced(claims, "run = \"2026-11-26\"\nfigure = \"claim_2_1a_fall\"\n", "");
  CHECK(found(unrun).ledger.at(0).seconds.at(0).verdict == Verdict::not_measured);
  const auto refused = [&](const std::string& old_text, const std::string& new_text) {
    return replaced(claims, old_text, new_text);
  };
  CHECK_THROWS_WITH(found(refused("claim = \"2.1a\"", "claim = \"2.1b\"")),
                    Contains("second 2.1a again: the id is not 2.1b and a word"));
  CHECK_THROWS_WITH(found(refused("run = \"2026-11-26\"\n", "")),
                    Contains("run and figure come together"));
  CHECK_THROWS_WITH(found(refused("2026-11-25", "today")), Contains("give a day"));
  CHECK_THROWS_WITH(found(refused(">= 3", "<= 3")), Contains("can both hold"));
  CHECK_THROWS_WITH(found(refused("otherwise = \"A drop of nothing.\"\n", "")),
                    Contains("the key 'otherwise' is missing"));
}

TEST_CASE("README counts both words as the ledger does", "[unit][ledger]") {
  std::vector<Claim> claims = read_claims(chapters_folder() / "open_claims.toml");
  const std::vector<Claim> measured = read_of_chapters("claims.toml", read_claims);
  claims.insert(claims.end(), measured.begin(), measured.end());
  Findings findings;
  findings.figures = as_expected(files_of_chapters("expected.csv"));
  findings.ledger = judge(claims, findings.figures);
  findings.errata = find_errata(read_of_chapters("errata.toml", read_errata), findings.figures);
  INFO(counts_text(findings));
  CHECK_THAT(unbroken(read_file(chapters_folder() / "../README.md")),
             Contains(unbroken(replaced(counts_text(findings), "\n", ""))));
}

}  // namespace tumble::chapters
