/// \file
/// \brief Joints: construction, held degrees of freedom, and gaps.
#include "tumble/exterior_rotation/joint.hpp"

#include "tumble/exterior_rotation/tolerances.hpp"

#include "exterior_rotation/cases.hpp"
#include "support/pose.hpp"
#include "support/test.hpp"

namespace {

// Two boxes: an immovable cube at the origin, and a rotated one above it.
World two(const Vec3& size, const Vec3& place_w, const Quat& turn) {
  World world;
  const BodyProperties below = fixed_box_properties(Vec3(2.0, 2.0, 2.0));
  world.add(below, Vec3(0.0, -1.0, 0.0));
  const BodyProperties above = box_properties(size, 1.0);
  world.add(above, place_w, turn);
  return world;
}

Quat about(const Vec3& axis, double angle) { return rotation_from_vector(angle * axis); }

// The joint of a world that has one.
Joint only_joint(const World& world) {
  const std::vector<Joint> joints = find_joints(world, tolerance::glue_margin);
  REQUIRE(joints.size() == 1);
  return joints.front();
}

// A world moved and turned as a whole.
World moved(const World& world, const Vec3& by, const Quat& turn) {
  return changed(world, [&](BodyProperties&, BodyState& state) {
    state.position_w = by + turn * state.position_w;
    state.orientation_wb = normalised(turn * state.orientation_wb);
  });
}

}  // namespace

TEST_CASE("A contact of one point makes a corner, of two an edge, of four and eight an area",
          "[unit][exterior_rotation]") {
  const double half = std::sqrt(0.5);
  // A cube on its corner: the diagonal is upright.
  const Quat on_corner = test::on_corner();
  const Joint corner = only_joint(two(Vec3::Ones(), Vec3(0.0, std::sqrt(0.75), 0.0), on_corner));
  CHECK(corner.count == 1);
  CHECK(corner.hold == JointHold::corner);
  CHECK_FALSE(corner.is_area());

  const Joint edge =
      only_joint(two(Vec3::Ones(), Vec3(0.0, half, 0.0), about(Vec3::UnitZ(), std::atan(1.0))));
  CHECK(edge.count == 2);
  CHECK(edge.hold == JointHold::edge);
  CHECK_FALSE(edge.is_area());

  const Joint area = only_joint(two(Vec3::Ones(), Vec3(0.0, 0.5, 0.0), Quat::Identity()));
  CHECK(area.count == 4);
  CHECK(area.hold == JointHold::area);
  CHECK(area.is_area());

  // A square across a rotated square that is smaller than its diagonal: an octagon.
  const Joint eight = only_joint(
      two(Vec3(2.0, 1.0, 2.0), Vec3(0.0, 0.5, 0.0), about(Vec3::UnitY(), std::atan(1.0))));
  CHECK(eight.count == 8);
  CHECK(eight.hold == JointHold::area);
  // Its corners go around: each turns the same way.
  const World world =
      two(Vec3(2.0, 1.0, 2.0), Vec3(0.0, 0.5, 0.0), about(Vec3::UnitY(), std::atan(1.0)));
  int left = 0;
  for (int k = 0; k < 8; ++k) {
    const Vec3 a = corner_of(eight, k, world.states()).first_w;
    const Vec3 b = corner_of(eight, k + 1, world.states()).first_w;
    if (a.cross(b).y() > 0.0) ++left;
  }
  CHECK((left == 0 || left == 8));
}

TEST_CASE("A contact without a point is refused as a joint", "[unit][exterior_rotation]") {
  const World world = two(Vec3::Ones(), Vec3(0.0, 0.5, 0.0), Quat::Identity());
  CHECK_THROWS_WITH(joint_of(world, {.second = 1}), Contains("without a point"));
}

