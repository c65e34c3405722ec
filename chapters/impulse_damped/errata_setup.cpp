/// \file
/// \brief Setups of the experiments with errata of the listings in appendix A.2.
#include "impulse_damped/errata_setup.hpp"

#include "tumble/contact/gather.hpp"

#include "driver/finished.hpp"

namespace tumble::chapters {

void add_paths(Result& result, const std::string& suffix, const std::vector<Column>& columns,
               double step, double scale, const std::vector<double>& printed,
               const std::vector<double>& mended) {
  Table table{suffix, columns};
  for (std::size_t k = 0; k < mended.size(); ++k)
    table.add(step * static_cast<double>(k), scale * printed[k], scale * mended[k]);
  result.tables.push_back(table);
}

DampedErrata misprints() {
  return DampedErrata(
      "D2,D4,D5,D6,C1,C2,C3,C4,C5,C6,C7,C10,RK1,RK3,RC4,DM1,DM2,DM3,DM4,DM5,DM8,DM13,DM16,X1,X2,"
      "G1,G2,G3,G4,G5,G7,G8");
}

DampedAsPrintedOptions undamped(const DampedErrata& repaired, bool stable_boxes) {
  DampedAsPrintedOptions options;
  options.repaired = repaired;
  options.stable_boxes = stable_boxes;
  DampedNumbers& n = options.numbers;
  n.k1 = n.k2 = n.k3 = n.k5 = n.k7 = 1.0;
  n.eps2 = n.eps3 = n.eps4 = n.eps5 = n.eps6 = n.eps7 = n.eps8 = n.eps10 = n.eps11 = 0.0;
  n.eps9 = 1e-9;  // what a rounding lifts does not rise
  return options;
}

World ground_world(double restitution) {
  World world;
  world.add_ground(0.0, restitution);
  return world;
}

int add_box(World& world, const Vec3& size, const Vec3& position_w, const Vec3& velocity_w,
            double restitution) {
  const BodyProperties box = box_properties(size, 1.0, 0.0, restitution);
  world.add(box, make_state(box, position_w, Quat::Identity(), velocity_w));
  return world.count() - 1;
}

void add_fixed_box(World& world, const Vec3& size, const Vec3& position_w,
                   const Quat& orientation_wb) {
  const BodyProperties body = fixed_box_properties(size);
  world.add(body, make_state(body, position_w, orientation_wb));
}

World cube_on_ground(const Vec3& velocity_w) {
  World world = ground_world();
  add_box(world, Vec3::Ones(), Vec3(0.0, 0.5, 0.0), velocity_w);
  return world;
}

Vec3 velocity_of(const World& world, int index) {
  return velocity(world.bodies()[idx(index)], world.states()[idx(index)]);
}

World stepped(World world, Technique&& technique, int steps, double dt) {
  for (int step = 0; step < steps; ++step) finished(technique.step(world, dt));
  return world;
}

std::vector<IndexPair> all_pairs(const World& world) {
  std::vector<IndexPair> pairs;
  for (int i = 0; i < world.count(); ++i)
    for (int j = i + 1; j < world.count(); ++j) pairs.push_back({i, j});
  return pairs;
}

ContactList contacts_of(const World& world, double margin) {
  std::vector<MovingBody> moving;
  load_moving_bodies(world, moving);
  ContactList contacts;
  gather_contacts(world, moving, all_pairs(world), margin, {}, contacts);
  return contacts;
}

Quat turned_about_z(double angle) {
  return Quat(std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle));
}

BodyProperties unit_cube() { return box_properties(Vec3::Ones(), 1.0); }

DampedThresholds usual_thresholds() {
  return thresholds_of(DampedNumbers{}, unit_cube(), kGravity, kStep);
}

World world_with_cube(const Vec3& momentum_w, const Vec3& spin_w) {
  World world;
  BodyState state = make_state(unit_cube(), Vec3::Zero());
  state.linear_momentum_w = momentum_w;
  state.angular_momentum_w = spin_w;
  world.add(unit_cube(), state);
  return world;
}

DampenReport dampen(World& world, bool touched, const PrintedNumbers& numbers,
                    const DampedErrata& mended, double dt) {
  const std::vector<std::uint8_t> flags(world.states().size(), touched ? 1 : 0);
  return dampen_objects_as_printed(world, flags, numbers, dt, RotationRule::splitting, mended);
}

void add_gravity(World& world) {
  for (std::size_t k = 0; k < world.states().size(); ++k)
    if (world.bodies()[k].movable())
      world.states()[k].linear_momentum_w += world.bodies()[k].mass * kStep * world.gravity_w;
}

}  // namespace tumble::chapters
