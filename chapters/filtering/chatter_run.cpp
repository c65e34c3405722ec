/// \file
/// \brief Measuring the chatter of a scene under any technique.
#include "filtering/chatter_run.hpp"

#include "tumble/record/overlap.hpp"

namespace tumble::chapters {
namespace {

// Sums over the bodies that rest in both; lists in the order of ids.
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
  const std::vector<BodyState> start(now.world().states().begin(), now.world().states().end());
  ChatterRun run;
  for (const BodyProperties& body : now.world().bodies())
    if (body.movable()) ++run.bodies;
  const auto first = std::lround(settling / kStep);
  const auto half_seconds = std::lround(watched / kStep) / (ChatterMeter::kWindow - 1);
  const auto last = first + half_seconds * (ChatterMeter::kWindow - 1);
  OverlapMeter near;
  ChatterMeter meter;
  const auto look = [&] {
    near.look(now.world().bodies(), now.world().states());
    meter.add(now.world(), near.in_contact());
  };
  for (run.steps = 0; run.steps < last;) {
    if (run.steps == first) look();
    const StepReport report = now.Simulation::step(kStep);
    now.settle();
    if (report.status >= StepStatus::unsolved) {
      run.solved = false;
      run.resting.clear();
      return run;
    }
    ++run.steps;
    if (report.status == StepStatus::event_cap) ++run.capped;  // shown in the table
    if (run.steps <= first) continue;
    run.last_collisions += report.events;
    look();
    if ((run.steps - first) % (ChatterMeter::kWindow - 1) != 0) continue;
    const std::vector<BodyChatter> each = meter.each(now.world().gravity_w.norm());
    run.resting =
        run.steps - first < ChatterMeter::kWindow ? each : resting_in_both(run.resting, each);
  }
  for (BodyChatter& body : run.resting) {
    body.amplitude /= static_cast<double>(half_seconds);
    body.acceleration /= static_cast<double>(half_seconds);
  }
  for (std::size_t k = 0; k < start.size(); ++k)
    run.displaced =
        std::max(run.displaced, (now.world().states()[k].position_w - start[k].position_w).norm());
  return run;
}

}  // namespace tumble::chapters
