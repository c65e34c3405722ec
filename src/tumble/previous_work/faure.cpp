/// \file
/// \brief Faure's energy method as a technique.
#include "tumble/previous_work/faure.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/contact_records.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/contact/impulse_work.hpp"
#include "tumble/contact/movable_edge.hpp"
#include "tumble/contact/parts_of_turn.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace tumble {
namespace {

// [m/s] The normal motion of a point at the end of the step is at least this: it may close its gap, or it bounces.
double least_motion(const ContactPoint& point, double dt, double restitution) {
  const double gap = std::max(point.distance, 0.0);
  const double approach = -point.approach_speed;
  if (restitution > 0.0 && approach > 0.0 && gap <= dt * approach) return restitution * approach;
  return -gap / dt;
}

}  // namespace

// --- contacts ---------------------------------------------------------------------------------------

void FaureContacts::take(std::span<const MovingBody> bodies, std::span<const Contact> contacts,
                         double dt, const World& world, const StickyOptions& sticky, bool bounce) {
  bodies_ = bodies;
  bounces_ = false;
  rows_.clear();
  impulses_.clear();
  for (const Contact& contact : contacts) {
    const MovingBody& a = bodies[idx(contact.first)];
    const MovingBody& b = bodies[idx(contact.second)];
    const Tangents tangents = tangents_of(contact.normal_w);
    const StickyScale scale{
        world.gravity_w.norm(),
        movable_edge(world.bodies()[idx(contact.first)], world.bodies()[idx(contact.second)]), dt};
    for (int k = 0; k < contact.count; ++k) {
      const ContactPoint& p = contact.points[idx(k)];
      Row row;
      row.first = contact.first;
      row.second = contact.second;
      row.friction = contact.friction;
      row.axis_w = {contact.normal_w, tangents.first_w, tangents.second_w};
      const Vec3 motion_w = relative_velocity(a, b, p.position_w);
      const Mat3 yield_w = inverse_mass_at(a, b, p.position_w);
      for (std::size_t i = 0; i < 3; ++i) {
        row.arm_first_w[i] = (p.position_w - a.position_w).cross(row.axis_w[i]);
        row.arm_second_w[i] = (p.position_w - b.position_w).cross(row.axis_w[i]);
        row.yield[i] = row.axis_w[i].dot(yield_w * row.axis_w[i]);
        row.constant[i] = row.axis_w[i].dot(motion_w);
      }
      // The mean, so that nothing depends on the choice of directions.
      row.yield[1] = row.yield[2] = 0.5 * (row.yield[1] + row.yield[2]);
      const double e = sticky_restitution(contact.restitution, p.approach_speed, scale, sticky);
      const double least = least_motion(p, dt, bounce ? e : 0.0);
      bounces_ = bounces_ || least > 0.0;
      row.constant[0] -= least;
      rows_.push_back(row);
      impulses_.push_back(p.normal_impulse);
      impulses_.push_back(p.friction_impulse_w.dot(tangents.first_w));
      impulses_.push_back(p.friction_impulse_w.dot(tangents.second_w));
    }
  }
}

// [S2.6.4:multiply]
// What impulses change of the bodies' velocities, and these of the motions of all points.
void FaureContacts::multiply(std::span<const double> p, std::span<double> out) {
  linear_w_.assign(bodies_.size(), Vec3::Zero());
  angular_w_.assign(bodies_.size(), Vec3::Zero());
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const Row& row = rows_[k];
    for (std::size_t i = 0; i < 3; ++i) {
      const double impulse = p[3 * k + i];
      linear_w_[idx(row.first)] -= impulse * row.axis_w[i];
      linear_w_[idx(row.second)] += impulse * row.axis_w[i];
      angular_w_[idx(row.first)] -= impulse * row.arm_first_w[i];
      angular_w_[idx(row.second)] += impulse * row.arm_second_w[i];
    }
  }
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    linear_w_[b] = bodies_[b].inverse_mass.cwiseProduct(linear_w_[b]);
    angular_w_[b] = bodies_[b].inverse_inertia_w * angular_w_[b];
  }
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const Row& row = rows_[k];
    const Vec3 linear_w = linear_w_[idx(row.second)] - linear_w_[idx(row.first)];
    for (std::size_t i = 0; i < 3; ++i)
      out[3 * k + i] = row.axis_w[i].dot(linear_w) +
                       row.arm_second_w[i].dot(angular_w_[idx(row.second)]) -
                       row.arm_first_w[i].dot(angular_w_[idx(row.first)]);
  }
}
// [S2.6.4:multiply]

void FaureContacts::allow(std::span<double> p) const {
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    p[3 * k] = std::max(p[3 * k], 0.0);
    const double most = rows_[k].friction * p[3 * k];
    const double rubs = std::sqrt(p[3 * k + 1] * p[3 * k + 1] + p[3 * k + 2] * p[3 * k + 2]);
    if (!(rubs > most)) continue;
    const double share = most / rubs;
    p[3 * k + 1] *= share;
    p[3 * k + 2] *= share;
  }
}

double FaureContacts::first_step() const {
  double sum = 0.0;
  for (const Row& row : rows_) {
    const double sinks = std::min(row.constant[0], 0.0);
    sum += sinks * sinks / row.yield[0];
  }
  return std::sqrt(sum);
}

void FaureContacts::require_no_energy() {
  allow(impulses_);
  image_.resize(impulses_.size());
  multiply(impulses_, image_);
  double energy = 0.0;
  for (std::size_t i = 0; i < impulses_.size(); ++i)
    energy += impulses_[i] * (0.5 * image_[i] + constant(i));
  if (!(energy <= 0.0)) std::fill(impulses_.begin(), impulses_.end(), 0.0);
}

