/// \file
/// \brief Edges without height.
#include "tumble/contact_patches/grazed_edges.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

Vec3 middle_of(const ContactPatch& patch, std::span<const MovingBody> bodies) {
  return bodies[idx(patch.first)].position_w + patch.first_arm_w;
}

// Whether one that can move: a floor carries others as well.
bool share_a_body(const ContactPatch& a, const ContactPatch& b,
                  std::span<const MovingBody> bodies) {
  const auto of_both = [&](int body) {
    return (body == b.first || body == b.second) && bodies[idx(body)].inverse_mass.x() > 0.0;
  };
  return of_both(a.first) || of_both(a.second);
}

}  // namespace

void drop_grazed_edges(std::span<const MovingBody> bodies, std::vector<ContactPatch>& patches,
                       std::uint64_t since) {
  const auto grazes = [](const ContactPatch& patch) { return !patch.flat_w[0].isZero(); };
  // Whether a body of the edge's pair lies on something in the plane of the edge.
  const auto supports = [&](const ContactPatch& edge, const ContactPatch& other) {
    if (grazes(other) || !share_a_body(edge, other, bodies)) return false;
    const Vec3 height_w = middle_of(edge, bodies) - middle_of(other, bodies);
    return std::any_of(edge.flat_w.begin(), edge.flat_w.end(), [&](const Vec3& flat_w) {
      return std::abs(other.frame_w.col(2).dot(flat_w)) > tolerance::flush_plane &&
             std::abs(height_w.dot(flat_w)) < tolerance::flush_height * edge.size;
    });
  };
  for (ContactPatch& patch : patches)
    if (patch.stamp > since && grazes(patch) &&
        std::any_of(patches.begin(), patches.end(),
                    [&](const ContactPatch& other) { return supports(patch, other); }))
      patch.count = 0;
  std::erase_if(patches, [](const ContactPatch& patch) { return patch.count == 0; });
}

}  // namespace tumble
