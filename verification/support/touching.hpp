/// \file
/// \brief Bodies that touch, and their contacts, for tests of what comes after geometry.
#pragma once

#include "driver/touching.hpp"

namespace tumble::test {

using chapters::all_pairs;
using chapters::contacts_within;

// A contact of one point, put down by hand.
// normal_w: [-] from the first to the second
// friction: [-]
inline Contact contact_at(int first, int second, const Vec3& position_w, const Vec3& normal_w,
                          double friction = 0.0) {
  Contact contact{
      .first = first, .second = second, .normal_w = normal_w, .friction = friction, .count = 1};
  contact.points[0].position_w = position_w;
  return contact;
}

// Boxes at rest that touch.
struct Pile {
  World world;           // the bodies
  ContactList contacts;  // where they touch; empty: not gathered yet
  double margin = 1e-9;  // [m] surfaces up to this far apart count as touching

  // Adds a movable box.
  // size: [m] full edges
  // mass: [kg]
  // friction: [-]
  int add(const Vec3& position_w, const Vec3& size = Vec3::Ones(), double mass = 1.0,
          double friction = 0.0, const Quat& orientation_wb = Quat::Identity()) {
    return put(box_properties(size, mass, friction), position_w, orientation_wb);
  }

  // Adds an immovable box.
  // size: [m] full edges
  // friction: [-]
  int add_fixed(const Vec3& position_w, const Vec3& size = Vec3::Ones(), double friction = 0.0,
                const Quat& orientation_wb = Quat::Identity()) {
    return put(fixed_box_properties(size, friction), position_w, orientation_wb);
  }

  // Adds a body; what was gathered is forgotten.
  int put(const BodyProperties& body, const Vec3& position_w,
          const Quat& orientation_wb = Quat::Identity()) {
    world.add(body, position_w, orientation_wb);
    contacts.clear();
    return world.count() - 1;
  }

  // Finds the contacts.
  void gather() { contacts = contacts_within(world, margin); }
};

}  // namespace tumble::test
