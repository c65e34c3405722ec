/// \file
/// \brief Housner's rocking block with contact_damped, and the rocking block of Siconos' examples.

#include "contact_damped/helpers.hpp"
#include "support/pose.hpp"
#include "support/shared_data.hpp"
#include "support/test.hpp"

#include <fstream>

namespace {

// Exact values for a block that is released at a tilt: Housner's model with the pendulum's true
// period, computed with elliptic integrals.
struct Rocking {
  const char *width, *height, *tilt;
  double alpha;    // [rad] angle of the diagonal
  double quarter;  // [s] until it is upright
  double omega;    // [rad/s] just before that
  double eta;      // [-] angular velocity after over before the impact
  double next;     // [-] next largest tilt, over alpha
};

constexpr Rocking kBlocks[] = {
    {"0.4", "2", "0.25", 0.1973955598, 0.296721333232, 0.349808550781, 0.942307692308,
     0.218039206964},
    {"0.4", "2", "0.5", 0.1973955598, 0.490864457850, 0.458239851116, 0.942307692308,
     0.422193453732},
    {"0.4", "2", "0.9", 0.1973955598, 1.11470531546, 0.526683106277, 0.942307692308,
     0.652697231070},
    {"1", "2", "0.5", 0.463647609, 0.516630152218, 1.01853463091, 0.7, 0.206300720985},
    {"1", "1", "0.5", 0.7853981634, 0.415785666388, 2.12392891316, 0.25, 0.0246353648061},
};

// [-] A tilt of less than this share of the diagonal's angle counts as upright.
constexpr double kUpright = 1e-4;

struct Seen {
  double quarter = 0.0;  // [s]
  double before = 0.0;   // [rad/s] largest speed of turning until it is upright
  double after = 0.0;    // [rad/s] largest after it
  double next = 0.0;     // [rad] largest tilt to the other side
};

// The block falls from a tilt to the left and rises to the right until it turns back.
Seen rock(const Rocking& block, double dt) {
  World world = world_of(
      "rocking_block",
      {{"width", block.width}, {"height", block.height}, {"tilt", block.tilt}, {"friction", "2"}});
  const std::unique_ptr<Technique> technique = contact_damped();
  Seen seen;
  double before = 1.0;
  for (double time = dt; time < 3.0; time += dt) {
    technique->step(world, dt);
    const double tilt = rotation_vector(world.body("block").state().orientation_wb).z();
    const double omega = -world.body("block").angular_velocity_w().z();
    if (seen.quarter == 0.0) {
      if (tilt > kUpright * block.alpha) {
        seen.before = std::max(seen.before, omega);
        before = tilt;
        continue;
      }
      const double part = before / std::max(before - tilt, 1e-300);
      seen.quarter = time - dt + part * dt;
      continue;  // the step of the impact
    }
    // An impact takes two steps where the turn of the first one ends just beyond upright.
    if (tilt < -2.0 * kUpright * block.alpha) seen.after = std::max(seen.after, omega);
    seen.next = std::max(seen.next, -tilt);
    if (omega < 0.0) break;  // it turns back
  }
  return seen;
}

}  // namespace

TEST_CASE("A rocking block falls in the time of a compound pendulum", "[exact][contact_damped]") {
  BOTH_POSES;
  for (const Rocking& block : kBlocks) {
    INFO(block.width << " by " << block.height << ", tilt " << block.tilt);
    const Seen coarse = rock(block, kFrame);
    const Seen fine = rock(block, kFrame / 16.0);
    // [s] One step: the semi-implicit rule is ahead by half a step, the impact is found to one.
    CHECK(std::abs(coarse.quarter - block.quarter) < kFrame);
    CHECK(std::abs(fine.quarter - block.quarter) < kFrame / 16.0);
    CHECK(std::abs(fine.before / block.omega - 1.0) < 0.02);  // [-] a step before the impact
  }
}

TEST_CASE("The impact of a rocking block leaves Housner's share of its speed",
          "[exact][contact_damped]") {
  BOTH_POSES;
  for (const Rocking& block : kBlocks) {
    for (const double dt : {kFrame, kFrame / 64.0}) {
      const Seen seen = rock(block, dt);
      // Three steps of the block's weight are what a step's length can cost, each p² sin(alpha) h:
      // one before the impact, one after it, and half a step on each side that the semi-implicit
      // rule is off. The next tilt follows from cos(alpha - tilt) = cos(alpha) + omega²/(2 p²).
      const double radius = 0.5 * std::hypot(std::stod(block.width), std::stod(block.height));
      const double p2 = 3.0 * kGravity / (4.0 * radius);
      const double lost = 3.0 * p2 * std::sin(block.alpha) * dt;  // [rad/s]
      const double left = block.eta * block.omega;
      const auto tilt_from = [&](double omega) {
        const double height = std::cos(block.alpha) + 0.5 * omega * omega / p2;
        return 1.0 - std::acos(std::min(height, 1.0)) / block.alpha;
      };
      REQUIRE(std::abs(tilt_from(left) - block.next) < 1e-6);
      const double low = tilt_from(std::max(left - lost, 0.0));
      const double high = tilt_from(left + lost);
      INFO(block.width << " by " << block.height << ", tilt " << block.tilt << ", "
                       << std::lround(1.0 / dt) << " steps a second: " << seen.next / block.alpha
                       << " in " << low << " to " << high);
      CHECK(seen.next / block.alpha > low - 1e-3);
      CHECK(seen.next / block.alpha < high + 1e-3);
      // [-] From 3840 steps a second on both speeds are the exact ones within a per cent or two.
      if (dt < kFrame)
        CHECK(std::abs(seen.after / seen.before - block.eta) < 2.0 * lost / block.omega + 1e-3);
    }
  }
}

