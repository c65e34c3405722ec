/// \file
/// \brief The frequency response of the box filter, measured with the filter itself (thesis 5.5).
#include "tumble/filtering/box_filter.hpp"

#include "driver/experiment.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

namespace tumble::chapters {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr int kFrames = 96;     // of a recorded motion
constexpr double kPhase = 0.3;  // [rad] at its first frame: no sample of any frequency is all 0
constexpr double kSwing = 0.5;  // [m] and [rad] its amplitude
constexpr double kSlowMotion = 0.05;  // [1/frame] of the motion whose delay is measured
const Vec3 kAlong = Vec3(2.0, -1.0, 2.0) / 3.0;
const Vec3 kSwingAbout = Vec3(6.0, 2.0, -3.0) / 7.0;

// A body that swings to and fro along a line and about an axis at once.
struct Swing {
  Trajectory run;
  std::vector<double> angle;  // [rad] of the cosine in each frame
};

Swing swing_of(double frequency) {
  Swing swing;
  const std::vector<BodyId> ids = {BodyId{1}};
  std::vector<BodyState> states(1);
  for (int n = 0; n < kFrames; ++n) {
    swing.angle.push_back(kTurn * frequency * n + kPhase);
    const double now = kSwing * elementary::cos(swing.angle.back());
    states[0].position_w = now * kAlong;
    states[0].orientation_wb = rotation_from_vector(now * kSwingAbout);
    swing.run.record(Frame{n * kStep, n, ids, states});
  }
  return swing;
}

// The parts of what is shown that go with the cosine and the sine of the motion, over its amplitude.
struct Gain {
  double in_phase = 0.0;
  double behind = 0.0;
};

// From all frames with a whole window, by least squares.
Gain gain_of(const Swing& swing, const std::function<double(const BodyState&)>& place,
             const Trajectory& shown, int first, int last) {
  std::array<double, 5> sums{};  // cc, cs, ss, yc, ys
  for (int n = first; n <= last; ++n) {
    const elementary::SinCos angle = elementary::sincos(swing.angle[static_cast<std::size_t>(n)]);
    const double y = place(shown.frame(n).states[0]) / kSwing;
    sums[0] += angle.cos * angle.cos;
    sums[1] += angle.cos * angle.sin;
    sums[2] += angle.sin * angle.sin;
    sums[3] += y * angle.cos;
    sums[4] += y * angle.sin;
  }
  const double determinant = sums[0] * sums[2] - sums[1] * sums[1];
  // At 0 and 1/2 cycles a frame sine and cosine are in proportion: all is in phase then.
  if (determinant < 1e-6 * sums[0] * (sums[0] + sums[2])) return {sums[3] / sums[0], 0.0};
  return {(sums[3] * sums[2] - sums[4] * sums[1]) / determinant,
          (sums[4] * sums[0] - sums[3] * sums[1]) / determinant};
}

double way_of(const BodyState& state) { return state.position_w.dot(kAlong); }
double turn_of(const BodyState& state) {
  return rotation_vector(state.orientation_wb).dot(kSwingAbout);
}

// How far the shown frames are from the cosine times the exact gain, over its amplitude.
double largest_error(const Swing& swing, const std::function<double(const BodyState&)>& place,
                     const Trajectory& shown, int first, int last, double gain) {
  double largest = 0.0;
  for (int n = first; n <= last; ++n) {
    const double exact = gain * elementary::cos(swing.angle[static_cast<std::size_t>(n)]);
    largest = std::max(largest, std::abs(place(shown.frame(n).states[0]) / kSwing - exact));
  }
  return largest;
}

// A zero of a function between two places where it has different signs, by GSL (Brent's method).
double root_of(const std::function<double(double)>& function, double low, double high) {
  gsl_function called{[](double x, void* data) {
                        return (*static_cast<const std::function<double(double)>*>(data))(x);
                      },
                      const_cast<std::function<double(double)>*>(&function)};
  const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
  gsl_root_fsolver_set(solver.get(), &called, low, high);
  for (int k = 0; k < 200; ++k) {
    if (gsl_root_fsolver_iterate(solver.get()) != GSL_SUCCESS) break;
    const double x = gsl_root_fsolver_root(solver.get());
    if (gsl_root_test_interval(gsl_root_fsolver_x_lower(solver.get()),
                               gsl_root_fsolver_x_upper(solver.get()), 1e-15, 0.0) == GSL_SUCCESS)
      return x;
  }
  throw std::runtime_error("no zero of the frequency response found");
}

// The places of sign changes on a grid, made exact.
std::vector<double> roots_of(const std::function<double(double)>& function, double from,
                             double to) {
  constexpr int kParts = 1009;  // a prime: no zero of a small width lies on the grid
  std::vector<double> roots;
  for (int k = 0; k < kParts; ++k) {
    const double low = from + (to - from) * k / kParts;
    const double high = from + (to - from) * (k + 1) / kParts;
    if ((function(low) < 0.0) != (function(high) < 0.0))
      roots.push_back(root_of(function, low, high));
  }
  return roots;
}

// The slope of the response, d H / d f.
double slope(int frames, double frequency) {
  double sum = 0.0;
  for (int k = 1; k <= frames / 2; ++k)
    sum -= 2.0 * kTurn * k * elementary::sin(kTurn * k * frequency);
  return sum / frames;
}

Result measure_box_response(const Parameters& settings) {
  const int frames = settings.count("frames");
  const int half = frames / 2;
  const double rate = settings.number("rate");
  const BoxFilter filter(frames);

  Table table{"",
              {{"frequency", "1/frame", "of the motion"},
               {"frequency_hz", "Hz", "the same"},
               {"exact", "-", "closed form"},
               {"moves", "-", "measured, a body that moves"},
               {"turns", "-", "measured, a body that turns"},
               {"error_moves", "-", "largest error in a frame over the amplitude, moving"},
               {"error_turns", "-", "largest error in a frame over the amplitude, turning"}}};
  double worst_move = 0.0;
  double worst_turn = 0.0;
  double last_gain = 0.0;
  const int count = settings.count("frequencies");
  for (int k = 0; k <= count; ++k) {
    const double f = 0.5 * k / count;
    const Swing swing = swing_of(f);
    const Trajectory shown = filtered(swing.run, filter);
    const int end = kFrames - 1 - half;
    const double exact = BoxFilter::response(frames, f);
    const double move = largest_error(swing, way_of, shown, half, end, exact);
    const double turn = largest_error(swing, turn_of, shown, half, end, exact);
    last_gain = gain_of(swing, way_of, shown, half, end).in_phase;
    table.add(f, f * rate, exact, last_gain, gain_of(swing, turn_of, shown, half, end).in_phase,
              std::max(move, kNearNothing), std::max(turn, kNearNothing));
    worst_move = std::max(worst_move, move);
    worst_turn = std::max(worst_turn, turn);
  }

  const auto response = [&](double f) { return BoxFilter::response(frames, f); };
  const std::vector<double> zeros = roots_of(response, 0.0, 0.5);
  const std::vector<double> turning =
      roots_of([&](double f) { return slope(frames, f); }, zeros.at(0), zeros.back());
  const double lowest =
      turning.empty() ? 0.5 : turning[0];  // over 3 frames at the end of the range
  const double third =
      root_of([&](double f) { return response(f) - std::sqrt(0.5); }, 0.0, zeros.at(0));
  Table marks{"marks",
              {{"kind", "-", "0: zero, 1: minimum, 2: -3 dB"},
               {"frequency", "1/frame", "where"},
               {"gain", "-", "the response there"}}};
  for (const double zero : zeros) marks.add(0.0, zero, response(zero));
  marks.add(1.0, lowest, response(lowest));
  marks.add(2.0, third, response(third));

  // The causal form shows a slow motion unchanged but for its size, and late.
  const Swing slow = swing_of(kSlowMotion);
  const Gain late = gain_of(slow, way_of, filtered(slow.run, BoxFilter(frames, BoxWindow::causal)),
                            2 * half, kFrames - 1);
  const double delay = elementary::atan2(late.behind, late.in_phase) / (kTurn * kSlowMotion);

  return {{table, marks},
          {{"largest error of the response, moving", "-", worst_move},
           {"largest error of the response, turning", "-", worst_turn},
           {"first frequency that is removed", "1/frame", zeros.front()},
           {"last frequency that is removed", "1/frame", zeros.back()},
           {"frequency of the lowest gain", "1/frame", lowest},
           {"lowest gain", "-", response(lowest)},
           {"frequency at -3 dB", "1/frame", third},
           {"frequency at -3 dB in hertz", "Hz", third * rate},
           {"gain of a body that is elsewhere in every other frame", "-", last_gain},
           {"frames by which the causal form is late", "-", delay},
           {"time by which the causal form is late", "s", delay / rate}}};
}

const Registered box_response_figure{
    {.name = "box_response",
     .parameters =
         Parameters{}
             .add_whole("frames", 5, 3, 15, "in the window, odd")
             .add_whole("frequencies", 200, 2, 10000, "from 0 to half a cycle a frame, less one")
             .add_number("rate", 60.0, 1.0, 1e4, "1/s", "frames a second"),
     .quick = {"frequencies=40"},
     .experiment = measure_box_response}};

}  // namespace
}  // namespace tumble::chapters
