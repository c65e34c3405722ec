/// \file
/// \brief The box filter against closed forms, at the ends of runs, with changing bodies, and live.
#include "tumble/filtering/box_filter.hpp"

#include "filtering/one_body.hpp"
#include "support/test.hpp"

#include <bit>

namespace {

using namespace one_body;

constexpr std::array<int, 8> kWidths = {1, 3, 5, 7, 9, 11, 13, 15};

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

// Also the sign of zeros.
bool same_bits(const BodyState& a, const BodyState& b) {
  bool same = true;
  for (int k = 0; k < 3; ++k)
    same = same && same_bits(a.position_w[k], b.position_w[k]) &&
           same_bits(a.linear_momentum_w[k], b.linear_momentum_w[k]) &&
           same_bits(a.angular_momentum_w[k], b.angular_momentum_w[k]);
  for (int k = 0; k < 4; ++k)
    same = same && same_bits(a.orientation_wb.coeffs()[k], b.orientation_wb.coeffs()[k]);
  return same;
}

Trajectory boxed(const Trajectory& run, int width, BoxWindow window = BoxWindow::centred) {
  return filtered(run, BoxFilter(width, window));
}

}  // namespace

TEST_CASE("The box filter multiplies moves and turns of any frequency by the closed form",
          "[exact][filtering]") {
  const Vec3 along = Vec3(2.0, -1.0, 2.0) / 3.0;
  const Vec3 about = Vec3(6.0, 2.0, -3.0) / 7.0;
  const Quat start = rotation_from_vector(Vec3(0.3, -1.2, 0.7));
  constexpr double kSwing = 0.7;  // [m] and [rad]
  constexpr int kCount = 40;
  double worst = 0.0;
  for (const int width : kWidths)
    for (int step = 0; step <= 50; ++step) {
      const double f = 0.01 * step;
      const auto cosine = [&](int n) {
        return elementary::cos(2.0 * std::numbers::pi * f * n + 0.3);
      };
      const Trajectory shown = boxed(
          run_of(kCount,
                 [&](int n) {
                   BodyState state{
                       .position_w = kSwing * cosine(n) * along,
                       .orientation_wb = rotation_from_vector(kSwing * cosine(n) * about) * start};
                   return state;
                 }),
          width);
      const double gain = BoxFilter::response(width, f);
      for (int n = width / 2; n < kCount - width / 2; ++n) {
        const BodyState& state = body_in(shown, n);
        const Vec3 turn = rotation_vector(state.orientation_wb * start.conjugate());
        worst = std::max(worst, (state.position_w / kSwing - gain * cosine(n) * along).norm());
        worst = std::max(worst, (turn / kSwing - gain * cosine(n) * about).norm());
      }
    }
  CHECK(worst < 1e-9);  // [-] of the amplitude; measured 7e-15
}

TEST_CASE("The response of a box over five frames has the values of the closed form",
          "[exact][filtering]") {
  // (1 + 2 cos 2πf + 2 cos 4πf)/5, computed separately to nine decimals.
  const std::array<std::pair<double, double>, 10> values = {{{0.0, 1.0},
                                                             {0.05, 0.904029404},
                                                             {0.1, 0.647213596},
                                                             {0.15, 0.311507303},
                                                             {0.2, 0.0},
                                                             {0.25, -0.2},
                                                             {0.3, -0.247213596},
                                                             {0.4, 0.0},
                                                             {0.45, 0.143184191},
                                                             {0.5, 0.2}}};
  for (const auto& [frequency, gain] : values)
    CHECK(BoxFilter::response(5, frequency) == near(gain, 6e-10));
  CHECK(BoxFilter::response(5, 0.290215312) == near(-0.25, 1e-12));
  CHECK(BoxFilter::response(5, 0.0901587151) == near(std::sqrt(0.5), 1e-9));
  CHECK(BoxFilter::response(5, 0.122472659) == near(0.5, 1e-8));
  CHECK(BoxFilter::response(1, 0.37) == 1.0);
}

TEST_CASE("A box filter keeps every bit of a run at rest, of q and -q and of negative zeros",
          "[exact][filtering]") {
  Random chance(5);
  for (int trial = 0; trial < 50; ++trial) {
    BodyState rest{.position_w = chance.in_cube(100.0)};
    rest.position_w[trial % 3] = -0.0;
    rest.orientation_wb = chance.orientation();
    rest.linear_momentum_w = Vec3(-0.0, 1.0, 0.0);
    const auto signs = static_cast<std::uint64_t>(trial < 2 ? 0 : chance.bits());
    const auto state = [&](int n) {
      BodyState now = rest;
      if ((signs >> n & 1U) != 0) now.orientation_wb.coeffs() = -now.orientation_wb.coeffs();
      return now;
    };
    const Trajectory run = run_of(40, state);
    for (const int width : kWidths)
      for (const BoxWindow window : {BoxWindow::centred, BoxWindow::causal}) {
        const Trajectory shown = boxed(run, width, window);
        const int late = window == BoxWindow::causal ? width / 2 : 0;
        bool same = true;
        for (int n = 0; n < run.count(); ++n)
          same = same && same_bits(body_in(shown, n), state(std::max(0, n - late)));
        CHECK(same);
      }
  }
}

