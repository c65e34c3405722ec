/// \file
/// \brief Static equilibrium: closed forms, certificates, friction, errors, scales, orders.
#include "tumble/geometric_stability/static_equilibrium.hpp"

#include "geometric_stability/balance_probe.hpp"
#include "support/test.hpp"
#include "support/touching.hpp"

namespace {

constexpr double kPi = std::numbers::pi;

// Bodies at rest in contact.
struct WeighedPile : Pile {
  void gather() {
    double longest = 0.0;
    for (const BodyProperties& body : world.bodies())
      if (body.shape == Shape::box) longest = std::max(longest, body.size.maxCoeff());
    margin = 1e-9 * longest;
    Pile::gather();
  }
  BalanceTask task(int friction_edges = 0) {
    if (contacts.empty()) gather();
    return BalanceTask{.contacts = contacts, .friction_edges = friction_edges};
  }
  bool balanced(int friction_edges = 0) {
    StaticEquilibrium equilibrium;
    return equilibrium.solve(world, task(friction_edges)).balanced;
  }
};

// Separation velocity of two bodies at a point, which contacts keep from being negative.
double parting(const WeighedPile& pile, const StaticEquilibrium& found, const Contact& contact,
               const Vec3& point_w) {
  const auto of = [&](int body) {
    const Acceleration& a = found.motion()[idx(body)];
    const Vec3 arm_w = point_w - pile.world.states()[idx(body)].position_w;
    return Vec3(a.linear_w + a.angular_w.cross(arm_w));
  };
  return contact.normal_w.dot(of(contact.second) - of(contact.first));
}

// Boxes in layers, each at a random place over the one below: many fall.
WeighedPile random_layers(Random& random) {
  WeighedPile pile;
  pile.world.add_ground();
  const int layers = 2 + static_cast<int>(random.below(3));
  for (int layer = 0; layer < layers; ++layer) {
    double left = random.uniform(-0.8, 0.2);
    const int count = 1 + static_cast<int>(random.below(3));
    for (int k = 0; k < count; ++k) {
      const double wide = random.uniform(0.5, 1.8);
      const double deep = random.uniform(0.6, 1.2);
      const double z = random.uniform(-0.2, 0.2);
      const double mass = random.uniform(0.2, 5.0);
      const double gap = random.uniform(0.05, 0.6);
      pile.add(Vec3(left + 0.5 * wide, layer + 0.5, z), Vec3(wide, 1.0, deep), mass);
      left += wide + gap;
    }
  }
  return pile;
}

// Figure 6.5, with lengths and masses in any unit: a top block, offset by 0.2, on two that overhang.
WeighedPile heavy_top(double mass_ratio, double length, double mass) {
  WeighedPile pile;
  for (const double side : {-1.0, 1.0}) {
    pile.add_fixed(length * Vec3(1.375 * side, 0.5, 0.0), length * Vec3(0.75, 1.0, 1.0));
    pile.add(length * Vec3(2.0 * side, 1.5, 0.0), length * Vec3(2.0, 1.0, 1.0), mass);
  }
  pile.add(length * Vec3(0.2, 2.5, 0.0), length * Vec3(2.5, 1.0, 1.0), mass_ratio * mass);
  return pile;
}

bool heavy_top_stands(double mass_ratio, double length, double mass) {
  return heavy_top(mass_ratio, length, mass).balanced();
}

// A plank that leans on a smooth wall, both turned about the vertical.
WeighedPile leaning_plank(double degrees, double friction, double turn) {
  WeighedPile pile;
  pile.world.add_ground(friction);
  const Quat about = rotation_from_vector(Vec3(0.0, turn, 0.0));
  pile.add_fixed(about * Vec3(-0.5, 2.0, 0.0), Vec3(1.0, 4.0, 4.0), 0.0, about);
  const double angle = degrees * kPi / 180.0;
  const Quat lean = rotation_from_vector(Vec3(0.0, 0.0, -angle));
  const Vec3 place_w = Vec3(2.0 * elementary::cos(angle), 0.0, 0.0) + lean * Vec3(-1.0, 0.05, 0.0);
  pile.add(about * place_w, Vec3(2.0, 0.1, 0.5), 1.0, friction, about * lean);
  return pile;
}

}  // namespace

