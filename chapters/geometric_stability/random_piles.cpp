/// \file
/// \brief Random piles of boxes.
#include "geometric_stability/random_piles.hpp"

#include "geometric_stability/pile_builder.hpp"

#include <initializer_list>

namespace tumble::chapters {
namespace {

// Adds two fixed blocks with faces at right angles, and a box between that lies on both: it rests,
// and none of its contacts is vertical.
void add_trough(Random& random, PileBuilder& builder) {
  const double lean = random.uniform(0.4, 1.1);
  const double width = random.uniform(0.6, 1.2);
  const double height = random.uniform(0.6, 1.2);
  const Quat turned = rotation_from_vector(Vec3(0.0, 0.0, lean));
  const Vec3 lowest_w(6.0, 2.0, 0.0);
  const auto add = [&](const BodyProperties& body, const Vec3& centre) {
    builder.add(body, make_state(body, lowest_w + turned * centre, turned));
  };
  add(fixed_box_properties(Vec3(2.0, 0.5, 2.0)), Vec3(1.0, -0.25, 0.0));
  add(fixed_box_properties(Vec3(0.5, 2.0, 2.0)), Vec3(-0.25, 1.0, 0.0));
  add(box_properties(Vec3(width, height, 1.0), 1.0), Vec3(0.5 * width, 0.5 * height, 0.0));
}

// Adds a plank with its foot before a kerb that leans on the edge of a block. In two of three cases the
// block has a kerb behind it, and all rest; else the plank pushes it away.
void add_leaning_plank(Random& random, PileBuilder& builder) {
  const double lean = random.uniform(0.5, 0.9);
  const double tall = random.uniform(0.6, 0.9);
  const bool held = random.below(3) != 0;
  const Quat turned = rotation_from_vector(Vec3(0.0, 0.0, lean));
  const auto [s, c] = elementary::sincos(lean);
  constexpr double thick = 0.25;
  const Vec3 foot_w(-7.0, 0.0, 0.0);               // the edge that stands on the ground
  const double leftmost = foot_w.x() - thick * s;  // touches the kerb
  const double edge = foot_w.x() + tall * c / s;   // here its underside is as high as the block
  const auto add = [&](const BodyProperties& body, const Vec3& centre_w, const Quat& q) {
    builder.add(body, make_state(body, centre_w, q));
  };
  const BodyProperties kerb = fixed_box_properties(Vec3(1.0, 0.5, 2.0));
  add(kerb, Vec3(leftmost - 0.5, 0.25, 0.0), Quat::Identity());
  add(box_properties(Vec3(1.0, tall, 1.0), 1.0), Vec3(edge + 0.5, 0.5 * tall, 0.0),
      Quat::Identity());
  if (held) add(kerb, Vec3(edge + 1.5, 0.25, 0.0), Quat::Identity());
  add(box_properties(Vec3(2.0, thick, 0.75), 1.0), foot_w + turned * Vec3(1.0, 0.5 * thick, 0.0),
      turned);
}

Quat about_y(double angle) { return rotation_from_vector(Vec3(0.0, angle, 0.0)); }

// An upright box of the pile, as a place for others.
struct Place {
  Vec3 centre_w;
  Vec3 size;
  Quat turn;

  [[nodiscard]] double top() const { return centre_w.y() + 0.5 * size.y(); }
  // A point of the top, in shares of its half edges.
  [[nodiscard]] Vec3 point(double x, double z) const {
    return centre_w + turn * Vec3(0.5 * x * size.x(), 0.0, 0.5 * z * size.z());
  }
};

// Adds one thing after the other to a pile. What the builder refuses is left out.
class Pile {
 public:
  Pile(std::uint64_t seed, const PileRecipe& recipe) : random_(seed), recipe_(recipe) {}

  World build() {
    for (int k = 0; k < 5; ++k) on_ground();
    while (added_ < recipe_.boxes) {
      ++added_;
      if (random_.unit() < recipe_.tilted) {
        tilted();
        continue;
      }
      switch (random_.below(8)) {
        case 0: on_ground(); break;
        case 1: beside(); break;
        case 2: over_edge(); break;
        case 3: across(); break;
        case 4: table(); break;
        default: within(); break;
      }
    }
    if (recipe_.scaffolds && random_.below(4) == 0) add_trough(random_, builder_);
    if (recipe_.scaffolds && random_.below(4) == 0) add_leaning_plank(random_, builder_);
    return builder_.world();
  }

