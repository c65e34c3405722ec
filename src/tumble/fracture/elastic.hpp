/// \file
/// \brief A body of tetrahedra: strain, stress, forces, and the steps that it stands (thesis 2.4.1).
#pragma once

#include "tumble/base/index.hpp"
#include "tumble/base/types.hpp"

#include <array>
#include <span>
#include <vector>

namespace tumble {

/// An elastic, viscous and brittle material, the same in all directions.
struct ElasticMaterial {
  double lambda = 0.0;    ///< [Pa] Lamé's first constant λ
  double mu = 0.0;        ///< [Pa] Lamé's second constant μ, the shear modulus
  double phi = 0.0;       ///< [Pa s] viscosity against a change of volume, beside λ
  double psi = 0.0;       ///< [Pa s] viscosity against shear, beside μ
  double density = 0.0;   ///< [kg/m³]
  double strength = 0.0;  ///< [Pa] tension at which it breaks, see separation_at()

  /// Speed of its fastest wave, \f$c = \sqrt{(\lambda + 2\mu)/\rho}\f$ [m/s].
  [[nodiscard]] double wave_speed() const;
};

/// A material from constants that handbooks have: \f$\lambda = E\nu/((1+\nu)(1-2\nu))\f$, \f$\mu = E/(2(1+\nu))\f$.
/// \param young     [Pa] Young's modulus E, above 0
/// \param poisson   [-] Poisson's ratio ν, at least 0 and below 0.5
/// \param density   [kg/m³] above 0
/// \param strength  [Pa] above 0
/// \param damping   [s] viscous stress over elastic stress at a strain of 1/s, at least 0
/// \throws std::invalid_argument naming the value that is out of range
/// \verified{A material, a mesh or a step that cannot be is refused with its value}
ElasticMaterial elastic_material(double young, double poisson, double density, double strength,
                                 double damping = 0.0);

/// An element: four nodes, between which everything is linear.
struct Tetrahedron {
  std::array<int, 4> nodes{};             ///< indices; in this order the volume is positive
  Eigen::Matrix<double, 4, 3> gradients;  ///< [1/m] of each node's barycentric coordinate, at rest
  double volume = 0.0;                    ///< [m³] at rest
};

/// A node: a point of the body with a share of its mass.
struct ElasticNode {
  Vec3 rest = Vec3::Zero();        ///< [m] where it is in the body at rest
  Vec3 position_w = Vec3::Zero();  ///< [m] where it is now
  Vec3 velocity_w = Vec3::Zero();  ///< [m/s]
  double mass = 0.0;               ///< [kg] a quarter of each of its elements (lumped)
  Vec3 moves = Vec3::Ones();       ///< [-] 1, or 0 for an axis along which it is held
  Vec3 load_w = Vec3::Zero();      ///< [N] a force from outside
};

/// Elements and nodes. A value: a copy is a snapshot.
struct ElasticMesh {
  ElasticMaterial material;            ///< of all elements
  std::vector<ElasticNode> nodes;      ///< ascending as they were made
  std::vector<Tetrahedron> elements;   ///< ditto
  std::vector<std::vector<int>> star;  ///< by node: its elements, ascending

