/// \file
/// \brief One impulse and the gravity around it, as printed and mended (thesis A.2; errata C1 to C11).
#include "tumble/contact/effective_mass.hpp"

#include "impulse_damped/errata_setup.hpp"

namespace tumble::chapters {
namespace {

struct Rested {
  double hop = 0.0;    // [m] highest above where it lay
  double speed = 0.0;  // [m/s] at the end
};

// A cube lies on the ground for half a second, and geometric stability is looked at or not.
Rested rest(const DampedErrata& repaired, bool stable_boxes) {
  World world = cube_on_ground();
  DampedAsPrinted technique(undamped(repaired, stable_boxes));
  Rested rested;
  for (int step = 0; step < 30; ++step) {
    finished(technique.step(world, kStep));
    rested.hop = std::max(rested.hop, world.states()[1].position_w.y() - 0.5);
  }
  rested.speed = BodyView(world, 1).velocity_w().norm();
  return rested;
}

// C4. A cube with restitution 0.9 comes down with 2 m/s on one that is stable; gravity is switched
// off for this step. Returns how fast it leaves, upwards.
double bounce_on_stable(const DampedErrata& repaired) {
  World world = cube_on_ground();
  DampedAsPrinted technique(undamped(repaired));
  finished(technique.step(world, kStep));
  const int upper = add_box(world, Vec3::Ones(), Vec3(0.0, 1.5, 0.0), Vec3(0.0, -2.0, 0.0), 0.9);
  world.gravity_w = Vec3::Zero();
  finished(technique.step(world, kStep));
  return BodyView(world, upper).velocity_w().y();
}

// C5. A column stands on the ground and is stable; a cube flies against its upper end. Returns by
// how much it has tilted a second later.
double tilt_after_hit(const DampedErrata& repaired) {
  World world = ground_world();
  const int column = add_box(world, Vec3(0.2, 1.0, 0.2), Vec3(0.0, 0.5, 0.0));
  DampedAsPrinted technique(undamped(repaired));
  finished(technique.step(world, kStep));
  add_box(world, Vec3::Constant(0.2), Vec3(-0.21, 0.9, 0.0), Vec3(2.0, 0.0, 0.0));
  world = stepped(world, std::move(technique), 60);
  const Vec3 up_w = world.states()[idx(column)].orientation_wb * Vec3::UnitY();
  return std::atan2(Vec3(up_w.x(), 0.0, up_w.z()).norm(), up_w.y());
}

// C7. Two cubes overlap and part with 1 m/s, without gravity. Returns how fast they part
// afterwards.
double separation_speed(const DampedErrata& repaired) {
  World world;
  world.gravity_w = Vec3::Zero();
  add_box(world, Vec3::Ones(), Vec3::Zero(), Vec3(-0.5, 0.0, 0.0));
  add_box(world, Vec3::Ones(), Vec3(0.9, 0.0, 0.0), Vec3(0.5, 0.0, 0.0));
  world = stepped(world, DampedAsPrinted(undamped(repaired)));
  return BodyView(world, 1).velocity_w().x() - BodyView(world, 0).velocity_w().x();
}

// The ground and a cube as COLLIDE sees them, out of a world that holds just these.
std::vector<PrintedObject> objects_of(const World& world) {
  PrintedObjects objects;
  const std::vector<std::uint8_t> stable(idx(world.count()), 0);
  const std::vector<Vec3> fixed(idx(world.count()), Vec3::Zero());
  objects.begin(world, stable, fixed, misprints());
  return {objects.all().begin(), objects.all().end()};
}

Contact contact_at(std::vector<Vec3> points) {
  Contact contact{
      .first = 0, .second = 1, .normal_w = Vec3::UnitY(), .count = static_cast<int>(points.size())};
  for (std::size_t k = 0; k < points.size(); ++k) contact.points[k].position_w = points[k];
  return contact;
}

// C8. A cube comes down flat with 2 m/s and restitution 0.9; it collides at the given points.
// Returns how fast it spins then.
double landing_spin(const std::vector<Vec3>& points) {
  std::vector<PrintedObject> objects = objects_of(cube_on_ground(Vec3(0.0, -2.0, 0.0)));
  collide_as_printed(objects[0], objects[1], contact_at(points), 0.9,
                     PrintedGravity::velocity_no_gravity, {.repaired = misprints()});
  return objects[1].moving.angular_velocity_w.norm();
}

// C9. A cube on its edge falls with 1 m/s and spins with 5 rad/s. It is stopped at the edge of the
// pose that it will have. Returns the normal velocity that is left at the edge, there and at the
// present pose.
struct LeverArms {
  double present = 0.0;    // [m/s]
  double predicted = 0.0;  // [m/s]
};

LeverArms lever_arms() {
  World world = ground_world();
  const Quat turned = rotation_from_vector(Vec3(0.0, 0.0, 0.3));
  world.add(box_properties(Vec3::Ones(), 1.0, 0.0), Vec3(0.0, 0.65, 0.0), turned,
            Vec3(0.0, -1.0, 0.0), Vec3(0.0, 0.0, 5.0));
  const auto edge_of = [&] {  // the middle of the lower edge that stands on the ground
    const BodyState& state = world.states()[1];
    return Vec3(state.position_w + state.orientation_wb * Vec3(-0.5, -0.5, 0.0));
  };
  PrintedObjects objects;
  const std::vector<std::uint8_t> stable(2, 0);
  const std::vector<Vec3> fixed(2, Vec3::Zero());
  objects.begin(world, stable, fixed, misprints());
  const Vec3 present_w = edge_of();
  objects.integrate_positions(world, kStep, Vec3::Zero(), RotationRule::splitting);
  const Vec3 predicted_w = edge_of();
  const Vec3 present_centre_w(0.0, 0.65, 0.0);

  PrintedObject& ground = objects.all()[0];
  PrintedObject& body = objects.all()[1];
  collide_as_printed(ground, body, contact_at({predicted_w}), 0.0,
                     PrintedGravity::velocity_no_gravity, {.repaired = misprints()});
  const double there = velocity_at(body.moving, predicted_w).y();
  body.moving.position_w = present_centre_w;
  return {std::abs(velocity_at(body.moving, present_w).y()), std::abs(there)};
}

// C10. A stable cube slides with 1 m/s. Returns what half a second leaves of it, if the components
// of vectors are counted from the given number.
double sliding_left(int index_base) {
  DampedAsPrintedOptions options = undamped(misprints());
  options.index_base = index_base;
  const World world = stepped(cube_on_ground(Vec3::UnitX()), DampedAsPrinted(options), 30);
  return BodyView(world, 1).velocity_w().x();
}

// C11. A brick counts as stable and turns; lines 13 and 14 leave its angular momentum about the
// vertical only. Returns the largest ratio of its energies, after over before, over all angular
// momenta with this vertical part.
double energy_ratio(double lean) {
  World world = ground_world();
  // Moments of inertia 2, 17 and 17.
  const BodyProperties brick = box_properties(Vec3(4.0, 1.0, 1.0), 12.0, 0.0);
  const Quat turned = rotation_from_vector(Vec3(0.0, 0.0, lean));
  const Mat3 inverse = inverse_inertia_w(brick, turned);
  // The least energy with L_y = 1 is there where nothing turns about the other axes: L = I e_y
  // times something.
  const Vec3 spin_w = inverse.inverse().col(1).normalized();
  const Vec3 omega_w = inverse * spin_w;
  world.add(brick, Vec3(0.0, 5.0, 0.0), turned, Vec3::Zero(), omega_w);
  std::vector<PrintedObject> objects = objects_of(world);
  objects[1].geometrically_stable = true;
  const double before = objects[1].kinetic_energy(Vec3::Zero());
  collide_as_printed(objects[0], objects[1], contact_at({world.states()[1].position_w}), -1.0,
                     PrintedGravity::velocity_no_gravity, {.repaired = misprints()});
  return objects[1].kinetic_energy(Vec3::Zero()) / before;
}

}  // namespace

void add_collide_errata(Result& result) {
  const DampedErrata mended = misprints();
  const auto resting = [](const DampedErrata& repaired) { return rest(repaired, false).speed; };
  const auto stable = [](const DampedErrata& repaired) { return rest(repaired, true).speed; };
  compare(result, "C1: hop of a cube at rest, ", "m", "gravity added as it is",
          "gravity times step added", mended,
          [](const DampedErrata& repaired) { return rest(repaired, false).hop; });
  compare(result, "C2: speed of a cube at rest, ", "m/s", "gravity for both bodies",
          "gravity for movable bodies", mended, resting);
  compare(result, "C3: speed of a stable cube, ", "m/s", "freed after gravity is taken back",
          "freed before", mended, stable);
  compare(result, "C4: rebound from a stable cube ", "m/s", "that yields", "that is immovable",
          mended, bounce_on_stable);
  compare(result, "C5: tilt 1 s after a hit, ", "rad", "column stays stable",
          "column no longer stable", mended, tilt_after_hit);
  compare(result, "C6: speed of a stable cube, ", "m/s", "velocity and momentum stored apart",
          "one store", mended, stable);
  compare(result, "C7: separation speed, ", "m/s", "impulse for all pairs",
          "impulse for pairs that approach", mended, separation_speed);
  const Vec3 corner(0.5, 0.0, 0.5);
  result.add("C8: spin after a flat landing, point at a corner", "rad/s", landing_spin({corner}));
  result.add(
      "C8: spin after a flat landing, point at the centre", "rad/s",
      landing_spin({corner, Vec3(-0.5, 0.0, 0.5), Vec3(0.5, 0.0, -0.5), Vec3(-0.5, 0.0, -0.5)}));
  const LeverArms arms = lever_arms();
  result.add("C9: approach that is left, seen at the present pose", "m/s", arms.present);
  result.add("C9: approach that is left, seen at the predicted pose", "m/s", arms.predicted);
  result.add("C10: speed left of a stable cube that slides, components from 1", "m/s",
             sliding_left(1));
  result.add("C10: speed left of a stable cube that slides, components from 0", "m/s",
             sliding_left(0));
  constexpr double eighth = 0.78539816339744830962;  // [rad] of a turn
  result.add("C11: energy ratio, stable brick that leans", "-", energy_ratio(eighth));
  result.add("C11: energy ratio, stable brick on its face", "-", energy_ratio(0.0));
}

}  // namespace tumble::chapters
