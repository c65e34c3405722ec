/// \file
/// \brief A check of a run by any technique: nothing hangs in the air.
#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/record/run_checks.hpp"
#include "tumble/record/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

void HangCheck::on_begin(const World& world) {
  time_ = world.time();
  stays_.clear();
  for (const BodyState& state : world.states())
    stays_.push_back({.place_w = state.position_w, .since = time_});
  hit_.clear();
}

void HangCheck::on_change(const World& world, double /*energy_added*/) { on_begin(world); }

void HangCheck::on_event(const Event& event) {
  hit_.push_back(event.first);
  hit_.push_back(event.second);
}

void HangCheck::on_step(const World& world, const StepReport& /*report*/) {
  status_ = StepStatus::done;
  const double dt = world.time() - time_;
  const double gravity = world.gravity_w.norm();
  time_ = world.time();
  std::sort(hit_.begin(), hit_.end());
  bool due = false;
  for (std::size_t k = 0; k < stays_.size() && gravity > 0.0; ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable()) continue;
    Stay& stay = stays_[k];
    const Vec3& place_w = world.states()[k].position_w;
    const double edge = tolerance::deep_overlap * body.size.minCoeff();
    const double least = std::max(std::sqrt(2.0 * edge / gravity), tolerance::hang_steps * dt);
    const double move = tolerance::hang_move * 0.5 * gravity * least * least;
    if (std::binary_search(hit_.begin(), hit_.end(), world.ids()[k]) ||
        !((place_w - stay.place_w).norm() <= move))
      stay = {.place_w = place_w, .since = time_};
    stay.in_place = time_ - stay.since >= least;
    due = due || (stay.in_place && time_ >= stay.look_at);
  }
  hit_.clear();
  if (due) look(world);
}

// All that stays in place now.
void HangCheck::look(const World& world) {
  find_held(world);
  for (std::size_t k = 0; k < stays_.size(); ++k) {
    Stay& stay = stays_[k];
    if (!stay.in_place) continue;
    const double stayed = time_ - stay.since;
    stay.look_at = time_ + stayed;
    if (held_[k] != 0) continue;
    status_ = StepStatus::held_by_nothing;
    find(world, world.name(static_cast<int>(k)) + " hangs in the air: it has not moved for " +
                    rounded_text(stayed, 3) + " s, and nothing that could hold it is near");
  }
}

// What is fixed or moves may hold what is near it, and that what is near again.
void HangCheck::find_held(const World& world) {
  bounds_.clear();
  held_.clear();
  for (std::size_t k = 0; k < stays_.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    const bool movable = body.movable();
    const double edge = movable ? tolerance::deep_overlap * body.size.minCoeff() : 0.0;
    bounds_.push_back(bounds_of(body, world.states()[k], edge));
    held_.push_back(movable && stays_[k].in_place ? 0 : 1);
  }
  near_.find_pairs(bounds_, pairs_);
  for (const BodyJoint& joint : world.joints())
    pairs_.push_back({world.index_of(joint.bodies[0]), world.index_of(joint.bodies[1])});
  bool again = true;
  const auto pass_on = [&](const IndexPair& pair) {
    char& first = held_[idx(pair.first)];
    char& second = held_[idx(pair.second)];
    again = again || first != second;
    first = second = first != 0 || second != 0 ? 1 : 0;
  };
  while (again) {  // to and fro: a stack takes one turn, whichever way it is numbered
    again = false;
    std::for_each(pairs_.begin(), pairs_.end(), pass_on);
    std::for_each(pairs_.rbegin(), pairs_.rend(), pass_on);
  }
}

}  // namespace tumble
