/// \file
/// \brief The outside of a body of tetrahedra, and nodes of one piece near another (thesis 2.4.1).
#pragma once

#include "tumble/fracture/elastic.hpp"
#include "tumble/geometry/box.hpp"

#include <span>
#include <vector>

namespace tumble {

/// A face that one element has alone.
struct OutsideFace {
  int element = 0;             ///< whose
  int corner = 0;              ///< which of its nodes, 0 to 3, is across from the face
  std::array<int, 3> nodes{};  ///< of the mesh, counter-clockwise seen from outside
};

/// The outside of a mesh, cracks included, by element and corner, ascending.
std::vector<OutsideFace> outside_of(const ElasticMesh& mesh);

/// A node near a face of another piece.
struct NearPair {
  int node = 0;     ///< of the mesh
  int element = 0;  ///< of another piece
  int corner = 0;   ///< across from its face on the outside
};

/// Nodes on the outside near elements of other pieces that have a face on the outside.
/// \param piece    by element, see pieces_of()
/// \param outside  of outside_of()
/// \param reach    [-] how near, over the extent of an element
/// \return by element, corner and node, ascending
/// \par Cost
/// A grid of cells as large as the largest element.
std::vector<NearPair> near_pieces(const ElasticMesh& mesh, std::span<const int> piece,
                                  std::span<const OutsideFace> outside, double reach);

/// How deep a point is in an element.
struct Sunk {
  bool inside = false;                       ///< whether it is in the element
  double depth = 0.0;                        ///< [m] below the plane of the face; negative above it
  std::array<double, 4> shares{0, 0, 0, 0};  ///< [-] of its nodes at the point (barycentric)
};

/// A face on the outside, with its element, where they are now: several nodes are near it.
/// \verified{Pieces that meet push each other and keep both momenta}
class NearFace {
 public:
  /// Measures the element.
  /// \param corner   which of its nodes, 0 to 3, is across from the face
  NearFace(const ElasticMesh& mesh, const Tetrahedron& element, int corner);
  /// Measures a point.
  [[nodiscard]] Sunk sunk(const Vec3& point_w) const;
  /// \return [-] of the face, outwards
  [[nodiscard]] const Vec3& normal_w() const { return normal_w_; }

 private:
  int corner_;
  Vec3 origin_w_;                          // [m] the first node
  Eigen::Matrix<double, 4, 3> gradients_;  // [1/m] of the barycentric coordinates
  bool turned_;                            // inside out
  double steep_;                           // [1/m] of the coordinate across from the face
  Vec3 normal_w_;                          // [-]
};

}  // namespace tumble
