/// \file
/// \brief Impacts of boxes of rods, and stiffness of rods (thesis 2.3).
#include "tumble/previous_work/rods.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

// Speeds after each step of something that falls on the ground.
struct Fall {
  std::vector<double> speeds;  // [m/s]
  double before = 0.0;         // [m/s] of the last step without contact
  double after = 0.0;          // [m/s] largest, from two steps after the first contact on
  int hit = -1;                // the step of the first contact

  void add(double speed, bool touches) {
    const int step = static_cast<int>(speeds.size());
    speeds.push_back(speed);
    if (hit < 0 && touches) hit = step;
    if (hit < 0) before = speed;
    if (hit >= 0 && step >= hit + 2) after = std::max(after, speed);
  }
  [[nodiscard]] double share() const { return after / before; }
};

constexpr int kFallSteps = 60;

// A cube of 1 kg that falls flat on the ground, from its own height above it.
Fall box_falls(int passes) {
  PlayedScene run(make_scene("bouncing_box", {"height=1", "restitution=0"}),
                  PlayedTechnique{"relaxation", {"passes=" + std::to_string(passes)}});
  Fall fall;
  for (int k = 0; k < kFallSteps; ++k) {
    const StepReport report = run.step();
    fall.add(BodyView(run.world(), 1).velocity_w().norm(), report.impulses > 0);
  }
  return fall;
}

// One particle, moved up to the ground where it is below.
Fall ball_falls() {
  RodParticles ball{{Vec3(0.0, 1.0, 0.0)}, {Vec3(0.0, 1.0, 0.0)}, {1.0}, {}};
  Fall fall;
  for (int k = 0; k < kFallSteps; ++k) {
    ball.advance(Vec3(0.0, -kGravity, 0.0), kStep);
    const bool below = ball.now_w[0].y() < 0.0;
    if (below) ball.now_w[0].y() = 0.0;
    fall.add((ball.now_w[0] - ball.before_w[0]).norm() / kStep, below);
  }
  return fall;
}

// A chain of ten rods of 0.1 m that hangs from its first particle.
// Returns [-] how much longer it is than its rods, at most in the last of ten seconds
double chain_stretch(int passes, double dt) {
  constexpr int kRods = 10;
  constexpr double kRod = 0.1;  // [m]
  RodParticles chain;
  for (int k = 0; k <= kRods; ++k) {
    chain.now_w.emplace_back(0.0, -kRod * k, 0.0);
    chain.inverse_mass.push_back(k == 0 ? 0.0 : 1.0);
    if (k > 0) chain.rods.push_back({k - 1, k, kRod});
  }
  chain.before_w = chain.now_w;
  double longest = 0.0;
  const int steps = static_cast<int>(std::lround(10.0 / dt));
  for (int step = 0; step < steps; ++step) {
    chain.advance(Vec3(0.0, -kGravity, 0.0), dt);
    for (int pass = 0; pass < passes; ++pass) chain.relax();
    if (dt * step >= 9.0) longest = std::max(longest, -chain.now_w.back().y());
  }
  return longest / (kRods * kRod) - 1.0;
}

// What two boxes that meet in free space keep.
struct Meeting {
  double momentum = 0.0;  // [-] change over that of one box
  double energy = 0.0;    // [-] left
};

Meeting boxes_meet() {
  PlayedScene run(make_scene("two_boxes"), PlayedTechnique{"relaxation"});
  const Vec3 before_w = linear_momentum(run.world());
  const double energy = energy_of(run.world()).total();
  run.advance(1.0);
  return {(linear_momentum(run.world()) - before_w).norm() / before_w.norm(),
          energy_of(run.world()).total() / energy};
}

// A cube that spins in free space [-], what it has of its angular momentum after a second.
double spin_left(int passes) {
  Scene scene{.gravity_w = Vec3::Zero()};
  scene.boxes.emplace_back();
  scene.boxes[0].angular_velocity_w = Vec3(1.0, 4.0, 2.0);
  PlayedScene run(scene, PlayedTechnique{"relaxation", {"passes=" + std::to_string(passes)}});
  const double before = run.world().states()[0].angular_momentum_w.norm();
  run.advance(1.0);
  return run.world().states()[0].angular_momentum_w.norm() / before;
}

Result measure_relaxation(const Parameters& settings) {
  const Fall box = box_falls(10);
  const Fall hasty = box_falls(4);
  const Fall ball = ball_falls();
  Result result;
  result.tables.push_back(Table{"",
                                {{"time_s", "s", "from the start"},
                                 {"box", "m/s", "speed of the centre of a box of rods, ten passes"},
                                 {"hasty", "m/s", "the same with four passes"},
                                 {"ball", "m/s", "a ball of one particle"}}});
  for (std::size_t k = 0; k < box.speeds.size(); ++k)
    result.tables[0].add(kStep * static_cast<double>(k + 1), box.speeds[k], hasty.speeds[k],
                         ball.speeds[k]);
  Table chain{"chain",
              {{"passes", "-", "over all rods in a step"},
               {"at_30", "-", "stretch of a hanging chain of ten rods, steps of 1/30 s"},
               {"at_60", "-", "the same with 1/60 s"},
               {"at_120", "-", "the same with 1/120 s"}}};
  for (const int passes : {1, 2, 4, 8, 16, 32, 64}) {
    if (passes > settings.count("passes")) break;
    chain.add(passes, chain_stretch(passes, 1.0 / 30), chain_stretch(passes, 1.0 / 60),
              chain_stretch(passes, 1.0 / 120));
  }
  result.tables.push_back(chain);
  result.add("speed after the impact over the speed before it, of a box of rods that lands flat",
             "-", box.share());
  result.add("the same with four passes", "-", hasty.share());
  result.add("the same with one pass", "-", box_falls(1).share());
  result.add("the same for a ball of one particle", "-", ball.share());
  const Meeting meeting = boxes_meet();
  result.add("change of momentum of two boxes that meet", "-", meeting.momentum);
  result.add("energy that they have left", "-", meeting.energy);
  result.add("angular momentum that a spinning box has left after a second", "-", spin_left(10));
  result.add("stretch of a hanging chain, four passes at 1/60 s", "-", chain_stretch(4, 1.0 / 60));
  result.add("the same at 1/120 s", "-", chain_stretch(4, 1.0 / 120));
  return result;
}

const Registered relaxation_figure{
    {.name = "claim_2_3a_relaxation",
     .parameters = {whole("passes", 64, 1, 64, "over the rods of a chain at most")},
     .quick = {"passes=4"},
     .experiment = measure_relaxation}};

}  // namespace
}  // namespace tumble::chapters
