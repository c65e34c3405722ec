/// \file
/// \brief The direct solver: all contact patches of an island at once, by ADMM and Newton steps (thesis 6.3.1).
///
/// Called direct because each of its iterations solves for all bodies together, by factors of the island's matrix, where
/// sweeps go from patch to patch. Iterations remain: friction and separation are not linear.
#pragma once

#include "tumble/contact_damped/island.hpp"
#include "tumble/contact_damped/tolerances.hpp"
#include "tumble/math/sparse_blocks.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// When IslandSolver stops, and which islands it takes.
struct IslandLimits {
  double residual = 0.0;    ///< [m/s] velocity error at a point that counts as solved
  double unit_speed = 0.0;  ///< [m/s] speed that gravity gives in a step, or a substitute for it
  int max_iterations = 20;  ///< ADMM iterations, at least 1
  double max_work = 0.0;    ///< [-] multiplications of a factorization for each body, at most
  double max_stiffness = tolerance::admm_max_stiffness;  ///< [-] of the springs of ADMM
  int max_newton_steps = 100;                            ///< each factors the matrix
  /// [m/s] Error of a point's shift that is accepted after Newton steps. Above 0 their result is also
  /// taken when they have not converged, if it is in balance and its residual much smaller than before.
  double shift_tolerance = 0.0;
  int max_shift_updates = 100;  ///< updates of impulses and shifts between Newton steps
  double early_stop_residual =
      0.0;  ///< [m/s] ADMM ends if velocities change by less, though that does not count as solved
  /// [m/s] Above 0, the impulses at the start are as near as this to a solution, and Newton steps are tried before ADMM.
  double near = 0.0;
  double good_residual =
      0.0;                  ///< [m/s] Newton steps in balance end below it: the next step goes on
  int more_iterations = 0;  ///< of ADMM, where Newton steps have failed too
};

/// How IslandSolver ended.
struct IslandResult {
  bool accepted = false;  ///< false: nothing was changed, as factors cost too much or ADMM diverged
  bool converged = false;  ///< the residual is below the limit
  bool improved = false;   ///< it is not, but Newton steps made it much smaller: shift_tolerance
  int factorizations = 0;  ///< of the island's matrix
  int iterations = 0;      ///< ADMM iterations, each a solution with the factors
  double residual = 0.0;   ///< [m/s] the largest velocity error at a point
};

