/// \file
/// \brief One step from velocities to velocities with contact and friction (thesis 2.6.3).
#pragma once

#include "tumble/analytic_lcp/assembly.hpp"
#include "tumble/analytic_lcp/friction_lemke.hpp"
#include "tumble/analytic_lcp/friction_pyramid.hpp"
#include "tumble/analytic_lcp/friction_sweeps.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/contact/islands.hpp"
#include "tumble/contact/sticky.hpp"
#include "tumble/lcp_solvers/baraff.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// Condition on the normal velocity of a point.
enum class SteppingForm : std::uint8_t {
  /// A point may close its gap g within the step, and no more: n·u >= -g/h. Points count before they touch, so
  /// that no body is passed.
  stewart_trinkle,
  /// A point that touches may not approach: n·u >= 0. Other points do not count, and a body
  /// that arrives during the step overlaps at its end.
  anitescu_potra
};

/// Options of a step.
struct VelocityStepOptions {
  int directions = 8;                                 ///< of the pyramid of friction: 4 or 8
  SteppingForm form = SteppingForm::stewart_trinkle;  ///< condition on normal velocities
  StickyOptions sticky;                               ///< rule for impacts that do not bounce
};

/// Result of a step.
struct VelocityStepResult {
  bool solved = true;  ///< if not, nothing was changed; see VelocityStep::problem()
  int points = 0;      ///< points in the problems
  int impulses = 0;    ///< points that push
  int pivots = 0;      ///< of all solvers
  /// islands whose restitution was left out or reduced, or that were solved by sweeps
  int fallbacks = 0;
  double residual = 0.0;  ///< [-] largest error of an answer over the speeds of its island
  double restitution_energy = 0.0;  ///< [J] work of the normal impulses, p·(u⁻ + u⁺)/2
  double friction_energy = 0.0;     ///< [J] the same of the tangential impulses
};

/// Solves for the impulses of a step, those of contacts and of impacts together (thesis 2.6.3).
///
/// With h the step, v⁻ the velocities at its start and a the accelerations without contact, look for
/// impulses p at the points such that
/// \f[ v^+ = v^- + h\,a + W J^{\mathsf T} p, \qquad
///     0 \le p_n \perp n\cdot u^+ + \max(g, 0)/h \ge 0 \f]
/// and p_t is within the pyramid of friction and against the sliding of u⁺ (FrictionPyramid). A
/// collision is a point with a large impulse; otherwise it is treated as a resting contact. What overlaps
/// (g < 0) is not pushed apart: that would give it speed. Move it, see OverlapRepair.
///
/// **There is always a solution** with e = 0, for Painlevé's rod too, since an impulse is finite where a force is not.
/// With friction A is copositive, and v⁺ = 0 satisfies all conditions on normals: so Lemke's method ends with a solution,
/// in exact arithmetic. With rounding about one in ten thousand islands of cubes that have turned by a millionth has none.
///
/// **Sweeps** (FrictionSweeps, counted in `fallbacks`) solve these islands, those with more than
/// FrictionLemkeSolver::kMostUnknowns, and, without friction, those above FrictionLemkeSolver::kMostToTryAll that need more
/// than four pivots for each point. If they end before they converge (`residual`), their impulses with e = 0 are scaled
/// down until they add no energy.
///
/// **Energy.** With e = 0 impulses only remove energy: their work after the accelerations have acted is
/// \f$p\cdot u^+ - \tfrac12 p\,A\,p\f$, and no term of \f$p\cdot u^+\f$ is above 0. If a = 0 the
/// kinetic energy does not rise.
///
/// **Restitution** is not part of the method. Newton's is added: a point that approaches with
/// u_n⁻ < 0 and touches, or would by the end of the step, has \f$n\cdot u^+ \ge w\f$ instead,
/// \f$\tfrac12 w^2 + w\,c = \tfrac12 (e\,u_n^-)^2\f$ with the speed c that gravity takes from it in a step, so that
/// e² of the energy stays, unless it is slow enough to stick. It so turns back up to \f$h\,|u_n^-|\f$ early. Points that
/// collide together can ask for what no motion gives, and restitution at several points or with friction
/// may add energy. What counts is the energy at the end of the step if pushed bodies then move by \f$h\,v^+\f$,
/// \f[ \Delta E = \sum p\cdot\tfrac12(u^- + u^+) - \tfrac h2 \sum m\,g\cdot(v^+ - v^-) : \f]
/// neither gravity's share h g nor the height of an early turn is for nothing.
/// Corners of a face that arrive together but for a slop bounce together.
/// Then (`fallbacks`) the group of bodies is solved with e = 0 as well, and the answer is the
/// point of the straight line from there to the other solution that is closest to the latter among
/// those whose \f$\Delta E\f$ is not above 0, or the solution for e = 0 if there is no other. Every convex combination of two answers holds points apart and friction in its pyramid.
/// \par How it is solved
/// Each island by itself, with no more of it than matters. Points that are apart and would not meet are
/// left out, and so is friction; BaraffSolver solves that. If points then meet they are taken up, and if
/// any rough point slides that pushes, all that push get friction and FrictionLemkeSolver goes on, until
/// nothing is missing: a point that does not push rubs neither, and one that does not slide needs no
/// friction, so the last answer is one of the whole problem.
///
/// An answer of Lemke's method counts if it holds to `tolerance::step_residual`, whatever the solver says.
/// \par Cost and determinism
/// O(N³) for an island with N unknowns, 2 + d for each point that rubs, 1 for others. No allocation as long as islands have the
/// sizes that they had.
/// \see Stewart, Trinkle 1996; Anitescu, Potra 1997 (see FrictionPyramid).
/// \algorithm{A time step with impacts and contact alike: section 2.6.3}
/// \deviation{Stewart and Trinkle push overlapping bodies apart by velocities; here bodies are moved.}
/// \verified{Without restitution and forces no step raises the kinetic energy of 1000 random states}
class VelocityStep {
 public:
  /// Finds the velocities at the end of a step.
  /// \param world     constant parts and gravity, for scales and to see which bodies are immovable
  /// \param free      how bodies accelerate without contact, one for each body index
  /// \param contacts  what touches or may, gathered with the velocities of the start: approach speeds
  ///                  are read, impulses are overwritten
  /// \param dt        [s] h
  /// \param bodies    how they move and how easily they are moved, one for each body index; unless
  ///                  solved they stay as they are
  /// \throws std::invalid_argument if there is not one entry of `free` and of `bodies` for each body, a
  ///         contact names a body that there is not, dt is not above 0, or an option is out of range
  VelocityStepResult solve(const World& world, std::span<const Acceleration> free,
                           std::span<Contact> contacts, double dt,
                           const VelocityStepOptions& options, std::span<MovingBody> bodies);

