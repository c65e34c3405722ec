/// \file
/// \brief Time of a box's signed distance with its normal beside that of its closest face.
///
/// What the footnote of thesis 3.3.2 weighs. Arithmetic is counted by the figure
/// claim_3_3_2b_signed_distance and decides there; this is the clock's word. Both answer the same
/// 100 000 points about cubes of 1 m, half of them inside, in turn, and the median of the rounds counts.
///
/// Run `signed_distance [rounds]`.
#include "tumble/geometry/signed_distance.hpp"

#include "tumble/base/random.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

using namespace tumble;

namespace {

struct Query {
  Box box;
  Vec3 point_w;
};

// The side of the box whose plane is closest, or least far behind, as the thesis remembers it.
[[gnu::noinline]] SignedDistance closest_face(const Box& box, const Vec3& point_w) {
  const Vec3 p = box.axes_w.transpose() * (point_w - box.center_w);
  const Vec3 q = p.cwiseAbs() - box.half;
  int nearest = 0;
  q.maxCoeff(&nearest);
  return {q[nearest], (p[nearest] < 0.0 ? -1.0 : 1.0) * box.axes_w.col(nearest)};
}

// [s] of processor time for all queries; what they answer is added up, so that it is needed.
template <typename Answer>
double time_of(const std::vector<Query>& queries, Answer&& answer, double& sum) {
  const std::clock_t begin = std::clock();
  for (const Query& query : queries) {
    const SignedDistance found = answer(query.box, query.point_w);
    sum += found.distance + found.gradient_w.x();
  }
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 51;
  Random random(1);
  std::vector<Query> queries;
  for (int k = 0; k < 100000; ++k) {
    const Vec3 center = random.in_cube(10.0);
    const Quat orientation = random.orientation();
    const Box box = make_box(center, orientation, Vec3::Ones());
    const Vec3 inside = random.in_cube(0.5);
    const Vec3 where = k % 2 == 0 ? inside : Vec3(inside + Vec3::Unit(k % 3));
    queries.push_back({box, center + box.axes_w * where});
  }
  double sum = 0.0;
  std::vector<double> distance;
  std::vector<double> face;
  for (int round = 0; round < rounds; ++round) {
    distance.push_back(time_of(queries, signed_distance, sum));
    face.push_back(time_of(queries, closest_face, sum));
  }
  const double scale = 1e9 / static_cast<double>(queries.size());
  std::printf("signed distance %.1f ns, closest face %.1f ns, ratio %.2f (sum %g)\n",
              scale * median(distance), scale * median(face), median(distance) / median(face), sum);
}
