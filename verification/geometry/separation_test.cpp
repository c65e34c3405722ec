/// \file
/// \brief The separating axis test against closed forms and the plain loop over fifteen axes.
#include "tumble/geometry/separation.hpp"

#include "tumble/base/tolerances.hpp"
#include "tumble/geometry/separation_plain.hpp"

#include "geometry/boxes.hpp"
#include "support/test.hpp"

namespace {

const double kQuarter = std::sqrt(0.5);  // sine and cosine of 45 degrees

SeparationOptions exact() { return SeparationOptions{.prefer_faces = false, .enough = kInfinity}; }

// The largest gap over the 15 axes, and over those of them that are well-conditioned.
//
// The cross product of edges at an angle t has its direction to 1e-19 / t only. For boxes that
// overlap this does no harm: the gap along any direction whatsoever is at most the true one, and the
// facet that the axis belongs to is as narrow as the axis is vague. For boxes that are apart any
// direction may show a larger gap than all 15 axes, so there only the second number is firm.
struct Truth {
  double all;
  double firm;
  bool vague() const { return all > 0.0 && some_left_out; }
  bool some_left_out;
};

Truth plain(const Box& a, const Box& b) {
  const Mat3 sines = (a.axes_w.transpose() * b.axes_w).cwiseAbs2().unaryExpr([](double cosine2) {
    return std::sqrt(std::max(0.0, 1.0 - cosine2));
  });
  const auto largest = [&](double parallel) {
    return static_cast<double>(separation_plain<long double>(a, b, parallel));
  };
  return {largest(1e-14), largest(1e-2), sines.minCoeff() <= 1e-2};
}

// The size of the numbers involved, which rounding is measured in.
double scale_of(const Box& a, const Box& b) {
  return a.half.sum() + b.half.sum() + (b.center_w - a.center_w).norm();
}

// One of seven kinds of pairs.
struct Pair {
  Box a, b;
};

Vec3 sizes(Random& random, double decades) {
  Vec3 out;
  for (int i = 0; i < 3; ++i) out[i] = std::pow(10.0, random.uniform(-decades, decades));
  return out;
}

Pair random_pair(Random& random, int kind) {
  const Quat q = random.orientation();
  const Quat other = random.orientation();
  const double decades = kind == 6 ? 3.0 : 0.5;
  const Vec3 size_a = sizes(random, decades);
  const Vec3 size_b = sizes(random, decades);
  Pair pair{make_box(random.in_cube(1.0), q, size_a), make_box(Vec3::Zero(), other, size_b)};
  if (kind >= 1 && kind <= 4) {
    // Exact quarter turns: the axes of the second are those of the first in another order.
    const int shift = static_cast<int>(random.below(3));
    for (int i = 0; i < 3; ++i) pair.b.axes_w.col(i) = pair.a.axes_w.col((i + shift) % 3);
    if (kind == 2) {  // all along the axes of the world
      pair.a.axes_w = Mat3::Identity();
      pair.b.axes_w = Mat3::Identity();
    }
    if (kind >= 3) {  // tilted by 1e-9 to 1e-3, or down to rounding
      const double exponent = random.uniform(kind == 3 ? -9.0 : -17.0, -3.0);
      const Vec3 axis = random.direction();
      pair.b.axes_w = about(axis, std::pow(10.0, exponent)) * pair.b.axes_w;
    }
  }
  const double apart = (size_a.norm() + size_b.norm()) * (kind == 5 ? 0.05 : 0.35);
  const Vec3 offset = apart * random.unit() * random.direction();
  pair.b.center_w = pair.a.center_w + offset;
  if (random.below(4) == 0) {  // touching, to rounding
    const Separation found = separation(pair.a, pair.b, exact());
    pair.b.center_w -= found.distance * found.normal_w;
  }
  return pair;
}

struct Tally {
  double worst_exact = 0.0;      // error of the separation over the scale
  double worst_normal = 0.0;     // its normal's own gap against the distance, over the scale
  double worst_preferred = 0.0;  // what the preference lost, over its allowance
  int disagreements = 0;         // touching or not, where it is not within rounding
  int not_unit = 0;
  int overlaps = 0;
};

Tally compare_with_plain_loop(int count, std::uint64_t seed) {
  Tally tally;
  Random random(seed);
  for (int n = 0; n < count; ++n) {
    const Pair pair = random_pair(random, n % 7);
    const Truth answer = plain(pair.a, pair.b);
    const double truth = answer.vague() ? answer.firm : answer.all;
    const double scale = scale_of(pair.a, pair.b);
    const double rounding = 1e-13 * scale;

    const Separation found = separation(pair.a, pair.b, exact());
    double error = (truth - found.distance) / scale;  // of a vague truth only this side is known
    if (!answer.vague()) error = std::abs(error);
    tally.worst_exact = std::max(tally.worst_exact, std::isfinite(error) ? error : kInfinity);
    const Vec3& normal = found.normal_w;
    const double gap = gap_along(pair.a, pair.b, normal);
    tally.worst_normal = std::max(tally.worst_normal, std::abs(gap - found.distance) / scale);
    if (!(std::abs(normal.norm() - 1.0) < 1e-12)) ++tally.not_unit;
    if (normal.dot(pair.b.center_w - pair.a.center_w) < -rounding) ++tally.not_unit;

    // With preference and early out, and with a remembered axis drawn at random.
    const double shortest = std::min(pair.a.half.minCoeff(), pair.b.half.minCoeff());
    for (int remember = 0; remember < 2; ++remember) {
      SeparationOptions options;
      if (remember == 1) options.remembered = static_cast<AxisIndex>(random.below(15));
      const double s = separation(pair.a, pair.b, options).distance;
      if ((s > 0.0) != (answer.all > 0.0) && std::abs(answer.all) > rounding) ++tally.disagreements;
      options.enough = kInfinity;
      const double preferred = separation(pair.a, pair.b, options).distance;
      const double allowance = tolerance::face_preference * std::abs(preferred) +
                               tolerance::face_preference_length * shortest;
      tally.worst_preferred =
          std::max(tally.worst_preferred, (truth - preferred - 5.0 * rounding) / allowance);
    }
    if (answer.all <= 0.0) ++tally.overlaps;
  }
  return tally;
}

void check(const Tally& tally, int count) {
  // Rounding of some twenty sums and products. Measured 1.7e-15 over a million pairs.
  CHECK(tally.worst_exact < 1e-13);
  // The distance is the gap along the very normal that is returned. Measured 8e-16.
  CHECK(tally.worst_normal < 1e-13);
  // The stated bound of the preference: one allowance. Measured 0.9995: it is used up.
  CHECK(tally.worst_preferred <= 1.0);
  CHECK(tally.disagreements == 0);
  CHECK(tally.not_unit == 0);
  // The cases are no soft ones: both outcomes are common.
  CHECK(tally.overlaps > count / 5);
  CHECK(tally.overlaps < 4 * count / 5);
}

}  // namespace

