/// \file
/// \brief Contact problems for the claims on solvers: stacks of cubes, and chains of boxes that touch in
///        many points (thesis 2.6.2, 3.3.1, 5.3).
#pragma once

#include "tumble/base/index.hpp"
#include "tumble/base/random.hpp"
#include "tumble/lcp_solvers/lcp.hpp"

#include <vector>

namespace tumble::chapters {

// How bodies would accelerate without contact forces.
struct Load {
  Vec3 linear_w = Vec3::Zero();   // [m/s²] of the centre of mass
  Vec3 angular_w = Vec3::Zero();  // [rad/s²] of the body
};

// b = J times accelerations; it is in the range of J, so forces exist.
inline VecX constant_part(const LcpFactors& factors, const std::vector<Load>& loads) {
  VecX b(static_cast<Eigen::Index>(factors.rows.size()));
  for (int i = 0; i < static_cast<int>(b.size()); ++i) {
    const LcpFactors::Row& row = factors.rows[idx(i)];
    const Load& second = loads[idx(row.second)];
    b[i] = row.linear_second_w.dot(second.linear_w) + row.angular_second_w.dot(second.angular_w);
    if (row.first < 0) continue;
    const Load& first = loads[idx(row.first)];
    b[i] += row.linear_first_w.dot(first.linear_w) + row.angular_first_w.dot(first.angular_w);
  }
  return b;
}

// I = m s² / 6 for a cube.
inline LcpFactors::Body cube_masses() { return {Vec3::Ones(), Vec3::Constant(6.0).asDiagonal()}; }

// A contact at r1 and r2 from the centres, with the normal n from the first to the second body.
inline LcpFactors::Row contact_row(int first, int second, const Vec3& n, const Vec3& r1,
                                   const Vec3& r2) {
  LcpFactors::Row row;
  row.first = first;
  row.second = second;
  row.linear_first_w = -n;
  row.linear_second_w = n;
  row.angular_first_w = -r1.cross(n);
  row.angular_second_w = r2.cross(n);
  return row;
}

inline LcpFactors::Row contact_anywhere(Random& random, int first, int second) {
  const Vec3 normal = random.direction();
  const Vec3 on_first = random.in_cube(0.5);
  const Vec3 on_second = random.in_cube(0.5);
  return contact_row(first, second, normal, on_first, on_second);
}

inline LcpProblem with_loads(Random& random, LcpFactors factors) {
  std::vector<Load> loads(factors.bodies.size());
  for (Load& load : loads) {
    load.linear_w = random.in_cube(10.0);
    load.angular_w = random.in_cube(10.0);
  }
  LcpProblem problem{.b = constant_part(factors, loads), .factors = std::move(factors)};
  multiply_out(problem.factors, problem.A);
  return problem;
}

// Unit cubes of 1 kg on top of each other, four corners to each joint. Three would do: of 4 rows 3 are
// independent. Rows 4k to 4k + 3 are under cube k.
inline LcpFactors stack_on_corners(int cubes) {
  LcpFactors factors;
  for (int k = 0; k < cubes; ++k) {
    factors.bodies.push_back(cube_masses());
    for (const double x : {-0.5, 0.5})
      for (const double z : {-0.5, 0.5})
        factors.rows.push_back(
            contact_row(k - 1, k, Vec3::UnitY(), Vec3(x, 0.5, z), Vec3(x, -0.5, z)));
  }
  return factors;
}

// Variants of a chain of boxes.
struct ChainOptions {
  double heavy = 1.0;   // [-] mass of every second body over that of the others
  double needle = 1.0;  // [-] factor of inverse inertias about z
  bool repeat = false;  // whether every fifth contact is the one before once more
};

// A chain of boxes of 1 kg, each touched by the one before in points anywhere and in any direction, the
// first by something fixed. No contact depends on fewer than seven others of its box.
inline LcpProblem contact_chain(Random& random, int boxes, int contacts,
                                const ChainOptions& options = {}) {
  LcpFactors factors;
  for (int k = 0; k < boxes; ++k) {
    const double inverse = k % 2 == 0 ? 1.0 : 1.0 / options.heavy;
    factors.bodies.push_back(
        {Vec3::Constant(inverse),
         Vec3(6.0 * inverse, 6.0 * inverse, 6.0 * inverse * options.needle).asDiagonal()});
    for (int i = 0; i < contacts; ++i) {
      const bool again = options.repeat && factors.rows.size() % 5 == 4;
      factors.rows.push_back(again ? factors.rows.back() : contact_anywhere(random, k - 1, k));
    }
  }
  return with_loads(random, std::move(factors));
}

// Boxes that touch each other and something fixed anywhere, every third contact given once more.
inline LcpProblem repeated_contacts(Random& random) {
  LcpFactors factors;
  const std::uint32_t boxes = 1 + random.below(4);
  const std::uint32_t contacts = 1 + random.below(24);
  factors.bodies.assign(boxes, cube_masses());
  for (std::uint32_t i = 0; i < contacts; ++i) {
    if (i % 3 == 2) {
      factors.rows.push_back(factors.rows.back());
      continue;
    }
    const int second = static_cast<int>(random.below(boxes));
    const int first = static_cast<int>(random.below(boxes)) - 1;
    factors.rows.push_back(contact_anywhere(random, first == second ? -1 : first, second));
  }
  return with_loads(random, std::move(factors));
}

}  // namespace tumble::chapters
