/// \file
/// \brief Rules for halving a step (thesis 6.3.1).
#include "tumble/filtering/adaptive_step.hpp"

#include "filtering/adaptive_cases.hpp"
#include "support/runs.hpp"
#include "support/test.hpp"

using namespace tumble::adaptive_cases;

namespace {

// Performs a prescribed change and reports contacts of some bodies with the ground, the last body.
class Scripted : public Cloned<Technique, Scripted> {
 public:
  // Changes a world in the sub-step of this number, from 0; returns the bodies on the ground.
  using Script = std::function<std::vector<int>(World&, int, StepReport&)>;
  explicit Scripted(Script script) : script_(std::move(script)) {}
  [[nodiscard]] std::string_view name() const override { return "scripted"; }
  StepReport step(World& world, double dt) override {
    StepReport report;
    contacts_.clear();
    for (const int body : script_(world, done_++, report)) {
      contacts_.emplace_back();
      contacts_.back().first = world.ids()[idx(body)];
      contacts_.back().second = world.ids().back();
    }
    world.finish_step(dt);
    return report;
  }
  [[nodiscard]] std::span<const ContactRecord> contacts() const override { return contacts_; }

 private:
  Script script_;
  int done_ = 0;
  std::vector<ContactRecord> contacts_;
};

// Two cubes of 0.2 m without weight, far from each other and from the ground.
World resting_cubes() {
  World world = one_cube(Vec3::Zero());
  world.add(box_properties(Vec3::Constant(0.2), 1.0), Vec3(3.0, 5.0, 0.0));
  world.add_ground();
  world.gravity_w = Vec3::Zero();
  return world;
}

// Sub-steps in the last of some steps with resting cubes.
std::size_t substeps_after(int steps, Scripted::Script script,
                           const AdaptiveStepOptions& options = {}) {
  World world = resting_cubes();
  AdaptiveStep adaptive(std::make_unique<Scripted>(std::move(script)), options);
  run(world, adaptive, steps);
  return adaptive.substeps().size();
}

// Length of the first sub-step with damped integration [s].
double first_substep(World world) {
  AdaptiveStep adaptive(make("damped"));
  adaptive.step(world, kStep);
  return adaptive.substeps()[0];
}

}  // namespace

TEST_CASE("A body that flies alone takes whole steps however fast it is", "[unit][filtering]") {
  World world = one_cube(Vec3(300.0, 0.0, 0.0), Vec3(50.0, 0.0, 0.0));
  world.add(box_properties(Vec3::Ones(), 1.0), Vec3(0.0, 5.0, 9.0));
  AdaptiveStep adaptive(make("damped"));
  for (int k = 0; k < 60; ++k) {
    adaptive.step(world, kStep);
    REQUIRE(adaptive.substeps().size() == 1);
  }
}

TEST_CASE("A step is halved until near bodies move by a fifth of the thinner one",
          "[exact][filtering]") {
  // The plank is 0.05 m thick, so that 0.01 m are allowed. Weightless.
  const auto towards_plank = [](double speed) {
    World world = one_cube(Vec3(speed, 0.0, 0.0));
    world.gravity_w = Vec3::Zero();
    world.add(fixed_box_properties(Vec3(0.05, 2.0, 2.0)), Vec3(0.126, 5.0, 0.0));
    return first_substep(world);
  };
  // 0.01 m in a step are 0.6 m/s.
  CHECK(towards_plank(0.59) == kStep);
  CHECK(towards_plank(0.61) == kStep / 2.0);
  CHECK(towards_plank(1.19) == kStep / 2.0);
  CHECK(towards_plank(1.21) == kStep / 4.0);
  CHECK(towards_plank(100.0) == kStep / 16.0);
}

TEST_CASE("A step is halved until a near body turns by a tenth of a radian", "[exact][filtering]") {
  const auto beside_wall = [](double spin) {
    World world = one_cube(Vec3::Zero(), Vec3(spin, 0.0, 0.0));
    world.gravity_w = Vec3::Zero();
    world.add(fixed_box_properties(Vec3(0.2, 2.0, 2.0)), Vec3(0.21, 5.0, 0.0));
    return first_substep(world);
  };
  CHECK(beside_wall(5.9) == kStep);  // 0.0983 rad
  CHECK(beside_wall(6.1) == kStep / 2.0);
  CHECK(beside_wall(12.1) == kStep / 4.0);
}

TEST_CASE("A thin plank stops at divided steps a body that passes through it at whole ones",
          "[unit][filtering]") {
  const auto end = [](int most) {
    World world = one_cube(Vec3(40.0, 0.0, 0.0));
    BodyState plank;
    plank.position_w = Vec3(1.0, 5.0, 0.0);  // [m] 40 m/s are 0.67 m in a step
    world.add(fixed_box_properties(Vec3(0.05, 9.0, 9.0)), plank);
    AdaptiveStep adaptive(make("damped"), halvings(most));
    run(world, adaptive, 6);
    return world.states()[0].position_w.x();
  };
  CHECK(end(0) > 3.0);
  CHECK(end(4) < 1.0);
}