TEST_CASE("A box on two ridges presses on them by the law of the lever",
          "[exact][geometric_stability]") {
  // Ridges of 1 mm under a plank of 2 m: a load off the middle by x has (0.9 - x)/1.8 on the left.
  for (const double x : {-0.6, 0.0, 0.3}) {
    WeighedPile pile;
    pile.add_fixed(Vec3(-0.9, 0.5, 0.0), Vec3(1e-3, 1.0, 1.0));
    pile.add_fixed(Vec3(0.9, 0.5, 0.0), Vec3(1e-3, 1.0, 1.0));
    pile.add(Vec3(x, 1.05, 0.0), Vec3(4.0, 0.1, 1.0), 3.0);
    StaticEquilibrium equilibrium;
    const BalanceTask task = pile.task();
    const BalanceReport& report = equilibrium.solve(pile.world, task);
    CHECK(report.balanced);
    CHECK(report.unknowns == 8);
    REQUIRE(equilibrium.forces_w().size() == 8);
    double left = 0.0;
    Vec3 sum_w = Vec3::Zero();
    for (std::size_t p = 0; p < 8; ++p) {
      sum_w += equilibrium.forces_w()[p];
      if (p < 4) left += equilibrium.forces_w()[p].y();
    }
    const double weight = 3.0 * kGravity;
    CHECK((sum_w - Vec3(0.0, weight, 0.0)).norm() < 1e-12 * weight);
    // [N] A force may act anywhere on a ridge: half of its width over the distance of the two.
    CHECK(left == near(weight * (0.9 - x) / 1.8, weight * 1e-3 / 1.8));
  }
}

TEST_CASE("The residual proves that no contact forces can hold the bodies",
          "[exact][geometric_stability]") {
  // Farkas: a motion that no contact resists, and in which the weights do work.
  Random random(63);
  int falling = 0;
  int standing = 0;
  for (int run = 0; run < 300; ++run) {
    WeighedPile pile = random_layers(random);
    StaticEquilibrium equilibrium;
    const BalanceTask task = pile.task();
    const bool balanced = equilibrium.solve(pile.world, task).balanced;
    ++(balanced ? standing : falling);
    double work = 0.0;    // [W/s...] a · w
    double energy = 0.0;  // a · M a
    double fastest = 0.0;
    for (int b = 0; b < pile.world.count(); ++b) {
      const BodyProperties& body = pile.world.bodies()[idx(b)];
      if (!body.movable()) continue;
      const Acceleration& a = equilibrium.motion()[idx(b)];
      work += body.mass * a.linear_w.dot(pile.world.gravity_w);
      energy += body.mass * a.linear_w.squaredNorm() +
                body.inertia_b.dot(a.angular_w.cwiseProduct(a.angular_w));  // upright boxes
      fastest = std::max(fastest, a.linear_w.norm());
    }
    double resisted = 0.0;
    std::size_t push = 0;
    for (const Contact& contact : pile.contacts)
      for (int p = 0; p < contact.count; ++p, ++push) {
        const double leaves =
            parting(pile, equilibrium, contact, contact.points[idx(p)].position_w);
        const Vec3& force_w = equilibrium.forces_w()[push];
        resisted = std::min(resisted, leaves);
        CHECK(force_w.dot(contact.normal_w) >= 0.0);
        // A contact with a force does not separate: the product of both is rounding.
        CHECK(std::min(leaves / kGravity, force_w.norm() / kGravity) < 1e-9);
      }
    CHECK(resisted > -1e-9 * kGravity);
    if (balanced) {
      CHECK(fastest <= 1e-9 * kGravity);
    } else {
      CHECK(work > 0.0);
      CHECK(work == near(energy, 1e-9 * energy + 1e-12));  // the nearest point of a cone
    }
  }
  INFO(standing << " stand, " << falling << " fall");
  CHECK(standing > 30);
  CHECK(falling > 100);
}

TEST_CASE("Equilibrium with friction finds a leaning plank's limit up to the error of the pyramid",
          "[exact][geometric_stability]") {
  // Moments about the foot: mu >= cot/2 - t/(2L). A pyramid of n edges inside Coulomb's cone has the full
  // friction along an edge, and cos(pi/n) of it between two.
  for (const double degrees : {45.0, 60.0, 75.0}) {
    const double angle = degrees * kPi / 180.0;
    const double needed = 0.5 * std::cos(angle) / std::sin(angle) - 0.5 * 0.1 / 2.0;
    for (const int edges : {4, 8, 16}) {
      INFO(degrees << " degrees, " << edges << " edges");
      const auto least = [&](double turn) {
        return chapters::threshold(
            [&](double mu) { return leaning_plank(degrees, mu, turn).balanced(edges); }, 1e-3,
            10.0);
      };
      CHECK(least(0.0) == near(needed, 1e-7 * needed));
      const double between = needed / std::cos(kPi / edges);
      CHECK(least(kPi / edges) == near(between, 1e-7 * between));
    }
    CHECK(!leaning_plank(degrees, 10.0, 0.0).balanced(0));  // friction is disabled
  }
}

