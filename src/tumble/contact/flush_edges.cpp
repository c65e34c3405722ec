/// \file
/// \brief Edges without height, which a body that slides over flush neighbours must not hit.
#include "tumble/contact/flush_edges.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

double size_of_pair(const World& world, const IndexPair& pair) {
  return shortest_edge(world.bodies()[idx(pair.first)], world.bodies()[idx(pair.second)]);
}

Box box_at(const World& world, int body) {
  return box_of(world.bodies()[idx(body)], world.states()[idx(body)]);
}

bool has_ground(const World& world, const IndexPair& pair) {
  return world.bodies()[idx(pair.first)].shape == Shape::ground ||
         world.bodies()[idx(pair.second)].shape == Shape::ground;
}

// A contact of faces has an area, one at an edge without height has none.
bool on_a_line(const Contact& contact, double height) {
  const Vec3& from_w = contact.points[0].position_w;
  Vec3 along_w = Vec3::Zero();
  const auto end = contact.points.begin() + contact.count;
  for (auto p = contact.points.begin(); p != end; ++p)
    if ((p->position_w - from_w).squaredNorm() > along_w.squaredNorm())
      along_w = p->position_w - from_w;
  if (along_w.isZero(0.0)) return true;
  along_w.normalize();
  return std::all_of(contact.points.begin(), end, [&](const ContactPoint& p) {
    return (p.position_w - from_w).cross(along_w).norm() <= height;
  });
}

// A plane in which an edge lies.
struct EdgePlane {
  Vec3 normal_w;  // [-]
  double at;      // [m] along the normal
  double height;  // [m] of the edge, at most
};

// Whether a contact holds one of two bodies in a plane.
bool holds(const Contact& contact, const IndexPair& pair, const EdgePlane& plane) {
  const auto is_of_pair = [&](int body) { return body == pair.first || body == pair.second; };
  if (is_of_pair(contact.first) == is_of_pair(contact.second)) return false;
  if (std::abs(contact.normal_w.dot(plane.normal_w)) < tolerance::flush_plane) return false;
  return std::any_of(contact.points.begin(), contact.points.begin() + contact.count,
                     [&](const ContactPoint& p) {
                       return std::abs(p.distance) < plane.height &&
                              std::abs(p.position_w.dot(plane.normal_w) - plane.at) < plane.height;
                     });
}

bool meets_flush_edge_along(const World& world, const IndexPair& pair, const Vec3& normal_w,
                            double gap, std::span<const Contact> contacts) {
  const double size = size_of_pair(world, pair);
  const double height = tolerance::flush_height * size;
  const Box first = box_at(world, pair.first);
  const Separation closed = closed_along(first, box_at(world, pair.second), normal_w, gap, size);
  if (std::abs(closed.distance) >= height) return false;
  const Vec3& flat_w = closed.normal_w;
  const EdgePlane plane{flat_w, flat_w.dot(first.center_w) + reach(first, flat_w), height};
  return std::any_of(contacts.begin(), contacts.end(),
                     [&](const Contact& contact) { return holds(contact, pair, plane); });
}

}  // namespace

Separation closed_along(const Box& first, Box second, const Vec3& normal_w, double gap,
                        double size) {
  second.center_w += -tolerance::flush_overlap * size * normal_w - gap * normal_w;
  return separation(first, second);
}

bool meets_flush_edge(const World& world, const IndexPair& pair,
                      std::span<const Contact> contacts) {
  if (has_ground(world, pair)) return false;
  const Separation gap = separation(box_at(world, pair.first), box_at(world, pair.second));
  return meets_flush_edge_along(world, pair, gap.normal_w, gap.distance, contacts);
}

void drop_flush_edges(const World& world, ContactList& contacts) {
  std::vector<std::size_t> flush;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Contact& contact = contacts[k];
    const IndexPair pair{contact.first, contact.second};
    if (has_ground(world, pair)) continue;
    const double size = size_of_pair(world, pair);
    if (!on_a_line(contact, tolerance::flush_height * size)) continue;
    double gap = contact.points[0].distance;
    for (int p = 1; p < contact.count; ++p) gap = std::min(gap, contact.points[idx(p)].distance);
    if (meets_flush_edge_along(world, pair, contact.normal_w, gap, contacts)) flush.push_back(k);
  }
  for (const std::size_t k : flush) contacts[k].count = 0;
  std::erase_if(contacts, [](const Contact& contact) { return contact.count == 0; });
}

}  // namespace tumble
