/// \file
/// \brief Impacts and impulses of the claims of 2.1 and 2.5.2, counted operations, and intervals of shares and means.
#include "tumble/geometry/signed_distance.hpp"

#include "basic_colliding/counted.hpp"
#include "driver/quick.hpp"
#include "driver/statistics.hpp"
#include "support/test.hpp"

using namespace tumble::chapters;

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

TEST_CASE("A stack that needs more impulses than the cap allows is said to",
          "[unit][basic_colliding]") {
  const FigureUnderTest figure("claim_2_5_2a_stack", {"cap=1000", "seeds=2"});
  CHECK(figure.number("runs that met the cap") > 0.0);
  // What is counted until then still is a rate: measured 16.4.
  CHECK(figure.number("impulses per second with four cubes over those with one cube, shortest hop "
                      "1 ms") > 14.0);
}

TEST_CASE("The counted signed distance has the library's bits where faces, edges and signs tie",
          "[unit][basic_colliding]") {
  Random random(7);
  int differ = 0;
  for (int k = 0; k < 2000; ++k) {
    const Quat orientation = k % 2 == 0 ? Quat::Identity() : random.orientation();
    const Box box = make_box(Vec3::Zero(), orientation, Vec3::Ones());
    // Coordinates of the centre, of a face, and of half way between, with either sign.
    Vec3 point_b;
    for (int i = 0; i < 3; ++i) point_b[i] = 0.25 * (static_cast<double>(random.below(9)) - 4.0);
    const Vec3 point_w = box.axes_w * point_b;
    const SignedDistance truth = signed_distance(box, point_w);
    Operations counts;
    const CountedNormal counted = counted_signed_distance(box, point_w, counts);
    bool same = counted.distance.value == truth.distance;
    for (std::size_t i = 0; i < 3; ++i)
      same = same && counted.normal_w[i].value == truth.gradient_w[static_cast<int>(i)];
    differ += same ? 0 : 1;
  }
  CHECK(differ == 0);
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
