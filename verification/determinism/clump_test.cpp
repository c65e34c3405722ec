/// \file
/// \brief The layers together: the same bits on every build.
#include "tumble/contact/impacts.hpp"
#include "tumble/contact/repair.hpp"
#include "tumble/contact/sleeping.hpp"
#include "tumble/contact/sticky.hpp"
#include "tumble/dynamics/advance_pose.hpp"

#include "support/test.hpp"

namespace {

constexpr double kMargin = 1e-3;  // [m] how far apart surfaces still count as touching

// Steps bodies with every layer once: broad phase, contacts, impacts, flight, repair, sleep.
//
// It is no technique of the thesis and none that a user should want: speeds first, then contacts
// as collisions one after the other, then positions, then whatever overlaps is pushed apart.
class LayerStepper : public Technique {
 public:
  explicit LayerStepper(std::string_view broad_phase = "bounding_tree")
      : broad_phase_(make_broad_phase(broad_phase)) {}

  [[nodiscard]] std::string_view name() const override { return "layers"; }
  StepReport step(World& world, double dt) override {
    StepReport report;
    sleeping_.wake_disturbed(world);

    // Gravity, on bodies that are awake.
    for (int i = 0; i < world.count(); ++i) {
      const auto k = idx(i);
      if (world.bodies()[k].movable() && !world.sleep_states()[k].asleep)
        world.states()[k].linear_momentum_w += dt * world.bodies()[k].mass * world.gravity_w;
    }

    do {
      find_contacts(world, kMargin, report);
    } while (sleeping_.wake_touched(world, contacts_) > 0);
    collide(world, dt, report);

    // Positions.
    for (int i = 0; i < world.count(); ++i) {
      const auto k = idx(i);
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
  [[nodiscard]] std::unique_ptr<Technique> clone() const override { return nullptr; }  // not needed

 private:
  void find_contacts(World& world, double margin, StepReport& report) {
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

  void collide(World& world, double dt, StepReport& report) {
    for (Contact& contact : contacts_) {
      double fastest = 0.0;
      for (int p = 0; p < contact.count; ++p)
        fastest = std::min(fastest, contact.points[idx(p)].approach_speed);
      const BodyProperties& body = world.bodies()[static_cast<std::size_t>(contact.second)];
      const StickyScale scale{world.gravity_w.norm(), body.size.minCoeff(), dt};
      contact.restitution =
          sticky_restitution(contact.restitution, fastest, scale, StickyOptions{});
    }
    const ImpactResult result = impacts_.resolve(contacts_, moving_, {.most_passes = 6});
    store_moving_bodies(moving_, world);
    report.energy.restitution += result.restitution_energy;
    report.energy.friction += result.friction_energy;
    report.impulses += result.impulses;
    report.iterations += result.passes;
  }

  std::unique_ptr<BroadPhase> broad_phase_;
  SleepingRule sleeping_;
  OverlapRepair repair_;
  ImpactSolver impacts_;
  Islands islands_;
  ContactList contacts_;
  ContactList previous_;
  std::vector<MovingBody> moving_;
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> pairs_;
  std::vector<IndexPair> candidates_;
};

// A clump of tumbling, bouncing boxes of several sizes over the ground.
World bouncing_clump(int per_edge) {
  World world = ground_world(0.5, 0.3);
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

std::string hash_after(World world, Technique& technique, int steps, double dt) {
  for (int k = 0; k < steps; ++k) technique.step(world, dt);
  return world.hash().text();
}

}  // namespace

TEST_CASE("A bouncing clump of 8 boxes has the golden hash after 1000 steps",
          "[determinism][golden][clump]") {
  // Committed once; the same for g++ and clang++ at -O0 and -O3. If a change to the layers is meant
  // to change bits, say so in CHANGELOG.md under "Changed numbers" and put the new value here.
  const std::string golden = "1c1d681af26c79fc";
  LayerStepper stepper;
  CHECK(hash_after(bouncing_clump(2), stepper, 1000, 1.0 / 60.0) == golden);
}

TEST_CASE("A bouncing clump of 27 boxes has its golden hash after 1000 steps",
          "[determinism][clump]") {
  // Larger, and so for optimised builds only: without optimisation it takes five minutes.
  LayerStepper stepper;
  CHECK(hash_after(bouncing_clump(3), stepper, 1000, 1.0 / 60.0) == "1664464225bfb293");
}

TEST_CASE("A bouncing clump settles on the ground and loses energy on the way", "[unit][clump]") {
  // So that the golden hash is that of boxes that do what boxes do.
  World world = bouncing_clump(3);
  const double start = energy_of(world).total();
  LayerStepper stepper;
  for (int k = 0; k < 1000; ++k) stepper.step(world, 1.0 / 60.0);
  CHECK(energy_of(world).total() < 0.5 * start);
  int low = 0;
  for (const BodyState& state : world.states()) {
    REQUIRE(state.position_w.allFinite());
    if (state.position_w.y() > -0.1 && state.position_w.y() < 4.0) ++low;
  }
  CHECK(low == world.count());
}

TEST_CASE("Any broad phase gives the same bits", "[determinism][clump]") {
  LayerStepper reference("all_pairs");
  const std::string expected = hash_after(bouncing_clump(3), reference, 150, 1.0 / 60.0);
  for (const std::string_view name : broad_phase_names()) {
    INFO(name);
    LayerStepper stepper(name);
    CHECK(hash_after(bouncing_clump(3), stepper, 150, 1.0 / 60.0) == expected);
  }
}
