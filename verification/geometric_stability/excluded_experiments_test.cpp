/// \file
/// \brief Figures 5.3 to 5.6 and claim 5.4b.
#include "driver/quick.hpp"
#include "support/test.hpp"

using namespace tumble::chapters;

namespace {

const std::string kUnknowns = "unknowns of a run, all boxes over those that are not stable, ";

constexpr const char* kBelow = "boxes below that are stable";
constexpr const char* kByCorners = "stable by the four corners";
constexpr const char* kByHull = "stable by the hull";
constexpr const char* kCarries = "carries every load by static equilibrium";
constexpr const char* kOwn = "largest acceleration of its corners under its own weight, over g";
constexpr const char* kLoaded =
    "the same under the worst load on a corner of its top, over (load + weight)/mass";

// [-] Rounding of these problems: measured 1e-14.
constexpr double kStill = 1e-11;

// What all verdicts on the top box say, if they agree; else -1.
double verdict_of(const FigureUnderTest& figure) {
  const double corners = figure.number(kByCorners);
  return figure.number(kByHull) == corners && figure.number(kCarries) == corners ? corners : -1.0;
}

}  // namespace

TEST_CASE(
    "A cube on the corner of another stands until its centre passes the corner, and never "
    "under every load",
    "[exact][geometric_stability]") {
  const FigureUnderTest figure("fig5_3_one_corner", {"shift=0.4"});
  // [m] The corner is half an edge from the middle; the search ends at 1e-9.
  CHECK(figure.number("shift from which its own weight tips it") == near(0.5, 2e-9));
  CHECK(figure.number(kOwn) < kStill);
  CHECK(figure.number(kLoaded) > 1.0);
  CHECK(verdict_of(figure) == 0.0);
  for (const auto& row : figure.result.tables.back().rows) {
    INFO("shift " << row[0]);
    CHECK((row[1] < kStill) == (row[0] <= 0.5));
    CHECK(row[2] > 0.1);
    CHECK(row[3] == 0.0);
  }
}

TEST_CASE(
    "Where the bottom boxes of figure 5.5 touch, both rules call no box stable and every load is "
    "carried all the same",
    "[reference][geometric_stability]") {
  const FigureUnderTest figure("fig5_5_two_supports", {"gap=0"});
  CHECK(figure.number(kBelow) == 0.0);
  CHECK(figure.number(kByCorners) == 0.0);
  CHECK(figure.number(kByHull) == 0.0);
  CHECK(figure.number(kCarries) == 1.0);
  CHECK(figure.number(kLoaded) < kStill);
}

TEST_CASE("Leaving stable boxes out saves Baraff's method three quarters of its multiplications",
          "[claims][geometric_stability]") {
  const FigureUnderTest decides =
      FigureUnderTest("claim_5_4b_excluded",
                      {"rows=11", "largest=3", "shuffled_rows=3", "knocked_rows=3", "steps=1"});
  // [-] measured 10.2
  CHECK(decides.number("multiplications of Baraff's method for the pyramid of figure 5.6 with 11 "
                       "rows, all boxes over the boxes that are not stable") >= 4.0);
  CHECK(decides.number("the same, the cube of the unknowns") == Approx(std::pow(472.0 / 272.0, 3)));

  const FigureUnderTest figure("claim_5_4b_excluded");
  // [-] measured 15.7, 6.2, 1.54
  CHECK(figure.number("multiplications of Baraff's method for the pyramid of figure 5.6 with 7 "
                      "rows, all boxes over the boxes that are not stable") >= 4.0);
  CHECK(figure.number("the same with 5 rows, contacts in random orders") >= 4.0);
  const double ours = figure.number("the same, our default solver");
  CHECK(ours > 1.2);
  CHECK(ours < 3.0);
  CHECK(figure.number("rows of the largest pyramid that Baraff's pivoting solves with all boxes") ==
        7.0);
}

TEST_CASE(
    "In the figure of claim 5.4b no acceleration and no net force depends on the boxes left out",
    "[claims][geometric_stability]") {
  const FigureUnderTest figure("claim_5_4b_excluded");
  // [-] measured 5e-14 and 2e-14; 9e-12 and 2e-12 up to 13 rows
  CHECK(figure.number("largest change of an acceleration, over g") <= 1e-9);
  CHECK(figure.number("largest change of a box's net contact force and torque, over its weight") <=
        1e-9);
}

TEST_CASE("What stable boxes save lasts while a pyramid rests, and not while it falls",
          "[claims][geometric_stability]") {
  const FigureUnderTest figure("claim_5_4b_excluded", {"seeds=4"});
  const double rests = figure.number(kUnknowns + "at rest");
  const double knocked = figure.number(kUnknowns + "knocked");
  const double falls = figure.number(kUnknowns + "three rows that fall");
  CHECK(rests == Approx(184.0 / 112.0));
  // [-] measured 1.3 and 1.02
  CHECK(knocked < rests);
  CHECK(knocked > falls);
  CHECK(falls < 1.1);
  // One step after the first nothing is stable.
  const Table& run = figure.result.tables[1];
  CHECK(run.rows[0][3] == 1.5);
  for (std::size_t k = 1; k < run.rows.size(); ++k) CHECK(run.rows[k][3] == 1.0);
}
