/// \file
/// \brief Impacts at many points, solved at one stroke (thesis 2.6.1, 5.2).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/contact/patch.hpp"
#include "tumble/math/complementarity.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// How a block ended.
enum class SimultaneousStatus : std::uint8_t {
  untouched,   ///< no point approaches that could be moved: nothing was done
  solved,      ///< done
  unsettled,   ///< friction still changed at the last round: some points may still approach
  no_solution  ///< no impulses can keep the bodies apart: they are squeezed by immovable ones
               ///< that move. Nothing was done
};

/// What SimultaneousImpacts::solve() did.
struct SimultaneousResult {
  SimultaneousStatus status = SimultaneousStatus::untouched;  ///< how it ended
  double restitution_share = 1.0;   ///< [-] restitution used, as a share of the one asked for
  double restitution_energy = 0.0;  ///< [J] work of the normal impulses
  double friction_energy = 0.0;     ///< [J] work of the tangential impulses
  int impulses = 0;                 ///< points that were pushed
  int pivots = 0;                   ///< of the complementarity solver
  int rounds = 0;                   ///< of normal impulses and friction in turn
};

/// Resolves the points of some contacts together: those of one contact area, or all there are.
///
/// **Normal impulses.** With A the inverse mass between the points' normals, \f$v^-\f$ their
/// present normal velocities and \f$w_i = \max(0, -e\,a_i)\f$ the separation speed that Newton's
/// restitution asks for at approach speed \f$a_i\f$,
/// \f[ v^+ = A j + v^-, \qquad v^+ - w \ge 0, \quad j \ge 0, \quad j\cdot(v^+ - w) = 0. \f]
/// A is singular when points are redundant; the net impulse on each contact area is used, spread by
/// even_out().
///
/// **Friction** follows PatchFriction, one step at a time, in turn with the normal impulses, which
/// it shifts (a sliding box leans on its leading edge), until it settles.
///
/// **What holds.** (1) No impulse pulls, and friction is within Coulomb's cone at each point.
/// (2) Momentum is kept. (3) Kinetic energy never rises. If all points approach, with one e and no
/// friction, this follows from the problem: \f$E = \tfrac12 j\cdot(v^- + w)
/// = -\tfrac12 \tfrac{1-e}{1+e}\, j A j\f$. Otherwise it need not; then the answer is drawn back
/// towards e = 0, and if that is not enough towards no friction, as solve_impact() does it: E is
/// convex, and e = 0 without friction has \f$E = -\tfrac12 j A j\f$. (4) \f$v^+ \ge 0\f$, up to
/// what friction did in its last step: nothing to speak of, unless the status is `unsettled`.
///
/// If no impulse can give all points the separation speeds asked for (a body between two others,
/// unequal e), all of them get the smallest e of the block, and if that fails, e = 0.
/// `restitution_share` shows.
/// \par Cost and determinism
/// Dense: one complementarity problem of n points for each round. No allocation once warm. Contacts
/// and points in another order give the same velocities to rounding if there is no friction, and
/// with it as closely as friction settles, if the contacts' forces are determinate.
/// \see Baraff, "Fast contact force computation for nonpenetrating rigid bodies", 1994, section 6.
class SimultaneousImpacts {
 public:
  /// How often normal impulses and friction are solved in turn, at most. Reason: a box that lands
  /// flat needs 3 to 8, a stack of 4 that sticks about 60. Of random impacts of one box with
  /// friction up to 0.5 every fiftieth has found no end after 100, nor would it: a step of friction
  /// lifts a corner and the next one sets it down. Heaps that slide at every level do this more
  /// often.
  static constexpr int kMostRounds = 200;

  /// Resolves contacts.
  /// \param contacts  what touches. Approach speeds are those of the event; impulses are added to
  ///                  the ones in the points
  /// \param bodies    how the bodies move, one for each body index; changed
  /// \throws std::invalid_argument if a contact names a body that is not there
  SimultaneousResult solve(std::span<Contact> contacts, std::span<MovingBody> bodies);

 private:
  // What one point's normal does to its two bodies, per unit impulse.
  struct Row {
    int patch = 0;
    bool movable = false;            // whether anything yields along the normal
    std::array<Vec3, 2> lever_w;     // [m] r × n, of the first and of the second body
    std::array<Vec3, 2> velocity_w;  // [1/kg] M⁻¹ n
    std::array<Vec3, 2> spin_w;      // [1/(kg m)] I⁻¹ (r × n)
  };
  using Answer = std::vector<PatchPoint>;

  void load(std::span<const Contact> contacts, std::span<const MovingBody> bodies);
  int place_of(int body, std::span<const MovingBody> bodies);
  void assemble();
  [[nodiscard]] double coupling(const Row& a, const Row& b) const;
  void require_separation(std::span<const Contact> contacts, double largest_restitution);
  [[nodiscard]] Vec3 slip_at(const std::vector<MovingBody>& bodies, std::size_t point) const;
  void apply(const Answer& answer, bool with_normals);
  bool solve_normals(double share, Answer& answer, SimultaneousResult& result);
  bool attempt(double share, bool with_friction, Answer& answer, SimultaneousResult& result);
  void account(const Answer& answer, SimultaneousResult& result);
  [[nodiscard]] double gain(const Answer& answer);
  double draw_back(const Answer& safe, Answer& answer);
  bool guard_energy(SimultaneousResult& result);
  void finish(std::span<Contact> contacts, std::span<MovingBody> bodies);

  std::vector<int> place_;                 // by body index: its place in start_, or -1
  std::vector<int> involved_;              // the body index of each place
  std::vector<MovingBody> start_;          // the bodies as they were
  std::vector<MovingBody> trial_;          // and with an answer applied to them
  std::vector<Patch> patches_;             // one for each contact, its bodies by place
  std::vector<Row> rows_;                  // one for each point
  std::vector<double> separation_speeds_;  // [m/s] w, one for each point
  MatX A_;            // [1/kg] between the points' normals; may be larger than needed
  VecX b_;            // [m/s] normal velocities less those asked for; ditto
  Answer points_;     // no impulses
  Answer answer_;     // the one that is asked for
  Answer inelastic_;  // the one for e = 0
  Answer safe_;       // the one for e = 0 without friction
  PatchFriction friction_;
  ComplementaritySolver solver_;
  ComplementarityResult lcp_;
};

}  // namespace tumble
