/// \file
/// \brief The point where two edges of two boxes touch, and the names of edges.
#pragma once

#include "tumble/base/types.hpp"
#include "tumble/geometry/manifold.hpp"
#include "tumble/geometry/separation_pair.hpp"

namespace tumble {

/// Edges of the second box count on from those of the first.
inline constexpr FeatureId kEdgesOfSecond = 12;

/// Names the second point of two edges that lie side by side.
inline constexpr FeatureId kOtherEnd = 1U << 16U;

/// The number of a box edge, 0 to 11.
/// \param axis               the axis that it is parallel to
/// \param next_is_positive   on which side of the next axis it lies
/// \param after_is_positive  on which side of the axis after that
FeatureId edge_number(std::size_t axis, bool next_is_positive, bool after_is_positive);

/// The name of the point where two edges meet, whichever comes first.
FeatureId name_of(FeatureId edge, FeatureId other);

/// Two edges where they touch.
struct EdgeContact {
  Vec3 position_w;    ///< [m] world frame, halfway between their closest points
  FeatureId feature;  ///< the name of the point
  double apart2;      ///< [m²] squared distance of the closest points
  bool within;        ///< whether neither passes beyond an end
  Vec3
      stretch_w;  ///< [m] from the position to one end of the stretch that parallel edges share; else 0
};

/// Where the edges of two boxes that reach farthest along a direction touch.
/// \param i         the axis of the first box that its edge is parallel to
/// \param j         the axis of the second box
EdgeContact cross_edges(const BoxPair& pair, const Vec3& normal_w, int i, int j);

/// Where two boxes are closest, of all edges that reach farthest along a direction; of edges equally close those
/// that lie beside each other for the longest stretch.
/// \param difference  [m] edges that reach less far by at most this count, too
EdgeContact nearest_edges(const BoxPair& pair, const Vec3& normal_w, double difference);

}  // namespace tumble
