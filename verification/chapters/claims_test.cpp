/// \file
/// \brief The numbers of figures: claims with their experiments run small, and all of those that take no time in full.
#include "driver/check.hpp"
#include "driver/ledger.hpp"
#include "driver/quick.hpp"
#include "support/test.hpp"

#include <filesystem>

namespace tumble::chapters {
namespace {

const std::filesystem::path kChapters = std::filesystem::path(TUMBLE_SOURCE_DIR) / "chapters";

// Claims whose small run decides otherwise, since it has too few seeds, steps or cubes, and one that takes a minute.
// They have tests of their own.
const std::set<std::string> kDecidedInFullOnly = {"2.4.1a", "2.4.2a", "2.4.2b", "2.4.3b",
                                                  "2.6.3b", "2.7.2b", "4.4a",   "5.4b",
                                                  "5.5b",   "6.1c",   "6.2e",   "6.3.1c"};

// The verdicts of small runs are those of the numbers that are expected of full ones.
void check_claims(const std::string& chapter) {
  const std::vector<DrawnFigure> full = expected_figures({kChapters / chapter / "expected.csv"});
  int decided = 0;
  for (const Claim& claim : read_claims(kChapters / chapter / "claims.toml")) {
    if (kDecidedInFullOnly.count(claim.id) > 0) continue;
    const double small = FigureUnderTest(claim.figure).number(claim.quantity);
    const double expected = find_number(full, claim.figure, claim.quantity, claim.place).expected;
    CAPTURE(claim.id, claim.quantity, small, expected);
    ++decided;
    if (!claim.comparable) {
      CHECK(std::isfinite(small));
      continue;
    }
    const Rule rule = read_rule(claim.confirmed, claim.refuted);
    CHECK(verdict_text(rule.verdict(small)) == verdict_text(rule.verdict(expected)));
  }
  CHECK(decided > 0);
}

// Every number of some figures, computed as `make figures` does. The reason beside each expected one has its closed form.
void check_all_numbers(const std::string& chapter, const std::vector<std::string>& names) {
  const std::vector<DrawnFigure> figures = expected_figures({kChapters / chapter / "expected.csv"});
  for (const std::string& name : names) {
    const Figure figure = registered_figure(name);
    const Result result = figure.experiment(figure.parameters);
    const DrawnFigure* expected = figure_of(figures, name);
    REQUIRE(expected != nullptr);
    CHECK(result.quantities.size() == expected->numbers.size());
    for (const CheckedNumber& number : expected->numbers) {
      INFO(name << ", " << number.quantity);
      CHECK(quantity_of(result, number.quantity).value == near(number.expected, number.tolerance));
    }
  }
}

}  // namespace

TEST_CASE("Run small, the claims of analytic_lcp have their verdicts", "[claims][analytic_lcp]") {
  check_claims("analytic_lcp");
}

TEST_CASE("Run small, the claims of basic_colliding have their verdicts",
          "[claims][basic_colliding]") {
  check_claims("basic_colliding");
}

TEST_CASE("Run small, the claim of choosing has its verdict", "[claims][choosing]") {
  check_claims("choosing");
}

TEST_CASE("Run small, the claims of exterior_rotation have their verdicts",
          "[claims][exterior_rotation]") {
  check_claims("exterior_rotation");
}

TEST_CASE("Run small, the claims of filtering have their verdicts", "[claims][filtering]") {
  check_claims("filtering");
}

TEST_CASE("Run small, the claims of geometric_stability have their verdicts",
          "[claims][geometric_stability]") {
  check_claims("geometric_stability");
}

TEST_CASE("Run small, the claims of impulse_damped have their verdicts",
          "[claims][impulse_damped]") {
  check_claims("impulse_damped");
}

TEST_CASE("Run small, the claims of lcp_solvers have their verdicts", "[claims][lcp_solvers]") {
  check_claims("lcp_solvers");
}

TEST_CASE("Run small, the claims of previous_work have their verdicts", "[claims][previous_work]") {
  check_claims("previous_work");
}

TEST_CASE("Run small, the claims of timewarp have their verdicts", "[claims][timewarp]") {
  check_claims("timewarp");
}

TEST_CASE("Each erratum has its expected numbers, taken literally and corrected",
          "[exact][ledger]") {
  check_all_numbers("basic_colliding", {"errata_event_search"});
  check_all_numbers("exterior_rotation", {"errata_exterior_rotation"});
  check_all_numbers("filtering", {"errata_filtering"});
  check_all_numbers("impulse_damped", {"errata_contacts", "errata_damping", "errata_stability"});
  check_all_numbers("lcp_solvers", {"index_sets"});
  check_all_numbers("timewarp", {"errata_timewarp_simple", "errata_timewarp_safer"});
}

TEST_CASE("Figures that take a second or two have every number that is expected of them",
          "[exact][ledger]") {
  check_all_numbers("analytic_lcp", {"claim_3_3_1d_joined", "painleve_map"});
  check_all_numbers("basic_colliding", {"claim_2_1a_impacts", "cradle", "rotation_rules", "zeno"});
  check_all_numbers("exterior_rotation",
                    {"claim_6_2a_turning", "claim_6_2b_order", "claim_6_2c_one_pivot",
                     "claim_6_2d_one_twist", "fig6_2_one_box", "fig6_3_nested"});
  check_all_numbers(
      "geometric_stability",
      {"claim_5_4d_sliding", "claim_6_3_1d_equilibrium", "fig5_3_one_corner", "fig5_4_all_corners",
       "fig5_5_two_supports", "fig5_6_pyramid", "fig6_4_one_block"});
  check_all_numbers("impulse_damped", {"claim_5_3f_chain", "fig5_2_friction"});
  check_all_numbers("previous_work", {"claim_2_3a_relaxation", "claim_2_5_1b_penalty_bounce",
                                      "claim_2_6_4a_faure", "joint_crane"});
  check_all_numbers("timewarp", {"fig5_1_order"});
}

}  // namespace tumble::chapters
