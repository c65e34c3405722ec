/// \file
/// \brief Forces of joints in linear time (thesis 2.6.5).
#pragma once

#include "tumble/contact/moving_body.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

using Vec6 = Eigen::Matrix<double, 6, 1>;  ///< a linear part and an angular one
using Mat6 = Eigen::Matrix<double, 6, 6>;  ///< ditto

/// What a joint holds: rows of \f$J\f$ in which the motions of its two bodies add up to 0.
struct JointRows {
  int first = -1;   ///< index of a body
  int second = -1;  ///< index of another one
  int count = 0;    ///< rows in use, 1 to 6, independent of one another in each movable body
  Mat6 on_first =
      Mat6::Zero();  ///< [-], [m] row by row, for velocity and angular velocity; 0 beyond `count`
  Mat6 on_second = Mat6::Zero();  ///< ditto
};

/// Mass and inertia of a body.
/// \param body  movable
/// \return [kg], [kg m²] the inverse of its inverses
Mat6 mass_of(const MovingBody& body);

/// Baraff's Lagrange multipliers in linear time: the forces of all joints, for bodies whose joints form no loop.
///
/// Accelerations a and multipliers λ follow from
/// \f[ \begin{pmatrix} M & -J^{\mathsf T} \\ -J & 0 \end{pmatrix} \begin{pmatrix} a \\ \lambda \end{pmatrix} =
///     \begin{pmatrix} f \\ -c \end{pmatrix} . \f]
/// The matrix has a block for each body and each joint, and one more for each pair of a joint and a body. Bodies and joints form a tree. Taken
/// up with every child before its parent, in depth-first order, each has one neighbour left when its turn comes, its
/// parent: \f$LDL^{\mathsf T}\f$ has no blocks that the matrix has not. A block of D belongs to a body and is positive definite, or
/// to a joint and is negative definite. So no pivot has to be looked for.
///
/// All immovable bodies together are one, the root of the trees that hang on them. Joints that close a loop are left out; see loops().
/// \par Cost and determinism
/// O(bodies + joints), in time and in memory. Digits are lost as the system is stiff: a glued column of n boxes, pushed at its end, turns
/// with an error of about \f$n^4\f$ roundings.
/// \see Baraff, "Linear-time dynamics using Lagrange multipliers", SIGGRAPH 1996.
/// \algorithm{Articulated bodies without loops in linear time: section 2.6.5}
/// \verified{Forces of trees in linear time are those of a dense solver}
/// \verified{Accelerations of chains are those of Featherstone's articulated bodies}
class JointTree {
 public:
  /// Finds the trees.
  /// \param bodies  of which those without inverse mass are immovable
  /// \param joints  each between two bodies of which one is movable at least. Those that close a loop with joints before
  ///                them are loops
  void arrange(std::span<const MovingBody> bodies, std::span<const JointRows> joints);
  /// Factors the matrix.
  /// \param bodies  as given to arrange(), with the present inertia
  /// \param joints  ditto, with the present rows
  /// \return false if rows of a joint depend on one another
  bool factor(std::span<const MovingBody> bodies, std::span<const JointRows> joints);
  /// Solves for accelerations and multipliers.
  /// \param body_part   [N], [N m] f, by body index; then [m/s²], [rad/s²] a. Entries of immovable bodies stay
  /// \param joint_part  [m/s²] or [rad/s²] -c, by joint; then [N], [N m] λ. Entries of loops stay
  void solve(std::span<Vec6> body_part, std::span<Vec6> joint_part);
  /// Joints that are in no tree: indices, ascending.
  [[nodiscard]] std::span<const int> loops() const { return loops_; }
  /// Multiplications since construction.
  [[nodiscard]] std::int64_t multiplications() const { return multiplications_; }
  /// \return [bytes] of the factors
  [[nodiscard]] std::size_t memory() const { return links_.capacity() * sizeof(Link); }

 private:
  // A place in a tree.
  struct Place {
    int body = 0;
    int joint = -1;   // to its parent; -1: it has none
    int parent = -1;  // place of its parent's link, before this one; -1: immovable, or none
  };
  // A body and the joint to its parent.
  struct Link : Place {
    Mat6 body_inverse = Mat6::Zero(), joint_inverse = Mat6::Zero();  // of D
    Mat6 lower = Mat6::Zero();  // of L: the joint's block below the body's
    Mat6 upper = Mat6::Zero();  // of L: the parent's block below the joint's
    Vec6 body_part = Vec6::Zero(), joint_part = Vec6::Zero();
  };
  void hang(const Place& place);

  std::vector<Link> links_;  // depth first, parents before children
  std::vector<int> loops_;
  std::int64_t multiplications_ = 0;

  // Storage of arrange().
  std::vector<int> set_;             // by body: union-find
  std::vector<int> start_, beside_;  // by body: its joints in trees
  std::vector<char> in_tree_;        // by joint
  std::vector<char> hung_;           // by body
  std::vector<Place> waiting_;
};

/// Sets of bodies, united one pair at a time.
class BodySets {
 public:
  /// Each movable body is a set, and all immovable ones are one.
  /// \param bodies  of which those without inverse mass are immovable
  /// \param sets    storage, is overwritten
  BodySets(std::span<const MovingBody> bodies, std::vector<int>& sets);
  /// Unites the sets of two bodies; returns whether they were two until now.
  bool join(int a, int b);
  /// \return whether they are in one set
  [[nodiscard]] bool same(int a, int b) { return root_of(a) == root_of(b); }

 private:
  int root_of(int body);
  std::vector<int>& sets_;
};

}  // namespace tumble
