/// \file
/// \brief Gaps of the text about the moment of impact, taken literally and mended (thesis 5.1,
///        A.1; errata T8 and T9).
#include "tumble/contact/collision_law.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/contact/impacts.hpp"
#include "tumble/dynamics/integrate.hpp"
#include "tumble/math/bracket.hpp"

#include "basic_colliding/errata.hpp"
#include "driver/experiment.hpp"

#include <initializer_list>

namespace tumble::chapters {
namespace {

// --- T8: what moves the bodies while a time is searched for -----------------------------------

using Mover = void (*)(const BodyProperties&, BodyState&, const Vec3&, double, RotationRule);

BodyState dropped_for(Mover move, double height, std::initializer_list<double> times) {
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  BodyState state = make_state(cube, Vec3(0.0, 0.5 + height, 0.0));
  for (const double time : times)
    move(cube, state, Vec3(0.0, -kGravity, 0.0), time, RotationRule::splitting);
  return state;
}

// By how much the height at the end changes if a step is cut in two, at a third.
double change_by_cutting(Mover move) {
  const double whole = dropped_for(move, 1.0, {kStep}).position_w.y();
  const double parts = dropped_for(move, 1.0, {kStep / 3.0, 2.0 * kStep / 3.0}).position_w.y();
  return std::abs(whole - parts);
}

constexpr double kDrop = 1e-3;  // [m]

double lower_face(Mover move, double time) {
  return dropped_for(move, kDrop, {time}).position_w.y() - 0.5;
}

double impact_by_bisection(Mover move) {
  const auto height = [&](double time) { return lower_face(move, time); };
  return bisect(height, Bracket{0.0, kStep}, 1e-12, 100).bracket.low;
}

Table fall_table() {
  Table table{"fall",
              {{"time_ms", "ms", "time"},
               {"euler_mm", "mm", "height after one semi-implicit Euler step of this length"},
               {"flight_mm", "mm", "height after a flight of this length"},
               {"exact_mm", "mm", "height, closed form"}}};
  constexpr int rows = 80;
  for (int k = 0; k <= rows; ++k) {
    const double t = kStep * k / rows;
    table.add(1e3 * t, 1e3 * lower_face(step_semi_implicit, t), 1e3 * lower_face(fly, t),
              1e3 * (kDrop - 0.5 * kGravity * t * t));
  }
  return table;
}

// --- T9: the order of collisions at one time -----------------------------------------------------

constexpr double kRestitution = 0.9;
using Order = std::array<int, 4>;  // of the corners

// A cube has come down flat with 2 m/s; this is how it goes on if its corners collide one by one in
// the given order, round and round until none approaches, or all together without an order.
World after_landing(const Order* order) {
  World world;
  world.add_ground(0.0, kRestitution);
  world.add(box_properties(Vec3::Ones(), 1.0, 0.0, kRestitution), Vec3(0.0, 0.5, 0.0),
            Quat::Identity(), Vec3(0.0, -2.0, 0.0));
  std::vector<MovingBody> moving;
  load_moving_bodies(world, moving);
  const IndexPair pair{0, 1};
  ContactList contacts;
  gather_contacts(world, moving, {&pair, 1}, 1e-9, {}, contacts);
  if (contacts.size() != 1 || contacts[0].count != 4)
    throw std::runtime_error("not a flat landing");

  if (order != nullptr) {
    // A corner that parts gets no impulse; another one's may make it approach again.
    constexpr int most_rounds = 100;
    bool quiet = false;
    for (int round = 0; !quiet; ++round) {
      if (round == most_rounds) throw std::runtime_error("the corners go on colliding");
      quiet = true;
      for (const int corner : *order) {
        const Vec3& point_w = contacts[0].points[idx(corner)].position_w;
        const PointImpulse impulse =
            collide_at_point(moving[0], moving[1], point_w, Vec3::UnitY(), 0.0, kRestitution);
        quiet = quiet && impulse.mode == ImpactMode::none;
      }
    }
  } else {
    ImpactSolver().resolve(contacts, moving, {.order = ImpactOrder::simultaneous});
  }
  store_moving_bodies(moving, world);
  return world;
}

double spin_of(const World& world) { return BodyView(world, 1).angular_velocity_w().norm(); }

// Heights of the lower corners, in the order of the four quarters around the vertical.
std::array<double, 4> corner_heights(World world, double time) {
  BodyState& cube = world.states()[1];
  fly(world.bodies()[1], cube, world.gravity_w, time, RotationRule::splitting);
  std::array<double, 4> heights{};
  const std::array<Vec3, 4> corners_b = {Vec3(-0.5, -0.5, -0.5), Vec3(0.5, -0.5, -0.5),
                                         Vec3(0.5, -0.5, 0.5), Vec3(-0.5, -0.5, 0.5)};
  for (std::size_t k = 0; k < corners_b.size(); ++k)
    heights[k] = cube.position_w.y() + (cube.orientation_wb * corners_b[k]).y();
  return heights;
}

// T8: a step of Euler's method cut in two is not the step.
void add_flow_erratum(Result& result) {
  result.tables.push_back(fall_table());
  result.add("T8: height that cutting a step changes, forward Euler", "m",
             change_by_cutting(step_forward_euler));
  result.add("T8: height that cutting a step changes, semi-implicit Euler", "m",
             change_by_cutting(step_semi_implicit));
  result.add("T8: height that cutting a step changes, flight", "m", change_by_cutting(fly));
  result.add("T8: impact time, bisecting a semi-implicit Euler step", "s",
             impact_by_bisection(step_semi_implicit));
  result.add("T8: impact time, bisecting a flight", "s", impact_by_bisection(fly));
}

// T9: impacts at one time are resolved in the order in which a heap happens to hold them.
void add_tie_erratum(Result& result) {
  const Order forth = {0, 1, 2, 3};
  const World one = after_landing(&forth);
  const World together = after_landing(nullptr);
  Order any = forth;
  double most = spin_of(one);
  while (std::next_permutation(any.begin(), any.end()))
    most = std::max(most, spin_of(after_landing(&any)));

  Table table{"landing", {{"time_ms", "ms", "time since the landing"}}};
  for (const char* how : {"literal", "mended"}) {
    for (const char* corner : {"1", "2", "3", "4"})
      table.columns.push_back(
          {std::string(how) + corner + "_m", "m", std::string("height of a corner, ") + how});
  }
  constexpr int rows = 40;
  constexpr double shown = 0.1;  // [s]
  for (int k = 0; k <= rows; ++k) {
    const double time = shown * k / rows;
    table.add(1e3 * time, corner_heights(one, time), corner_heights(together, time));
  }
  result.tables.push_back(table);
  result.add("T9: spin after a flat landing, corner by corner", "rad/s", spin_of(one));
  result.add("T9: the same, most of all 24 orders of the corners", "rad/s", most);
  result.add("T9: spin after a flat landing, all corners together", "rad/s", spin_of(together));
}

Result measure_event_search_errata(const Parameters& settings) {
  Result result;
  add_pass_erratum(result);
  add_progress_errata(settings.count("cap"), result);
  add_flow_erratum(result);
  add_tie_erratum(result);
  return result;
}

const Registered errata_event_search_figure{
    {.name = "errata_event_search",
     .parameters = {whole("cap", 1000, 20, 100000, "impacts at which an endless step is stopped")},
     .quick = {"cap=100"},
     .experiment = measure_event_search_errata}};

}  // namespace
}  // namespace tumble::chapters
