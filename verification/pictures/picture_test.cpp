/// \file
/// \brief Pictures against rays from the eye, and their cameras, shades and shadows.
#include "tumble/pictures/picture.hpp"

#include "tumble/pictures/lighting.hpp"
#include "tumble/pictures/painters_order.hpp"
#include "tumble/pictures/world_picture.hpp"

#include "geometry/boxes.hpp"
#include "support/test.hpp"

using test::Stretch;
using test::stretch_in;

namespace {

PictureBox drawn_box(const Vec3& center, const Vec3& size) {
  return {make_box(center, Quat::Identity(), size)};
}

// --- the judge: rays ----------------------------------------------------------------------------

// The line of sight of a pixel, from the definition of a perspective with a vertical picture edge.
Vec3 sight_of(const Camera& camera, const Vec2& pixel) {
  const Vec3 back = (camera.eye_w - camera.target_w).normalized();
  const Vec3 right = Vec3::UnitY().cross(back).normalized();
  const Vec3 up = back.cross(right);
  const double size = 2.0 * std::tan(0.5 * camera.field_of_view) / camera.height;  // of a pixel
  return size * (pixel.x() - 0.5 * camera.width) * right +
         size * (0.5 * camera.height - pixel.y()) * up - back;
}

bool contains(const Polygon& loop, const Vec2& p) {
  int turns = 0;  // the pixel is on the same side of all edges
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec2 a = loop[k] - p, b = loop[(k + 1) % loop.size()] - p;
    turns += a.x() * b.y() - a.y() * b.x() > 0.0 ? 1 : -1;
  }
  return static_cast<std::size_t>(std::abs(turns)) == loop.size();
}

bool contains(const PictureArea& area, const Vec2& p) {
  return std::ranges::any_of(area.loops, [&](const Polygon& loop) { return contains(loop, p); });
}

// The box whose face was painted last at a pixel.
int box_drawn_at(const Picture& picture, const Vec2& pixel) {
  int box = kNoBox;
  for (const PictureArea& area : picture.areas)
    if (area.box != kNoBox && !area.shadow && contains(area, pixel)) box = area.box;
  return box;
}

// The box that the line of sight of a pixel meets first.
int box_met_at(const std::vector<PictureBox>& boxes, const Camera& camera, const Vec2& pixel) {
  int nearest = kNoBox;
  double first = kInfinity;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    const Stretch stretch = stretch_in(boxes[b].box, camera.eye_w, sight_of(camera, pixel));
    if (stretch.empty() || stretch.enter >= first) continue;
    nearest = static_cast<int>(b);
    first = stretch.enter;
  }
  return nearest;
}

// Whether two boxes overlap so little that one may be painted as a whole after the other.
bool overlap_slightly(const Box& a, const Box& b) {
  const double distance = separation(a, b).distance;
  return distance < 0.0 && distance > -0.01 * std::min(a.half.minCoeff(), b.half.minCoeff());
}

struct Judgement {
  int pixels = 0;  // that show a box
  int wrong = 0;   // that show another one than the ray meets first
};

// Tests random pixels. At a seam, where boxes are cut by each other, either may be shown [px].
void judge(const std::vector<PictureBox>& boxes, const Camera& camera, const Picture& picture,
           int pixels, Random& random, Judgement& out, double seam = 0.0) {
  for (int k = 0; k < pixels; ++k) {
    Vec2 pixel;
    pixel.x() = random.uniform(0.0, camera.width);
    pixel.y() = random.uniform(0.0, camera.height);
    const int nearest = box_met_at(boxes, camera, pixel);
    const int drawn = box_drawn_at(picture, pixel);
    if (nearest != kNoBox) ++out.pixels;
    if (drawn == nearest) continue;
    bool allowed = drawn != kNoBox && nearest != kNoBox &&
                   overlap_slightly(boxes[idx(drawn)].box, boxes[idx(nearest)].box);
    for (int turn = 0; turn < 16 && seam > 0.0; ++turn) {
      const double angle = 2.0 * std::numbers::pi * turn / 16.0;
      const Vec2 beside = pixel + seam * Vec2(std::cos(angle), std::sin(angle));
      allowed = allowed || box_met_at(boxes, camera, beside) == drawn;
    }
    if (!allowed) ++out.wrong;
  }
}

