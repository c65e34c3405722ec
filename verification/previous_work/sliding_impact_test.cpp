/// \file
/// \brief Friction through an impact against Routh's closed forms, and against a plain integration.
#include "tumble/previous_work/sliding_impact.hpp"

#include "support/test.hpp"

namespace {

// An impact in a plane: yields a across the normal, b between, c along it.
struct Flat {
  double a, b, c;         // [1/kg]
  double slip, approach;  // [m/s] both above 0
  double friction, restitution;
};

// Routh's construction: straight lines in the plane of both impulses, with the end after Poisson or Stronge.
// Returns across and along the normal [N s]
Vec3 routh(const Flat& f, ImpactEnd end) {
  struct Line {
    double across, length;  // impulse across per impulse along; how far at most
  };
  std::vector<Line> lines;
  const double slows = f.friction * f.a - f.b;  // of the slip
  const double stop = slows > 0.0 ? f.slip / slows : kInfinity;
  lines.push_back({-f.friction, stop});
  const double holds = -f.b / f.a;
  lines.push_back(
      {std::abs(holds) <= f.friction ? holds : std::copysign(f.friction, holds), kInfinity});
  double across = 0.0, along = 0.0, u = -f.approach, work = 0.0, wanted = 0.0;
  bool approaches = true;
  for (std::size_t k = 0; k < lines.size();) {
    const double rate = f.c + f.b * lines[k].across;
    double left = kInfinity;
    if (approaches && rate > 0.0) left = -u / rate;
    if (!approaches && end == ImpactEnd::impulse) left = wanted - along;
    if (!approaches && end == ImpactEnd::work) {
      const double square = u * u + 2.0 * rate * (wanted - work);
      left = square < 0.0 ? kInfinity : (std::sqrt(square) - u) / rate;
    }
    const double length = std::min(left, lines[k].length);
    across += length * lines[k].across;
    along += length;
    work += length * (u + 0.5 * rate * length);
    u += rate * length;
    lines[k].length -= length;
    if (left > length) {
      ++k;
    } else if (approaches) {
      approaches = false;
      u = 0.0;
      wanted = end == ImpactEnd::work ? (1.0 - f.restitution * f.restitution) * work
                                      : (1.0 + f.restitution) * along;
    } else {
      break;
    }
  }
  return {across, along, 0.0};
}

// The same in space, in a plane that is turned about the normal y.
SlidingImpact turned(const Flat& f, double angle, ImpactEnd end) {
  const Vec3 x(std::cos(angle), 0.0, std::sin(angle)), y = Vec3::UnitY(), z = x.cross(y);
  SlidingImpact impact{.normal_w = y, .velocity_w = f.slip * x - f.approach * y};
  impact.inverse_mass_w = f.a * x * x.transpose() + f.c * y * y.transpose() +
                          f.b * (x * y.transpose() + y * x.transpose()) + z * z.transpose();
  impact.friction = f.friction;
  impact.restitution = f.restitution;
  impact.end = end;
  return impact;
}

// Of a pair of bodies that can move: the sum of two random ones.
Mat3 random_yield(Random& random) {
  Mat3 arm;
  for (int k = 0; k < 3; ++k) arm.col(k) = random.in_cube(1.0);
  return arm * arm.transpose() + 0.1 * Mat3::Identity();
}

SlidingImpact random_impact(Random& random) {
  SlidingImpact impact;
  impact.inverse_mass_w = random_yield(random);
  impact.velocity_w = random.in_cube(2.0);
  impact.velocity_w.y() = -random.uniform(0.1, 2.0);
  impact.friction = random.uniform(0.0, 1.5);
  impact.restitution = random.unit();
  return impact;
}

}  // namespace

TEST_CASE("Impacts of a rod are Routh's: they slide, stick, or slide back",
          "[exact][microcollisions]") {
  // A rod of 1 kg and 2 m hits with an end: a = 1 + 3 cos², c = 1 + 3 sin², b = 3 sin cos of its angle to the normal.
  int slides = 0, sticks = 0, returns = 0, jams = 0;
  for (int degrees = -80; degrees <= 80; degrees += 5) {
    const double angle = degrees * std::numbers::pi / 180.0;
    for (const double friction : {0.0, 0.05, 0.3, 0.8, 2.0}) {
      for (const double slip : {0.01, 0.5, 5.0}) {
        for (const ImpactEnd end : {ImpactEnd::work, ImpactEnd::impulse}) {
          Flat f{1.0 + 3.0 * std::cos(angle) * std::cos(angle),
                 3.0 * std::sin(angle) * std::cos(angle),
                 1.0 + 3.0 * std::sin(angle) * std::sin(angle),
                 slip,
                 1.0,
                 friction,
                 0.5};
          if (end == ImpactEnd::impulse && f.c < f.friction * std::abs(f.b)) continue;
          const SlidingImpact impact = turned(f, 0.4, end);
          const SlidingImpulse found = solve_sliding_impact(impact);
          const Vec3 right = routh(f, end);
          const Vec3 x(std::cos(0.4), 0.0, std::sin(0.4));
          CAPTURE(degrees, friction, slip, static_cast<int>(end));
          CHECK(found.impulse_w.dot(x) == near(right.x(), 1e-12 * right.y()));
          CHECK(found.impulse_w.y() == near(right.y(), 1e-12 * right.y()));
          CHECK(found.steps == 0);
          const bool holds = std::abs(f.b / f.a) <= friction;
          (!found.stopped ? slides : holds ? sticks : returns) += 1;
          CHECK((found.mode == ImpactMode::stick) == (found.stopped && holds));
          jams += f.c < friction * f.b ? 1 : 0;  // friction pushes the rod in until it stops
        }
      }
    }
  }
  CHECK(std::min({slides, sticks, returns, jams}) > 10);
}