TEST_CASE("A joint keeps its corners in the frames of both bodies wherever the world stands",
          "[exact][exterior_rotation]") {
  Random random(7);
  const World upright = two(Vec3(1.0, 0.5, 2.0), Vec3(0.3, 0.25, 0.1), Quat::Identity());
  for (int trial = 0; trial < 20; ++trial) {
    const Vec3 by = random.in_cube(10.0);
    World world = moved(upright, by, random.orientation());
    const Joint joint = only_joint(world);
    CHECK(joint.count == 4);
    // [m] rounding at 10 m, measured 6e-15
    CHECK(gap_of(joint, world.states()).apart <= 1e-13);
    CHECK((joint.normal_first_b - Vec3::UnitY()).norm() <= 1e-14);
    const JointPoint held = held_point(joint, world.states());
    CHECK((held.first_w - held.second_w).norm() <= 1e-13);
    // The area is that of the smaller box, as far as it is over the larger one.
    Vec3 low = Vec3::Constant(9.0);
    Vec3 high = Vec3::Constant(-9.0);
    for (int k = 0; k < joint.count; ++k) {
      const Vec3& corner_b = joint.corners_first_b[idx(k)];
      low = low.cwiseMin(corner_b);
      high = high.cwiseMax(corner_b);
    }
    // [m] clipping lets corners stick out by 1e-12
    CHECK((low - Vec3(-0.2, 1.0, -0.9)).norm() <= 2e-12);
    CHECK((high - Vec3(0.8, 1.0, 1.0)).norm() <= 2e-12);

    // Body 1 is moved in its own frame, so that the gap does not depend on the world's pose.
    BodyState& state = world.states()[1];
    state.position_w += world.states()[0].orientation_wb * Vec3(0.03, 0.04, 0.0);
    JointGap gap = gap_of(joint, world.states());
    CHECK(gap.opening == near(0.04, 1e-13));
    CHECK(gap.overlap == 0.0);
    CHECK(gap.apart == near(0.05, 1e-13));
    state.position_w -= world.states()[0].orientation_wb * Vec3(0.0, 0.08, 0.0);
    gap = gap_of(joint, world.states());
    CHECK(gap.opening == 0.0);
    CHECK(gap.overlap == near(0.04, 1e-13));
    CHECK(gap.apart == near(0.05, 1e-13));
  }
}

TEST_CASE("Only the corners that are held count for a gap", "[exact][exterior_rotation]") {
  World world = two(Vec3::Ones(), Vec3(0.0, 0.5, 0.0), Quat::Identity());
  Joint joint = only_joint(world);
  joint.hold = JointHold::edge;
  for (joint.side = 0; joint.side < 4; ++joint.side) {
    World turned_world = world;
    const JointPoint middle = held_point(joint, world.states());
    // About the side, by a tenth: the side stays, the middle of the area rises or sinks by half.
    const Vec3 along = (corner_of(joint, joint.side + 1, world.states()).second_w -
                        corner_of(joint, joint.side, world.states()).second_w)
                           .normalized();
    const Quat turn = rotation_from_vector(0.1 * along);
    BodyState& state = turned_world.states()[1];
    state.position_w = middle.second_w + turn * (state.position_w - middle.second_w);
    state.orientation_wb = turn;
    CHECK(gap_of(joint, turned_world.states()).apart <= 1e-15);
    CHECK(std::abs(opened(joint, turned_world.states())) == near(0.5 * std::sin(0.1), 1e-15));
    const double way = opened(joint, turned_world.states());
    Joint all = joint;
    all.hold = JointHold::area;
    const JointGap gap = gap_of(all, turned_world.states());
    CHECK((way > 0.0 ? gap.opening : gap.overlap) == near(std::sin(0.1), 1e-15));
    CHECK((way > 0.0 ? gap.overlap : gap.opening) <= 1e-15);
  }
  joint.side = 0;
  joint.hold = JointHold::nothing;
  world.states()[1].position_w.y() += 3.0;
  const JointGap none = gap_of(joint, world.states());
  CHECK(none.opening + none.overlap + none.apart == 0.0);
}