  /// Mass [kg], the sum over the nodes.
  [[nodiscard]] double mass() const;
  /// \return [kg m/s] sum over the nodes
  [[nodiscard]] Vec3 momentum_w() const;
  /// \return [J] kinetic energy
  [[nodiscard]] double kinetic_energy() const;
  /// \return [J] elastic energy, \f$\sum V(\tfrac12\lambda(\mathrm{tr}\,\varepsilon)^2 + \mu\,\varepsilon:\varepsilon)\f$
  [[nodiscard]] double elastic_energy() const;
};

/// A box of tetrahedra at rest: equal cells, each divided into six elements of equal volume.
/// \param size      [m] full edges, each above 0
/// \param cells     along each edge, each at least 1
/// \param material  with density, λ + μ and μ above 0
/// \throws std::invalid_argument naming the value that is out of range
/// \verified{A box of tetrahedra has the mass and the volume of the box, and no face without partner inside}
ElasticMesh elastic_box(const Vec3& size, const std::array<int, 3>& cells,
                        const ElasticMaterial& material, const Vec3& center_w = Vec3::Zero());

/// The element of four nodes, with its gradients and volume.
/// \return the element; its volume is negative if the order of the nodes is
Tetrahedron tetrahedron(std::span<const ElasticNode> nodes, const std::array<int, 4>& four);

/// Deformation of an element and the stress that it makes.
struct ElementStress {
  Mat3 deformation;  ///< [-] F, from the body at rest to the world
  Mat3 stress;       ///< [Pa] second Piola-Kirchhoff stress, in the frame of the body at rest
};

/// Stress of an element.
///
/// With the deformation F, Green's strain \f$\varepsilon = \tfrac12(F^{\mathsf T}F - 1)\f$ and its rate \f$\dot\varepsilon\f$,
/// \f[ S = \lambda\,\mathrm{tr}\,\varepsilon\,1 + 2\mu\,\varepsilon + \phi\,\mathrm{tr}\,\dot\varepsilon\,1 + 2\psi\,\dot\varepsilon . \f]
/// A rotation has no strain, however large it is.
/// \see O'Brien, Hodgins, "Graphical modeling and animation of brittle fracture", SIGGRAPH 1999. Their strain is twice this one.
/// \verified{A deformation that is the same everywhere is so in each element, and nodes inside feel no force}
/// \verified{A mesh that is turned and moved has no stress}
ElementStress stress_of(const ElasticMesh& mesh, const Tetrahedron& element);

/// Adds the forces of all elements: \f$f_i = -V F S\,g_i\f$ with the gradient \f$g_i\f$ of node i.
/// \param forces   [N] by node
/// \param tension  [Pa] by element: an upper bound of its largest principal stress
void add_forces(const ElasticMesh& mesh, std::span<Vec3> forces, std::span<double> tension);

/// The forces of small displacements from rest, of which the linear part is kept: \f$-K q\f$.
/// \param q       [m] displacement by node, in the frame of the body at rest
/// \param forces  [N] by node, is overwritten
void linear_forces(const ElasticMesh& mesh, std::span<const Vec3> q, std::span<Vec3> forces);

/// The highest angular frequency of an element alone, with a quarter of its mass at each node.
///
/// With \f$G = \sum_i g_i g_i^{\mathsf T}\f$ and its eigenvalues \f$\gamma_1 \ge \gamma_2 \ge \gamma_3\f$, shear and stretching part:
/// \f[ \omega^2 = \frac4\rho \max\bigl(\mu(\gamma_1 + \gamma_2),\;
///     \lambda_{\max}(\lambda\,s s^{\mathsf T} + 2\mu\,\mathrm{diag}\,\gamma)\bigr), \qquad s_i = \sqrt{\gamma_i} . \f]
/// No mesh of such elements swings faster than its fastest element (Irons).
/// \param lambda   [Pa] λ; or [Pa s] φ
/// \param mu       [Pa] μ; or [Pa s] ψ
/// \param density  [kg/m³]
/// \return [1/s²] \f$\omega^2\f$; or [1/s] the rate of the viscous part
/// \verified{The frequency of an element is the largest eigenvalue of its stiffness over its mass}
double element_rate(const Tetrahedron& element, double lambda, double mu, double density);

/// The longest step for which no element alone gains energy: \f$h^2\omega^2 + 2 h \omega_c < 4\f$ with the rate of its viscosity
/// \f$\omega_c\f$. Velocities first, and nodes move with the new ones.
/// \param mesh   the mesh, at least one element
/// \param extra  [1/s²] \f$\omega^2\f$ of springs besides, over the masses that they are at
/// \param from   index of a node: only elements with a node from it on count, as those that a crack has changed have
/// \return [s] infinite without such elements
/// \verified{No mesh swings faster than its fastest element, and its stable step is near the Courant step}
double stable_step(const ElasticMesh& mesh, double extra = 0.0, int from = 0);

/// The time that the fastest wave takes through the smallest height of an element [s].
double courant_step(const ElasticMesh& mesh);

/// Number of pieces: sets of elements that share nodes.
/// \param piece  by element: its piece, from 0 in the order of their first elements; is overwritten
int pieces_of(const ElasticMesh& mesh, std::vector<int>& piece);

}  // namespace tumble
