/// \file
/// \brief Boxes of particles and rods held by relaxation.
#include "tumble/previous_work/relaxation.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/contact_records.hpp"
#include "tumble/contact/movable_edge.hpp"
#include "tumble/contact/repair.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/previous_work/tolerances.hpp"

#include <algorithm>
#include <string>

namespace tumble {
namespace {

constexpr std::array<std::array<int, 2>, 6> kEdges{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

}  // namespace

Relaxation::Relaxation(const RelaxationOptions& options) : options_(options) {
  require::that(options.passes >= 1,
                "passes = " + std::to_string(options.passes) + ": expected 1 or more");
}

std::vector<std::string> Relaxation::ignores(const World& world) const {
  const auto bounces = [](const BodyProperties& body) { return body.restitution > 0.0; };
  if (std::none_of(world.bodies().begin(), world.bodies().end(), bounces)) return {};
  return {"restitution"};
}

StepReport Relaxation::step(World& world, double dt) {
  require::positive(dt, "dt");
  StepReport report;
  const double energy = energy_of(world).total();
  load(world, dt);
  // [S2.3:step]
  // All particles go on as they went, and contacts are looked for where they come.
  particles_.advance(world.gravity_w, dt);
  show(world, dt, report);
  find_contacts(world, dt, report);
  // Rods and contacts in turn; each disturbs the others.
  for (int pass = 0; pass < options_.passes; ++pass) {
    particles_.relax();
    project();
  }
  // [S2.3:step]
  report.iterations = options_.passes;
  store(world, dt, report);
  record(world, dt, energy, report);
  last_dt_ = dt;
  world.finish_step(dt);
  return report;
}

// Particles of the step before, unless the body was moved or pushed from outside in between.
void Relaxation::load(const World& world, double dt) {
  const std::size_t count = world.bodies().size();
  first_.assign(count, -1);
  particles_.now_w.clear();
  particles_.before_w.clear();
  particles_.inverse_mass.clear();
  particles_.rods.clear();
  std::size_t old = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable()) continue;
    const int first = static_cast<int>(particles_.now_w.size());
    first_[k] = first;
    for (int i = 0; i < 4; ++i) {
      particles_.now_w.emplace_back(Vec3::Zero());
      particles_.before_w.emplace_back(Vec3::Zero());
      particles_.inverse_mass.push_back(4.0 * body.inverse_mass);
    }
    for (const auto& [a, b] : kEdges) {
      const Vec3 along =
          particle_of_box(0.5 * body.size, idx(a)) - particle_of_box(0.5 * body.size, idx(b));
      particles_.rods.push_back({first + a, first + b, along.norm()});
    }
    while (old < kept_.size() && kept_[old].id < world.ids()[k]) ++old;
    const bool same = old < kept_.size() && kept_[old].id == world.ids()[k] &&
                      kept_[old].written == world.states()[k];
    if (!same) {
      put_in_place(world, k, dt);
      continue;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3& now_w = kept_[old].now_w[i];
      const Vec3 way_w = now_w - kept_[old].before_w[i];
      particles_.now_w[idx(first) + i] = now_w;
      particles_.before_w[idx(first) + i] =
          dt == last_dt_ ? kept_[old].before_w[i] : Vec3(now_w - dt / last_dt_ * way_w);
    }
  }
}

// Particles of a box without strain that moves as its momenta say.
void Relaxation::put_in_place(const World& world, std::size_t body, double dt) {
  const BodyProperties& box = world.bodies()[body];
  const BodyState& state = world.states()[body];
  const MovingBody moving = moving_body_of(box, state);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 arm_w = state.orientation_wb * particle_of_box(0.5 * box.size, i);
    const Vec3 way_w = dt * (moving.velocity_w + moving.angular_velocity_w.cross(arm_w));
    particles_.now_w[idx(first_[body]) + i] = state.position_w + arm_w;
    particles_.before_w[idx(first_[body]) + i] = state.position_w + arm_w - way_w;
  }
}

// Writes poses and momenta of all boxes. One that is turned inside out is put back as its momenta say.
void Relaxation::show(World& world, double dt, StepReport& report) {
  for (std::size_t k = 0; k < first_.size(); ++k) {
    if (first_[k] < 0) continue;
    const BodyProperties& body = world.bodies()[k];
    BodyState& state = world.states()[k];
    const std::size_t first = idx(first_[k]);
    std::array<Vec3, 4> now_w;
    std::copy_n(particles_.now_w.begin() + first_[k], 4, now_w.begin());
    const FittedBox fitted = fit_box(0.5 * body.size, now_w);
    Vec3 push_w = Vec3::Zero(), spin_w = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 way_w = now_w[i] - particles_.before_w[first + i];
      push_w += way_w;
      spin_w += (now_w[i] - fitted.centre_w).cross(way_w);
    }
    state.position_w = fitted.centre_w;
    state.linear_momentum_w = 0.25 * body.mass / dt * push_w;
    state.angular_momentum_w = 0.25 * body.mass / dt * spin_w;
    if (fitted.found) {
      state.orientation_wb = fitted.orientation_wb;
    } else {
      put_in_place(world, k, dt);
      ++report.fallbacks;
    }
  }
}

// At the poses that the particles have come to.
void Relaxation::find_contacts(const World& world, double dt, StepReport& report) {
  const double margin = tolerance::relaxation_reach * movable_edge(world);
  repair_bounds(world, margin, bounds_);
  near_.find_pairs(bounds_, pairs_);
  load_moving_bodies(world, moving_);
  const GatherReport found = gather_contacts(world, moving_, pairs_, margin, {}, contacts_);
  report.pair_tests += found.pair_tests;
  report.deepest_overlap = found.deepest_overlap;
  touches_.clear();
  for (const Contact& contact : contacts_)
    for (int k = 0; k < contact.count; ++k) take_up(world, contact, contact.points[idx(k)], dt);
}