// --- scenes -------------------------------------------------------------------------------------

// Boxes of all shapes in a cube, added if they do not overlap earlier ones.
std::vector<PictureBox> falling_boxes(Random& random, int tries) {
  std::vector<PictureBox> boxes;
  for (int k = 0; k < tries; ++k) {
    const Vec3 center = random.in_cube(3.0) + Vec3(0.0, 4.0, 0.0);
    const Quat orientation = random.orientation();
    const Vec3 size = random.in_cube(4.0).cwiseAbs().cwiseProduct(Vec3(1.0, 0.3, 0.3));
    const Box box = make_box(center, orientation, size + Vec3::Constant(0.1));
    const bool disjoint = std::ranges::all_of(
        boxes, [&](const PictureBox& other) { return separation(box, other.box).distance > 0.0; });
    if (disjoint) boxes.push_back({box});
  }
  return boxes;
}

// A built-in scene after some steps.
std::vector<PictureBox> scene_boxes(const char* name, const char* setting, int steps,
                                    std::uint64_t seed) {
  World world = build_world(make_scene(name, {setting}, seed));
  const auto technique = make_technique("basic", {"event_cap=20"}, seed);
  for (int k = 0; k < steps; ++k) technique->step(world, 1.0 / 60.0);
  return picture_boxes(world);
}

std::vector<PictureBox> scene_number(int number, Random& random) {
  const auto seed = static_cast<std::uint64_t>(number);
  switch (number % 8) {
    case 0: return scene_boxes("clump", "per_edge=3", 40, seed);  // settling
    case 1: return scene_boxes("dice", "count=20", 25, seed);     // bouncing
    case 2: return scene_boxes("pyramid", "rows=6", 0, seed);
    case 3: return scene_boxes("pyramid3d", "rows=4", 0, seed);
    case 4: return scene_boxes("wall", "bricks=3", 0, seed);
    default: return falling_boxes(random, 100);
  }
}

Camera random_camera(const std::vector<PictureBox>& boxes, Random& random) {
  Vec3 direction = random.direction();
  direction.y() = std::abs(direction.y());
  return camera_for(boxes, direction, 300.0, 200.0, true);
}

bool is_cyclic(const std::vector<Box>& boxes, const Vec3& eye_w) {
  const PaintersOrder order = painters_order(boxes, eye_w);
  return order.size() < boxes.size();
}

// Draws and checks scenes [begin, end). Returns the number of pictures with cyclic overlaps.
int check_scenes(int begin, int end, int pixels) {
  Judgement judgement;
  int with_rings = 0;
  for (int number = begin; number < end; ++number) {
    Random random = Random(7).fork(static_cast<std::uint64_t>(number));
    const std::vector<PictureBox> boxes = scene_number(number, random);
    const Camera camera = random_camera(boxes, random);
    const Picture picture = draw_boxes(boxes, camera);
    std::vector<Box> shapes;
    for (const PictureBox& b : boxes) shapes.push_back(b.box);
    if (is_cyclic(shapes, camera.eye_w)) ++with_rings;
    judge(boxes, camera, picture, pixels, random, judgement);
  }
  INFO(judgement.pixels << " pixels, " << judgement.wrong << " wrong, " << with_rings
                        << " pictures with rings");
  CHECK(judgement.wrong == 0);
  CHECK(judgement.pixels > (end - begin) * pixels / 10);
  return with_rings;
}

}  // namespace

TEST_CASE("Each pixel of a picture shows the box that the line of sight meets first",
          "[exact][picture]") {
  check_scenes(0, 24, 300);  // none has a cyclic overlap
}

TEST_CASE("Each pixel of 200 pictures shows the box that the line of sight meets first",
          "[.long][exact][picture]") {
  CHECK(check_scenes(24, 224, 5000) >= 3);  // measured 5: the scenes are hard enough
}

