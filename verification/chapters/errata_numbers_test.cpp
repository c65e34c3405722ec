/// \file
/// \brief Numbers of the errata of the thesis's listings, computed as `make figures` does.
#include "driver/check.hpp"
#include "driver/quick.hpp"
#include "support/test.hpp"

namespace tumble::chapters {

TEST_CASE("Each erratum of a listing has its expected numbers, taken literally and corrected",
          "[exact][ledger]") {
  // The reason beside each expected number has its closed form.
  const std::filesystem::path chapters = std::filesystem::path(TUMBLE_SOURCE_DIR) / "chapters";
  const std::vector<DrawnFigure> figures = expected_figures(
      {chapters / "impulse_damped/expected.csv", chapters / "timewarp/expected.csv"});
  for (const char* name : {"errata_contacts", "errata_damping", "errata_stability",
                           "errata_timewarp_simple", "errata_timewarp_safer"}) {
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

}  // namespace tumble::chapters
