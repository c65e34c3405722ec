/// \file
/// \brief A box that hangs on one of its edges and swings.
#include "exterior_rotation/box_pendulum.hpp"

#include "driver/experiment.hpp"
#include "exterior_rotation/glued_runs.hpp"

#include <gsl/gsl_sf_ellint.h>

namespace tumble::chapters {
namespace {

Quat about_z(double angle) { return rotation_from_vector(Vec3(0.0, 0.0, angle)); }

// [s] from the start until the box hangs straight down, which it does within a step.
double passage_within_step(const HungBox& start) {
  double low = 0.0;
  double high = kStep;
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high || high - low < 1e-16) return high;
    HungBox trial = start;
    finished(trial.glued.step(trial.world, middle));
    (trial.angle() * start.angle() > 0.0 ? low : high) = middle;
  }
}

}  // namespace

double exact_swing_period(double width, double height, double amplitude) {
  const double lever = 0.5 * std::hypot(width, height);
  const double p = std::sqrt(0.75 * kGravity / lever);
  return 4.0 * gsl_sf_ellint_Kcomp(std::sin(0.5 * amplitude), GSL_PREC_DOUBLE) / p;
}

HungBox::HungBox(double width, double height, double amplitude, const GluedOptions& options)
    : glued(options) {
  const BodyProperties beam = fixed_box_properties(Vec3(4.0, 1.0, 4.0));
  BodyState beam_state;
  beam_state.position_w = Vec3(0.0, 0.5, 0.0);
  world.add(beam, beam_state, "beam");

  // The edge is at the upper right of the box; straight below it, its centre is on the diagonal.
  const Vec3 centre_b(-0.5 * width, -0.5 * height, 0.0);
  const double hanging = 0.5 * std::numbers::pi - std::atan2(height, width);
  const auto hung_at = [&](double angle) {
    BodyState state;
    state.orientation_wb = about_z(hanging + angle);
    state.position_w = state.orientation_wb * centre_b;
    return state;
  };
  const BodyId box =
      world.add(box_properties(Vec3(width, height, 1.0), width * height), hung_at(0.0), "box");
  glued.find(world);
  world.set_state(box, hung_at(amplitude));
}

double HungBox::angle() const {
  const Vec3& centre_w = world.states()[1].position_w;
  return std::atan2(centre_w.x(), -centre_w.y());
}

double HungBox::energy() const { return energy_of(world).total(); }

MeasuredSwing measure_swing(double width, double height, double amplitude, double accuracy) {
  HungBox box(width, height, amplitude,
              glued_options(GluedScheme::dormand_prince, PoseUpdate::separate, accuracy));
  std::array<double, 2> passages{};  // [s]
  for (double& passage : passages) {
    for (;;) {
      const HungBox start = box;
      finished(box.glued.step(box.world, kStep));
      if (box.angle() * start.angle() > 0.0) continue;
      passage = start.world.time() + passage_within_step(start);
      break;
    }
  }
  MeasuredSwing found;
  found.period = 2.0 * (passages[1] - passages[0]);
  found.apart = gap_of(box.glued.joints(), box.world.states()).apart;
  return found;
}

}  // namespace tumble::chapters