TEST_CASE("Boxes that overlap are drawn as the line of sight meets them", "[exact][picture]") {
  // A heap of 54 boxes that has collapsed into itself.
  Random random(11);
  std::vector<PictureBox> heap;
  for (int k = 0; k < 54; ++k) {
    const Vec3 center = random.in_cube(0.6) + Vec3(0.0, 0.6, 0.0);
    const Quat orientation = random.orientation();
    const Vec3 size = random.in_cube(0.4).cwiseAbs() + Vec3::Constant(0.3);
    heap.push_back({make_box(center, orientation, size)});
  }
  const Camera camera = camera_for(heap, Vec3(1.0, 0.6, 2.0), 600.0, 400.0, true);
  const Picture picture = draw_boxes(heap, camera);
  Judgement judgement;
  judge(heap, camera, picture, 3000, random, judgement, 0.75);
  CHECK(judgement.pixels > 500);
  CHECK(judgement.wrong == 0);
  CHECK(picture.areas.size() < 50000);  // measured 26 562: the work is bounded
}

TEST_CASE("A camera has all boxes and shadows in its picture and touches the free air on two sides",
          "[exact][picture]") {
  Failures wrong;
  for (int number = 0; number < 40; ++number) {
    Random random = Random(3).fork(static_cast<std::uint64_t>(number));
    const std::vector<PictureBox> boxes = falling_boxes(random, 20);
    const Camera camera = random_camera(boxes, random);
    const Projection view(camera);
    const Lamp lamp(view, 1);
    Polygon points;
    for (const PictureBox& b : boxes) {
      for (const Vec3& corner : corners_of(b.box)) points.push_back(view(corner));
      for (const Vec2& p : shadow_of(b.box, Plane{}, lamp.middle_w()))
        points.push_back(view(Plane{}.at(p)));
    }
    const double air = 0.06 * camera.height;  // the default of camera_for()
    Vec2 low = Vec2::Constant(kInfinity), high = -low;
    for (const Vec2& p : points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    // [px] rounding of some 1e3 px; measured 2e-12
    const double slack = 1e-9;
    const Vec2 free =
        (low - Vec2::Constant(air)).cwiseMin(Vec2(camera.width - air, camera.height - air) - high);
    if (free.minCoeff() < -slack) ++wrong["outside"];
    const Vec2 room =
        (low - Vec2::Constant(air)).cwiseMax(Vec2(camera.width - air, camera.height - air) - high);
    if (room.minCoeff() > slack) ++wrong["loose"];
  }
  CHECK(wrong == Failures{});
}

TEST_CASE(
    "Whatever the direction of the view, top, left and right of a cube have shades in this order",
    "[exact][picture]") {
  const std::vector<PictureBox> cube = {drawn_box(Vec3(0.0, 0.5, 0.0), Vec3::Ones())};
  for (const Vec3& direction : {Vec3(1.0, 0.8, 1.0), Vec3(-1.0, 0.8, 1.0), Vec3(-1.0, 0.8, -1.0)}) {
    const Camera camera = camera_for(cube, direction, 300.0, 200.0, true);
    const Picture picture = draw_boxes(cube, camera, false);
    REQUIRE(picture.areas.size() == 3);
    // Position of the face in the picture, and its brightness.
    std::vector<std::pair<double, std::uint32_t>> sides;
    std::uint32_t top = 0;
    double highest = kInfinity;
    for (const PictureArea& area : picture.areas) {
      Vec2 middle = Vec2::Zero();
      for (const Vec2& p : area.loops.front()) middle += 0.25 * p;
      const std::uint32_t green = area.colour >> 8U & 0xffU;
      sides.emplace_back(middle.x(), green);
      if (middle.y() < highest) top = green;
      highest = std::min(highest, middle.y());
    }
    std::ranges::sort(sides);
    const std::uint32_t left = sides.front().second;
    const std::uint32_t right = sides.back().second;
    CHECK(top > left + 8);  // of 255 levels; measured 23
    CHECK(left > right + 8);
  }
}

TEST_CASE("The shadow of a cube in the air lies where the light through its centre meets the floor",
          "[exact][picture]") {
  const std::vector<PictureBox> cube = {drawn_box(Vec3(1.0, 5.0, -2.0), Vec3::Ones())};
  const Camera camera = camera_for(cube, Vec3(1.0, 1.0, 2.0), 300.0, 200.0, true);
  const Projection view(camera);
  const Vec3 light = Lamp(view, 1).middle_w();
  const Vec3 center = cube[0].box.center_w;
  const Vec2 dark = view(center - center.y() / light.y() * light);
  const Vec2 lit = view(Vec3(1.0, 0.0, -2.0));  // directly below it: the lamp is far from vertical
  int layers = 0, over_dark = 0, over_lit = 0;
  double remaining = 1.0;
  for (const PictureArea& area : draw_boxes(cube, camera).areas) {
    if (!area.shadow) continue;
    ++layers;
    over_dark += contains(area, dark) ? 1 : 0;
    over_lit += contains(area, lit) ? 1 : 0;
    remaining *= 1.0 - area.opacity;
  }
  CHECK(layers == 24);
  CHECK(over_dark == layers);
  CHECK(over_lit == 0);
  // [-] all layers together have the darkness of the floor's shadow; rounding
  CHECK(1.0 - remaining == near(Lamp(view, 1).shadow_depth(Vec3::UnitY())).epsilon(1e-12));
}

TEST_CASE("A box casts its shadow on the box below and not on the one above", "[exact][picture]") {
  const std::vector<PictureBox> boxes = {drawn_box(Vec3(0.0, 0.5, 0.0), Vec3(4.0, 1.0, 4.0)),
                                         drawn_box(Vec3(0.0, 2.5, 0.0), Vec3::Ones())};
  const Picture picture =
      draw_boxes(boxes, camera_for(boxes, Vec3(1.0, 2.0, 1.0), 300.0, 200.0, true));
  int on_lower = 0, on_upper = 0;
  for (const PictureArea& area : picture.areas) {
    on_lower += area.shadow && area.box == 0 ? 1 : 0;
    on_upper += area.shadow && area.box == 1 ? 1 : 0;
  }
  CHECK(on_lower == 12);
  CHECK(on_upper == 0);
}

TEST_CASE("All that is drawn is inside the picture, also from within the scene",
          "[exact][picture]") {
  const std::vector<PictureBox> boxes = {drawn_box(Vec3(0.0, 0.5, 0.0), Vec3(40.0, 1.0, 1.0)),
                                         drawn_box(Vec3(2.0, 30.0, -40.0), Vec3(1.0, 60.0, 1.0))};
  Camera camera{.eye_w = Vec3(0.0, 2.0, 6.0), .target_w = Vec3(0.0, 1.0, 0.0)};
  const Picture picture = draw_boxes(boxes, camera);
  int outside = 0;
  for (const PictureArea& area : picture.areas) {
    for (const Polygon& loop : area.loops) {
      for (const Vec2& p : loop) {
        // [px] rounding of a cut edge that is 1e4 px long; measured 2e-12
        if (!(p.minCoeff() > -1e-6 && p.x() < camera.width + 1e-6 && p.y() < camera.height + 1e-6))
          ++outside;
      }
    }
  }
  CHECK(picture.areas.size() > 20);
  CHECK(outside == 0);
}

TEST_CASE("The floor is left out when the eye is below it or nothing stands on it",
          "[unit][picture]") {
  const std::vector<PictureBox> cube = {drawn_box(Vec3(0.0, 0.5, 0.0), Vec3::Ones())};
  const auto floor_areas = [&](const Camera& camera, const std::vector<PictureBox>& boxes) {
    const Picture picture = draw_boxes(boxes, camera);
    return std::ranges::count_if(picture.areas,
                                 [](const PictureArea& area) { return area.box == kNoBox; });
  };
  CHECK(floor_areas(camera_for(cube, Vec3(1.0, 1.0, 1.0), 300.0, 200.0, true), cube) > 0);
  CHECK(floor_areas(camera_for(cube, Vec3(1.0, -1.0, 1.0), 300.0, 200.0, false), cube) == 0);
  CHECK(floor_areas(Camera{}, {}) == 0);
  const std::vector<PictureBox> sunk = {drawn_box(Vec3(0.0, -2.0, 0.0), Vec3::Ones())};
  CHECK(floor_areas(Camera{}, sunk) == 0);
}

TEST_CASE("Opposite sides of a die have seven pips together", "[unit][picture]") {
  std::set<int> all;
  for (int side = 0; side < 6; ++side) all.insert(pips_of_side(side));
  CHECK(all == std::set<int>{1, 2, 3, 4, 5, 6});
  for (int axis = 0; axis < 3; ++axis)
    CHECK(pips_of_side(2 * axis) + pips_of_side(2 * axis + 1) == 7);
  CHECK(pips_of_side(3) == 2);  // +y

  std::vector<PictureBox> die = {drawn_box(Vec3(0.0, 0.5, 0.0), Vec3::Ones())};
  die[0].die = true;
  const Picture picture = draw_boxes(die, camera_for(die, Vec3(0.1, 1.0, 0.0), 300.0, 200.0, true));
  std::size_t most = 0;
  for (const PictureArea& area : picture.areas)
    if (area.box == 0 && !area.outlined) most = std::max(most, area.loops.size());
  CHECK(most == 2);  // from above, the upper side is visible, and a sliver of the side with one
}

TEST_CASE("gnuplot and SVG get every area, in finite numbers", "[unit][picture]") {
  const std::vector<PictureBox> cube = {drawn_box(Vec3(0.0, 0.5, 0.0), Vec3::Ones())};
  const Picture picture =
      draw_boxes(cube, camera_for(cube, Vec3(1.0, 1.0, 2.0), 300.0, 200.0, true));
  const auto count = [](const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
      ++found;
    return found;
  };
  const std::string commands = to_gnuplot(picture);
  CHECK(count(commands, "\nset object ") == picture.areas.size());
  CHECK(commands.find("set object 2 ") <
        commands.find("set object 1 "));  // quick for gnuplot to read
  CHECK(count(commands, "transparent") == 24);
  CHECK(count(commands, "border lc") == 3);
  CHECK_THAT(commands, Contains("set xrange [0:300]; set yrange [0:200]") && !Contains("nan"));
  const std::string svg = to_svg(picture);
  CHECK(count(svg, "<path ") == picture.areas.size());
  CHECK(count(svg, "stroke=\"#") == 3);
  CHECK_THAT(svg, Contains("viewBox=\"0 0 300 200\"") && !Contains("nan"));
}

TEST_CASE("Cameras and pictures refuse invalid input", "[unit][picture]") {
  const std::vector<PictureBox> cube = {drawn_box(Vec3(0.0, 0.5, 0.0), Vec3::Ones())};
  const auto camera = [&](const Vec3& direction, double width, double height) {
    return camera_for(cube, direction, width, height, true);
  };
  CHECK_THROWS_WITH(camera_for(std::vector<PictureBox>{}, Vec3::Ones(), 300.0, 200.0, true),
                    Contains("no points"));
  CHECK_THROWS_WITH(camera(Vec3::UnitY(), 300.0, 200.0), Contains("vertical"));
  CHECK_THROWS_WITH(camera(Vec3::Zero(), 300.0, 200.0), Contains("vertical"));
  CHECK_THROWS_AS(camera(Vec3(kNan, 0.0, 1.0), 300.0, 200.0), std::invalid_argument);
  CHECK_THROWS_WITH(camera(Vec3::Ones(), 0.0, 200.0), Contains("width"));
  CHECK_THROWS_WITH(camera(Vec3::Ones(), 300.0, -1.0), Contains("height"));
  CHECK_THROWS_WITH(camera(Vec3::Ones(), 10.0, 200.0), Contains("free air"));
  const std::vector<Vec3> one_point = {Vec3::Ones()};
  CHECK_THROWS_WITH(camera_for(one_point, Vec3::Ones(), 300.0, 200.0), Contains("points_w"));
  CHECK_THROWS_WITH(camera_for(one_point, Vec3::Ones(), 300.0, 200.0, 0.5), Contains("air"));

  Camera inside = camera(Vec3::Ones(), 300.0, 200.0);
  inside.eye_w = Vec3(0.1, 0.5, 0.2);
  CHECK_THROWS_WITH(draw_boxes(cube, inside), Contains("boxes[0] reaches behind the eye"));
  inside.eye_w = Vec3(5.0, 0.5, 0.2);
  inside.target_w = Vec3(9.0, 0.5, 0.2);
  CHECK_THROWS_WITH(draw_boxes(cube, inside), Contains("behind the eye"));
  inside.target_w = inside.eye_w;
  CHECK_THROWS_AS(draw_boxes(cube, inside), std::invalid_argument);
  inside = camera(Vec3::Ones(), 300.0, 200.0);
  inside.field_of_view = 3.2;
  CHECK_THROWS_WITH(draw_boxes(cube, inside), Contains("field_of_view"));
}
