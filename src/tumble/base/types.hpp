/// \file
/// \brief The linear algebra types that every layer shares.
#pragma once

// Eigen's vector instructions add in another order than its scalar code, and differ between
// targets. Two translation units that disagree about them would also disagree about bits (and,
// worse, about alignment). The CMake target passes this definition on; so must any other build.
#ifndef EIGEN_DONT_VECTORIZE
#error "Tumble: compile with -DEIGEN_DONT_VECTORIZE (link tumble::tumble and CMake does it)."
#endif
#ifndef EIGEN_MPL2_ONLY
#error "Tumble: compile with -DEIGEN_MPL2_ONLY (link tumble::tumble and CMake does it)."
#endif

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>

/// A reference implementation of Egan's *Techniques for Real-Time Rigid Body Simulation* (2003).
///
/// Conventions everywhere: SI units, radians, y up, ground at y = 0, full edge lengths for sizes,
/// quaternions w x y z from body to world, contact normals from the first body to the second.
/// A vector that could live in two frames carries its frame as a suffix: `_w` world, `_b` body.
/// Usual names mean the same in every function: `dt` is the step, above 0; `point_w` and `position_w` are places, `normal_w`
/// is a direction of length 1, `orientation_wb` takes vectors of a body to the world, `omega_w` is an angular velocity, and
/// `restitution` is from 0 to 1.
namespace tumble {

using Vec2 = Eigen::Vector2d;  ///< two components
using Vec3 = Eigen::Vector3d;  ///< three components
using Mat2 = Eigen::Matrix2d;  ///< 2×2
using Mat3 = Eigen::Matrix3d;  ///< 3×3
using VecX = Eigen::VectorXd;  ///< run-time size; storage only, see MatX
/// Run-time size, column by column; storage only: Eigen's products of such matrices block by the
/// size of the cache and so change the order of sums between machines. Use math/dense.hpp.
using MatX = Eigen::MatrixXd;
using Quat = Eigen::Quaterniond;  ///< orientation, body to world; constructor order w x y z

/// Name of a body, given once by World and never used again for another body.
///
/// Ids grow with time, so sorting by id is sorting by age: the only order in which bodies and
/// pairs of bodies are ever visited.
enum class BodyId : std::uint32_t {};

/// The number behind an id, for printing and hashing: its number, from 0.
constexpr std::uint32_t number_of(BodyId id) { return static_cast<std::uint32_t>(id); }

}  // namespace tumble