// A contact point as means of the particles of its bodies.
void Relaxation::take_up(const World& world, const Contact& contact, const ContactPoint& point,
                         double dt) {
  Touch touch;
  touch.normal_w = contact.normal_w;
  touch.friction = contact.friction;
  const std::array<int, 2> bodies{contact.first, contact.second};
  for (std::size_t side = 0; side < 2; ++side) {
    const std::size_t k = idx(bodies[side]);
    const double half_gap = side == 0 ? -0.5 * point.distance : 0.5 * point.distance;
    touch.place_w[side] = point.position_w + half_gap * contact.normal_w;
    touch.particle[side] = first_[k];
    if (first_[k] < 0) continue;
    const BodyState& state = world.states()[k];
    touch.weight[side] =
        weights_of(0.5 * world.bodies()[k].size,
                   state.orientation_wb.conjugate() * (touch.place_w[side] - state.position_w));
    for (const double c : touch.weight[side])
      touch.yield += c * c * particles_.inverse_mass[idx(first_[k])];
  }
  touch.apart_w = apart(touch, particles_.before_w);
  touch.way_w = apart(touch, particles_.now_w) - touch.apart_w;
  for (std::size_t side = 0; side < 2; ++side)  // without what gravity has just added
    if (touch.particle[side] >= 0)
      touch.way_w += (side == 0 ? 1.0 : -1.0) * dt * dt * world.gravity_w;
  touches_.push_back(touch);
}

// [m] from the point of the first body to that of the second
Vec3 Relaxation::apart(const Touch& touch, const std::vector<Vec3>& at_w) const {
  std::array<Vec3, 2> point_w = touch.place_w;
  for (std::size_t side = 0; side < 2; ++side) {
    if (touch.particle[side] < 0) continue;
    point_w[side].setZero();
    for (std::size_t i = 0; i < 4; ++i)
      point_w[side] += touch.weight[side][i] * at_w[idx(touch.particle[side]) + i];
  }
  return point_w[1] - point_w[0];
}

// Moves the particles of both bodies, each by its weight and inverse mass, with opposite signs.
void Relaxation::move(const Touch& touch, const Vec3& push_w) {
  for (std::size_t side = 0; side < 2; ++side) {
    if (touch.particle[side] < 0) continue;
    const double sign = side == 0 ? -1.0 : 1.0;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t k = idx(touch.particle[side]) + i;
      particles_.now_w[k] += sign * touch.weight[side][i] * particles_.inverse_mass[k] * push_w;
    }
  }
}

// [S2.3:project]
// Each point is moved out of the other body, and its slip taken back as far as friction goes.
void Relaxation::project() {
  for (Touch& touch : touches_) {
    const double gap = touch.normal_w.dot(apart(touch, particles_.now_w));
    if (gap < 0.0) {
      const double push = -gap / touch.yield;
      touch.push += push;
      move(touch, push * touch.normal_w);
    }
    if (!(touch.push > 0.0) || !(touch.friction > 0.0)) continue;
    Vec3 slip_w = apart(touch, particles_.now_w) - touch.apart_w;
    slip_w -= touch.normal_w.dot(slip_w) * touch.normal_w;
    Vec3 rub_w = touch.rub_w - slip_w / touch.yield;
    const double most = touch.friction * touch.push;
    if (rub_w.norm() > most) rub_w *= most / rub_w.norm();
    move(touch, rub_w - touch.rub_w);
    touch.rub_w = rub_w;
  }
}
// [S2.3:project]

// Poses and momenta; what the particles go on with is kept.
void Relaxation::store(World& world, double dt, StepReport& report) {
  show(world, dt, report);
  kept_.clear();
  for (std::size_t k = 0; k < first_.size(); ++k) {
    if (first_[k] < 0) continue;
    Kept& kept = kept_.emplace_back();
    kept.id = world.ids()[k];
    kept.written = world.states()[k];
    std::copy_n(particles_.now_w.begin() + first_[k], 4, kept.now_w.begin());
    std::copy_n(particles_.before_w.begin() + first_[k], 4, kept.before_w.begin());
    ++report.integrations;
  }
}

// Work is an impulse times the mean of the velocities before and after. The rest of what changes is booked to the rods.
void Relaxation::record(const World& world, double dt, double energy, StepReport& report) {
  records_.clear();
  std::size_t next = 0;
  for (Contact& contact : contacts_) {
    for (int k = 0; k < contact.count; ++k, ++next) {
      const Touch& touch = touches_[next];
      ContactPoint& point = contact.points[idx(k)];
      point.normal_impulse = touch.push / dt;
      point.friction_impulse_w = touch.rub_w / dt;
      if (!(touch.push > 0.0)) continue;
      ++report.impulses;
      const Vec3 mean_w = 0.5 * (touch.way_w + apart(touch, particles_.now_w) - touch.apart_w) / dt;
      report.energy.restitution += point.normal_impulse * touch.normal_w.dot(mean_w);
      report.energy.friction += point.friction_impulse_w.dot(mean_w);
      records_.push_back(record_of(contact, k, world.time() + dt));
    }
  }
  report.contacts = static_cast<std::int64_t>(records_.size());
  report.energy.damping =
      energy_of(world).total() - energy - report.energy.restitution - report.energy.friction;
}

}  // namespace tumble
