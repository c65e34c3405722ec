/// \file
/// \brief Cracks of a body of tetrahedra, and the split of its mesh (thesis 2.4.1).
#pragma once

#include "tumble/fracture/elastic.hpp"
#include "tumble/fracture/tolerances.hpp"

#include <vector>

namespace tumble {

/// How much the elements around a node pull it apart.
struct NodeSeparation {
  Mat3 tensor = Mat3::Zero();     ///< [N] the separation tensor ς, world frame
  Vec3 normal_w = Vec3::UnitX();  ///< [-] direction in which it is pulled apart most
  double force = 0.0;             ///< [N] the largest eigenvalue of ς
  double area = 0.0;              ///< [m²] the area across the normal that belongs to the node
  /// \return [Pa] force over area; 0 without an area
  [[nodiscard]] double stress() const { return area > 0.0 ? force / area : 0.0; }
};

/// The stress of an element, and what of it pulls.
struct TensileStress {
  ElementStress all;            ///< with its deformation
  Mat3 tensile = Mat3::Zero();  ///< [Pa] the part with principal stresses above 0
};

/// The stresses of the elements of a mesh, each found when it is asked for first: all of an element's nodes need it.
class TensileStresses {
 public:
  /// Knows none yet.
  /// \param mesh  stays as it is, and lives as long
  explicit TensileStresses(const ElasticMesh& mesh)
      : mesh_(mesh), places_(mesh.elements.size(), -1) {}
  /// \return its stress, until another element is asked for
  const TensileStress& of(int element);
  /// \return the mesh
  [[nodiscard]] const ElasticMesh& mesh() const { return mesh_; }

 private:
  const ElasticMesh& mesh_;
  std::vector<int> places_;  // by element, in stresses_; -1: not known yet
  std::vector<TensileStress> stresses_;
};

/// The separation tensor of a node.
///
/// The stress of each element is divided into its tensile and its compressive part, by the signs of its principal stresses. Each makes a force
/// on the node, \f$f^+\f$ and \f$f^-\f$. With \f$m(a) = a a^{\mathsf T}/|a|\f$,
/// \f[ \varsigma = \tfrac12\Bigl(-m\bigl({\textstyle\sum} f^+\bigr) + \sum m(f^+) + m\bigl({\textstyle\sum} f^-\bigr) - \sum m(f^-)\Bigr) . \f]
/// Forces that balance each other at the node pull it apart, those that move it do not.
///
/// An eigenvalue is a force, so it is smaller the smaller the elements are. The paper compares it with a constant, the toughness. Here it
/// is divided by the area that belongs to the node, \f$\tfrac12 V \sum |n \cdot g|\f$, a third of the shadow of its elements along n. Under uniform tension
/// that is the tension exactly, on every mesh.
/// \see O'Brien, Hodgins, SIGGRAPH 1999.
/// \verified{The separation tensor of a bar under tension has the tension as its eigenvalue, along the bar}
NodeSeparation separation_at(TensileStresses& stresses, int node);

/// Smallest height of an element that a crack may leave, `tolerance::crack_least` of the smallest one now [m].
[[nodiscard]] double least_height(const ElasticMesh& mesh);

/// Counts of a mesh that was split.
struct CrackWork {
  int cracks = 0;  ///< nodes that became two
  int splits = 0;  ///< edges at which a node was put in
  int loose = 0;   ///< nodes that hung between elements without a common face, and became several
};

/// Splits a mesh by a plane through a node, as far as the elements at this node reach.
///
/// - Edges across from the node that cross the plane get a node there, and all elements at such an edge become two: the mesh
///   stays conforming. Their new nodes get position and velocity between the ends of the edge, which keeps mass, momentum and
///   elastic energy.
/// - Where the plane passes an end within `tolerance::crack_angle` as seen from the node, or an element would be flatter than
///   `least`, it goes through that end. So no element, and no step, becomes as small as one likes.
/// - The node becomes two, one for each side.
/// - Nodes of these elements whose elements no longer hang together by faces become one for each part.
/// \param normal_w  [-] of the plane, length 1
/// \param least     [m] smallest height of an element that a split may leave, at rest
/// \param work      counts are added
/// \return false if all elements are on one side: nothing is parted, though edges may have been divided
/// \verified{A split keeps mass, momentum, volume and elastic energy, and the mesh conforming}
bool crack(ElasticMesh& mesh, int node, const Vec3& normal_w, double least, CrackWork& work);

/// Cracks all nodes that are pulled apart by more than the strength, the most loaded first. Nodes beside one that has cracked wait for
/// the next search, since its crack relieves them.
/// \param tension  [Pa] by element, of add_forces(). Only nodes with an element above `tolerance::crack_tension` of the
///                 strength are looked at
/// \return whether the mesh has changed: nodes have been added, also where edges were divided and nothing was parted
/// \verified{A search for cracks that divides edges and parts nothing says that the mesh has changed}
bool crack_all(ElasticMesh& mesh, std::span<const double> tension, double least, CrackWork& work);

}  // namespace tumble