TEST_CASE("A flat block does not rock", "[exact][contact_damped]") {
  BOTH_POSES;
  // 1.5 by 1: with b/h above the root of 2 both edges are loaded in the impact and it stays down.
  const Rocking flat = {"1.5", "1", "0.3", 0.9827937232, 0.0, 0.0, 0.0, 0.0};
  CHECK(rock(flat, kFrame).next < 1e-3);         // [rad]
  CHECK(rock(flat, kFrame / 16.0).next < 1e-3);  // [rad]
}

TEST_CASE("A block falls over if it is pushed faster than its centre needs to pass its edge",
          "[exact][contact_damped]") {
  BOTH_POSES;
  struct Case {
    const char *width, *height;
    double least;  // [rad/s] sqrt(3 g (1 - cos alpha)/(2 R))
  };
  for (const Case& c : {Case{"0.5", "2", 0.652866850845}, Case{"1", "2", 1.17876889828},
                        Case{"1", "1", 2.46883627856}}) {
    for (const double share : {0.95, 1.05}) {
      World world =
          world_of("rocking_block",
                   {{"width", c.width}, {"height", c.height}, {"tilt", "0"}, {"friction", "2"}});
      const Vec3 omega(0.0, 0.0, share * c.least);
      const BodyState start = world.body("block").state();
      const Vec3 from_edge = start.position_w - Vec3(-0.5 * std::stod(c.width), 0.0, 0.0);
      world.set_velocity(*world.find("block"), omega.cross(from_edge), omega);
      run(world, *contact_damped(), 4.0, kFrame / 4.0);
      const double tilt = rotation_vector(world.body("block").state().orientation_wb).z();
      INFO(c.width << " by " << c.height << " at " << share);
      // [rad] it rocks, or lies on its side
      if (share < 1.0) CHECK(std::abs(tilt) < std::atan2(std::stod(c.width), std::stod(c.height)));
      if (share > 1.0) CHECK(tilt > 1.5);
    }
  }
}

TEST_CASE("A block that bounces on its corners does what Siconos' event-driven run does at first",
          "[reference][contact_damped]") {
  BOTH_POSES;
  // The example's block is 0.2 by 0.1 m for its contacts and has the moment of inertia of one of 1
  // by 0.5 m; restitution 0.8, no friction. It falls on a corner without turning. Compared are the
  // first impact and when the second one comes. What follows hangs on levers of a few millimetres,
  // which a step of any length changes, and is not compared.
  const auto folder = shared_data("siconos-trajectories");
  if (!folder) return;
  std::ifstream in(*folder / "RockingBlockED_Lsodar_LZBimpact.ref");
  int rows = 0;
  int columns = 0;
  in >> rows >> columns;
  REQUIRE(columns == 13);
  std::vector<std::vector<double>> table;
  for (int row = 0; row < rows; ++row) {
    table.emplace_back(idx(columns));
    for (double& cell : table.back()) in >> cell;
  }
  REQUIRE(in);
  std::vector<std::size_t> impacts;  // rows after an impact: the time of the row before
  for (std::size_t row = 1; row < table.size() && impacts.size() < 2; ++row)
    if (table[row][0] == table[row - 1][0] && table[row][0] > 0.0) impacts.push_back(row);
  REQUIRE(impacts.size() == 2);
  const std::vector<double>& first = table[impacts[0]];
  const std::vector<double>& second = table[impacts[1]];

  World world = ground_world(0.0, 0.8);
  BodyProperties block = box_properties(Vec3(0.2, 0.1, 1.0), 1.0, 0.0, 0.8);
  block.inertia_b.z() = (1.0 + 0.25) / 12.0;
  block.inverse_inertia_b.z() = 1.0 / block.inertia_b.z();
  const std::vector<double>& start = table.front();
  world.add(block,
            make_state(block, Vec3(start[1], start[2], 0.0),
                       rotation_from_vector(Vec3(0.0, 0.0, start[3]))),
            "block");
  const std::unique_ptr<Technique> technique = contact_damped();
  const double dt = kFrame / 16.0;
  double before = 0.0;
  std::vector<double> times;
  Vec3 after = Vec3::Zero();
  double spin = 0.0;
  while (times.size() < 2 && world.time() < 1.0) {
    technique->step(world, dt);
    const double now = world.body("block").velocity_w().y();
    if (before < 0.0 && now > 0.0) {  // it falls before an impact and rises after it
      times.push_back(world.time());
      if (times.size() == 1) after = world.body("block").velocity_w();
      if (times.size() == 1) spin = world.body("block").angular_velocity_w().z();
    }
    before = now;
  }
  REQUIRE(times.size() == 2);
  CHECK(std::abs(times[0] - first[0]) < 2.0 * dt);     // [s] a step of waiting, a step of the rule
  CHECK(std::abs(after.y() / first[5] - 1.0) < 0.02);  // [-] g h/v is 0.4 % for each step
  CHECK(std::abs(spin / first[6] - 1.0) < 0.02);
  CHECK(std::abs(times[1] - second[0]) < 0.02);  // [s] 2 v/g of 2 % of 2.4 m/s is 0.01
  CHECK(std::abs(after.x()) < 1e-12);            // [m/s] nothing pushes sideways
}