TEST_CASE(
    "A box filter treats a body from its first frame to its last, and anew when it comes back",
    "[exact][filtering]") {
  // The first body is missing from two frames, where the others change places; the second is in 5 ...
  // 14 and 17 ... 29, the third in one.
  const auto there = [](int body, int n) {
    if (body == 1) return (n >= 5 && n < 15) || n >= 17;
    return body == 0 ? n < 9 || n > 10 : n == 20;
  };
  const auto place = [](int body, int n) { return 100.0 * body + n * n; };
  Trajectory run;
  for (int n = 0; n < 30; ++n) {
    std::vector<BodyId> ids;
    std::vector<BodyState> states;
    for (int body = 0; body < 3; ++body) {
      if (!there(body, n)) continue;
      ids.push_back(BodyId{static_cast<std::uint32_t>(10 + body)});
      states.push_back(at(place(body, n)));
    }
    run.record(Frame{n * kFrameTime, n, ids, states});
  }
  for (const int width : kWidths) {
    const Trajectory shown = boxed(run, width);
    const Trajectory late = boxed(run, width, BoxWindow::causal);
    for (int n = 0; n < 30; ++n) {
      REQUIRE(shown.frame(n).ids.size() == run.frame(n).ids.size());
      for (int body = 0; body < 3; ++body) {
        const BodyId id{static_cast<std::uint32_t>(10 + body)};
        const auto state = shown.state(n, id);
        REQUIRE(state.has_value() == there(body, n));
        if (!state) continue;
        int half = 0;
        while (half < width / 2 && n - half - 1 >= 0 && n + half + 1 < 30 &&
               there(body, n - half - 1) && there(body, n + half + 1))
          ++half;
        CHECK(state->position_w.x() == near(place(body, n) + half * (half + 1) / 3.0, 1e-12));
        // The causal form: half a window ago, or the body's first pose.
        int then = n;
        while (then > n - width / 2 && then > 0 && there(body, then - 1)) --then;
        CHECK(same_pose(*late.state(n, id), *shown.state(then, id)));
      }
    }
  }
}

TEST_CASE("A window ends where a body has turned by half a turn from its middle",
          "[exact][filtering]") {
  // A fifth of a turn per frame, accelerating: the mean shows how many frames were averaged.
  const double turn = 0.4 * std::numbers::pi;
  const auto angle = [&](int n) { return turn * n + 1e-3 * n * n; };
  const Trajectory run = run_of(21, [&](int n) { return turned_by(angle(n)); });
  for (const int width : {1, 3, 5, 15}) {
    const Trajectory shown = boxed(run, width);
    for (int n = 7; n < 14; ++n) {
      const int half = std::min(width / 2, 2);  // 3 · 0.4 π is more than π
      const double expected = angle(n) + 1e-3 * half * (half + 1) / 3.0;
      CHECK(angle_between(body_in(shown, n).orientation_wb,
                          turned_by(expected).orientation_wb) < 1e-13);  // [rad] measured 3e-16
    }
  }
  // The window of positions ends with that of rotations, so that both belong to one time.
  const Trajectory both = run_of(21, [&](int n) {
    BodyState state = turned_by(angle(n));
    state.position_w.x() = n * n;
    return state;
  });
  CHECK(body_in(boxed(both, 15), 10).position_w.x() == near(102.0, 1e-12));
}

TEST_CASE("A box filter shows the same orientations for q and -q", "[exact][filtering]") {
  const Trajectory run = random_walk(80, 0.1, 0.3, 11);
  Random chance(12);
  Trajectory flipped;
  for (int n = 0; n < run.count(); ++n) {
    std::vector<BodyState> states = {body_in(run, n)};
    if (chance.below(2) == 0) states[0].orientation_wb.coeffs() *= -1.0;
    const Frame frame = run.frame(n);
    flipped.record(Frame{frame.time, frame.step, frame.ids, states});
  }
  for (const int width : {3, 5, 15}) {
    const Trajectory a = boxed(run, width);
    const Trajectory b = boxed(flipped, width);
    for (int n = 0; n < run.count(); ++n) {
      const Quat& p = body_in(a, n).orientation_wb;
      const Quat& q = body_in(b, n).orientation_wb;
      CHECK((p.coeffs() == q.coeffs() || p.coeffs() == -q.coeffs()));
      CHECK(body_in(flipped, n).orientation_wb.dot(q) > 0.0);  // the sign of the middle frame
    }
  }
}

TEST_CASE("An even width, none and a huge one are refused with the number", "[unit][filtering]") {
  for (const int width : {0, -1, -5, 2, 4, 1002, 1003, 100001}) {
    const std::string message = refusal_of([&] { BoxFilter filter(width); });
    CHECK_THAT(message, Contains("over " + std::to_string(width) + " frames"));
    CHECK_THAT(message, Contains("an odd number from 1 to 1001"));
  }
  CHECK(BoxFilter(1001).frames() == 1001);
}

