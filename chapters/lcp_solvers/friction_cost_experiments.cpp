/// \file
/// \brief Counted work: friction against none, new factors against updated ones.
#include "tumble/lcp_solvers/baraff.hpp"

#include "driver/experiment.hpp"
#include "lcp_solvers/redundant_contacts.hpp"

namespace tumble::chapters {
namespace {

// W between the rows of some factors: A = J W Jᵀ.
MatX yields(const LcpFactors& factors) {
  MatX A;
  multiply_out(factors, A);
  return A;
}

// The problem of a time step with friction: unknowns are the normal pushes, those in four directions
// across at each contact, and one more at each that is the speed of sliding,
//   ( N'WN  N'WD  0 )         ( N'v )
//   ( D'WN  D'WD  E ) z + q,  ( D'v ) = q, E = 1 for the directions of a contact.
//   (  mu    -E'  0 )         (  0  )
LcpProblem with_friction(const LcpFactors& normals, const std::vector<Load>& velocities,
                         double friction) {
  const int n = static_cast<int>(normals.rows.size());
  LcpFactors all = normals;
  for (const LcpFactors::Row& normal : normals.rows) {
    // Of a corner of a stack r × n is known, and r_y is 1/2 above and -1/2 below.
    for (const double sign : {1.0, -1.0})
      for (const Vec3& t : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitZ())}) {
        LcpFactors::Row row = normal;
        const auto turned = [&](const Vec3& r_cross_y, double r_y) {
          const Vec3 r(r_cross_y.z(), r_y, -r_cross_y.x());  // r × y = (-r_z, 0, r_x)
          return Vec3(r.cross(sign * t));
        };
        row.linear_first_w = -sign * t;
        row.linear_second_w = sign * t;
        row.angular_first_w = -turned(-normal.angular_first_w, 0.5);
        row.angular_second_w = turned(normal.angular_second_w, -0.5);
        all.rows.push_back(row);
      }
  }
  LcpProblem problem;
  const MatX W = yields(all);
  problem.A = MatX::Zero(6 * n, 6 * n);
  problem.A.topLeftCorner(5 * n, 5 * n) = W;
  problem.b = VecX::Zero(6 * n);
  problem.b.head(5 * n) = constant_part(all, velocities);
  for (int i = 0; i < n; ++i) {
    problem.A(5 * n + i, i) = friction;
    for (int k = 0; k < 4; ++k) {
      problem.A(n + 4 * i + k, 5 * n + i) = 1.0;
      problem.A(5 * n + i, n + 4 * i + k) = -1.0;
    }
  }
  return problem;
}

// What Gaussian elimination with one right-hand side takes.
double elimination(double size) { return size * (size * size + 3.0 * size - 1.0) / 3.0; }

// Lemke's path in a tableau, to see how many forces are in use at each of its pivots. b is changed by a
// ten-millionth at random so that nothing ties; that is no way to solve a problem, but the path is
// as long.
class Path {
 public:
  Path(const LcpProblem& problem, Random& random) : n_(problem.size()), table_(n_, 2 * n_ + 2) {
    const double scale = problem.b.cwiseAbs().maxCoeff();
    for (int i = 0; i < n_; ++i) {
      for (int j = 0; j < n_; ++j) {
        table_(i, j) = i == j ? 1.0 : 0.0;
        table_(i, n_ + j) = -problem.A(i, j);
      }
      table_(i, 2 * n_) = -1.0;
      table_(i, 2 * n_ + 1) = problem.b[i] + random.uniform(0.0, 1e-7) * scale;
      basis_.push_back(i);
    }
  }

  // Multiplications of a pivot that factors the k rows and columns of the forces in use anew, and works
  // out how the N - k other rows answer: the mean over the path.
  double work_with_new_factors() {
    int row = 0;
    for (int i = 1; i < n_; ++i)
      if (table_(i, 2 * n_ + 1) < table_(row, 2 * n_ + 1)) row = i;
    double sum = 0.0;
    int entering = 2 * n_;
    for (int pivots = 1; pivots <= 100 * n_; ++pivots) {
      const double k =
          static_cast<double>(std::ranges::count_if(basis_, [this](int u) { return u >= n_; }));
      sum += elimination(k) + k * (n_ - k);
      const int leaving = basis_[idx(row)];
      exchange(row, entering);
      if (leaving == 2 * n_) return sum / pivots;
      entering = leaving < n_ ? leaving + n_ : leaving - n_;
      row = row_to_leave(entering);
    }
    throw std::runtime_error("Lemke's path does not end");
  }

