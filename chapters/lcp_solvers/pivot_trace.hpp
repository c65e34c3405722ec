/// \file
/// \brief The steps of Baraff's algorithm (thesis 3.3.1).
#pragma once

#include "tumble/lcp_solvers/as_printed/baraff_as_printed.hpp"

#include <vector>

namespace tumble::chapters {

// How a step of Baraff's algorithm ends.
enum class StepEnd : std::uint8_t {
  rests,   // the driven contact has stopped to sink: it goes to C
  stops,   // a force of C is used up: its contact goes to NC
  returns  // a contact of NC would begin to sink: it goes to C
};

// One step, copied.
struct TracedStep {
  int driven = 0;                 // the contact whose force grew
  int ended_by = 0;               // the contact that ended the step
  StepEnd end = StepEnd::rests;   // how
  std::vector<BaraffSet> during;  // (n) the sets while it grew
  std::vector<double> f;          // [N] (n) after the step
  std::vector<double> a;          // [m/s²] (n) after the step
};

class Recorder : public BaraffObserver {
 public:
  explicit Recorder(int size) : sets_(static_cast<std::size_t>(size), BaraffSet::none) {}

  void on_step(const BaraffStep& step) override {
    const auto mover = static_cast<std::size_t>(step.ended_by);
    TracedStep traced{.driven = step.driven, .ended_by = step.ended_by};
    traced.end = step.ended_by == step.driven        ? StepEnd::rests
                 : step.sets[mover] == BaraffSet::NC ? StepEnd::stops
                                                     : StepEnd::returns;
    traced.during = sets_;
    traced.f.assign(step.f.begin(), step.f.end());
    traced.a.assign(step.a.begin(), step.a.end());
    steps.push_back(traced);
    sets_.assign(step.sets.begin(), step.sets.end());
  }

  std::vector<TracedStep> steps;

 private:
  std::vector<BaraffSet> sets_;  // before the next step
};

// Runs the algorithm as the thesis describes it and keeps every step.
inline std::vector<TracedStep> trace_baraff(const LcpProblem& problem, LcpResult& result) {
  Recorder recorder(problem.size());
  BaraffAsPrintedSolver solver;
  solver.observe(&recorder);
  solver.solve(problem, result);
  return recorder.steps;
}

}  // namespace tumble::chapters
