/// \file
/// \brief Claims: their files, their rules, their verdicts.
#include "driver/ledger.hpp"

#include "chapters/scratch.hpp"
#include "driver/csv.hpp"
#include "support/test.hpp"

#include <filesystem>

namespace tumble::chapters {
namespace {

using Catch::Matchers::EndsWith;

const char* const kClaim = R"([[claim]]
id = "2.1a"
section = "2.1"
statement = "It falls, \"always\"."
experiment = "A box is dropped."
technique = "basic"
reading = "as_meant"
quantity = "depth of fall"
unit = "m"
confirmed = "<= 5"
refuted = "> 100"
reason = "Five is near."
figure = "claim_2_1a_fall"
test = "A box falls"
reads = "stands"
reads_because = "Because."
)";

// The same with one piece replaced.
std::string with(const std::string& old_text, const std::string& new_text) {
  return replaced(kClaim, old_text, new_text);
}

DrawnFigure drawn(double value, double low, double high, int seeds) {
  CheckedNumber number{.quantity = "depth of fall",
                       .unit = "m",
                       .value = value,
                       .low = low,
                       .high = high,
                       .seeds = seeds};
  return DrawnFigure{.name = "claim_2_1a_fall", .numbers = {number}};
}

DrawnFigure drawn(double value) { return drawn(value, kNan, kNan, 0); }

std::vector<Claim> claims_of(const std::string& text) {
  const Scratch scratch("claims");
  return read_claims(scratch.file("falling/claims.toml", text));
}

}  // namespace

TEST_CASE("A rule decides at, above and below its limits", "[unit][ledger]") {
  const Rule small_is_good = read_rule("<= 5", "> 100");
  CHECK(small_is_good.verdict(-1.0) == Verdict::confirmed);
  CHECK(small_is_good.verdict(5.0) == Verdict::confirmed);
  CHECK(small_is_good.verdict(std::nextafter(5.0, 6.0)) == Verdict::qualified);
  CHECK(small_is_good.verdict(100.0) == Verdict::qualified);
  CHECK(small_is_good.verdict(std::nextafter(100.0, 101.0)) == Verdict::refuted);
  CHECK(small_is_good.verdict(kNan) == Verdict::not_measured);

  const Rule large_is_good = read_rule(">=0.5", "< -1e-3");
  CHECK(large_is_good.verdict(0.5) == Verdict::confirmed);
  CHECK(large_is_good.verdict(std::nextafter(0.5, 0.0)) == Verdict::qualified);
  CHECK(large_is_good.verdict(-1e-3) == Verdict::qualified);
  CHECK(large_is_good.verdict(-2e-3) == Verdict::refuted);

  // Nothing is left in between.
  CHECK(read_rule("<= 0", "> 0").verdict(0.0) == Verdict::confirmed);
  CHECK(read_rule("< 0", ">= 0").verdict(0.0) == Verdict::refuted);
}

TEST_CASE("A rule that one number could both confirm and refute is refused", "[unit][ledger]") {
  CHECK_THROWS_WITH(read_rule("<= 5", ">= 5"), Contains("'<= 5' and '>= 5' can both hold"));
  CHECK_THROWS_WITH(read_rule("< 5", "> 4"), Contains("can both hold"));
  CHECK_THROWS_WITH(read_rule("< 5", "< 4"), Contains("can both hold"));
  CHECK_THROWS_WITH(read_rule("> 4", "> 5"), Contains("can both hold"));
  CHECK_NOTHROW(read_rule("< 5", ">= 5"));
}

TEST_CASE("A text that is no comparison is refused and named", "[unit][ledger]") {
  for (const char* text : {"", "<", "<=", "< ", "5", "= 5", "== 5", "< five", "<= 5 m", "< nan",
                           "> inf", "=< 5", " < 5"}) {
    INFO(text);
    CHECK_THROWS_WITH(read_comparison(text),
                      Contains('\'' + std::string(text) + "' is no comparison"));
  }
}