 private:
  void exchange(int row, int entering) {
    table_.row(row) /= double{table_(row, entering)};
    for (int i = 0; i < n_; ++i) {
      const double share = table_(i, entering);
      if (i != row && share != 0.0) table_.row(i) -= share * table_.row(row);
    }
    basis_[idx(row)] = entering;
  }

  [[nodiscard]] int row_to_leave(int entering) const {
    int row = -1;
    for (int i = 0; i < n_; ++i) {
      if (!(table_(i, entering) > 1e-9)) continue;
      if (row < 0 || table_(i, 2 * n_ + 1) * table_(row, entering) <
                         table_(row, 2 * n_ + 1) * table_(i, entering))
        row = i;
    }
    if (row < 0) throw std::runtime_error("Lemke's path ends on a ray");
    return row;
  }

  int n_;
  MatX table_;              // accelerations, forces, the lift, the constants
  std::vector<int> basis_;  // which unknown each row gives
};

double entries(const MatX& A) { return static_cast<double>((A.array() != 0.0).count()); }

Result measure_friction_cost(const Parameters& settings) {
  const double friction = settings.number("friction");
  const int seeds = settings.count("seeds");
  Table table{"",
              {{"contacts", "-", "contact points"},
               {"unknowns", "-", "without friction"},
               {"unknowns_friction", "-", "with friction"},
               {"entries", "-", "of the matrix that are not 0, without friction"},
               {"entries_friction", "-", "the same with friction"},
               {"updated", "-", "multiplications per pivot, no friction, updated factors"},
               {"new_factors", "-", "the same, no friction, new factors"},
               {"friction", "-", "the same, friction, new factors"}}};
  std::vector<double> with;
  std::vector<double> without;
  for (const int contacts : {8, 16, 24, 32, 48, 64}) {
    std::array<double, 8> row{};
    with.clear();
    without.clear();
    for (int seed = 1; seed <= seeds; ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      const LcpFactors factors = stack_on_corners(contacts / 4);
      // A stack that has just been pushed: gravity for 1/60 s, and up to 0.1 m/s and 0.1 rad/s.
      std::vector<Load> velocities(factors.bodies.size());
      for (Load& velocity : velocities) {
        velocity.linear_w = random.in_cube(0.1) - Vec3(0.0, 9.81 / 60.0, 0.0);
        velocity.angular_w = random.in_cube(0.1);
      }
      LcpProblem plain{.A = yields(factors), .b = constant_part(factors, velocities)};
      const LcpProblem rough = with_friction(factors, velocities, friction);
      LcpResult result;
      BaraffSolver baraff;
      baraff.solve(plain, result);
      if (result.status != LcpStatus::solved) throw std::runtime_error("a stack without friction");
      const double updated =
          static_cast<double>(result.multiplications) / std::max(1, result.pivots);
      const double plain_again = Path(plain, random).work_with_new_factors();
      with.push_back(Path(rough, random).work_with_new_factors());
      without.push_back(updated);
      const std::array<double, 8> one = {1.0 * contacts,   1.0 * plain.size(), 1.0 * rough.size(),
                                         entries(plain.A), entries(rough.A),   updated,
                                         plain_again,      with.back()};
      for (std::size_t k = 0; k < row.size(); ++k) row[k] += one[k] / seeds;
    }
    table.add(row);
  }
  const std::vector<double>& last = table.rows.back();
  return {
      {table},
      {ratio_of_sums("multiplications per pivot at 64 contacts, friction and new factors over no "
                     "friction and updated factors",
                     "-", with, without),
       {"unknowns with friction over those without", "-", last[2] / last[1]},
       {"new factors over updated ones, no friction, 64 contacts", "-", last[6] / last[5]}}};
}

const Registered claim_5_3d_friction_cost_figure{
    {.name = "claim_5_3d_friction_cost",
     .parameters = {number("friction", 0.5, 0.01, 2.0, "-", "coefficient"),
                    whole("seeds", 20, 2, 100, "random velocities")},
     .quick = {"seeds=2"},
     .experiment = measure_friction_cost}};

}  // namespace
}  // namespace tumble::chapters
