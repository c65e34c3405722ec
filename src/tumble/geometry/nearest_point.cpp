/// \file
/// \brief The point where two boxes that are apart are nearest.
#include "tumble/geometry/nearest_point.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/geometry/edge_crossing.hpp"

#include <algorithm>

namespace tumble {

void add_nearest_point(const Box& first, const Box& second, double margin, double nearer,
                       Manifold& manifold) {
  require::not_negative(margin, "margin");
  double least = margin;
  for (int i = 0; i < manifold.count; ++i)
    least = std::min(least, manifold.points[idx(i)].distance);
  if (!(least > nearer) || manifold.count == Manifold::kMostPoints) return;
  const BoxPair pair(first, second);
  const Separation apart = separation(pair, {false, margin, kNoAxis});
  if (apart.distance > margin) return;
  if (manifold.count == 0) {
    manifold.normal_w = apart.normal_w;
    manifold.axis = apart.axis;
  }
  const Vec3& normal_w = manifold.normal_w;
  const double distance = pair.d_w.dot(normal_w) - reach(first, normal_w) - reach(second, normal_w);
  if (!(distance > -pair.rounding()) || !(distance < least - nearer)) return;
  const EdgeContact edges = nearest_edges(pair, normal_w, pair.rounding());
  manifold.points[idx(manifold.count++)] = {edges.position_w, distance, edges.feature};
}

}  // namespace tumble
