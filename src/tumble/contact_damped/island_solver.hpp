/// \file
/// \brief All contact areas of a island together, by alternating directions (thesis 6.3.1).
///
/// Uses no other chapter.
#pragma once

#include "tumble/contact_damped/contact_patch.hpp"
#include "tumble/contact_damped/tolerances.hpp"
#include "tumble/math/sparse_blocks.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// When IslandSolver is to stop, and which islands it takes on.
struct IslandLimits {
  double enough = 0.0;     ///< [m/s] wrong velocity at a point that is left alone
  double unit = 0.0;       ///< [m/s] what gravity does in a step, or what stands for it
  int most_rounds = 20;    ///< in one call, at least 1
  double most_work = 0.0;  ///< [-] multiplications of a factorisation for each body
  double hardest = tolerance::island_hardness;  ///< [-] stiffness of springs in the rounds, at most
  int most_steps = 100;                         ///< of Newton's after the rounds, each factors
  /// [m/s] By how much the shift of a point may be wrong after Newton's steps. Above 0 what they leave is
  /// taken even if they have not come to an end, provided that it is in balance and much better than before.
  double loose = 0.0;
  int most_turns = 100;  ///< how often impulses and shifts follow these steps, at most
};

/// How IslandSolver ended.
struct IslandResult {
  bool tried = false;   ///< false: factors would cost more than allowed, or rounds ran away
  bool solved = false;  ///< what is wrong is below what was asked for
  bool close =
      false;  ///< it is not, but Newton's steps have made it much less; see IslandLimits::loose
  int factorings = 0;  ///< of the island's matrix
  int rounds = 0;      ///< solutions with its factors
  double wrong = 0.0;  ///< [m/s] the largest velocity at a point that is not as it should be
};

/// Finds the velocities at the end of a step, and the impulses of all contact areas of a island.
///
/// With u the motion of a point against its target w, \f$u = J v - w\f$, Coulomb's law with the cone
/// \f$K: |\lambda_t| \le \mu \lambda_n\f$ and its dual \f$K^*\f$ is
/// \f[ K \ni \lambda \perp u + \mu |u_t|\, n \in K^* . \f]
/// With \f$s = \mu |u_t|\f$ of the round before (0 where nothing slides) it is the condition for
/// \f[ \min_v\; \tfrac12 (v-\hat v)^{\mathsf T} M (v-\hat v)\quad\text{with}\quad
///     z = J v - w + s\,n \in K^* , \f]
/// convex, \f$\hat v\f$ being the velocities without contacts. **Alternating directions**: each point is a
/// spring of stiffness \f$\rho\f$, always on, that pulls its motion to z; the bodies give way to all
/// springs at once, then each spring is put right by itself,
/// \f[ (M + J^{\mathsf T}\rho J)\, v = M \hat v + J^{\mathsf T}\bigl(\rho (z + w - s n) + \lambda\bigr),
///     \quad \lambda \leftarrow P_K\bigl(\lambda - \rho (J v - w + s n)\bigr), \f]
/// and z is what is left. The matrix is the same in every round: one factorisation, then a
/// back-substitution a round. Unlike sweeps the rounds do not get more with the height of a stack, because
/// the factors carry weight through all of it; where all areas stick two or three rounds do. The stiffness
/// is raised or lowered when one of the two residuals, \f$|u - z|\f$ and \f$|\Delta z|\f$, runs ahead.
///
/// **Sliding.** A point that slides faster than friction could stop it in four steps has no spring across
/// the normal and no shift; its friction is \f$\mu\f$ times the pressure of the round before, against its
/// way. So it is at its bound in every round.
///
/// **The last digits.** Where rounds do not end, springs that are hard,
/// \f$\lambda = P_K(\lambda_0 - \rho(J v - w + s n))\f$, are brought into balance with the bodies,
/// \f$M(v-\hat v) = J^{\mathsf T}\lambda\f$, by Newton's steps, each as long as the convex
/// function falls whose slope this is; then \f$\lambda_0\f$ and s follow (augmented Lagrangian). With
/// friction above 1 it is not tried: shifts that follow slides run away there. If it
/// does not end the rounds have the last word: what it leaves on the way is rounding,
/// enlarged by how hard the springs are.
///
/// **From step to step.** Where points creep, s comes nearer by a twentieth in a turn. A shift that is wrong by
/// less than a slop in a step opens no gap; so it may be (IslandLimits::loose), and two or three turns in a step
/// do. The next step goes on from there: each point keeps what it was given (ContactPatchPoint::given).
///
/// Nothing here depends on the axes of the world but by rounding: what is wrong is measured by lengths of
/// vectors, never by components along tangents.
///
/// Rounds that are broken off leave velocities that nearly keep all conditions, and impulses within the
/// cones that nearly belong to them.
/// \par Cost and determinism
/// SparseBlocks::factor() when the island or the place of an area in it has changed since the last call, and
/// SparseBlocks::solve() in each round; the factors of one island are kept. No allocation once warm.
/// \see Boyd et al., "Distributed optimization and statistical learning via the alternating direction
///      method of multipliers", Found. Trends Mach. Learn. 3 (2011).
/// \see De Saxcé, Feng, "The bipotential method", Math. Comput. Model. 28 (1998), for s.
/// \see Acary, Cadoux, Lemaréchal, Malick, "A formulation of the linear discrete Coulomb friction
///      problem via convex optimization", ZAMM 91 (2011).
/// \see Carpentier, Montaut, Le Lidec, "From compliant to rigid contact simulation: a unified and
///      efficient approach", RSS 2024.
/// \algorithm{Contact areas of a island together: section 6.3.1}
class IslandSolver {
 public:
  /// Solves one island.
  /// \param members   indices of the island's movable bodies
  /// \param contacts  places of its areas in `blocks`
  /// \param limits    when to stop
  /// \param free      how the bodies would move without any contact, by index
  /// \param blocks    areas with their targets; impulses in (a start) and out
  /// \param bodies    by index: velocities in (a start) and out
  /// \return how it ended; nothing is changed unless it was tried
  IslandResult solve(std::span<const int> members, std::span<const int> contacts,
                     const IslandLimits& limits, std::span<const MovingBody> free,
                     std::span<ContactPatch> blocks, std::span<MovingBody> bodies);

