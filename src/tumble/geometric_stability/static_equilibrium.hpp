/// \file
/// \brief Whether contacts can hold bodies in balance, and what starts to move if not (thesis 5.4, 6.3.1).
///
/// Uses no other chapter.
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/contact/islands.hpp"
#include "tumble/dynamics/wrench.hpp"
#include "tumble/math/least_squares.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// A force that acts on a body beside its weight.
struct Load {
  int body = 0;                 ///< its index
  Vec3 point_w = Vec3::Zero();  ///< [m] where it acts, world frame
  Vec3 force_w = Vec3::Zero();  ///< [N] world frame
};

/// What is to be balanced.
struct BalanceTask {
  std::span<const Contact> contacts;  ///< with normals and points where the bodies are
  std::span<const Load> loads;        ///< forces beside the weights; may be empty
  std::span<const char> held;  ///< by index, not 0: stays where it is, whatever acts; may be empty
  bool weight = true;          ///< whether gravity acts
  int friction_edges = 0;      ///< 0: no friction; 4 or more: edges of the pyramid of forces
};

/// What one balance took.
struct BalanceReport {
  bool balanced = true;              ///< whether every island is in balance
  int unknowns = 0;                  ///< contact forces that were looked for, of all islands
  int pivots = 0;                    ///< of NonNegativeLeastSquares
  std::int64_t multiplications = 0;  ///< its work, whatever the machine
};

/// Static equilibrium of bodies at rest: the exact test.
///
/// Contacts push and do not pull. With a column of W for every contact point, the wrench of a unit
/// push on all bodies, and w the weights and loads, an island is in balance if there are
/// \f$f \ge 0\f$ with \f$W f + w = 0\f$. They are looked for as the least of
/// \f[ \tfrac12\,\bigl| S^{\mathsf T} (W f + w) \bigr|^2, \qquad M^{-1} = S S^{\mathsf T}, \f]
/// which always exists and is 0 exactly in balance.
///
/// **Certificate.** Without friction this is Gauss' principle, so \f$a = M^{-1}(W f + w)\f$ is how
/// the bodies begin to move from rest. It proves that there is no balance: a motion that no contact
/// resists (\f$W^{\mathsf T} a \ge 0\f$) and in which the weights do work (\f$a \cdot w > 0\f$,
/// Farkas). Two consequences: in balance means that the complementarity problem of the contact forces
/// has no acceleration, and each body's part of a is that problem's, which is unique.
///
/// **Friction.** Each point pushes with a sum of the edges of a pyramid inside of Coulomb's cone.
/// Balance then says that forces exist, not that nature finds them: *weakly stable* (Pang and
/// Trinkle). Without balance the bodies do move, but not as a says.
/// \par Cost and determinism
/// For each island about n pivots of O(6 b n) for b bodies and n columns.
/// \see Mattikalli, Baraff, Khosla, Repetto, "Finding stable orientations of assemblies with linear
///      programming", ICRA 1994; Pang and Trinkle, "Stability characterizations of rigid body
///      contact problems with Coulomb friction", ZAMM 80 (2000).
/// \algorithm{Static equilibrium: section 6.3.1}
/// \verified{Balance and the complementarity problem agree on random piles}
class StaticEquilibrium {
 public:
  /// Looks for forces that balance.
  /// \param world  the bodies where they are; speeds are not looked at
  /// \param task   see there
  /// \return the work, and whether all is in balance
  /// \throws std::invalid_argument for a contact or a load of a body that there is not, a list of
  ///         held bodies of another length, or friction_edges of 1 to 3 or below 0
  const BalanceReport& solve(const World& world, const BalanceTask& task);

  /// Who is in an island that is in balance, by the last solve().
  /// \return by index, 1 if so; held and immovable bodies are
  [[nodiscard]] std::span<const char> balanced() const { return balanced_; }

  /// How bodies begin to move.
  /// \return by index; 0 up to rounding in balance, 0 for held bodies
  [[nodiscard]] std::span<const Acceleration> motion() const { return motion_; }

  /// The forces found, if balanced; one of many if contacts are redundant.
  /// \return [N] on the second body, one for each point of each contact, in order
  [[nodiscard]] std::span<const Vec3> pushes_w() const { return pushes_w_; }

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
  std::vector<Vec3> pushes_w_;
  std::vector<int> first_push_;       // by contact: place of its first point in pushes_w_
  std::vector<Mat3> root_inertia_w_;  // by body: S, lower right block
  std::vector<Wrench> acting_;        // by body: weight and loads
  std::vector<double> pushed_;        // by body: [N] how much its contacts push it, of one island

  // Of one island.
  std::vector<int> slot_;        // by body: its place among those of the island
  std::vector<int> push_place_;  // by column: whose push it is
  std::vector<Vec3> push_of_w_;  // by column: the push of one newton
  MatX G_;                       // -Sᵀ W
  VecX d_;                       // Sᵀ w
};

}  // namespace tumble
