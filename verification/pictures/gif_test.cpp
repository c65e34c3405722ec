/// \file
/// \brief GIF files read back by stb_image.
#include "tumble/pictures/gif.hpp"

#include "tumble/pictures/palette.hpp"

#include "support/test.hpp"

#if __has_include(<stb/stb_image.h>)
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_GIF
#include <stb/stb_image.h>
#else
#define NO_READER
#endif

namespace {

Raster plain(int width, int height, int grey) {
  return {width, height,
          std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height),
                                    static_cast<std::uint8_t>(grey))};
}

#ifndef NO_READER
// A GIF as a viewer shows it: each frame is the picture displayed after it.
struct ShownGif {
  explicit ShownGif(const std::string& bytes) {
    std::vector<stbi_uc> file(bytes.begin(), bytes.end());
    int* times = nullptr;
    int count = 0, channels = 0;
    stbi_uc* pixels = stbi_load_gif_from_memory(file.data(), static_cast<int>(file.size()), &times,
                                                &width, &height, &count, &channels, 3);
    REQUIRE(pixels != nullptr);
    delays.assign(times, times + count);
    const auto size = static_cast<std::size_t>(3 * width * height);
    for (std::size_t k = 0; k < delays.size(); ++k)
      frames.emplace_back(pixels + k * size, pixels + (k + 1) * size);
    stbi_image_free(pixels);
    stbi_image_free(times);
  }
  int width = 0, height = 0;
  std::vector<int> delays;                        // [ms] of each frame
  std::vector<std::vector<std::uint8_t>> frames;  // colours
};
#endif

}  // namespace

#ifndef NO_READER
TEST_CASE("A GIF that is read back has the pixels that were written", "[exact][picture]") {
  // Noise of 200 colours is the worst case: the dictionary fills and is cleared many times.
  Random random(5);
  std::vector<Raster> written;
  for (int k = 0; k < 5; ++k) {
    Raster raster = k == 0 ? plain(160, 90, 255) : written.back();
    const int rows = k == 3 ? 0 : 20 + 15 * k;  // frame 3 is like the one before
    for (int y = 10; y < std::min(rows, 90); ++y) {
      for (int x = 5 * k; x < 150; ++x) {
        const auto colour = static_cast<std::uint8_t>(random.uniform(0.0, 200.0));
        for (int c = 0; c < 3; ++c)
          raster.rgb[static_cast<std::size_t>(3 * (y * 160 + x) + c)] =
              static_cast<std::uint8_t>(c == 1 ? 255 - colour : colour);
      }
    }
    written.push_back(raster);
  }
  const std::vector<int> delays = {4, 3, 300, 1, 65535};
  const auto frame = [&](int k) { return written.at(idx(k)); };
  const std::string bytes = to_gif(delays, frame);
  CHECK(bytes == to_gif(delays, frame));
  CHECK(Contains(std::string("NETSCAPE2.0\x03\x01\0\0", 15)).match(bytes));  // for ever
  const ShownGif shown(bytes);
  CHECK(shown.width == 160);
  CHECK(shown.height == 90);
  REQUIRE(shown.frames.size() == 5);
  for (std::size_t k = 0; k < 5; ++k) {
    INFO(k);
    CHECK(shown.delays[k] == 10 * delays[k]);
    CHECK(shown.frames[k] == written[k].rgb);
  }
}
#endif

TEST_CASE("A frame that does not differ takes a few bytes", "[unit][picture]") {
  const auto size = [](int frames) {
    return to_gif(std::vector<int>(idx(frames), 4), [](int) { return plain(400, 300, 9); }).size();
  };
  CHECK(size(11) - size(1) < 300);
#ifndef NO_READER
  // The end of the code stream: every length of a row of equal pixels, and so every length of the last code.
  for (int width = 1; width < 600; ++width)
    CHECK(ShownGif(to_gif(std::vector<int>{4}, [&](int) {
            return plain(width, 3, 7);
          })).frames.at(0) == plain(width, 3, 7).rgb);
#endif
}

TEST_CASE("A palette keeps colours that are few and the most frequent ones of many",
          "[unit][picture]") {
  ColourCount few;
  few.add(plain(3, 3, 8));
  few.add(plain(2, 2, 255));
  few.add(plain(1, 1, 8));
  CHECK(few.chosen(255) == std::vector<std::uint32_t>{0x080808, 0xffffff});
  CHECK(few.chosen(1) == std::vector<std::uint32_t>{0x080808});
  CHECK_THROWS_AS(ColourCount().chosen(4), std::invalid_argument);
  CHECK_THROWS_AS(few.chosen(0), std::invalid_argument);

  // A gradient of 256 shades and two flat colours, represented by 16 colours.
  ColourCount many;
  for (int grey = 0; grey < 256; ++grey) many.add(plain(1, 1, grey));
  many.add(plain(40, 40, 200));
  many.add(plain(40, 40, 203));
  const std::vector<std::uint32_t> chosen = many.chosen(16);
  CHECK(chosen.size() == 16);
  Palette palette(chosen);
  const auto shown = [&](std::uint32_t grey) {
    return palette.colours()[palette.nearest(grey * 0x010101U)];
  };
  CHECK(shown(200) == 0xc8c8c8);
  CHECK(shown(203) == 0xcbcbcb);
  for (std::uint32_t grey = 0; grey < 256; ++grey) {
    const auto got = static_cast<int>(shown(grey) & 0xffU);
    // [levels] 14 shades for 256 leave cells of 19 and their most frequent colour, the first, at an end.
    CHECK(std::abs(got - static_cast<int>(grey)) <= 40);
  }
  CHECK_THROWS_AS(Palette({}), std::invalid_argument);
}

TEST_CASE("Delays keep a rate on the average", "[unit][picture]") {
  const std::vector<int> delays = gif_delays(30, 30.0, 1.5);
  CHECK(std::accumulate(delays.begin(), delays.end(), 0) == 100 + 150);
  CHECK(std::set<int>(delays.begin(), delays.end() - 1) == std::set<int>{3, 4});
  CHECK(gif_delays(2, 50.0, 0.0) == std::vector<int>{2, 2});
  CHECK_THROWS_WITH(gif_delays(2, 60.0, 0.0), Contains("frames per second of a GIF"));
  CHECK_THROWS_AS(gif_delays(0, 25.0, 0.0), std::invalid_argument);
  CHECK_THROWS_AS(gif_delays(2, 25.0, -1.0), std::invalid_argument);
  const auto frame = [](int k) { return plain(k == 2 ? 5 : 4, 4, 0); };
  CHECK_THROWS_WITH(to_gif(std::vector<int>{}, frame), Contains("no frames"));
  CHECK_THROWS_WITH(to_gif(std::vector<int>{4, 0}, frame), Contains("delay of a frame"));
  CHECK_THROWS_WITH(to_gif(std::vector<int>(3, 4), frame), Contains("size of the first"));
}
