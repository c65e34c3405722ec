/// \file
/// \brief The column of figure 6.1, each body moved by one twist (claim 6.2d).
#include "exterior_rotation/column_runs.hpp"
#include "exterior_rotation/glued_runs.hpp"

namespace tumble::chapters {
namespace {

// Chosen before the first run: semi-implicit Euler; a gap is the distance along the normal at the held
// corners of a joint, apart or into each other, whichever is larger, over all joints, that at the
// larger box included, and over all steps. Edges are 1 m. The distance of corners in any direction is
// a quantity of its own.
constexpr std::array<std::size_t, 4> kSchemes = {0, 1, 2, 4};  // of separate_schemes()

struct TwistRun {
  std::vector<double> gaps;  // [m] after each step, from the start
  GluedRun run;
  double error = 0.0;  // [rad] of the angle at the end
};

TwistRun twist_run(GluedScheme scheme, PoseUpdate pose, double angle, double dt, int steps) {
  TwistRun found;
  found.gaps.push_back(0.0);
  found.run = run_glued(column_world(angle), glued_options(scheme, pose), dt, steps,
                        [&](const World&, const JointGap& gap) {
                          found.gaps.push_back(std::max(gap.opening, gap.overlap));
                        });
  found.error = centre_angle(found.run.world) - column_angle(steps * dt, angle);
  return found;
}

// The distance of neighbouring numbers at the largest coordinate of the column.
double spacing_of_numbers(const World& world) {
  double largest = 0.0;
  for (std::size_t k = 0; k < world.states().size(); ++k)
    if (world.bodies()[k].movable())
      largest = std::max(largest, world.states()[k].position_w.cwiseAbs().maxCoeff());
  return std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
}

Result measure_one_twist(const Parameters& settings) {
  const double angle = settings.number("angle");
  const double dt = 1.0 / settings.number("rate");
  const int steps = static_cast<int>(std::lround(settings.number("duration") / dt));
  std::array<TwistRun, kSchemes.size()> separate;
  std::array<TwistRun, kSchemes.size()> exponential;
  Table angles{
      "angles",
      {{"scheme", "-", "forward Euler, semi-implicit Euler, impulses, leapfrog"},
       {"separate_rad", "rad", "error of the column's angle, centre and orientation apart"},
       {"exponential_rad", "rad", "error of the column's angle, one twist for each body"}}};
  Result result;
  for (std::size_t k = 0; k < kSchemes.size(); ++k) {
    const GluedScheme scheme = separate_schemes()[kSchemes[k]].scheme;
    separate[k] = twist_run(scheme, PoseUpdate::separate, angle, dt, steps);
    exponential[k] = twist_run(scheme, PoseUpdate::exponential, angle, dt, steps);
    angles.add(k + 1, separate[k].error, exponential[k].error);
  }

  const double rounding = spacing_of_numbers(column_world(angle));
  Table gaps{"",
             {{"time_s", "s", "since the column was released"},
              {"separate_m", "m", "gap, semi-implicit, centre and orientation apart"},
              {"exponential_m", "m", "gap, semi-implicit, one twist for each body"},
              {"leapfrog_separate_m", "m", "gap, leapfrog, centre and orientation apart"},
              {"leapfrog_exponential_m", "m", "gap, leapfrog, one twist for each body"},
              {"rounding_m", "m", "distance of neighbouring numbers at the column's coordinates"}}};
  for (std::size_t n = 0; n < separate[0].gaps.size(); ++n)
    gaps.add(static_cast<double>(n) * dt, separate[1].gaps[n], exponential[1].gaps[n],
             separate[3].gaps[n], exponential[3].gaps[n], rounding);

  const TwistRun& claim = exponential[1];
  result.quantities = {
      {"largest gap or overlap of figure 6.1's column in a second of its fall at 60 steps a "
       "second, "
       "each body moved by the exponential of its own twist with the same forces, over an edge",
       "-", claim.run.gap},
      {"the same in any direction, not only along the normal", "m", claim.run.apart},
      {"largest gap or overlap, centre and orientation apart", "m", separate[1].run.gap}};
  for (std::size_t k = 0; k < kSchemes.size(); ++k) {
    const std::string name = "error of the angle, " + separate_schemes()[kSchemes[k]].words;
    result.add(name + ", apart", "rad", separate[k].error);
    result.add(name + ", one twist", "rad", exponential[k].error);
  }
  result.tables = {gaps, angles};
  return result;
}

const Registered claim_6_2d_one_twist_figure{
    {.name = "claim_6_2d_one_twist",
     .parameters = {number("angle", 0.3, 0.01, 1.0, "rad", "of the column's centre at the start"),
                    number("rate", 60.0, 5.0, 1e4, "1/s", "steps a second"),
                    number("duration", 1.0, 0.1, 1.5, "s", "of the fall")},
     .experiment = measure_one_twist}};

}  // namespace
}  // namespace tumble::chapters
