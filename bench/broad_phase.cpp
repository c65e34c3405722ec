/// \file
/// \brief Time and tests of the broad phases as scenes grow, beside Bullet's.
///
/// Boxes of 1 m, turned at random, drift at up to 1 m/s in a volume that grows with their number,
/// in steps of 1/60 s: once in a cube, once in a layer two boxes high. For every number of bodies all
/// methods see the same steps, in turn, and the median of the steps' processor times counts. The last column is the
/// exponent p of time ~ n^p between 1 000 bodies and the largest number: 1 is linear, 2 is all pairs.
///
/// Run `broad_phase [steps]`. Bullet's trees and its sweep and prune are measured if
/// `TUMBLE_HAVE_BULLET` was defined at build time; both report pairs of widened or rounded bounds, so
/// a few more, and hand over a set of pairs that is not sorted.
#include "tumble/geometry/broad_phase.hpp"

#include "tumble/base/random.hpp"

#ifdef TUMBLE_HAVE_BULLET
#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>

using namespace tumble;

namespace {

constexpr double kStep = 1.0 / 60.0;  // [s]

// Boxes that drift in a container and turn around at its walls.
class Drift {
 public:
  Drift(int count, bool flat) {
    // 4 m³ for each box in the cube, 4 m² in the layer.
    const double n = count;
    room_ = flat ? Vec3(std::sqrt(n), 1.0, std::sqrt(n)) : Vec3::Constant(0.5 * std::cbrt(4.0 * n));
    Random random(5);
    for (int k = 0; k < count; ++k) {
      const Vec3 center = random.in_cube(1.0).cwiseProduct(room_);
      const Quat orientation = random.orientation();
      boxes_.push_back(make_box(center, orientation, Vec3::Ones()));
      velocities_.push_back(random.in_cube(1.0));
    }
    bounds_.resize(boxes_.size());
    advance();
  }

  void advance() {
    for (std::size_t k = 0; k < boxes_.size(); ++k) {
      boxes_[k].center_w += kStep * velocities_[k];
      for (int i = 0; i < 3; ++i) {
        const bool outwards = boxes_[k].center_w[i] * velocities_[k][i] > 0.0;
        if (std::abs(boxes_[k].center_w[i]) > room_[i] && outwards) velocities_[k][i] *= -1.0;
      }
      bounds_[k] = bounds_of(boxes_[k]);
    }
  }

  [[nodiscard]] const std::vector<Bounds>& bounds() const { return bounds_; }

 private:
  Vec3 room_;
  std::vector<Box> boxes_;
  std::vector<Vec3> velocities_;
  std::vector<Bounds> bounds_;
};

// What one step of a method gave.
struct Found {
  std::int64_t pairs = 0;
  std::int64_t tests = -1;  // -1: not known
};

// A broad phase, ours or an engine's. Every number of bodies starts with a new one.
struct Contestant {
  std::string name;
  int most_bodies = 0;
  std::function<std::function<Found(const std::vector<Bounds>&)>()> start;
};

#ifdef TUMBLE_HAVE_BULLET
btVector3 to_bullet(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

// Bullet keeps its pairs and updates them; the dispatcher is only needed for what hangs on pairs.
std::function<Found(const std::vector<Bounds>&)> run_bullet(
    std::shared_ptr<btBroadphaseInterface> method) {
  return [method,
          proxies = std::vector<btBroadphaseProxy*>()](const std::vector<Bounds>& bounds) mutable {
    for (std::size_t k = 0; k < bounds.size(); ++k) {
      const btVector3 low = to_bullet(bounds[k].low), high = to_bullet(bounds[k].high);
      if (proxies.size() <= k) {
        proxies.push_back(method->createProxy(low, high, 0, nullptr, 1, 1, nullptr));
      } else {
        method->setAabb(proxies[k], low, high, nullptr);
      }
    }
    method->calculateOverlappingPairs(nullptr);
    return Found{method->getOverlappingPairCache()->getNumOverlappingPairs(), -1};
  };
}
#endif

std::vector<Contestant> contestants() {
  std::vector<Contestant> out;
  for (const std::string_view name : broad_phase_names()) {
    const std::string own_name(name);
    out.push_back({own_name, name == "all_pairs" ? 3000 : 10000, [own_name] {
                     std::shared_ptr<BroadPhase> method = make_broad_phase(own_name);
                     return [method, pairs = std::vector<IndexPair>()](
                                const std::vector<Bounds>& bounds) mutable {
                       method->find_pairs(bounds, pairs);
                       return Found{static_cast<std::int64_t>(pairs.size()), method->pair_tests()};
                     };
                   }});
  }
#ifdef TUMBLE_HAVE_BULLET
  out.push_back(
      {"Bullet Dbvt", 10000, [] { return run_bullet(std::make_shared<btDbvtBroadphase>()); }});
  out.push_back({"Bullet AxisSweep3", 10000, [] {
                   const btVector3 corner(200, 200, 200);
                   return run_bullet(std::make_shared<btAxisSweep3>(-corner, corner));
                 }});
#endif
  return out;
}

// [s] Of this program alone, in nanoseconds: other programs on the machine do not count.
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

void measure(bool flat, int steps) {
  const std::vector<Contestant> all = contestants();
  const std::vector<int> counts = {10, 30, 100, 300, 1000, 3000, 10000};
  std::vector<double> at_thousand(all.size(), 0.0);
  std::printf("%s\n%-18s %7s %9s %14s %12s %9s\n", flat ? "boxes in a layer" : "boxes in a cube",
              "method", "bodies", "pairs", "tests per body", "us per step", "exponent");
  for (const int n : counts) {
    Drift scene(n, flat);
    std::vector<std::function<Found(const std::vector<Bounds>&)>> runs;
    for (const Contestant& one : all) runs.push_back(one.start());
    std::vector<std::vector<double>> times(all.size());
    std::vector<Found> found(all.size());
    for (int step = 0; step < steps + 5; ++step) {
      scene.advance();
      for (std::size_t m = 0; m < all.size(); ++m) {
        if (n > all[m].most_bodies) continue;
        const double start = processor_time();
        found[m] = runs[m](scene.bounds());
        const double took = processor_time() - start;
        if (step >= 5) times[m].push_back(1e6 * took);  // the first steps build what is kept
      }
    }
    for (std::size_t m = 0; m < all.size(); ++m) {
      if (times[m].empty()) continue;
      const double time = median(times[m]);
      if (n == 1000) at_thousand[m] = time;
      std::printf("%-18s %7d %9lld ", all[m].name.c_str(), n,
                  static_cast<long long>(found[m].pairs));
      if (found[m].tests >= 0) {
        std::printf("%14.1f ", static_cast<double>(found[m].tests) / n);
      } else {
        std::printf("%14s ", "-");
      }
      std::printf("%12.1f", time);
      if (n > 1000 && n == all[m].most_bodies)
        std::printf(" %9.2f", std::log(time / at_thousand[m]) / std::log(n / 1000.0));
      std::printf("\n");
    }
  }
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  const int steps = argc > 1 ? std::atoi(argv[1]) : 60;
  if (steps < 1) {
    std::fprintf(stderr, "broad_phase: steps = %s: give at least 1\n", argv[1]);
    return 2;
  }
  measure(false, steps);
  measure(true, steps);
  return 0;
}