TEST_CASE("A ball that slides into an impact keeps the direction of its slip",
          "[exact][microcollisions]") {
  // Ball: 7/2 across and 1 along the normal, over the mass; a cube in the middle of a face: 5/2.
  for (const double across : {3.5, 2.5}) {
    for (const double friction : {0.05, 0.2, 1.0}) {
      SlidingImpact impact{.velocity_w = Vec3(1.2, -2.0, -0.5),
                           .inverse_mass_w = Vec3(across, 1.0, across).asDiagonal(),
                           .friction = friction,
                           .restitution = 0.6};
      const SlidingImpulse found = solve_sliding_impact(impact);
      const Vec3 slip(1.2, 0.0, -0.5);
      const double push = 1.6 * 2.0;
      const double rubs = std::min(friction * push, slip.norm() / across);
      CAPTURE(across, friction);
      CHECK((found.impulse_w - (push * Vec3::UnitY() - rubs * slip.normalized())).norm() < 1e-13);
      CHECK((found.mode == ImpactMode::stick) == (friction * push > slip.norm() / across));
    }
  }
}

TEST_CASE("Slip that turns in an impact follows a plain integration of its equation",
          "[reference][microcollisions]") {
  Random random(7);
  int turned_by_steps = 0;
  for (int trial = 0; trial < 12; ++trial) {
    SlidingImpact impact = random_impact(random);
    impact.restitution = 0.0;
    const SlidingImpulse found = solve_sliding_impact(impact);
    if (found.stopped) continue;  // the plain one has no answer to that
    turned_by_steps += found.steps > 0 ? 1 : 0;
    // Midpoint steps in the normal impulse, as many as go into the answer's.
    constexpr int kSteps = 20000;
    const double step = found.impulse_w.y() / kSteps;
    Vec3 j = Vec3::Zero();
    const auto rate = [&](const Vec3& at) {
      Vec3 u = impact.velocity_w + impact.inverse_mass_w * at;
      u.y() = 0.0;
      return Vec3(Vec3::UnitY() - impact.friction * u.normalized());
    };
    for (int k = 0; k < kSteps; ++k) j += step * rate(j + 0.5 * step * rate(j));
    CAPTURE(trial, found.steps);
    CHECK((j - found.impulse_w).norm() < 1e-6 * j.norm());  // measured: 1e-8
    CHECK(std::abs((impact.velocity_w + impact.inverse_mass_w * j).y()) <
          1e-5 * impact.velocity_w.norm());
  }
  CHECK(turned_by_steps > 3);
}

TEST_CASE("Impacts with friction end apart, within the cone, and without new energy",
          "[exact][microcollisions]") {
  Random random(8);
  Failures wrong;
  for (int trial = 0; trial < 3000; ++trial) {
    SlidingImpact impact = random_impact(random);
    if (trial % 5 == 0) impact.velocity_w.x() = impact.velocity_w.z() = 0.0;
    const SlidingImpulse found = solve_sliding_impact(impact);
    const Vec3& j = found.impulse_w;
    const Vec3 after = impact.velocity_w + impact.inverse_mass_w * j;
    const double gained = 0.5 * j.dot(impact.velocity_w + after);
    const Vec3 rubs(j.x(), 0.0, j.z());
    if (!(after.y() >= -1e-12)) ++wrong["approaches"];
    if (!(rubs.norm() <= impact.friction * j.y() * (1.0 + 1e-9))) ++wrong["outside the cone"];
    if (!(gained <= 1e-12)) ++wrong["energy"];
    // Asked to part faster, they do.
    impact.rebound = 3.0;
    const Vec3 fast =
        impact.velocity_w + impact.inverse_mass_w * solve_sliding_impact(impact).impulse_w;
    if (!(fast.y() >= 3.0 * (1.0 - 1e-9))) ++wrong["rebound"];
  }
  CHECK(wrong == Failures{});
}
