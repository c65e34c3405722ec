/// \file
/// \brief Contact problems for the claims on solvers: stacks of cubes, and chains of boxes.
#include "lcp_solvers/redundant_contacts.hpp"

#include "tumble/base/index.hpp"

namespace tumble::chapters {
namespace {

// I = m s² / 6 for a cube.
LcpFactors::Body unit_cube() { return {Vec3::Ones(), Vec3::Constant(6.0).asDiagonal()}; }

// A contact at r1 and r2 from the centres, with the normal n from the first to the second body.
LcpFactors::Row contact_row(int first, int second, const Vec3& n, const Vec3& r1, const Vec3& r2) {
  LcpFactors::Row row;
  row.first = first;
  row.second = second;
  row.linear_first_w = -n;
  row.linear_second_w = n;
  row.angular_first_w = -r1.cross(n);
  row.angular_second_w = r2.cross(n);
  return row;
}

LcpFactors::Row contact_anywhere(Random& random, int first, int second) {
  const Vec3 normal = random.direction();
  const Vec3 on_first = random.in_cube(0.5);
  const Vec3 on_second = random.in_cube(0.5);
  return contact_row(first, second, normal, on_first, on_second);
}

LcpProblem with_loads(Random& random, LcpFactors factors) {
  std::vector<Load> loads(factors.bodies.size());
  for (Load& load : loads) {
    load.linear_w = random.in_cube(10.0);
    load.angular_w = random.in_cube(10.0);
  }
  LcpProblem problem;
  problem.b = constant_part(factors, loads);
  problem.factors = std::move(factors);
  multiply_out(problem.factors, problem.A);
  return problem;
}

}  // namespace

VecX constant_part(const LcpFactors& factors, const std::vector<Load>& loads) {
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

LcpFactors stack_on_corners(int cubes) {
  LcpFactors factors;
  for (int k = 0; k < cubes; ++k) {
    factors.bodies.push_back(unit_cube());
    for (const double x : {-0.5, 0.5})
      for (const double z : {-0.5, 0.5})
        factors.rows.push_back(
            contact_row(k - 1, k, Vec3::UnitY(), Vec3(x, 0.5, z), Vec3(x, -0.5, z)));
  }
  return factors;
}

LcpProblem contact_chain(Random& random, int boxes, int contacts, const ChainOptions& options) {
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

LcpProblem repeated_contacts(Random& random) {
  LcpFactors factors;
  const std::uint32_t boxes = 1 + random.below(4);
  const std::uint32_t contacts = 1 + random.below(24);
  factors.bodies.assign(boxes, unit_cube());
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
