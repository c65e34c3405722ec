/// \file
/// \brief The one-euro filter: a low-pass filter whose cutoff rises with speed.
#include "tumble/filtering/one_euro_filter.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/math/rotation.hpp"

#include <numbers>

namespace tumble {
namespace {

// The share by which exponential smoothing with a cutoff [Hz] approaches the new value.
double share_of(double cutoff, double dt) {
  return 1.0 / (1.0 + 1.0 / (2.0 * std::numbers::pi * cutoff * dt));
}

}  // namespace

OneEuroFilter::OneEuroFilter(const OneEuroOptions& options) : options_(options) {
  require::positive(options.cutoff, "cutoff of the one-euro filter");
  require::not_negative(options.gain, "gain of the one-euro filter");
  require::positive(options.speed_cutoff, "cutoff of the one-euro filter's speed");
}

std::string OneEuroFilter::text() const {
  return "one_euro:" + shortest_text(options_.cutoff) + "Hz," + shortest_text(options_.gain) + "," +
         shortest_text(options_.speed_cutoff) + "Hz";
}

void OneEuroFilter::follow(const BodyState& now, double dt, FollowedBody& body) const {
  const Vec3 velocity_w = (now.position_w - body.computed.position_w) / dt;
  const Vec3 angular_velocity_w =
      rotation_vector(now.orientation_wb * body.computed.orientation_wb.conjugate()) / dt;
  const double smooth = share_of(options_.speed_cutoff, dt);
  body.velocity_w += smooth * (velocity_w - body.velocity_w);
  body.angular_velocity_w += smooth * (angular_velocity_w - body.angular_velocity_w);

  const Vec3 way = now.position_w - body.shown.position_w;
  const Vec3 turn = rotation_vector(now.orientation_wb * body.shown.orientation_wb.conjugate());
  const auto share = [&](const Vec3& speed) {
    return share_of(options_.cutoff + options_.gain * speed.norm(), dt);
  };
  if (way != Vec3::Zero()) body.shown.position_w += share(body.velocity_w) * way;
  if (turn != Vec3::Zero())
    body.shown.orientation_wb = normalised(
        rotation_from_vector(share(body.angular_velocity_w) * turn) * body.shown.orientation_wb);
}

}  // namespace tumble
