/// \file
/// \brief The outside of a body of tetrahedra, and nodes of one piece near another (thesis 2.4.1).
///
/// Uses no other chapter.
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

/// The outside of a mesh, cracks included.
/// \param mesh  the mesh
/// \return by element and corner, ascending
std::vector<OutsideFace> outside_of(const ElasticMesh& mesh);

/// A node near a face of another piece.
struct NearPair {
  int node = 0;     ///< of the mesh
  int element = 0;  ///< of another piece
  int corner = 0;   ///< across from its face on the outside
};

/// Nodes on the outside near elements of other pieces that have a face on the outside.
/// \param mesh     the mesh
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
  Vec3 normal_w = Vec3::UnitY();             ///< [-] of the face, outwards
  std::array<double, 4> shares{0, 0, 0, 0};  ///< [-] of its nodes at the point (barycentric)
};

/// Whether a point is on the outer side of a face, by a share of the height of the element: sunk_in() then has a depth below 0. This one
/// takes a fifth of its time.
/// \param mesh     the mesh
/// \param element  one of its elements
/// \param corner   which of its nodes, 0 to 3, is across from the face
/// \param point_w  [m] the point
/// \param by       [-] of the height, at least 0
/// \return false also for an element without a volume
/// \verified{A point that is clear of a face has a depth below 0 there}
[[nodiscard]] bool is_clear_of(const ElasticMesh& mesh, const Tetrahedron& element, int corner,
                               const Vec3& point_w, double by);

/// Measures it.
/// \param mesh     the mesh
/// \param element  one of its elements
/// \param corner   which of its nodes, 0 to 3, is across from the face
/// \param point_w  [m] the point
/// \return see there
/// \verified{Pieces that meet push each other and keep both momenta}
Sunk sunk_in(const ElasticMesh& mesh, const Tetrahedron& element, int corner, const Vec3& point_w);

}  // namespace tumble
