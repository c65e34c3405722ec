/// \file
/// \brief Time and quality of box against box, beside the routines of installed engines.
///
/// Prints, for random pairs (about half of them overlap) and for pairs that rest face to face, the
/// time per pair of the separating axis test and of the full contact manifold, and for each
/// routine what it returns for that time. All routines run in one process on the same pairs, in
/// turn, and the median of the rounds counts.
///
/// Run `narrow_phase [pairs] [rounds]`. Peers are those found at build time: ODE
/// (`TUMBLE_HAVE_ODE`) and Bullet (`TUMBLE_HAVE_BULLET`, in the precision it was built with).
#include "tumble/base/random.hpp"
#include "tumble/geometry/manifold.hpp"

#include "narrow_phase_peers.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

namespace {

using narrow_phase::Answer;
using narrow_phase::over_all;
using narrow_phase::Pair;
using narrow_phase::peers;
using narrow_phase::Routine;
using tumble::make_box;
using tumble::Quat;
using tumble::Random;
using tumble::Vec3;

Quat small_turn(Random& random, double angle) {
  const Vec3 axis = random.direction();
  return Quat(1.0, 0.5 * angle * axis.x(), 0.5 * angle * axis.y(), 0.5 * angle * axis.z())
      .normalized();
}

Vec3 random_size(Random& random) {
  const double x = random.uniform(0.5, 2.0);
  const double y = random.uniform(0.5, 2.0);
  const double z = random.uniform(0.5, 2.0);
  return {x, y, z};
}

// Any orientation; distances such that about half of the pairs overlap.
std::vector<Pair> random_pairs(std::size_t count, Random random) {
  std::vector<Pair> out;
  out.reserve(count);
  while (out.size() < count) {
    const Quat q_first = random.orientation();
    const Quat q_second = random.orientation();
    const Vec3 size_first = random_size(random);
    const Vec3 size_second = random_size(random);
    const Vec3 center = random.in_cube(5.0);
    const double apart = random.uniform(0.5, 2.7);
    const Vec3 offset = apart * random.direction();
    out.push_back(
        {make_box(center, q_first, size_first), make_box(center + offset, q_second, size_second)});
  }
  return out;
}

// The second box lies on a face of the first, up to 10 mm deep, turned about the normal by any
// angle and tilted by up to 0.005 rad; the whole pair is turned anyhow.
std::vector<Pair> face_pairs(std::size_t count, Random random) {
  std::vector<Pair> out;
  out.reserve(count);
  while (out.size() < count) {
    const Quat whole = random.orientation();
    const Vec3 size_first = random_size(random);
    const Vec3 size_second = random_size(random);
    const Vec3 center = random.in_cube(5.0);
    const Vec3 aside = random.in_cube(0.5);
    const double depth = random.uniform(0.002, 0.010);
    const double half_angle_tangent = random.uniform(-1.0, 1.0);
    const Quat yaw = Quat(1.0, 0.0, half_angle_tangent, 0.0).normalized();
    const double tilt = random.uniform(0.0, 0.005);
    const Quat tilted = small_turn(random, tilt);
    const Vec3 offset(aside.x(), 0.5 * (size_first.y() + size_second.y()) - depth, aside.z());
    out.push_back(
        {make_box(center, whole, size_first),
         make_box(center + whole * offset, (whole * tilted * yaw).normalized(), size_second)});
  }
  return out;
}

Answer answer_of(const tumble::Manifold& manifold) {
  Answer out;
  out.points = manifold.count;
  for (int i = 0; i < manifold.count; ++i)
    out.depth = std::max(out.depth, -manifold.points[static_cast<std::size_t>(i)].distance);
  return out;
}

void add_ours(const std::vector<Pair>& pairs, std::vector<Routine>& out) {
  Routine test;
  test.name = "tumble separation";
  test.run = over_all(pairs.size(), [&pairs](std::size_t k) {
    return separation(pairs[k].first, pairs[k].second).distance;
  });
  test.ask = [&pairs](std::size_t k) {
    const double distance = separation(pairs[k].first, pairs[k].second).distance;
    return Answer{distance <= 0.0 ? 1 : 0, -distance};
  };
  out.push_back(test);

  Routine full;
  full.name = "tumble collide";
  full.run = over_all(pairs.size(), [&pairs, manifold = tumble::Manifold()](std::size_t k) mutable {
    collide(pairs[k].first, pairs[k].second, 0.0, tumble::kNoAxis, manifold);
    return manifold.points[0].distance;
  });
  full.ask = [&pairs](std::size_t k) {
    tumble::Manifold manifold;
    collide(pairs[k].first, pairs[k].second, 0.0, tumble::kNoAxis, manifold);
    return answer_of(manifold);
  };
  out.push_back(full);
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

// Depths against the exact smallest overlap, over the pairs that the routine reports as touching.
void print_row(const Routine& routine, const std::vector<Pair>& pairs) {
  tumble::SeparationOptions exact{.prefer_faces = false,
                                  .enough = std::numeric_limits<double>::infinity()};
  double hits = 0.0, points = 0.0, sum = 0.0, worst = 0.0;
  int wrong = 0;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const Answer answer = routine.ask(k);
    const double distance = separation(pairs[k].first, pairs[k].second, exact).distance;
    if ((answer.points > 0) != (distance <= 0.0)) ++wrong;
    if (answer.points == 0) continue;
    hits += 1.0;
    points += answer.points;
    sum += std::abs(answer.depth + distance);
    worst = std::max(worst, std::abs(answer.depth + distance));
  }
  const auto [least, most] = std::minmax_element(routine.ns.begin(), routine.ns.end());
  std::printf("  %-24s %7.1f  %7.1f..%-7.1f %8.0f %8.2f %9.4f %9.4f %7d\n", routine.name.c_str(),
              median(routine.ns), *least, *most, hits, points / hits, 1e3 * sum / hits, 1e3 * worst,
              wrong);
}

void compare(const char* title, const std::vector<Pair>& pairs, int rounds) {
  std::vector<Routine> routines;
  add_ours(pairs, routines);
  for (const Routine& peer : peers(pairs)) routines.push_back(peer);

  double sink = 0.0;
  for (int round = -1; round < rounds; ++round) {  // round -1 warms up
    for (Routine& routine : routines) {
      const auto start = std::chrono::steady_clock::now();
      sink += routine.run();
      const std::chrono::duration<double, std::nano> took =
          std::chrono::steady_clock::now() - start;
      if (round >= 0) routine.ns.push_back(took.count() / static_cast<double>(pairs.size()));
    }
  }

  std::printf("\n%s (%zu pairs, median of %d rounds)\n", title, pairs.size(), rounds);
  std::printf("  %-24s %7s  %16s %8s %8s %9s %9s %7s\n", "routine", "ns/pair", "least..most",
              "hits", "pts/hit", "mean mm", "worst mm", "wrong");
  for (const Routine& routine : routines) print_row(routine, pairs);
  if (routines.size() > 2) {
    double peer = std::numeric_limits<double>::infinity();
    for (std::size_t i = 2; i < routines.size(); ++i) peer = std::min(peer, median(routines[i].ns));
    std::printf("  ratio tumble collide / faster peer: %.2f\n", median(routines[1].ns) / peer);
  }
  if (!std::isfinite(sink)) std::printf("  (a result is not finite)\n");
}

// A whole number on the command line, at least `least`.
bool read_count(const char* text, long least, long& out) {
  char* end = nullptr;
  out = std::strtol(text, &end, 10);
  if (end != text && *end == '\0' && out >= least) return true;
  std::fprintf(stderr, "narrow_phase: \"%s\": expected a whole number, at least %ld\n", text,
               least);
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  long count = 100000;
  long rounds = 9;
  if (argc > 1 && !read_count(argv[1], 1, count)) return 2;
  if (argc > 2 && !read_count(argv[2], 1, rounds)) return 2;

  std::printf(
      "Box against box. mean/worst mm: how far the depth is from the smallest overlap;\n"
      "wrong: pairs on which touching or not differs from the exact test.\n"
      "tumble separation finds no points; tumble collide returns all corners of the contact\n"
      "area, up to 8; ODE and Bullet prefer faces by 5 %% and return up to 8 and 4 points.\n");
  const Random random(20030501);
  const auto n = static_cast<std::size_t>(count);
  compare("random pairs", random_pairs(n, random.fork(1)), static_cast<int>(rounds));
  compare("face pairs", face_pairs(n, random.fork(2)), static_cast<int>(rounds));
  return 0;
}
