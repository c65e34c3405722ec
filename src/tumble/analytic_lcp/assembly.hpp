/// \file
/// \brief From bodies that rest on each other to the linear complementarity problem of the forces
///        between them (thesis 2.6, 3.3.1).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/dynamics/wrench.hpp"
#include "tumble/lcp_solvers/lcp.hpp"

#include <span>
#include <vector>

namespace tumble {

/// Where a row of the problem comes from.
struct ContactRow {
  int contact = 0;  ///< index of the contact
  int point = 0;    ///< which of its points
};

/// The acceleration of a body's material at a point that it carries along,
/// \f$\dot v + \dot\omega \times r + \omega \times (\omega \times r)\f$.
/// \return [m/s²] world frame
Vec3 acceleration_at(const MovingBody& body, const Acceleration& acceleration, const Vec3& point_w);

/// How bodies accelerate while nothing touches them: gravity, and the tumbling of a free body.
///
/// \f[ \dot v = g, \qquad \dot\omega = I_w^{-1}\,(L \times \omega), \quad L = I_w\,\omega . \f]
/// Other forces, if there are any, are the caller's to add by accelerate().
/// \param world   masses, orientations, gravity
/// \param bodies  how they move, one for each body index. What cannot be moved (an inverse of 0) is
///                not accelerated, along that axis
/// \param out     is overwritten, one for each body index; its capacity is kept
/// \throws std::invalid_argument if there is not one entry of `bodies` for each body
void free_accelerations(const World& world, std::span<const MovingBody> bodies,
                        std::vector<Acceleration>& out);

/// Adds what forces do to the motion of bodies, \f$m^{-1} F\f$ and \f$I_w^{-1} \tau\f$.
/// \param accelerations  one for each body; added to
/// \throws std::invalid_argument if the lengths differ
void accelerate(std::span<const MovingBody> bodies, std::span<const Wrench> wrenches,
                std::span<Acceleration> accelerations);

/// How the normal of a contact turns: that of a face with the body that the face belongs to, that
/// of two edges with both.
///
/// Face: \f$\dot n = \omega_{owner} \times n\f$. Edges e of the first and h of the second body:
/// \f$n = \pm c/|c|\f$ with \f$c = e \times h\f$, so
/// \f[ \dot n = \pm\frac{(1 - n n^{\mathsf T})\,\dot c}{|c|}, \qquad
///     \dot c = (\omega_1 \times e) \times h + e \times (\omega_2 \times h). \f]
/// Contact::axis says which. The ground's normal stays. Where two faces rest flat on each other it
/// does not matter whose it is. Where a box has just begun to tip over its edge, contacts may name
/// its own face instead of the one that the edge lies on, until it is tilted by
/// `tolerance::face_preference_length` or so; the second derivative of the gap is then off by at most
/// twice the relative angular velocity times the speed at which the edge slides.
/// \param contact  found at the present poses
/// \return [1/s] across the normal, world frame
/// \throws std::invalid_argument for a body or an axis that there is not, or edges that are
///         parallel by now
Vec3 rate_of_normal(const World& world, std::span<const MovingBody> bodies, const Contact& contact);

/// The problem of the contact forces: what they must be for no surfaces to sink into each other.
///
/// Row i is a point p where a force \f$f_i \ge 0\f$ along the normal n pushes the second body, and
/// its opposite the first one. The gap there is \f$n \cdot (p_2 - p_1)\f$, with a material point of
/// each body; at the moment at which the two meet its second derivative is
/// \f[ a_i = n\cdot(\ddot p_2 - \ddot p_1) + 2\,\dot n\cdot(\dot p_2 - \dot p_1)
///         = \sum_j A_{ij} f_j + b_i . \f]
/// With J the rows \f$(-n,\; -r_1\times n,\; n,\; r_2\times n)\f$ and W the inverse masses and
/// inertias, \f$A = J W J^{\mathsf T}\f$ is symmetric and positive semidefinite. Its rank is at most
/// 6 for each movable body, so with four corners to a box it is singular and the forces are not
/// unique; what they do to the bodies is. b is the same second derivative without contact forces,
/// from \f$\ddot p = \dot v + \dot\omega\times r + \omega\times(\omega\times r)\f$ and the turning
/// normal. Forget that last term, and a box that rolls over its edge while it slides is held down or
/// thrown up.
///
/// All this holds for points that touch and neither part nor approach. One that parts needs no force
/// and is left out. One that approaches is a collision, to be resolved before; if it is slow enough
/// for the caller it has a row, and goes on approaching at that speed.
/// \par Cost and determinism
/// O(n²) for n rows. No allocation once warm, as long as n stays the same.
/// \see Lötstedt, "Mechanical systems of rigid bodies subject to unilateral constraints", SIAM J.
///      Appl. Math. 42, 1982; Baraff, "Analytical methods for dynamic simulation of non-penetrating
///      rigid bodies", SIGGRAPH 1989.
/// \algorithm{The problem of contact forces: section 3.3.1}
/// \verified{The constant part is the second derivative of the gap of 1000 pairs in free flight}
class ContactProblem {
 public:
  /// Sets up the problem of an instant.
  /// \param free           how they accelerate without contact forces, see free_accelerations()
  /// \param contacts       what touches, found at the present poses. Distances are not looked at:
  ///                       b is without the terms in proportion to them
  /// \param separation_speed  [m/s] points that part faster have no row; infinity: every point has one
  /// \throws std::invalid_argument if `bodies` or `free` have not one entry for each body, a contact
  ///         names a body or an axis that there is not, or the speed is negative or not a number
  void assemble(const World& world, std::span<const MovingBody> bodies,
                std::span<const Acceleration> free, std::span<const Contact> contacts,
                double separation_speed);

  /// Asks for more, or less, than that no surfaces sink into each other.
  /// \param terms  [m/s²] one for each row, added to b: with a term c the row asks for an acceleration
  ///               of at least -c
  /// \throws std::invalid_argument if there is not one for each row
  void add_to_b(std::span<const double> terms);

  /// The problem, with the factors of its matrix: A, b; no equalities.
  [[nodiscard]] const LcpProblem& lcp() const { return lcp_; }

  /// Where the rows come from: one for each row, in the order of contacts and points.
  [[nodiscard]] std::span<const ContactRow> rows() const { return rows_; }

  /// How many points have no row because they part.
  [[nodiscard]] int separating() const { return separating_; }

  /// How fast the points with a row approach: a collision was missed if this is large.
  /// \return [m/s] the fastest; 0 if none approaches
  [[nodiscard]] double fastest_approach() const { return fastest_approach_; }

  /// Adds what contact forces exert on the bodies, \f$J^{\mathsf T} f\f$; accelerate() finds
  /// the accelerations.
  /// \param f         [N] a force for each row
  /// \param wrenches  one for each body index; those of movable bodies are added to
  /// \throws std::invalid_argument if there is not one force for each row, or not one wrench for
  ///         each body
  void add_wrenches(std::span<const double> f, std::span<Wrench> wrenches) const;

 private:
  int place_of(int body, const World& world, std::span<const MovingBody> bodies);
  void add_row(const World& world, std::span<const MovingBody> bodies, const Contact& contact,
               const Vec3& point_w);

  LcpProblem lcp_;
  std::vector<ContactRow> rows_;
  std::vector<double> constant_;  // b while it grows
  std::vector<int> involved_;     // the body index of each block of W
  std::vector<int> place_;        // by body index: its block, or -1
  int separating_ = 0;
  double fastest_approach_ = 0.0;
};

}  // namespace tumble
