/// \file
/// \brief Painter's order of areas, and clipping.
#include "tumble/pictures/picture.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/geometry/painters_order.hpp"
#include "tumble/pictures/lighting.hpp"
#include "tumble/pictures/picture_parts.hpp"

#include <array>
#include <cmath>
#include <numeric>

namespace tumble {
namespace {

constexpr double kTooSmall = 0.02;    // [px²] an invisible area
constexpr double kOutlineRoom = 1.5;  // [px] beside an edge for the line that is drawn along it
constexpr int kDeepestRing = 6;       // most nested cyclic overlaps

// Adds areas to a picture in painter's order.
class Painter {
 public:
  Painter(const PictureScene& scene, double width, double height);
  void paint_floor(std::span<const PictureBox> around);
  void paint_boxes();
  Picture take() { return std::move(picture_); }

 private:
  // A box, ready to be painted repeatedly.
  struct Prepared {
    Polygon outline;                 // [px]
    std::vector<PictureArea> areas;  // faces, with pips and shadows
  };

  void paint(const std::vector<int>& numbers, const Polygon& region, int depth);
  void mend(const std::vector<int>& order, const Polygon& region, int depth);
  void add(const PictureArea& area, const Polygon& region);
  [[nodiscard]] Polygon common(int one, int other, const Polygon& region, double room) const;

  const PictureScene& scene_;
  Polygon frame_;  // [px] in the sense of rotation of convex_hull()
  std::vector<Prepared> prepared_;
  Picture picture_;
};

Painter::Painter(const PictureScene& scene, double width, double height)
    : scene_(scene),
      frame_{Vec2(0.0, 0.0), Vec2(width, 0.0), Vec2(width, height), Vec2(0.0, height)} {
  picture_.width = width;
  picture_.height = height;
}

void Painter::paint_floor(std::span<const PictureBox> around) {
  for (const PictureArea& area : floor_areas(scene_, around)) add(area, frame_);
}

void Painter::paint_boxes() {
  for (std::size_t k = 0; k < scene_.boxes.size(); ++k) {
    Prepared box;
    for (const Vec3& corner_w : corners_of(scene_.boxes[k].box))
      box.outline.push_back(scene_.view(corner_w));
    box.outline = convex_hull(std::move(box.outline));
    box.areas = face_areas(scene_, k);
    prepared_.push_back(std::move(box));
  }
  std::vector<int> all(scene_.boxes.size());
  std::iota(all.begin(), all.end(), 0);
  paint(all, frame_, 0);
}

// The intersection of two boxes' outlines with a region.
Polygon Painter::common(int one, int other, const Polygon& region, double room) const {
  return clipped(clipped(region, prepared_[idx(one)].outline, room), prepared_[idx(other)].outline,
                 room);
}

// Paints some of the boxes, clipped to a region.
void Painter::paint(const std::vector<int>& numbers, const Polygon& region, int depth) {
  std::vector<Box> shapes;
  for (const int number : numbers) shapes.push_back(scene_.boxes[idx(number)].box);
  const auto meet_here = [&](int a, int b) {
    return depth == 0 || area_of(common(numbers[idx(a)], numbers[idx(b)], region, 0.0)) > kTooSmall;
  };
  const PaintersOrder sorted = painters_order(shapes, ViewPoint::from_eye(scene_.eye_w), meet_here);
  std::vector<int> order;
  for (const int place : sorted.order) order.push_back(numbers[idx(place)]);
  for (const int number : order) {
    for (const PictureArea& area : prepared_[idx(number)].areas) add(area, region);
  }
  if (sorted.cycles > 0 && depth < kDeepestRing) mend(order, region, depth);
  if (sorted.cycles > 0 && depth == kDeepestRing) picture_.rings += sorted.cycles;
}

// Resolves a cyclic overlap: wherever a box was painted before one that it covers, everything in the
// intersection of the two is painted again. Fewer boxes overlap there, and finally none cyclically.
void Painter::mend(const std::vector<int>& order, const Polygon& region, int depth) {
  for (std::size_t later = 1; later < order.size(); ++later) {
    for (std::size_t sooner = 0; sooner < later; ++sooner) {
      const int one = order[sooner];
      const int other = order[later];
      if (area_of(common(one, other, region, 0.0)) < kTooSmall) continue;
      const std::array<Box, 2> pair = {scene_.boxes[idx(one)].box, scene_.boxes[idx(other)].box};
      if (painters_order(pair, scene_.eye_w).order.front() == 0) continue;  // correct order
      const Polygon wider = common(one, other, region, kOutlineRoom);
      std::vector<int> there;
      for (const int number : order) {
        if (clipped(wider, prepared_[idx(number)].outline).size() > 2) there.push_back(number);
      }
      paint(there, wider, depth + 1);
    }
  }
}

// Adds the part of an area inside a region. A clipped area loses its outline, and the rest of that is drawn
// as lines, so that the cut gets no line.
void Painter::add(const PictureArea& area, const Polygon& region) {
  PictureArea inside = area;
  inside.loops.clear();
  bool cut = false;
  double size = 0.0;
  for (const Polygon& loop : area.loops) {
    Polygon part = clipped(loop, region);
    cut = cut || part != loop;
    size += std::abs(area_of(part));
    if (part.size() > 2) inside.loops.push_back(std::move(part));
  }
  if (size < kTooSmall) return;
  inside.outlined = area.outlined && !cut;
  picture_.areas.push_back(std::move(inside));
  if (!area.outlined || !cut) return;
  for (const Polygon& loop : area.loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      PictureArea line = area;
      line.loops = {clipped(Polygon{loop[k], loop[(k + 1) % loop.size()]}, region)};
      if (!line.loops.front().empty()) picture_.areas.push_back(std::move(line));
    }
  }
}

}  // namespace

int pips_of_side(int side) { return side % 2 == 1 ? side / 2 + 1 : 6 - side / 2; }

Camera camera_for(std::span<const PictureBox> boxes, const Vec3& direction_w, double width,
                  double height, bool floor) {
  std::vector<Vec3> points_w;
  for (const PictureBox& b : boxes) {
    const std::array<Vec3, 8> corners_w = corners_of(b.box);
    points_w.insert(points_w.end(), corners_w.begin(), corners_w.end());
  }
  const Camera camera = camera_for(points_w, direction_w, width, height);
  if (!floor) return camera;
  // Once more, with the shadows: the lamp depends on the direction of the eye only.
  const Plane ground{};
  const Lamp lamp(Projection(camera), 1);
  for (const PictureBox& b : boxes) {
    for (const Vec2& p : shadow_of(b.box, ground, lamp.middle_w())) {
      points_w.push_back(ground.at(p));
    }
  }
  return camera_for(points_w, direction_w, width, height);
}

Picture draw_boxes(std::span<const PictureBox> boxes, const Camera& camera, bool floor,
                   std::span<const PictureBox> around) {
  const PictureScene scene = picture_scene(boxes, camera);
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    for (const Vec3& corner_w : corners_of(boxes[k].box)) {
      require::that(
          scene.view.depth(corner_w) > 0.0,
          "boxes[" + std::to_string(k) + "] reaches behind the eye: move the camera back");
    }
  }
  Painter painter(scene, camera.width, camera.height);
  if (floor) painter.paint_floor(around.empty() ? boxes : around);
  painter.paint_boxes();
  return painter.take();
}

}  // namespace tumble
