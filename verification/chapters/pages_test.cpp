/// \file
/// \brief Pages that are made from numbers: what they say, what they escape, what they refuse.
#include "driver/pages.hpp"

#include "chapters/scratch.hpp"
#include "driver/markup.hpp"
#include "support/test.hpp"

namespace tumble::chapters {
namespace {

const std::string kClaimToEscape = claim_on_speed("A < B \\\\ref C.");

Findings findings_of_rows(const std::string& rows) {
  const Scratch scratch("pages");
  const auto folder = scratch.figure("claim_2_1a_fall", rows);
  static_cast<void>(scratch.figure("gallery_pile", ""));
  return read_findings(folder, {scratch.file("falling/expected.csv",
                                             "figure,quantity,unit,value,tolerance,reason\n"
                                             "claim_2_1a_fall,speed,m/s,3,0.5,exact\n"),
                                scratch.file("falling/claims.toml", kClaimToEscape)});
}

std::string header_with(const std::string& lines) {
  return "/// \\file\n#pragma once\n\nnamespace tumble::tolerance {\n\n" + lines +
         "\n}  // namespace tumble::tolerance\n";
}

std::vector<Tolerance> tolerances_in(const std::string& text) {
  const Scratch scratch("tolerances");
  return read_tolerances(scratch.file("tolerances.hpp", text));
}

}  // namespace

TEST_CASE("Text in HTML keeps browsers and Doxygen from taking it for their own",
          "[unit][ledger]") {
  CHECK(html_text("a<b> & \"c\" \\ref d") == "a&lt;b&gt; &amp; &quot;c&quot; &#92;ref d");
  CHECK(prose_html("below `eps`, a < b") == "below <code>eps</code>, a &lt; b");
}

TEST_CASE("Ledger and index show statement, number, interval, rule and verdict", "[unit][ledger]") {
  const Findings findings = findings_of_rows("speed,m/s,3.25,2,4,20\n");
  for (const std::string& page : {ledger_page(findings), index_page(findings)}) {
    CHECK_THAT(page, Contains("A &lt; B &#92;ref C."));
    CHECK_THAT(page, Contains("<span class=\"verdict confirmed\">confirmed</span>"));
    CHECK_THAT(page, Contains("<strong><span class=\"whole\">3.25 m/s</span></strong>"));
    CHECK_THAT(page, Contains("over 20 random cases"));
    CHECK_THAT(page, Contains("confirmed if ≥ 1, refuted if &lt; 1, qualified in between"));
  }
  const std::string ledger = ledger_page(findings);
  CHECK(ledger.starts_with("# Ledger of claims {#ledger}\n"));
  CHECK_THAT(ledger, Contains("Of 1 claims: 1 confirmed."));
  CHECK_THAT(ledger, Contains("1 verdict stands, in 0 the rule misread the sentence, 0 hang on"));
  CHECK_THAT(ledger, Contains("confirmed</span> <span class=\"reads\">stands</span>"));
  CHECK_THAT(ledger, Contains("\\anchor claim_2_1a\n\\htmlonly\n"));
  CHECK_THAT(ledger, Contains("href=\"figures_of_falling.html#claim_2_1a_fall\""));
  CHECK_FALSE(findings.ledger.at(0).number.value != 3.25);
}

TEST_CASE("A number that left its tolerance is marked on both pages", "[unit][ledger]") {
  const Findings findings = findings_of_rows("speed,m/s,9,,,0\n");
  CHECK_THAT(ledger_page(findings), Contains("not as expected"));
  CHECK_THAT(index_page(findings), Contains("<span class=\"bad\"><span class=\"whole\">9 m/s"));
}

TEST_CASE("Small numbers are read with layer, value, unit, reason and section", "[unit][ledger]") {
  const auto found = tolerances_in(
      header_with("// --- math ----\n\n/// [m/s] Slow, or\n/// not. Reason: so. Really. (3.1)\n"
                  "inline constexpr double slow = 0x1p-3;\n"));
  REQUIRE(found.size() == 1);
  CHECK(found[0].layer == "math");
  CHECK(found[0].name == "slow");
  CHECK(found[0].value == "0x1p-3");
  CHECK(found[0].unit == "m/s");
  CHECK(found[0].meaning == "Slow, or not.");
  CHECK(found[0].reason == "so. Really.");
  CHECK(found[0].section == "3.1");
  CHECK_THAT(tolerances_page(found),
             Contains("<code>slow</code> = <strong><span class=\"whole\">0x1p-3 m/s</span>"));
  CHECK_THAT(tolerances_page(found), Contains("{#tolerances}"));
}

TEST_CASE("A small number without unit, reason or section is refused", "[unit][ledger]") {
  const std::string constant = "inline constexpr double slow = 1e-3;\n";
  for (const char* said : {"", "/// Slow. Reason: so. (3.1)\n", "/// [-] Slow. (3.1)\n",
                           "/// [-] Slow. Reason: so.\n"}) {
    INFO(said);
    CHECK_THROWS_WITH(tolerances_in(header_with(said + constant)),
                      Contains("tolerances.hpp:") && Contains("what it decides. Reason: why."));
  }
}

TEST_CASE("Every small number of the library has unit, reason and section", "[unit][ledger]") {
  const auto found = read_all_tolerances(std::filesystem::path(TUMBLE_SOURCE_DIR) / "src/tumble");
  CHECK(found.size() > 60);
  CHECK(found.front().layer == "base");
  CHECK(std::ranges::any_of(found, [](const Tolerance& one) { return one.layer == "filtering"; }));
}

}  // namespace tumble::chapters
