/// \file
/// \brief Static equilibrium of contacts that only push, and the initial motion without it (thesis 5.4, 6.3.1).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/contact/islands.hpp"
#include "tumble/dynamics/wrench.hpp"
#include "tumble/math/least_squares.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// A force on a body in addition to its weight.
struct Load {
  int body = 0;                 ///< its index
  Vec3 point_w = Vec3::Zero();  ///< [m] point of action, world frame
  Vec3 force_w = Vec3::Zero();  ///< [N] world frame
};

/// Input of a static equilibrium.
struct BalanceTask {
  std::span<const Contact> contacts;  ///< with normals and points of the present poses
  std::span<const Load> loads;        ///< forces in addition to the weights; may be empty
  std::span<const char> held;         ///< by index, not 0: treated as immovable; may be empty
  bool weight = true;                 ///< whether gravity acts
  int friction_edges = 0;             ///< 0: no friction; 4 or more: edges of the friction pyramid
};

/// Cost and result of a static equilibrium.
struct BalanceReport {
  bool balanced = true;              ///< whether every island is in equilibrium
  int unknowns = 0;                  ///< contact forces, of all islands
  int pivots = 0;                    ///< of NonNegativeLeastSquares
  std::int64_t multiplications = 0;  ///< its cost, independent of the machine
};

/// Static equilibrium of bodies at rest: the exact test.
///
/// Contacts push and do not pull. With a column of W for every contact point, the wrenches of a unit force
/// there on all bodies, and w the weights and loads, an island is in equilibrium if there are
/// \f$f \ge 0\f$ with \f$W f + w = 0\f$. They minimise
/// \f[ \tfrac12\,\bigl| S^{\mathsf T} (W f + w) \bigr|^2, \qquad M^{-1} = S S^{\mathsf T}; \f]
/// the minimum always exists and is 0 exactly in equilibrium.
///
/// **Certificate.** Without friction this is Gauss' principle, so \f$a = M^{-1}(W f + w)\f$ is the
/// initial acceleration from rest. It proves that there is no equilibrium: a motion that no contact
/// resists (\f$W^{\mathsf T} a \ge 0\f$) and in which the weights do work (\f$a \cdot w > 0\f$,
/// Farkas). Consequently equilibrium is equivalent to zero accelerations in the complementarity problem
/// of the contact forces; without it, a is the unique solution of that problem.
///
/// **Friction.** Each point force is a combination of the edges of a pyramid inside Coulomb's cone.
/// Equilibrium then means that such forces exist, not that they occur: *weakly stable* (Pang and
/// Trinkle). Without equilibrium the bodies move, but not with acceleration a.
/// \par Cost and determinism
/// For each island about n pivots of O(6 b n) for b bodies and n columns.
/// \see Mattikalli, Baraff, Khosla, Repetto, "Finding stable orientations of assemblies with linear
///      programming", ICRA 1994; Pang and Trinkle, "Stability characterizations of rigid body
///      contact problems with Coulomb friction", ZAMM 80 (2000).
/// \algorithm{Static equilibrium: section 6.3.1}
/// \verified{Balance and the complementarity problem agree on random piles}
class StaticEquilibrium {
 public:
  /// Computes forces in equilibrium.
  /// \param world  the bodies; velocities are ignored
  /// \return cost, and whether all islands are in equilibrium
  /// \throws std::invalid_argument for a contact or a load of an unknown body, a list of held bodies of
  ///         wrong length, or friction_edges of 1 to 3 or below 0
  const BalanceReport& solve(const World& world, const BalanceTask& task);

  /// Bodies in islands in equilibrium, by the last solve().
  /// \return by index, 1 if so; also for held and immovable bodies
  [[nodiscard]] std::span<const char> balanced() const { return balanced_; }

  /// Initial accelerations from rest, by index; 0 up to rounding in equilibrium, 0 for held bodies.
  [[nodiscard]] std::span<const Acceleration> motion() const { return motion_; }

  /// The forces, if in equilibrium; one of many solutions if contacts are redundant.
  /// \return [N] on the second body, one for each point of each contact, in order
  [[nodiscard]] std::span<const Vec3> forces_w() const { return forces_w_; }

 private:
  void load(const World& world, const BalanceTask& task);
  void balance(const World& world, const BalanceTask& task, int island);
  void add_columns(const World& world, const BalanceTask& task, int contact);
  void add_push(const World& world, const Contact& contact, const Vec3& point_w, const Vec3& push_w,
                int column);
  void add_push_on(const World& world, int body, const Vec3& point_w, const Vec3& push_w,
                   int column);
  void take(const World& world, const BalanceTask& task, int island, double scale);

  Islands islands_;
  NonNegativeLeastSquares nearest_;
  LeastSquaresResult result_;
  BalanceReport report_;
  std::vector<char> balanced_;
  std::vector<Acceleration> motion_;
  std::vector<Vec3> forces_w_;
  std::vector<int> first_push_;       // by contact: index of its first point in forces_w_
  std::vector<Mat3> root_inertia_w_;  // by body: S, lower right block
  std::vector<Wrench> acting_;        // by body: weight and loads
  std::vector<double> pushed_;        // by body: [N] sum of contact forces, of one island

  // Of one island.
  std::vector<int> slot_;        // by body: its index within the island
  std::vector<int> push_place_;  // by column: index in forces_w_
  std::vector<Vec3> push_of_w_;  // by column: its unit force
  MatX G_;                       // -Sᵀ W
  VecX d_;                       // Sᵀ w
};

}  // namespace tumble
