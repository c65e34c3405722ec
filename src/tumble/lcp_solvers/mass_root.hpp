/// \file
/// \brief A root of a body's inverse inertia (thesis 2.6.2).
#pragma once

#include "tumble/base/types.hpp"

namespace tumble {

/// The lower triangular S with S Sᵀ = B, by Cholesky's method.
///
/// Where B does not yield, neither does S: a pivot that is only rounding (`tolerance::rigid`) leaves a
/// column of zeros.
/// \param inverse_inertia_w [1/(kg m²)] B, symmetric and positive semidefinite
/// \return [(kg m²)^-1/2] S
Mat3 root_of(const Mat3& inverse_inertia_w);

}  // namespace tumble