 private:
  struct Member {
    double mass = 0.0;              // [kg]
    Mat3 inertia_w = Mat3::Zero();  // [kg m²]
    Vec6 free = Vec6::Zero();       // velocity and angular velocity without contacts
    Vec6 now = Vec6::Zero();        // the present ones
  };
  struct Point {
    double along = 0.0, across = 0.0;  // [m] from the middle of the area
    double target = 0.0;               // [m/s] w
    double shift = 0.0;                // [m/s] s
    double yield = 0.0;                // [1/kg] normal velocity of a unit impulse
    double friction = 0.0;             // [-] mu
    Vec3 pushed = Vec3::Zero();        // [N s] lambda: along, across, normal
    Vec3 reached = Vec3::Zero();       // [m/s] z, ditto
    Vec3 slip = Vec3::Zero();          // [-] direction in which it slides too fast to stop, or 0
    bool slides = false;               // whether it does
    Vec3 motion = Vec3::Zero();        // [m/s] u, in polish()
    Vec3 presses = Vec3::Zero();       // [N s] what a hard spring pushes, ditto
    Vec3 way = Vec3::Zero();           // [m/s] how u changes in a whole step of Newton's
    Vec3 pressed = Vec3::Zero();       // [N s] what the spring pushed before that step
    Mat3 follows = Mat3::Zero();       // [kg] how that falls with the motion, ditto
  };
  struct Area {
    int block = 0;    // place in the list
    int first = -1;   // member, or -1 for an immovable body
    int second = -1;  // ditto
    int pair = -1;    // in the matrix
    int begin = 0;    // its points
    int end = 0;      // ditto
  };

  void load(std::span<const int> members, std::span<const int> contacts,
            std::span<const MovingBody> free, std::span<const ContactPatch> blocks,
            std::span<const MovingBody> bodies);
  void load_points(const ContactPatch& block);
  static std::array<double, ContactPatch::kMostPoints> pressures_of(const ContactPatch& block,
                                                                    const Six& since);
  void start_from(std::span<const ContactPatch> blocks, double unit);
  void factor(std::span<const ContactPatch> blocks, bool soft);
  void press(std::span<const ContactPatch> blocks);
  double balance(std::span<const ContactPatch> blocks);
  double go(std::span<const ContactPatch> blocks);
  void go_to(double share, std::span<const ContactPatch> blocks);
  [[nodiscard]] double slope(double share) const;
  void polish(std::span<const ContactPatch> blocks, const IslandLimits& limits,
              IslandResult& result);
  [[nodiscard]] Six motion_now(const Area& area, const ContactPatch& block) const;
  void factor_if_changed(std::span<const ContactPatch> blocks, IslandResult& result);
  void give_way(std::span<const ContactPatch> blocks);
  void put_right(std::span<const ContactPatch> blocks, double& primal, double& dual);
  void store(std::span<const int> members, bool solved, std::span<const MovingBody> free,
             std::span<ContactPatch> blocks, std::span<MovingBody> bodies) const;

  std::vector<int> member_of_;  // by body index, -1 for others
  std::vector<Member> members_;
  std::vector<Area> areas_;
  std::vector<Point> points_;
  std::vector<BlockPair> joined_;
  std::vector<Vec6> x_;
  std::vector<Vec6> from_;
  std::vector<Point> points_before_;
  std::vector<Member> members_before_;
  double unit_mass_ = 1.0;  // [1/kg] a power of two, one over about a body's mass
  double stiffness_ = 0.0;  // [-] rho times yield, the same for all points

  // What the factors belong to: memory from step to step.
  SparseBlocks matrix_;
  double factored_stiffness_ = 0.0;
  std::vector<std::uint64_t> stamps_;
  std::vector<std::uint64_t> wanted_stamps_;
};

}  // namespace tumble
