/// \file
/// \brief The separation tensor of a node.
#include "tumble/previous_work/crack.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

// m(a) = a a' / |a|
Mat3 spread(const Vec3& a) {
  const double length = a.norm();
  return length > 0.0 ? Mat3(a * a.transpose() / length) : Mat3(Mat3::Zero());
}

// The gradient of a node in one of its elements.
Vec3 gradient_at(const Tetrahedron& element, int node) {
  const auto at = std::find(element.nodes.begin(), element.nodes.end(), node);
  return element.gradients.row(at - element.nodes.begin()).transpose();
}

}  // namespace

NodeSeparation separation_at(const ElasticMesh& mesh, int node) {
  // [S2.4.1:separation]
  NodeSeparation found;
  Vec3 all_tensile = Vec3::Zero(), all_compressive = Vec3::Zero();
  for (const int k : mesh.star[idx(node)]) {
    const Tetrahedron& element = mesh.elements[idx(k)];
    const ElementStress now = stress_of(mesh, element);
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(now.stress);
    const Mat3& axes = principal.eigenvectors();
    const Mat3 tensile =
        axes * principal.eigenvalues().cwiseMax(0.0).asDiagonal() * axes.transpose();
    const Vec3 g = gradient_at(element, node);
    const Vec3 pull = -element.volume * (now.deformation * (tensile * g));
    const Vec3 push = -element.volume * (now.deformation * ((now.stress - tensile) * g));
    all_tensile += pull;
    all_compressive += push;
    found.tensor += spread(pull) - spread(push);
  }
  found.tensor = 0.5 * (found.tensor - spread(all_tensile) + spread(all_compressive));
  const Eigen::SelfAdjointEigenSolver<Mat3> most(found.tensor);
  found.force = most.eigenvalues()[2];
  found.normal_w = most.eigenvectors().col(2);
  // [S2.4.1:separation]
  for (const int k : mesh.star[idx(node)]) {
    const Tetrahedron& element = mesh.elements[idx(k)];
    const Vec3 normal =  // in the body at rest
        (stress_of(mesh, element).deformation.transpose() * found.normal_w).normalized();
    found.area += 0.5 * element.volume * std::abs(gradient_at(element, node).dot(normal));
  }
  return found;
}

}  // namespace tumble
