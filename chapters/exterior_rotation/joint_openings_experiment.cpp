/// \file
/// \brief Openings of the joints of the falling column, and their consequences.
#include "driver/experiment.hpp"
#include "exterior_rotation/falling_column.hpp"
#include "exterior_rotation/held_run.hpp"
#include "exterior_rotation/side_view.hpp"
#include "exterior_rotation/unilateral_run.hpp"

namespace tumble::chapters {
namespace {

constexpr int kJoints = 3;  // areas between four cubes; joint 0 is the pivot
constexpr int kTop = 3;
constexpr double kDegrees = 180.0 / std::numbers::pi;
const Vec2 kLow = Vec2(-1.3, 1.0);  // [m] what a frame shows
const Vec2 kHigh = Vec2(5.0, 6.2);

// How far a body has turned, falling.
double tilt_of(const BodyState& state) {
  const Vec3 up_w = state.orientation_wb * Vec3::UnitY();
  return elementary::atan2(up_w.x(), up_w.y());
}

// A moment of the fall.
struct Look {
  double time = 0.0;
  std::array<double, kJoints> pressed{};  // [m] NaN if the area is not held
  std::array<double, kJoints> hinge{};    // [rad] between the two boxes
};

Look look_at(const World& world, std::span<const Joint> joints) {
  Look look;
  look.time = world.time();
  const HeldInstant held(world, joints);
  for (int k = 0; k < kJoints; ++k) {
    const Joint& joint = joints[idx(k + 1)];
    look.pressed[idx(k)] = joint.hold == JointHold::area
                               ? pressed_at(joint, held.forces.on_second(k + 1), world.states())
                               : std::nan("");
    look.hinge[idx(k)] =
        tilt_of(world.states()[idx(joint.first)]) - tilt_of(world.states()[idx(joint.second)]);
  }
  return look;
}

struct DryFall {
  UnilateralRun run;
  std::vector<Look> looks;
  JointMoment start;
};

DryFall let_fall(double angle, double seconds, double rate) {
  DryFall fall;
  fall.run = run_unilateral(
      column_world(angle), unilateral(GluedScheme::dormand_prince, GluedEvents::located), seconds,
      static_cast<int>(std::lround(seconds * rate)), [&](const World& world, const Glued& glued) {
        if (fall.looks.empty())
          fall.start = {world, {glued.joints().begin(), glued.joints().end()}};
        fall.looks.push_back(look_at(world, glued.joints()));
      });
  return fall;
}

// The first event of a kind.
const JointEvent& event_of(const DryFall& fall, int joint, JointHold hold) {
  for (const JointEvent& event : fall.run.events)
    if (event.joint == joint && event.hold == hold) return event;
  throw std::runtime_error("seconds: the fall is too short, joint " + std::to_string(joint) +
                           " has not opened by then");
}

// The column from the side. Thick lines: areas that hold. Dots: edges that boxes turn about.
Drawing drawing_of(const JointMoment& moment, int number) {
  SideView view(kLow, kHigh);
  const auto& bodies = moment.world.bodies();
  const std::span<const BodyState> states = moment.world.states();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const bool moves = bodies[b].movable();
    if (bodies[b].shape != Shape::box) continue;
    const Polygon side = side_of(bodies[b], states[b]);
    view.fill(side, moves ? film_colour::body : film_colour::supporter);
    view.outline(side, {moves ? film_colour::edge : film_colour::supporter_edge, 1.0});
  }
  const auto corner = [&](const Joint& joint, int k) -> Vec2 {
    return corner_of(joint, k, states).first_w.head<2>();
  };
  constexpr double radius = 0.11;  // [m] of a dot
  for (const Joint& joint : moment.joints) {
    if (joint.hold == JointHold::edge)
      view.dot(corner(joint, joint.side), radius, film_colour::pivot);
    if (joint.hold != JointHold::area) continue;
    // Seen from the side, two neighbouring corners of the area are one point, the next two another.
    const bool ahead = (corner(joint, 0) - corner(joint, 1)).norm() > radius;
    view.line(corner(joint, 0), corner(joint, ahead ? 1 : 2), {film_colour::dark, 4.0});
  }
  return {"frame" + std::to_string(number), view.commands()};
}

Table looks_table(const DryFall& fall, double angle) {
  Table table{"",
              {{"time_s", "s", "since the release of the column"},
               {"glued_deg", "deg", "closed form: angle of the glued column's centre"}}};
  const double opens = fall.run.events.front().time;
  const std::array<std::array<std::string, 3>, 4> parts = {
      {{"pressed", "m", "centre of pressure from the edge on the pivot's side, joint "},
       {"glued", "m", "the same of the glued column, closed form, joint "},
       {"error", "m", "their difference until the first opening, joint "},
       {"hinge", "deg", "angle between the two boxes, joint "}}};
  for (const auto& [name, unit, meaning] : parts)
    for (int k = 1; k <= kJoints; ++k)
      table.columns.push_back(
          {name + std::to_string(k) + '_' + unit, unit, meaning + std::to_string(k)});
  std::array<double, kJoints> opens_at{};  // glue would have to pull from there on
  for (int k = 0; k < kJoints; ++k) opens_at[idx(k)] = opening_angle(k + 1, angle);
  for (const Look& look : fall.looks) {
    const double phi = column_angle(look.time, angle);
    std::array<double, kJoints> glued{};
    std::array<double, kJoints> errors{};
    std::array<double, kJoints> hinges{};
    for (std::size_t k = 0; k < kJoints; ++k) {
      const int joint = static_cast<int>(k) + 1;
      glued[k] = phi <= opens_at[k] ? glue_force(joint, phi, angle).from_edge : std::nan("");
      errors[k] = look.time < opens ? std::abs(look.pressed[k] - glued[k]) : std::nan("");
      hinges[k] = kDegrees * look.hinge[k];
    }
    table.add(look.time, kDegrees * phi, look.pressed, glued, errors, hinges);
  }
  return table;
}

Table events_table(const DryFall& fall) {
  Table table{"events",
              {{"time_s", "s", "since the release of the column"},
               {"joint", "-", "0: pivot; from 1 areas, the lowest first"},
               {"hold", "-", "0: area, 1: edge, 3: nothing, from now on"},
               {"angle_rad", "rad", "of the centre of all cubes"}}};
  for (const JointEvent& event : fall.run.events)
    table.add(event.time, event.joint, static_cast<int>(event.hold), event.angle);
  return table;
}

double largest_error(const Table& looks) {
  double largest = 0.0;
  for (const auto& row : looks.rows)
    for (std::size_t column = 8; column < 11; ++column)
      if (row[column] > largest) largest = row[column];
  return largest;
}

Result measure_joint_openings(const Parameters& settings) {
  const double angle = settings.number("angle");
  const DryFall fall = let_fall(angle, settings.number("seconds"), settings.number("rate"));
  const JointEvent& first = event_of(fall, kTop, JointHold::edge);
  const JointEvent& second = event_of(fall, kTop - 1, JointHold::edge);
  const JointEvent& apart = event_of(fall, kTop, JointHold::nothing);
  const JointEvent& leaves = event_of(fall, 0, JointHold::nothing);
  const auto [steeper, enough] = std::array<double, 2>{0.3, 0.9};  // another fall: [rad], [s]
  const DryFall other = let_fall(steeper, enough, 60.0);

  Result result;
  result.tables = {looks_table(fall, angle), events_table(fall)};
  // The start, the first opening, and each time that a box has come apart.
  Table frames{"frames", {{"time_s", "s", "of the drawing with this place"}}};
  const auto draw = [&](double time, const JointMoment& moment) {
    frames.add(time);
    result.drawings.push_back(drawing_of(moment, static_cast<int>(frames.rows.size())));
  };
  draw(0.0, fall.start);
  for (std::size_t k = 0; k < fall.run.events.size(); ++k)
    if (k == 0 || fall.run.events[k].hold == JointHold::nothing)
      draw(fall.run.events[k].time, fall.run.events[k].after);
  result.tables.push_back(frames);

  const double opening = opening_angle(kTop, angle);
  const BodyState& lowest = first.after.world.states()[idx(fall.start.joints[1].first)];
  result.quantities = {
      {"angle of the column's centre at the first opening", "rad", first.angle},
      {"the same, closed form", "rad", opening},
      {"tilt of the column at the first opening", "deg", kDegrees * tilt_of(lowest)},
      {"moment of the first opening", "s", first.time},
      {"moment of the first opening, closed form", "s", column_time(opening, angle)},
      {"largest error of a centre of pressure before the first opening", "m",
       largest_error(result.tables.front())},
      {"angle at the first opening when released at 0.3", "rad",
       event_of(other, kTop, JointHold::edge).angle},
      {"angle of the centre of all boxes at the second opening", "rad", second.angle},
      {"angle at the second opening if the first joint held, closed form", "rad",
       opening_angle(kTop - 1, angle)},
      {"moment at which the top box comes apart", "s", apart.time},
      {"moment at which the lowest box leaves the edge", "s", leaves.time}};
  return result;
}

const Registered joint_openings_figure{
    {.name = "joint_openings",
     .parameters =
         Parameters{}
             .add_number("angle", 0.1, 0.01, 0.5, "rad", "of the column's centre, at the start")
             .add_number("seconds", 1.9, 0.1, 10.0, "s", "length of the fall")
             .add_number("rate", 480.0, 10.0, 1e4, "1/s", "looks a second"),
     .quick = {"rate=30"},
     .experiment = measure_joint_openings}};

}  // namespace
}  // namespace tumble::chapters
