/// \file
/// \brief Painter's order of areas, and clipping.
#include "tumble/pictures/picture.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/pictures/lighting.hpp"
#include "tumble/pictures/painters_order.hpp"
#include "tumble/pictures/picture_parts.hpp"

#include <array>
#include <cmath>

namespace tumble {
namespace {

constexpr double kTooSmall = 0.02;  // [px²] an invisible area
constexpr double kSeam = 0.5;  // [px] parts of a face overlap, so that no gap is seen between them

// Adds areas to a picture in painter's order.
class Painter {
 public:
  Painter(const PictureScene& scene, double width, double height);
  void paint_floor(std::span<const PictureBox> around);
  void paint_boxes();
  Picture take() { return std::move(picture_); }

 private:
  void paint_together(const std::vector<int>& boxes);
  void add(const PictureArea& area, const Polygon& region);

  const PictureScene& scene_;
  Polygon frame_;  // [px] in the sense of rotation of convex_hull()
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
  std::vector<Box> shapes;
  for (const PictureBox& b : scene_.boxes) shapes.push_back(b.box);
  for (const std::vector<int>& group : painters_order(shapes, scene_.eye_w)) {
    if (group.size() > 1) {
      paint_together(group);
      continue;
    }
    for (const PictureFace& face : visible_faces(scene_, idx(group.front()))) {
      for (const PictureArea& area : face.areas) add(area, frame_);
    }
  }
}

// Paints boxes none of which can be first: their faces are cut by each other.
void Painter::paint_together(const std::vector<int>& boxes) {
  std::vector<PictureFace> faces;
  std::vector<FacePart> parts;
  for (const int box : boxes) {
    for (PictureFace& face : visible_faces(scene_, idx(box))) {
      face.whole.face = static_cast<int>(faces.size());
      parts.push_back(face.whole);
      faces.push_back(std::move(face));
    }
  }
  for (const FacePart& part : back_to_front(std::move(parts))) {
    Polygon outline;  // [px]
    for (const Vec3& corner_w : part.corners_w) outline.push_back(scene_.view(corner_w));
    outline = convex_hull(std::move(outline));
    if (std::abs(area_of(outline)) < kTooSmall) continue;
    for (const PictureArea& area : faces[idx(part.face)].areas) {
      // Shadows are transparent: where two of their parts overlapped, there would be a darker line.
      const double room = area.shadow ? 0.0 : kSeam;
      add(area, part.cut ? clipped(frame_, outline, room) : frame_);
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
    for (const Vec2& p : shadow_of(b.box, ground, lamp.middle_w()))
      points_w.push_back(ground.at(p));
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
