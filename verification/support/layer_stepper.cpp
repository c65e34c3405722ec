/// \file
/// \brief The layers, one after the other.
#include "support/layer_stepper.hpp"

#include "tumble/base/random.hpp"
#include "tumble/dynamics/advance_pose.hpp"

#include <algorithm>
#include <limits>

namespace tumble::test {
namespace {

constexpr double kMargin = 1e-3;  // [m] how far apart surfaces still count as touching

}  // namespace

LayerStepper::LayerStepper(std::string_view broad_phase)
    : broad_phase_(make_broad_phase(broad_phase)) {}

LayerStepper::LayerStepper(const LayerStepper& other)
    : Technique(other),
      broad_phase_(other.broad_phase_->clone()),
      sleeping_(other.sleeping_),
      repair_(other.repair_),
      impacts_(other.impacts_),
      islands_(other.islands_),
      contacts_(other.contacts_),
      previous_(other.previous_) {}

std::unique_ptr<Technique> LayerStepper::clone() const {
  return std::make_unique<LayerStepper>(*this);
}

StepReport LayerStepper::step(World& world, double dt) {
  StepReport report;
  sleeping_.wake_disturbed(world);

  // Gravity, on bodies that are awake.
  for (int i = 0; i < world.count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (world.bodies()[k].movable() && !world.sleep_states()[k].asleep)
      world.states()[k].linear_momentum_w += dt * world.bodies()[k].mass * world.gravity_w;
  }

  do {
    find_contacts(world, kMargin, report);
  } while (sleeping_.wake_touched(world, contacts_) > 0);
  collide(world, dt, report);

  // Positions.
  for (int i = 0; i < world.count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!world.bodies()[k].movable() || world.sleep_states()[k].asleep) continue;
    advance_pose(world.bodies()[k], world.states()[k], dt, RotationRule::splitting);
    ++report.integrations;
  }

  const RepairReport repaired = repair_.run(world, candidates_);
  report.energy.repair += repaired.energy;
  report.pair_tests += repaired.pair_tests;

  islands_.build(world.bodies(), contacts_);
  report.energy.damping += sleeping_.update(world, contacts_, islands_, dt).energy;
  world.finish_step(dt);
  return report;
}

void LayerStepper::find_contacts(World& world, double margin, StepReport& report) {
  const auto bodies = world.bodies();
  bounds_.resize(bodies.size());
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].shape == Shape::ground) {
      const double far = std::numeric_limits<double>::infinity();
      bounds_[k] = Bounds{Vec3(-far, -far, -far), Vec3(far, margin, far)};
    } else {
      bounds_[k] = bounds_of(box_of(bodies[k], world.states()[k]), 0.1);
    }
  }
  broad_phase_->find_pairs(bounds_, pairs_);
  candidates_.clear();
  for (const IndexPair& pair : pairs_)
    if (sleeping_.needs_test(pair.first, pair.second)) candidates_.push_back(pair);
  load_moving_bodies(world, moving_);
  std::swap(previous_, contacts_);
  const GatherReport found =
      gather_contacts(world, moving_, candidates_, margin, previous_, contacts_);
  report.pair_tests += found.pair_tests;
  report.contacts = found.points;
  report.deepest_overlap = std::max(report.deepest_overlap, found.deepest_overlap);
}

void LayerStepper::collide(World& world, double dt, StepReport& report) {
  for (Contact& contact : contacts_) {
    double fastest = 0.0;
    for (int p = 0; p < contact.count; ++p)
      fastest = std::min(fastest, contact.points[static_cast<std::size_t>(p)].approach_speed);
    const BodyProperties& body = world.bodies()[static_cast<std::size_t>(contact.second)];
    const StickyScale scale{world.gravity_w.norm(), body.size.minCoeff(), dt};
    contact.restitution = sticky_restitution(contact.restitution, fastest, scale, StickyOptions{});
  }
  const ImpactResult result = impacts_.resolve(contacts_, moving_, {.most_passes = 6});
  store_moving_bodies(moving_, world);
  report.energy.restitution += result.restitution_energy;
  report.energy.friction += result.friction_energy;
  report.impulses += result.impulses;
  report.iterations += result.passes;
}

World bouncing_clump(int per_edge) {
  World world;
  world.add_ground(0.5, 0.3);
  Random random(20030501);
  for (int k = 0; k < per_edge * per_edge * per_edge; ++k) {
    const Vec3 cell(k % per_edge, k / (per_edge * per_edge), k / per_edge % per_edge);
    Vec3 size = Vec3::Constant(0.8) + random.in_cube(0.3);
    const Vec3 place = 1.9 * cell + Vec3(0.0, 1.2, 0.0);
    const Quat turn = random.orientation();
    const Vec3 velocity_w = random.in_cube(2.0);
    const Vec3 spin_w = random.in_cube(3.0);
    world.add(box_properties(size, size.prod(), 0.5, 0.3), place, turn, velocity_w, spin_w);
  }
  return world;
}

}  // namespace tumble::test