/// Finds the velocities at the end of a step, and the impulses of all contact patches of an island.
///
/// With u the motion of a point relative to its target w, \f$u = J v - w\f$, Coulomb's law with the cone
/// \f$C: |\lambda_t| \le \mu \lambda_n\f$ and its dual \f$C^*\f$ is
/// \f[ C \ni \lambda \perp u + \mu |u_t|\, n \in C^* . \f]
/// With the *shift* \f$s = \mu |u_t|\f$ of the iteration before (0 where nothing slides) it is the condition for
/// \f[ \min_v\; \tfrac12 (v-\hat v)^{\mathsf T} M (v-\hat v)\quad\text{with}\quad
///     z = J v - w + s\,n \in C^* , \f]
/// convex, \f$\hat v\f$ being the velocities without contacts. **ADMM**, the alternating direction method of
/// multipliers: each point is a spring of stiffness \f$\rho\f$, always on, that pulls its motion to z. In turn
/// the velocities are solved for all springs together, then each impulse is projected by itself,
/// \f[ (M + J^{\mathsf T}\rho J)\, v = M \hat v + J^{\mathsf T}\bigl(\rho (z + w - s n) + \lambda\bigr),
///     \quad \lambda \leftarrow P_C\bigl(\lambda - \rho (J v - w + s n)\bigr), \f]
/// and z follows. The matrix is the same in every iteration: one factorization, then one
/// back-substitution each. Unlike sweeps, the iterations do not grow with the height of a stack, because
/// the factors carry weight through all of it; where all patches stick two or three are enough. The stiffness
/// is raised or lowered when one of the two residuals, primal \f$|u - z|\f$ and dual \f$|\Delta z|\f$, runs ahead.
///
/// **Sliding.** A point that slides faster than friction could stop it in four steps has no tangential
/// spring and no shift; its friction is \f$\mu\f$ times the pressure of the iteration before, against its
/// direction. So it is at its bound in every iteration; with friction above 1 it comes nearer to that, by
/// tolerance::steep_friction_share. Where that would turn the slide around, as of a light plank under a
/// heavy crate, the point becomes one like others.
///
/// **Newton steps** follow where ADMM does not converge, with the shift of its last velocities for all points. Stiff springs
/// \f$\lambda = P_C(\lambda_0 - \rho(J v - w + s n))\f$ are brought into balance with the bodies,
/// \f$M(v-\hat v) = J^{\mathsf T}\lambda\f$; each step goes as far as the convex function decreases whose
/// gradient this is. Then \f$\lambda_0\f$ and s are updated (augmented Lagrangian). With
/// friction above 1 this is not tried, as the shifts diverge there. If they do not
/// converge either, the best one in balance is taken (IslandLimits::shift_tolerance), or ADMM goes on from where it was: a
/// result that is not in balance is dominated by rounding, enlarged by the stiffness of the springs.
///
/// **From step to step.** Where points creep, an update brings s nearer by a twentieth only. An error of the shift
/// below a slop in a step opens no gap and is accepted (IslandLimits::shift_tolerance), so two or three updates in
/// a step are enough. The next step continues: each point keeps its impulse (ContactPatchPoint::solver_impulse).
///
/// Nothing depends on the axes of the world except by rounding: errors are measured by lengths of
/// vectors, never by components along tangents.
///
/// ADMM that is stopped early leaves velocities that nearly meet all conditions, and impulses within the
/// cones that nearly belong to them.
/// \par Cost and determinism
/// SparseBlocks::factor() at the start and where the stiffness changes, SparseBlocks::solve() in each iteration. No allocation
/// once warm. The result depends on nothing but the island: not on what was solved before.
/// \see Boyd et al., "Distributed optimization and statistical learning via the alternating direction
///      method of multipliers", Found. Trends Mach. Learn. 3 (2011).
/// \see De Saxcé, Feng, "The bipotential method", Math. Comput. Model. 28 (1998), for s.
/// \see Acary, Cadoux, Lemaréchal, Malick, "A formulation of the linear discrete Coulomb friction
///      problem via convex optimization", ZAMM 91 (2011).
/// \see Carpentier, Montaut, Le Lidec, "From compliant to rigid contact simulation: a unified and
///      efficient approach", RSS 2024.
/// \algorithm{Contact patches of an island together: section 6.3.1}
class IslandSolver {
 public:
  /// Solves one island.
  /// \param island  patches with their targets; impulses and velocities in (a start) and out
  /// \return how it ended; nothing is changed unless it was accepted
  IslandResult solve(const Island& island, const IslandLimits& limits);

  /// Whether one factorization of an island's matrix takes more multiplications than that.
  bool costs_more_than(double most, const Island& island);

  /// Finds the normal impulses with which nothing approaches, friction held as it is.
  ///
  /// Without the cones' coupling the problem is convex with one solution, and the Newton steps of solve() find it
  /// whatever the masses and the coefficients of friction are. Impulses of friction may be outside of their cones
  /// afterwards.
  /// \param island  patches with their targets; normal impulses and velocities in (a start) and out
  /// \param limits  residual, max_newton_steps and max_work count
  /// \param held    by index: velocities without contacts, with the impulses of friction
  /// \return how it ended; nothing is changed unless it was accepted, which it is if factors do not cost too much
  IslandResult solve_normal(const Island& island, const IslandLimits& limits,
                            std::span<const MovingBody> held);

