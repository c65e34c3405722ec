/// \file
/// \brief Two planks on three posts: a small problem on which Baraff's algorithm shows all it does.
#include "lcp_solvers/planks.hpp"

#include <limits>

namespace tumble::chapters {
namespace {

constexpr double kThick = 0.1;  // [m] of planks, and width of posts
constexpr double kLow = 0.5;    // [m] height of the posts under the lower plank

void add_post(World& world, double x, double height) {
  const BodyProperties post = fixed_box_properties(Vec3(kThick, height, kThick));
  world.add(post, make_state(post, Vec3(x, 0.5 * height, 0.0)));
}

void add_plank(World& world, double x, double bottom, double length, double mass) {
  const BodyProperties plank = box_properties(Vec3(length, kThick, kThick), mass);
  world.add(plank, make_state(plank, Vec3(x, bottom + 0.5 * kThick, 0.0)));
}

Contact contact_at(int first, int second, double x, double y) {
  Contact contact;
  contact.first = first;
  contact.second = second;
  contact.count = 1;
  contact.points[0].position_w = Vec3(x, y, 0.0);
  return contact;
}

}  // namespace

Planks make_planks(double centre, double post) {
  const double high = kLow + kThick;  // top of the lower plank
  Planks planks;
  World& world = planks.world;
  add_post(world, -0.75, kLow);
  add_post(world, 0.25, kLow);
  add_post(world, post, high);
  add_plank(world, 0.0, kLow, 2.0, 1.0);
  add_plank(world, centre, high, 2.5, 1.25);
  planks.contacts = {contact_at(0, 3, -0.75, kLow), contact_at(1, 3, 0.25, kLow),
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
