/// \file
/// \brief Held bodies: the levels of the hierarchy, and the memory.
#include "tumble/geometric_stability/stable_boxes.hpp"

#include "support/test.hpp"
#include "support/touching.hpp"

namespace {

constexpr char kFree = static_cast<char>(Hold::free);
constexpr char kUpright = static_cast<char>(Hold::upright);
constexpr char kStill = static_cast<char>(Hold::still);

// Boxes, their contacts, and which of them are held.
struct Structure {
  World world;
  ContactList contacts;
  std::vector<MovingBody> moving;

  Structure() { world.add_ground(0.0); }
  BodyId add(const Vec3& position_w, const Vec3& size = Vec3::Ones(), double mass = 1.0) {
    return world.add(box_properties(size, mass, 0.0), position_w);
  }
  BodyId add_fixed(const Vec3& position_w, const Vec3& size, const Quat& q = Quat::Identity()) {
    return world.add(fixed_box_properties(size, 0.0), position_w, q);
  }
  void gather() {
    load_moving_bodies(world, moving);
    contacts = contacts_within(world, 1e-6);
  }
  std::vector<char> find(StableBoxes& boxes) {
    gather();
    const std::span<const char> held = boxes.find(world, moving, contacts);
    return {held.begin(), held.end()};
  }
  std::vector<char> find(StableRule rule) {
    StableBoxes boxes(rule);
    return find(boxes);
  }
  // By name, of movable bodies: f free, u upright, s still.
  std::string holds(StableRule rule) {
    const std::vector<char> held = find(rule);
    std::string text;
    for (std::size_t b = 0; b < held.size(); ++b)
      if (world.bodies()[b].movable()) text += "fus"[static_cast<std::size_t>(held[b])];
    return text;
  }
};

// Figure 6.5: two blocks that would each tip outwards from its pedestal, and a box on their inner
// ends that prevents it. With a depth of 1 m for all it stands from 2/3 of a block's mass on.
struct Bridge : Structure {
  BodyId left, right, top;

  explicit Bridge(double top_mass) {
    add_fixed(Vec3(-1.375, 0.5, 0.0), Vec3(0.75, 1.0, 1.0));
    add_fixed(Vec3(1.375, 0.5, 0.0), Vec3(0.75, 1.0, 1.0));
    left = add(Vec3(-2.0, 1.5, 0.0), Vec3(2.0, 1.0, 1.0));
    right = add(Vec3(2.0, 1.5, 0.0), Vec3(2.0, 1.0, 1.0));
    top = add_top(top_mass);
  }
  BodyId add_top(double mass) { return add(Vec3(0.0, 2.5, 0.0), Vec3(2.5, 1.0, 1.0), mass); }
};

// A pile of boxes of few sizes at few places, multiples of half an edge: many share sides.
Structure heap(Random& random, int count) {
  Structure s;
  for (int level = 0; level < 3; ++level) {
    double x = 0.25 * random.below(4);
    for (int k = 0; k < count; ++k) {
      const double width = 0.5 * (1 + random.below(3));
      if (random.below(4) != 0) s.add(Vec3(x + 0.5 * width, 0.5 + level, 0.0), Vec3(width, 1, 1));
      x += width + 0.25 * random.below(3);
    }
  }
  return s;
}

}  // namespace

TEST_CASE("A box whose corners are supported is held upright by every rule but off",
          "[exact][geometric_stability]") {
  Structure s;
  s.add(Vec3(0.0, 0.5, 0.0), Vec3(2.0, 1.0, 2.0));
  s.add(Vec3(0.2, 1.5, 0.0));
  for (const StableRule rule : {StableRule::corners, StableRule::hull, StableRule::equilibrium})
    CHECK(s.find(rule) == std::vector<char>{kStill, kUpright, kUpright});
  CHECK(s.find(StableRule::off) == std::vector<char>{kStill, kFree, kFree});
}

TEST_CASE("Towers that overhang and bridges in balance are held by equilibrium alone",
          "[exact][geometric_stability]") {
  Structure tower;
  tower.add(Vec3(0.0, 0.5, 0.0));
  tower.add(Vec3(0.3, 1.5, 0.0));
  tower.add(Vec3(0.4, 2.5, 0.0));  // the centre of both is at 0.35
  Bridge bridge(0.7);
  for (const StableRule rule : {StableRule::corners, StableRule::hull}) {
    CHECK(tower.holds(rule) == "uff");
    CHECK(bridge.holds(rule) == "fff");
  }
  CHECK(tower.holds(StableRule::equilibrium) == "uuu");
  CHECK(bridge.holds(StableRule::equilibrium) == "uuu");
  tower.add(Vec3(1.2, 3.5, 0.0));  // beyond the edge of the one below, at 0.9: it tips
  CHECK(tower.holds(StableRule::equilibrium) == "ufff");
}

