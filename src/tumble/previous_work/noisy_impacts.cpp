/// \file
/// \brief Impacts disturbed after the step.
#include "tumble/previous_work/noisy_impacts.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/math/elementary.hpp"
#include "tumble/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace tumble {

void NoisyImpacts::Meeting::add(const Vec3& point, const Vec3& normal, const Vec3& impulse,
                                double at) {
  const double along = std::abs(normal.dot(impulse));
  impulse_w += impulse;
  normal_w += along * normal;
  point_w += along * point;
  time += along * at;
  weight += along;
}

namespace {

constexpr int kMostNoiseHalvings = 8;
constexpr double kMostDeviations = 3.0;  // of a Gaussian angle

class EventsByPair : public Observer {
 public:
  explicit EventsByPair(Observer* next) : next_(next) {}
  void on_event(const Event& event) override {
    events.push_back(event);
    if (next_ != nullptr) next_->on_event(event);
  }
  std::vector<Event> events;

 private:
  Observer* next_;
};

// [J] kinetic energy of both, and potential energy in gravity
double energy_of_pair(const World& world, std::span<const BodyState> states, int first,
                      int second) {
  double energy = 0.0;
  for (const int k : {first, second}) {
    const BodyProperties& body = world.bodies()[idx(k)];
    if (!body.movable()) continue;
    energy += kinetic_energy(body, states[idx(k)]) -
              body.mass * world.gravity_w.dot(states[idx(k)].position_w);
  }
  return energy;
}

// Whether a body moved fast enough for a fast impact, so that its contacts need to be looked at.
bool any_fast(const World& world, std::span<const BodyState> states, double share) {
  double shortest = std::numeric_limits<double>::infinity();
  double fastest = 0.0;
  for (std::size_t k = 0; k < states.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (body.shape == Shape::box) shortest = std::min(shortest, body.size.minCoeff());
    if (body.movable())
      fastest = std::max(fastest, fastest_point_speed(body, velocity(body, states[k]),
                                                      angular_velocity(body, states[k])));
  }
  return 2.0 * fastest > share * std::sqrt(world.gravity_w.norm() * shortest);
}

// Box and Muller's Gaussian angle, with its axis across the normal.
Vec3 random_turn(const Vec3& normal_w, double deviation, double radius, double turn) {
  const double angle =
      deviation * std::min(kMostDeviations, std::sqrt(-2.0 * elementary::log(1.0 - radius)));
  const elementary::SinCos way = elementary::sincos(2.0 * std::numbers::pi * turn);
  const Tangents across = tangents_of(normal_w);
  return angle * (way.cos * across.first_w + way.sin * across.second_w);
}

}  // namespace

void require_valid(const ImpactNoiseOptions& options) {
  require::not_negative(options.speed, "noise speed");
  require::within(options.normal, 0.0, 1.0, "noise normal");
  require::within(options.restitution, 0.0, 1.0, "noise restitution");
}

NoisyImpacts::NoisyImpacts(std::unique_ptr<Technique> inner, ImpactNoise noise,
                           const ImpactNoiseOptions& options)
    : Cloned(std::move(inner)), noise_(std::move(noise)), options_(options) {
  require_valid(options);
}

StepReport NoisyImpacts::step(World& world, double dt) {
  before_.assign(world.states().begin(), world.states().end());
  const double start = world.time();
  EventsByPair seen(observer());
  Technique& technique = prepared_inner();
  technique.observe(&seen);
  StepReport report;
  try {
    report = technique.step(world, dt);
  } catch (...) {
    technique.observe(nullptr);
    throw;
  }
  technique.observe(nullptr);
  if (report.status >= StepStatus::unsolved || !all_finite(world)) return report;
  std::vector<Meeting> meetings;
  const auto meeting_of = [&](BodyId first, BodyId second) {
    return std::find_if(meetings.begin(), meetings.end(),
                        [&](const Meeting& m) { return m.first == first && m.second == second; });
  };
  const auto add = [&](const auto& event, const Vec3& impulse_w) {
    auto meeting = meeting_of(event.first, event.second);
    if (meeting == meetings.end())
      meeting = meetings.insert(meetings.end(), Meeting{event.first, event.second});
    meeting->add(event.point_w, event.normal_w, impulse_w, event.time);
  };
  for (const Event& event : seen.events) add(event, event.impulse_w);
  has_events_ = has_events_ || !seen.events.empty();
  if (!has_events_ && any_fast(world, before_, options_.speed)) {
    for (const ContactRecord& contact : technique.contacts())
      if (contact.is_impulse) add(contact, contact.push_w);
  }
  for (const Meeting& meeting : meetings) disturb(world, meeting, start, report.energy);
  return report;
}

