/// \file
/// \brief The damping of DAMPENOBJECTS, line by line, and its constants.
#include "tumble/impulse_damped/dampen_objects.hpp"

#include "support/test.hpp"

namespace {

struct Single {
  World world;
  BodyProperties body;
  std::vector<char> touched{1};

  explicit Single(const Vec3& size = Vec3::Ones(), const Quat& q = Quat::Identity(),
                  double mass = 1.0)
      : body(box_properties(size, mass)) {
    world.add(body, Vec3(0.0, 5.0, 0.0), q);
  }
  BodyState& state() { return world.states()[0]; }
  DampingReport damp(const DampingParts& parts, double dt = kFrame,
                     const DampedNumbers& numbers = {}) {
    ObjectDamping damping;
    return damping.run(world, touched, numbers, parts, dt, RotationRule::splitting);
  }
};

DampingParts only(std::string_view names) { return damping_parts_from(names); }

}  // namespace

TEST_CASE("Halving the step leaves the same momentum after a second", "[exact][impulse_damped]") {
  double left[3];
  int i = 0;
  for (const int rate : {60, 120, 480}) {
    Single one;
    one.state().linear_momentum_w = Vec3(3.0, 0.0, 1.0);
    for (int k = 0; k < rate; ++k) one.damp(only("scale"), 1.0 / rate);
    left[i++] = one.state().linear_momentum_w.x();
  }
  // 0.92 to the power of 60; each factor is rounded to 1e-16.
  CHECK(left[0] == near(3.0 * 0.0067184585, 1e-9));
  CHECK(left[1] == near(left[0], 1e-15));
  CHECK(left[2] == near(left[0], 1e-15));
}

TEST_CASE("A body without contact is not damped", "[unit][impulse_damped]") {
  Single one;
  one.touched[0] = 0;
  one.state().linear_momentum_w = Vec3(1.0, -0.01, 0.02);
  one.state().angular_momentum_w = Vec3(1e-3, 0.0, 1e-3);
  const BodyState before = one.state();
  CHECK(one.damp(only("scale+small+align+tilt")).energy == 0.0);
  CHECK(one.state().linear_momentum_w == before.linear_momentum_w);
  CHECK(one.state().angular_momentum_w == before.angular_momentum_w);
}

TEST_CASE("Damping commutes with a mirror", "[determinism][impulse_damped]") {
  // As printed, lines 20 and 21 stop a spin about the vertical in one sense only.
  Random random(11);
  for (int trial = 0; trial < 200; ++trial) {
    Single one(Vec3(1.0, 0.7, 0.5), rotation_from_vector(random.in_cube(0.02)));
    one.state().linear_momentum_w = random.in_cube(0.3);
    one.state().angular_momentum_w = random.in_cube(0.1);
    Single mirrored(Vec3(1.0, 0.7, 0.5));
    const Quat q = one.state().orientation_wb;
    mirrored.state().orientation_wb = Quat(q.w(), q.x(), -q.y(), -q.z());  // x -> -x
    const Vec3& p = one.state().linear_momentum_w;
    const Vec3& l = one.state().angular_momentum_w;
    mirrored.state().linear_momentum_w = Vec3(-p.x(), p.y(), p.z());
    mirrored.state().angular_momentum_w = Vec3(l.x(), -l.y(), -l.z());
    one.damp({});
    mirrored.damp({});
    const Vec3& mp = mirrored.state().linear_momentum_w;
    const Vec3& ml = mirrored.state().angular_momentum_w;
    CHECK(mp == Vec3(-p.x(), p.y(), p.z()));
    CHECK(ml == Vec3(l.x(), -l.y(), -l.z()));
    CHECK(mirrored.state().position_w.x() == -one.state().position_w.x());
  }
}