TEST_CASE("Figure 6.5 is held from two thirds of a block's mass on",
          "[exact][geometric_stability]") {
  // N = M/2 on each inner end at a lever of 3/4 of a metre; a block's own weight has 1/4.
  CHECK(Bridge(2.0 / 3.0 * (1.0 + 1e-6)).holds(StableRule::equilibrium) == "uuu");
  CHECK(Bridge(2.0 / 3.0 * (1.0 - 1e-6)).holds(StableRule::equilibrium) == "fff");
}

TEST_CASE("A tower on a bridge is its load", "[exact][geometric_stability]") {
  // 0.5 and 0.2 together are more than 2/3, 0.5 alone is less.
  Bridge bridge(0.5);
  CHECK(bridge.holds(StableRule::equilibrium) == "fff");
  bridge.add(Vec3(0.0, 3.5, 0.0), Vec3::Ones(), 0.2);
  CHECK(bridge.holds(StableRule::equilibrium) == "uuuu");
  bridge.add(Vec3(-2.5, 2.5, 0.0), Vec3::Ones(), 0.5);  // on the outer end of the left block
  CHECK(bridge.holds(StableRule::equilibrium) == "fffff");
}

TEST_CASE("Each rule holds all bodies that the one before it holds",
          "[exact][geometric_stability]") {
  int by_corners = 0;
  int by_equilibrium = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    Structure s = heap(random, 4);
    const std::vector<char> corners = s.find(StableRule::corners);
    const std::vector<char> equilibrium = s.find(StableRule::equilibrium);
    INFO("seed " << seed);
    CHECK(corners == s.find(StableRule::hull));  // for boxes the two agree
    for (std::size_t b = 0; b < corners.size(); ++b) {
      if (corners[b] != kFree) CHECK(equilibrium[b] == corners[b]);
      by_corners += corners[b] != kFree ? 1 : 0;
      by_equilibrium += equilibrium[b] != kFree ? 1 : 0;
    }
  }
  CHECK(by_corners > 500);                   // measured 597, grounds among them
  CHECK(by_equilibrium > by_corners + 300);  // measured 960
}

TEST_CASE("Which bodies are held does not depend on the order of bodies or contacts",
          "[determinism][geometric_stability]") {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    Structure s = heap(random, 4);
    const std::vector<char> held = s.find(StableRule::equilibrium);
    std::vector<std::size_t> order;
    for (std::size_t b = 1; b < held.size(); ++b) order.push_back(b);
    for (std::size_t i = order.size(); i > 1; --i)
      std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
    Structure other;
    for (const std::size_t b : order)
      other.add(s.world.states()[b].position_w, s.world.bodies()[b].size);
    other.gather();
    for (std::size_t i = other.contacts.size(); i > 1; --i)
      std::swap(other.contacts[i - 1], other.contacts[random.below(static_cast<std::uint32_t>(i))]);
    StableBoxes boxes(StableRule::equilibrium);
    const std::span<const char> found = boxes.find(other.world, other.moving, other.contacts);
    INFO("seed " << seed);
    for (std::size_t k = 0; k < order.size(); ++k) CHECK(found[k + 1] == held[order[k]]);
  }
}

TEST_CASE("Where a support is not vertical the whole island is held still, or not at all",
          "[exact][geometric_stability]") {
  Structure s;
  s.add_fixed(Vec3(-1.0, 0.5, 0.0), Vec3::Ones());  // a wall
  const BodyId box = s.add(Vec3(0.0, 0.5, 0.0));
  CHECK(s.holds(StableRule::corners) == "f");
  CHECK(s.holds(StableRule::equilibrium) == "s");
  // Along the wall: no acceleration now, but the wall may end.
  s.world.set_velocity(box, Vec3(0.0, 0.0, 1.0), Vec3::Zero());
  CHECK(s.holds(StableRule::equilibrium) == "f");
}

