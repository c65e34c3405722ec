/// \file
/// \brief Measuring the chatter of a scene under any technique.
#include "filtering/chatter_run.hpp"

#include "tumble/base/tolerance.hpp"
#include "tumble/impulse_damped/pair_gatherer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tumble::chapters {
namespace {

// Sees who touches and hands it to the meter.
class Watch {
 public:
  // [m] up to this distance bodies touch
  explicit Watch(double reach) : reach_(reach) {}

  void look(const World& world) {
    near_.gather(world, world.states(), world.states(), nullptr, reach_, contacts_);
    touching_.assign(world.bodies().size(), 0);
    for (const Contact& contact : contacts_)
      for (const int body : {contact.first, contact.second})
        touching_[static_cast<std::size_t>(body)] = 1;
    meter_.add(world, touching_);
  }
  [[nodiscard]] std::vector<BodyChatter> each(const World& world) const {
    return meter_.each(world.gravity_w.norm());
  }

 private:
  double reach_;
  PairGatherer near_{NormalRule::separation, PointRule::one};
  ContactList contacts_;
  std::vector<char> touching_;
  ChatterMeter meter_;
};

// Sums of those who rest in both; lists in the order of ids.
std::vector<BodyChatter> resting_in_both(const std::vector<BodyChatter>& sums,
                                         const std::vector<BodyChatter>& more) {
  std::vector<BodyChatter> both;
  for (BodyChatter body : sums)
    for (const BodyChatter& other : more)
      if (other.id == body.id) {
        body.amplitude += other.amplitude;
        body.acceleration += other.acceleration;
        both.push_back(body);
      }
  return both;
}

double shortest_edge(const World& world) {
  double edge = std::numeric_limits<double>::infinity();
  for (const BodyProperties& body : world.bodies())
    if (body.movable()) edge = std::min(edge, body.size.minCoeff());
  return edge;
}

double largest(const std::vector<BodyChatter>& bodies, double BodyChatter::*measure) {
  if (bodies.empty()) return std::numeric_limits<double>::quiet_NaN();
  double most = 0.0;
  for (const BodyChatter& body : bodies) most = std::max(most, body.*measure);
  return most;
}

}  // namespace

double ChatterRun::amplitude() const { return largest(resting, &BodyChatter::amplitude); }
double ChatterRun::acceleration() const { return largest(resting, &BodyChatter::acceleration); }

ChatterRun chatter_of(const Scene& scene, const PlayedTechnique& played, double settling,
                      double watched, std::uint64_t seed) {
  PlayedScene now(scene, played, seed);
  const std::vector<BodyState> start(now.world.states().begin(), now.world.states().end());
  ChatterRun run;
  for (const BodyProperties& body : now.world.bodies())
    if (body.movable()) ++run.bodies;
  const auto first = std::lround(settling / PlayedScene::kStep);
  const auto half_seconds = std::lround(watched / PlayedScene::kStep) / (ChatterMeter::kWindow - 1);
  const auto last = first + half_seconds * (ChatterMeter::kWindow - 1);
  Watch watch(tolerance::touching * shortest_edge(now.world));
  try {
    for (run.steps = 0; run.steps < last;) {
      if (run.steps == first) watch.look(now.world);
      const StepReport report = now.step();
      ++run.steps;
      run.collisions += report.events;
      if (report.status == StepStatus::event_cap) ++run.capped;
      if (run.steps <= first) continue;
      run.last_collisions += report.events;
      watch.look(now.world);
      if ((run.steps - first) % (ChatterMeter::kWindow - 1) != 0) continue;
      const std::vector<BodyChatter> each = watch.each(now.world);
      run.resting =
          run.steps - first < ChatterMeter::kWindow ? each : resting_in_both(run.resting, each);
    }
  } catch (const std::runtime_error&) {
    run.solved = false;
    run.resting.clear();
    return run;
  }
  for (BodyChatter& body : run.resting) {
    body.amplitude /= static_cast<double>(half_seconds);
    body.acceleration /= static_cast<double>(half_seconds);
  }
  for (std::size_t k = 0; k < start.size(); ++k)
    run.displaced =
        std::max(run.displaced, (now.world.states()[k].position_w - start[k].position_w).norm());
  return run;
}

}  // namespace tumble::chapters