TEST_CASE("Balance with friction says that a wedged box may stay, and it falls freely",
          "[claims][geometric_stability]") {
  const auto wedged = [](double friction) {
    WeighedPile pile;
    pile.add_fixed(Vec3(-1.0, 2.0, 0.0), Vec3(1.0, 4.0, 2.0), friction);
    pile.add_fixed(Vec3(1.0, 2.0, 0.0), Vec3(1.0, 4.0, 2.0), friction);
    pile.add(Vec3(0.0, 2.0, 0.0), Vec3::Ones(), 1.0, friction);
    return pile;
  };
  CHECK(wedged(0.5).balanced(4));
  CHECK(wedged(0.5).balanced(8));
  CHECK(wedged(0.05).balanced(8));
  CHECK(!wedged(0.5).balanced(0));
  CHECK(!wedged(0.0).balanced(8));
  // Nothing makes the walls press, so there is no friction.
  for (const char* name : {"contact_damped", "analytic"}) {
    INFO(name);
    World world = wedged(0.5).world;
    const std::unique_ptr<Technique> technique = make_technique(name);
    for (int k = 0; k < 30; ++k)
      REQUIRE(technique->step(world, 1.0 / 60.0).status == StepStatus::done);
    CHECK(2.0 - world.states().back().position_w.y() == near(0.5 * kGravity * 0.25, 1e-9));
  }
}

TEST_CASE("Thresholds of equilibrium do not depend on the units of length and mass, or on gravity",
          "[exact][geometric_stability]") {
  for (const double length : {1e-3, 1.0, 1e3})
    for (const double mass : {1e-6, 1.0, 1e6}) {
      INFO("lengths times " << length << ", masses times " << mass);
      const double found = chapters::threshold(
          [&](double ratio) { return heavy_top_stands(ratio, length, mass); }, 0.1, 10.0);
      CHECK(found == near(70.0 / 93.0, 1e-8));
    }
}

TEST_CASE("One body may have a hundred thousand times the mass of another, or figure 6.5 a million",
          "[exact][geometric_stability]") {
  for (const double ratio : {1e-6, 1e-3, 1e3, 1e6}) {
    INFO("top over the others: " << ratio);
    // With a nearly weightless top it falls, with a very heavy one it stands.
    CHECK(heavy_top_stands(ratio, 1.0, 1.0) == (ratio > 1.0));
  }
  // Towers with one block heavier or lighter than the rest, against sums of moments.
  Random random(67);
  int standing = 0;
  for (const double ratio : {1e-5, 1e-3, 1e3, 1e5, 1e7, 1e9}) {
    INFO("one block over the others: " << ratio);
    for (int run = 0; run < 100; ++run) {
      const int other = static_cast<int>(random.below(4));
      std::vector<double> x(4, 0.0);
      for (std::size_t k = 1; k < 4; ++k) x[k] = x[k - 1] + random.uniform(-0.45, 0.45);
      double mass = 0.0;
      double moment = 0.0;
      double inside = 1.0;  // [m] of the centre of all above, from the end of a support
      WeighedPile pile;
      pile.world.add_ground();
      for (int k = 3; k >= 0; --k) {
        const double own = k == other ? ratio : 1.0;
        mass += own;
        moment += own * x[idx(k)];
        const double under = k > 0 ? x[idx(k - 1)] : x[idx(k)];
        const double centre = moment / mass;
        inside = std::min({inside, centre - std::max(x[idx(k)], under) + 0.5,
                           std::min(x[idx(k)], under) + 0.5 - centre});
        pile.add(Vec3(x[idx(k)], k + 0.5, 0.0), Vec3::Ones(), own);
      }
      if (std::abs(inside) < 1e-3) continue;
      standing += inside > 0.0 ? 1 : 0;
      // Beyond, the rounding of a contact force can accelerate a light body; the result is on the safe side.
      if (ratio < 1e6) CHECK(pile.balanced() == (inside > 0.0));
      if (ratio > 1e6 && inside < 0.0) CHECK(!pile.balanced());
    }
  }
  CHECK(standing > 300);
}

