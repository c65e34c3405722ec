/// \file
/// \brief Stepping through a scene.
#include "tumble/record/scene_run.hpp"

#include "tumble/base/error.hpp"
#include "tumble/dynamics/energy.hpp"

#include <algorithm>
#include <utility>

namespace tumble {
namespace {

// The energy of those who come and go is not the technique's error.
template <class Change>
void change_bodies(World& world, MetricsMeter& meter, const Change& change) {
  const double before = energy_of(world).total();
  change();
  meter.allow(energy_of(world).total() - before);
}

}  // namespace

SceneRun::SceneRun(Scene scene, Technique& technique) : technique_(technique) {
  begin(checked(std::move(scene)));
}

// Nothing is changed if the scene is refused.
void SceneRun::begin(Scene scene) {
  world_ = build_world(scene);
  scene_ = std::move(scene);
  meter_ = MetricsMeter();
  metrics_ = meter_.begin(world_);
}

void SceneRun::settle() {
  if (!(world_.time() > settled_)) return;
  change_bodies(world_, meter_, [&] { come_and_go(scene_, settled_, world_.time(), world_); });
  before_ = settled_;
  settled_ = world_.time();
}

StepReport SceneRun::step(double dt) {
  settle();
  StepReport report = technique_.step(world_, dt);
  if (!all_finite(world_)) report.status = StepStatus::not_finite;
  metrics_ = meter_.measure(world_, report);
  return report;
}

std::string SceneRun::throw_in(SceneBox box) {
  Scene next = scene_;
  box.appears = world_.time();
  next.boxes.push_back(std::move(box));
  next = checked(std::move(next));
  std::string name = next.boxes.back().name;
  if (world_.steps() == 0) {
    begin(std::move(next));
    return name;
  }
  settle();  // a run of the scene lets in whoever was due at this time before it too
  change_bodies(world_, meter_, [&] { add_box(next.boxes.back(), world_); });
  scene_ = std::move(next);
  return name;
}

void SceneRun::take_away(std::string_view asked) {
  const std::string name(asked);  // it may be the world's own, which settle() moves
  settle();
  const auto box = std::find_if(scene_.boxes.begin(), scene_.boxes.end(),
                                [&](const SceneBox& b) { return b.name == name; });
  require::that(box != scene_.boxes.end() && world_.find(name),
                "there is no box called " + name + " to take away");
  if (world_.steps() == 0) {
    Scene next = scene_;
    next.boxes.erase(next.boxes.begin() + (box - scene_.boxes.begin()));
    begin(std::move(next));
    return;
  }
  // A run of the scene would not see it at all, and give its id to the next one.
  require::that(box->appears <= before_,
                name + " came in at this very time: step before it is taken away");
  box->disappears = world_.time();
  change_bodies(world_, meter_, [&] { world_.remove(*world_.find(name)); });
}

}  // namespace tumble