TEST_CASE("A figure that was not drawn, or with other settings, measures nothing",
          "[unit][ledger]") {
  const auto claims = claims_of(kClaim);
  const LedgerEntry missing = judge(claims, {drawn(kNan)}).at(0);
  CHECK(missing.verdict == Verdict::not_measured);
  CHECK_THAT(missing.note, Contains("make figures"));

  DrawnFigure other = drawn(5.0);
  other.numbers[0].compared = false;
  const LedgerEntry changed = judge(claims, {other}).at(0);
  CHECK(changed.verdict == Verdict::not_measured);
  CHECK_THAT(changed.note, Contains("other settings"));
  CHECK(std::isnan(changed.number.value));
}

TEST_CASE("A claim that is not comparable has a number and no verdict", "[unit][ledger]") {
  std::string text = with("confirmed = \"<= 5\"\nrefuted = \"> 100\"\n", "comparable = false\n");
  const LedgerEntry entry = judge(claims_of(text), {drawn(7.0)}).at(0);
  CHECK(entry.verdict == Verdict::not_comparable);
  CHECK(entry.number.value == 7.0);
  CHECK(entry.note == "Five is near.");
  CHECK(rule_text(entry.claim.confirmed, entry.claim.refuted).empty());
  CHECK_THROWS_WITH(claims_of(with("confirmed", "comparable = false\nconfirmed")),
                    Contains("claim 2.1a: not comparable, so nothing confirms"));
}

TEST_CASE("A figure, quantity or unit that does not exist is an error", "[unit][ledger]") {
  CHECK_THROWS_WITH(judge(claims_of(kClaim), {}),
                    EndsWith("claims.toml:1: claim 2.1a: there is no figure claim_2_1a_fall"));
  CHECK_THROWS_WITH(judge(claims_of(with("depth of fall", "depth")), {drawn(1.0)}),
                    EndsWith("claim 2.1a: figure claim_2_1a_fall has no quantity 'depth'"));
  CHECK_THROWS_WITH(judge(claims_of(with("\"m\"", "\"cm\"")), {drawn(1.0)}),
                    EndsWith("the unit is cm, but claim_2_1a_fall computes it in m"));
}

TEST_CASE("A number over random scenes needs twenty of them and an interval", "[unit][ledger]") {
  const auto claims = claims_of(kClaim);
  CHECK(judge(claims, {drawn(3.0, 2.0, 4.0, 20)}).at(0).verdict == Verdict::confirmed);
  CHECK_THROWS_WITH(judge(claims, {drawn(3.0, 2.0, 4.0, 19)}),
                    Contains("measured over 19 random scenes: take at least 20"));
  CHECK_THROWS_WITH(judge(claims, {drawn(3.0, kNan, kNan, 20)}), Contains("give the interval"));
}

TEST_CASE("Two claims with one id are refused, in one file and in two", "[unit][ledger]") {
  CHECK_THROWS_WITH(claims_of(std::string(kClaim) + kClaim),
                    EndsWith("claims.toml:17: claim 2.1a: this id stands twice"));
  const Scratch scratch("open");
  auto all = read_claims(scratch.file("open_claims.toml",
                                      "[[claim]]\nid = \"2.1a\"\nchapter = \"c\"\nsection = "
                                      "\"2.1\"\nstatement = \"s\"\nexperiment = \"e\"\n"));
  const auto more = claims_of(kClaim);
  all.insert(all.end(), more.begin(), more.end());
  CHECK_THROWS_WITH(judge(all, {drawn(1.0)}), Contains("this id stands also at"));
}

TEST_CASE("An open claim may have its rule already, whole", "[unit][ledger]") {
  const Scratch scratch("ruled");
  const std::string open =
      "[[claim]]\nid = \"2.1a\"\nchapter = \"c\"\nsection = \"2.1\"\nstatement = \"s\"\n"
      "experiment = \"e\"\nconfirmed = \"<= 5\"\nrefuted = \"> 6\"\n";
  CHECK_THROWS_WITH(read_claims(scratch.file("open_claims.toml", open)),
                    Contains("a rule needs quantity, unit and reason"));
  const std::string rest = "quantity = \"q\"\nunit = \"m\"\nreason = \"r\"\n";
  const auto claims = read_claims(scratch.file("open_claims.toml", open + rest));
  CHECK(rule_text(claims.at(0).confirmed, claims.at(0).refuted) ==
        "confirmed if <= 5, refuted if > 6, qualified in between");
  CHECK(judge(claims, {}).at(0).verdict == Verdict::not_measured);
}

