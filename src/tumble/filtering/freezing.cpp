/// \file
/// \brief Sleep for islands that only chatter.
#include "tumble/filtering/freezing.hpp"

#include "tumble/contact/tolerances.hpp"

#include <algorithm>
#include <utility>

namespace tumble {
namespace {

// Makes bodies count as slow, and undoes that however the step ends.
class CountedAsSlow {
 public:
  CountedAsSlow(Technique& technique, std::span<const char> bodies) : technique_(technique) {
    technique.count_as_slow(bodies);
  }
  CountedAsSlow(const CountedAsSlow&) = delete;
  CountedAsSlow& operator=(const CountedAsSlow&) = delete;
  ~CountedAsSlow() { technique_.count_as_slow({}); }

 private:
  Technique& technique_;
};

}  // namespace

CalmBodies::CalmBodies(const ChatterDetectorOptions& options) : detector_(options) {}

// [S6.3.1:calm]
void CalmBodies::add(const World& world, std::span<const char> in_contact) {
  detector_.add(world, in_contact);
  next_.clear();
  auto known = anchors_.begin();  // sorted by id, as the world's bodies are
  for (std::size_t k = 0; k < world.ids().size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable()) continue;
    const BodyId id = world.ids()[k];
    const Placement place = placement_of(body, world.states()[k]);
    while (known != anchors_.end() && known->id < id) ++known;
    const bool stays =
        known != anchors_.end() && known->id == id &&
        (place - known->place).norm() <= tolerance::resting_movement * body.size.minCoeff();
    if (stays) {
      next_.push_back(*known);
    } else if (detector_.motion(id) != Motion::moves) {
      next_.push_back({id, place});
    }
  }
  anchors_.swap(next_);
}
// [S6.3.1:calm]

bool CalmBodies::calm(BodyId id) const {
  const auto found = std::lower_bound(anchors_.begin(), anchors_.end(), id,
                                      [](const Anchor& anchor, BodyId b) { return anchor.id < b; });
  return found != anchors_.end() && found->id == id;
}

FreezeOnChatter::FreezeOnChatter(std::unique_ptr<Technique> technique,
                                 const ChatterDetectorOptions& options)
    : Cloned(std::move(technique)), calm_(options) {}

StepReport FreezeOnChatter::step(World& world, double dt) {
  if (world.time() < last_time_) calm_ = CalmBodies(calm_.detector().options());
  const StepReport report = [&] {
    slow_.clear();
    for (const BodyId id : world.ids()) slow_.push_back(calm_.calm(id) ? 1 : 0);
    Technique& technique = prepared_inner();
    const CountedAsSlow counted(technique, slow_);
    return technique.step(world, dt);
  }();
  mark_contacts(world, contacts(), in_contact_);
  calm_.add(world, in_contact_);
  last_time_ = world.time();
  return report;
}

}  // namespace tumble
