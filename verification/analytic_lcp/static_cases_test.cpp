/// \file
/// \brief Worlds of boxes whose contact forces and impacts are known in closed form: tipping, leaning,
///        rocking, Newton's cradle.
#include "analytic_lcp/instant.hpp"
#include "support/touching.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

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

// An equality: the relative motion along x at a place stays 0, as with enough friction. The bodies are
// those of a row that there is already.
void hold_along_x(const Instant& instant, std::size_t contact_row, const Vec3& place_w,
                  LcpProblem& problem) {
  const Contact& contact = instant.contacts[idx(instant.problem.rows()[contact_row].contact)];
  LcpFactors::Row row = problem.factors.rows[contact_row];
  double motion = 0.0;  // without forces
  const auto set = [&](int body, const Vec3& along_w, Vec3& linear_w, Vec3& angular_w) {
    linear_w = along_w;
    angular_w = (place_w - instant.bodies[idx(body)].position_w).cross(along_w);
    const Acceleration& free = instant.accelerations[idx(body)];
    motion += linear_w.dot(free.linear_w) + angular_w.dot(free.angular_w);
  };
  if (row.first >= 0) set(contact.first, -Vec3::UnitX(), row.linear_first_w, row.angular_first_w);
  if (row.second >= 0)
    set(contact.second, Vec3::UnitX(), row.linear_second_w, row.angular_second_w);
  problem.factors.rows.push_back(row);
  multiply_out(problem.factors, problem.A);
  problem.equality.resize(idx(problem.size()), 0);
  problem.equality.push_back(1);
  problem.b.conservativeResize(problem.size() + 1);
  problem.b[problem.size() - 1] = motion;
}

// Impacts: impulses change velocities as forces do accelerations, so velocities take their place.
void assemble_impact(Instant& instant) {
  instant.accelerations.resize(instant.bodies.size());
  for (std::size_t k = 0; k < instant.bodies.size(); ++k) {
    MovingBody& body = instant.bodies[k];
    instant.accelerations[k] = {body.velocity_w, body.angular_velocity_w};
    body.velocity_w.setZero();
    body.angular_velocity_w.setZero();
  }
  instant.problem.assemble(instant.world, instant.bodies, instant.accelerations, instant.contacts,
                           kAll);
}

constexpr std::array<const char*, 3> kExact{"baraff", "lemke", "least_constraint"};