Vec3 FaureContacts::impulse_w(std::size_t row) const {
  const Row& r = rows_[row];
  return impulses_[3 * row] * r.axis_w[0] + impulses_[3 * row + 1] * r.axis_w[1] +
         impulses_[3 * row + 2] * r.axis_w[2];
}

// --- the technique ----------------------------------------------------------------------------------

Faure::Faure(const FaureOptions& options)
    : options_(options), broad_phase_(make_broad_phase("bounding_tree")) {
  require::that(options.budget >= 0,
                "budget = " + std::to_string(options.budget) + ": expected 0 or more");
  require::not_negative(options.wanted, "wanted");
}

std::unique_ptr<Technique> Faure::clone() const {
  auto copy = std::make_unique<Faure>(options_);
  copy->contacts_ = contacts_;
  copy->records_ = records_;
  copy->descent_ = descent_;
  copy->last_dt_ = last_dt_;
  copy->observe(observer());
  return copy;
}

StepReport Faure::step(World& world, double dt) {
  return step_in_parts(world, dt, [&](World& w, double part, int) { return step_part(w, part); });
}

StepReport Faure::step_part(World& world, double dt) {
  StepReport report;
  load_moving_bodies(world, start_);
  find_contacts(world, dt, report);

  // [S2.6.4:technique]
  // Impulses of all contacts at once.
  push(world, dt, true, report);
  if (gains(report)) {  // by bounces that contradict one another: nothing bounces in this step
    push(world, dt, false, report);
    ++report.fallbacks;
  }

  // All bodies move with the velocities of the end.
  store_moving_bodies(moving_, world);
  for (std::size_t k = 0; k < moving_.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    BodyState& state = world.states()[k];
    if (!body.movable()) continue;
    if (!moving_[k].changed) state.linear_momentum_w += body.mass * dt * world.gravity_w;
    if (moving_[k].changed)
      report.energy.restitution += lift_at_end_velocity(
          world.gravity_w, dt, body.mass * start_[k].velocity_w, state.linear_momentum_w);
    advance_pose(body, state, dt, options_.rotation);
    ++report.integrations;
  }
  // [S2.6.4:technique]

  repair_bounds(world, 0.0, bounds_);
  broad_phase_->find_pairs(bounds_, pairs_);
  book(repair_.run(world, pairs_), report);
  report.contacts = static_cast<std::int64_t>(records_.size());
  last_dt_ = dt;
  return report;
}

// Those that may close their gap within the step, with the impulses that they had.
void Faure::find_contacts(const World& world, double dt, StepReport& report) {
  double fastest = 0.0, edge = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < start_.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable()) continue;
    fastest = std::max(fastest, start_[k].velocity_w.norm() + dt * world.gravity_w.norm() +
                                    0.5 * body.size.norm() * start_[k].angular_velocity_w.norm());
    edge = std::min(edge, body.size.minCoeff());
  }
  const double margin =
      std::isfinite(edge) ? std::min(2.0 * dt * fastest, tolerance::faure_reach * edge) : 0.0;
  std::swap(previous_, contacts_);
  repair_bounds(world, margin, bounds_);
  broad_phase_->find_pairs(bounds_, pairs_);
  const GatherReport found = gather_contacts(world, start_, pairs_, margin, previous_, contacts_);
  report.pair_tests += found.pair_tests;
  report.deepest_overlap = found.deepest_overlap;
  if (!options_.warm || !(last_dt_ > 0.0)) return;
  carry_over_impulses(previous_, contacts_);
  for (Contact& contact : contacts_)
    for (int k = 0; k < contact.count; ++k) {
      contact.points[idx(k)].normal_impulse *= dt / last_dt_;
      contact.points[idx(k)].friction_impulse_w *= dt / last_dt_;
    }
}

// Whether the impulses add energy.
bool Faure::gains(const StepReport& report) const {
  double scale = 0.0;  // [J]
  for (const Contact& contact : contacts_)
    for (int k = 0; k < contact.count; ++k) {
      const ContactPoint& p = contact.points[idx(k)];
      scale += p.normal_impulse * std::abs(p.approach_speed);
    }
  return rows_.bounces() &&
         report.energy.restitution + report.energy.friction > tolerance::faure_gain * scale;
}

// How all bodies move without contacts, and with the impulses that are found. Work is an impulse times the mean of the velocities before and after.
void Faure::push(const World& world, double dt, bool bounce, StepReport& report) {
  moving_ = start_;
  for (std::size_t k = 0; k < moving_.size(); ++k)
    if (world.bodies()[k].movable()) moving_[k].velocity_w += dt * world.gravity_w;
  rows_.take(moving_, contacts_, dt, world, options_.sticky, bounce);
  rows_.require_no_energy();
  descent_ = iteration_.solve(rows_, rows_.impulses(), options_.wanted * rows_.first_step(),
                              options_.budget);
  report.iterations += descent_.iterations;
  report.impulses = 0;
  report.energy = {};
  records_.clear();
  std::size_t row = 0;
  for (Contact& contact : contacts_) {
    for (int k = 0; k < contact.count; ++k, ++row) {
      ContactPoint& p = contact.points[idx(k)];
      const Vec3 impulse_w = rows_.impulse_w(row);
      p.normal_impulse = impulse_w.dot(contact.normal_w);
      p.friction_impulse_w = impulse_w - p.normal_impulse * contact.normal_w;
      if (!(p.normal_impulse > 0.0)) continue;
      apply_impulse(moving_[idx(contact.first)], moving_[idx(contact.second)], p.position_w,
                    impulse_w);
      ++report.impulses;
      records_.push_back(record_of(contact, k, world.time()));
    }
  }
  book_impulses(contacts_, start_, moving_, report.energy);
}

}  // namespace tumble
