/// \file
/// \brief The constant part of the problem of contact forces: closed forms, and gaps in free flight.
#include "tumble/base/random.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/dynamics/advance_pose.hpp"
#include "tumble/dynamics/flight.hpp"

#include "analytic_lcp/instant.hpp"
#include "dynamics/random_bodies.hpp"

#include <array>
#include <cmath>

TEST_CASE("A free body tumbles as Euler's equations say", "[exact][assembly][analytic_lcp]") {
  World world;
  add_box(world, Vec3(3, 2, 1), 12.0, Vec3::Zero(), Quat::Identity(), Vec3(1, 2, 3),
          Vec3(1, 0, 2));  // moments 5, 10, 13: the second one turns by (13 - 5) 2 / 10
  const Quat turned = about(Vec3(1, 2, 3), 0.7);
  add_box(world, Vec3(3, 2, 1), 12.0, Vec3::Zero(), turned, Vec3::Zero(), turned * Vec3(1, 0, 2));
  add_fixed(world, Vec3::Ones(), Vec3::Zero());
  std::vector<MovingBody> bodies;
  load_moving_bodies(world, bodies);
  std::vector<Acceleration> free;
  free_accelerations(world, bodies, free);
  CHECK((free[0].angular_w - Vec3(0, 1.6, 0)).norm() < 1e-15);           // measured 0
  CHECK((free[1].angular_w - turned * Vec3(0, 1.6, 0)).norm() < 1e-14);  // measured 1e-15
  CHECK(free[0].linear_w == world.gravity_w);
  CHECK(free[2].linear_w == Vec3::Zero());
  // What a technique has locked is not accelerated.
  bodies[0].inverse_mass.y() = 0.0;
  bodies[0].inverse_inertia_w.setZero();
  world.gravity_w = Vec3(1, 2, 3);
  free_accelerations(world, bodies, free);
  CHECK(free[0].linear_w == Vec3(1, 0, 3));
  CHECK(free[0].angular_w == Vec3::Zero());
}

namespace {

// Two bodies in free flight that touch in one point at time 0.
struct TouchingPair {
  World world;
  Separation found;

  [[nodiscard]] Separation gap() const {
    return gap_between(world.bodies()[0], world.states()[0], world.bodies()[1], world.states()[1]);
  }

  [[nodiscard]] Mat3 axes(std::size_t body) const {
    return world.states()[body].orientation_wb.toRotationMatrix();
  }

  // Whether a corner in a face or two edges touch so clearly that they still do so a moment later.
  [[nodiscard]] bool clear_cut() const {
    const auto least = [&](std::size_t body, int but) {
      double smallest = 1.0;
      for (int k = 0; k < 3; ++k)
        if (k != but)
          smallest = std::min(smallest, std::abs(found.normal_w.dot(axes(body).col(k))));
      return smallest;
    };
    if (found.axis == kNoAxis)
      return least(world.bodies()[0].shape == Shape::ground ? 1 : 0, -1) > 0.25;
    if (found.axis < 6) return least(found.axis < 3 ? 1 : 0, -1) > 0.25;
    const int i = (found.axis - 6) / 3, j = (found.axis - 6) % 3;
    const double sine = axes(0).col(i).cross(axes(1).col(j)).norm();
    return sine > 0.4 && least(0, i) > 0.25 && least(1, j) > 0.25;
  }
};

void add_random(World& world, Random& random, bool fixed) {
  const BodyProperties body = random_box(random);
  const BodyState state = random_state(random, body, 0.0, 2.0, 2.0);
  if (fixed) {
    add_fixed(world, body.size, Vec3::Zero(), state.orientation_wb);
  } else {
    world.add(body, state);
  }
}

TouchingPair touching_pair(Random& random) {
  TouchingPair pair;
  pair.world.gravity_w = random.in_cube(10.0);
  const std::uint32_t kind = random.below(8);  // 0, 1: with the ground; 2: with a fixed box
  if (kind == 0) pair.world.add_ground();
  if (kind != 0) add_random(pair.world, random, kind == 2);
  if (kind != 1) add_random(pair.world, random, false);
  if (kind == 1) pair.world.add_ground();
  // From far away towards the other body, until they touch: the gap is convex along the way.
  const std::size_t mover = kind == 1 ? 0 : 1;
  const double turn = kind == 1 ? -1.0 : 1.0;
  const Vec3 way = kind <= 1 ? Vec3::UnitY() : random.direction();
  Vec3& position_w = pair.world.states()[mover].position_w;
  position_w = 10.0 * way;
  for (int i = 0; i < 20; ++i) {
    pair.found = pair.gap();
    position_w -= pair.found.distance / (turn * pair.found.normal_w.dot(way)) * way;
  }
  pair.found = pair.gap();
  return pair;
}

// Where a free body is after a time: exact but for the rotation, 128 steps of fourth order, some
// 1e-13 rad off.
BodyState flown(const World& world, std::size_t body, double time) {
  BodyState state = world.states()[body];
  if (!world.bodies()[body].movable()) return state;
  constexpr int kSteps = 128;
  for (int i = 0; i < kSteps; ++i)
    advance_pose(world.bodies()[body], state, time / kSteps, RotationRule::rk4);
  state.position_w += 0.5 * time * time * world.gravity_w;
  return state;
}

// [m/s²] The second derivative of the gap at time 0: central differences of four widths, drawn
// together by Richardson's rule. Says in `same` whether the same axis was the best one throughout.
double gap_acceleration(const TouchingPair& pair, bool& same) {
  std::array<double, 4> d{};
  double h = 0.03;  // [s]
  same = true;
  for (double& value : d) {
    double sum = -2.0 * pair.found.distance;
    for (const double time : {-h, h}) {
      TouchingPair then = pair;
      for (std::size_t body = 0; body < 2; ++body)
        then.world.states()[body] = flown(pair.world, body, time);
      const Separation gap = then.gap();
      same = same && gap.axis == pair.found.axis;
      sum += gap.distance;
    }
    value = sum / (h * h);
    h *= 0.5;
  }
  double power = 4.0;  // the error has the powers h², h⁴, h⁶
  for (std::size_t level = 1; level < d.size(); ++level, power *= 4.0)
    for (std::size_t i = d.size() - 1; i >= level; --i) d[i] += (d[i] - d[i - 1]) / (power - 1.0);
  return d.back();
}

}  // namespace