LcpResult solved_by(const char* name, const LcpProblem& problem) {
  LcpResult result;
  make_lcp_solver(name)->solve(problem, result);
  CHECK(result.status == LcpStatus::solved);
  return result;
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

TEST_CASE("A ladder on a smooth wall needs friction of 1 / (2 tan θ) at its foot",
          "[exact][assembly][analytic_lcp]") {
  for (const auto& [degrees, friction] :
       {std::pair(59.0362434679, 0.3), std::pair(45.0, 0.5), std::pair(75.0, 0.133974596215561)}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const Vec3 half(std::cos(angle), std::sin(angle), 0.0);  // of 2 m
    World world;
    world.add_ground();
    add_fixed(world, Vec3(1, 4, 1), Vec3(half.x() + 0.5, 2, 0));
    add_box(world, Vec3(2.0, 0.1, 0.1), 3.0, Vec3(0, half.y(), 0), about(Vec3::UnitZ(), angle));
    Instant ladder(world);
    ladder.contacts = {contact_at(0, 2, Vec3(-half.x(), 0, 0), Vec3::UnitY()),
                       contact_at(1, 2, Vec3(half.x(), 2.0 * half.y(), 0), -Vec3::UnitX())};
    ladder.assemble();
    LcpProblem problem = ladder.problem.lcp();
    hold_along_x(ladder, 0, ladder.place(0), problem);
    for (const char* solver : kExact) {
      const LcpResult result = solved_by(solver, problem);
      CHECK(result.f[0] == Approx(3.0 * kG).epsilon(1e-12));
      // Twelve digits of the angle: measured 3e-13.
      CHECK(result.f[2] / result.f[0] == Approx(friction).epsilon(1e-11));
      CHECK(result.f[1] == Approx(result.f[2]).epsilon(1e-12));
    }
  }
}

TEST_CASE("Two cards that lean on each other by 15 degrees need a friction of tan 15° / 2",
          "[exact][assembly][analytic_lcp]") {
  const double lean = std::numbers::pi / 12.0;
  const Vec3 half(std::sin(lean), std::cos(lean), 0.0);  // of 2 m
  World world;
  world.add_ground();
  add_box(world, Vec3(0.01, 2.0, 1.0), 1.0, Vec3(-half.x(), half.y(), 0),
          about(Vec3::UnitZ(), -lean));
  add_box(world, Vec3(0.01, 2.0, 1.0), 1.0, Vec3(half.x(), half.y(), 0),
          about(Vec3::UnitZ(), lean));
  Instant cards(world);
  cards.contacts = {contact_at(0, 1, Vec3(-2.0 * half.x(), 0, 0), Vec3::UnitY()),
                    contact_at(0, 2, Vec3(2.0 * half.x(), 0, 0), Vec3::UnitY()),
                    contact_at(1, 2, Vec3(0, 2.0 * half.y(), 0), Vec3::UnitX())};
  cards.assemble();
  LcpProblem problem = cards.problem.lcp();
  hold_along_x(cards, 0, cards.place(0), problem);
  hold_along_x(cards, 1, cards.place(1), problem);
  for (const char* solver : kExact) {
    const LcpResult result = solved_by(solver, problem);
    CHECK(result.f[0] == Approx(kG).epsilon(1e-12));
    CHECK(result.f[1] == Approx(kG).epsilon(1e-12));
    CHECK(result.f[3] / result.f[0] == Approx(0.133974596215561).epsilon(1e-12));
    CHECK(result.f[4] / result.f[1] == Approx(-0.133974596215561).epsilon(1e-12));
    for (const double a : result.a) CHECK(std::abs(a) < 1e-12);  // [m/s²] measured 5e-15
  }
}

// --- impacts ------------------------------------------------------------------------------------

TEST_CASE("A rocking block keeps 1 - 3/2 sin² α of its turning when it lands on its other edge",
          "[exact][assembly][analytic_lcp]") {
  struct Case {
    double width, height;
    double kept;      // [-] of the angular velocity
    double old_edge;  // [N s] on the edge that it turned about, with 1 kg
    double new_edge;
  };
  // A block wider than √2 times its height is stopped by both edges instead.
  for (const Case& c :
       {Case{0.4, 2.0, 0.942307692308, 0.0, 0.0}, Case{1.0, 2.0, 0.7, 0.0, 0.0},
        Case{1.0, 1.0, 0.25, 0.0, 0.0}, Case{1.5, 1.0, 0.0, 0.0277777777778, 0.722222222222}}) {
    // It turns by -1 rad/s about its left edge and lands on the right one.
    World world;
    world.add_ground();
    add_box(world, Vec3(c.width, c.height, 1.0), 1.0, Vec3(0, 0.5 * c.height, 0), Quat::Identity(),
            Vec3(0.5 * c.height, -0.5 * c.width, 0), Vec3(0, 0, -1));
    Instant block(world);
    assemble_impact(block);
    LcpProblem problem = block.problem.lcp();
    REQUIRE(problem.size() == 4);
    hold_along_x(block, 0, Vec3::Zero(), problem);
    for (const char* solver : kExact) {
      const LcpResult result = solved_by(solver, problem);
      double left = 0.0, right = 0.0;        // [N s]
      double left_up = 0.0, right_up = 0.0;  // [m/s]
      for (int i = 0; i < 4; ++i) {
        const bool is_left = block.place(idx(i)).x() < 0.0;
        (is_left ? left : right) += result.f[idx(i)];
        (is_left ? left_up : right_up) = result.a[idx(i)];
      }
      CHECK(left_up - right_up == Approx(c.width * c.kept).epsilon(1e-11).margin(1e-14));
      CHECK(std::abs(right_up) < 1e-14);  // [m/s] measured 4e-16
      CHECK(left == Approx(c.old_edge).epsilon(1e-11).margin(1e-14));
      if (c.new_edge > 0.0) CHECK(right == Approx(c.new_edge).epsilon(1e-11));
    }
  }
}

TEST_CASE("Cubes in a row, all impulses at once, share the speed of those that come in",
          "[exact][assembly][analytic_lcp]") {
  struct Case {
    int moving;
    std::vector<double> after;  // [m/s]
  };
  for (const Case& c :
       {Case{1, {-1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0}}, Case{1, {-0.6, 0.4, 0.4, 0.4, 0.4}},
        Case{2, {-0.2, -0.2, 0.8, 0.8, 0.8}}}) {
    World world;
    const int count = static_cast<int>(c.after.size());
    for (int k = 0; k < count; ++k)
      add_box(world, Vec3::Ones(), 1.0, Vec3(k, 0, 0), Quat::Identity(),
              Vec3(k < c.moving ? 1.0 : 0.0, 0, 0));
    Instant row(world);
    assemble_impact(row);
    LcpProblem problem = row.problem.lcp();
    REQUIRE(problem.size() == 4 * (count - 1));
    problem.b *= 2.0;  // v+ + e v- with e = 1
    for (const char* solver : kExact) {
      row.wrenches.assign(row.bodies.size(), Wrench());
      row.problem.add_wrenches(solved_by(solver, problem).f, row.wrenches);
      std::vector<Acceleration> after = row.accelerations;
      accelerate(row.bodies, row.wrenches, after);
      for (std::size_t k = 0; k < c.after.size(); ++k) {
        CHECK((after[k].linear_w - Vec3(c.after[k], 0, 0)).norm() < 1e-13);  // measured 2e-15
        CHECK(after[k].angular_w.norm() < 1e-13);
      }
    }
  }
}
