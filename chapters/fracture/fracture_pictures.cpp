/// \file
/// \brief Triangles sorted from back to front.
#include "fracture/fracture_pictures.hpp"

#include "tumble/base/number_text.hpp"
#include "tumble/fracture/outside.hpp"
#include "tumble/pictures/gif.hpp"
#include "tumble/pictures/lettering.hpp"
#include "tumble/pictures/lighting.hpp"
#include "tumble/pictures/picture_parts.hpp"
#include "tumble/pictures/raster.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tumble::chapters {
namespace {

constexpr std::uint32_t kOutside = 0x3d7fb5;
constexpr std::uint32_t kInside = 0xf0c27a;  // of a crack
constexpr std::uint32_t kAround = 0x9a9a9a;
constexpr std::uint32_t kShade = 0x14141f;
constexpr std::uint32_t kLetters = 0x202020;
constexpr double kShadeOpacity = 0.3;
constexpr double kNearFace = 1e-6;   // [-] of the size: on the outside of the box at rest
constexpr double kTooThin = 0.02;    // [px²] not seen
constexpr double kPauseAtEnd = 1.0;  // [s]

bool was_outside(const ElasticMesh& mesh, const OutsideFace& face, const Vec3& size) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-0.5, 0.5})
      if (std::ranges::all_of(face.nodes, [&](int node) {
            return std::abs(mesh.nodes[idx(node)].rest[axis] - side * size[axis]) <
                   kNearFace * size[axis];
          }))
        return true;
  return false;
}

// Faces of a box as parts, with a colour for each.
void add_box(const PictureBox& box, std::vector<FacePart>& parts,
             std::vector<std::uint32_t>& colours) {
  static constexpr std::array<std::array<int, 4>, 6> faces{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (int side = 0; side < 6; ++side) {
    FacePart part;
    for (const int corner : faces[idx(side)]) part.corners_w.push_back(corner_of(box.box, corner));
    part.normal_w = (side % 2 == 0 ? -1.0 : 1.0) * box.box.axes_w.col(side / 2);
    parts.push_back(part);
    colours.push_back(box.colour);
  }
}

}  // namespace

FractureFrame frame_of(const Fracture& scene, const Vec3& size, double time) {
  FractureFrame frame{.time = time};
  const ElasticMesh& mesh = scene.mesh();
  for (const OutsideFace& face : outside_of(mesh)) {
    FacePart part;
    for (const int node : face.nodes) part.corners_w.push_back(mesh.nodes[idx(node)].position_w);
    const Vec3 across =
        (part.corners_w[1] - part.corners_w[0]).cross(part.corners_w[2] - part.corners_w[0]);
    if (across.norm() <= 0.0) continue;
    part.normal_w = across.normalized();
    frame.faces.push_back(part);
    frame.colours.push_back(was_outside(mesh, face, size) ? kOutside : kInside);
  }
  const World& rigid = scene.rigid();
  for (std::size_t k = 0; k < rigid.bodies().size(); ++k)
    if (rigid.bodies()[k].shape == Shape::box)
      frame.boxes.push_back({box_of(rigid.bodies()[k], rigid.states()[k]), kAround});
  return frame;
}

Picture drawn(const FractureFrame& frame, const Camera& camera,
              std::span<const PictureBox> around) {
  const PictureScene scene = picture_scene(frame.boxes, camera);
  Picture picture{.width = camera.width, .height = camera.height};
  const Polygon window{Vec2(0.0, 0.0), Vec2(camera.width, 0.0), Vec2(camera.width, camera.height),
                       Vec2(0.0, camera.height)};
  const auto add = [&](PictureArea area) {
    double size = 0.0;
    for (Polygon& loop : area.loops) {
      loop = clipped(loop, window);
      size += std::abs(area_of(loop));
    }
    std::erase_if(area.loops, [](const Polygon& loop) { return loop.size() < 3; });
    if (size > kTooThin) picture.areas.push_back(std::move(area));
  };
  for (const PictureArea& area : floor_areas(scene, around)) add(area);
  // The shadow of the triangles that the lamp sees, by one lamp.
  PictureArea shade{.colour = kShade, .opacity = kShadeOpacity, .shadow = true};
  const Vec3 light_w = scene.lamp.middle_w();
  for (const FacePart& part : frame.faces) {
    if (part.normal_w.dot(light_w) <= 0.0) continue;
    Polygon loop;
    for (const Vec3& corner_w : part.corners_w) {
      Vec3 on_floor = corner_w - corner_w.y() / light_w.y() * light_w;
      loop.push_back(scene.view(on_floor));
    }
    loop = convex_hull(std::move(loop));
    if (loop.size() > 2) shade.loops.push_back(std::move(loop));
  }
  if (!shade.loops.empty()) add(shade);
  // What faces the eye, from back to front.
  std::vector<FacePart> parts = frame.faces, seen;
  std::vector<std::uint32_t> colours = frame.colours, shown;
  for (const PictureBox& box : frame.boxes) add_box(box, parts, colours);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k].normal_w.dot(camera.eye_w - parts[k].corners_w.front()) <= 0.0) continue;
    parts[k].face = static_cast<int>(shown.size());
    shown.push_back(scene.lamp.shade(colours[k], parts[k].normal_w));
    seen.push_back(parts[k]);
  }
  const std::vector<FacePart> sorted = back_to_front(std::move(seen));
  for (const FacePart& part : sorted) {
    PictureArea area{.colour = shown[idx(part.face)]};
    area.outline = area.colour;  // so that no gap is seen between triangles
    area.outlined = true;
    Polygon loop;
    for (const Vec3& corner_w : part.corners_w) loop.push_back(scene.view(corner_w));
    area.loops = {convex_hull(std::move(loop))};
    add(area);
  }
  return picture;
}

std::string film_of(const std::vector<FractureFrame>& frames, const Camera& camera,
                    std::span<const PictureBox> around, double rate) {
  const std::vector<int> delays = gif_delays(static_cast<int>(frames.size()), rate, kPauseAtEnd);
  return to_gif(delays, [&](int k) {
    const FractureFrame& frame = frames[idx(k)];
    Picture picture = drawn(frame, camera, around);
    const double letter = 0.05 * camera.height;
    picture.areas.push_back(
        lettering(fixed_text(frame.time, 3) + " s", Vec2(letter, letter), letter, kLetters));
    return rasterised(picture);
  });
}

}  // namespace tumble::chapters
