/// \file
/// \brief A flat pyramid of bricks as a problem of contact forces (thesis 2.6).
#include "lcp_solvers/brick_pyramid.hpp"

#include "tumble/contact/gather.hpp"

namespace tumble::chapters {
namespace {

const Vec3 kBrick(1.0, 0.8, 0.5);  // [m]
constexpr double kMargin = 1e-9;   // [m] faces that touch are as close, up to rounding

void add_foot(const BrickPyramid& pyramid, Contact& contact, double offset) {
  const Vec3& brick_w = pyramid.bodies[static_cast<std::size_t>(contact.second)].position_w;
  contact.points[static_cast<std::size_t>(contact.count++)].position_w =
      brick_w + Vec3(offset, -0.5 * kBrick.y(), 0.0);
}

// On the ground a brick's two feet are two points of one contact; higher up each is on a brick of its
// own.
void put_on_feet(int rows, double spacing, BrickPyramid& pyramid) {
  const auto contact_of = [](int lower, int upper) {
    Contact contact;
    contact.first = lower;
    contact.second = upper;
    return contact;
  };
  int brick = 1;
  for (int row = 0; row < rows; ++row) {
    for (int k = 0; k < rows - row; ++k, ++brick) {
      const int left = row == 0 ? 0 : brick - (rows - row) - 1;
      Contact one = contact_of(left, brick);
      add_foot(pyramid, one, -0.25 * spacing);
      if (row == 0) {
        add_foot(pyramid, one, 0.25 * spacing);
      } else {
        Contact other = contact_of(left + 1, brick);
        add_foot(pyramid, other, 0.25 * spacing);
        pyramid.contacts.push_back(other);
      }
      pyramid.contacts.push_back(one);
    }
  }
  std::sort(pyramid.contacts.begin(), pyramid.contacts.end(),
            [](const Contact& a, const Contact& b) {
              return a.first != b.first ? a.first < b.first : a.second < b.second;
            });
}

void put_on_faces(BrickPyramid& pyramid) {
  std::vector<IndexPair> pairs;
  for (int i = 0; i < pyramid.world.count(); ++i)
    for (int j = i + 1; j < pyramid.world.count(); ++j) pairs.push_back({i, j});
  gather_contacts(pyramid.world, pyramid.bodies, pairs, kMargin, {}, pyramid.contacts);
}

}  // namespace

BrickPyramid make_brick_pyramid(int rows, double spacing, Stand stand) {
  BrickPyramid pyramid;
  World& world = pyramid.world;
  world.add_ground();
  const BodyProperties brick = box_properties(kBrick, 1.0);
  for (int row = 0; row < rows; ++row)
    for (int k = 0; k < rows - row; ++k) {
      const double x = spacing * (k - 0.5 * (rows - row - 1));
      world.add(brick, make_state(brick, Vec3(x, (row + 0.5) * kBrick.y(), 0.0)));
    }
  load_moving_bodies(world, pyramid.bodies);
  if (stand == Stand::feet)
    put_on_feet(rows, spacing, pyramid);
  else
    put_on_faces(pyramid);

  std::vector<Acceleration> falling;
  free_accelerations(world, pyramid.bodies, falling);
  pyramid.problem.assemble(world, pyramid.bodies, falling, pyramid.contacts,
                           std::numeric_limits<double>::infinity());
  return pyramid;
}

double weight_of_brick(const BrickPyramid& pyramid) {
  return pyramid.world.bodies().back().mass * pyramid.world.gravity_w.norm();
}

std::vector<Resultant> resultants(const BrickPyramid& pyramid, std::span<const double> f) {
  std::vector<Resultant> result(pyramid.contacts.size());
  const auto rows = pyramid.problem.rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto contact = static_cast<std::size_t>(rows[i].contact);
    const ContactPoint& point =
        pyramid.contacts[contact].points[static_cast<std::size_t>(rows[i].point)];
    result[contact].force += f[i];
    result[contact].place += f[i] * point.position_w.x();  // a moment, so far
  }
  for (Resultant& r : result) r.place = r.force > 0.0 ? r.place / r.force : 0.0;
  return result;
}

}  // namespace tumble::chapters
