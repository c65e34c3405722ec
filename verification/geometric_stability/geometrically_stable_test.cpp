/// \file
/// \brief Geometric stability: orders, marks and both definitions.
#include "tumble/geometric_stability/geometrically_stable.hpp"

#include "tumble/contact/tolerances.hpp"

#include "support/test.hpp"
#include "support/touching.hpp"

namespace {

struct StablePile : Pile {
  StablePile() {
    margin = tolerance::stability_margin;
    world.add_ground();
  }
  // One character for each movable body: 1 stable, 0 not.
  std::string verdict(StableRule rule) {
    if (contacts.empty()) gather();
    std::vector<char> stable;
    GeometricStability stability;
    stability.run(world, contacts, rule, 0.02, stable);
    std::string text;
    for (std::size_t k = 0; k < stable.size(); ++k)
      if (world.bodies()[k].movable()) text += stable[k] != 0 ? '1' : '0';
    return text;
  }
  std::string both() {
    const std::string corners = verdict(StableRule::corners);
    CHECK(corners == verdict(StableRule::hull));
    return corners;
  }
};

}  // namespace

TEST_CASE("A wall that is touched stays immovable, and what stands on it stable",
          "[exact][geometric_stability]") {
  StablePile pile;
  pile.add_fixed(Vec3(0.0, 1.0, 0.0), Vec3(1.0, 2.0, 1.0));
  pile.add(Vec3(1.0, 0.5, 0.0));  // touches its side
  pile.add(Vec3(0.0, 2.5, 0.0));
  CHECK(pile.both() == "01");
}

TEST_CASE("One unstable support makes the whole box unstable, in any order",
          "[exact][geometric_stability]") {
  StablePile pile;
  pile.add_fixed(Vec3(-1.5, 0.5, 0.0), Vec3::Ones());
  pile.add_fixed(Vec3(1.5, 0.5, 0.0), Vec3::Ones());
  pile.add(Vec3(0.0, 0.5, 0.0));
  pile.add(Vec3(0.6, 0.25, 0.0), Vec3(0.2, 0.5, 0.2));  // touches the side of the last one
  pile.add(Vec3(0.0, 1.1, 0.0), Vec3(4.0, 0.2, 1.0));   // the plank
  CHECK(pile.both() == "000");
  // Without the loose one the plank is stable.
  StablePile clear;
  clear.add_fixed(Vec3(-1.5, 0.5, 0.0), Vec3::Ones());
  clear.add_fixed(Vec3(1.5, 0.5, 0.0), Vec3::Ones());
  clear.add(Vec3(0.0, 1.1, 0.0), Vec3(4.0, 0.2, 1.0));
  CHECK(clear.both() == "1");
}

TEST_CASE("The set of stable bodies does not depend on the order of contacts",
          "[determinism][geometric_stability]") {
  Random random(9);
  int stable = 0;
  for (int trial = 0; trial < 200; ++trial) {
    StablePile pile;
    // Boxes of few sizes at few places: many share heights, sides and corners.
    for (int k = 0; k < 12; ++k) {
      const double width = 0.5 * (1 + random.below(3));
      const double x = 0.5 * random.below(8);
      const double y = 0.5 + random.below(3);
      pile.add(Vec3(x, y, 0.0), Vec3(width, 1.0, 1.0));
    }
    const std::string first = pile.both();
    stable += static_cast<int>(std::ranges::count(first, '1'));
    for (int shuffle = 0; shuffle < 10; ++shuffle) {
      for (std::size_t i = pile.contacts.size(); i > 1; --i)
        std::swap(pile.contacts[i - 1], pile.contacts[random.below(static_cast<std::uint32_t>(i))]);
      REQUIRE(pile.both() == first);
    }
  }
  CHECK(stable > 50);  // 76
}

TEST_CASE("A rising body is not stable", "[exact][geometric_stability]") {
  StablePile pile;
  pile.add(Vec3(0.0, 0.5, 0.0));
  pile.world.states()[1].linear_momentum_w.y() = 0.1;  // the limit is 0.02 sqrt(9.81) = 0.063
  CHECK(pile.both() == "0");
  pile.world.states()[1].linear_momentum_w.y() = 0.05;
  CHECK(pile.both() == "1");
}

