/// \file
/// \brief Floor, faces, pips and shadows as areas.
#include "tumble/pictures/picture_parts.hpp"

#include "tumble/math/elementary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace tumble {
namespace {

constexpr std::uint32_t kPageColour = 0xffffff;
constexpr std::uint32_t kFloorColour = 0xe4e1da;
constexpr std::uint32_t kShadowColour = 0x14141f;
constexpr std::uint32_t kPipColour = 0xfffffa;
constexpr double kOutlineShare = 0.62;  // share of the shadow's colour in an outline
constexpr double kFloorBegins = 0.9;    // start of the floor's fading, over the radius of the boxes
constexpr double kFloorEnds = 2.3;      //   on it, and its end, where it is white
constexpr int kFloorSteps = 20;         // shades in between: one or two levels of colour each
constexpr int kCircleCorners = 72;      // of a large circle
constexpr int kPipCorners = 16;         // of a small one
constexpr double kNearest = 0.02;   // floor nearer than this share of the scene's depth is left out
constexpr double kPipRadius = 0.2;  // over half the edge, as are the places of pips
constexpr double kPipPlace = 0.54;

Polygon seen(const Polygon& polygon, const Plane& plane, const Projection& view) {
  Polygon out;
  for (const Vec2& p : polygon) out.push_back(view(plane.at(p)));
  return out;
}

Polygon circle(const Vec2& middle, const Vec2& radii, int corners) {
  Polygon out;
  for (int k = 0; k < corners; ++k) {
    const elementary::SinCos turn = elementary::sincos(2.0 * std::numbers::pi * k / corners);
    out.emplace_back(middle + radii.cwiseProduct(Vec2(turn.cos, turn.sin)));
  }
  return out;
}

// An area for one point of the lamp; the overlay of all of them is the shadow.
PictureArea shadow_layer(const Lamp& lamp, const Vec3& normal_w, int box) {
  PictureArea area{.colour = kShadowColour};
  const double lit = 1.0 - lamp.shadow_depth(normal_w);
  area.opacity = 1.0 - elementary::pow(lit, 1.0 / static_cast<double>(lamp.points_w().size()));
  area.shadow = true;
  area.box = box;
  return area;
}

// Whether a box may be between the lamp and a receiver, by their bounding spheres.
bool shades(const Box& box, const Box& receiver, const Lamp& lamp) {
  const Vec3 way_w = box.center_w - receiver.center_w;
  const double along = way_w.dot(lamp.middle_w());
  const double radii = box.half.norm() + receiver.half.norm();
  return along > -radii &&
         (way_w - along * lamp.middle_w()).norm() <= radii + Lamp::kRadius * std::abs(along);
}

// The shadows of the other boxes on a face, one area for each point of the lamp.
void add_face_shadows(const PictureScene& scene, std::size_t number, const Plane& face,
                      const Polygon& rectangle, std::vector<PictureArea>& areas) {
  if (scene.lamp.shadow_depth(face.normal_w) <= 0.0) return;
  PictureArea area = shadow_layer(scene.face_lamp, face.normal_w, static_cast<int>(number));
  for (const Vec3& light_w : scene.face_lamp.points_w()) {
    if (light_w.dot(face.normal_w) <= 0.0) continue;
    area.loops.clear();
    for (std::size_t k = 0; k < scene.boxes.size(); ++k) {
      if (k == number || !shades(scene.boxes[k].box, scene.boxes[number].box, scene.lamp)) continue;
      const Polygon shadow = clipped(shadow_of(scene.boxes[k].box, face, light_w), rectangle);
      if (shadow.size() > 2) area.loops.push_back(seen(shadow, face, scene.view));
    }
    if (!area.loops.empty()) areas.push_back(area);
  }
}

// One pip in the middle of odd numbers, then pairs on one diagonal, the other, and between them.
void add_pips(const PictureScene& scene, const Plane& face, const Vec2& half, int pips,
              std::size_t number, std::vector<PictureArea>& areas) {
  constexpr std::array<std::array<double, 2>, 3> pairs = {{{1.0, 1.0}, {1.0, -1.0}, {1.0, 0.0}}};
  PictureArea area{.colour = scene.lamp.shade(kPipColour, face.normal_w),
                   .box = static_cast<int>(number)};
  const auto add = [&](const Vec2& place) {
    area.loops.push_back(
        seen(circle(half.cwiseProduct(place), kPipRadius * half, kPipCorners), face, scene.view));
  };
  if (pips % 2 == 1) add(Vec2::Zero());
  for (std::size_t k = 0; 2 * static_cast<int>(k) + 2 <= pips; ++k) {
    add(kPipPlace * Vec2(pairs[k][0], pairs[k][1]));
    add(-kPipPlace * Vec2(pairs[k][0], pairs[k][1]));
  }
  areas.push_back(std::move(area));
}

// So many that the steps of a soft edge are not seen, but in large heaps, where edges are many and short.
int points_of_lamp(int fewest, int most, std::size_t room, std::size_t boxes) {
  return std::clamp(static_cast<int>(room / std::max<std::size_t>(boxes, 1)), fewest, most);
}

}  // namespace

