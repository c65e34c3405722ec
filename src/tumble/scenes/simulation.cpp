/// \file
/// \brief Stepping through a scene.
#include "tumble/scenes/simulation.hpp"

#include "tumble/base/error.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/dynamics/step_mistakes.hpp"

#include <algorithm>
#include <utility>

namespace tumble {
namespace {

// Forwards the collisions of a step to the observers; without observers the technique is left as it is.
class EventsOfStep : public Observer {
 public:
  EventsOfStep(std::span<Observer* const> observers, Technique& technique)
      : observers_(observers), technique_(technique) {
    if (!observers_.empty()) technique_.observe(this);
  }
  ~EventsOfStep() override {
    if (!observers_.empty()) technique_.observe(nullptr);
  }
  EventsOfStep(const EventsOfStep&) = delete;
  EventsOfStep& operator=(const EventsOfStep&) = delete;
  void on_event(const Event& event) override {
    for (Observer* observer : observers_) observer->on_event(event);
  }

 private:
  std::span<Observer* const> observers_;
  Technique& technique_;
};

// An std::invalid_argument that is no refusal comes from a check inside the step, so it is not the caller's mistake.
StepReport checked_step(Technique& technique, World& world, double dt) {
  try {
    return technique.step(world, dt);
  } catch (const StepRefused&) {
    throw;
  } catch (const std::invalid_argument& fault) {
    throw StepFault(fault.what());
  }
}

// Removes the wishes about a box.
void leave_out(const std::string& name, std::vector<Wish>& wishes) {
  for (Wish& wish : wishes) std::erase(wish.bodies, name);
  std::erase_if(wishes, [](const Wish& wish) { return wish.bodies.empty(); });
}

}  // namespace

Simulation::Simulation(Scene scene, std::unique_ptr<Technique> technique)
    : owned_(std::move(technique)), technique_(owned_.get()) {
  require::that(technique_ != nullptr, "technique is null: expected one");
  begin(std::move(scene));
}

Simulation::Simulation(Scene scene, std::string_view technique,
                       const std::vector<std::string>& settings, std::uint64_t seed)
    : Simulation(std::move(scene), make_technique(technique, settings, seed)) {}

Simulation::Simulation(Scene scene, Technique& technique) : technique_(&technique) {
  begin(std::move(scene));
}

// Nothing is changed if the scene is refused.
void Simulation::begin(Scene scene) {
  world_ = start_world(scene);
  scene_ = std::move(scene);
  for (Observer* observer : observers_) observer->on_begin(world_);
}

void Simulation::observe(Observer& observer) {
  observers_.push_back(&observer);
  observer.on_begin(world_);
}

void Simulation::stop_observing(const Observer& observer) {
  observers_.erase(std::remove(observers_.begin(), observers_.end(), &observer), observers_.end());
}

// The energy of boxes that are added and removed is reported apart: the technique is not to blame for it.
template <class Change>
void Simulation::change_bodies(const Change& change) {
  const double before = energy_of(world_).total();
  change();
  const double added = energy_of(world_).total() - before;
  for (Observer* observer : observers_) observer->on_change(world_, added);
}

void Simulation::update_boxes() {
  const double until = due_until(world_.time(), last_dt_);
  if (!(until > updated_)) return;
  const auto due = [&](double time) { return time > updated_ && time <= until; };
  if (std::any_of(scene_.boxes.begin(), scene_.boxes.end(),
                  [&](const SceneBox& box) { return due(box.appears) || due(box.disappears); }))
    change_bodies([&] { tumble::update_boxes(scene_, updated_, until, world_); });
  earlier_ = updated_;
  updated_ = until;
}

void require_time_step(double dt) { require_step_limits(dt, 0.0); }

StepReport Simulation::step(double dt) {
  require_step_limits(dt, world_.time());
  require_joints_held(*technique_, world_);
  update_boxes();
  StepReport report;
  const double begin = world_.time();
  {
    const EventsOfStep events(observers_, *technique_);
    report = checked_step(*technique_, world_, dt);
  }
  last_dt_ = world_.time() - begin;
  if (!all_finite(world_)) report.status = StepStatus::not_finite;
  for (Observer* observer : observers_) observer->on_step(world_, report);
  return report;
}

StepStatus Simulation::run_for(double seconds, double dt) {
  require::not_negative(seconds, "seconds");
  require_time_step(dt);
  const double end = world_.time() + seconds;
  StepStatus worst = StepStatus::done;
  while (world_.time() < end - 0.5 * dt && worst < StepStatus::unsolved)
    worst = std::max(worst, step(dt).status);
  return worst;
}

std::string Simulation::throw_in(SceneBox box) {
  Scene next = scene_;
  box.appears = world_.time();
  next.boxes.push_back(std::move(box));
  if (world_.steps() == 0) {
    begin(std::move(next));
    return scene_.boxes.back().name;
  }
  next = checked(std::move(next));
  update_boxes();  // as in a run of the scene, boxes that are due at this time come first
  change_bodies([&] { add_box(next.boxes.back(), world_); });
  scene_ = std::move(next);
  return scene_.boxes.back().name;
}

void Simulation::take_away(std::string_view asked) {
  const std::string name(asked);  // it may be the world's own, which update_boxes() moves
  update_boxes();
  const auto box = std::find_if(scene_.boxes.begin(), scene_.boxes.end(),
                                [&](const SceneBox& b) { return b.name == name; });
  require::that(box != scene_.boxes.end() && world_.find(name),
                "there is no box called " + name + " to take away");
  if (world_.steps() == 0) {
    Scene next = scene_;
    next.boxes.erase(next.boxes.begin() + (box - scene_.boxes.begin()));
    leave_out(name, next.wishes);
    std::erase_if(next.joints,
                  [&](const SceneJoint& j) { return j.first == name || j.second == name; });
    begin(std::move(next));
    return;
  }
  // In a run of the scene it would never be there, and the next box would have its id.
  require::that(box->appears <= earlier_,
                name + " came in at this very time: step before it is taken away");
  box->disappears = world_.time();
  change_bodies([&] { world_.remove(*world_.find(name)); });
}

}  // namespace tumble