TEST_CASE("Stopping components raises the energy of a brick but not of a cube",
          "[reference][impulse_damped]") {
  // Moments 2, 17, 17 of a box turned by 45 degrees about z; L = (1, -0.5, 0). Stopping L_y takes
  // its energy from 0.0643382 to 0.1397059: 2.171 times as much.
  const double a2 = 96.0, b2 = 6.0;  // m = 2: (b²+b²)/6 = 2, (a²+b²)/6 = 17
  const Quat q = rotation_from_degrees(Vec3(0.0, 0.0, 45.0));
  Single brick(Vec3(std::sqrt(a2), std::sqrt(b2), std::sqrt(b2)), q, 2.0);
  CHECK((brick.body.inertia_b - Vec3(2.0, 17.0, 17.0)).norm() < 1e-14);
  DampedNumbers stop_half;
  const double scale = 2.0 * std::sqrt(9.81 * std::sqrt(b2)) * std::sqrt(b2);
  stop_half.eps7 = 0.0;
  stop_half.eps8 = 0.6 / scale;
  brick.state().angular_momentum_w = Vec3(1.0, -0.5, 0.0);
  const double before = kinetic_energy(brick.body, brick.state());
  const DampingReport report = brick.damp(only("small"), kFrame, stop_half);
  CHECK(before == near(0.0643382, 1e-7));
  CHECK(brick.state().angular_momentum_w == Vec3(1.0, 0.0, 0.0));
  CHECK(report.energy == near(0.1397059 - 0.0643382, 1e-7));

  Random random(4);
  double worst = 0.0;
  for (int trial = 0; trial < 2000; ++trial) {
    Single cube(Vec3::Ones(), random.orientation());
    cube.state().linear_momentum_w = random.in_cube(0.4);
    cube.state().angular_momentum_w = random.in_cube(0.2);
    const double energy = kinetic_energy(cube.body, cube.state());
    worst = std::max(worst, cube.damp(only("scale+small+align+tilt")).energy / energy);
  }
  CHECK(worst <= 1e-15);  // rounding
}

TEST_CASE("A box is turned upright by a little in each step and then stays",
          "[exact][impulse_damped]") {
  const Quat q =
      rotation_from_degrees(Vec3(0.0, 30.0, 0.0)) * rotation_from_vector(Vec3(0.0025, 0.0, 0.0));
  CHECK(check_y_axis_alignment(q, 0.0026));
  CHECK_FALSE(check_y_axis_alignment(q, 0.0024));
  Quat turned = q;
  for (const double left : {0.0015, 0.0005, 0.0}) {
    turned = tilted_towards_y_axis(turned, 0.001);
    const Vec3 up_w = turned.toRotationMatrix().col(1);
    // Rounding of an angle near 0 from components of size 1.
    CHECK(Vec3(up_w.cross(Vec3::UnitY())).norm() == near(std::sin(left), 1e-15));
  }
  // It has not turned about the vertical.
  CHECK(angle_between(turned, rotation_from_degrees(Vec3(0.0, 30.0, 0.0))) < 1e-6);
  // Any face will do: the nearest one is taken, also the one that looks down.
  const Quat down = rotation_from_degrees(Vec3(0.0, 0.0, 179.9));
  CHECK(check_y_axis_alignment(down, 0.002));
  CHECK(std::abs(tilted_towards_y_axis(down, 0.01).toRotationMatrix()(1, 1) + 1.0) < 1e-15);
}

TEST_CASE("A body that hardly moves is put back, with its energy booked",
          "[exact][impulse_damped]") {
  Single one;
  one.state().linear_momentum_w = Vec3(0.01, -0.01, 0.0);  // 0.24 mm in a step, below 0.5 mm
  const BodyState before = one.state();
  const DampingReport still = one.damp(only("freeze"));
  CHECK(still.frozen == 1);
  CHECK(one.state().position_w == before.position_w);
  CHECK(one.state().linear_momentum_w == before.linear_momentum_w);  // kept, as listed
  CHECK(still.energy == near(9.81 * 0.01 / 60.0, 1e-13));            // rounding of 50 J

  one.state().linear_momentum_w = Vec3(0.04, 0.0, 0.0);  // 0.67 mm
  CHECK(one.damp(only("freeze")).frozen == 0);
}

TEST_CASE("A released box falls, at any size, and at 1 m at any step down to 1/300 s",
          "[exact][impulse_damped]") {
  for (const double size : {0.01, 1.0, 5.0, 1e3, 1e6}) {
    for (const double rate : {1.0, 60.0, 300.0}) {
      if (size > 1.0 && rate > 60.0) continue;
      Single one(Vec3::Constant(size));
      // What gravity gives in one step, in contact with a wall: it is slowed and not stopped.
      one.state().linear_momentum_w = Vec3(0.0, -9.81 / rate, 0.0);
      one.damp(only("align+tilt+freeze"), 1.0 / rate);
      CHECK(one.state().linear_momentum_w.y() < 0.0);
      CHECK(one.state().position_w.y() < 5.0);
    }
  }
}

TEST_CASE("Parts of the damping are named one by one", "[unit][impulse_damped]") {
  CHECK(only("all").freeze);
  CHECK_FALSE(only("none").scale);
  const DampingParts two = only("scale+tilt");
  CHECK(two.scale);
  CHECK(two.tilt);
  CHECK_FALSE(two.small);
  CHECK_THROWS_WITH(only("scale+tlit"), Contains("tilt"));
  CHECK_THROWS_AS(only("scale+"), std::invalid_argument);
  CHECK_THROWS_WITH(check({.k5 = 1.1}), Contains("k5"));
}