PictureScene picture_scene(std::span<const PictureBox> boxes, const Camera& camera) {
  const Projection view(camera);
  return {boxes, camera.eye_w, view, Lamp(view, points_of_lamp(8, 24, 4000, boxes.size())),
          Lamp(view, points_of_lamp(4, 12, 1500, boxes.size()))};
}

// The floor: concentric discs, the larger the closer to the white of the page, so that it has neither an edge
// nor a horizon. On it is one area for each point of the lamp, with the shadows of all boxes.
std::vector<PictureArea> floor_areas(const PictureScene& scene,
                                     std::span<const PictureBox> around) {
  std::vector<PictureArea> areas;
  if (scene.eye_w.y() <= 0.0) return areas;
  const Plane floor{};
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = -low;
  for (const PictureBox& b : around) {
    for (const Vec2& p : shadow_of(b.box, floor, scene.lamp.middle_w())) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  if (!(low.x() < high.x())) return areas;  // nothing is above the floor
  const Vec2 middle = 0.5 * (low + high);
  const double radius = 0.5 * (high - low).norm();

  // All of the floor must be in front of the eye: depth(p) = depth(0) + p.(its slopes) >= nearest.
  const Projection& view = scene.view;
  const Vec2 slopes(-view.back_w().dot(floor.u_w), -view.back_w().dot(floor.v_w));
  const double depth = view.depth(floor.origin_w);
  const HalfPlane in_front{-slopes, depth - kNearest * (depth + slopes.dot(middle))};
  for (int step = 0; step < kFloorSteps; ++step) {
    const double share = 1.0 - static_cast<double>(step) / kFloorSteps;  // 1: at the outer edge
    const double reach = radius * (kFloorBegins + (kFloorEnds - kFloorBegins) * share);
    const Polygon disc = circle(middle, Vec2::Constant(reach), kCircleCorners);
    PictureArea area{
        .loops = {seen(clipped(disc, in_front), floor, view)},
        .colour = mixed(kFloorColour, kPageColour, share * share * (3.0 - 2.0 * share))};
    areas.push_back(std::move(area));
  }
  for (const Vec3& light_w : scene.lamp.points_w()) {
    PictureArea area = shadow_layer(scene.lamp, floor.normal_w, kNoBox);
    for (const PictureBox& b : scene.boxes)
      area.loops.push_back(seen(clipped(shadow_of(b.box, floor, light_w), in_front), floor, view));
    areas.push_back(std::move(area));
  }
  return areas;
}

std::vector<PictureFace> visible_faces(const PictureScene& scene, std::size_t number) {
  const PictureBox& drawn = scene.boxes[number];
  const Box& box = drawn.box;
  std::vector<PictureFace> faces;
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    int next = (axis + 1) % 3;
    int last = (axis + 2) % 3;
    if (side % 2 == 0) std::swap(next, last);  // so that u x v points outwards
    const Vec3 normal_w = box.axes_w.col(axis) * (side % 2 == 0 ? -1.0 : 1.0);
    const Plane face{box.center_w + box.half[axis] * normal_w, box.axes_w.col(next),
                     box.axes_w.col(last), normal_w};
    if (normal_w.dot(scene.eye_w - face.origin_w) <= 0.0) continue;  // back face
    const Vec2 half(box.half[next], box.half[last]);
    const Polygon rectangle{-half, Vec2(half.x(), -half.y()), half, Vec2(-half.x(), half.y())};
    PictureFace visible;
    visible.whole.normal_w = normal_w;
    for (const Vec2& corner : rectangle) visible.whole.corners_w.push_back(face.at(corner));
    PictureArea area;
    area.loops = {seen(rectangle, face, scene.view)};
    area.colour = scene.lamp.shade(drawn.colour, normal_w);
    area.outline = mixed(drawn.colour, kShadowColour, kOutlineShare);
    area.outlined = true;
    area.box = static_cast<int>(number);
    visible.areas.push_back(std::move(area));
    if (drawn.die) add_pips(scene, face, half, pips_of_side(side), number, visible.areas);
    add_face_shadows(scene, number, face, rectangle, visible.areas);
    faces.push_back(std::move(visible));
  }
  return faces;
}

}  // namespace tumble