TEST_CASE("A body that rises, sinks or tips is free, and so is its group",
          "[exact][geometric_stability]") {
  // tolerance::resting_speed of the root of g times a metre is 3.13 mm/s.
  for (const auto& [velocity, spin, told] :
       {std::tuple(Vec3(0.0, 0.004, 0.0), Vec3(0.0, 0.0, 0.0), "fff"),
        std::tuple(Vec3(0.0, -0.004, 0.0), Vec3(0.0, 0.0, 0.0), "fff"),
        std::tuple(Vec3(0.0, 0.0, 0.0), Vec3(0.004, 0.0, 0.0), "fff"),
        std::tuple(Vec3(5.0, 0.0, 0.0), Vec3(0.0, 0.0, 0.0), "uuu"),
        std::tuple(Vec3(0.0, 0.0, 0.0), Vec3(0.0, 5.0, 0.0),
                   "fff"),  // about no principal axis, too
        std::tuple(Vec3(0.0, 0.002, 0.0), Vec3(0.0, 0.0, 0.0), "uuu")}) {
    Bridge bridge(1.0);
    bridge.world.set_velocity(bridge.top, velocity, spin);
    INFO(velocity.transpose() << ", " << spin.transpose());
    CHECK(bridge.holds(StableRule::equilibrium) == told);
  }
  for (const auto& [velocity, spin] : {std::pair(Vec3(0.0, 0.004, 0.0), Vec3(0.0, 0.0, 0.0)),
                                       std::pair(Vec3(0.0, -0.004, 0.0), Vec3(0.0, 0.0, 0.0)),
                                       std::pair(Vec3(0.0, 0.0, 0.0), Vec3(0.0, 0.0, -0.004))}) {
    Structure pile;
    pile.add(Vec3(0.0, 0.5, 0.0));
    const BodyId upper = pile.add(Vec3(0.0, 1.5, 0.0));
    pile.world.set_velocity(upper, velocity, spin);
    INFO(velocity.transpose() << ", " << spin.transpose());
    for (const StableRule rule : {StableRule::corners, StableRule::hull, StableRule::equilibrium})
      CHECK(pile.holds(rule) == "uf");
  }
}

TEST_CASE("With gravity from the side, upwards or none the thesis's rules hold no body",
          "[exact][geometric_stability]") {
  for (const Vec3& gravity :
       {Vec3(9.81, 0.0, 0.0), Vec3(0.1, -9.81, 0.0), Vec3(0.0, 9.81, 0.0), Vec3(0.0, 0.0, 0.0)}) {
    Structure s;
    s.add(Vec3(0.0, 0.5, 0.0));
    s.add(Vec3(0.0, 1.5, 0.0));
    s.world.gravity_w = gravity;
    INFO(gravity.transpose());
    for (const StableRule rule : {StableRule::corners, StableRule::hull})
      CHECK(s.find(rule) == std::vector<char>{kStill, kFree, kFree});
    // Without weight everything is in equilibrium, and no body is held.
    CHECK(s.holds(StableRule::equilibrium) == "ff");
  }
  // A wall under the direction of gravity supports the box: in the present state nothing moves.
  Structure s;
  s.add_fixed(Vec3(1.0, 0.5, 0.0), Vec3::Ones());
  s.add(Vec3(0.0, 0.5, 0.0));
  s.world.gravity_w = Vec3(9.81, -9.81, 0.0);
  CHECK(s.holds(StableRule::equilibrium) == "s");
  CHECK(s.holds(StableRule::hull) == "f");
}

TEST_CASE("A change of any input of a verdict is detected", "[unit][geometric_stability]") {
  using Change = std::function<void(Bridge&)>;
  const auto move = [](Bridge& b, BodyId id, const Vec3& by) {
    BodyState state = b.world.states()[static_cast<std::size_t>(b.world.index_of(id))];
    state.position_w += by;
    b.world.set_state(id, state);
  };
  const std::vector<std::pair<std::string, Change>> changes{
      {"a contact moved", [&](Bridge& b) { move(b, b.top, Vec3(0.0, 0.0, 1e-9)); }},
      {"a contact lost", [&](Bridge& b) { move(b, b.top, Vec3(0.0, 0.1, 0.0)); }},
      {"the centre moved, the contacts did not",
       [&](Bridge& b) { move(b, b.left, Vec3(-0.01, 0.0, 0.0)); }},
      {"speed", [](Bridge& b) { b.world.set_velocity(b.top, Vec3(0, 1, 0), Vec3::Zero()); }},
      {"slip", [](Bridge& b) { b.world.set_velocity(b.top, Vec3(1, 0, 0), Vec3::Zero()); }},
      {"spin", [](Bridge& b) { b.world.set_velocity(b.top, Vec3::Zero(), Vec3(0, 0, 1)); }},
      {"gravity", [](Bridge& b) { b.world.gravity_w.y() = -1.62; }},
      {"direction of gravity", [](Bridge& b) { b.world.gravity_w.x() = 1.0; }},
      {"a body added", [](Bridge& b) { b.add(Vec3(0.0, 3.5, 0.0)); }},
      {"a body removed", [](Bridge& b) { b.world.remove(b.top); }},
      {"a body replaced",
       [](Bridge& b) {
         b.world.remove(b.top);
         b.top = b.add_top(1.0);
       }},
      {"another mass, the same id", [](Bridge& b) { b = Bridge(0.5); }},
  };
  for (const auto& [what, change] : changes) {
    INFO(what);
    Bridge bridge(1.0);
    StableBoxes boxes(StableRule::equilibrium);
    bridge.find(boxes);
    change(bridge);
    const std::vector<char> found = bridge.find(boxes);
    CHECK_FALSE(boxes.report().remembered);
    CHECK(found == bridge.find(StableRule::equilibrium));
    bridge.find(boxes);
    CHECK(boxes.report().remembered);
  }
}

