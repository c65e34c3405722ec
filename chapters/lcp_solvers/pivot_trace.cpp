/// \file
/// \brief The steps of Baraff's algorithm (thesis 3.3.1).
#include "lcp_solvers/pivot_trace.hpp"

namespace tumble::chapters {
namespace {

class Recorder : public BaraffObserver {
 public:
  explicit Recorder(int size) : sets_(static_cast<std::size_t>(size), BaraffSet::none) {}

  void on_step(const BaraffStep& step) override {
    const auto mover = static_cast<std::size_t>(step.ended_by);
    TracedStep traced;
    traced.driven = step.driven;
    traced.ended_by = step.ended_by;
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

}  // namespace

std::vector<TracedStep> trace_baraff(const LcpProblem& problem, LcpResult& result) {
  Recorder recorder(problem.size());
  BaraffAsPrintedSolver solver;
  solver.observe(&recorder);
  solver.solve(problem, result);
  return recorder.steps;
}

}  // namespace tumble::chapters