TEST_CASE("A cube turned by 45 degrees reaches 0.107106781187 into a cube 1.1 away",
          "[exact][separation]") {
  const Separation s = separation(cube_at(Vec3::Zero()),
                                  cube_at({1.1, 0.0, 0.0}, about(Vec3::UnitZ(), M_PI_4)), exact());
  CHECK(-s.distance == near(0.5 + kQuarter - 1.1, 1e-15));
  CHECK(-s.distance == near(0.107106781187, 1e-12));  // digits given
  CHECK(s.axis == 0);
  CHECK((s.normal_w - Vec3::UnitX()).norm() < 1e-15);
}

TEST_CASE("Two cubes edge across edge overlap by the square root of 2 less their distance",
          "[exact][separation]") {
  const Box lower = cube_at(Vec3::Zero(), about(Vec3::UnitZ(), M_PI_4));
  for (const bool prefer : {false, true}) {
    SeparationOptions options = exact();
    options.prefer_faces = prefer;
    const Separation touching =
        separation(lower, cube_at({0.0, 1.4, 0.0}, about(Vec3::UnitX(), M_PI_4)), options);
    CHECK(-touching.distance == near(2.0 * kQuarter - 1.4, 4e-16));
    CHECK(-touching.distance == near(0.014213562373, 1e-12));
    CHECK(touching.axis == 6 + 3 * 2 + 0);
    CHECK((touching.normal_w - Vec3::UnitY()).norm() < 1e-15);
    // A little higher they are apart, which none of the six face axes sees.
    const Box upper = cube_at({0.0, 1.42, 0.0}, about(Vec3::UnitX(), M_PI_4));
    const Separation apart = separation(lower, upper, options);
    CHECK(apart.distance == near(0.005786437627, 1e-12));
    double faces = -kInfinity;
    for (int i = 0; i < 3; ++i) {
      faces = std::max(faces, gap_along<double>(lower, upper, lower.axes_w.col(i)));
      faces = std::max(faces, gap_along<double>(lower, upper, upper.axes_w.col(i)));
    }
    CHECK(-faces == near(0.349461761, 1e-9));
  }
}

