/// \file
/// \brief The pyramids that solvers are measured with.
#include "lcp_solvers/pyramid_problem.hpp"

#include "support/test.hpp"

using namespace tumble;
using namespace tumble::chapters;

TEST_CASE("A pyramid's problem is that of the cubes and contacts that it says",
          "[exact][lcp][lcp_solvers]") {
  // Two cubes and one on top: two pairs of faces on the ground, two above.
  const PyramidProblem pyramid = pyramid_problem(16, 0.0, 1);
  CHECK(pyramid.problem.factors.bodies.size() == 3);
  CHECK(pyramid.problem.size() == 16);
  for (int i = 0; i < 16; ++i)  // only the ground does not fall with the cubes
    CHECK(pyramid.problem.b[i] == (i < 8 ? -9.81 * (1.0 / 60.0) : 0.0));
  // A corner of a cube on the ground: 1 + 6 (1/4 + 1/4), and where the upper cube stands 0.475 m wide on
  // two others, 1 + 6 (0.025² + 1/4) more or so.
  CHECK(std::abs(pyramid.problem.A(0, 0) - 4.0) <= 1e-14);
  const double lower = 1.0 + 6.0 * (0.5 * 0.5 + 0.25);
  const double upper = 1.0 + 6.0 * (0.025 * 0.025 + 0.25);
  CHECK(std::abs(pyramid.problem.A(10, 10) - lower - upper) <= 1e-13);

  // Cut short, the last cube stands on one pair of faces, and there is no cube without contact.
  CHECK(pyramid_problem(512, 0.0, 1).problem.factors.bodies.size() ==
        static_cast<std::size_t>(12 + 11 + 10 + 9 + 8 + 7 + 6 + 5 + 2));
  CHECK_THROWS_AS(pyramid_problem(0, 0.0, 1), std::invalid_argument);
  CHECK_THROWS_AS(pyramid_problem(18, 0.0, 1), std::invalid_argument);
  CHECK_THROWS_AS(next_step(pyramid, std::vector<double>(3)), std::invalid_argument);
}
