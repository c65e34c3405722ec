/// \file
/// \brief Faces on the outside, and nodes near them.
#include "tumble/fracture/outside.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace tumble {
namespace {

// Across from each corner, counter-clockwise seen from outside.
constexpr std::array<std::array<int, 3>, 4> kFaces{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

using Cell = std::array<int, 3>;

Cell cell_of(const Vec3& point_w, double size) {
  return {static_cast<int>(std::floor(point_w.x() / size)),
          static_cast<int>(std::floor(point_w.y() / size)),
          static_cast<int>(std::floor(point_w.z() / size))};
}

}  // namespace

std::vector<OutsideFace> outside_of(const ElasticMesh& mesh) {
  struct Seen {
    std::array<int, 3> key;
    OutsideFace face;
  };
  std::vector<Seen> seen;
  seen.reserve(4 * mesh.elements.size());
  for (std::size_t k = 0; k < mesh.elements.size(); ++k)
    for (int corner = 0; corner < 4; ++corner) {
      Seen one;
      one.face.element = static_cast<int>(k);
      one.face.corner = corner;
      for (int i = 0; i < 3; ++i)
        one.face.nodes[idx(i)] = mesh.elements[k].nodes[idx(kFaces[idx(corner)][idx(i)])];
      one.key = one.face.nodes;
      std::sort(one.key.begin(), one.key.end());
      seen.push_back(one);
    }
  const auto order = [](const OutsideFace& a, const OutsideFace& b) {
    return std::tie(a.element, a.corner) < std::tie(b.element, b.corner);
  };
  std::sort(seen.begin(), seen.end(), [&](const Seen& a, const Seen& b) {
    return a.key != b.key ? a.key < b.key : order(a.face, b.face);
  });
  std::vector<OutsideFace> outside;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const bool alone = (k == 0 || seen[k - 1].key != seen[k].key) &&
                       (k + 1 == seen.size() || seen[k + 1].key != seen[k].key);
    if (alone) outside.push_back(seen[k].face);
  }
  std::sort(outside.begin(), outside.end(), order);
  return outside;
}

std::vector<NearPair> near_pieces(const ElasticMesh& mesh, std::span<const int> piece,
                                  std::span<const OutsideFace> outside, double reach) {
  std::vector<Bounds> bounds;
  double largest = 0.0;
  for (const OutsideFace& face : outside) {
    Bounds around{Vec3::Constant(std::numeric_limits<double>::infinity()),
                  Vec3::Constant(-std::numeric_limits<double>::infinity())};
    for (const int node : mesh.elements[idx(face.element)].nodes) {
      around.low = around.low.cwiseMin(mesh.nodes[idx(node)].position_w);
      around.high = around.high.cwiseMax(mesh.nodes[idx(node)].position_w);
    }
    const double extent = (around.high - around.low).maxCoeff();
    around.low.array() -= reach * extent;
    around.high.array() += reach * extent;
    largest = std::max(largest, (1.0 + 2.0 * reach) * extent);
    bounds.push_back(around);
  }
  // Each node on the outside in its cell; then for each face the cells that it reaches.
  std::vector<int> nodes;
  for (const OutsideFace& face : outside)
    nodes.insert(nodes.end(), face.nodes.begin(), face.nodes.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  std::vector<std::pair<Cell, int>> places;
  for (const int node : nodes)
    places.emplace_back(cell_of(mesh.nodes[idx(node)].position_w, largest), node);
  std::sort(places.begin(), places.end());
  std::vector<NearPair> near;
  for (std::size_t k = 0; k < outside.size(); ++k) {
    const Cell low = cell_of(bounds[k].low, largest), high = cell_of(bounds[k].high, largest);
    const std::size_t begin = near.size();
    for (int x = low[0]; x <= high[0]; ++x)
      for (int y = low[1]; y <= high[1]; ++y) {
        auto at = std::lower_bound(places.begin(), places.end(),
                                   std::pair<Cell, int>{Cell{x, y, low[2]}, -1});
        for (; at != places.end() && at->first <= Cell{x, y, high[2]}; ++at) {
          const Vec3& point_w = mesh.nodes[idx(at->second)].position_w;
          if (piece[idx(mesh.star[idx(at->second)].front())] == piece[idx(outside[k].element)] ||
              !overlap(bounds[k], Bounds{point_w, point_w}))
            continue;
          near.push_back({at->second, outside[k].element, outside[k].corner});
        }
      }
    std::sort(near.begin() + static_cast<std::ptrdiff_t>(begin), near.end(),
              [](const NearPair& a, const NearPair& b) { return a.node < b.node; });
  }
  return near;
}

NearFace::NearFace(const ElasticMesh& mesh, const Tetrahedron& element, int corner)
    : corner_(corner), origin_w_(mesh.nodes[idx(element.nodes[0])].position_w) {
  Mat3 edges;
  for (int k = 0; k < 3; ++k)
    edges.col(k) = mesh.nodes[idx(element.nodes[idx(k + 1)])].position_w - origin_w_;
  const Mat3 inverse = edges.inverse();
  gradients_.bottomRows<3>() = inverse;
  gradients_.row(0) = -inverse.colwise().sum();
  turned_ = !(edges.determinant() > 0.0);
  const Vec3 inwards = gradients_.row(corner).transpose();
  steep_ = inwards.norm();
  normal_w_ = -inwards / steep_;
}

// Barycentric coordinates in the element as it is now.
Sunk NearFace::sunk(const Vec3& point_w) const {
  Eigen::Vector4d at = gradients_ * (point_w - origin_w_);
  at[0] += 1.0;
  Sunk sunk{.inside = at.minCoeff() > 0.0 && !turned_, .depth = at[corner_] / steep_};
  for (int i = 0; i < 4; ++i) sunk.shares[idx(i)] = at[i];
  return sunk;
}

}  // namespace tumble
