/// \file
/// \brief Filters made from text (thesis 5.5).
#include "tumble/filtering/filters.hpp"

#include "tumble/filtering/box_filter.hpp"
#include "tumble/filtering/envelope_filter.hpp"
#include "tumble/filtering/one_euro_filter.hpp"

#include "filtering/one_body.hpp"
#include "support/test.hpp"

using namespace one_body;

namespace {

// Whether two filters show the same bits for a random walk that all filters change.
bool same_filter(const PoseFilter& a, const PoseFilter& b) {
  const Trajectory run = random_walk(120, 0.006, 0.01, 9);
  const Trajectory x = filtered(run, a);
  const Trajectory y = filtered(run, b);
  for (int n = 0; n < run.count(); ++n)
    if (!same_pose(body_in(x, n), body_in(y, n))) return false;
  return true;
}

}  // namespace

TEST_CASE("Every text form of a filter makes its filter", "[unit][filtering]") {
  CHECK(same_filter(*filter_of("box"), BoxFilter(5)));
  CHECK(same_filter(*filter_of("box:5"), BoxFilter(5)));
  CHECK(same_filter(*filter_of("box:15"), BoxFilter(15)));
  CHECK(same_filter(*filter_of("box:7,causal"), BoxFilter(7, BoxWindow::causal)));
  CHECK_FALSE(same_filter(*filter_of("box:7,causal"), *filter_of("box:7")));
  const double degree = std::numbers::pi / 180.0;
  for (const char* text : {"envelope", "envelope:0.01m,1deg", "envelope:10mm,1deg",
                           "envelope:1e-2m,0.017453292519943295rad"})
    CHECK(same_filter(*filter_of(text), EnvelopeFilter({0.01, degree})));
  CHECK(same_filter(*filter_of("soft_envelope"), SoftEnvelopeFilter()));
  CHECK(same_filter(*filter_of("soft_envelope:9mm,0.02rad"), SoftEnvelopeFilter({0.009, 0.02})));
  CHECK_FALSE(same_filter(*filter_of("soft_envelope"), *filter_of("envelope")));
  CHECK(same_filter(*filter_of("one_euro"), OneEuroFilter()));
  CHECK(same_filter(*filter_of("one_euro:2Hz"), OneEuroFilter({2.0, OneEuroOptions{}.gain, 1.0})));
  CHECK(same_filter(*filter_of("one_euro:2Hz,0"), OneEuroFilter({2.0, 0.0, 1.0})));
  CHECK(same_filter(*filter_of("one_euro:2Hz,7,3Hz"), OneEuroFilter({2.0, 7.0, 3.0})));
}

TEST_CASE("Nine millimetres are the same bits as 0.009 metres to a filter", "[exact][filtering]") {
  for (int k = 1; k <= 99; ++k) {
    const std::string digits = (k < 10 ? "0" : "") + std::to_string(k);
    CHECK(filter_of("envelope:" + std::to_string(k) + "mm,1deg")->text() ==
          filter_of("envelope:0.0" + digits + "m,1deg")->text());
  }
}

TEST_CASE("The text of a filter makes the same filter again", "[unit][filtering]") {
  for (const char* text :
       {"box", "box:9", "box:9,causal", "envelope", "envelope:3mm,0.7deg", "soft_envelope:7mm,1deg",
        "one_euro", "one_euro:0.3Hz", "one_euro:0.3Hz,1e2", "one_euro:0.3Hz,0.1,5Hz"}) {
    const auto filter = filter_of(text);
    const auto again = filter_of(filter->text());
    CHECK(again->text() == filter->text());
    CHECK(again->latency() == filter->latency());
    CHECK(same_filter(*filter, *again));
  }
  CHECK(filter_of("box:5")->text() == "box:5");
  const OneEuroFilter filter({0.3, 4.0, 5.0});
  CHECK(same_filter(filter, *filter_of(filter.text())));
}

TEST_CASE("The library of filters names those that can be made", "[unit][filtering]") {
  std::size_t count = 0;
  for (const FilterRecipe& recipe : filter_library()) {
    CHECK_NOTHROW(filter_of(recipe.name));
    const std::string form(recipe.form);
    CHECK((form.find(std::string(recipe.name) + ":") == 0 ||
           form.find(std::string(recipe.name) + "[:") == 0));
    CHECK_FALSE(recipe.summary.empty());
    ++count;
  }
  CHECK(count == 4);
}

