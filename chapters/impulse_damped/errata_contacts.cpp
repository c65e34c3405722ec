/// \file
/// \brief Errata of collisions and contacts in damped integration, measured (thesis A.2).
#include "impulse_damped/errata_contacts.hpp"

#include "impulse_damped/errata_collide_experiments.hpp"

#include <cmath>

namespace tumble::chapters {

DampedErrata misprints() {
  return DampedErrata(
      "D2,D4,D5,D6,C1,C2,C3,C4,C5,C6,C7,C10,RK1,RK3,RC4,DM1,DM2,DM3,DM4,DM5,DM8,DM13,DM16,X1,X2,"
      "G1,G2,G3,G4,G5,G7,G8");
}

DampedAsPrintedOptions undamped(const DampedErrata& repaired) {
  DampedAsPrintedOptions options;
  options.repaired = repaired;
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

Vec3 velocity_of(const World& world, int index) {
  const auto k = static_cast<std::size_t>(index);
  return velocity(world.bodies()[k], world.states()[k]);
}

void run_steps(Technique& technique, World& world, double dt, int steps) {
  for (int step = 0; step < steps; ++step) technique.step(world, dt);
}

Result measure_contact_errata(const Parameters& settings) {
  std::vector<ErratumPair> pairs;
  add_step_errata(pairs);
  add_collide_errata(pairs);
  add_pass_errata(settings.number("seconds"), pairs);

  Result result;
  Table table{"",
              {{"row", "-", "number of the erratum, in the order of the listings"},
               {"failure", "as the number's name says", "with the text taken literally"},
               {"mended", "as the number's name says", "under the other reading"}}};
  for (const ErratumPair& pair : pairs) {
    table.rows.push_back(
        {static_cast<double>(table.rows.size()), std::abs(pair.failure), std::abs(pair.mended)});
    result.quantities.push_back({pair.failure_name, pair.unit, pair.failure});
    result.quantities.push_back({pair.mended_name, pair.unit, pair.mended});
  }
  result.tables.push_back(table);
  return result;
}

Figure contact_errata_figure() {
  Figure figure;
  figure.name = "errata_contacts";
  figure.section = "4.3, 4.4, 5.2, A.2";
  figure.title = "Where collisions and contacts of damped integration fail, and the same mended";
  figure.caption =
      "One row for each erratum of the listings DAMPEDINTEGRATION (D), COLLIDE (C), "
      "RESOLVECOLLISIONS and RESOLVECONTACTS (RK, RC); squares: the text taken literally, all "
      "other misprints being mended; circles: this one mended, too, or the alternative to a "
      "choice. "
      "Each row is a number of its own, in the unit that stands with it; what is below 1e-9 is "
      "at 0. Nothing is damped in these runs (but in D3), so that nothing hides a mistake. The "
      "worst are those at which a cube at rest does not rest: C1 throws it into the air, C2, C3, "
      "C6 and D6 let it sink, RK3 lets it bounce for ever. C4, C5 and C10 go wrong because a body "
      "counts as stable: it swallows a collision, cannot be toppled, or stops. RK4 is the chatter "
      "of a stack of five under the thesis's own choice, to push bodies instead of going through "
      "their velocities level by level.";
  figure.parameters.add_number("seconds", 5.0, 0.1, 600.0, "s",
                               "for which the stack of RK4 is watched, after as long to settle");
  figure.quick = {"seconds=1"};
  figure.experiment = measure_contact_errata;
  return figure;
}

}  // namespace tumble::chapters
