/// \file
/// \brief The tolerance of the thesis's program, and its negative forces.
#include "tumble/lcp_solvers/as_printed/baraff_as_printed.hpp"
#include "tumble/lcp_solvers/baraff.hpp"
#include "tumble/lcp_solvers/tolerances.hpp"

#include "driver/experiment.hpp"
#include "lcp_solvers/redundant_contacts.hpp"

namespace tumble::chapters {
namespace {

// Stacks of one to four cubes, pushed about at random by up to a tenth of their weight.
LcpProblem random_stack(Random& random) {
  LcpProblem problem{.factors = stack_on_corners(1 + static_cast<int>(random.below(4)))};
  std::vector<Load> loads(problem.factors.bodies.size());
  for (Load& load : loads) {
    load.linear_w = random.in_cube(0.1 * kGravity) - Vec3(0.0, kGravity, 0.0);
    load.angular_w = random.in_cube(0.6 * kGravity);
  }
  problem.b = constant_part(problem.factors, loads);
  multiply_out(problem.factors, problem.A);
  return problem;
}

std::vector<LcpProblem> many(int count, LcpProblem (*make)(Random&)) {
  Random random(1);
  std::vector<LcpProblem> problems;
  for (int k = 0; k < count; ++k) problems.push_back(make(random));
  return problems;
}

// How the thesis's program ended with a tolerance.
struct Endings {
  std::array<double, 6> share{};  // by LcpStatus
  double pivots = 0.0;            // on average
  std::vector<bool> solved;
};

Endings endings(const std::vector<LcpProblem>& problems, double eps) {
  BaraffAsPrintedSolver solver({.eps = eps});
  LcpResult result;
  Endings all;
  for (const LcpProblem& problem : problems) {
    solver.solve(problem, result);
    const double one = 1.0 / static_cast<double>(problems.size());
    all.share[static_cast<std::size_t>(result.status)] += one;
    all.pivots += one * result.pivots;
    all.solved.push_back(result.status == LcpStatus::solved);
  }
  return all;
}

Table endings_table(const std::string& suffix, const std::vector<LcpProblem>& problems) {
  Table table{suffix,
              {{"eps", "m/s²", "tolerance; 1e-17 stands for 0"},
               {"solved", "-", "share of the problems that the loop ends"},
               {"infeasible", "-", "a force seems to grow for ever"},
               {"cap", "-", "not ended after 50 (n + 1) pivots"},
               {"singular", "-", "elimination meets a column of zeros"},
               {"pivots", "-", "on average"}}};
  for (const double eps : {0.0, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7,
                           1e-6, 1e-5, 1e-4, 1e-3}) {
    const Endings all = endings(problems, eps);
    const auto share = [&](LcpStatus s) { return all.share[static_cast<std::size_t>(s)]; };
    table.add(std::max(eps, 1e-17), share(LcpStatus::solved), share(LcpStatus::infeasible),
              share(LcpStatus::cap_reached), share(LcpStatus::singular), all.pivots);
  }
  return table;
}

Quantity saved_by_tolerance(const char* name, const std::vector<LcpProblem>& problems) {
  const Endings without = endings(problems, 0.0);
  const Endings with = endings(problems, tolerance::sinking);
  std::int64_t saved = 0;
  for (std::size_t i = 0; i < problems.size(); ++i)
    if (!without.solved[i] && with.solved[i]) ++saved;
  return share_of_trials(name, saved, static_cast<std::int64_t>(problems.size()));
}

// Corners that move as answers of a solver say: the acceleration is constant during a step,
// x = v dt + a dt²/2 exactly, and what is wrong with it is there for ever.
struct Corners {
  std::vector<double> gap;    // [m]
  std::vector<double> speed;  // [m/s]

