/// \file
/// \brief The listings RESOLVECOLLISIONS and RESOLVECONTACTS as they are printed (thesis A.2).
#include "tumble/impulse_damped/as_printed/resolve_as_printed.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/dynamics/flight.hpp"

namespace tumble {
namespace {

void integrate_object_positions(PrintedStage& stage, PrintedGravity gravity) {
  const bool plus = gravity == PrintedGravity::velocity_plus_gravity;
  stage.report.integrations += stage.objects.integrate_positions(
      stage.world, stage.dt, plus ? stage.ahead_w : Vec3::Zero(), stage.rotation);
}

void gather_collisions(PrintedStage& stage) {
  ++stage.report.iterations;
  const PairReport found = stage.gatherer.gather(stage.world, stage.last, stage.world.states(),
                                                 nullptr, 0.0, stage.collisions);
  stage.report.pair_tests += found.pair_tests;
  if (!stage.collide.repaired.has("C5")) return;
  // Erratum C5 repaired: a body that is touched from another side than above or below is not stable.
  for (const Contact& c : stage.collisions) {
    const double sine = Vec3(c.normal_w.x(), 0.0, c.normal_w.z()).norm();
    if (sine <= tolerance::vertical_normal) continue;
    stage.objects.all()[idx(c.first)].geometrically_stable = false;
    stage.objects.all()[idx(c.second)].geometrically_stable = false;
  }
}

// Erratum RC2 mended: whether the pair still overlaps where its velocities of now would take it.
bool still_overlaps(PrintedStage& stage, const Contact& c) {
  stage.objects.revert_to_original_positions(stage.world);
  integrate_object_positions(stage, PrintedGravity::velocity_plus_gravity);
  ++stage.report.pair_tests;
  return gap_between(stage.world.bodies()[idx(c.first)], stage.world.states()[idx(c.first)],
                     stage.world.bodies()[idx(c.second)], stage.world.states()[idx(c.second)])
             .distance <= 0.0;
}

void collide(PrintedStage& stage, const Contact& c, double restitution, PrintedGravity gravity) {
  if (stage.collide.repaired.has("RC2") && !still_overlaps(stage, c)) return;
  const std::span<PrintedObject> objects = stage.objects.all();
  const PrintedCollision done = collide_as_printed(objects[idx(c.first)], objects[idx(c.second)], c,
                                                   restitution, gravity, stage.collide);
  stage.report.energy.restitution += done.energy;
  stage.report.energy.damping += done.damping;
  if (done.impulse != 0.0) ++stage.report.impulses;
  if (stage.told) stage.told(c, done);
}

// Erratum RK1: the quotient of two integers.
double restitution_of_pass(int i, int passes, const DampedErrata& repaired) {
  if (repaired.has("RK1")) return -1.0 + static_cast<double>(i) / passes;
  // [RESOLVECONTACTS:5]
  return -1 + (i / passes);
  // [RESOLVECONTACTS:5]
}

}  // namespace

void resolve_collisions_as_printed(PrintedStage& stage) {
  const int first = stage.loop_base;
  // [RESOLVECOLLISIONS:1]
  // For a fixed number of passes:
  for (int i = first; i < first + stage.passes; ++i) {
    // [RESOLVECOLLISIONS:1]
    // [RESOLVECOLLISIONS:2-3]
    // move all bodies as if nothing were in their way, and see which overlap;
    integrate_object_positions(stage, PrintedGravity::velocity_plus_gravity);
    gather_collisions(stage);
    // [RESOLVECOLLISIONS:2-3]
    // [RESOLVECOLLISIONS:4-5]
    // let each of these pairs collide, without gravity;
    for (const Contact& c : stage.collisions)
      collide(stage, c, c.restitution, PrintedGravity::velocity_no_gravity);
    // [RESOLVECOLLISIONS:4-5]
    // [RESOLVECOLLISIONS:6]
    // and put all bodies back.
    stage.objects.revert_to_original_positions(stage.world);
    // [RESOLVECOLLISIONS:6]
  }
  // [RESOLVECOLLISIONS:7]
  // Velocities have changed and nothing else.
  return;
  // [RESOLVECOLLISIONS:7]
}

void resolve_contacts_as_printed(PrintedStage& stage) {
  const int first = stage.loop_base;
  // [RESOLVECONTACTS:1]
  // For a fixed number of passes:
  for (int i = first; i < first + stage.passes; ++i) {
    // [RESOLVECONTACTS:1]
    // [RESOLVECONTACTS:2-3]
    // move all bodies as if nothing were in their way, and see which overlap;
    integrate_object_positions(stage, PrintedGravity::velocity_plus_gravity);
    gather_collisions(stage);
    // [RESOLVECONTACTS:2-3]
    const double restitution =
        stage.elastic ? 1.0 : restitution_of_pass(i, stage.passes, stage.collide.repaired);
    // [RESOLVECONTACTS:4-5]
    // let each of these pairs collide with gravity, a little more of it at each pass;
    for (const Contact& c : stage.collisions)
      collide(stage, c, restitution, PrintedGravity::velocity_plus_gravity);
    // [RESOLVECONTACTS:4-5]
    // [RESOLVECONTACTS:6]
    // and put all bodies back.
    stage.objects.revert_to_original_positions(stage.world);
    // [RESOLVECONTACTS:6]
  }
  // [RESOLVECONTACTS:7]
  // Velocities have changed and nothing else.
  return;
  // [RESOLVECONTACTS:7]
}

}  // namespace tumble
