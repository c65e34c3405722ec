/// \file
/// \brief A check of a run by any technique: bodies are where they were hit.
#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/record/run_checks.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

void HitCheck::on_begin(const World& world) {
  time_ = world.time();
  events_.clear();
  before_.assign(world.states().begin(), world.states().end());
}

void HitCheck::on_change(const World& world, double /*energy_added*/) { on_begin(world); }

void HitCheck::on_event(const Event& event) { events_.push_back(event); }

void HitCheck::on_step(const World& world, const StepReport& /*report*/) {
  status_ = StepStatus::done;
  if (!events_.empty()) find_speeds(world);
  for (const Event& event : events_)
    for (const BodyId body : {event.first, event.second}) look(world, event, body);
  on_begin(world);
}

// No body was faster in the step than before and after it and all its impulses together.
void HitCheck::find_speeds(const World& world) {
  speeds_.clear();
  for (std::size_t k = 0; k < before_.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    speeds_.push_back(velocity(body, before_[k]).norm() + velocity(body, world.states()[k]).norm());
  }
  for (const Event& event : events_) {
    for (const BodyId id : {event.first, event.second}) {
      const std::size_t k = idx(world.index_of(id));
      speeds_[k] += event.impulse_w.norm() * world.bodies()[k].inverse_mass;
    }
  }
}

void HitCheck::look(const World& world, const Event& event, BodyId id) {
  const int k = world.index_of(id);
  const BodyProperties& body = world.bodies()[idx(k)];
  const double half_edge = 0.5 * body.size.minCoeff();
  const double dt = world.time() - time_;
  const double speed = speeds_[idx(k)];
  if (!body.movable() || !(dt * speed > half_edge)) return;
  const auto away_from = [&](const BodyState& state, double time) {
    return (event.point_w - state.position_w).norm() - 0.5 * body.size.norm() -
           std::abs(event.time - time) * speed;
  };
  const double away =
      std::max(away_from(before_[idx(k)], time_), away_from(world.states()[idx(k)], world.time()));
  const double fall = 0.5 * world.gravity_w.norm() * dt * dt;
  if (!(away > half_edge + fall)) return;
  status_ = StepStatus::held_by_nothing;
  find(world, world.name(k) + " was hit " + rounded_text(away, 3) +
                  " m from where it was: a smaller --dt or a technique that finds the time of an "
                  "impact is needed");
}

}  // namespace tumble
