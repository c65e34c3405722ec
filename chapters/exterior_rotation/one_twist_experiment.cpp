/// \file
/// \brief The column of figure 6.1, each body moved by one twist (claim 6.2d).
#include "exterior_rotation/cure_figures.hpp"
#include "exterior_rotation/cure_runs.hpp"
#include "exterior_rotation/falling_column.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace tumble::chapters {
namespace {

// Chosen before the first run: semi-implicit Euler; a gap is the distance along the normal at the held
// corners of a joint, apart or into each other, whichever is larger, over all joints, that at the
// larger box included, and over all steps. Edges are 1 m. The distance of corners in any direction is
// a quantity of its own.
constexpr std::array kSchemes = {GluedScheme::forward_euler, GluedScheme::semi_implicit,
                                 GluedScheme::impulse, GluedScheme::leapfrog};
constexpr std::array<const char*, kSchemes.size()> kNames = {"forward Euler", "semi-implicit Euler",
                                                             "impulses", "leapfrog"};
constexpr std::size_t kSemiImplicit = 1;
constexpr std::size_t kLeapfrog = 3;

GluedOptions options_of(GluedScheme scheme, PoseUpdate pose) {
  GluedOptions options;
  options.scheme = scheme;
  options.pose = pose;
  return options;
}

struct Way {
  std::vector<double> gaps;  // [m] after each step, from the start
  GluedRun run;
  double error = 0.0;  // [rad] of the angle at the end
};

Way fall(GluedScheme scheme, PoseUpdate pose, double angle, double dt, int steps) {
  Way way;
  way.gaps.push_back(0.0);
  way.run = run_glued(column_world(angle), options_of(scheme, pose), dt, steps,
                      [&](const World&, const JointGap& gap) {
                        way.gaps.push_back(std::max(gap.opening, gap.overlap));
                      });
  way.error = centre_angle(way.run.world) - column_angle(steps * dt, angle);
  return way;
}

// The distance of neighbouring numbers at the largest coordinate of the column.
double spacing(const World& world) {
  double largest = 0.0;
  for (std::size_t k = 0; k < world.states().size(); ++k)
    if (world.bodies()[k].movable())
      largest = std::max(largest, world.states()[k].position_w.cwiseAbs().maxCoeff());
  return std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
}

}  // namespace

Result measure_one_twist(const Parameters& settings) {
  const double angle = settings.number("angle");
  const double dt = 1.0 / settings.number("rate");
  const int steps = static_cast<int>(std::lround(settings.number("duration") / dt));
  std::array<Way, kSchemes.size()> separate;
  std::array<Way, kSchemes.size()> exponential;
  Table angles{
      "angles",
      {{"scheme", "-", "forward Euler, semi-implicit Euler, impulses, leapfrog"},
       {"separate_rad", "rad", "error of the column's angle, centre and orientation apart"},
       {"exponential_rad", "rad", "error of the column's angle, one twist for each body"}}};
  Result result;
  for (std::size_t k = 0; k < kSchemes.size(); ++k) {
    separate[k] = fall(kSchemes[k], PoseUpdate::separate, angle, dt, steps);
    exponential[k] = fall(kSchemes[k], PoseUpdate::exponential, angle, dt, steps);
    angles.rows.push_back({static_cast<double>(k + 1), separate[k].error, exponential[k].error});
  }

  const double rounding = spacing(column_world(angle));
  Table gaps{"",
             {{"time_s", "s", "since the column was released"},
              {"separate_m", "m", "gap, semi-implicit, centre and orientation apart"},
              {"exponential_m", "m", "gap, semi-implicit, one twist for each body"},
              {"leapfrog_separate_m", "m", "gap, leapfrog, centre and orientation apart"},
              {"leapfrog_exponential_m", "m", "gap, leapfrog, one twist for each body"},
              {"rounding_m", "m", "distance of neighbouring numbers at the column's coordinates"}}};
  for (std::size_t n = 0; n < separate[0].gaps.size(); ++n)
    gaps.rows.push_back({static_cast<double>(n) * dt, separate[kSemiImplicit].gaps[n],
                         exponential[kSemiImplicit].gaps[n], separate[kLeapfrog].gaps[n],
                         exponential[kLeapfrog].gaps[n], rounding});

  const Way& claim = exponential[kSemiImplicit];
  result.quantities = {
      {"largest gap or overlap of figure 6.1's column in a second of its fall at 60 steps a "
       "second, "
       "each body moved by the exponential of its own twist with the same forces, over an edge",
       "-", claim.run.gap},
      {"the same in any direction, not only along the normal", "m", claim.run.apart},
      {"largest gap or overlap, centre and orientation apart", "m",
       separate[kSemiImplicit].run.gap},
      {"distance of neighbouring numbers at the column's coordinates", "m", rounding}};
  for (std::size_t k = 0; k < kSchemes.size(); ++k) {
    const std::string name = std::string("error of the angle, ") + kNames[k];
    result.quantities.push_back({name + ", apart", "rad", separate[k].error});
    result.quantities.push_back({name + ", one twist", "rad", exponential[k].error});
  }
  result.tables = {std::move(gaps), std::move(angles)};
  return result;
}

}  // namespace tumble::chapters
