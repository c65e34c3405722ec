/// \file
/// \brief Broad phases, one answer.
#include "tumble/geometry/broad_phase.hpp"

#include "support/test.hpp"

namespace {

using Methods = std::vector<std::unique_ptr<BroadPhase>>;

Methods all_methods() {
  Methods out;
  for (const std::string_view name : broad_phase_names()) out.push_back(make_broad_phase(name));
  return out;
}

// The judge: the definition, written down once more and apart from the library's all_pairs.
std::vector<IndexPair> pairs_by_definition(const std::vector<Bounds>& bounds) {
  std::vector<IndexPair> out;
  for (std::size_t a = 0; a < bounds.size(); ++a) {
    for (std::size_t b = a + 1; b < bounds.size(); ++b) {
      bool touch = true;
      for (int k = 0; k < 3; ++k)
        touch = touch && !(bounds[a].high[k] < bounds[b].low[k]) &&
                !(bounds[b].high[k] < bounds[a].low[k]);
      if (touch) out.push_back({static_cast<int>(a), static_cast<int>(b)});
    }
  }
  return out;
}

// How many of the methods give another list than the judge.
int disagreements(Methods& methods, const std::vector<Bounds>& bounds,
                  std::size_t* found = nullptr) {
  const std::vector<IndexPair> right = pairs_by_definition(bounds);
  if (found != nullptr) *found += right.size();
  std::vector<IndexPair> pairs = {{7, 8}};  // left over from an earlier call
  int wrong = 0;
  for (const auto& method : methods) {
    method->find_pairs(bounds, pairs);
    if (pairs != right) ++wrong;
  }
  return wrong;
}

// The kinds of scene that the methods have to cope with.
enum class Kind { even, mixed, clustered, flat, line, infinite, lattice, points, far_out };
constexpr Kind kKinds[] = {Kind::even,     Kind::mixed,   Kind::clustered, Kind::flat,   Kind::line,
                           Kind::infinite, Kind::lattice, Kind::points,    Kind::far_out};

Bounds around(const Vec3& center, const Vec3& half) { return {center - half, center + half}; }

Bounds ground() { return {Vec3::Constant(-kInfinity), Vec3(kInfinity, 0.0, kInfinity)}; }

Bounds random_bounds(Kind kind, int n, Random& random) {
  const double spread = 0.6 * elementary::exp(elementary::log(n + 1.0) / 3.0);
  const Vec3 center = random.in_cube(spread);
  const Vec3 half = random.in_cube(0.4).cwiseAbs() + Vec3::Constant(0.1);
  switch (kind) {
    case Kind::even: return around(center, half);
    case Kind::mixed:  // sizes from 1e-3 to 1e3
      return around(20.0 * center, half * elementary::exp(random.uniform(-6.9, 6.9)));
    case Kind::clustered:
      return around(0.1 * center + (random.unit() < 0.5 ? 0.0 : 50.0) * Vec3::UnitY(), half);
    case Kind::flat: return around(center.cwiseProduct(Vec3(3.0, 0.01, 3.0)), half);
    case Kind::line: return around(center.cwiseProduct(Vec3(0.01, 0.01, 30.0)), half);
    case Kind::infinite: {
      if (random.unit() < 0.9) return around(center, half);
      Bounds out = around(center, half);
      const int k = static_cast<int>(random.below(3));
      if (random.unit() < 0.7) out.low[k] = -kInfinity;
      if (random.unit() < 0.7) out.high[k] = kInfinity;
      return random.unit() < 0.2 ? ground() : out;
    }
    case Kind::lattice: {  // faces touch exactly, many bounds coincide
      const Vec3 corner = (2.0 * center).array().round();
      return {corner, corner + Vec3::Ones()};
    }
    case Kind::points: return around(center.array().round(), Vec3::Zero());
    case Kind::far_out: {
      const double far = random.unit() < 0.1 ? 1e300 : 1.0;
      return around(far * center, random.unit() < 0.1 ? Vec3(1e12 * half) : half);
    }
  }
  return {};
}

std::vector<Bounds> random_scene(Kind kind, int n, Random& random) {
  std::vector<Bounds> out;
  for (int k = 0; k < n; ++k) out.push_back(random_bounds(kind, n, random));
  return out;
}

}  // namespace

TEST_CASE("Six broad phases can be made by name, and no seventh", "[unit][broad_phase]") {
  REQUIRE(broad_phase_names().size() == 6);
  for (const std::string_view name : broad_phase_names()) {
    CHECK(make_broad_phase(name)->name() == name);
    CHECK(make_broad_phase(name)->clone()->name() == name);
  }
  CHECK_THROWS_WITH(make_broad_phase("quadtree"),
                    Contains("quadtree") && Contains("bounding_tree"));
  CHECK_THROWS_AS(make_broad_phase(""), std::invalid_argument);
}