TEST_CASE("Loads beside the weights are balanced, also if they are a couple",
          "[unit][geometric_stability]") {
  WeighedPile pile;
  pile.world.add_ground();
  const int box = pile.add(Vec3(0.013, 0.5, 0.01), Vec3(1.01, 1.0, 0.437), 0.8);
  StaticEquilibrium equilibrium;
  const auto balanced = [&](const std::vector<Load>& loads, bool weight) {
    BalanceTask task = pile.task();
    task.loads = loads;
    task.weight = weight;
    return equilibrium.solve(pile.world, task).balanced;
  };
  const Vec3 down_w(0.0, -10.3, 0.0);
  CHECK(balanced({}, false));
  CHECK(balanced({{box, Vec3(0.3, 1.0, 0.0), down_w}}, false));
  CHECK(!balanced({{box, Vec3(0.6, 1.0, 0.0), down_w}}, false));  // beyond its edge
  CHECK(equilibrium.motion()[idx(box)].angular_w.z() < 0.0);      // clockwise, to the right
  CHECK(!balanced({{box, Vec3(-0.6, 1.0, 0.0), down_w}}, false));
  CHECK(equilibrium.motion()[idx(box)].angular_w.z() > 0.0);
  CHECK(!balanced({{box, Vec3(0.0, 1.0, 0.0), -down_w}}, true));  // 10.3 N up against 7.8 N
  CHECK(equilibrium.motion()[idx(box)].linear_w.y() == near(10.3 / 0.8 - kGravity, 1e-9));
  CHECK(balanced({{box, Vec3(0.0, 1.0, 0.0), 0.7 * -down_w}}, true));
  CHECK(!balanced({{box, Vec3(0.0, 0.5, 0.0), Vec3(1.0, 0.0, 0.0)}}, true));  // no friction
  // A couple needs a lid: then two corners, one above and one below, hold it.
  const std::vector<Load> couple = {{box, Vec3(0.25, 0.5, 0.01), down_w},
                                    {box, Vec3(-0.17, 0.5, 0.0), -down_w}};
  CHECK(!balanced(couple, false));
  pile.add_fixed(Vec3(0.0, 1.5, 0.0), Vec3::Ones());
  CHECK(balanced(couple, false));
  CHECK(balanced(couple, true));
  // A load on an immovable body has no effect.
  CHECK(balanced({{0, Vec3::Zero(), down_w}}, true));
}

TEST_CASE("Held bodies stay where they are and hold whatever leans on them",
          "[unit][geometric_stability]") {
  WeighedPile pile;
  pile.world.add_ground();
  const int low = pile.add(Vec3(0.0, 0.5, 0.0));
  const int high = pile.add(Vec3(0.3, 1.5, 0.0));
  const int highest = pile.add(Vec3(0.75, 2.5, 0.0));  // with this, the middle one tips
  StaticEquilibrium equilibrium;
  BalanceTask task = pile.task();
  CHECK(!equilibrium.solve(pile.world, task).balanced);
  CHECK(equilibrium.balanced()[0] == 1);  // the ground
  const std::vector<char> held = {0, 0, 1, 0};
  task.held = held;
  const BalanceReport& report = equilibrium.solve(pile.world, task);
  CHECK(report.balanced);
  CHECK(report.unknowns == 12);
  for (const int body : {low, high, highest}) CHECK(equilibrium.balanced()[idx(body)] == 1);
  CHECK(equilibrium.motion()[idx(high)].linear_w.norm() == 0.0);
}

TEST_CASE("Equilibrium refuses invalid input with the value and the right one",
          "[unit][geometric_stability]") {
  WeighedPile pile;
  pile.world.add_ground();
  pile.add(Vec3(0.0, 0.5, 0.0));
  StaticEquilibrium equilibrium;
  const auto said = [&](const BalanceTask& task) {
    return refusal_of([&] { equilibrium.solve(pile.world, task); });
  };
  const auto contains = [](const std::string& text, const std::string& part) {
    INFO(text);
    CHECK(text.find(part) != std::string::npos);
  };
  for (const int edges : {-1, 1, 2, 3})
    contains(said(pile.task(edges)),
             "friction_edges = " + std::to_string(edges) + ": give 0 for none, or 4 and more");
  CHECK(said(pile.task(4)).empty());
  for (const int body : {-1, 2}) {
    BalanceTask task = pile.task();
    const std::vector<Load> loads = {{body, Vec3::Zero(), Vec3::UnitY()}};
    task.loads = loads;
    contains(said(task), "load on body " + std::to_string(body) + ": give an index below 2");
  }
  {
    BalanceTask task = pile.task();
    const std::vector<char> held = {0, 0, 0};
    task.held = held;
    CHECK_FALSE(said(task).empty());
  }
  {
    ContactList wrong = pile.contacts;
    wrong[0].second = 7;
    CHECK_FALSE(said({.contacts = wrong}).empty());
  }
  // After a refusal it works as before.
  CHECK(equilibrium.solve(pile.world, pile.task()).balanced);
}