TEST_CASE("Every mistake in a file of claims is named with file, line and id", "[unit][ledger]") {
  struct Case {
    std::string text;
    const char* message;
  };
  const std::vector<Case> cases{
      {with("unit = \"m\"\n", ""), "claims.toml:1: claim 2.1a: the key 'unit' is missing"},
      {with("unit = \"m\"", "unit = \"\""), "claim 2.1a: unit: give a text in quotes"},
      {with("unit = \"m\"", "unit = 3"), "claim 2.1a: unit: give a text in quotes"},
      {with("unit", "units"), "claim 2.1a: unknown key 'units'"},
      {with("unit", "comparable = 1\nunit"), "claim 2.1a: comparable: give true or false"},
      {with("confirmed = \"<= 5\"\n", ""), "claim 2.1a: the key 'confirmed' is missing"},
      {with("\"<= 5\"", "\"about 5\""), "claim 2.1a: 'about 5' is no comparison"},
      {with("\"> 100\"", "\"> 1\""), "claim 2.1a: '<= 5' and '> 1' can both hold"},
      {with("as_meant", "mine"), "claim 2.1a: reading 'mine': give as_printed"},
      {with("\"2.1a\"", "\"2.2a\""), "claim 2.2a: the id is not section 2.1 and a letter"},
      {with("\"2.1a\"", "\"2.1\""), "claim 2.1: the id is not section 2.1 and a letter"},
      {with("id = \"2.1a\"\n", ""), "claims.toml:1: claim: the key 'id' is missing"},
      {with("[[claim]]", "[[claims]]"), "'claims': there are only [[claim]] tables here"},
      {with("[[claim]]", "[claim]"), "'claim': there are only [[claim]] tables here"},
      {with("unit = ", "unit "), "claims.toml:9: not TOML"}};
  for (const Case& one : cases) CHECK_THROWS_WITH(claims_of(one.text), Contains(one.message));
  CHECK_THROWS_AS(read_claims("/nowhere/claims.toml"), FileError);
}

TEST_CASE("The ledger as CSV has quotes where commas are and empty cells for open claims",
          "[unit][ledger]") {
  const Scratch scratch("csv");
  auto claims = claims_of(kClaim);
  const auto open =
      read_claims(scratch.file("open_claims.toml",
                               "[[claim]]\nid = \"10.1a\"\nchapter = \"c\"\nsection = \"10.1\"\n"
                               "statement = \"It rests.\"\nexperiment = \"e\"\n"));
  claims.insert(claims.begin(), open.begin(), open.end());
  CHECK(ledger_csv(judge(claims, {drawn(3.0, 2.5, 4.0, 20)})) ==
        "id,section,statement,technique,reading,quantity,unit,value,low,high,seeds,rule,verdict,"
        "reads,reads_because,second,figure,test\n"
        "2.1a,2.1,\"It falls, \"\"always\"\".\",basic,as_meant,depth of fall,m,3,2.5,4,20,"
        "\"confirmed if <= 5, refuted if > 100, qualified in between\",confirmed,stands,Because.,,"
        "claim_2_1a_fall,A box falls\n"
        "10.1a,10.1,It rests.,,,,,,,,,,not measured,,,,,\n");
}

TEST_CASE("Claims are ordered as the thesis is", "[unit][ledger]") {
  CHECK(earlier_in_thesis("2.4a", "2.4.2a"));
  CHECK(earlier_in_thesis("2.4.2a", "2.4.2b"));
  CHECK(earlier_in_thesis("2.4.3b", "2.4.10a"));
  CHECK(earlier_in_thesis("2.9a", "10.1a"));
  CHECK(earlier_in_thesis("5.3", "A.2"));
  CHECK_FALSE(earlier_in_thesis("3.1a", "3.1a"));
  CHECK_FALSE(earlier_in_thesis("4.1a", "3.3.2b"));
}

TEST_CASE("The project's ledger holds 74 claims, each once", "[unit][ledger]") {
  std::vector<Claim> claims = read_of_chapters("claims.toml", read_claims);
  const std::vector<Claim> open = read_claims(chapters_folder() / "open_claims.toml");
  claims.insert(claims.end(), open.begin(), open.end());
  std::set<std::string> ids;
  for (const Claim& claim : claims) ids.insert(claim.id);
  CHECK(claims.size() == 74);
  CHECK(ids.size() == 74);
}

}  // namespace tumble::chapters
