/// \file
/// \brief The order of a fall before openings of joints and across them, and of the moment of an opening.
#include "driver/experiment.hpp"
#include "exterior_rotation/falling_column.hpp"
#include "exterior_rotation/held_run.hpp"
#include "exterior_rotation/unilateral_run.hpp"

namespace tumble::chapters {
namespace {

constexpr double kReferenceAccuracy = 1e-13;  // [-] accuracy of the reference
constexpr double kRounding = 3e-12;           // [m], [s] smaller errors are not fitted

// A scheme with openings located, or noticed at the end of a step.
struct EventWay {
  std::string column;
  GluedScheme scheme;
  GluedEvents events;
};

const std::vector<EventWay>& ways() {
  static const std::vector<EventWay> list = {
      {"rk4_located", GluedScheme::rk4, GluedEvents::located},
      {"rk4_step_end", GluedScheme::rk4, GluedEvents::step_end},
      {"midpoint_located", GluedScheme::midpoint, GluedEvents::located},
      {"midpoint_step_end", GluedScheme::midpoint, GluedEvents::step_end},
      {"semi_implicit_located", GluedScheme::semi_implicit, GluedEvents::located},
      {"semi_implicit_step_end", GluedScheme::semi_implicit, GluedEvents::step_end}};
  return list;
}
constexpr std::size_t kLocated = 0;  // places of rk4
constexpr std::size_t kStepEnd = 1;

// Errors of all ways at one length of step.
struct Errors {
  double dt = 0.0;
  std::vector<double> pose;      // [m]
  std::vector<double> lateness;  // [s] of the first opening; NaN if there is none
};

// An end of the fall.
struct End {
  double time = 0.0;
  UnilateralRun reference;
  std::vector<Errors> errors;
};

std::vector<int> step_counts(const Parameters& settings) {
  std::vector<int> counts;
  const int fewest = settings.count("fewest");
  const int per_doubling = settings.count("per_doubling");
  for (int n = 0;; ++n) {
    const double count = fewest * std::pow(2.0, static_cast<double>(n) / per_doubling);
    if (count > settings.count("most") + 0.5) return counts;
    counts.push_back(static_cast<int>(std::lround(count)));
  }
}

double lateness(const UnilateralRun& run, const UnilateralRun& reference) {
  if (run.events.empty() || reference.events.empty()) return std::nan("");
  return run.events.front().time - reference.events.front().time;
}

End measure(const std::string& name, const Parameters& settings) {
  End end{settings.number(name), {}, {}};
  const World start = column_world(settings.number("angle"));
  end.reference = run_unilateral(
      start, unilateral(GluedScheme::dormand_prince, GluedEvents::located, kReferenceAccuracy),
      end.time, 100);
  for (const int steps : step_counts(settings)) {
    Errors errors{end.time / steps, {}, {}};
    for (const EventWay& way : ways()) {
      const UnilateralRun run =
          run_unilateral(start, unilateral(way.scheme, way.events), end.time, steps);
      errors.pose.push_back(farthest_corner(run.world, end.reference.world));
      errors.lateness.push_back(lateness(run, end.reference));
    }
    end.errors.push_back(errors);
  }
  return end;
}

// Slopes of errors against something, without what rounding is part of.
double order_of(const End& end, std::size_t way, double (*x)(const Errors&, std::size_t),
                double (*y)(const Errors&, std::size_t)) {
  std::vector<double> xs;
  std::vector<double> ys;
  for (const Errors& errors : end.errors) {
    if (!(y(errors, way) > kRounding) || !(x(errors, way) > kRounding)) continue;
    xs.push_back(x(errors, way));
    ys.push_back(y(errors, way));
  }
  return fitted_order(xs, ys);
}

double step_of(const Errors& errors, std::size_t) { return errors.dt; }
double pose_of(const Errors& errors, std::size_t way) { return errors.pose[way]; }
double moment_of(const Errors& errors, std::size_t way) { return std::abs(errors.lateness[way]); }

// By how much accelerations jump as a joint changes: of the centre that jumps most.
double jump_at(const UnilateralRun& run, std::size_t event) {
  const World& world = run.events[event].after.world;
  // The hold before: that after the last change of this joint, or its whole area.
  std::vector<Joint> joints = run.events[event].after.joints;
  const int changed = run.events[event].joint;
  Joint& joint = joints[static_cast<std::size_t>(changed)];
  joint.hold = joint.is_area() ? JointHold::area : JointHold::edge;
  for (std::size_t k = 0; k < event; ++k) {
    if (run.events[k].joint != changed) continue;
    joint = run.events[k].after.joints[static_cast<std::size_t>(changed)];
  }
  const std::vector<Wrench> after = HeldInstant(world, run.events[event].after.joints).rates;
  const std::vector<Wrench> before = HeldInstant(world, joints).rates;
  double largest = 0.0;
  for (std::size_t b = 0; b < before.size(); ++b) {
    const BodyProperties& body = world.bodies()[b];
    if (body.movable())
      largest =
          std::max(largest, body.inverse_mass * (after[b].force_w - before[b].force_w).norm());
  }
  return largest;
}

// The first change that leaves a joint like this.
std::size_t first_event(const UnilateralRun& run, JointHold hold) {
  for (std::size_t k = 0; k < run.events.size(); ++k)
    if (run.events[k].hold == hold) return k;
  throw std::runtime_error("late: expected an end after a box has come apart");
}

Table pose_table(const std::vector<End>& ends) {
  Table table{"",
              {{"end", "-", "0: before any opening, 1: after one, 2: after several"},
               {"step_s", "s", "length of a step"}}};
  for (const EventWay& way : ways())
    table.columns.push_back(
        {way.column + "_m", "m", "largest distance of a corner from where it should be"});
  for (std::size_t e = 0; e < ends.size(); ++e) {
    for (const Errors& errors : ends[e].errors) table.add(e, errors.dt, errors.pose);
  }
  return table;
}

Table moment_table(const End& end) {
  Table table{"moment", {{"step_s", "s", "length of a step"}}};
  for (const EventWay& way : ways())
    table.columns.push_back({way.column + "_s", "s", "error of the moment of the first opening"});
  for (const Errors& errors : end.errors) {
    std::vector<double> moments;
    for (std::size_t way = 0; way < ways().size(); ++way) moments.push_back(moment_of(errors, way));
    table.add(errors.dt, moments);
  }
  return table;
}

// The error-controlled method, with nothing but its own steps.
Table adaptive_table(const Parameters& settings, const End& end) {
  Table table{"adaptive",
              {{"accuracy", "-", "that a step is asked to have"},
               {"located_m", "m", "error after one opening, the opening located"},
               {"step_end_m", "m", "the same, noticed at the end of a step"},
               {"located_solves", "-", "systems of joint forces solved"},
               {"step_end_solves", "-", "the same, noticed at the end of a step"},
               {"glued_solves", "-", "the same with glue: nothing opens"}}};
  const World start = column_world(settings.number("angle"));
  for (int n = 8; n <= 24; ++n) {
    const double accuracy = std::pow(10.0, -0.5 * n);
    std::vector<double> errors;
    std::vector<int> solves;
    for (const GluedEvents events : {GluedEvents::located, GluedEvents::step_end}) {
      const UnilateralRun run = run_unilateral(
          start, unilateral(GluedScheme::dormand_prince, events, accuracy), end.time, 1);
      errors.push_back(farthest_corner(run.world, end.reference.world));
      solves.push_back(run.solves);
    }
    GluedOptions glued = unilateral(GluedScheme::dormand_prince, GluedEvents::located, accuracy);
    glued.joints = GluedJoints::bilateral;
    solves.push_back(run_unilateral(start, glued, end.time, 1).solves);
    table.add(accuracy, errors, solves);
  }
  return table;
}

double sum_of(const Table& table, std::size_t column) {
  return std::accumulate(table.rows.begin(), table.rows.end(), 0.0,
                         [&](double sum, const auto& row) { return sum + row[column]; });
}

Result measure_event_order(const Parameters& settings) {
  const std::vector<End> ends = {measure("before", settings), measure("after", settings),
                                 measure("late", settings)};
  if (!ends[0].reference.events.empty() || ends[1].reference.events.size() != 1 ||
      ends[2].reference.events.size() < 3)
    throw std::runtime_error(
        "before, after, late: expected ends before any opening, after one, and after three or "
        "more");
  Result result;
  const Table adaptive = adaptive_table(settings, ends[1]);
  result.tables = {pose_table(ends), moment_table(ends[2]), adaptive};

  const auto order = [&](const End& end, std::size_t way) {
    return order_of(end, way, step_of, pose_of);
  };
  const UnilateralRun& longest = ends[2].reference;
  result.quantities = {
      {"order before any joint opens, classical Runge-Kutta", "-", order(ends[0], kLocated)},
      {"order across one opening, located", "-", order(ends[1], kLocated)},
      {"order across several openings, located", "-", order(ends[2], kLocated)},
      {"the same, midpoint", "-", order(ends[2], 2)},
      {"order across several openings, noticed at the end of a step", "-",
       order(ends[2], kStepEnd)},
      {"order of what an opening costs against how late it is noticed", "-",
       order_of(ends[1], kStepEnd, moment_of, pose_of)},
      {"order of the first opening's moment, located", "-",
       order_of(ends[2], kLocated, step_of, moment_of)},
      {"jump of an acceleration as the first joint opens", "m/s²",
       jump_at(longest, first_event(longest, JointHold::edge))},
      {"jump of an acceleration as the first box comes apart", "m/s²",
       jump_at(longest, first_event(longest, JointHold::nothing))},
      {"error after one opening, error-controlled at 1e-12, located", "m", adaptive.rows.back()[1]},
      {"the same, noticed at the end of a step", "m", adaptive.rows.back()[2]},
      {"force solves of the latter over those with glue, sums over accuracies", "-",
       sum_of(adaptive, 4) / sum_of(adaptive, 5)}};
  return result;
}

const Registered event_order_figure{
    {.name = "event_order",
     .parameters =
         Parameters{}
             .add_number("angle", 0.3, 0.05, 0.5, "rad", "of the column's centre, at the start")
             .add_number("before", 0.8, 0.1, 10.0, "s", "end of a fall before any opening")
             .add_number("after", 0.86, 0.1, 10.0, "s", "end of a fall after one opening")
             .add_number("late", 1.15, 0.1, 10.0, "s",
                         "end of a fall after several changes of joints")
             .add_whole("fewest", 24, 4, 1000, "steps of a fall")
             .add_whole("most", 768, 8, 100000, "steps of a fall")
             .add_whole("per_doubling", 4, 1, 100, "numbers of steps between one and its double"),
     .quick = {"most=192", "per_doubling=2"},
     .experiment = measure_event_order}};

}  // namespace
}  // namespace tumble::chapters
