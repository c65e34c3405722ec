/// \file
/// \brief GIF files read back by a decoder written from the specification alone.
#include "tumble/pictures/gif.hpp"

#include "tumble/base/random.hpp"
#include "tumble/pictures/palette.hpp"

#include "support/catch.hpp"

using namespace tumble;

namespace {

// Decodes a GIF as a viewer does: each frame is the picture displayed after it.
class GifReader {
 public:
  struct Frame {
    int delay = 0;  // [1/100 s]
    std::vector<std::uint8_t> rgb;
  };

  explicit GifReader(std::string bytes) : bytes_(std::move(bytes)) {
    expect(bytes_.substr(0, 6) == "GIF89a", "signature");
    at_ = 6;
    width = word();
    height = word();
    const int flags = byte();
    at_ += 2;
    expect((flags & 0x80) != 0, "a palette for all frames");
    palette_ = bytes_.substr(at_, 3U << ((flags & 7) + 1));
    at_ += palette_.size();
    screen_.assign(static_cast<std::size_t>(3 * width * height), 0x77);
    for (int mark = byte(); mark != ';'; mark = byte()) {
      if (mark == 0x21) {
        extension();
      } else {
        expect(mark == ',', "a frame");
        frame();
      }
    }
    expect(at_ == bytes_.size(), "nothing after the end");
  }

  int width = 0, height = 0;
  bool for_ever = false;
  std::vector<Frame> frames;

 private:
  static void expect(bool good, const char* what) {
    if (!good) throw std::runtime_error(std::string("GIF: expected ") + what);
  }
  int byte() {
    expect(at_ < bytes_.size(), "more bytes");
    return static_cast<unsigned char>(bytes_[at_++]);
  }
  int word() {
    const int low = byte();
    return low + 256 * byte();
  }
  std::string blocks() {
    std::string out;
    for (int size = byte(); size > 0; size = byte()) {
      out += bytes_.substr(at_, static_cast<std::size_t>(size));
      at_ += static_cast<std::size_t>(size);
    }
    return out;
  }
  void extension() {
    const int label = byte();
    const std::string data = blocks();
    if (label == 0xff) for_ever = data == std::string("NETSCAPE2.0\x01\0\0", 14);
    if (label != 0xf9) return;
    expect(data.size() == 4 && data[0] == 5, "a frame that is laid over the one before");
    delay_ = static_cast<unsigned char>(data[1]) + 256 * static_cast<unsigned char>(data[2]);
    clear_ = static_cast<unsigned char>(data[3]);
  }
  void frame() {
    const int left = word(), top = word(), wide = word(), high = word();
    expect(byte() == 0, "no palette of its own");
    expect(left + wide <= width && top + high <= height && wide > 0 && high > 0, "a part");
    const std::vector<int> numbers = unpacked(byte());
    expect(static_cast<int>(numbers.size()) == wide * high, "all pixels of the part");
    for (int k = 0; k < wide * high; ++k) {
      const int number = numbers[static_cast<std::size_t>(k)];
      if (number == clear_) continue;
      const int place = (top + k / wide) * width + left + k % wide;
      for (int c = 0; c < 3; ++c)
        screen_[static_cast<std::size_t>(3 * place + c)] =
            static_cast<std::uint8_t>(palette_[static_cast<std::size_t>(3 * number + c)]);
    }
    frames.push_back({delay_, screen_});
  }
  // Appendix F of the specification: codes of growing length, a table that both sides build.
  std::vector<int> unpacked(int bits) {
    const std::string data = blocks();
    const int clear = 1 << bits;
    std::vector<std::vector<int>> table;
    const auto reset = [&] {
      table.clear();
      for (int k = 0; k < clear + 2; ++k) table.push_back({k});
    };
    std::vector<int> out;
    std::size_t bit = 0;
    int length = bits + 1;
    int before = -1;
    while (true) {
      int code = 0;
      for (int k = 0; k < length; ++k, ++bit) {
        expect(bit / 8 < data.size(), "a code for the end");
        code |= (static_cast<unsigned char>(data[bit / 8]) >> (bit % 8) & 1) << k;
      }
      if (code == clear) {
        reset();
        length = bits + 1;
        before = -1;
        continue;
      }
      if (code == clear + 1) return out;
      const auto at = static_cast<std::size_t>(code);
      if (before >= 0) {
        const std::vector<int> last = table[static_cast<std::size_t>(before)];
        expect(at <= table.size(), "a code that is known");
        table.push_back(last);
        table.back().push_back(at < table.size() - 1 ? table[at].front() : last.front());
        if (table.size() == std::size_t{1} << length && length < 12) ++length;
      }
      expect(at < table.size(), "a code that is known");
      out.insert(out.end(), table[at].begin(), table[at].end());
      before = code;
    }
  }

  std::string bytes_, palette_;
  std::size_t at_ = 0;
  int delay_ = 0, clear_ = -1;
  std::vector<std::uint8_t> screen_;
};

Raster plain(int width, int height, int grey) {
  return {width, height,
          std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height),
                                    static_cast<std::uint8_t>(grey))};
}

}  // namespace

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
  const auto frame = [&](int k) { return written.at(static_cast<std::size_t>(k)); };
  const std::string bytes = to_gif(delays, frame);
  CHECK(bytes == to_gif(delays, frame));
  const GifReader read(bytes);
  CHECK(read.width == 160);
  CHECK(read.height == 90);
  CHECK(read.for_ever);
  REQUIRE(read.frames.size() == 5);
  for (std::size_t k = 0; k < 5; ++k) {
    INFO(k);
    CHECK(read.frames[k].delay == delays[k]);
    CHECK(read.frames[k].rgb == written[k].rgb);
  }
}

TEST_CASE("A frame that does not differ takes a few bytes", "[unit][picture]") {
  const auto size = [](int frames) {
    return to_gif(std::vector<int>(static_cast<std::size_t>(frames), 4),
                  [](int) { return plain(400, 300, 9); })
        .size();
  };
  CHECK(size(11) - size(1) < 300);
  // The end of the code stream: every length of a row of equal pixels, and so every length of the last code.
  for (int width = 1; width < 600; ++width)
    CHECK(GifReader(to_gif(std::vector<int>{4}, [&](int) { return plain(width, 3, 7); }))
              .frames.at(0)
              .rgb == plain(width, 3, 7).rgb);
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