  void move(const std::vector<double>& acceleration, double dt) {
    for (std::size_t i = 0; i < gap.size(); ++i) {
      gap[i] += dt * speed[i] + 0.5 * dt * dt * acceleration[i];
      speed[i] += dt * acceleration[i];
    }
  }
  [[nodiscard]] double depth() const { return std::max(0.0, -*std::ranges::min_element(gap)); }
};

// Cubes on corners whose loads move about slowly. Forces are worked out anew at every step, and nothing
// is repaired. Angles stay so small that A does not change, and loads do not depend on the motion. Where
// the solver does not come to an end, the library's stands in and is counted. Beside the answers as they are the
// corners follow the same with negative forces set to zero, which is all that the thesis's program does besides.
class Rest {
 public:
  Rest(LcpSolver& solver, int cubes, double weight)
      : solver_(solver), weight_(weight), loads_(idx(cubes)) {
    problem_.factors = stack_on_corners(cubes);
    multiply_out(problem_.factors, problem_.A);
    left.gap.assign(idx(4 * cubes), 0.0);
    left.speed = left.gap;
    zeroed = left;
  }

  // The load of each cube goes round its middle, 0.2 m from it and once in some ten seconds.
  void advance(double time, double dt) {
    for (std::size_t k = 0; k < loads_.size(); ++k) {
      const double angle = 2.0 * std::numbers::pi * time / (9.0 + static_cast<double>(k));
      const Vec3 place(0.2 * elementary::cos(angle), 0.0, 0.2 * elementary::sin(angle));
      loads_[k].linear_w = Vec3(0.0, -weight_, 0.0);
      loads_[k].angular_w = 6.0 * place.cross(Vec3(0.0, -weight_, 0.0));
    }
    problem_.b = constant_part(problem_.factors, loads_);
    solver_.solve(problem_, result_);
    const bool ended = result_.status == LcpStatus::solved;
    if (!ended) {
      unsolved += 1.0;
      baraff_.solve(problem_, result_);
    }
    const double sinking = -*std::ranges::min_element(result_.a);
    if (sinking > tolerance::sinking) wrong += 1.0;
    fastest_sinking = std::max(fastest_sinking, sinking);
    if (result_.status != LcpStatus::solved)
      throw std::runtime_error("a stack at rest: " + std::string(name_of(result_.status)));
    left.move(result_.a, dt);
    if (ended) {
      for (double& f : result_.f) f = std::max(f, 0.0);
      complete(problem_, result_);
    }
    zeroed.move(result_.a, dt);
  }

  Corners left;
  Corners zeroed;
  double unsolved = 0.0;         // steps
  double wrong = 0.0;            // steps whose answer counts as found, though a contact sinks
  double fastest_sinking = 0.0;  // [m/s²]

