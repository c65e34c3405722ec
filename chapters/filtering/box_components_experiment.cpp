/// \file
/// \brief Erratum P13: what comes of averaging the components of quaternions (thesis 5.5).
#include "tumble/filtering/box_filter.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

constexpr int kMeanOf = 5;   // frames, the thesis's
constexpr int kLength = 21;  // frames of a motion, its event in the middle
constexpr double kToDegrees = 180.0 / std::numbers::pi;
const Vec3 kAbout = Vec3(6.0, 2.0, -3.0) / 7.0;

// A body that turns about an axis, by angle and frame.
struct Turning {
  std::vector<double> angle;  // [rad]
  Trajectory run;             // stored with w >= 0, as many files have it
};

Turning turning(const std::function<double(int)>& angle, double rate) {
  Turning motion;
  const std::vector<BodyId> ids = {BodyId{1}};
  std::vector<BodyState> states(1);
  for (int n = 0; n < kLength; ++n) {
    motion.angle.push_back(angle(n));
    Quat q = normalised(rotation_from_vector(motion.angle.back() * kAbout));
    if (q.w() < 0.0) q.coeffs() = -q.coeffs();
    states[0].orientation_wb = q;
    motion.run.record(Frame{n / rate, n, ids, states});
  }
  return motion;
}

// Turns steadily past half a turn, where w changes its sign.
Turning steady(double speed, double rate) {
  return turning([&](int n) { return std::numbers::pi + (n - 0.5 * kLength) * speed / rate; },
                 rate);
}

// Turns, and from the middle on it does not.
Turning stopped(double speed, double rate) {
  return turning([&](int n) { return std::min(n, kLength / 2) * speed / rate; }, rate);
}

// The mean of the components in a window.
Eigen::Vector4d component_mean(const Trajectory& run, int middle, bool aligned) {
  const Eigen::Vector4d centre = run.frame(middle).states[0].orientation_wb.coeffs();
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (int n = middle - kMeanOf / 2; n <= middle + kMeanOf / 2; ++n) {
    const Eigen::Vector4d q = run.frame(n).states[0].orientation_wb.coeffs();
    sum += aligned && q.dot(centre) < 0.0 ? Eigen::Vector4d(-q) : q;
  }
  return sum / kMeanOf;
}

// About a fixed axis a mean orientation is that of the mean angle.
double mean_angle(const Turning& motion, int middle) {
  double sum = 0.0;
  for (int n = middle - kMeanOf / 2; n <= middle + kMeanOf / 2; ++n) sum += motion.angle[idx(n)];
  return sum / kMeanOf;
}

// How wrong means are at worst, over all whole windows of a motion.
struct Errors {
  double components = 0.0;  // [rad] as they are stored
  double aligned = 0.0;     // [rad] with one sign
  double shrunk = 0.0;      // [-] what their length lacks to 1, with one sign
  double tangent = 0.0;     // [rad] of the filter of the library
};

Errors errors_of(const Turning& motion) {
  const Trajectory shown = filtered(motion.run, BoxFilter(kMeanOf));
  Errors worst;
  for (int n = kMeanOf / 2; n < kLength - kMeanOf / 2; ++n) {
    const Quat exact = rotation_from_vector(mean_angle(motion, n) * kAbout);
    const auto error = [&](const Eigen::Vector4d& mean) {
      return angle_between(normalised(Quat(mean)), exact);
    };
    const Eigen::Vector4d aligned = component_mean(motion.run, n, true);
    worst.components = std::max(worst.components, error(component_mean(motion.run, n, false)));
    worst.aligned = std::max(worst.aligned, error(aligned));
    worst.shrunk = std::max(worst.shrunk, 1.0 - aligned.norm());
    worst.tangent =
        std::max(worst.tangent, error(shown.frame(n).states[0].orientation_wb.coeffs()));
  }
  return worst;
}

// The angle turned by since the middle, as each mean shows it.
Table flip_table(const Turning& motion) {
  Table table{"flip",
              {{"frame", "-", "0: the last before the sign changes"},
               {"computed_deg", "deg", "angle turned by, computed"},
               {"components_deg", "deg", "mean of the components as stored"},
               {"tangent_deg", "deg", "mean of rotation vectors"}}};
  const Trajectory shown = filtered(motion.run, BoxFilter(kMeanOf));
  const Quat middle = rotation_from_vector(motion.angle[kLength / 2] * kAbout);
  const auto degrees = [&](const Quat& q) {
    return kToDegrees * rotation_vector(q * middle.conjugate()).dot(kAbout);
  };
  for (int n = kMeanOf / 2; n < kLength - kMeanOf / 2; ++n)
    table.add(n - kLength / 2, degrees(motion.run.frame(n).states[0].orientation_wb),
              degrees(normalised(Quat(component_mean(motion.run, n, false)))),
              degrees(shown.frame(n).states[0].orientation_wb));
  return table;
}

Result measure_component_means(const Parameters& settings) {
  const double rate = settings.number("rate");
  const double slowest = 0.1;  // [rad/s]
  const double fastest = settings.number("fastest");
  const int speeds = settings.count("speeds");
  Table table{"",
              {{"speed_rad_s", "rad/s", "of the body"},
               {"components", "rad", "mean of components as stored, the sign changes"},
               {"aligned", "rad", "mean of components with one sign, the body stops"},
               {"tangent", "rad", "mean of rotation vectors, the worse of the two"}}};
  for (int k = 0; k <= speeds; ++k) {
    const double speed =
        slowest * elementary::pow(fastest / slowest, static_cast<double>(k) / speeds);
    const Errors on = errors_of(steady(speed, rate));
    const Errors off = errors_of(stopped(speed, rate));
    table.add(speed, on.components, std::max(off.aligned, kNearNothing),
              std::max({on.tangent, off.tangent, kNearNothing}));
  }

  const double shown_speed = settings.number("speed");
  const Errors on = errors_of(steady(shown_speed, rate));
  const Errors off = errors_of(stopped(shown_speed, rate));
  return {{table, flip_table(steady(shown_speed, rate))},
          {{"P13: angle to the right mean while a sign changes, mean of components", "rad",
            on.components},
           {"P13: angle to the right mean while a sign changes, mean of rotation vectors", "rad",
            on.tangent},
           {"the same over the turn in a frame, mean of components", "-",
            on.components / (shown_speed / rate)},
           {"angle to the right mean of a body that stops, components with one sign", "rad",
            off.aligned},
           {"angle to the right mean of a body that stops, mean of rotation vectors", "rad",
            off.tangent},
           {"by how much that mean of components is shorter than 1", "-", off.shrunk}}};
}

const Registered errata_filtering_figure{
    {.name = "errata_filtering",
     .parameters = {number("speed", 5.0, 0.01, 60.0, "rad/s", "of the body above"),
                    whole("speeds", 40, 2, 10000, "in the sweep, less one"),
                    number("fastest", 60.0, 1.0, 90.0, "rad/s", "of the sweep"),
                    number("rate", 60.0, 60.0, 1e4, "1/s", "frames a second")},
     .experiment = measure_component_means}};

}  // namespace
}  // namespace tumble::chapters
