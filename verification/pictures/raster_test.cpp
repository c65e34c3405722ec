/// \file
/// \brief Pictures as pixels, digits in them, and films.
#include "tumble/pictures/raster.hpp"

#include "tumble/pictures/film.hpp"
#include "tumble/pictures/lettering.hpp"

#include "support/test.hpp"

namespace {

std::array<int, 3> pixel(const Raster& raster, int x, int y) {
  const auto at = static_cast<std::size_t>(3 * (y * raster.width + x));
  return {raster.rgb[at], raster.rgb[at + 1], raster.rgb[at + 2]};
}

Polygon rectangle(double left, double top, double right, double bottom) {
  return {Vec2(left, top), Vec2(right, top), Vec2(right, bottom), Vec2(left, bottom)};
}

Picture picture_of(std::vector<Polygon> loops, std::uint32_t colour, double opacity) {
  PictureArea area{.loops = std::move(loops), .colour = colour, .opacity = opacity};
  return Picture{.width = 8.0, .height = 6.0, .areas = {area}};
}

Film film_of_a_fall() {
  std::vector<FilmFrame> frames;
  for (int k = 0; k < 4; ++k)
    frames.push_back(
        {0.1 * k, {{make_box(Vec3(0.0, 3.0 - 0.5 * k, 0.0), Quat::Identity(), Vec3::Ones())}}});
  return film_of(std::move(frames), Vec3(0.5, 0.4, 1.0), 120, 80, true);
}

}  // namespace

TEST_CASE("A partly covered pixel is blended by the covered share", "[exact][picture]") {
  const std::array<int, 3> white = {255, 255, 255};
  // From the middle of pixel 1 to a quarter of pixel 5, from row 1 to row 2: 16 points resolve halves
  // and quarters exactly.
  const Raster half = rasterised(picture_of({rectangle(1.5, 1.0, 5.25, 3.0)}, 0x000000, 1.0));
  CHECK(half.width == 8);
  CHECK(half.height == 6);
  CHECK(half.rgb.size() == 3 * 8 * 6);
  CHECK(pixel(half, 0, 1) == white);
  CHECK(pixel(half, 1, 1) == std::array<int, 3>{128, 128, 128});  // 127.5, rounded up
  CHECK(pixel(half, 2, 1) == std::array<int, 3>{0, 0, 0});
  CHECK(pixel(half, 5, 2) == std::array<int, 3>{191, 191, 191});
  CHECK(pixel(half, 6, 2) == white);
  CHECK(pixel(half, 2, 0) == white);
  CHECK(pixel(half, 2, 3) == white);
  // Overlapping polygons darken once, in any sense of rotation; opacity blends in the same way.
  Polygon turned = rectangle(2.0, 0.0, 7.0, 6.0);
  std::ranges::reverse(turned);
  const Raster both =
      rasterised(picture_of({rectangle(0.0, 0.0, 5.0, 6.0), turned}, 0xff0000, 0.4));
  CHECK(pixel(both, 1, 3) == std::array<int, 3>{255, 153, 153});
  CHECK(pixel(both, 3, 3) == pixel(both, 1, 3));
  CHECK(pixel(both, 6, 3) == pixel(both, 1, 3));
  CHECK(pixel(both, 7, 3) == white);
}

TEST_CASE("Areas outside a picture are not painted, and its size is checked", "[unit][picture]") {
  const Raster all = rasterised(picture_of({rectangle(-50.0, -9.0, 90.0, 70.0)}, 0x102030, 1.0));
  for (const int x : {0, 7})
    for (const int y : {0, 5}) CHECK(pixel(all, x, y) == std::array<int, 3>{0x10, 0x20, 0x30});
  const Raster none = rasterised(picture_of({rectangle(9.0, 0.0, 12.0, 6.0)}, 0, 1.0));
  CHECK(std::ranges::count(none.rgb, 255) == 3 * 8 * 6);
  // Two points are a line: it has an outline and no inside.
  Picture line = picture_of({{Vec2(1.0, 2.5), Vec2(7.0, 2.5)}}, 0xff0000, 1.0);
  CHECK(pixel(rasterised(line), 4, 2) == std::array<int, 3>{255, 255, 255});
  line.areas.front().outlined = true;
  CHECK(pixel(rasterised(line), 4, 2)[0] < 100);
  line.width = 0.0;
  CHECK_THROWS_WITH(rasterised(line), Contains("width of the picture"));
  CHECK_THROWS_WITH(beside(Raster{1, 1, {0, 0, 0}}, Raster{1, 2, {0, 0, 0, 0, 0, 0}}),
                    Contains("heights 1 and 2"));
  const Raster two = beside(none, all);
  CHECK(two.width == 16);
  CHECK(pixel(two, 7, 5) == std::array<int, 3>{255, 255, 255});
  CHECK(pixel(two, 8, 5) == std::array<int, 3>{0x10, 0x20, 0x30});
}

TEST_CASE("Each digit has its own strokes, and an unknown character is refused",
          "[unit][picture]") {
  std::set<std::string> looks;
  for (const char sign : std::string("0123456789.- s")) {
    Picture picture = picture_of({}, 0, 1.0);
    picture.width = picture.height = 16.0;
    picture.areas = {lettering(std::string(1, sign), Vec2(3.0, 3.0), 10.0, 0)};
    const Raster raster = rasterised(picture);
    looks.emplace(raster.rgb.begin(), raster.rgb.end());
    // No stroke leaves the cell of its letter by more than half its width.
    CHECK(pixel(raster, 1, 8) == std::array<int, 3>{255, 255, 255});
    CHECK(pixel(raster, 8, 1) == std::array<int, 3>{255, 255, 255});
    CHECK(pixel(raster, 8, 14) == std::array<int, 3>{255, 255, 255});
  }
  CHECK(looks.size() == 14);
  CHECK_THROWS_WITH(lettering("1.5 m", Vec2::Zero(), 10.0, 0), Contains("lettering of 'm'"));
  CHECK_THROWS_AS(lettering("1", Vec2::Zero(), 0.0, 0), std::invalid_argument);
}

TEST_CASE("All frames of a film are seen by one camera and have their time in a corner",
          "[unit][picture]") {
  const Film film = film_of_a_fall();
  const FilmPainter painter(film);
  std::set<std::string> corners;
  for (int k = 0; k < 4; ++k) {
    const Raster raster = painter.painted(k);
    CHECK(raster.width == 120);
    CHECK(raster.height == 80);
    std::vector<std::uint8_t> corner;
    for (int y = 8; y < 20; ++y)
      for (int x = 8; x < 50; ++x)
        corner.push_back(static_cast<std::uint8_t>(pixel(raster, x, y)[1]));
    CHECK(std::ranges::count_if(corner, [](int c) { return c < 0x60; }) > 20);
    corners.emplace(corner.begin(), corner.end());
    // The floor is the same in each frame, wherever the box is.
    CHECK(pixel(raster, 100, 70) == pixel(painter.painted(0), 100, 70));
  }
  CHECK(corners.size() == 4);
  CHECK_THROWS_WITH(painter.painted(4), Contains("the film has 4"));
  CHECK_THROWS_WITH(painter.painted(-1), Contains("frame -1"));
  CHECK(film_delays(film, 25.0) == std::vector<int>{4, 4, 4, 104});
}