TEST_CASE("A tilt by a twentieth of a degree does not matter, three degrees do",
          "[unit][geometric_stability]") {
  for (const double degrees : {0.0, 0.05, 3.0}) {
    StablePile pile;
    pile.add(Vec3(0.0, 0.5 + 1e-3, 0.0), Vec3::Ones(), 1.0, 0.0,
             rotation_from_degrees(Vec3(0.0, 20.0, degrees)));
    CHECK(pile.both() == (degrees < 1.0 ? "1" : "0"));
  }
}

TEST_CASE("A verdict names the reason against a body: motion, a side, a support, a corner",
          "[exact][geometric_stability]") {
  StablePile pile;
  const int firm = pile.add(Vec3(0.0, 0.5, 0.0));
  const int beside = pile.add(Vec3(3.0, 0.5, 0.0));
  const int neighbour = pile.add(Vec3(4.0, 0.5, 0.0));
  const int on_it = pile.add(Vec3(3.0, 1.5, 0.0), Vec3(0.5, 1.0, 0.5));
  const int over = pile.add(Vec3(0.25, 1.5, 0.125));
  const int rising = pile.add(Vec3(8.0, 0.5, 0.0));
  pile.world.states()[idx(rising)].linear_momentum_w.y() = 1.0;
  pile.gather();
  std::vector<char> stable;
  GeometricStability stability;
  for (const StableRule rule : {StableRule::corners, StableRule::hull}) {
    stability.run(pile.world, pile.contacts, rule, 0.02, stable);
    const auto verdict = [&](int body) { return stability.verdict(pile.world, body); };
    const auto words = [&](int body) {
      return explanation(pile.world, pile.contacts, verdict(body));
    };
    const auto pair_of = [&](int body) {
      const Contact& contact = pile.contacts[static_cast<std::size_t>(verdict(body).contact)];
      return std::vector<int>{contact.first, contact.second};
    };
    for (int body = 0; body < pile.world.count(); ++body)
      CHECK(verdict(body).stable() == (stable[idx(body)] != 0));
    CHECK(verdict(0).reason == StabilityReason::immovable);
    CHECK(words(0) == "immovable");
    CHECK(verdict(firm).reason == StabilityReason::supported);
    CHECK(words(firm) == "supports any load");
    CHECK(verdict(rising).reason == StabilityReason::moving);
    CHECK(words(rising) == "rises, sinks or tips");
    for (const int body : {beside, neighbour}) {
      CHECK(verdict(body).reason == StabilityReason::side_contact);
      CHECK(pair_of(body) == std::vector<int>{beside, neighbour});
      CHECK(words(body) == "the contact of box2 and box3 is not vertical");
    }
    CHECK(verdict(on_it).reason == StabilityReason::unstable_support);
    CHECK(pair_of(on_it) == std::vector<int>{beside, on_it});
    CHECK(words(on_it) == "of box2 and box4, the lower one is not stable");
    // Of the three overhanging corners, the one that overhangs most.
    CHECK(verdict(over).reason == StabilityReason::corner);
    CHECK(verdict(over).corner_xz == Vec2(0.75, 0.625));
    CHECK(words(over) == "the corner at x = 0.75 m, z = 0.625 m is not supported");
  }
  CHECK_THROWS_WITH(stability.verdict(pile.world, 99), Contains("99"));
}