 private:
  double pick(std::initializer_list<double> values) {
    return values.begin()[random_.below(static_cast<std::uint32_t>(values.size()))];
  }
  double height() { return pick({0.5, 0.5, 1.0}); }
  // On the ground, at multiples of a quarter.
  Vec3 ground_place(double half) {
    const auto steps = static_cast<std::uint32_t>(8.0 * half) + 1;
    const double x = 0.25 * random_.below(steps) - half;
    const double z = 0.25 * random_.below(steps) - half;
    return {x, 0.0, z};
  }
  Vec3 any_size(std::initializer_list<double> widths) {
    const double x = pick(widths);
    const double y = height();
    const double z = pick(widths);
    return {x, y, z};
  }
  // Half of all boxes are straight, the others turned by anything.
  Quat turn() {
    const bool straight = random_.below(2) == 0;
    const double angle = random_.uniform(0.0, 0.5 * std::numbers::pi);
    return straight ? Quat::Identity() : about_y(angle);
  }
  BodyProperties body(const Vec3& size) {
    const double mass = elementary::exp(random_.uniform(-1.6, 1.6));  // [kg] 0.2 to 5
    return random_.below(12) == 0 ? fixed_box_properties(size) : box_properties(size, mass);
  }
  bool put(const Vec3& place_w, const Vec3& size, const Quat& turn) {
    const BodyProperties properties = body(size);
    return builder_.lower(properties, make_state(properties, place_w, turn));
  }

  // An upright box that is there; straight ones too if asked for.
  std::optional<Place> any_place() {
    const World& world = builder_.world();
    std::vector<int> upright;
    for (int k = 1; k < world.count(); ++k)
      if (is_upright(k)) upright.push_back(k);
    if (upright.empty()) return std::nullopt;
    return place(upright[random_.below(static_cast<std::uint32_t>(upright.size()))]);
  }
  [[nodiscard]] bool is_upright(int k) const {
    const Quat& q = builder_.world().states()[idx(k)].orientation_wb;
    return q.x() == 0.0 && q.z() == 0.0;
  }
  [[nodiscard]] Place place(int k) const {
    const BodyState& state = builder_.world().states()[idx(k)];
    return {state.position_w, builder_.world().bodies()[idx(k)].size, state.orientation_wb};
  }

  void on_ground() {
    const Vec3 size = any_size({0.5, 1.0, 1.5});
    const Vec3 place_w = ground_place(2.0);
    put(place_w, size, turn());
  }

  // Whole on another one.
  void within() {
    const std::optional<Place> under = any_place();
    if (!under) return;
    const double share = random_.uniform(0.4, 0.7);
    const Vec3 size(share * under->size.x(), height(), share * under->size.z());
    const double x = random_.uniform(-0.2, 0.2);
    const double z = random_.uniform(-0.2, 0.2);
    const double angle = random_.below(2) == 0 ? 0.0 : random_.uniform(-0.3, 0.3);
    put(under->point(x, z), size, under->turn * about_y(angle));
  }

  // With its centre anywhere over another one, or a little outside.
  void over_edge() {
    const std::optional<Place> under = any_place();
    if (!under) return;
    const Vec3 size = any_size({0.5, 1.0, 1.5});
    const double x = random_.uniform(-1.2, 1.2);
    const double z = random_.uniform(-1.2, 1.2);
    put(under->point(x, z), size, turn());
  }

  // Across two boxes of equal height, with corners on them or beyond them.
  void across() {
    const World& world = builder_.world();
    std::vector<std::array<int, 2>> pairs;
    for (int a = 1; a < world.count(); ++a)
      for (int b = 1; b < a; ++b)
        if (is_upright(a) && is_upright(b) && std::abs(place(a).top() - place(b).top()) < 1e-9)
          pairs.push_back({a, b});
    if (pairs.empty()) return;
    const auto [a, b] = pairs[random_.below(static_cast<std::uint32_t>(pairs.size()))];
    const Vec3 way_w = place(b).centre_w - place(a).centre_w;
    const double length = Vec2(way_w.x(), way_w.z()).norm();
    const double widest =
        std::min({place(a).size.x(), place(a).size.z(), place(b).size.x(), place(b).size.z()});
    const double beyond = random_.uniform(-0.5, 0.7) * widest;
    const double width = random_.uniform(0.3, 0.8) * widest;
    const Vec3 middle_w = 0.5 * (place(a).centre_w + place(b).centre_w);
    if (length + beyond < width || length > 3.0) return;
    put(middle_w, Vec3(length + beyond, pick({0.25, 0.5}), width),
        about_y(elementary::atan2(-way_w.z(), way_w.x())));
  }

