/// \file
/// \brief Two planks on three posts: a small problem on which Baraff's algorithm shows all it does.
#pragma once

#include "tumble/analytic_lcp/assembly.hpp"

#include <limits>
#include <vector>

namespace tumble::chapters {

// A plank on two posts, and a longer one that lies on its right half and on a third post, seen from
// the side. All contacts are points in the plane.
//
// | contact | between | x [m] |
// |---|---|---|
// | 1, 2 | posts and lower plank | -0.75, 0.25 |
// | 3, 4 | lower and upper plank: the ends of the area that touches | centre - 1.25, 1 |
// | 5 | third post and upper plank | post |
struct Planks {
  World world;                     // three fixed posts, then the lower and the upper plank
  std::vector<MovingBody> bodies;  // how they are moved
  ContactList contacts;            // five, with a point each
  ContactProblem problem;          // of their forces
};

inline constexpr double kPlankThick = 0.1;  // [m] of planks, and width of posts
inline constexpr double kPostHeight = 0.5;  // [m] height of the posts under the lower plank

inline void add_post(World& world, double x, double height) {
  const BodyProperties post = fixed_box_properties(Vec3(kPlankThick, height, kPlankThick));
  world.add(post, Vec3(x, 0.5 * height, 0.0));
}

inline void add_plank(World& world, double x, double bottom, double length, double mass) {
  world.add(box_properties(Vec3(length, kPlankThick, kPlankThick), mass),
            Vec3(x, bottom + 0.5 * kPlankThick, 0.0));
}

inline Contact contact_at(int first, int second, double x, double y) {
  Contact contact{.first = first, .second = second, .count = 1};
  contact.points[0].position_w = Vec3(x, y, 0.0);
  return contact;
}

// Planks of 1 kg and 2 m, and of 1.25 kg and 2.5 m, 0.1 m thick; centre [m] of the upper plank and place
// [m] of the third post.
inline Planks make_planks(double centre, double post) {
  const double high = kPostHeight + kPlankThick;  // top of the lower plank
  Planks planks;
  World& world = planks.world;
  add_post(world, -0.75, kPostHeight);
  add_post(world, 0.25, kPostHeight);
  add_post(world, post, high);
  add_plank(world, 0.0, kPostHeight, 2.0, 1.0);
  add_plank(world, centre, high, 2.5, 1.25);
  planks.contacts = {contact_at(0, 3, -0.75, kPostHeight), contact_at(1, 3, 0.25, kPostHeight),
                     contact_at(3, 4, centre - 1.25, high), contact_at(3, 4, 1.0, high),
                     contact_at(2, 4, post, high)};
  load_moving_bodies(world, planks.bodies);
  std::vector<Acceleration> falling;
  free_accelerations(world, planks.bodies, falling);
  planks.problem.assemble(world, planks.bodies, falling, planks.contacts,
                          std::numeric_limits<double>::infinity());
  return planks;
}

}  // namespace tumble::chapters