TEST_CASE("The margin of glue depends on the smaller of two bodies alone",
          "[unit][exterior_rotation]") {
  // A small pair beside a body a hundred times as large: 0.5 mm are a twentieth of its edge.
  World world;
  const BodyProperties large = fixed_box_properties(Vec3::Constant(100.0));
  world.add(large, Vec3(0.0, -50.0, 0.0));
  const BodyProperties small = box_properties(Vec3::Constant(0.01), 1.0);
  world.add(small, Vec3(0.0, 0.005, 0.0));
  world.add(small, Vec3(0.0, 0.0155, 0.0));
  CHECK(find_joints(world, tolerance::glue_margin).size() == 1);
  CHECK(find_joints(world, 0.06).size() == 2);

  // A plate: its shortest edge, against the middle one.
  const double margin = 0.01;
  for (const double gap : {0.9e-3, 1.1e-3}) {
    World plate = two(Vec3(1.0, 0.1, 1.0), Vec3(0.0, 0.05 + gap, 0.0), Quat::Identity());
    CHECK(find_joints(plate, margin).size() == (gap < 1e-3 ? 1u : 0u));
  }
}

TEST_CASE("Joints are sorted, none is between immovable bodies, and the ground can be glued to",
          "[unit][exterior_rotation]") {
  World world;
  const BodyProperties fixed = fixed_box_properties(Vec3::Ones());
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  world.add(cube, Vec3(1.0, 0.5, 0.0));
  world.add(fixed, Vec3(0.0, 0.5, 0.0));
  world.add_ground();
  world.add(cube, Vec3(1.0, 1.5, 0.0));
  world.add(cube, Vec3(5.0, 1.5, 0.0));
  const std::vector<Joint> joints = find_joints(world, tolerance::glue_margin);
  REQUIRE(joints.size() >= 3);
  CHECK(joints[0].first == 0);
  CHECK(joints[0].second == 1);
  CHECK(joints[1].second == 2);
  CHECK(joints[2].second == 3);
  // Towards the second body, which is the ground here.
  CHECK((joints[1].normal_first_b + Vec3::UnitY()).norm() == 0.0);
  for (const Joint& joint : joints) CHECK((joint.first == 0 || joint.second == 3));
  CHECK(find_joints(World{}, tolerance::glue_margin).empty());
}

TEST_CASE("A margin for joints that is negative or no number is refused",
          "[unit][exterior_rotation]") {
  const World world = two(Vec3::Ones(), Vec3(0.0, 0.5, 0.0), Quat::Identity());
  CHECK_THROWS_WITH(find_joints(world, -1e-9), Contains("margin"));
  CHECK_THROWS_WITH(find_joints(world, kNan), Contains("margin"));
  CHECK(find_joints(world, 0.0).size() == 1);
}

TEST_CASE("Bodies that were there keep their joints when others come or go",
          "[unit][exterior_rotation]") {
  World world = world_of("fig6_1");
  std::vector<Joint> joints = find_joints(world, tolerance::glue_margin);
  REQUIRE(joints.size() == 4);
  joints[3].hold = JointHold::nothing;
  const std::vector<BodyId> before(world.ids().begin(), world.ids().end());
  // The column's joints open by more than the margin, and one of its boxes is removed.
  for (std::size_t k = 2; k < 6; ++k)
    world.states()[k].position_w.x() += 1e-3 * static_cast<double>(k);
  world.remove(before[3]);
  world.add(box_properties(Vec3::Ones(), 1.0), Vec3(-2.0, 2.5, 0.0));
  const std::vector<Joint> now = renewed_joints(joints, before, world, tolerance::glue_margin);
  REQUIRE(now.size() == 3);
  CHECK((now[0].first == 1 && now[0].second == 2));  // larger and box1
  CHECK((now[1].first == 1 && now[1].second == 5));  // larger and the new one
  CHECK(now[1].hold == JointHold::area);
  CHECK((now[2].first == 3 && now[2].second == 4));  // box3 and box4, still apart
  CHECK(now[2].hold == JointHold::nothing);
}
