/// \file
/// \brief Bisection keeps the separated side and counts what it asks.
#include "tumble/math/bracket.hpp"

#include "support/test.hpp"

TEST_CASE("Bisecting a frame to a microsecond takes 15 evaluations", "[exact][bracket]") {
  const double touch = 0.0123;
  int asked = 0;
  const auto gap = [&](double t) {
    ++asked;
    return touch - t;
  };
  const BisectionResult result = bisect(gap, Bracket{0.0, 1.0 / 60.0}, 1e-6, 100);
  CHECK(result.status == SearchStatus::found);
  CHECK(result.evaluations == 15);
  CHECK(asked == 15);
  CHECK(result.bracket.high - result.bracket.low <= 1e-6);
  CHECK(result.bracket.low <= touch);
  CHECK(result.bracket.high > touch);
}

TEST_CASE("Bisection ends at neighbouring doubles", "[exact][bracket]") {
  for (const double touch : {0.3, 1e-300, 0.999}) {
    const BisectionResult result =
        bisect([touch](double t) { return touch - t; }, Bracket{0.0, 1.0}, 0.0, 2200);
    CHECK(result.status == SearchStatus::found);
    CHECK(result.bracket.low == touch);  // gap 0 counts as separated
    CHECK(result.bracket.high == std::nextafter(touch, 2.0));
  }
}

TEST_CASE("Bisection of an enormous bracket does not overflow", "[unit][bracket]") {
  const double big = std::numeric_limits<double>::max();
  const BisectionResult result =
      bisect([](double t) { return 1.0 - t; }, Bracket{-big, big}, 0.0, 2200);
  CHECK(result.status == SearchStatus::found);
  CHECK(result.bracket.low == 1.0);
}

TEST_CASE("Bisection stops at its cap with the shortest bracket so far", "[unit][bracket]") {
  const auto gap = [](double t) { return 0.3 - t; };
  BisectionResult result = bisect(gap, Bracket{0.0, 1.0}, 1e-9, 2);
  CHECK(result.status == SearchStatus::cap_reached);
  CHECK(result.evaluations == 2);
  CHECK(result.bracket.low == 0.25);
  CHECK(result.bracket.high == 0.5);
  CHECK(bisect(gap, Bracket{0.0, 1.0}, 1e-9, 0).status == SearchStatus::cap_reached);
  // Exactly as many as needed is enough.
  CHECK(bisect(gap, Bracket{0.0, 1.0}, 0.25, 2).status == SearchStatus::found);
}

TEST_CASE("Bisection detects a bracket that is none", "[unit][bracket]") {
  const auto gap = [](double t) { return 0.3 - t; };
  CHECK(bisect(gap, Bracket{1.0, 0.0}, 1e-6, 10).status == SearchStatus::no_bracket);
  CHECK(bisect(gap, Bracket{kNan, 1.0}, 1e-6, 10).status == SearchStatus::no_bracket);
  CHECK(bisect([](double) { return kNan; }, Bracket{0.0, 1.0}, 1e-6, 10).status ==
        SearchStatus::no_bracket);
}

TEST_CASE("Bisection refuses a resolution or cap below zero", "[unit][bracket]") {
  const auto gap = [](double t) { return 0.3 - t; };
  CHECK_THROWS_WITH(bisect(gap, Bracket{0.0, 1.0}, -1.0, 10), Contains("resolution"));
  CHECK_THROWS_AS(bisect(gap, Bracket{0.0, 1.0}, kNan, 10), std::invalid_argument);
  CHECK_THROWS_WITH(bisect(gap, Bracket{0.0, 1.0}, 1e-6, -1), Contains("cap"));
}