 private:
  LcpSolver& solver_;
  BaraffSolver baraff_;
  double weight_;  // [m/s²]
  std::vector<Load> loads_;
  LcpProblem problem_;
  LcpResult result_;
};

// The slope of depth against time, both logarithmic, over the last tenfold of time, in the stack whose
// negative forces are left; NaN without depth.
double exponent(const Table& table) {
  constexpr std::size_t column = 1;
  double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  const double end = table.rows.back()[0];
  for (const std::vector<double>& row : table.rows) {
    if (row[0] < 0.1 * end || !(row[column] > 0.0)) continue;
    const double x = elementary::log(row[0]);
    const double y = elementary::log(row[column]);
    n += 1.0;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  if (n < 3.0) return std::numeric_limits<double>::quiet_NaN();
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

Result measure_tolerance(const Parameters& settings) {
  const int count = settings.count("problems");
  const std::vector<LcpProblem> stacks = many(count, random_stack);
  const std::vector<LcpProblem> repeated = many(count, repeated_contacts);
  return {
      {endings_table("", stacks), endings_table("repeated", repeated)},
      {saved_by_tolerance("problems that the loop does not end with eps = 0 and ends with eps = "
                          "1e-5, over all problems",
                          stacks),
       saved_by_tolerance("the same, contacts anywhere and every third given twice", repeated)}};
}

const Registered claim_3_3_1a_tolerance_figure{
    {.name = "claim_3_3_1a_tolerance",
     .parameters = {whole("problems", 2000, 100, 100000, "random problems of each kind")},
     .quick = {"problems=300"},
     .experiment = measure_tolerance}};

// Depth of stacks under loads that go round, negative forces being set to zero, over that with them left: a second
// measurement of claim 3.3.1b.
double clamped_over_left(double duration, double dt) {
  double clamped = 0.0;
  double left = 0.0;
  for (const int cubes : {2, 4, 5, 6}) {
    BaraffAsPrintedSolver leave({.clamp = false});
    Rest run(leave, cubes, kGravity);
    const auto steps = static_cast<std::int64_t>(std::floor(duration / dt + 0.5));
    for (std::int64_t k = 0; k < steps; ++k) run.advance(static_cast<double>(k) * dt, dt);
    clamped += run.zeroed.depth();
    left += run.left.depth();
  }
  return clamped / left;
}

Result measure_negative_forces(const Parameters& settings) {
  const double duration = settings.number("duration");
  const int cubes = settings.count("cubes");
  constexpr double dt = 1.0 / 60.0;
  constexpr double light = 0.9 * tolerance::sinking;

  BaraffAsPrintedSolver leave({.clamp = false});
  BaraffSolver relative;
  Rest stack(leave, cubes, kGravity);
  Rest below(leave, 1, light);
  Rest below_relative(relative, 1, light);
  Rest stack_relative(relative, cubes, kGravity);
  const std::array<Rest*, 4> runs = {&stack, &below, &below_relative, &stack_relative};
  const std::array<const Corners*, 5> shown_corners = {&stack.left, &stack.zeroed, &below.left,
                                                       &below_relative.left, &stack_relative.left};

  Table table{"",
              {{"time_s", "s", "time"},
               {"left_m", "m", "stack, negative forces left: deepest corner"},
               {"zeroed_m", "m", "stack, negative forces set to 0"},
               {"light_m", "m", "one cube, its weight 0.9 of the tolerance"},
               {"light_relative_m", "m", "the same, tolerance relative to the load"},
               {"relative_m", "m", "stack, tolerance relative to the load"}}};
  double shown = 1.0;  // [s] the next moment of the table: a twentieth of a power of ten apart
  const auto steps = static_cast<std::int64_t>(std::floor(duration / dt + 0.5));
  for (std::int64_t k = 0; k < steps; ++k) {
    for (Rest* run : runs) run->advance(static_cast<double>(k) * dt, dt);
    const double time = static_cast<double>(k + 1) * dt;
    if (time < shown && k + 1 < steps) continue;
    std::array<double, 5> depths{};
    std::transform(shown_corners.begin(), shown_corners.end(), depths.begin(),
                   [](const Corners* corners) { return corners->depth(); });
    table.add(time, depths);
    while (shown <= time) shown *= 1.122;
  }

  return {{table},
          {{"exponent of the depth against time, negative forces being left", "-", exponent(table)},
           {"depth of stacks of 2, 4, 5 and 6 cubes with negative forces set to zero, over the "
            "same with them left",
            "-", clamped_over_left(settings.number("others"), dt)},
           {"depth at the end, negative forces left", "m", stack.left.depth()},
           {"P5: depth of a load below the tolerance, at the end", "m", below.left.depth()},
           {"P5: the same with a tolerance relative to the load", "m", below_relative.left.depth()},
           {"steps whose answer is wrong though the loop ends, stack", "-", stack.wrong},
           {"fastest sinking in these", "m/s²", stack.fastest_sinking},
           {"steps that the loop does not end, stack", "-",
            stack.unsolved / static_cast<double>(steps)}}};
}

const Registered claim_3_3_1b_negative_forces_figure{
    {.name = "claim_3_3_1b_negative_forces",
     .parameters = {number("duration", 600.0, 10.0, 36000.0, "s", "length of the runs"),
                    whole("cubes", 3, 1, 20, "in the stack"),
                    number("others", 600.0, 1.0, 36000.0, "s",
                           "length of the runs of stacks of 2, 4, 5 and 6 cubes")},
     .quick = {"duration=60", "others=5"},
     .experiment = measure_negative_forces}};

}  // namespace
}  // namespace tumble::chapters
