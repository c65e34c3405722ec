/// \file
/// \brief The claims of 2.1 and 2.5.2 on handling collisions, the errata T5 to T9, and intervals of shares and means.
#include "driver/quick.hpp"
#include "driver/statistics.hpp"
#include "support/test.hpp"

using namespace tumble;
using namespace tumble::chapters;

namespace {

FigureUnderTest errata() { return FigureUnderTest("errata_event_search"); }

}  // namespace

TEST_CASE("The basic technique finds the impacts of a bouncing cube at their closed-form times",
          "[claims][basic_colliding]") {
  const FigureUnderTest figure("claim_2_1a_impacts");
  CHECK(figure.number("largest error of an impact time, over the search's resolution times the "
                      "impact's number") < 1.0);  // [-] the claim accepts 5; measured 0.52
  // Eight impacts of five resolutions; t_8 = t_1 (1 + 2 (e + ... + e^7)).
  CHECK(std::abs(figure.number("time of the last impact") - 4.69162673905) < 4e-8);  // [s]
  // A cube found a resolution early is up to v times it too high; measured 6e-9 after 8 impacts.
  CHECK(figure.number("largest relative error of the energy after an impact") < 4e-8);
  CHECK(figure.number("bodies put back in time, for each impact") == 1.0);
  CHECK(figure.number("separations computed to find an impact, on average") == 24.0);
}

TEST_CASE("The basic technique meets its cap once a bouncing cube has come to rest",
          "[claims][basic_colliding]") {
  // 1.6 s: 15 steps end after 1.35457 s, and the first of them ends at the cap.
  const FigureUnderTest figure("claim_2_1b_rest");
  CHECK(figure.number("steps after that moment") == 15.0);
  CHECK(std::abs(figure.number("share of the steps after that moment that end at the cap") -
                 1.0 / 15.0) < 1e-12);
  CHECK(figure.number("capped steps that begin after that moment") == 0.0);
  // Without the thousandth of an edge that repair leaves it would meet the cap again and again:
  // in 9 of 15 steps as measured; which ones hangs on rounding.
  CHECK(figure.number("the same share, with overlap lifted clear of the ground") > 0.5);
  // What is left of rest is a hop at the start of each step; each step halves (e) what is missing
  // to it. Measured 1e-8 m and 6e-7 m/s off.
  CHECK(std::abs(figure.number("sinking in a step at the end") -
                 figure.number("sinking in a step at the end, closed form")) < 2e-8);  // [m]
  CHECK(std::abs(figure.number("speed at the end of a step at the end") -
                 figure.number("speed at the end of a step at the end, closed form")) < 1e-6);
}

TEST_CASE("Impulses alone grow faster than the height of a stack", "[claims][basic_colliding]") {
  // A tenth of a second of 4 seeds.
  const FigureUnderTest figure("claim_2_5_2a_stack");
  const std::string ratio =
      "impulses per second with four cubes over those with one cube, shortest hop ";
  // In proportion it would be 4. Measured 16.42 and 16.40; a full second of 20 seeds gives 16.40.
  CHECK(std::abs(figure.number(ratio + "1 ms") - 16.4) < 0.1);
  CHECK(std::abs(figure.number(ratio + "0.1 ms") - 16.4) < 0.05);
  // One cube hops as often as the shortest hop fits in, give or take the first.
  CHECK(std::abs(figure.number("impulses per second, 1 cube, shortest hop 1 ms") - 1000.0) < 11.0);
  // The ground hands up the weight: after 0.1 s to within hop/2 over 0.1 s.
  CHECK(std::abs(figure.number("impulse of the ground over the weight, four cubes, shortest hop "
                               "1 ms") -
                 1.0) < 5e-3);
  CHECK(figure.number("runs that met the cap") == 0.0);
}

TEST_CASE("A stack that needs more impulses than the cap allows is said to",
          "[unit][basic_colliding]") {
  const FigureUnderTest figure("claim_2_5_2a_stack", {"cap=1000", "seeds=2"});
  CHECK(figure.number("runs that met the cap") > 0.0);
  // What is counted until then still is a rate: measured 16.4.
  CHECK(figure.number("impulses per second with four cubes over those with one cube, shortest hop "
                      "1 ms") > 14.0);
}

TEST_CASE(
    "A test at the end of the step lets a cube fly through another, a search of the way does not",
    "[exact][basic_colliding]") {
  // By hand: the second flies from 1.5 to 3 m and the third from 2.65 to 1.9 m; or they collide at
  // 0.3 s, the second is back at 1.5 m at 0.4 s and stops there, and the third ends at 4 m. Impacts
  // may be found 1 µs early: 3 m/s of that for each.
  CHECK(std::abs(errata().number("T5: third cube ahead of the second, end of the step tested") -
                 -1.1) < 5e-6);  // [m] measured 1e-16 off
  CHECK(std::abs(errata().number("T5: third cube ahead of the second, way there searched") - 2.5) <
        1e-5);  // [m] measured 1e-15 off
}

