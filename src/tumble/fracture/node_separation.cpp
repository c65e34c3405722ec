/// \file
/// \brief The separation tensor of a node.
#include "tumble/fracture/crack.hpp"

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

const TensileStress& TensileStresses::of(int element) {
  int& place = places_[idx(element)];
  if (place < 0) {
    place = static_cast<int>(stresses_.size());
    TensileStress found{stress_of(mesh_, mesh_.elements[idx(element)]), Mat3::Zero()};
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(found.all.stress);
    const Mat3& axes = principal.eigenvectors();
    found.tensile = axes * principal.eigenvalues().cwiseMax(0.0).asDiagonal() * axes.transpose();
    stresses_.push_back(found);
  }
  return stresses_[idx(place)];
}

NodeSeparation separation_at(TensileStresses& stresses, int node) {
  const ElasticMesh& mesh = stresses.mesh();
  // [S2.4.1:separation]
  NodeSeparation found;
  Vec3 all_tensile = Vec3::Zero(), all_compressive = Vec3::Zero();
  for (const int k : mesh.star[idx(node)]) {
    const Tetrahedron& element = mesh.elements[idx(k)];
    const auto& [now, tensile] = stresses.of(k);
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
        (stresses.of(k).all.deformation.transpose() * found.normal_w).normalized();
    found.area += 0.5 * element.volume * std::abs(gradient_at(element, node).dot(normal));
  }
  return found;
}

}  // namespace tumble
