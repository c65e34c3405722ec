/// \file
/// \brief Numbers that changed, errata, the last line of `make figures`.
#include "driver/findings.hpp"

#include "chapters/scratch.hpp"
#include "driver/csv.hpp"
#include "support/test.hpp"

namespace tumble::chapters {
namespace {

const char* const kExpected =
    "figure,quantity,unit,value,tolerance,reason\n"
    "fig2_1_fall,depth,m,5,0.1,measured\n"
    "claim_2_1a_fall,speed,m/s,3,0,exact\n";

const std::string kClaims = claim_on_speed("It falls.");

const char* const kErratum = R"([[erratum]]
id = "C1"
title = "Down is <up>"
section = "A.1"
kind = "misprint"
printed = "Down is up."
reading = "Down is down."
scene = "drop"
figure = "fig2_1_fall"
failure = "depth"
mended = "depth"
test = "Down is down"
command = "tumble run drop"
)";

}  // namespace

TEST_CASE("The last line counts figures, claims and differences in fixed words", "[unit][ledger]") {
  const Scratch scratch("summary");
  const auto folder = scratch.figure("fig2_1_fall", "depth,m,5.05,,,0\n");
  static_cast<void>(scratch.figure("fig2_1_fall_curves", ""));  // of the same figure
  static_cast<void>(scratch.figure("claim_2_1a_fall", "speed,m/s,3,,,0\n"));
  const Findings findings = read_findings(folder, {scratch.file("falling/expected.csv", kExpected),
                                                   scratch.file("falling/claims.toml", kClaims),
                                                   scratch.file("falling/errata.toml", kErratum)});
  CHECK(differences(findings).empty());
  CHECK(summary_text(findings) ==
        "1 thesis figures, 1 claims measured, 0 not measured, 0 differ from expected");
  CHECK(others_text(findings) == "also 1 figure of claims");
  CHECK(findings.ledger.at(0).claim.chapter == "falling");
  CHECK(findings.figures.at(0).chapter == "falling");
}

TEST_CASE("A changed number is reported with what was expected", "[unit][ledger]") {
  const Scratch scratch("changed");
  const auto folder = scratch.figure("fig2_1_fall", "depth,m,5.125,,,0\nwidth,m,1,,,0\n");
  static_cast<void>(scratch.figure("gallery_pile", "boxes,-,3,,,0\n", "changed"));
  const Findings findings = read_findings(
      folder, {scratch.file("falling/expected.csv", kExpected),
               scratch.file("falling/claims.toml", kClaims),
               scratch.file("falling/page.md", "It is 5.2<!-- fig2_1_fall: depth -->.\n")});
  const std::vector<std::string> wrong = differences(findings);
  REQUIRE(wrong.size() == 4);
  CHECK_THAT(wrong[0], Contains("fig2_1_fall, depth: 5.125 m, expected 5 to within 0.1"));
  CHECK_THAT(wrong[1], Contains("fig2_1_fall, width: 1 m, but no expected.csv knows it"));
  CHECK_THAT(wrong[2], Contains("claim_2_1a_fall, speed: expected, but not computed"));
  CHECK_THAT(wrong[3], Contains("page.md: 5.2 (fig2_1_fall, depth): computed is 5.125"));
  CHECK(summary_text(findings) ==
        "1 thesis figures, 0 claims measured, 1 not measured, 4 differ from expected");
  CHECK(others_text(findings) ==
        "also 1 figure of claims, 1 picture of the gallery, 1 number not compared: drawn with "
        "other settings");
  CHECK(findings.figures.at(2).chapter == "falling");  // known from its command
}

TEST_CASE("A number that Markdown would take for an item of a list is reported", "[unit][ledger]") {
  const Scratch scratch("list");
  const auto folder = scratch.figure("fig2_1_fall", "depth,m,5,,,0\n");
  const auto stale = [&](const std::string& text) {
    return read_findings(folder, {scratch.file("falling/page.md", text)}).stale;
  };
  CHECK(stale("It is\n5<!-- fig2_1_fall: depth -->m. It\nis 5<!-- fig2_1_fall: depth -->. So.\n")
            .empty());
  CHECK(stale("It is\n500 per cent<!-- fig2_1_fall: depth -->. So.\n").empty());
  const std::vector<std::string> wrong = stale("It is\n5<!-- fig2_1_fall: depth -->. So.\n");
  REQUIRE(wrong.size() == 1);
  CHECK_THAT(wrong[0], Contains("would be shown as a list"));
}

TEST_CASE("A film that README shows is the one that was painted", "[unit][ledger]") {
  const Scratch scratch("films");
  const auto folder = scratch.figure("fig2_1_fall", "depth,m,5,,,0\n");
  const auto wrong = [&](const std::string& shown, const std::string& painted) {
    const auto film = scratch.file("films/fig2_1_fall.gif", shown);
    if (!painted.empty()) write_file(folder / "fig2_1_fall.gif", painted);
    return read_findings(folder, {film}).stale;
  };
  CHECK(wrong("GIF89a;", "").empty());
  CHECK(wrong("GIF89a;", "GIF89a;").empty());
  const std::vector<std::string> stale = wrong("GIF89a;", "GIF89a,;");
  REQUIRE(stale.size() == 1);
  CHECK_THAT(stale[0], Contains("fig2_1_fall.gif: is not the film that was painted now"));
}

TEST_CASE("An erratum has the numbers of its figure beside it", "[unit][ledger]") {
  const Scratch scratch("errata");
  const auto expected = scratch.file("falling/expected.csv", kExpected);
  const auto errata = scratch.file("falling/errata.toml", kErratum);
  const auto entry = [&](const std::string& settings) {
    const auto folder = scratch.figure("fig2_1_fall", "depth,m,5,,,0\n", settings);
    return read_findings(folder, {expected, errata}).errata.at(0);
  };
  CHECK(entry("default").failure.value == 5.0);
  CHECK(entry("default").mended.value == 5.0);
  CHECK(entry("default").erratum.chapter == "falling");
  CHECK(std::isnan(entry("changed").failure.value));
}

TEST_CASE("Every mistake in a file of errata is named with file, line and id", "[unit][ledger]") {
  const Scratch scratch("bad_errata");
  const std::string good = kErratum;
  const auto read = [&](const std::string& text) {
    return read_findings("/nowhere", {scratch.file("falling/expected.csv", kExpected),
                                      scratch.file("falling/errata.toml", text)});
  };
  CHECK_NOTHROW(read(good));
  CHECK_THROWS_WITH(
      read(replaced(good, "misprint", "error")),
      Contains("errata.toml:1: erratum C1: kind 'error': give misprint, choice or wording"));
  CHECK_THROWS_WITH(read(replaced(good, "scene = \"drop\"\n", "")),
                    Contains("erratum C1: the key 'scene' is missing"));
  CHECK_THROWS_WITH(read(replaced(good, "\"depth\"", "\"height\"")),
                    Contains("erratum C1: figure fig2_1_fall has no quantity 'height'"));
  CHECK_THROWS_WITH(read(replaced(good, "fig2_1_fall", "fig9")),
                    Contains("erratum C1: there is no figure fig9"));
  CHECK_THROWS_WITH(read(good + good), Contains("erratum C1: this id stands twice"));
}

TEST_CASE("A file whose name says nothing is refused", "[unit][ledger]") {
  CHECK_THROWS_WITH(read_findings("/nowhere", {"notes.toml"}), Contains("notes.toml: give files"));
  CHECK_THROWS_AS(read_findings("/nowhere", {"/nowhere/expected.csv"}), FileError);
}

}  // namespace tumble::chapters
