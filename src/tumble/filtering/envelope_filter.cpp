/// \file
/// \brief Two envelope filters: the thesis's, which pops, and one that does not.
#include "tumble/filtering/envelope_filter.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/math/rotation.hpp"

#include <algorithm>

namespace tumble {
namespace {

void require_valid(const Envelope& envelope) {
  require::positive(envelope.radius, "radius of the envelope");
  require::positive(envelope.angle, "angle of the envelope");
}

std::string text_of(const Envelope& envelope) {
  return shortest_text(envelope.radius) + "m," + shortest_text(envelope.angle) + "rad";
}

// Distance of two poses, in envelopes.
double apart(const BodyState& a, const BodyState& b, const Envelope& envelope) {
  return std::max((a.position_w - b.position_w).norm() / envelope.radius,
                  angle_between(a.orientation_wb, b.orientation_wb) / envelope.angle);
}

}  // namespace

EnvelopeFilter::EnvelopeFilter(const Envelope& envelope) : envelope_(envelope) {
  require_valid(envelope);
}

std::string EnvelopeFilter::text() const { return "envelope:" + text_of(envelope_); }

// [S5.5]
void EnvelopeFilter::follow(const BodyState& now, double dt, FollowedBody& body) const {
  (void)dt;
  const bool left = (now.position_w - body.shown.position_w).norm() > envelope_.radius ||
                    angle_between(now.orientation_wb, body.shown.orientation_wb) > envelope_.angle;
  if (left) body.shown = now;
}
// [S5.5]

SoftEnvelopeFilter::SoftEnvelopeFilter(const Envelope& envelope) : envelope_(envelope) {
  require_valid(envelope);
}

std::string SoftEnvelopeFilter::text() const { return "soft_envelope:" + text_of(envelope_); }

// [S5.5:soft]
void SoftEnvelopeFilter::follow(const BodyState& now, double dt, FollowedBody& body) const {
  (void)dt;
  const double allowed = std::max(0.0, 1.0 - apart(now, body.computed, envelope_));
  const double offset = apart(now, body.shown, envelope_);
  if (!(offset > allowed)) return;
  if (allowed == 0.0) {
    body.shown = now;
    return;
  }
  // The remaining distance to the computed pose is the allowed one.
  const double left = allowed / offset;
  const Vec3 turn = rotation_vector(body.shown.orientation_wb * now.orientation_wb.conjugate());
  body.shown.position_w = now.position_w + left * (body.shown.position_w - now.position_w);
  if (turn != Vec3::Zero())
    body.shown.orientation_wb = normalised(rotation_from_vector(left * turn) * now.orientation_wb);
}
// [S5.5:soft]

}  // namespace tumble
