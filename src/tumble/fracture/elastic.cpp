/// \file
/// \brief Tetrahedra under strain.
#include "tumble/fracture/elastic.hpp"

#include "tumble/base/error.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace tumble {
namespace {

constexpr std::array<std::array<int, 3>, 6> kOrders{
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

// aᵀ a, half of which is computed.
Mat3 squared(const Mat3& a) {
  Mat3 m;
  for (int j = 0; j < 3; ++j)
    for (int i = j; i < 3; ++i) m(i, j) = m(j, i) = a.col(i).dot(a.col(j));
  return m;
}

Mat3 symmetric(const Mat3& a) { return 0.5 * (a + a.transpose()); }

Mat3 isotropic(double lambda, double mu, const Mat3& strain) {
  return lambda * strain.trace() * Mat3::Identity() + 2.0 * mu * strain;
}

// Of the elements: sum of a field of the nodes times the gradients.
template <class Field>
Mat3 gradient(const Tetrahedron& element, const Field& field) {
  const auto& g = element.gradients;
  const Vec3 &a = field(element.nodes[0]), &b = field(element.nodes[1]),
             &c = field(element.nodes[2]), &d = field(element.nodes[3]);
  Mat3 sum;
  for (int k = 0; k < 3; ++k) sum.col(k) = a * g(0, k) + b * g(1, k) + c * g(2, k) + d * g(3, k);
  return sum;
}

// m + 2 sqrt(J2 / 3): no principal stress is above it.
double most_tension(const Mat3& stress) {
  const double mean = stress.trace() / 3.0;
  return mean + std::sqrt(2.0 / 3.0) * (stress - mean * Mat3::Identity()).norm();
}

}  // namespace

double ElasticMaterial::wave_speed() const { return std::sqrt((lambda + 2.0 * mu) / density); }

ElasticMaterial elastic_material(double young, double poisson, double density, double strength,
                                 double damping) {
  require::positive(young, "young [Pa]");
  require::that(poisson >= 0.0 && poisson < 0.5,
                "poisson = " + std::to_string(poisson) + ": give at least 0 and less than 0.5");
  require::positive(density, "density [kg/m3]");
  require::positive(strength, "strength [Pa]");
  require::not_negative(damping, "damping [s]");
  const double lambda = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  const double mu = young / (2.0 * (1.0 + poisson));
  return {lambda, mu, damping * lambda, damping * mu, density, strength};
}

double ElasticMesh::mass() const {
  double sum = 0.0;
  for (const ElasticNode& node : nodes) sum += node.mass;
  return sum;
}

Vec3 ElasticMesh::momentum_w() const {
  Vec3 sum = Vec3::Zero();
  for (const ElasticNode& node : nodes) sum += node.mass * node.velocity_w;
  return sum;
}

double ElasticMesh::kinetic_energy() const {
  double sum = 0.0;
  for (const ElasticNode& node : nodes) sum += 0.5 * node.mass * node.velocity_w.squaredNorm();
  return sum;
}

double ElasticMesh::elastic_energy() const {
  double sum = 0.0;
  for (const Tetrahedron& element : elements) {
    const Mat3 F =
        gradient(element, [&](int node) -> const Vec3& { return nodes[idx(node)].position_w; });
    const Mat3 strain = 0.5 * (squared(F) - Mat3::Identity());
    sum += element.volume * (0.5 * material.lambda * strain.trace() * strain.trace() +
                             material.mu * strain.squaredNorm());
  }
  return sum;
}

Tetrahedron tetrahedron(std::span<const ElasticNode> nodes, const std::array<int, 4>& four) {
  Tetrahedron element;
  element.nodes = four;
  Mat3 edges;
  for (int k = 0; k < 3; ++k)
    edges.col(k) = nodes[idx(four[idx(k + 1)])].rest - nodes[idx(four[0])].rest;
  element.volume = edges.determinant() / 6.0;
  const Mat3 inverse = edges.inverse();
  element.gradients.bottomRows<3>() = inverse;
  element.gradients.row(0) = -inverse.colwise().sum();
  return element;
}

// Each cell is divided along its diagonal: one element for each order in which the axes can be walked.
// Cells divided in the same way fit to each other.
ElasticMesh elastic_box(const Vec3& size, const std::array<int, 3>& cells,
                        const ElasticMaterial& material, const Vec3& center_w) {
  for (int k = 0; k < 3; ++k) {
    require::positive(size[k], "size [m]");
    require::that(cells[idx(k)] >= 1,
                  "cells = " + std::to_string(cells[idx(k)]) + ": give at least 1 along each edge");
  }
  require::positive(material.density, "material.density [kg/m3]");
  require::positive(material.mu, "material.mu [Pa]");
  require::not_negative(material.lambda, "material.lambda [Pa]");
  require::not_negative(material.phi, "material.phi [Pa s]");
  require::not_negative(material.psi, "material.psi [Pa s]");
  require::positive(material.strength, "material.strength [Pa]");
  require::finite(center_w, "center_w");
  ElasticMesh mesh{.material = material};
  const auto at = [&](const std::array<int, 3>& c) {
    return (c[2] * (cells[1] + 1) + c[1]) * (cells[0] + 1) + c[0];
  };
  std::array<int, 3> c{};
  for (c[2] = 0; c[2] <= cells[2]; ++c[2])
    for (c[1] = 0; c[1] <= cells[1]; ++c[1])
      for (c[0] = 0; c[0] <= cells[0]; ++c[0]) {
        ElasticNode node;
        for (int k = 0; k < 3; ++k)
          node.rest[k] = size[k] * (static_cast<double>(c[idx(k)]) / cells[idx(k)] - 0.5);
        node.position_w = center_w + node.rest;
        mesh.nodes.push_back(node);
      }
  mesh.star.resize(mesh.nodes.size());
  for (c[2] = 0; c[2] < cells[2]; ++c[2])
    for (c[1] = 0; c[1] < cells[1]; ++c[1])
      for (c[0] = 0; c[0] < cells[0]; ++c[0])
        for (const std::array<int, 3>& order : kOrders) {
          std::array<int, 3> walk = c;
          std::array<int, 4> four{at(walk), 0, 0, 0};
          for (int k = 0; k < 3; ++k) {
            ++walk[idx(order[idx(k)])];
            four[idx(k + 1)] = at(walk);
          }
          Tetrahedron element = tetrahedron(mesh.nodes, four);
          if (element.volume < 0.0) {
            std::swap(four[2], four[3]);
            element = tetrahedron(mesh.nodes, four);
          }
          for (const int node : four) {
            mesh.nodes[idx(node)].mass += 0.25 * material.density * element.volume;
            mesh.star[idx(node)].push_back(static_cast<int>(mesh.elements.size()));
          }
          mesh.elements.push_back(element);
        }
  return mesh;
}

ElementStress stress_of(const ElasticMesh& mesh, const Tetrahedron& element) {
  const ElasticMaterial& m = mesh.material;
  ElementStress found;
  found.deformation =
      gradient(element, [&](int node) -> const Vec3& { return mesh.nodes[idx(node)].position_w; });
  // [S2.4.1:stress]
  const Mat3& F = found.deformation;
  found.stress = isotropic(m.lambda, m.mu, 0.5 * (squared(F) - Mat3::Identity()));
  if (m.phi > 0.0 || m.psi > 0.0) {
    const Mat3 rate = gradient(
        element, [&](int node) -> const Vec3& { return mesh.nodes[idx(node)].velocity_w; });
    found.stress += isotropic(m.phi, m.psi, symmetric(F.transpose() * rate));
  }
  // [S2.4.1:stress]
  return found;
}

void add_forces(const ElasticMesh& mesh, std::span<Vec3> forces, std::span<double> tension) {
  for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
    const Tetrahedron& element = mesh.elements[k];
    const ElementStress now = stress_of(mesh, element);
    tension[k] = most_tension(now.stress);
    const Mat3 pull = -element.volume * now.deformation * now.stress;
    for (int i = 0; i < 4; ++i)
      forces[idx(element.nodes[idx(i)])] += pull * element.gradients.row(i).transpose();
  }
}

