/// \file
/// \brief Anderson acceleration of fixed-point iterations.
#include "tumble/math/anderson.hpp"

#include "support/test.hpp"

namespace {

// How far x = M x + b, with M of this diagonal, is from its solution after so many iterations.
double error_after(int iterations, const VecX& diagonal, bool accelerated) {
  const VecX b = VecX::Ones(diagonal.size());
  const VecX solution = b.array() / (1.0 - diagonal.array());
  AndersonAcceleration acceleration;
  acceleration.start();
  VecX x = VecX::Zero(diagonal.size());
  for (int k = 0; k < iterations; ++k) {
    VecX g = diagonal.cwiseProduct(x) + b;
    if (accelerated) acceleration.extrapolate(g - x, g);
    x = g;
  }
  return (x - solution).norm() / solution.norm();
}

}  // namespace

TEST_CASE("Anderson acceleration solves a linear iteration in as many steps as it has unknowns",
          "[exact][anderson]") {
  // After one step for each unknown the extrapolation is the solution; the iteration alone is far from it.
  const VecX three = Vec3(0.9, 0.5, -0.3);
  CHECK(error_after(4, three, true) < 1e-12);
  CHECK(error_after(4, three, false) > 0.3);
}

TEST_CASE("Anderson acceleration needs a fifth of the steps of a slow iteration",
          "[exact][anderson]") {
  // Twenty rates up to 0.99, as sweeps over a tall stack have them.
  const VecX rates = VecX::LinSpaced(20, 0.0, 0.99);
  CHECK(error_after(80, rates, true) < error_after(400, rates, false));
}

TEST_CASE("Anderson acceleration stays at a solution, and where all changes are alike",
          "[exact][anderson]") {
  AndersonAcceleration acceleration;
  acceleration.start();
  VecX x = Vec3(1.0, 2.0, 3.0);
  const VecX none = VecX::Zero(3);
  for (int k = 0; k < 5; ++k) acceleration.extrapolate(none, x);
  CHECK(x == VecX(Vec3(1.0, 2.0, 3.0)));
  // An iteration that goes on by the same step has no solution; nor is one made up.
  acceleration.start();
  const VecX step = Vec3(1.0, 0.0, 0.0);
  for (int k = 0; k < 5; ++k) {
    x += step;
    acceleration.extrapolate(step, x);
  }
  CHECK(x == VecX(Vec3(6.0, 2.0, 3.0)));
}
