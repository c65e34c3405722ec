/// \file
/// \brief Contact with friction as one linear complementarity problem (thesis 2.6.3).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/lcp_solvers/lcp.hpp"

#include <span>
#include <vector>

namespace tumble {

/// One point of a contact, as the problem with friction sees it.
///
/// The motion in question is the relative velocity of the point (second body minus first) at the end
/// of a step, or its acceleration at an instant; pushes are then impulses, or forces.
struct FrictionPoint {
  int contact = 0;  ///< index of the contact
  int point = 0;    ///< which of its points
  /// [m/s or m/s²] along the normal: the motion without any push, less what it must not fall below
  double normal_constant = 0.0;
  /// [m/s or m/s²] across the normal: the motion without any push
  Vec3 tangential_constant_w = Vec3::Zero();
  /// [-] length 1 across the normal: the direction in which the second body slides over the first,
  /// so that friction is known to act against it; zero: it sticks, or is free to choose
  Vec3 sliding_w = Vec3::Zero();
  bool rough = true;  ///< if not, friction is left out at this point
};

/// The part of a vector across a normal.
/// \param v  [any]
/// \param n  [-] length 1
inline Vec3 across(const Vec3& v, const Vec3& n) { return v - n.dot(v) * n; }

/// Two directions across a normal for the edges of a pyramid of friction.
///
/// A frame across n cannot follow n all over the sphere without a jump. A cross of two lines, all
/// that a pyramid of 4 or 8 edges needs, can do so everywhere but at the eight space diagonals. This
/// cross has its arms where \f$t_x^4 + t_y^4 + t_z^4\f$, freed of its twofold part, is largest: along
/// the other two axes where n is an axis of the world. With unit tangents u, v and
/// \f$w_k = u_k - i v_k\f$ the arms are at the angles \f$-\tfrac14 \arg \sum_k w_k^4\f$ from u to v
/// and a quarter turn on. n and -n have the same cross.
/// \return a right-handed frame (first, second, normal); which arm comes first, and its sign, jumps
Tangents pyramid_axes(const Vec3& normal_w);

/// Assembles the problem of normal pushes and friction, and reads its answer.
///
/// | symbol | meaning | unit |
/// |---|---|---|
/// | n, μ | normal and coefficient of friction of a point's contact | - |
/// | t_1 .. t_d | directions across n in opposite pairs, 360/d degrees apart | - |
/// | c | push along n, one unknown | N s or N |
/// | β_k | pushes along t_k, d unknowns | N s or N |
/// | λ | speed (acceleration) at which the point slides in the end, one unknown, held as λ/s | as c |
/// | s | the point's own answer to a push along n, nᵀ K n | 1/kg |
/// | u | motion of the point in the end, u = constant + J W Jᵀ pushes | m/s or m/s² |
///
/// A point that may stick or slide has the conditions of Stewart and Trinkle,
/// \f[ 0 \le c \perp n\cdot u \ge 0, \qquad
///     0 \le \beta_k \perp \lambda + t_k\cdot u \ge 0, \qquad
///     0 \le \lambda \perp \mu\,c - \textstyle\sum_k \beta_k \ge 0 : \f]
/// friction is in the pyramid \f$\sum\beta \le \mu c\f$ that the t_k span, and where the point slides
/// it is on the surface, along the edge most opposed to the sliding. A point that is known to slide
/// along a unit vector T has one unknown, c, which pushes with \f$c\,(n - \mu T)\f$, and so has one
/// without friction, with c n.
///
/// A pyramid is weaker than Coulomb's cone between its edges: at least \f$\mu\cos(180°/d)\f$ in all
/// directions, 0.7071 μ for d = 4 and 0.9239 μ for d = 8, if what resists is as stiff all round.
///
/// **The matrix.** Rows of λ are multiplied and the unknown divided by s, so that all unknowns, and
/// all rows, have one unit. One point that is free to choose gives
/// \f[ A = \begin{pmatrix} n^{\mathsf T}Kn & n^{\mathsf T}KT & 0\\ T^{\mathsf T}Kn & T^{\mathsf T}KT
///     & s\mathbf 1\\ s\mu & -s\mathbf 1^{\mathsf T} & 0\end{pmatrix} \f]
/// with T the columns t_k. A is not symmetric. Without points that slide by decree it is copositive,
/// and Lemke's method finds a solution for every constant part as far as the normal constants are
/// motions that some motion of the bodies has or exceeds (Anitescu and Potra): if the bodies can
/// move so that no point sinks. With them there may be no solution, or two: Painlevé's paradox.
/// Without friction A is symmetric and positive semidefinite.
/// \par Cost and determinism
/// O(N²) for N unknowns, with a 3×3 matrix for each pair of points of one body. No allocation as
/// long as N stays the same.
/// \see Stewart, Trinkle, "An implicit time-stepping scheme for rigid body dynamics with inelastic
///      collisions and Coulomb friction", Int. J. Numer. Methods Eng. 39, 1996; Anitescu, Potra,
///      "Formulating dynamic multi-rigid-body contact problems with friction as solvable linear
///      complementarity problems", Nonlinear Dynamics 14, 1997.
/// \algorithm{Contact with a pyramid of friction: section 2.6.3}
/// \verified{One step of a sliding particle is Stewart and Trinkle's solution}
class FrictionPyramid {
 public:
  /// Sets up the problem.
  /// \param bodies      how easily they are moved, one for each body index; velocities are not read
  /// \param directions  of the pyramid: 4 or 8; 0 leaves friction out altogether
  /// \throws std::invalid_argument for another number of directions, an index out of range, a
  ///         constant that is not finite, or a sliding direction that is neither 0 nor of length 1
  void assemble(std::span<const MovingBody> bodies, std::span<const Contact> contacts,
                std::span<const FrictionPoint> points, int directions);

  /// How large a problem would be: N; 0 if no point has friction, so that the problem is a symmetric one.
  [[nodiscard]] static int unknowns(std::span<const Contact> contacts,
                                    std::span<const FrictionPoint> points, int directions);

  /// The problem: A and b, without factors; the unknowns point by point, each one's c, β, λ.
  [[nodiscard]] const LcpProblem& lcp() const { return lcp_; }

  /// Whether any point has friction; if not, the matrix is symmetric and positive semidefinite.
  [[nodiscard]] bool has_friction() const { return has_friction_; }

  /// What the answer pushes with.
  /// \param f     (N) the answer of a solver
  /// \param push  [N s or N] is overwritten: one for each point, on the second body, world frame
  /// \throws std::invalid_argument if there are not N numbers
  void pushes(std::span<const double> f, std::vector<Vec3>& push) const;

 private:
  // What an unknown does: it pushes along push_w, and its row looks at the motion along look_w.
  // Unknowns of λ have neither.
  struct Unknown {
    int point = 0;
    Vec3 look_w = Vec3::Zero();
    Vec3 push_w = Vec3::Zero();
  };
  // The unknowns of a point: c, then d times β and λ, or none of these.
  struct Range {
    int first = 0;
    int directions = 0;
    [[nodiscard]] int count() const { return directions > 0 ? directions + 2 : 1; }
  };

  void list_unknowns(std::span<const Contact> contacts, std::span<const FrictionPoint> points,
                     int directions);
  void couple(int i, int j, const Mat3& yield);
  void add_sliding(int point, double friction);

  LcpProblem lcp_;
  std::vector<Unknown> unknowns_;  // (N)
  std::vector<Range> ranges_;      // one for each point
  bool has_friction_ = false;
};

}  // namespace tumble