TEST_CASE("A last frame that comes early or late is shown as it is and enters no window",
          "[exact][filtering]") {
  // Five frames of 20 and one more; the result is as if the run had ended with the 20th.
  for (const double share : {0.3, 1.5})
    for (const int width : kWidths) {
      Trajectory run = run_of(20, [](int n) { return at(n * n); });
      const Trajectory regular = boxed(run, width);
      const std::vector<BodyId> ids = {BodyId{7}};
      const std::vector<BodyState> states = {at(-5.0)};
      run.record(Frame{(19 + share) * kFrameTime, 20, ids, states});
      const Trajectory shown = boxed(run, width);
      const Trajectory late = boxed(run, width, BoxWindow::causal);
      REQUIRE(shown.count() == 21);
      for (int n = 0; n < 20; ++n) CHECK(same_pose(body_in(shown, n), body_in(regular, n)));
      CHECK(same_pose(body_in(shown, 20), states[0]));
      CHECK(same_pose(body_in(late, 20), body_in(shown, 20 - width / 2)));
    }
}

TEST_CASE("A frame after one at another interval is refused, and the filter is as before",
          "[unit][filtering]") {
  for (const BoxWindow window : {BoxWindow::centred, BoxWindow::causal}) {
    const Trajectory run = random_walk(12, 0.1, 0.3, 16);
    BoxFilter filter(5, window);
    std::vector<BodyState> seen;
    const FrameSink show = [&](const Frame& frame) { seen.push_back(frame.states[0]); };
    for (int n = 0; n < 10; ++n) filter.add(run.frame(n), show);
    const auto add_at = [&](PoseFilter& to, double time, int n) {
      Frame frame = run.frame(n);
      frame.time = time;
      to.add(frame, show);
    };
    add_at(filter, 9.5 * kFrameTime, 10);
    const std::unique_ptr<PoseFilter> copy = filter.clone();
    const std::size_t before = seen.size();
    const std::string message = refusal_of([&] { add_at(filter, 10.5 * kFrameTime, 11); });
    CHECK_THAT(message, Contains("frame 11 at 0.175 s"));
    CHECK_THAT(message, Contains("equal times"));
    CHECK_THAT(message, Contains("Keep the step constant"));
    CHECK(seen.size() == before);
    filter.finish(show);
    const std::vector<BodyState> after(seen.begin() + static_cast<std::ptrdiff_t>(before),
                                       seen.end());
    seen.clear();
    copy->finish(show);
    REQUIRE(seen.size() == after.size());
    for (std::size_t k = 0; k < seen.size(); ++k) CHECK(same_pose(seen[k], after[k]));

    // Ready for another run with another interval.
    seen.clear();
    for (int n = 0; n < 6; ++n) add_at(filter, n * 0.5, n);
    filter.finish(show);
    CHECK(seen.size() == 6);
  }
}

TEST_CASE("Times may carry rounding, and no more", "[unit][filtering]") {
  const auto refused = [](double shift) {
    BoxFilter filter(5);
    const std::vector<BodyId> ids = {BodyId{7}};
    const std::vector<BodyState> states(1);
    return !refusal_of([&] {
              for (int n = 0; n < 5; ++n)
                filter.add(Frame{(n + (n == 3 ? shift : 0.0)) * kFrameTime, n, ids, states},
                           [](const Frame&) {});
            }).empty();
  };
  CHECK_FALSE(refused(0.0));
  CHECK_FALSE(refused(0.9e-6));
  CHECK(refused(1.1e-6));
  CHECK(refused(-1.1e-6));
}

TEST_CASE("A frame whose ids do not ascend, are not as many as states or come twice is refused",
          "[unit][filtering]") {
  const std::vector<BodyState> states = {at(0.0), at(1.0)};
  const auto message = [&](const std::vector<BodyId>& ids, double time) {
    BoxFilter filter(3);
    return refusal_of([&] { filter.add(Frame{time, 0, ids, states}, [](const Frame&) {}); });
  };
  CHECK(message({BodyId{7}, BodyId{9}}, 0.0).empty());
  CHECK_THAT(message({BodyId{9}, BodyId{7}}, 0.0),
             Contains("body with id 7: expected ids that ascend"));
  CHECK_THAT(message({BodyId{7}, BodyId{7}}, 0.0), Contains("expected ids that ascend"));
  CHECK_THAT(message({BodyId{7}}, 0.0), Contains("1 ids and 2 states"));
  CHECK_THAT(message({BodyId{7}, BodyId{9}}, kInfinity), Contains("time of a frame"));
  BoxFilter filter(3);
  const std::vector<BodyId> ids = {BodyId{7}, BodyId{9}};
  const auto add = [&] { filter.add(Frame{1.0, 0, ids, states}, [](const Frame&) {}); };
  add();
  CHECK_THAT(refusal_of(add), Contains("frame 1 at 1 s: expected a time after 1 s"));
}
