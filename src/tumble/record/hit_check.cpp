/// \file
/// \brief A check of a run by any technique: bodies are where they were hit.
#include "tumble/record/hit_check.hpp"

#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

void HitCheck::on_begin(const World& world) {
  time_ = world.time();
  events_.clear();
  speeds_.clear();
  for (std::size_t k = 0; k < idx(world.count()); ++k)
    speeds_.push_back(velocity(world.bodies()[k], world.states()[k]).norm());
}

void HitCheck::on_change(const World& world, double /*energy_added*/) { on_begin(world); }

void HitCheck::on_event(const Event& event) { events_.push_back(event); }

void HitCheck::on_step(const World& world, const StepReport& /*report*/) {
  status_ = StepStatus::done;
  const double dt = world.time() - time_;
  looked_at_.assign(speeds_.size(), 0);
  for (auto event = events_.rbegin(); event != events_.rend(); ++event) {
    for (const BodyId body : {event->first, event->second}) {
      const std::size_t k = idx(world.index_of(body));
      if (looked_at_[k] != 0 || !world.bodies()[k].movable()) continue;
      looked_at_[k] = 1;
      look(world, *event, body, speeds_[k], dt);
    }
  }
  on_begin(world);
}

void HitCheck::look(const World& world, const Event& event, BodyId id, double speed_before,
                    double dt) {
  const int k = world.index_of(id);
  const BodyProperties& body = world.bodies()[idx(k)];
  const BodyState& state = world.states()[idx(k)];
  const Vec3 velocity_w = velocity(body, state);
  const double half_edge = 0.5 * body.size.minCoeff();
  if (!(dt * std::max(speed_before, velocity_w.norm()) > half_edge)) return;
  const Vec3 place_w = state.position_w - (world.time() - event.time) * velocity_w;
  const double fall = 0.5 * world.gravity_w.norm() * dt * dt;
  const double away = (event.point_w - place_w).norm() - 0.5 * body.size.norm();
  if (!(away > half_edge + fall)) return;
  status_ = StepStatus::held_by_nothing;
  find(world, world.name(k) + " was hit " + rounded_text(away, 3) +
                  " m from where it was: a smaller --dt or a technique that finds the time of an "
                  "impact is needed");
}

}  // namespace tumble