TEST_CASE("Broad phases find nothing among no bodies and among one", "[unit][broad_phase]") {
  for (const auto& method : all_methods()) {
    std::vector<IndexPair> pairs = {{0, 1}};
    method->find_pairs({}, pairs);
    CHECK(pairs.empty());
    CHECK(method->pair_tests() == 0);
    for (const Bounds& one : {ground(), around(Vec3::Zero(), Vec3::Ones())}) {
      pairs = {{0, 1}};
      method->find_pairs(std::span(&one, 1), pairs);
      CHECK(pairs.empty());
      CHECK(method->pair_tests() == 0);
    }
  }
}

TEST_CASE("All broad phases agree on thousands of random scenes", "[unit][broad_phase]") {
  Random random(41);
  for (const Kind kind : kKinds) {
    // The same objects see one scene after the other: what they remember is always of another one.
    Methods methods = all_methods();
    int wrong = 0;
    std::size_t found = 0;
    for (int trial = 0; trial < 400; ++trial) {
      const int n = static_cast<int>(random.below(trial % 20 == 0 ? 300 : 60));
      wrong += disagreements(methods, random_scene(kind, n, random), &found);
    }
    CAPTURE(static_cast<int>(kind));
    CHECK(wrong == 0);
    CHECK(found > 1000);
  }
}

TEST_CASE("All broad phases agree while bodies move, appear and vanish", "[unit][broad_phase]") {
  Random random(42);
  for (const Kind kind : kKinds) {
    Methods methods = all_methods();
    std::vector<Bounds> bounds = random_scene(kind, 150, random);
    std::vector<Vec3> velocities;
    for (std::size_t k = 0; k < bounds.size(); ++k) velocities.push_back(random.in_cube(0.1));
    int wrong = 0;
    std::size_t found = 0;
    for (int step = 0; step < 200; ++step) {
      for (std::size_t k = 0; k < bounds.size(); ++k) {
        bounds[k].low += velocities[k];
        bounds[k].high += velocities[k];
        // Turning boxes grow and shrink a little.
        if (step % 7 == 0) bounds[k].high += Vec3::Constant(1e-3 * random.unit());
        if (random.unit() < 0.05) velocities[k] = -velocities[k];
      }
      if (step % 10 == 3) {  // one goes, and all later ones move down
        const auto gone =
            static_cast<std::ptrdiff_t>(random.below(static_cast<std::uint32_t>(bounds.size())));
        bounds.erase(bounds.begin() + gone);
        velocities.erase(velocities.begin() + gone);
      }
      if (step % 10 == 6) {
        bounds.push_back(random_bounds(kind, 150, random));
        velocities.push_back(random.in_cube(0.1));
      }
      if (step % 50 == 40) std::swap(bounds.front(), bounds.back());  // a jump
      wrong += disagreements(methods, bounds, &found);
      if (step == 100) {
        for (auto& method : methods) method = method->clone();
      }
      if (step == 150) methods = all_methods();  // forget everything
    }
    CAPTURE(static_cast<int>(kind));
    CHECK(wrong == 0);
    CHECK(found > (kind == Kind::points ? 0U : 1000U));  // moving points hardly ever meet
  }
}

TEST_CASE("Broad phases of scattered boxes need few tests per body", "[unit][broad_phase]") {
  // 4000 boxes, about one neighbour each: trying all pairs needs 2000 tests per body.
  Random random(44);
  const std::vector<Bounds> bounds = random_scene(Kind::even, 4000, random);
  for (const auto& method : all_methods()) {
    if (method->name() == "all_pairs") continue;
    std::vector<IndexPair> pairs;
    method->find_pairs(bounds, pairs);
    CAPTURE(method->name());
    const double per_body = static_cast<double>(method->pair_tests()) / 4000.0;
    // [-] measured 1.1 (sweep_and_prune), 5.8 (hashed_grid), 10.7 (octree), 12.9 (bounding_tree), 22.4 (kd_tree)
    CHECK(per_body < 25.0);
  }
}

TEST_CASE("Bounds with a NaN, upside down or at infinity are refused", "[unit][broad_phase]") {
  const Bounds good = around(Vec3::Zero(), Vec3::Ones());
  std::vector<IndexPair> pairs;
  for (const auto& method : all_methods()) {
    for (int k = 0; k < 3; ++k) {
      Bounds nan_low = good, nan_high = good, upside_down = good, beyond = good, before = good;
      nan_low.low[k] = kNan;
      nan_high.high[k] = kNan;
      upside_down.low[k] = 2.0;
      beyond.low[k] = beyond.high[k] = kInfinity;
      before.low[k] = before.high[k] = -kInfinity;
      for (const Bounds& bad : {nan_low, nan_high, upside_down, beyond, before}) {
        const std::vector<Bounds> bounds = {good, good, bad};
        CHECK_THROWS_AS(method->find_pairs(bounds, pairs), std::invalid_argument);
        CHECK_THROWS_WITH(method->find_pairs(bounds, pairs), Contains("bounds[2]"));
      }
    }
    // It goes on working afterwards.
    method->find_pairs(std::vector<Bounds>{good, good}, pairs);
    CHECK(pairs == std::vector<IndexPair>{{0, 1}});
  }
}