  /// The problem that the last step has not solved; valid until the next step; nullptr if it has solved all.
  [[nodiscard]] const LcpProblem* problem() const {
    return failed_ && used_pyramids_ > 0 ? &pyramids_[used_pyramids_ - 1].lcp() : nullptr;
  }

 private:
  // For each row of a problem without friction that sweeps can take over: a path that arrives takes one.
  static constexpr int kPivotsOfLarge = 4;

  // A point that may push.
  struct Candidate {
    int contact = 0;
    int point = 0;
    bool taken_up = false;         // in the problem
    bool rubs = false;             // with friction
    double floor = 0.0;            // [m/s] n·u must not end below this with e = 0
    double bounce_floor = 0.0;     // [m/s] nor below this with restitution
    Vec3 push_w = Vec3::Zero();    // [N s] on the second body
    Vec3 bounce_w = Vec3::Zero();  // [N s] the same with restitution
  };
  // One call's arguments.
  struct Task {
    const World* world = nullptr;
    std::span<const MovingBody> start;  // without gravity of the step
    std::span<Contact> contacts;
    double dt = 0.0;
    VelocityStepOptions options;
  };

  // What pushes do to the energy.
  struct Work {
    double of_pushes = 0.0;  // [J]
    double rounding = 0.0;   // [J] of it
  };

  // [m/s] Velocity of the second body against the first at a point.
  static Vec3 motion(std::span<const MovingBody> bodies, const Contact& contact,
                     const Vec3& place_w) {
    return relative_velocity(bodies[static_cast<std::size_t>(contact.first)],
                             bodies[static_cast<std::size_t>(contact.second)], place_w);
  }
  bool solve_island(const Task& task, int island, VelocityStepResult& result);
  bool list_candidates(const Task& task, std::span<const int> contacts);
  bool find_pushes(const Task& task, int island, bool bounce, VelocityStepResult& result);
  void list_points(std::span<const Contact> contacts, bool bounce);
  bool solve_points(const Task& task, VelocityStepResult& result);
  void take_pushes();
  [[nodiscard]] bool is_large(const Task& task) const;
  bool sweep(const Task& task, int island, bool bounce, VelocityStepResult& result);
  void take_no_energy(const Task& task, int island);
  [[nodiscard]] double error_of(const LcpProblem& problem) const;
  void apply_pushes(const Task& task, int island);
  bool take_up_friction(std::span<const Contact> contacts);
  bool take_up_missed(std::span<const Contact> contacts, bool bounce);
  void go_towards_bounce(const Task& task, int island, const Work& bounce);
  [[nodiscard]] static Vec3 gain_of(const Task& task, const Contact& contact, const Vec3& mean_w);
  [[nodiscard]] Work work(const Task& task) const;
  [[nodiscard]] double work_of_gravity(const Task& task, int island);
  [[nodiscard]] double least_gap(const Task& task, const Contact& contact) const;
  void store(std::span<Contact> contacts, std::span<MovingBody> bodies,
             VelocityStepResult& result) const;

  // The points of the present island.
  [[nodiscard]] std::span<Candidate> candidates() {
    return std::span<Candidate>(candidates_).subspan(first_);
  }
  [[nodiscard]] std::span<const Candidate> candidates() const {
    return std::span<const Candidate>(candidates_).subspan(first_);
  }

  Islands islands_;
  std::vector<MovingBody> free_;   // at the end of the step if nothing pushes
  std::vector<MovingBody> ended_;  // with the pushes found so far
  std::vector<char> pushed_;       // by body index: not 0 if something pushes it
  std::vector<Candidate> candidates_;
  std::size_t first_ = 0;  // where those of the present island begin
  std::vector<FrictionPoint> points_;
  std::vector<Vec3> pushes_;
  std::vector<FrictionPyramid> pyramids_;  // one for each problem of a step, for their storage
  std::size_t used_pyramids_ = 0;          // of them, in this step
  bool failed_ = false;                    // at the last of these
  double speed_ = 0.0;                     // [m/s] the fastest point of the island, as a scale
  BaraffSolver smooth_solver_;
  BaraffSolver hasty_solver_{kPivotsOfLarge};  // of large problems: sweeps do what it does not
  FrictionLemkeSolver rough_solver_;
  FrictionSweeps sweeps_;
  LcpResult answer_;
};

}  // namespace tumble
