/// \file
/// \brief Towers as one heavier block: closed forms, loads, shapes without towers, orders.
#include "tumble/geometric_stability/towers.hpp"

#include "tumble/geometric_stability/static_equilibrium.hpp"

#include "support/test.hpp"
#include "support/touching.hpp"

namespace {

// Bodies in contact, with gathered contacts.
struct TowerPile : Pile {
  TowerPile() { margin = 1e-6; }
  Towers towers(std::span<const char> held = {}) {
    if (contacts.empty()) gather();
    Towers result;
    result.run(world, contacts, held);
    return result;
  }
  // Whether all bodies are in towers that stand.
  bool stands() {
    const Towers found = towers();
    for (int b = 0; b < world.count(); ++b)
      if (world.bodies()[idx(b)].movable() && found.states()[idx(b)] != TowerState::supported)
        return false;
    return true;
  }
  bool in_balance() {
    if (contacts.empty()) gather();
    StaticEquilibrium equilibrium;
    return equilibrium.solve(world, {.contacts = contacts}).balanced;
  }
};

double harmonic_overhang(int blocks) {
  double sum = 0.0;
  for (int k = 1; k <= blocks; ++k) sum += 0.5 / k;
  return sum;
}

// Blocks over the edge of a table: the k-th from the top is scale/(2k) over the next one.
TowerPile blocks_over_edge(int blocks, double scale) {
  TowerPile pile;
  pile.add_fixed(Vec3(-2.0, -0.5, 0.0), Vec3(4.0, 1.0, 1.0));
  double right = 0.0;
  for (int k = blocks; k >= 1; --k) {
    right += scale * 0.5 / k;
    pile.add(Vec3(right - 0.5, 0.3 * (blocks - k) + 0.15, 0.0), Vec3(1.0, 0.3, 1.0));
  }
  return pile;
}

}  // namespace

TEST_CASE("A tower stands as long as the centre of the load is above each support",
          "[exact][geometric_stability]") {
  SECTION("blocks over an edge reach a half of the harmonic sum") {
    CHECK(harmonic_overhang(6) == near(49.0 / 40.0, 1e-15));
    for (int n = 1; n <= 6; ++n) {
      INFO(n << " blocks");
      // [-] A millionth of the reach, on both sides.
      CHECK(blocks_over_edge(n, 1.0 - 1e-6).stands());
      CHECK(!blocks_over_edge(n, 1.0 + 1e-6).stands());
    }
  }
  SECTION("random towers: each level by hand") {
    Random random(41);
    int standing = 0;
    int tipping = 0;
    for (int run = 0; run < 400; ++run) {
      TowerPile pile;
      pile.world.add_ground();
      const int count = 1 + static_cast<int>(random.below(6));
      double top = 0.0;
      Vec3 place_w(0.0, 0.0, 0.0);
      for (int k = 0; k < count; ++k) {
        const double wide = random.uniform(0.5, 2.0);
        const double deep = random.uniform(0.5, 2.0);
        const double high = random.uniform(0.2, 1.0);
        const double decade = random.uniform(-3.0, 3.0);
        const double aside_x = random.uniform(-0.45, 0.45);
        const double aside_z = random.uniform(-0.45, 0.45);
        if (k > 0) place_w += Vec3(aside_x, 0.0, aside_z);
        pile.add(Vec3(place_w.x(), top + 0.5 * high, place_w.z()), Vec3(wide, high, deep),
                 elementary::exp(decade * 2.302585092994046));
        top += high;
      }
      const Towers towers = pile.towers();
      // Expected by hand, from the top down; upright boxes touch in the overlap of two rectangles.
      double mass = 0.0;
      Vec3 moment_w = Vec3::Zero();
      bool above_stands = true;
      for (int b = count; b >= 1; --b) {
        const BodyProperties& body = pile.world.bodies()[idx(b)];
        const Vec3& p = pile.world.states()[idx(b)].position_w;
        mass += body.mass;
        moment_w += body.mass * p;
        const Vec3 centre_w = moment_w / mass;
        double inside = 1.0;  // [m] from the edge
        for (const int axis : {0, 2}) {
          double low = p[axis] - 0.5 * body.size[axis];
          double high = p[axis] + 0.5 * body.size[axis];
          if (b > 1) {
            const double q = pile.world.states()[idx(b - 1)].position_w[axis];
            const double half = 0.5 * pile.world.bodies()[idx(b - 1)].size[axis];
            low = std::max(low, q - half);
            high = std::min(high, q + half);
          }
          inside = std::min({inside, centre_w[axis] - low, high - centre_w[axis]});
        }
        if (!above_stands) {
          CHECK(towers.states()[idx(b)] == TowerState::none);  // undecided
        } else if (inside > 1e-6) {
          CHECK(towers.states()[idx(b)] == TowerState::supported);
          CHECK(towers.supports()[idx(b)] == b - 1);
          CHECK(towers.loads()[idx(b)].mass == near(mass, 1e-12 * mass));
          CHECK((towers.loads()[idx(b)].centre_w() - centre_w).norm() < 1e-12 * top);
        } else if (inside < -1e-6) {
          CHECK(towers.states()[idx(b)] == TowerState::tips);
          above_stands = false;
        }
      }
      ++(above_stands ? standing : tipping);
      CHECK(pile.stands() == above_stands);
      CHECK(pile.in_balance() == above_stands);
    }
    INFO(standing << " stand, " << tipping << " tip");
    CHECK(standing > 50);
    CHECK(tipping > 50);
  }
}

