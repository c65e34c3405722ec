/// \file
/// \brief Worlds of boxes whose contact forces and impacts are known in closed form: tipping, leaning,
///        rocking, Newton's cradle.
#include "analytic_lcp/instant.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

using namespace tumble;
using namespace tumble::test;

namespace {

// Widths and heights of blocks.
constexpr std::array<std::pair<double, double>, 3> kBlocks{{{1.0, 2.0}, {0.5, 2.0}, {1.0, 1.0}}};

// A block of 2 kg on the ground.
Instant block_on_ground(double width, double height) {
  World world;
  world.add_ground();
  add_box(world, Vec3(width, height, 1.0), 2.0, Vec3(0, 0.5 * height, 0));
  return Instant(world);
}

// A force on a body at a point, in place of friction or of a hand.
void pull(Instant& instant, int body, const Vec3& force_w, const Vec3& point_w) {
  instant.external[idx(body)].force_w += force_w;
  instant.external[idx(body)].torque_w +=
      (point_w - instant.bodies[idx(body)].position_w).cross(force_w);
}

// A millionth below its threshold a block does not turn, a millionth above it does.
void check_threshold(Instant (*load)(double width, double height, double share)) {
  for (const auto& [width, height] : kBlocks) {
    for (const double share : {1.0 - 1e-6, 1.0 + 1e-6}) {
      Instant block = load(width, height, share);
      block.solve();
      const double turning = block.accelerations.back().angular_w.norm();  // [rad/s²]
      if (share < 1.0) CHECK(turning < 1e-12);                             // measured 7e-15
      if (share > 1.0) CHECK(turning > 1e-7);                              // measured 6e-6
    }
  }
}

}  // namespace

// --- tipping ------------------------------------------------------------------------------------

TEST_CASE("A block that cannot slide tips on a slope from the angle atan(w/h) on",
          "[exact][assembly][analytic_lcp]") {
  // Written down in degrees; a millionth of its tangent is what differs.
  CHECK(std::atan2(1.0, 2.0) * 180.0 / std::numbers::pi == Approx(26.5650511771).epsilon(1e-11));
  CHECK(std::atan2(0.5, 2.0) * 180.0 / std::numbers::pi == Approx(14.0362434679).epsilon(1e-11));
  check_threshold([](double width, double height, double share) {
    const double slope = std::atan2(share * width, height);
    const Quat tilt = about(Vec3::UnitZ(), -slope);
    World world;
    add_fixed(world, Vec3(20, 1, 5), tilt * Vec3(0, -0.5, 0), tilt);
    add_box(world, Vec3(width, height, 1.0), 2.0, tilt * Vec3(0, 0.5 * height, 0), tilt);
    Instant block(world);
    pull(block, 1, tilt * Vec3(-2.0 * kG * std::sin(slope), 0, 0), Vec3::Zero());
    return block;
  });
}

TEST_CASE("A push at the top edge tips a block that cannot slide from m g w / 2h on",
          "[exact][assembly][analytic_lcp]") {
  check_threshold([](double width, double height, double share) {
    Instant block = block_on_ground(width, height);
    const Vec3 push(share * 2.0 * kG * width / (2.0 * height), 0, 0);
    pull(block, 1, push, Vec3(-0.5 * width, height, 0));
    pull(block, 1, -push, Vec3::Zero());
    return block;
  });
}

TEST_CASE("A block on ground that accelerates tips from the acceleration g w / h on",
          "[exact][assembly][analytic_lcp]") {
  check_threshold([](double width, double height, double share) {
    Instant block = block_on_ground(width, height);
    pull(block, 1, Vec3(share * 2.0 * kG * width / height, 0, 0), Vec3::Zero());
    return block;
  });
}

// --- leaning ------------------------------------------------------------------------------------

// --- impacts ------------------------------------------------------------------------------------