TEST_CASE("A slow landing has no last impact unless a shortest flight makes one",
          "[exact][basic_colliding]") {
  CHECK(errata().number("T6: impacts in a step that nothing ends, until a cap") == 100.0);
  // Impact k leaves a flight of 2 v e^k / g, v = 0.05 m/s, e = 1/2: 1.24 µs for 13, 0.62 µs for 14.
  CHECK(errata().number("T6: impacts in a step, a flight below 1 µs being the last") == 14.0);
  CHECK(std::abs(errata().number("T6: time from the first of them to the last") - 0.0101924355728) <
        8.4e-8);  // [s] 14 impacts of 6 ns; measured 1e-8 off
}

TEST_CASE(
    "Bodies put where they overlap are found again and again, bodies put where they are apart once",
    "[exact][basic_colliding]") {
  CHECK(errata().number("T7: impacts, the overlapping end being kept, until a cap") == 100.0);
  CHECK(errata().number("T7: impacts, the separated end being kept") == 1.0);
}

TEST_CASE("Bisecting an Euler step finds a false time of impact, bisecting a flight the true one",
          "[exact][basic_colliding]") {
  const double h = 1e-3;       // [m]
  const double g = 9.81;       // [m/s²]
  const double found = 2e-12;  // [s] the search's resolution, and rounding
  CHECK(std::abs(errata().number("T8: impact time, bisecting a semi-implicit Euler step") -
                 std::sqrt(h / g)) < found);
  CHECK(std::abs(errata().number("T8: impact time, bisecting a flight") - std::sqrt(2.0 * h / g)) <
        found);
  // Cut at a third, an Euler step of dt loses 2/9 g dt² (semi-implicit) or gains it (forward).
  const double cut = 2.0 / 9.0 * g / 3600.0;
  CHECK(std::abs(errata().number("T8: height that cutting a step changes, forward Euler") - cut) <
        1e-14);
  CHECK(std::abs(errata().number("T8: height that cutting a step changes, semi-implicit Euler") -
                 cut) < 1e-14);
  CHECK(errata().number("T8: height that cutting a step changes, flight") < 1e-15);  // [m] 0
}

TEST_CASE(
    "A flat landing tilts a cube if its corners collide in turn, not if they collide together",
    "[exact][basic_colliding]") {
  // Exact fractions: each corner that approaches takes (1 + e) times its speed over 4 / m.
  CHECK(std::abs(errata().number("T9: spin after a flat landing, corner by corner") -
                 1.842908714517629) < 1e-13);  // [rad/s]
  CHECK(std::abs(errata().number("T9: the same, most of all 24 orders of the corners") -
                 2.187993856941261) < 1e-13);
  CHECK(errata().number("T9: spin after a flat landing, all corners together") < 1e-13);  // 2e-15
}

TEST_CASE("A share of trials has Wilson's interval", "[exact][basic_colliding]") {
  // By hand with z = 1.959964: z²/(n + z²) for no hit, and 1/2 ± z/2/sqrt(n + z²) for a half.
  const Quantity none = share_of_trials("none", 0, 10);
  CHECK(none.value == 0.0);
  CHECK(none.low == 0.0);
  CHECK(std::abs(none.high - 0.2775327998628893) < 1e-12);
  const Quantity all = share_of_trials("all", 10, 10);
  CHECK(std::abs(all.low - (1.0 - none.high)) < 1e-12);
  CHECK(all.high == 1.0);
  const Quantity half = share_of_trials("half", 5, 10);
  CHECK(half.value == 0.5);
  CHECK(std::abs(half.low - 0.2365930905125654) < 1e-12);
  CHECK(std::abs(half.high - 0.7634069094874346) < 1e-12);
  CHECK(half.seeds == 10);
  CHECK(std::isnan(share_of_trials("nothing tried", 0, 0).value));
}

TEST_CASE("The interval of a mean over seeds is Student's", "[exact][basic_colliding]") {
  // 1 to 5 have the mean 3 and its standard error sqrt(2.5/5); Student's factor for five is 2.7764.
  const std::vector<double> values = {1.0, 2.0, 3.0, 4.0, 5.0};
  const Quantity mean = over_seeds("mean", "m", 5, [&](int left_out) {
    return sum_without(values, left_out) / (left_out < 0 ? 5.0 : 4.0);
  });
  CHECK(mean.value == 3.0);
  CHECK(std::abs(mean.high - 3.0 - 1.9632432) < 1e-6);  // seven digits were written down
  CHECK(std::abs(mean.low - 3.0 + 1.9632432) < 1e-6);
  CHECK(mean.seeds == 5);
  CHECK(mean.unit == "m");
}

TEST_CASE("One seed has no interval", "[unit][basic_colliding]") {
  const Quantity one = over_seeds("one", "-", 1, [](int) { return 2.0; });
  CHECK(one.value == 2.0);
  CHECK(std::isnan(one.low));
  CHECK(std::isnan(one.high));
}