TEST_CASE("A box on two others, or touched from the side, is no part of a tower",
          "[unit][geometric_stability]") {
  TowerPile pile;
  pile.world.add_ground();
  const int left = pile.add(Vec3(-0.6, 0.5, 0.0));
  const int right = pile.add(Vec3(0.6, 0.5, 0.0));
  const int across = pile.add(Vec3(0.0, 1.5, 0.0), Vec3(2.0, 1.0, 1.0));
  const int on_top = pile.add(Vec3(0.3, 2.5, 0.0));
  const int alone = pile.add(Vec3(5.0, 0.5, 0.0));
  const int touches = pile.add(Vec3(6.0, 0.5, 0.0));
  const int on_alone = pile.add(Vec3(4.9, 1.5, 0.2));
  const Towers towers = pile.towers();
  const auto state = [&](int b) { return towers.states()[idx(b)]; };
  CHECK(state(on_top) == TowerState::supported);
  CHECK(towers.supports()[idx(on_top)] == across);
  CHECK(state(across) == TowerState::none);
  CHECK(towers.supports()[idx(across)] == -1);
  // A body below a box that is not in a tower has not all its loads.
  CHECK(state(left) == TowerState::none);
  CHECK(state(right) == TowerState::none);
  CHECK(towers.loads()[idx(across)].mass == near(2.0, 1e-15));
  // Side by side: both may be pushed aside. A box on one of them is still its load.
  CHECK(state(alone) == TowerState::none);
  CHECK(state(touches) == TowerState::none);
  CHECK(state(on_alone) == TowerState::supported);
  CHECK(towers.loads()[idx(alone)].mass == near(2.0, 1e-15));
}

TEST_CASE("A held body counts as ground, not as a load", "[unit][geometric_stability]") {
  TowerPile pile;
  pile.world.add_ground();
  const int low = pile.add(Vec3(0.0, 0.5, 0.0));
  const int high = pile.add(Vec3(0.4, 1.5, 0.0));
  const std::vector<char> held = {0, 1, 0};
  const Towers towers = pile.towers(held);
  CHECK(towers.states()[idx(low)] == TowerState::none);
  CHECK(towers.supports()[idx(low)] == -1);
  CHECK(towers.states()[idx(high)] == TowerState::supported);
  CHECK(towers.supports()[idx(high)] == low);
  CHECK(towers.loads()[0].mass == 0.0);
}

TEST_CASE("A support given as two contacts holds as much as the two together",
          "[unit][geometric_stability]") {
  TowerPile pile;
  pile.world.add_ground();
  pile.add(Vec3(0.0, 0.5, 0.0));
  pile.add(Vec3(0.2, 1.5, 0.0));
  pile.gather();
  REQUIRE(pile.contacts.size() == 2);
  REQUIRE(pile.contacts[1].count == 4);
  // Two points each, on opposite sides: neither line alone supports the centre.
  Contact half = pile.contacts[1];
  std::sort(half.points.begin(), half.points.begin() + 4,
            [](const ContactPoint& a, const ContactPoint& b) {
              return a.position_w.x() < b.position_w.x();
            });
  Contact other = half;
  std::copy(other.points.begin() + 2, other.points.begin() + 4, other.points.begin());
  half.count = 2;
  other.count = 2;
  pile.contacts[1] = half;
  CHECK(!pile.stands());
  pile.contacts.push_back(other);
  CHECK(pile.stands());
  const Towers towers = pile.towers();
  CHECK(towers.loads()[1].mass == near(2.0, 1e-15));  // once, not once for each contact
}
