/// \file
/// \brief Tests of the rule by which slow collisions stick.
#include "tumble/contact/sticky.hpp"

#include "support/test.hpp"

namespace {

struct Bounces {
  int collisions = 0;  // those that bounced and the one that stuck
  double time = 0.0;   // [s] of the last one
};

// A ball dropped from 1 m, by the closed form: flights of 2 v / g between collisions.
Bounces drop(double e, const StickyOptions& options, int cap = 200) {
  Bounces b;
  double v = std::sqrt(2.0 * kGravity);
  b.time = v / kGravity;
  while (b.collisions < cap) {
    ++b.collisions;
    const double used = sticky_restitution(e, -v, {kGravity, 1.0, 1.0 / 60}, options);
    v *= used;
    if (v == 0.0) break;
    b.time += 2.0 * v / kGravity;
  }
  return b;
}

}  // namespace

TEST_CASE("A ball with restitution 0.5 bounces 6 times above 0.1 m/s, and 36 times with 0.9",
          "[exact][sticky]") {
  struct Row {
    double e, threshold;
    int bounces;
    double time;  // [s] of the last bounce; the sticking one follows after a flight
  };
  const std::array<Row, 6> rows = {{{0.5, 0.1, 6, 1.32635069540},
                                    {0.5, 0.01, 9, 1.35104339451},
                                    {0.5, 0.001, 13, 1.35435045243},
                                    {0.9, 0.1, 36, 8.37550707897},
                                    {0.9, 0.01, 58, 8.55891479272},
                                    {0.9, 0.001, 80, 8.57697625069}}};
  for (const Row& row : rows) {
    const Bounces b = drop(row.e, {.threshold = row.threshold / std::sqrt(kGravity)});
    CHECK(b.collisions == row.bounces + 1);
    const double last_speed = std::sqrt(2.0 * kGravity) * std::pow(row.e, row.bounces);
    CHECK(b.time - 2.0 * last_speed / kGravity == near(row.time).epsilon(1e-11));
  }
}

TEST_CASE("A ball sticks at its 5th or 32nd collision when rebounds below g dt stick",
          "[exact][sticky]") {
  StickyOptions options{.rule = StickyRule::step_size};
  CHECK(drop(0.5, options).collisions == 5);
  CHECK(drop(0.9, options).collisions == 32);
}

TEST_CASE("Boxes of any size stick alike when time and speed scale with their size",
          "[unit][sticky]") {
  for (const double size : {1e-3, 1.0, 1e3}) {
    const double v = std::sqrt(kGravity * size);
    const StickyScale scale{kGravity, size, 1.0 / 60};
    CHECK(sticky_restitution(0.7, -0.049 * v, scale, {}) == 0.0);
    CHECK(sticky_restitution(0.7, -0.051 * v, scale, {}) == 0.7);
  }
}

TEST_CASE("Without gravity the scale of speed is one size in a step", "[unit][sticky]") {
  const StickyScale scale{0.0, 2.0, 0.01};  // L / dt = 200 m/s
  CHECK(sticky_restitution(0.7, -0.019, scale, {}) == 0.0);
  CHECK(sticky_restitution(0.7, -0.021, scale, {}) == 0.7);
  // And the rule by step size never makes anything stick.
  CHECK(sticky_restitution(0.7, -1e-9, scale, {.rule = StickyRule::step_size}) == 0.7);
}

TEST_CASE("Bad values are refused by the sticky rule", "[unit][sticky]") {
  CHECK_THROWS_WITH(sticky_restitution(1.5, -1.0, {}, {}), Contains("restitution"));
  CHECK_THROWS_WITH(sticky_restitution(0.5, kNan, {}, {}), Contains("approach_speed"));
  CHECK_THROWS_WITH(sticky_restitution(0.5, -1.0, {-9.81, 1.0, 0.01}, {}), Contains("gravity"));
  CHECK_THROWS_WITH(sticky_restitution(0.5, -1.0, {9.81, 0.0, 0.01}, {}), Contains("size"));
  CHECK_THROWS_WITH(sticky_restitution(0.5, -1.0, {9.81, 1.0, 0.0}, {}), Contains("dt"));
  StickyOptions options{.threshold = -0.1};
  CHECK_THROWS_WITH(sticky_restitution(0.5, -1.0, {}, options), Contains("threshold"));
}
