/// \file
/// \brief The column of figure 6.1 as if it were one body, and measures of the simulated one.
#include "exterior_rotation/falling_column.hpp"

#include "driver/experiment.hpp"

#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>

namespace tumble::chapters {
namespace {

struct Elliptic {
  double sn = 0.0;
  double cn = 0.0;
  double dn = 0.0;
};

// Of the parameter k² = cos²(φ0/2): GSL wants the parameter for functions, k for integrals.
Elliptic elliptic(double time, double phi0, int count) {
  if (!(phi0 > 0.0 && phi0 < std::numbers::pi))
    throw std::invalid_argument("phi0: expected an angle above 0 and below pi");
  const double k = std::cos(0.5 * phi0);
  Elliptic e;
  gsl_sf_elljac_e(column_frequency(count) * time, k * k, &e.sn, &e.cn, &e.dn);
  return e;
}

// Energy gained in the fall, in units of g R but for a factor.
double fallen(double angle, double phi0) {
  return 2.0 * std::sin(0.5 * (angle + phi0)) * std::sin(0.5 * (angle - phi0));
}

}  // namespace

double column_radius(int count) { return 0.5 * std::sqrt(1.0 + count * count); }

double column_frequency(int count) { return std::sqrt(0.75 * kGravity / column_radius(count)); }

double column_tilt(int count) { return std::atan2(1.0, count); }

double column_angle(double time, double phi0, int count) {
  const Elliptic e = elliptic(time, phi0, count);
  return 2.0 * std::atan2(std::sin(0.5 * phi0), std::cos(0.5 * phi0) * e.cn);
}

double column_rate(double time, double phi0, int count) {
  const Elliptic e = elliptic(time, phi0, count);
  return column_frequency(count) * std::sin(phi0) * e.sn / e.dn;
}

double column_rate_at(double angle, double phi0, int count) {
  return column_frequency(count) * std::sqrt(2.0 * fallen(angle, phi0));
}

double column_time(double angle, double phi0, int count) {
  // cn by the tangent above; sn by the rate, sin(φ/2) = sin(φ0/2) / dn.
  const double k = std::cos(0.5 * phi0);
  const double dn = std::sin(0.5 * phi0) / std::sin(0.5 * angle);
  const double cn = std::cos(0.5 * angle) * dn / k;
  const double sn = std::sqrt(0.5 * fallen(angle, phi0)) / (k * std::sin(0.5 * angle));
  return gsl_sf_ellint_F(std::atan2(sn, cn), k, GSL_PREC_DOUBLE) / column_frequency(count);
}

PivotForce pivot_force(double angle, double phi0, int count) {
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  const double weight = kGravity * count;
  return {weight * (1.0 - 0.75 * s * s - 1.5 * fallen(angle, phi0) * c),
          weight * (0.75 * s * c - 1.5 * fallen(angle, phi0) * s)};
}

GlueForce glue_force(int joint, double angle, double phi0, int count) {
  if (joint < 1 || joint >= count) throw std::invalid_argument("joint: there is no such one");
  const double p = column_frequency(count);
  const double acceleration = p * p * std::sin(angle);        // [rad/s²]
  const double squared = 2.0 * p * p * fallen(angle, phi0);   // [1/s²] of the rate
  const double tilt = angle + column_tilt(count);             // [rad] of the axis
  const int above = count - joint;                            // [kg] and [m] of the upper part
  const double centre = joint + 0.5 * above;                  // [m] its centre along the column
  const double inertia = above * (1.0 + above * above) / 12;  // [kg m²]
  // In the column's frame: x across, towards the fall; y along. The pivot is at (0, 0), the centre of
  // the upper part at (-1/2, centre).
  const double force_x =
      above * (acceleration * centre + 0.5 * squared - kGravity * std::sin(tilt));
  const double force_y =
      above * (0.5 * acceleration - squared * centre + kGravity * std::cos(tilt));
  const double lever = ((joint - centre) * force_x - inertia * acceleration) / force_y;
  return {-force_x, force_y, 0.5 - lever};
}

double opening_angle(int joint, double phi0, int count) {
  // While pressed, the moment about the far edge is positive. It may be pulled later.
  const auto holds = [&](double angle) {
    const GlueForce force = glue_force(joint, angle, phi0, count);
    return force.normal > 0.0 && force.from_edge < 1.0;
  };
  // Coarse steps find the first change, halving the moment.
  constexpr int steps = 1000;
  const double stride = (0.5 * std::numbers::pi - phi0) / steps;
  double high = phi0;
  for (int n = 0; n <= steps && holds(high); ++n) high = phi0 + n * stride;
  if (holds(high)) throw std::runtime_error("the joint holds until the column is level");
  double low = high - stride;
  while (high - low > 4e-16) {  // [rad] rounding of angles below 2
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (holds(middle) ? low : high) = middle;
  }
  return high;
}

World column_world(double angle, double spin, int count) {
  return build_world(scene_with("fig6_1", {setting("angle", angle), setting("spin", spin),
                                           "count=" + std::to_string(count)}));
}

Vec3 column_pivot() { return {0.0, 2.0, 0.0}; }

double centre_angle(const World& world) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < world.bodies().size(); ++k)
    if (world.bodies()[k].movable())
      sum += world.bodies()[k].mass * (world.states()[k].position_w - column_pivot());
  return std::atan2(sum.x(), sum.y());
}

double column_gap(const World& world) {
  std::optional<Vec3> axis_w;
  Vec3 before_w = Vec3::Zero();
  double gap = 0.0;
  for (std::size_t k = 0; k < world.bodies().size(); ++k) {
    if (!world.bodies()[k].movable()) continue;
    const BodyState& state = world.states()[k];
    if (axis_w) {
      const double length = world.bodies()[k].size.y();  // [m] all cubes are equal
      const double between = axis_w->dot(state.position_w - before_w) - length;
      if (std::abs(between) > std::abs(gap)) gap = between;
    } else {
      axis_w = state.orientation_wb * Vec3::UnitY();
    }
    before_w = state.position_w;
  }
  return gap;
}

}  // namespace tumble::chapters