TEST_CASE("The constant part is the second derivative of the gap of 1000 pairs in free flight",
          "[exact][assembly][analytic_lcp]") {
  Random random(20);
  std::array<int, 4> kinds{};  // the ground's normal, a face of the first, of the second, edges
  int done = 0, wrong_contacts = 0, term_matters = 0;
  double worst = 0.0, worst_rate = 0.0;
  for (int drawn = 0; done < 1000 && drawn < 20000; ++drawn) {
    const TouchingPair pair = touching_pair(random);
    bool same = false;
    if (!pair.clear_cut()) continue;
    const double expected = gap_acceleration(pair, same);
    if (!same) continue;
    ++done;
    Instant instant(pair.world);
    instant.assemble();
    if (instant.problem.lcp().size() != 1 || instant.contacts[0].axis != pair.found.axis) {
      ++wrong_contacts;
      continue;
    }
    const AxisIndex axis = pair.found.axis;
    ++kinds[axis == kNoAxis ? 0 : axis < 3 ? 1 : axis < 6 ? 2 : 3];
    worst = std::max(worst, std::abs(instant.problem.lcp().b[0] - expected));

    // Without the turning normal most of them would be wrong, and by how much.
    const Vec3 n_rate = rate_of_normal(pair.world, instant.bodies, instant.contacts[0]);
    const Vec3 u = relative_velocity(instant.bodies[0], instant.bodies[1],
                                     instant.contacts[0].points[0].position_w);
    term_matters += std::abs(2.0 * n_rate.dot(u)) > 1.0 ? 1 : 0;
    const double h = 1e-6;  // [s] central difference: error h² w³ and rounding / h
    std::array<Vec3, 2> normal_w;
    for (std::size_t k = 0; k < 2; ++k) {
      TouchingPair then = pair;
      for (std::size_t body = 0; body < 2; ++body)
        then.world.states()[body] = flown(pair.world, body, k == 0 ? -h : h);
      normal_w[k] = then.gap().normal_w;
    }
    worst_rate = std::max(worst_rate, (n_rate - (normal_w[1] - normal_w[0]) / (2.0 * h)).norm());
  }
  CHECK(done == 1000);
  CHECK(wrong_contacts == 0);
  for (const int count : kinds) CHECK(count > 100);
  CHECK(term_matters > 500);
  // [m/s²] Rounding of a gap between bodies of metres, 1e-15 m, over the square of the narrowest
  // width, (4 ms)², with what Richardson's rule makes of it and leaves of the widest one's error.
  CHECK(worst < 1e-7);       // measured 5e-9
  CHECK(worst_rate < 1e-7);  // [1/s] rounding of a direction over h: measured 7e-9
}
