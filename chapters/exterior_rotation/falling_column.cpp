/// \file
/// \brief The column of figure 6.1 as if it were one body, and measures of the simulated one.
#include "exterior_rotation/falling_column.hpp"

#include "driver/experiment.hpp"

#include <gsl/gsl_sf_elljac.h>

namespace tumble::chapters {
namespace {

struct Elliptic {
  double sn = 0.0;
  double cn = 0.0;
  double dn = 0.0;
};

// Of the parameter k² = cos²(φ0/2).
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

World column_world(double angle, double spin, int count) {
  return build_world(make_scene("fig6_1", {setting("angle", angle), setting("spin", spin),
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
