/// \file
/// \brief The random numbers: published values, evenness, and streams that do not disturb each other.
#include "tumble/base/random.hpp"

#include "support/test.hpp"

namespace {

// Counts of draws in bins, as χ² with bins - 1 degrees of freedom, scaled to mean 0 and deviation 1.
template <std::size_t Bins>
double unevenness(const std::array<int, Bins>& counts) {
  double total = 0.0;
  for (const int count : counts) total += count;
  const double expected = total / static_cast<double>(Bins);
  double chi2 = 0.0;
  for (const int count : counts) chi2 += (count - expected) * (count - expected) / expected;
  const double freedoms = static_cast<double>(Bins) - 1.0;
  return (chi2 - freedoms) / std::sqrt(2.0 * freedoms);
}

// An even source exceeds 5 deviations less than once in 10^5 seeds (χ² has a longer tail than the
// normal law); the seeds are fixed. Measured: below 2.
constexpr double even = 5.0;

std::size_t bin(double value, double low, double high, std::size_t bins) {
  return static_cast<std::size_t>((value - low) / (high - low) * static_cast<double>(bins));
}

}  // namespace

TEST_CASE("The stream of seed 1234567 is that of the published SplitMix64", "[exact][random]") {
  Random random(1234567);
  CHECK(random.bits() == 6457827717110365317U);
  CHECK(random.bits() == 3203168211198807973U);
  CHECK(random.bits() == 9817491932198370423U);
  CHECK(random.bits() == 4593380528125082431U);
  CHECK(random.bits() == 16408922859458223821U);
}

TEST_CASE("Numbers from 0 to 1 are even, start at 0 and do not reach 1", "[unit][random]") {
  Random random(1);
  std::array<int, 64> counts{};
  int outside = 0;
  for (int i = 0; i < 64000; ++i) {
    const double u = random.unit();
    if (!(u >= 0.0 && u < 1.0)) {
      ++outside;
      continue;
    }
    ++counts[bin(u, 0.0, 1.0, counts.size())];
  }
  CHECK(outside == 0);
  CHECK(std::abs(unevenness(counts)) <= even);
}

TEST_CASE("Whole numbers below a count are even and stay below it", "[unit][random]") {
  Random random(2);
  std::array<int, 7> counts{};
  int outside = 0;
  for (int i = 0; i < 70000; ++i) {
    const std::uint32_t k = random.below(7);
    if (k < 7)
      ++counts[k];
    else
      ++outside;
  }
  CHECK(outside == 0);
  CHECK(std::abs(unevenness(counts)) <= even);
  CHECK(random.below(1) == 0);
}

TEST_CASE("Uniform numbers keep to their range, also an empty one", "[unit][random]") {
  Random random(3);
  int outside = 0;
  for (int i = 0; i < 10000; ++i) {
    const double x = random.uniform(-3.0, 5.0);
    if (!(x >= -3.0 && x < 5.0)) ++outside;
  }
  CHECK(outside == 0);
  CHECK(random.uniform(2.0, 2.0) == 2.0);
}

TEST_CASE("Random directions favour no side", "[unit][random]") {
  // Each coordinate of an even direction is even on [-1, 1] (Archimedes).
  Random random(4);
  std::array<std::array<int, 32>, 3> counts{};
  double longest = 0.0;
  for (int i = 0; i < 32000; ++i) {
    const Vec3 d = random.direction();
    longest = std::max(longest, std::abs(d.norm() - 1.0));
    for (int k = 0; k < 3; ++k) {
      auto& of_axis = counts[idx(k)];
      ++of_axis[std::min<std::size_t>(bin(d[k], -1.0, 1.0, 32), 31)];
    }
  }
  CHECK(longest <= 1e-15);  // a few roundings of numbers up to 1: measured 3e-16
  for (const auto& of_axis : counts) CHECK(std::abs(unevenness(of_axis)) <= even);
}

TEST_CASE("Random orientations take every direction to every other", "[unit][random]") {
  // An even rotation takes a fixed direction to an even one; and its trace has the mean 0.
  Random random(5);
  std::array<int, 32> counts{};
  double trace = 0.0;
  double longest = 0.0;
  const int draws = 32000;
  for (int i = 0; i < draws; ++i) {
    const Quat q = random.orientation();
    longest = std::max(longest, std::abs(q.norm() - 1.0));
    const Mat3 R = q.toRotationMatrix();
    trace += R.trace() / draws;
    ++counts[std::min<std::size_t>(bin(R(0, 1), -1.0, 1.0, 32), 31)];
  }
  CHECK(longest <= 1e-15);  // a few roundings of numbers up to 1: measured 3e-16
  CHECK(std::abs(unevenness(counts)) <= even);
  // The trace has deviation 1, its mean 1/√32000 = 0.0056; five of them. Measured 0.009.
  CHECK(std::abs(trace) <= 0.028);
}

TEST_CASE("Points of a cube stay in it", "[unit][random]") {
  Random random(6);
  double farthest = 0.0;
  for (int i = 0; i < 10000; ++i)
    farthest = std::max(farthest, random.in_cube(0.25).cwiseAbs().maxCoeff());
  CHECK(farthest <= 0.25);
  CHECK(farthest > 0.249);
}

TEST_CASE("A forked stream does not depend on what is drawn elsewhere", "[determinism][random]") {
  Random parent(7);
  const std::uint64_t before = parent.state();
  Random early = parent.fork(3);
  CHECK(parent.state() == before);  // forking draws nothing
  Random other = parent.fork(4);
  for (int i = 0; i < 100; ++i) other.bits();
  Random late = parent.fork(3);
  CHECK(early.bits() == late.bits());
  CHECK(parent.fork(3).bits() != parent.fork(4).bits());
  CHECK(parent.fork(3).fork(4).bits() != parent.fork(4).fork(3).bits());
}

TEST_CASE("Forked streams of neighbouring names are not related", "[unit][random]") {
  // Bits in common between the first draws of streams k and k + 1: 32 of 64 on average, with the
  // deviation 4; the mean of 4000 has 4/√4000 = 0.063. Five of them. Measured 0.056.
  const Random parent(8);
  double mean = 0.0;
  std::array<int, 64> counts{};
  for (std::uint64_t k = 0; k < 4000; ++k) {
    Random one = parent.fork(k);
    Random next = parent.fork(k + 1);
    std::uint64_t same = ~(one.bits() ^ next.bits());
    for (; same != 0; same &= same - 1) mean += 1.0 / 4000.0;
    ++counts[bin(one.unit(), 0.0, 1.0, 64)];
  }
  CHECK(std::abs(mean - 32.0) <= 0.32);
  CHECK(std::abs(unevenness(counts)) <= even);
}

TEST_CASE("A stream goes on from its state", "[determinism][random]") {
  Random random(9);
  for (int i = 0; i < 10; ++i) random.bits();
  Random copy(random.state());
  CHECK(copy.bits() == random.bits());
}