TEST_CASE("The separation of 20000 pairs is that of the plain loop over fifteen axes",
          "[unit][separation]") {
  constexpr int kPairs = 20000;
  check(compare_with_plain_loop(kPairs, 1), kPairs);
}

TEST_CASE("The separation of a million pairs is that of the plain loop over fifteen axes",
          "[unit][separation][.long]") {
  constexpr int kPairs = 1000000;
  check(compare_with_plain_loop(kPairs, 2), kPairs);
}

TEST_CASE(
    "Almost parallel edges that barely cross decide, though their angle is only 1e-7 to 1e-11",
    "[unit][separation]") {
  // Seen along z two squares, one turned by 45 degrees, meet corner against corner; z of the second
  // is tilted so little towards the line of centres that quick sums would lose the edge axis.
  Random random(6);
  double worst = 0.0;
  int edges = 0;
  for (int n = 0; n < 20000; ++n) {
    const double direction = M_PI / 8.0;
    const Vec3 centers(std::cos(direction), std::sin(direction), 0.0);
    const double tilt = std::pow(10.0, random.uniform(-11.0, -7.0));
    const double depth = tilt * random.uniform(0.0, 2.0);
    // A corner of each square reaches this far along the line of centres.
    const double corners = std::sqrt(0.5) * 2.0 * std::cos(direction);
    const Quat whole = random.orientation();
    const Quat turn = about(centers, tilt) * about(Vec3::UnitZ(), M_PI_4);
    const Box a = cube_at(Vec3::Zero(), whole);
    const Box b = cube_at(whole * Vec3((corners - depth) * centers), (whole * turn).normalized());
    const Truth truth = plain(a, b);
    if (truth.all > 0.0) continue;
    const Separation found = separation(a, b, exact());
    if (found.axis >= 6) ++edges;
    worst = std::max(worst, std::abs(found.distance - truth.all));
  }
  CHECK(edges > 1000);
  CHECK(worst < 1e-14);  // [m] rounding, for cubes of 1 m; measured 1.5e-15
}

TEST_CASE("A remembered axis is kept until another one beats it clearly", "[unit][separation]") {
  // Cubes beside each other along x and y: 0.100 deep along y, a little less along x.
  SeparationOptions options{.remembered = 1};
  const Box first = cube_at(Vec3::Zero());
  CHECK(separation(first, cube_at({0.902, 0.9, 0.0}), options).axis == 1);
  CHECK(separation(first, cube_at({0.910, 0.9, 0.0}), options).axis == 0);
  options.remembered = kNoAxis;
  CHECK(separation(first, cube_at({0.902, 0.9, 0.0}), options).axis == 0);
}

TEST_CASE("The search stops at the first axis beyond enough, and no axis is missed",
          "[unit][separation]") {
  Random random(5);
  int wrong = 0, stopped = 0;
  for (int n = 0; n < 14000; ++n) {
    const Pair pair = random_pair(random, n % 7);
    const Truth answer = plain(pair.a, pair.b);
    if (answer.vague()) continue;
    const double truth = answer.all;
    const double rounding = 1e-13 * scale_of(pair.a, pair.b);
    SeparationOptions options;
    // Anywhere, or so close below the truth that a preferred axis alone would not see it.
    options.enough =
        n % 2 == 0 ? random.uniform(-0.5, 0.5) * pair.a.half.minCoeff() : truth - 10.0 * rounding;
    const double s = separation(pair.a, pair.b, options).distance;
    if (std::abs(truth - options.enough) > rounding &&
        (s > options.enough) != (truth > options.enough))
      ++wrong;
    if (s > truth + rounding) ++wrong;
    if (s > options.enough) ++stopped;
  }
  CHECK(wrong == 0);
  CHECK(stopped > 1000);
}

TEST_CASE("A separation that is asked for with bad options is refused", "[unit][separation]") {
  const Box box = cube_at(Vec3::Zero());
  SeparationOptions options{.remembered = 15};
  CHECK_THROWS_WITH(separation(box, box, options), Contains("remembered = 15"));
  options.remembered = -2;
  CHECK_THROWS_AS(separation(box, box, options), std::invalid_argument);
  options.remembered = kNoAxis;
  options.enough = kNan;
  CHECK_THROWS_WITH(separation(box, box, options), Contains("enough"));
}
