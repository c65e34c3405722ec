/// \file
/// \brief The claims on finding collisions (thesis 3.2, 3.3.1, 3.3.2, 4.1), run small.
#include "tumble/geometry/signed_distance.hpp"

#include "basic_colliding/counted.hpp"
#include "driver/quick.hpp"
#include "support/test.hpp"

using namespace tumble;
using namespace tumble::chapters;

TEST_CASE("The counted signed distance has the library's bits where faces, edges and signs tie",
          "[unit][basic_colliding]") {
  Random random(7);
  int differ = 0;
  for (int k = 0; k < 2000; ++k) {
    const Quat orientation = k % 2 == 0 ? Quat::Identity() : random.orientation();
    const Box box = make_box(Vec3::Zero(), orientation, Vec3::Ones());
    // Coordinates of the centre, of a face, and of half way between, with either sign.
    Vec3 point_b;
    for (int i = 0; i < 3; ++i) point_b[i] = 0.25 * (static_cast<double>(random.below(9)) - 4.0);
    const Vec3 point_w = box.axes_w * point_b;
    const SignedDistance truth = signed_distance(box, point_w);
    Operations counts;
    const CountedNormal counted = counted_signed_distance(box, point_w, counts);
    bool same = counted.distance.value == truth.distance;
    for (std::size_t i = 0; i < 3; ++i)
      same = same && counted.normal_w[i].value == truth.gradient_w[static_cast<int>(i)];
    differ += same ? 0 : 1;
  }
  CHECK(differ == 0);
}
