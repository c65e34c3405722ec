/// \file
/// \brief The loop of a run.
#include "tumble/record/run.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/dynamics/step_report.hpp"
#include "tumble/record/passage_check.hpp"
#include "tumble/record/run_checks.hpp"
#include "tumble/record/tolerances.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <stdexcept>

namespace tumble {
namespace {

constexpr double kMostStepsOfRun = 1e12;  // as many would run for years

// Passes on the events of the steps, with the world for the bodies' names.
class EventForwarder : public Observer {
 public:
  EventForwarder(const World& world, std::span<RunObserver* const> observers)
      : world_(world), observers_(observers) {}
  void on_event(const Event& event) override {
    for (RunObserver* observer : observers_) observer->on_event(world_, event);
  }

 private:
  const World& world_;
  std::span<RunObserver* const> observers_;
};

// Observes a simulation for as long as it lives.
class Observation {
 public:
  Observation(Simulation& simulation, Observer& observer)
      : simulation_(simulation), observer_(observer) {
    simulation_.observe(observer_);
  }
  ~Observation() { simulation_.stop_observing(observer_); }
  Observation(const Observation&) = delete;
  Observation& operator=(const Observation&) = delete;

 private:
  Simulation& simulation_;
  Observer& observer_;
};

// All checks of a run.
class RunChecks {
 public:
  explicit RunChecks(Simulation& simulation)
      : observed_{Observation(simulation, appear_),  Observation(simulation, energy_),
                  Observation(simulation, passage_), Observation(simulation, hang_),
                  Observation(simulation, hit_),     Observation(simulation, turn_)} {}

  [[nodiscard]] StepStatus status() const {
    return std::max(
        {appear_.status(), energy_.status(), passage_.status(), hang_.status(), hit_.status()});
  }
  void on_overlap(const World& world, double deepest) { passage_.on_overlap(world, deepest); }
  // After the last step; with nothing left in anything no pair needs to be looked at.
  StepStatus end(const World& world, double deepest_overlap) {
    if (!(deepest_overlap <= 0.0)) passage_.at_end(world);
    return status();
  }

  // Passes on each check's finding, once.
  void pass_on(std::span<RunObserver* const> observers, RunResult& result) {
    for (const RunCheck*& check : unheard_) {
      if (check == nullptr || check->message().empty()) continue;
      result.findings.push_back(check->message());
      for (RunObserver* observer : observers) observer->on_finding(check->message());
      check = nullptr;
    }
  }