  // Face to face with another one, if it comes down as far.
  void beside() {
    const std::optional<Place> other = any_place();
    if (!other) return;
    const double width = pick({0.5, 1.0});
    const double sign = random_.below(2) == 0 ? 1.0 : -1.0;
    const double along = random_.uniform(-0.4, 0.4);
    const Vec3 step(sign * 0.5 * (other->size.x() + width), 0.0, along);
    put(other->centre_w + other->turn * step, Vec3(width, height(), width), other->turn);
  }

  // A table where it finds a place.
  void table() {
    for (int attempt = 0; attempt < 6; ++attempt) {
      const PileBuilder before = builder_;
      if (slab_on_pillars()) return;
      builder_ = before;
    }
  }

  // Four pillars of one height, one of which may be missing, and a slab with its corners on them.
  bool slab_on_pillars() {
    const double tall = pick({0.5, 1.0});
    const double half_x = random_.uniform(0.6, 1.0);
    const double half_z = random_.uniform(0.6, 1.0);
    const Vec3 middle_w = ground_place(3.0);
    const Quat turned = turn();
    if (random_.below(2) == 0) under_slab(middle_w, tall);
    const std::uint32_t missing = random_.below(12);
    for (std::uint32_t k = 0; k < 4; ++k) {
      const Vec3 arm((k & 1U) != 0 ? half_x : -half_x, 0.0, (k & 2U) != 0 ? half_z : -half_z);
      if (k != missing && !put(middle_w + turned * arm, Vec3(0.4, tall, 0.4), turned)) return false;
    }
    const double thick = 0.25;
    if (!put(middle_w, Vec3(2.0 * half_x + 0.2, thick, 2.0 * half_z + 0.2), turned)) return false;
    return std::abs(builder_.world().states().back().position_w.y() - tall - 0.5 * thick) < 1e-9;
  }

  // Something as high as the pillars: a box, or one on a narrower one; perhaps with a neighbour.
  void under_slab(const Vec3& middle_w, double tall) {
    const Quat turned = turn();
    const double width = random_.uniform(0.3, 0.7);
    const double depth = random_.uniform(0.3, 0.7);
    const double share = random_.uniform(0.3, 1.1);
    const double shift = random_.uniform(-0.3, 0.3);
    if (random_.below(2) == 0) {
      put(middle_w, Vec3(width, tall, depth), turned);
    } else {
      put(middle_w + turned * Vec3(shift * width, 0.0, 0.0),
          Vec3(share * width, 0.5 * tall, share * depth), turned);
      put(middle_w, Vec3(width, 0.5 * tall, depth), turned);
    }
    if (random_.below(3) != 0) return;
    const double beside = random_.uniform(0.2, 0.4);
    put(middle_w + turned * Vec3(0.5 * (width + beside), 0.0, shift * depth),
        Vec3(beside, tall, beside), turned);
  }

  // In any orientation, or about one level axis, so that it comes to lie on an edge.
  void tilted() {
    const std::optional<Place> under = any_place();
    if (!under) return;
    const Vec3 size = any_size({0.5, 1.0});
    const double x = random_.uniform(-0.8, 0.8);
    const double z = random_.uniform(-0.8, 0.8);
    const double lean = random_.uniform(0.1, 0.7);
    const Quat about_level = turn() * rotation_from_vector(Vec3(0.0, 0.0, lean));
    const Quat any = random_.orientation();
    put(under->point(x, z), size, random_.below(2) == 0 ? any : about_level);
  }

  Random random_;
  PileRecipe recipe_;
  PileBuilder builder_;
  int added_ = 0;
};

}  // namespace

World random_pile(std::uint64_t seed, const PileRecipe& recipe) {
  return Pile(seed, recipe).build();
}

}  // namespace tumble::chapters
