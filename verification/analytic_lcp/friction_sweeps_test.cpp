/// \file
/// \brief Contact with friction by sweeps over the points: closed forms, and that it always ends.
#include "tumble/analytic_lcp/friction_sweeps.hpp"

#include "support/test.hpp"

namespace {

// A cube of 1 kg on four corners on an immovable one, and what the pushes make of its velocity.
struct Slider {
  World world;
  std::vector<MovingBody> bodies;
  std::vector<Contact> contacts;
  std::vector<FrictionPoint> points;
  std::vector<Vec3> pushes;

  Slider(const Vec3& velocity_w, double friction) {
    world.add(fixed_box_properties(Vec3(10.0, 1.0, 10.0)), Vec3(0.0, -0.5, 0.0));
    world.add(box_properties(Vec3(1.0, 0.2, 1.0), 1.0, friction), Vec3(0.0, 0.1, 0.0));
    load_moving_bodies(world, bodies);
    bodies[1].velocity_w = velocity_w;
    Contact contact{.second = 1, .friction = friction};
    for (const double x : {-0.5, 0.5})
      for (const double z : {-0.5, 0.5})
        contact.points[static_cast<std::size_t>(contact.count++)].position_w = Vec3(x, 0.0, z);
    contacts.push_back(contact);
    for (int k = 0; k < 4; ++k) {
      points.push_back(FrictionPoint{.point = k, .normal_constant = velocity_w.y()});
    }
    pushes.assign(4, Vec3::Zero());
  }
  FrictionSweepReport solve(double wanted) {
    FrictionSweeps sweeps;
    return sweeps.solve(bodies, contacts, points, wanted, pushes);
  }
  Vec3 after() {
    std::vector<MovingBody> ended = bodies;
    for (std::size_t k = 0; k < pushes.size(); ++k)
      apply_impulse(ended[0], ended[1], contacts[0].points[k].position_w, pushes[k]);
    return ended[1].velocity_w;
  }
};

}  // namespace

TEST_CASE("Sweeps find Coulomb's law for a plate that slides, in any direction",
          "[exact][friction_sweeps][analytic_lcp]") {
  for (const double angle : {0.0, 0.3, 0.8, 2.0}) {
    CAPTURE(angle);
    const Vec3 way_w(std::cos(angle), 0.0, std::sin(angle));
    Slider slides(2.0 * way_w - 0.5 * Vec3::UnitY(), 0.4);
    CHECK(slides.solve(1e-12).error <= 1e-12);
    CHECK((slides.after() - (2.0 - 0.4 * 0.5) * way_w).norm() < 1e-9);
    Slider sticks(0.1 * way_w - 0.5 * Vec3::UnitY(), 0.4);
    CHECK(sticks.solve(1e-12).error <= 1e-12);
    CHECK(sticks.after().norm() < 1e-9);
    for (const Vec3& push_w : sticks.pushes) {
      CHECK(push_w.y() >= 0.0);
      CHECK(std::hypot(push_w.x(), push_w.z()) <= 0.4 * push_w.y() * (1.0 + 1e-12));
    }
  }
}

TEST_CASE("Sweeps end where there is no answer, with numbers",
          "[unit][friction_sweeps][analytic_lcp]") {
  // The same points, asked to leave the ground on the one side and to sink on the other at once.
  Slider squeezed(-Vec3::UnitY(), 3.0);
  Contact from_above = squeezed.contacts.front();
  from_above.normal_w = -Vec3::UnitY();
  squeezed.contacts.push_back(from_above);
  for (int k = 0; k < 4; ++k) {
    squeezed.points.push_back(FrictionPoint{.contact = 1, .point = k, .normal_constant = -1.0});
    squeezed.pushes.push_back(Vec3::Zero());
  }
  const FrictionSweepReport report = squeezed.solve(1e-9);
  CHECK(report.sweeps <= FrictionSweeps::kMostSweeps);
  CHECK(report.error > 0.1);
  for (const Vec3& push_w : squeezed.pushes) CHECK(push_w.allFinite());
}
