/// \file
/// \brief The matrix of a contact problem as the product that it came from (thesis 2.6.2).
#pragma once

#include "tumble/base/types.hpp"

#include <vector>

namespace tumble {

/// A = J W Jᵀ: from contact forces to forces on bodies, to their accelerations, to those at the contacts.
///
/// The acceleration of a body is \f$(\dot v, \dot\omega)\f$ in the world frame, 6 numbers. J has a
/// row for each row of the problem, with at most two bodies in it, and W a block for each body.
struct LcpFactors {
  /// One row of J: which relative acceleration is looked at.
  ///
  /// For a contact at p with normal n from the first to the second body these are (-n, -r × n) and
  /// (n, r × n), r from the body's centre of mass to p.
  struct Row {
    int first = -1;                        ///< index into bodies; -1: scenery
    int second = -1;                       ///< another index into bodies; -1: scenery
    Vec3 linear_first_w = Vec3::Zero();    ///< [-] is multiplied by \f$\dot v\f$ of the first body
    Vec3 angular_first_w = Vec3::Zero();   ///< [m] is multiplied by its \f$\dot\omega\f$
    Vec3 linear_second_w = Vec3::Zero();   ///< [-] the same for the second body
    Vec3 angular_second_w = Vec3::Zero();  ///< [m] the same for the second body
  };

  /// One block of W: how easily a body is moved.
  struct Body {
    Vec3 inverse_mass = Vec3::Zero();       ///< [1/kg] along the world's axes; 0 is immovable
    Mat3 inverse_inertia_w = Mat3::Zero();  ///< [1/(kg m²)] symmetric positive semidefinite
  };

  std::vector<Row> rows;     ///< (n) or empty: not known
  std::vector<Body> bodies;  ///< in any order
};

/// Refuses factors that make no sense.
/// \throws std::invalid_argument for a body's index out of range, twice the same body in a row, a
///         number that is not finite, or a negative inverse mass or diagonal entry of an inverse
///         inertia
void require_valid(const LcpFactors& factors);

/// A = J W Jᵀ.
/// \param A        [1/kg] (n×n) the product, exactly symmetric; overwritten, its storage is used
///                 again
/// \throws std::invalid_argument as require_valid()
/// \par Cost
/// O(n²).
void multiply_out(const LcpFactors& factors, MatX& A);

}  // namespace tumble