 private:
  AppearCheck appear_;
  EnergyCheck energy_;
  PassageCheck passage_;
  HangCheck hang_;
  HitCheck hit_;
  TurnCheck turn_;
  std::array<const RunCheck*, 6> unheard_{&appear_, &energy_, &passage_, &hang_, &hit_, &turn_};
  std::array<Observation, 6> observed_;
};

// Whole steps in the duration; a remainder of next to nothing is rounding.
std::int64_t whole_steps(const RunSettings& settings) {
  return static_cast<std::int64_t>(
      std::floor(settings.duration / settings.dt + tolerance::step_remainder));
}

void add_up(const StepReport& step, StepReport& total, StepReport& worst) {
  add_report(step, total);
  for (const ReportCount& count : kReportCounts)
    worst.*count.member = std::max(worst.*count.member, step.*count.member);
  worst.deepest_overlap = total.deepest_overlap;
  worst.status = std::max(worst.status, step.status);
}

void keep_farther(double now, double& worst) {
  if (std::abs(now) > std::abs(worst)) worst = now;
}

void keep_longer(const Vec3& now, Vec3& worst) {
  if (now.squaredNorm() > worst.squaredNorm()) worst = now;
}

void keep_worst(const Metrics& now, Metrics& worst) {
  keep_farther(now.kinetic, worst.kinetic);
  keep_farther(now.potential, worst.potential);
  keep_farther(now.booked.restitution, worst.booked.restitution);
  keep_farther(now.booked.friction, worst.booked.friction);
  keep_farther(now.booked.damping, worst.booked.damping);
  keep_farther(now.booked.repair, worst.booked.repair);
  keep_farther(now.energy_error, worst.energy_error);
  keep_farther(now.energy_error_share, worst.energy_error_share);
  keep_longer(now.momentum_w, worst.momentum_w);
  keep_longer(now.angular_momentum_w, worst.angular_momentum_w);
  keep_farther(now.deepest_overlap, worst.deepest_overlap);
  keep_farther(now.chatter.amplitude, worst.chatter.amplitude);
  keep_farther(now.chatter.acceleration, worst.chatter.acceleration);
  worst.chatter.bodies = std::max(worst.chatter.bodies, now.chatter.bodies);
  keep_farther(now.fastest, worst.fastest);
  worst.asleep = std::max(worst.asleep, now.asleep);
}

// Simulates a step. Returns the message of one that broke off, or that was refused after the first; if the first
// is refused, nothing has been simulated, and the caller gets the exception.
std::string try_step(Simulation& simulation, double dt, StepReport& report) {
  const bool first = simulation.world().steps() == 0;
  try {
    report = simulation.step(dt);
  } catch (const std::invalid_argument& error) {
    if (first) throw;
    return error.what();
  } catch (const StepFault& fault) {
    return fault.what();
  }
  return {};
}

}  // namespace

void require_run_settings(const RunSettings& settings) {
  require_time_step(settings.dt);
  require::not_negative(settings.duration, "duration");
  require::that(settings.every >= 1,
                "every = " + std::to_string(settings.every) + ": expected 1 or more");
  require::that(settings.duration / settings.dt < kMostStepsOfRun,
                "duration / dt = " + shortest_text(settings.duration / settings.dt) +
                    ": expected fewer than 1e12 steps");
}

RunResult run_simulation(Simulation& simulation, const RunSettings& settings,
                         std::span<RunObserver* const> observers,
                         const std::function<bool()>& stop) {
  assert(simulation.world().steps() == 0);
  const World& world = simulation.world();
  MetricsMeter meter;
  const Observation measured(simulation, meter);
  RunChecks checks(simulation);
  EventForwarder events(world, observers);
  const Observation forwarded(simulation, events);
  RunResult result{.last = meter.metrics()};
  keep_worst(result.last, result.worst_metrics);
  for (RunObserver* observer : observers) observer->on_begin(world);

  const std::int64_t whole = whole_steps(settings);
  const double rest = settings.duration - static_cast<double>(whole) * settings.dt;
  const std::int64_t steps = whole + (rest > tolerance::step_remainder * settings.dt ? 1 : 0);
  for (std::int64_t k = 0; k < steps; ++k) {
    if (stop && stop()) {
      result.end = RunEnd::interrupted;
      break;
    }
    StepReport report;
    result.refusal = try_step(simulation, k < whole ? settings.dt : rest, report);
    if (!result.refusal.empty()) {
      result.end = RunEnd::failed;
      result.worst_report.status = std::max(result.worst_report.status, StepStatus::unsolved);
      break;
    }
    ++result.steps;
    if (report.status == StepStatus::event_cap) ++result.capped_steps;
    checks.on_overlap(world, meter.metrics().deepest_overlap);
    report.status = std::max(report.status, checks.status());
    checks.pass_on(observers, result);
    add_up(report, result.totals, result.worst_report);
    result.last_report = report;
    result.last = meter.metrics();
    keep_worst(result.last, result.worst_metrics);
    for (RunObserver* observer : observers)
      observer->on_step(world, simulation.technique(), report, result.last);
    if (report.status >= StepStatus::unsolved) {
      result.end = RunEnd::failed;
      break;
    }
  }
  if (result.end == RunEnd::complete) {
    result.worst_report.status =
        std::max(result.worst_report.status, checks.end(world, result.last.deepest_overlap));
    checks.pass_on(observers, result);
  }
  result.worst = result.worst_report.status;
  result.time = world.time();
  result.state_hash = world.hash().text();
  return result;
}

RunResult run_scene(const Scene& scene, Technique& technique, const RunSettings& settings,
                    std::span<RunObserver* const> observers, const std::function<bool()>& stop) {
  require_run_settings(settings);
  Simulation simulation(scene, technique);
  return run_simulation(simulation, settings, observers, stop);
}

std::string_view name_of(StepStatus status) {
  switch (status) {
    case StepStatus::done: return "done";
    case StepStatus::event_cap: return "event_cap";
    case StepStatus::energy_gained: return "energy_gained";
    case StepStatus::passed_through: return "passed_through";
    case StepStatus::held_by_nothing: return "held_by_nothing";
    case StepStatus::unsolved: return "unsolved";
    case StepStatus::not_finite: return "not_finite";
  }
  return "unknown";
}

std::string_view name_of(RunEnd end) {
  switch (end) {
    case RunEnd::complete: return "complete";
    case RunEnd::interrupted: return "interrupted";
    case RunEnd::failed: return "failed";
  }
  return "unknown";
}

}  // namespace tumble