TEST_CASE("Halvings are undone when nothing requests them any more", "[unit][filtering]") {
  // A cube falls flat on the ground and rests there.
  World world = one_cube(Vec3(0.0, -9.0, 0.0));
  world.add_ground();
  AdaptiveStep adaptive(make("damped"));
  std::size_t most = 0;
  std::size_t touched = 0;
  for (int k = 0; k < 90; ++k) {
    adaptive.step(world, kStep);
    // Touched bodies were in contact in any sub-step, and are listed once.
    touched = std::max(touched, adaptive.touched().size());
    if (!adaptive.contacts().empty()) REQUIRE(adaptive.touched().size() == 2);
    most = std::max(most, adaptive.substeps().size());
  }
  CHECK(touched == 2);
  CHECK(most >= 4);  // measured 5
  CHECK(adaptive.substeps().size() == 1);
}

TEST_CASE("Gravity counts in the predicted approach to a fixed body", "[exact][filtering]") {
  // 0.04 m are allowed: 2.4 m/s in a step. Gravity adds 0.16 m/s, but not between two that fall.
  const auto towards_cube = [](double speed, bool fixed) {
    World world = one_cube(Vec3(0.0, -speed, 0.0));
    world.add(fixed ? fixed_box_properties(Vec3::Constant(0.2))
                    : box_properties(Vec3::Constant(0.2), 1.0),
              Vec3(0.0, 4.79, 0.0));
    return first_substep(world);
  };
  CHECK(towards_cube(2.2, true) == kStep);
  CHECK(towards_cube(2.3, true) == kStep / 2.0);
  CHECK(towards_cube(2.3, false) == kStep);
  CHECK(towards_cube(2.5, false) == kStep / 2.0);
}

TEST_CASE("A corner that reverses by more than its tolerance requests smaller steps",
          "[unit][filtering]") {
  const auto substeps = [](double shake) {
    const auto shaken = [](World& bodies, int n, StepReport&) {
      bodies.states()[0].position_w.y() += n % 2 == 0 ? 1e-3 : -1e-3;  // 5e-3 of an edge
      return std::vector<int>{0};
    };
    return substeps_after(10, shaken, {.shake = shake});
  };
  CHECK(substeps(4.9e-3) == 16);
  CHECK(substeps(5.1e-3) == 1);
  CHECK(substeps(kInfinity) == 1);
}

TEST_CASE("Reversals are found body by body, independent of other bodies in contact",
          "[unit][filtering]") {
  // The second cube moves there and back; the first one touches only in the first step, or in both.
  for (const bool both : {false, true}) {
    World world = resting_cubes();
    AdaptiveStep adaptive(std::make_unique<Scripted>([&](World& bodies, int n, StepReport&) {
      if (n < 2) bodies.states()[1].position_w.y() += n == 0 ? 1e-3 : -1e-3;
      return n == 0 || both ? std::vector<int>{0, 1} : std::vector<int>{1};
    }));
    adaptive.step(world, kStep);
    adaptive.step(world, kStep);
    CHECK(adaptive.substeps().size() == 1);
    adaptive.step(world, kStep);
    CHECK(adaptive.substeps().size() == 2);
  }
  // One moves there, the other one back.
  const auto in_turn = [](World& bodies, int n, StepReport&) {
    bodies.states()[n % 2 == 0 ? 0 : 1].position_w.y() += n % 2 == 0 ? 1e-3 : -1e-3;
    return std::vector<int>{n % 2 == 0 ? 0 : 1};
  };
  CHECK(substeps_after(6, in_turn) == 1);
}

TEST_CASE("Overlap above a fiftieth of an edge requests smaller steps", "[exact][filtering]") {
  const auto substeps = [](double overlap) {
    return substeps_after(10, [=](World&, int, StepReport& report) {
      report.deepest_overlap = overlap;
      return std::vector<int>{};
    });
  };
  CHECK(substeps(3.9e-3) == 1);  // 4 mm are allowed
  CHECK(substeps(4.1e-3) == 16);
}

TEST_CASE("One halving at a time is undone after four quiet steps", "[exact][filtering]") {
  World world = resting_cubes();
  AdaptiveStep adaptive(std::make_unique<Scripted>([](World&, int n, StepReport& report) {
                          report.deepest_overlap = n < 2 ? 1.0 : 0.0;
                          return std::vector<int>{};
                        }),
                        halvings(2));
  std::vector<std::size_t> counts;
  for (int k = 0; k < 11; ++k) {
    adaptive.step(world, kStep);
    counts.push_back(adaptive.substeps().size());
  }
  // Two requests, in the first step and in the first half of the second one, which continues in
  // quarters. Quiet begins in its middle; a longer sub-step begins where it is aligned.
  CHECK(counts == std::vector<std::size_t>{1, 3, 4, 4, 4, 3, 2, 2, 2, 2, 1});
}
