/// \file
/// \brief The errata of DAMPENOBJECTS that show in motion (thesis 5.3, A.2; DM6, DM7, DM10 to DM12,
///        DM14).
#include "impulse_damped/errata_setup.hpp"

namespace tumble::chapters {
namespace {

constexpr double kPi = 3.14159265358979323846;

Vec3 lowest_corner(const World& world, int& which) {
  const std::array<Vec3, 8> corners = corners_of(box_of(world.bodies()[0], world.states()[0]));
  const auto lower = [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); };
  const auto lowest = std::ranges::min_element(corners, lower);
  which = static_cast<int>(lowest - corners.begin());
  return *lowest;
}

// DM6. A cube, tilted by 30 degrees, turns about its lowest edge at 1 rad/s. What is the edge's velocity
// after a step?
Vec3 edge_velocity(double k1, double k2) {
  World world = world_with_cube(Vec3::Zero());
  BodyState& cube = world.states()[0];
  cube.orientation_wb = turned_about_z(kPi / 6.0);
  int which = 0;
  const Vec3 arm_w = lowest_corner(world, which);
  cube.linear_momentum_w = -Vec3::UnitZ().cross(arm_w);
  cube.angular_momentum_w = unit_cube().inertia_b.z() * Vec3::UnitZ();
  PrintedNumbers numbers;
  numbers.k.momentum = k1;
  numbers.k.spin = k2;
  dampen(world, true, numbers);
  const Vec3 velocity_w = velocity(world.bodies()[0], cube);
  const Vec3 spin_w = angular_velocity(world.bodies()[0], cube);
  return velocity_w + spin_w.cross(arm_w);
}

void add_pivot(double k1, Result& result) {
  constexpr double k2 = 0.99;
  const Vec3 apart_w = edge_velocity(k1, k2);
  const Vec3 alike_w = edge_velocity(k1, k1);
  result.add("DM6: sideways speed of the edge that a cube pivots on, two factors", "m/s",
             std::abs(apart_w.x()));
  result.add("DM6: sideways speed of the edge that a cube pivots on, one factor", "m/s",
             std::abs(alike_w.x()));
  result.add("DM6: depth that the edge gains in a step, two factors", "m", -kStep * apart_w.y());
}

// DM7. Two cubes fall side by side, and touch. Damped is their motion in the world, or against the
// motion that they have in common.
std::vector<double> fall_speeds(double k1, bool against_each_other, int steps) {
  World world = world_with_cube(Vec3::Zero());
  world.add(unit_cube(), Vec3::UnitX());
  PrintedNumbers numbers;
  numbers.k.momentum = k1;
  std::vector<double> speeds = {0.0};
  for (int step = 0; step < steps; ++step) {
    add_gravity(world);
    Vec3 common_w = Vec3::Zero();  // [m/s]
    if (against_each_other)
      for (const BodyState& cube : world.states()) common_w += 0.5 * cube.linear_momentum_w;
    for (BodyState& cube : world.states()) cube.linear_momentum_w -= common_w;
    dampen(world, true, numbers);
    for (BodyState& cube : world.states()) {
      cube.linear_momentum_w += common_w;
      cube.position_w += kStep * common_w;
    }
    speeds.push_back(-world.states()[0].linear_momentum_w.y());
  }
  return speeds;
}

void add_fall(double k1, Result& result) {
  constexpr int second = 60;  // [steps]
  const std::vector<double> printed = fall_speeds(k1, false, 10 * second);
  const std::vector<double> mended = fall_speeds(k1, true, second);
  add_paths(result, "fall",
            {{"time_s", "s", "time since their release"},
             {"printed_m_s", "m/s", "speed of the fall, damped in the world"},
             {"mended_m_s", "m/s", "damped against each other"}},
            kStep, 1.0, printed, mended);
  result.add("DM7: speed after a fall of 1 s beside another cube, damped in the world", "m/s",
             printed[second]);
  result.add("DM7: speed after a fall of 1 s beside another cube, damped against it", "m/s",
             mended[second]);
  result.add("DM7: speed that the fall never exceeds, damped in the world", "m/s", printed.back());
}

// DM10. A cube slides at 30 degrees to the x axis. Ended are components below ε6, or a momentum below it.
std::vector<Vec3> slide(double k1, bool whole) {
  const double small = usual_thresholds().still;  // [N s]
  PrintedNumbers numbers;
  numbers.k.momentum = k1;
  numbers.eps.still = whole ? 0.0 : small;
  World world = world_with_cube(Vec3(std::cos(kPi / 6.0), 0.0, std::sin(kPi / 6.0)));
  BodyState& cube = world.states()[0];
  std::vector<Vec3> path = {cube.position_w};
  while (!cube.linear_momentum_w.isZero(0.0)) {
    if (whole && k1 * cube.linear_momentum_w.norm() < small) cube.linear_momentum_w.setZero();
    dampen(world, true, numbers);
    path.push_back(cube.position_w);
    if (path.size() > 10000) throw std::runtime_error("the slide does not end");
  }
  path.pop_back();  // the step that ended it did not move it
  return path;
}

// [deg] between the first and the last move
double bend_of(const std::vector<Vec3>& path) {
  const Vec3 first_w = path[1] - path[0];
  const Vec3 last_w = path.back() - path[path.size() - 2];
  return std::atan2(first_w.cross(last_w).norm(), first_w.dot(last_w)) * 180.0 / kPi;
}

void add_path(double k1, Result& result) {
  Table table{"path",
              {{"whole", "-", "0: components are ended; 1: the whole momentum is"},
               {"x_m", "m", "along the x axis"},
               {"z_m", "m", "along the z axis"}}};
  for (const bool whole : {false, true})
    for (const Vec3& place : slide(k1, whole)) table.add(whole, place.x(), place.z());
  result.tables.push_back(table);
  result.add("DM10: angle by which the way of a slide bends, each component on its own", "deg",
             bend_of(slide(k1, false)));
  result.add("DM10: angle by which the way of a slide bends, whole momentum", "deg",
             bend_of(slide(k1, true)));
}

// DM11. A cube beside a high wall is released. It is damped by any contact, or by one that can hold it up.
std::vector<double> fall_beside_wall(bool any_contact, int steps) {
  World world;
  add_fixed_box(world, Vec3(1.0, 100.0, 1.0), Vec3::Zero());
  world.add(unit_cube(), Vec3::UnitX());
  PrintedNumbers numbers;
  numbers.eps.aligned = usual_thresholds().aligned;
  numbers.eps.settled = 0.2;  // [N s] above m g dt = 0.1635 N s
  std::vector<double> fallen = {0.0};
  for (int step = 0; step < steps; ++step) {
    add_gravity(world);
    const ContactList contacts = contacts_within(world, 0.0);
    const bool holds =
        !contacts.empty() && (any_contact || contacts[0].normal_w.y() > std::sqrt(0.5));
    dampen(world, holds, numbers);
    fallen.push_back(0.0 - world.states()[1].position_w.y());
  }
  return fallen;
}

// DM12. A cube in free flight.
struct Flown {
  std::vector<double> places;  // [m] along its way, after each step
  int frozen = 0;
};
Flown fly_frozen(const Vec3& momentum_w, double eps10, bool weight, int steps) {
  PrintedNumbers numbers;
  numbers.eps.frozen = eps10;
  numbers.eps.frozen_angle = 1.0;
  World world = world_with_cube(momentum_w);
  Flown flown{{0.0}, 0};
  for (int step = 0; step < steps; ++step) {
    if (weight) add_gravity(world);
    flown.frozen += dampen(world, false, numbers).frozen;
    const Vec3& place_w = world.states()[0].position_w;
    flown.places.push_back(weight ? place_w.y() : place_w.x());
  }
  return flown;
}

void add_freeze(double eps10, Result& result) {
  // Thrown up so that the apex is at the end of the tenth step.
  const Vec3 throw_w(0.0, 10.0 * kGravity * kStep, 0.0);
  const Flown printed = fly_frozen(throw_w, eps10, true, 20);
  const Flown mended = fly_frozen(throw_w, 0.0, true, 20);
  add_paths(result, "apex",
            {{"time_ms", "ms", "time since the throw"},
             {"printed_mm", "mm", "height, small moves undone"},
             {"mended_mm", "mm", "height, only those of bodies in contact"}},
            1e3 * kStep, 1e3, printed.places, mended.places);
  result.add("DM12: steps that a cube hangs at its apex, every body tested", "-", printed.frozen);
  result.add("DM12: steps that a cube hangs at its apex, bodies in contact tested", "-",
             mended.frozen);
  result.add("DM12: steps that a cube hangs at its apex, every body tested, twice the threshold",
             "-", fly_frozen(throw_w, 2.0 * eps10, true, 20).frozen);
  const Flown dropped = fly_frozen(Vec3::Zero(), eps10, true, 2);
  result.add("DM12: jump of a released cube, after the steps that it hangs", "m",
             dropped.places[1] - dropped.places[2]);
  const Vec3 slow_w(0.29, 0.0, 0.0);
  result.add("DM12: way of a slide at 0.29 m/s in 1 s, every body tested", "m",
             fly_frozen(slow_w, eps10, false, 60).places.back());
}

// DM14. A cube on its edge is turned upright by `most` a step. How far is it above the ground then?
std::vector<double> tilt_gaps(double tilt, double most, bool about_edge, int steps) {
  PrintedNumbers numbers;
  numbers.eps.aligned = 0.1;
  numbers.eps.tilt = most;
  World world = world_with_cube(Vec3::Zero());
  BodyState& cube = world.states()[0];
  cube.orientation_wb = turned_about_z(tilt);
  int which = 0;
  const double ground = lowest_corner(world, which).y();
  std::vector<double> gaps = {0.0};
  for (int step = 0; step < steps; ++step) {
    const Vec3 before_w = lowest_corner(world, which);
    dampen(world, true, numbers);
    if (about_edge) cube.position_w += before_w - corner_of(box_of(world.bodies()[0], cube), which);
    gaps.push_back(lowest_corner(world, which).y() - ground);
  }
  return gaps;
}

void add_tilt(Result& result) {
  constexpr int steps = 6;
  const std::vector<double> printed = tilt_gaps(0.05, 0.01, false, steps);
  const std::vector<double> mended = tilt_gaps(0.05, 0.01, true, steps);
  add_paths(result, "tilt",
            {{"step", "-", "steps"},
             {"printed_mm", "mm", "gap below a cube turned about its centre"},
             {"mended_mm", "mm", "about its lowest edge"}},
            1.0, 1e3, printed, mended);
  const std::string gap = "DM14: gap below a cube turned from ";
  result.add(gap + "0.02 rad to 0, about its centre", "m", tilt_gaps(0.02, 0.02, false, 1).back());
  result.add(gap + "0.02 rad to 0, about its edge", "m", tilt_gaps(0.02, 0.02, true, 1).back());
  result.add(gap + "0.05 rad to 0.04, about its centre", "m", printed[1]);
}

}  // namespace

void add_motion_errata(double k1, double eps10, Result& result) {
  add_pivot(k1, result);
  add_fall(k1, result);
  add_path(k1, result);

  const std::vector<double> printed = fall_beside_wall(true, 60);
  const std::vector<double> mended = fall_beside_wall(false, 60);
  add_paths(result, "wall",
            {{"time_s", "s", "time since its release"},
             {"printed_m", "m", "fall, held by any contact"},
             {"mended_m", "m", "fall, held by what is below"}},
            kStep, 1.0, printed, mended);
  result.add("DM11: fall in 1 s beside a wall, any contact counts", "m", printed.back());
  result.add("DM11: fall in 1 s beside a wall, support counts", "m", mended.back());

  add_freeze(eps10, result);
  add_tilt(result);
}

}  // namespace tumble::chapters