TEST_CASE("Forgetting which bodies are stable changes no bit",
          "[determinism][geometric_stability]") {
  // A plank slides on a smaller pedestal: its contact stays, its centre moves.
  Structure s;
  s.add_fixed(Vec3(0.0, 0.5, 0.0), Vec3::Ones());
  const BodyId plank = s.add(Vec3(0.0, 1.1, 0.0), Vec3(4.0, 0.2, 1.0));
  StableBoxes boxes(StableRule::equilibrium);
  for (int k = 0; k <= 12; ++k) {
    BodyState state = s.world.states()[2];
    state.position_w.x() = 0.0625 * k;
    s.world.set_state(plank, state);
    INFO("centre at " << state.position_w.x());
    CHECK(s.find(boxes) == s.find(StableRule::equilibrium));
    CHECK(s.find(boxes)[2] == (k <= 8 ? kUpright : kFree));
  }

  // Piles in which one box after the other is moved, pushed or removed.
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    Structure heaps = heap(random, 4);
    StableBoxes memory(StableRule::equilibrium);
    for (int k = 0; k < 20 && heaps.world.count() > 1; ++k) {
      const auto b = 1 + random.below(static_cast<std::uint32_t>(heaps.world.count() - 1));
      const BodyId id = heaps.world.ids()[b];
      BodyState state = heaps.world.states()[b];
      const std::uint32_t what = random.below(4);
      if (what == 0) heaps.world.remove(id);
      if (what == 1)
        heaps.world.set_velocity(id, Vec3(random.uniform(-1.0, 1.0), 0, 0), Vec3::Zero());
      if (what == 2) {
        state.position_w.z() += random.uniform(-0.3, 0.3);
        heaps.world.set_state(id, state);
      }
      INFO("seed " << seed << ", change " << k);
      CHECK(heaps.find(memory) == heaps.find(StableRule::equilibrium));
    }
  }
}

TEST_CASE("Worlds without bodies, contacts or movable bodies are searched",
          "[unit][geometric_stability]") {
  for (const StableRule rule :
       {StableRule::off, StableRule::corners, StableRule::hull, StableRule::equilibrium}) {
    StableBoxes boxes(rule);
    const World nothing;
    CHECK(boxes.find(nothing, {}, {}).empty());
    Structure s;
    CHECK(s.find(boxes) == std::vector<char>{kStill});
    s.add_fixed(Vec3(0.0, 0.5, 0.0), Vec3::Ones());
    CHECK(s.find(boxes) == std::vector<char>{kStill, kStill});
    s.add(Vec3(0.0, 5.0, 0.0));  // in the air
    CHECK(s.find(boxes) == std::vector<char>{kStill, kStill, kFree});
    CHECK(boxes.report().stable == 0);
  }
}

TEST_CASE("Contacts of missing bodies and a wrong number of velocities are refused by StableBoxes",
          "[unit][geometric_stability]") {
  for (const StableRule rule : {StableRule::corners, StableRule::equilibrium}) {
    Structure s;
    s.add(Vec3(0.0, 0.5, 0.0));
    s.gather();
    StableBoxes boxes(rule);
    CHECK_THROWS_WITH(boxes.find(s.world, {}, s.contacts), Contains("0 entries; 2 are needed"));
    s.contacts.front().second = 7;
    CHECK_THROWS_AS(boxes.find(s.world, s.moving, s.contacts), std::invalid_argument);
    s.contacts.front().second = -1;
    CHECK_THROWS_AS(boxes.find(s.world, s.moving, s.contacts), std::invalid_argument);
  }
}
