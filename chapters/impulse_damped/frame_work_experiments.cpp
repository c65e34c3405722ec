/// \file
/// \brief The work of a step of the clump and of the pyramid (thesis 6.1).
#include "impulse_damped/damped_variants.hpp"

namespace tumble::chapters {
namespace {

// Counts of a step under one technique.
struct StepWork {
  double tests = 0.0;       // pairs tested for contact, mean
  double most_tests = 0.0;  // in any step
  double impulses = 0.0;    // mean
};

StepWork step_work(const Scene& scene, const PlayedTechnique& technique, double duration) {
  PlayedScene played(scene, technique);
  StepWork work;
  double steps = 0.0;
  played.advance(duration, [&](const StepReport& report) {
    const auto tests = static_cast<double>(report.pair_tests);
    steps += 1.0;
    work.tests += tests;
    work.most_tests = std::max(work.most_tests, tests);
    work.impulses += static_cast<double>(report.impulses);
  });
  work.tests /= steps;
  work.impulses /= steps;
  return work;
}

void add_row(const Scene& scene, double duration, Table& table) {
  const StepWork damped = step_work(scene, {"damped"}, duration);
  const StepWork coulomb = step_work(scene, coulomb_technique(), duration);
  table.add(scene.boxes.size(), damped.tests, damped.most_tests, damped.impulses, coulomb.tests,
            coulomb.impulses);
}

Result measure_frame_work(const Parameters& settings) {
  const double duration = settings.number("duration");
  Table clumps{"",
               {{"boxes", "-", "that move"},
                {"tests", "-", "pairs tested for contact in a step, damped, mean"},
                {"tests_most", "-", "the same, most in any step"},
                {"impulses", "-", "impulses in a step, damped, mean"},
                {"tests_coulomb", "-", "pairs tested for contact in a step, contact_damped, mean"},
                {"impulses_coulomb", "-", "impulses in a step, contact_damped, mean"}}};
  Table pyramids{"pyramid", clumps.columns};
  for (int per_edge = 2; per_edge <= settings.count("per_edge"); ++per_edge)
    add_row(make_scene("fig6_7", {"per_edge=" + std::to_string(per_edge)}), duration, clumps);
  for (int rows = 4; rows <= settings.count("rows"); rows += 2)
    add_row(make_scene("pyramid", {"rows=" + std::to_string(rows)}), duration, pyramids);
  const std::vector<double>& clump = clumps.rows.back();
  return {{clumps, pyramids},
          {{"pairs that were tested for contact in a step of the clump of figure 6.7, on average",
            "-", clump[1]},
           {"pairs in all, the ground included", "-", 0.5 * clump[0] * (clump[0] + 1.0)},
           {"pairs that are tested in the worst step of the clump of figure 6.7, over those of a "
            "step on average",
            "-", clump[2] / clump[1]},
           {"impulses in a step of the clump, on average", "-", clump[3]},
           {"pairs tested in a step of the clump, on average, contact_damped", "-", clump[4]},
           {"impulses in a step of the clump, on average, contact_damped", "-", clump[5]}}};
}

const Registered claim_6_1a_frame_rate_figure{
    {.name = "claim_6_1a_frame_rate",
     .parameters = {whole("per_edge", 5, 2, 10, "cubes along each edge of the largest clump"),
                    whole("rows", 10, 4, 30, "of the largest pyramid"),
                    number("duration", 10.0, 0.1, 100.0, "s", "of each run")},
     .quick = {"per_edge=2", "rows=4", "duration=2"},
     .experiment = measure_frame_work}};

}  // namespace
}  // namespace tumble::chapters