// The body as it was before the step, flown to the time of the impact.
MovingBody NoisyImpacts::before_impact(const World& world, int index, double flown) const {
  const BodyProperties& body = world.bodies()[idx(index)];
  MovingBody moving = moving_body_of(body, before_[idx(index)]);
  if (body.movable())
    moving.position_w += flown * moving.velocity_w + 0.5 * flown * flown * world.gravity_w;
  return moving;
}

void NoisyImpacts::disturb(World& world, const Meeting& meeting, double start,
                           BookedEnergy& energy) {
  const double length = meeting.normal_w.norm();
  if (!(meeting.weight > 0.0) || !(length > 0.0)) return;
  const Vec3 n_w = meeting.normal_w / length;
  const Vec3 point_w = meeting.point_w / meeting.weight;
  const int first = world.index_of(meeting.first);
  const int second = world.index_of(meeting.second);
  const BodyProperties& a = world.bodies()[idx(first)];
  const BodyProperties& b = world.bodies()[idx(second)];
  const double flown = std::clamp(meeting.time / meeting.weight - start, 0.0, world.time() - start);
  const MovingBody before_a = before_impact(world, first, flown);
  const MovingBody before_b = before_impact(world, second, flown);
  const double approach = -n_w.dot(relative_velocity(before_a, before_b, point_w));
  const double scale = std::sqrt(world.gravity_w.norm() * shortest_edge(a, b));
  if (!(approach > options_.speed * scale)) return;

  // Fast: its name, and the values that go with it.
  const auto same_pair = [&](const ImpactName& name) {
    return name.first == meeting.first && name.second == meeting.second;
  };
  const auto number = std::count_if(impacts_.begin(), impacts_.end(), same_pair);
  impacts_.push_back({meeting.first, meeting.second, static_cast<int>(number)});
  const ImpactValues values = noise_.of(impacts_.back());

  // [S2.4.2:disturb]
  // delta = (R - 1) j + (e' - e) |n u| / (n K n) n
  MovingBody body_a = moving_body_of(a, world.states()[idx(first)]);
  MovingBody body_b = moving_body_of(b, world.states()[idx(second)]);
  body_a.position_w = before_a.position_w;  // the point belongs to these
  body_b.position_w = before_b.position_w;
  const Mat3 k_w = inverse_mass_at(body_a, body_b, point_w);
  const double yield = n_w.dot(k_w * n_w);
  if (!(yield > 0.0)) return;
  const double e = std::max(a.restitution, b.restitution);
  const double varied = std::clamp(e + options_.restitution * (2.0 * values[0] - 1.0), 0.0, 1.0);
  const Vec3 turn_w = random_turn(n_w, options_.normal, values[1], values[2]);
  Vec3 delta_w = rotation_from_vector(turn_w) * meeting.impulse_w - meeting.impulse_w +
                 (varied - e) * approach / yield * n_w;

  const Vec3 left_w = relative_velocity(body_a, body_b, point_w);
  const double left = energy_of_pair(world, world.states(), first, second);
  const double allowed = energy_of_pair(world, before_, first, second) -
                         0.5 * (1.0 - varied * varied) * approach * approach / yield;
  for (int halving = 0; halving < kMostNoiseHalvings; ++halving, delta_w *= 0.5) {
    // What would make the point approach is taken back along the normal.
    const double speed = n_w.dot(left_w + k_w * delta_w);
    const double least = std::min(0.0, n_w.dot(left_w));
    const Vec3 impulse_w = delta_w + std::max(0.0, least - speed) / yield * n_w;
    const double added = impulse_w.dot(left_w) + 0.5 * impulse_w.dot(k_w * impulse_w);
    if (added > std::max(0.0, allowed - left)) continue;
    apply_impulse(body_a, body_b, point_w, impulse_w);
    if (a.movable()) store_moving_body(body_a, a, world.states()[idx(first)]);
    if (b.movable()) store_moving_body(body_b, b, world.states()[idx(second)]);
    energy.restitution += added;
    return;
  }
  // [S2.4.2:disturb]
}

}  // namespace tumble
