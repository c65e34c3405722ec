/// \file
/// \brief The painter's order against rays from the eye, and the ring that has none.
#include "tumble/pictures/painters_order.hpp"

#include "geometry/boxes.hpp"
#include "support/test.hpp"

namespace {

// Where a ray enters a box; infinite if it misses.
double enters_at(const Box& box, const Vec3& origin, const Vec3& direction) {
  const Stretch stretch = stretch_in(box, origin, direction);
  return stretch.enter <= stretch.leave && stretch.leave > 0.0 ? stretch.enter : kInfinity;
}

// Boxes of all shapes in a cube, added as long as they do not overlap those that are there.
std::vector<Box> disjoint_boxes(Random& random, int tries, double spread) {
  std::vector<Box> boxes;
  for (int k = 0; k < tries; ++k) {
    const Box box = random_box(random, spread, 1.5, 0.1);
    const bool disjoint = std::ranges::all_of(
        boxes, [&](const Box& other) { return separation(box, other).distance > 0.0; });
    if (disjoint) boxes.push_back(box);
  }
  return boxes;
}

std::vector<int> flat(const PaintersOrder& result) {
  std::vector<int> boxes;
  for (const std::vector<int>& group : result)
    boxes.insert(boxes.end(), group.begin(), group.end());
  return boxes;
}

// How many boxes are in groups of several.
std::size_t grouped(const PaintersOrder& result) {
  std::size_t count = 0;
  for (const std::vector<int>& group : result) count += group.size() > 1 ? group.size() : 0;
  return count;
}

std::vector<int> places_in(const PaintersOrder& result) {
  const std::vector<int> boxes = flat(result);
  std::vector<int> places(boxes.size(), -1);
  for (std::size_t k = 0; k < boxes.size(); ++k)
    places[static_cast<std::size_t>(boxes[k])] = static_cast<int>(k);
  return places;
}

bool is_permutation(const PaintersOrder& result, std::size_t count) {
  std::vector<int> sorted = flat(result);
  std::ranges::sort(sorted);
  for (std::size_t k = 0; k < sorted.size(); ++k)
    if (sorted[k] != static_cast<int>(k)) return false;
  return sorted.size() == count;
}

// What many rays say about orders.
struct Judgement {
  int pairs = 0;           // times a ray met two boxes
  int violations = 0;      // times the one met first was painted first
  std::size_t cyclic = 0;  // boxes in groups of several
};

void judge(const std::vector<Box>& boxes, const std::vector<int>& places, const Vec3& origin,
           const Vec3& direction, Judgement& out) {
  std::vector<std::pair<double, int>> hits;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const double t = enters_at(boxes[k], origin, direction);
    if (t < kInfinity) hits.emplace_back(t, places[k]);
  }
  for (const auto& near : hits) {
    for (const auto& far : hits) {
      if (near.first >= far.first) continue;
      ++out.pairs;
      if (near.second < far.second) ++out.violations;
    }
  }
}

// Sends rays to points near the origin, each from where `origin_of` says.
template <class Origin>
void judge_rays(const std::vector<Box>& boxes, const PaintersOrder& order, Random& random,
                const Origin& origin_of, Judgement& out) {
  out.cyclic += grouped(order);
  if (grouped(order) > 0) return;
  const std::vector<int> places = places_in(order);
  for (int ray = 0; ray < 3000; ++ray) {
    const Vec3 target = random.in_cube(2.5);
    const Vec3 origin = origin_of(target);
    judge(boxes, places, origin, target - origin, out);
  }
}

}  // namespace

TEST_CASE("Every ray from the eye meets a box that was painted later before one painted earlier",
          "[unit][painters_order]") {
  Random random(31);
  Judgement judgement;
  int broken = 0;
  std::size_t most = 0;
  for (int scene = 0; scene < 60; ++scene) {
    const std::vector<Box> boxes = disjoint_boxes(random, 80, 2.5);
    most = std::max(most, boxes.size());
    // Some eyes are far away, some stand among the boxes.
    const Vec3 eye = (scene % 3 == 0 ? 1.0 : 6.0) * random.in_cube(2.0);
    const PaintersOrder got = painters_order(boxes, eye);
    if (!is_permutation(got, boxes.size())) ++broken;
    judge_rays(
        boxes, got, random, [&](const Vec3&) { return eye; }, judgement);
  }
  CHECK(most > 30);
  CHECK(broken == 0);
  CHECK(judgement.cyclic == 0);
  CHECK(judgement.pairs > 50000);  // measured 74 000
  CHECK(judgement.violations == 0);
}

TEST_CASE("Every parallel ray meets a box that was painted later before one painted earlier",
          "[unit][painters_order]") {
  Random random(32);
  Judgement judgement;
  for (int scene = 0; scene < 40; ++scene) {
    const std::vector<Box> boxes = disjoint_boxes(random, 80, 2.5);
    const Vec3 direction = random.direction();
    const PaintersOrder got = painters_order(boxes, ViewPoint::along(3.0 * direction));
    const auto before = [&](const Vec3& target) { return Vec3(target - 20.0 * direction); };
    judge_rays(boxes, got, random, before, judgement);
  }
  CHECK(judgement.cyclic == 0);
  CHECK(judgement.pairs > 50000);  // measured 60 000
  CHECK(judgement.violations == 0);
}