void linear_forces(const ElasticMesh& mesh, std::span<const Vec3> q, std::span<Vec3> forces) {
  std::fill(forces.begin(), forces.end(), Vec3::Zero());
  for (const Tetrahedron& element : mesh.elements) {
    const Mat3 strain =
        symmetric(gradient(element, [&](int node) -> const Vec3& { return q[idx(node)]; }));
    const Mat3 pull = -element.volume * isotropic(mesh.material.lambda, mesh.material.mu, strain);
    for (int i = 0; i < 4; ++i)
      forces[idx(element.nodes[idx(i)])] += pull * element.gradients.row(i).transpose();
  }
}

double element_rate(const Tetrahedron& element, double lambda, double mu, double density) {
  const Mat3 G = element.gradients.transpose() * element.gradients;
  const Eigen::SelfAdjointEigenSolver<Mat3> principal(G, Eigen::EigenvaluesOnly);
  const Vec3 gamma = principal.eigenvalues().cwiseMax(0.0);  // ascending
  const Vec3 s = gamma.cwiseSqrt();
  const Mat3 stretch = lambda * s * s.transpose() + Mat3(2.0 * mu * gamma.asDiagonal());
  const Eigen::SelfAdjointEigenSolver<Mat3> stretched(stretch, Eigen::EigenvaluesOnly);
  return 4.0 / density * std::max(mu * (gamma[1] + gamma[2]), stretched.eigenvalues()[2]);
}

double stable_step(const ElasticMesh& mesh, double extra, int from) {
  const ElasticMaterial& m = mesh.material;
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t n = idx(from); n < mesh.nodes.size(); ++n)
    for (const int k : mesh.star[n]) {
      const Tetrahedron& element = mesh.elements[idx(k)];
      if (idx(*std::max_element(element.nodes.begin(), element.nodes.end())) != n) continue;
      const double spring = extra + element_rate(element, m.lambda, m.mu, m.density);
      const double damper = element_rate(element, m.phi, m.psi, m.density);
      // The root of h² spring + 2 h damper = 4.
      step = std::min(step, 4.0 / (damper + std::sqrt(damper * damper + 4.0 * spring)));
    }
  return step;
}

double courant_step(const ElasticMesh& mesh) {
  double steepest = 0.0;  // [1/m] the inverse of the smallest height
  for (const Tetrahedron& element : mesh.elements)
    steepest = std::max(steepest, element.gradients.rowwise().norm().maxCoeff());
  return 1.0 / (steepest * mesh.material.wave_speed());
}

int pieces_of(const ElasticMesh& mesh, std::vector<int>& piece) {
  piece.assign(mesh.elements.size(), -1);
  std::vector<int> waiting;
  int count = 0;
  for (std::size_t first = 0; first < piece.size(); ++first) {
    if (piece[first] >= 0) continue;
    piece[first] = count;
    waiting.push_back(static_cast<int>(first));
    while (!waiting.empty()) {
      const int element = waiting.back();
      waiting.pop_back();
      for (const int node : mesh.elements[idx(element)].nodes)
        for (const int other : mesh.star[idx(node)])
          if (piece[idx(other)] < 0) {
            piece[idx(other)] = count;
            waiting.push_back(other);
          }
    }
    ++count;
  }
  return count;
}

}  // namespace tumble