 private:
  // The shift s is found by substitution, which diverges where friction or the ratio of masses is very large. Without
  // it the problem is convex, and the iterations converge; points that slide then separate a little. Where friction is
  // held, points have none.
  enum class FrictionLaw : std::uint8_t { coulomb, convex, held };
  // A movable body of the island.
  struct Member {
    double mass = 0.0;              // [kg]
    double load = 0.0;              // [kg] the heaviest body that it may carry, itself included
    Mat3 inertia_w = Mat3::Zero();  // [kg m²]
    Vec6 free = Vec6::Zero();       // velocity and angular velocity without contacts
    Vec6 now = Vec6::Zero();        // the present ones
  };
  // A point of a patch that asks for something; vectors are along, across, normal.
  struct Point {
    std::size_t place = 0;               // in the patch
    double along = 0.0, across = 0.0;    // [m] from the middle of the patch
    double target = 0.0;                 // [m/s] w
    double shift = 0.0;                  // [m/s] s
    double inverse_mass = 0.0;           // [1/kg] along the normal; at most that of lightest_spring
    double friction = 0.0;               // [-] mu
    Vec3 impulse = Vec3::Zero();         // [N s] lambda
    Vec3 auxiliary = Vec3::Zero();       // [m/s] z
    Vec3 slip_direction = Vec3::Zero();  // [-] of a point that slides too fast to stop, or 0
    bool slides = false;                 // whether it does
    Vec3 motion = Vec3::Zero();          // [m/s] u, in newton()
    Vec3 spring_impulse = Vec3::Zero();  // [N s] of its stiff spring, in newton()
    Mat3 spring_slope = Mat3::Zero();    // [kg] by which that falls as the motion grows
    Vec3 motion_change = Vec3::Zero();   // [m/s] of u in a whole Newton step
    Vec3 start_impulse = Vec3::Zero();   // [N s] spring impulse at the start of a Newton step
  };
  // A patch: the members that it joins, and its points.
  struct Constraint {
    int patch = 0;    // place in the list
    int first = -1;   // member, or -1 for an immovable body
    int second = -1;  // ditto
    int pair = -1;    // of members in the matrix, or -1
    int begin = 0;    // its points
    int end = 0;      // ditto
  };

  // island_setup.cpp: bodies, points and the matrix.
  void load(const Island& island, std::span<const MovingBody> free, FrictionLaw law);
  void number_members(const Island& island);
  void forget_members(const Island& island);
  void find_loads(const Island& island);
  void load_points(const ContactPatch& patch, double load, FrictionLaw law);
  bool costs_too_much(double max_work);
  void begin_iterations(std::span<const ContactPatch> patches, double unit_speed, FrictionLaw law);
  [[nodiscard]] Six motion_now(const Constraint& constraint, const ContactPatch& patch) const;
  void factor(std::span<const ContactPatch> patches, bool newton);
  void begin_right_side();
  void add_to_right_side(const Constraint& constraint, const ContactPatch& patch,
                         const Six& impulse);
  void solve_with_factors();

  // island_solver.cpp: an ADMM iteration is solve_velocities(), then project_impulses().
  void solve_velocities(std::span<const ContactPatch> patches);
  bool iterate(std::span<const ContactPatch> patches, const IslandLimits& limits, FrictionLaw law,
               IslandResult& result);
  void project_impulses(std::span<const ContactPatch> patches, FrictionLaw law, double& primal,
                        double& dual);
  void start_auxiliary(const Vec3& motion, Point& point) const;
  bool hold_reversed(std::span<const ContactPatch> patches);
  void adjust_stiffness(double primal, double dual, double most);
  void store(const Island& island, std::span<const MovingBody> free, FrictionLaw law) const;

  // island_newton.cpp
  void newton(std::span<const ContactPatch> patches, const IslandLimits& limits,
              IslandResult& result);
  void start_shifts(std::span<const ContactPatch> patches);
  double update_impulses(double shift_tolerance, double residual);
  double balance(std::span<const ContactPatch> patches, double balanced, int most, int& steps);
  double newton_step(std::span<const ContactPatch> patches);
  void evaluate_springs(std::span<const ContactPatch> patches);
  double line_search(std::span<const ContactPatch> patches);
  void move_along(double share, std::span<const ContactPatch> patches);
  [[nodiscard]] double slope(double share) const;

  std::vector<int> member_of_;  // by body index, -1 for others and between solutions
  std::vector<Member> members_;
  std::vector<Constraint> constraints_;
  std::vector<Point> points_;
  std::vector<BlockPair> joined_;   // members of patches between two movable bodies
  std::vector<Vec6> x_;             // right side, then solution; in Newton steps the direction
  std::vector<Vec6> newton_start_;  // velocities at the start of a Newton step
  std::vector<Point> saved_points_;
  std::vector<Member> saved_members_;
  double unit_mass_ = 1.0;       // [1/kg] a power of two, one over about a body's mass
  double stiffness_ = 0.0;       // [-] rho times inverse mass, the same for all points
  double first_residual_ = 0.0;  // [m/s] after one ADMM iteration

  SparseBlocks matrix_;
};

}  // namespace tumble