TEST_CASE("A prism is judged by the hull under its own outline, and never by four corners",
          "[exact][geometric_stability]") {
  // A triangular prism on three posts; its body is the box around it.
  StablePile pile;
  const std::vector<Vec2> triangle{{-1.0, -1.0}, {1.0, -1.0}, {0.0, 1.0}};
  for (const Vec2& corner : triangle)
    pile.add_fixed(Vec3(corner.x(), 0.5, corner.y()), Vec3(0.4, 1.0, 0.4));
  pile.gather();
  const int prism = pile.add(Vec3(0.0, 1.5, 0.0), Vec3(2.0, 1.0, 2.0));
  for (int post = 0; post < 3; ++post) {
    Contact contact{.first = post + 1, .second = prism, .count = 1};
    const Vec2& corner = triangle[idx(post)];
    contact.points[0].position_w = Vec3(corner.x(), 1.0, corner.y());
    pile.contacts.push_back(contact);
  }
  std::vector<GeometricStability::Outline> outlines(pile.world.bodies().size());
  outlines.back() = triangle;
  GeometricStability stability;
  std::vector<char> stable;
  const auto is_stable = [&](StableRule rule) {
    stability.run(pile.world, pile.contacts, rule, 0.02, stable, outlines);
    return stable.back() != 0;
  };
  CHECK_FALSE(is_stable(StableRule::corners));
  CHECK(is_stable(StableRule::hull));
  // As the box around it, it has corners without support.
  stability.run(pile.world, pile.contacts, StableRule::hull, 0.02, stable);
  CHECK(stable.back() == 0);
  // The last post is 3 cm short of the corner, three times the tolerance.
  pile.contacts.back().points[0].position_w.z() -= 0.03;
  CHECK_FALSE(is_stable(StableRule::hull));
  const StabilityVerdict verdict = stability.verdict(pile.world, prism);
  CHECK(verdict.reason == StabilityReason::corner);
  CHECK(verdict.corner_xz == triangle.back());
  outlines.pop_back();
  CHECK_THROWS_WITH(is_stable(StableRule::hull), Contains("outlines: 4 for 5"));
}

TEST_CASE(
    "Where motion counts, a body that sinks, tips or rocks is not steady, and one that slides is",
    "[exact][geometric_stability]") {
  const auto stable_with = [](const Vec3& momentum_w, const Vec3& angular_w, double steady) {
    StablePile pile;
    pile.add(Vec3(0.0, 0.5, 0.0));
    pile.world.states()[1].linear_momentum_w = momentum_w;
    pile.world.states()[1].angular_momentum_w = angular_w;
    pile.gather();
    GeometricStability stability({.steady = steady});
    std::vector<char> stable;
    stability.run(pile.world, pile.contacts, StableRule::hull, 0.02, stable);
    CHECK((stable[1] != 0) ==
          (stability.verdict(pile.world, 1).reason == StabilityReason::supported));
    return stable[1] != 0;
  };
  const double none = kInfinity;
  // The limit is 1e-3 sqrt(9.81) = 3.1 mm/s; a cube of 1 kg turns with 6 times its angular momentum, and
  // its corners are 0.87 m away.
  const Vec3 zero = Vec3::Zero();
  CHECK(stable_with(Vec3(0.0, -0.1, 0.0), zero, none));
  CHECK_FALSE(stable_with(Vec3(0.0, -0.1, 0.0), zero, 1e-3));
  CHECK(stable_with(Vec3(0.0, -3.0e-3, 0.0), zero, 1e-3));
  CHECK_FALSE(stable_with(Vec3(0.0, -3.2e-3, 0.0), zero, 1e-3));
  CHECK(stable_with(zero, Vec3(5.9e-4, 0.0, 0.0), 1e-3));
  CHECK_FALSE(stable_with(zero, Vec3(6.2e-4, 0.0, 0.0), 1e-3));
  CHECK_FALSE(stable_with(zero, Vec3(0.0, 0.0, 6.2e-4), 1e-3));
  CHECK(stable_with(Vec3(2.0, 0.0, 1.0), Vec3(0.0, 1.0, 0.0), 1e-3));
}

TEST_CASE("Without weight a resting box is stable as long as speeds are not tested",
          "[exact][geometric_stability]") {
  StablePile pile;
  pile.add(Vec3(0.0, 0.5, 0.0));
  pile.world.gravity_w = Vec3::Zero();
  pile.gather();
  std::vector<char> stable;
  GeometricStability().run(pile.world, pile.contacts, StableRule::corners, 0.02, stable);
  CHECK(stable[1] == 1);
}