TEST_CASE("A pyramid of touching bricks is painted without a cycle and without a violation",
          "[unit][painters_order]") {
  std::vector<Box> bricks;
  for (int level = 0; level < 5; ++level) {
    for (int x = 0; x < 5 - level; ++x) {
      for (int z = 0; z < 5 - level; ++z)
        bricks.push_back(
            upright(Vec3(x + 0.5 * level, level + 0.5, z + 0.5 * level), Vec3::Ones()));
    }
  }
  REQUIRE(bricks.size() == 55);
  Random random(33);
  Judgement judgement;
  const Vec3 eye(12.3, 7.1, 15.7);
  const PaintersOrder got = painters_order(bricks, eye);
  const std::vector<int> places = places_in(got);
  for (int ray = 0; ray < 20000; ++ray) {
    const Vec3 target = Vec3(2.0, 2.0, 2.0) + random.in_cube(3.0);
    judge(bricks, places, eye, target - eye, judgement);
  }
  CHECK(grouped(got) == 0);
  CHECK(judgement.pairs > 50000);  // measured 122 000
  CHECK(judgement.violations == 0);
}

TEST_CASE("Views overlap exactly if some ray meets both boxes", "[unit][painters_order]") {
  Random random(34);
  int seen_but_denied = 0, denied = 0, claimed = 0, confirmed = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const std::vector<Box> boxes = disjoint_boxes(random, 2, 1.5);
    if (boxes.size() < 2) continue;
    const Vec3 eye = 5.0 * random.direction();
    const bool claim = views_overlap(boxes[0], boxes[1], ViewPoint::from_eye(eye));
    if (claim != views_overlap(boxes[1], boxes[0], ViewPoint::from_eye(eye))) ++seen_but_denied;
    bool seen = false;
    for (int ray = 0; ray < 5000 && !seen; ++ray) {
      // Rays to points of the first box.
      Vec3 inside = random.in_cube(1.0).cwiseProduct(boxes[0].half);
      const Vec3 direction = boxes[0].center_w + boxes[0].axes_w * inside - eye;
      seen = enters_at(boxes[1], eye, direction) < kInfinity;
    }
    ++(claim ? claimed : denied);
    if (claim && seen) ++confirmed;
    if (!claim && seen) ++seen_but_denied;
  }
  CHECK(seen_but_denied == 0);
  CHECK(denied > 50);
  CHECK(claimed > 50);
  // A sliver of overlap may be missed by the rays.
  CHECK(claimed - confirmed <= 5);
}

TEST_CASE("A ring of three sticks that cover each other is one group", "[exact][painters_order]") {
  const std::vector<Box> ring = ring_of_sticks();
  for (std::size_t a = 0; a < 3; ++a)
    REQUIRE(separation(ring[a], ring[(a + 1) % 3]).distance > 0.0);
  const PaintersOrder got = painters_order(ring, Vec3(0.0, 0.0, 20.0));
  CHECK(grouped(got) == 3);
  CHECK(is_permutation(got, 3));
  CHECK(grouped(painters_order(ring, ViewPoint::along(Vec3(0.0, 0.0, -1.0)))) == 3);
  // Seen from the side there is nothing wrong with it; nor if one stick is taken away.
  CHECK(grouped(painters_order(ring, Vec3(20.0, 0.3, 0.0))) == 0);
  CHECK(grouped(painters_order(std::span(ring).first(2), Vec3(0.0, 0.0, 20.0))) == 0);
}

TEST_CASE("Boxes that overlap slightly, coincide or hold the eye still get an order",
          "[unit][painters_order]") {
  const std::vector<Box> stack = {upright(Vec3(0.0, 0.5, 0.0), Vec3::Ones()),
                                  upright(Vec3(0.0, 1.499, 0.0), Vec3::Ones())};
  CHECK(flat(painters_order(stack, Vec3(1.0, 8.0, 2.0))) == std::vector<int>{0, 1});
  CHECK(flat(painters_order(stack, Vec3(1.0, -8.0, 2.0))) == std::vector<int>{1, 0});

  const std::vector<Box> same(4, stack[0]);
  CHECK(painters_order(same, Vec3(1.0, 8.0, 2.0)) == PaintersOrder{{0, 1, 2, 3}});
  CHECK(is_permutation(painters_order(stack, Vec3(0.0, 0.5, 0.0)), 2));  // in the centre of one
  CHECK(
      is_permutation(painters_order(stack, stack[0].center_w + stack[0].half), 2));  // in a corner

  CHECK(painters_order(std::span<const Box>(), Vec3::Zero()).empty());
  CHECK(flat(painters_order(std::span(stack).first(1), Vec3::Zero())) == std::vector<int>{0});
}

TEST_CASE("An eye or a direction that makes no sense is refused", "[unit][painters_order]") {
  CHECK_THROWS_WITH(ViewPoint::from_eye(Vec3(kNan, 0.0, 0.0)), Contains("eye_w"));
  CHECK_THROWS_WITH(ViewPoint::along(Vec3(kInfinity, 0.0, 0.0)), Contains("direction_w"));
  CHECK_THROWS_WITH(ViewPoint::along(Vec3::Zero()), Contains("direction_w"));
  CHECK_THROWS_AS(painters_order(std::span<const Box>(), Vec3(0.0, kNan, 0.0)),
                  std::invalid_argument);
}