TEST_CASE("An unknown filter is refused with the known names", "[unit][filtering]") {
  for (const char* text : {"bix:5", "Box:5", "", ":5", "box 5", "median", "envelope 1"}) {
    const std::string message = refusal_of([&] { (void)filter_of(text); });
    CHECK_THAT(message, Contains("one_euro"));
    CHECK_THAT(message, Contains("soft_envelope"));
  }
  CHECK_THAT(refusal_of([] { (void)filter_of("bix:5"); }), Contains("did you mean box?"));
  CHECK_THAT(refusal_of([] { (void)filter_of("envelop"); }), Contains("\"envelop\""));
}

TEST_CASE("An invalid parameter of a filter is refused with the text and the expected form",
          "[unit][filtering]") {
  // The text, the wrong part, and part of the expected form.
  const std::vector<std::array<std::string, 3>> cases = {
      {"box:", "\"\"", "box[:FRAMES=5[,causal]]"},
      {"box:five", "\"five\"", "box[:FRAMES=5[,causal]]"},
      {"box:5.5", "\"5.5\"", "box[:FRAMES=5[,causal]]"},
      {"box:5m", "\"5m\"", "box[:FRAMES=5[,causal]]"},
      {"box: 5", "\" 5\"", "box[:FRAMES=5[,causal]]"},
      {"box:nan", "\"nan\"", "box[:FRAMES=5[,causal]]"},
      {"box:inf", "\"inf\"", "box[:FRAMES=5[,causal]]"},
      {"box:1e999", "\"1e999\"", "box[:FRAMES=5[,causal]]"},
      {"box:5,", "\"\"", "causal"},
      {"box:5,late", "\"late\"", "causal"},
      {"box:5,causal,", "too many commas", "box[:FRAMES=5[,causal]]"},
      {"box:4", "4", "odd"},
      {"box:0", "0", "odd"},
      {"box:-5", "-5", "odd"},
      {"envelope:", "radius", "envelope:RADIUS,ANGLE"},
      {"envelope:1cm,1deg", "\"1cm\"", "m or mm"},
      {"envelope:0.01,1deg", "\"0.01\"", "m or mm"},
      {"envelope:0.01m", "an envelope has a radius and an angle", "envelope:RADIUS,ANGLE"},
      {"envelope:0.01m,", "\"\"", "rad or deg"},
      {"envelope:0.01m,1", "\"1\"", "rad or deg"},
      {"envelope:0.01m,1deg,", "an envelope has a radius and an angle", "envelope:RADIUS,ANGLE"},
      {"envelope:1e999m,1deg", "\"1e999m\"", "m or mm"},
      {"envelope:nanm,1deg", "\"nanm\"", "m or mm"},
      {"envelope:infm,1deg", "\"infm\"", "m or mm"},
      {"envelope:m,1deg", "\"m\"", "m or mm"},
      {"envelope:-0.01m,1deg", "-0.01", "above 0"},
      {"envelope:0m,1deg", "0", "above 0"},
      {"envelope:1m,-1deg", "angle", "above 0"},
      {"soft_envelope:1e-400m,1deg", "\"1e-400m\"", "finite number"},
      {"one_euro:1", "\"1\"", "Hz"},
      {"one_euro:1hz", "\"1hz\"", "Hz"},
      {"one_euro:0Hz", "cutoff", "above 0"},
      {"one_euro:1Hz,", "\"\"", "one_euro:CUTOFF"},
      {"one_euro:1Hz,-1", "gain", "-1"},
      {"one_euro:1Hz,1,1", "\"1\"", "Hz"},
      {"one_euro:1Hz,1,1Hz,1", "too many commas", "one_euro:CUTOFF"},
  };
  for (const auto& [text, wrong, remedy] : cases) {
    const std::string message = refusal_of([&text = text] { (void)filter_of(text); });
    CAPTURE(text, message);
    CHECK_THAT(message, Contains(wrong));
    CHECK_THAT(message, Contains(remedy));
  }
}
