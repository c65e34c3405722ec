/// \file
/// \brief GIF: differences of frames, compressed by the method of Lempel, Ziv and Welch.
#include "tumble/pictures/gif.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/pictures/palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tumble {
namespace {

constexpr int kStays = kGifColours;  // the index of an unchanged pixel
constexpr int kSampledFrames = 8;    // for the palette
constexpr unsigned kLetterBits = 8;  // of a pixel
constexpr unsigned kMostBits = 12;   // of a code
constexpr int kClear = 1 << kLetterBits;
constexpr int kEnd = kClear + 1;
constexpr std::size_t kBlock = 255;  // bytes

void add_byte(std::string& out, int value) { out += static_cast<char>(value & 0xff); }

void add_word(std::string& out, int value) {
  add_byte(out, value);
  add_byte(out, value >> 8);
}

// Codes of growing length, packed into bytes from the lowest bit on.
class Codes {
 public:
  void add(int code, unsigned bits) {
    waiting_ |= static_cast<std::uint32_t>(code) << count_;
    count_ += bits;
    for (; count_ >= 8; count_ -= 8, waiting_ >>= 8U) bytes_ += static_cast<char>(waiting_ & 0xffU);
  }
  // The bytes in blocks, each with its length before it, and an empty one at the end.
  std::string blocks() {
    if (count_ > 0) bytes_ += static_cast<char>(waiting_ & 0xffU);
    std::string out;
    for (std::size_t at = 0; at < bytes_.size(); at += kBlock) {
      const std::string part = bytes_.substr(at, kBlock);
      add_byte(out, static_cast<int>(part.size()));
      out += part;
    }
    return out + '\0';
  }

 private:
  std::string bytes_;
  std::uint32_t waiting_ = 0;
  unsigned count_ = 0;
};

// The dictionary of pixel sequences: the children of a code are a list.
class Words {
 public:
  // The code of a known sequence with one more pixel; -1 if that is new, and then gets the next code.
  int child_or_add(int code, std::uint8_t pixel) {
    for (int k = first_[idx(code)]; k >= 0; k = next_[idx(k)])
      if (pixel_[idx(k)] == pixel) return k;
    next_[idx(count_)] = first_[idx(code)];
    first_[idx(count_)] = -1;
    pixel_[idx(count_)] = pixel;
    first_[idx(code)] = count_++;
    return -1;
  }
  void clear() {
    std::fill(first_.begin(), first_.begin() + kClear, -1);
    count_ = kEnd + 1;
  }
  // The latest code.
  [[nodiscard]] int last() const { return count_ - 1; }

 private:
  std::array<int, 1U << kMostBits> first_{}, next_{};
  std::array<std::uint8_t, 1U << kMostBits> pixel_{};
  int count_ = 0;
};

std::string packed(const std::vector<std::uint8_t>& pixels) {
  Codes codes;
  Words words;
  words.clear();
  unsigned bits = kLetterBits + 1;
  codes.add(kClear, bits);
  int code = pixels.front();
  for (std::size_t k = 1; k < pixels.size(); ++k) {
    const int longer = words.child_or_add(code, pixels[k]);
    if (longer >= 0) {
      code = longer;
      continue;
    }
    codes.add(code, bits);
    code = pixels[k];
    // A decoder is one code behind: codes get longer once the last one that it knows is full.
    if (words.last() == 1 << bits) ++bits;
    if (words.last() == (1 << kMostBits) - 1) {
      codes.add(kClear, bits);
      words.clear();
      bits = kLetterBits + 1;
    }
  }
  codes.add(code, bits);
  if (words.last() + 1 == 1 << bits && bits < kMostBits) ++bits;
  codes.add(kEnd, bits);
  return static_cast<char>(kLetterBits) + codes.blocks();
}

// The displayed picture, and the encoding of the change to another frame.
class Screen {
 public:
  Screen(Palette& palette, int width, int height)
      : palette_(palette), width_(width), height_(height) {
    shown_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), kStays);
  }
  // The encoding of a frame.
  std::string next(const Raster& raster, int delay);
  [[nodiscard]] bool fits(const Raster& raster) const {
    return raster.width == width_ && raster.height == height_;
  }

 private:
  Palette& palette_;
  int width_, height_;
  std::vector<std::uint8_t> shown_;
};

std::string Screen::next(const Raster& raster, int delay) {
  std::vector<std::uint8_t> changed(shown_.size(), kStays);
  int left = width_, right = -1, top = height_, bottom = -1;
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const auto at = static_cast<std::size_t>(y * width_ + x);
      const std::uint8_t* rgb = &raster.rgb[3 * at];
      const std::uint8_t number =
          palette_.nearest(static_cast<std::uint32_t>(rgb[0]) << 16U |
                           static_cast<std::uint32_t>(rgb[1]) << 8U | rgb[2]);
      if (number == shown_[at]) continue;
      changed[at] = shown_[at] = number;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  }
  if (right < 0) left = right = top = bottom = 0;  // a frame has at least one pixel

  std::string out("\x21\xf9\x04\x05",
                  4);  // the frame is laid over the displayed one; kStays is transparent
  add_word(out, delay);
  add_byte(out, kStays);
  out += '\0';
  out += ',';
  for (const int number : {left, top, right - left + 1, bottom - top + 1}) add_word(out, number);
  out += '\0';
  std::vector<std::uint8_t> part;
  for (int y = top; y <= bottom; ++y) {
    const auto row = changed.begin() + static_cast<std::ptrdiff_t>(y) * width_;
    part.insert(part.end(), row + left, row + right + 1);
  }
  return out + packed(part);
}

std::string head_of(const Raster& first, const std::vector<std::uint32_t>& colours) {
  std::string out = "GIF89a";
  add_word(out, first.width);
  add_word(out, first.height);
  out += std::string("\xf7\0\0", 3);  // a palette of 256 colours, 8 bits each
  for (std::size_t k = 0; k < 256; ++k) {
    const std::uint32_t colour = k < colours.size() ? colours[k] : 0;
    for (const unsigned shift : {16U, 8U, 0U}) add_byte(out, static_cast<int>(colour >> shift));
  }
  return out + std::string("\x21\xff\x0bNETSCAPE2.0\x03\x01\0\0\0", 19);  // repeat endlessly
}

}  // namespace

std::vector<int> gif_delays(int frames, double rate, double pause) {
  require::that(frames > 0, std::to_string(frames) + " frames: expected at least one");
  require::within(rate, 1.0, 50.0, "frames per second of a GIF");
  require::within(pause, 0.0, 60.0, "pause at the end of a GIF, in seconds,");
  std::vector<int> delays;
  int begins = 0;  // [1/100 s]
  for (int k = 1; k <= frames; ++k) {
    const int ends = static_cast<int>(std::lround(100.0 * k / rate));
    delays.push_back(ends - begins);
    begins = ends;
  }
  delays.back() += static_cast<int>(std::lround(100.0 * pause));
  return delays;
}

std::string to_gif(std::span<const int> delays, const std::function<Raster(int)>& frame) {
  require::that(!delays.empty(), "a GIF of no frames: give at least one");
  for (const int delay : delays)
    require::within(delay, 1.0, 65535.0, "delay of a frame of a GIF, in hundredths of a second,");
  const int frames = static_cast<int>(delays.size());
  const int sampled = std::min(frames, kSampledFrames);
  ColourCount colours;
  Raster first;
  for (int k = 0; k < sampled; ++k) {
    const Raster raster = frame(sampled == 1 ? 0 : k * (frames - 1) / (sampled - 1));
    if (k == 0) first = raster;
    colours.add(raster);
  }
  Palette palette(colours.chosen(kGifColours));
  std::string out = head_of(first, palette.colours());
  Screen screen(palette, first.width, first.height);
  for (int k = 0; k < frames; ++k) {
    const Raster raster = k == 0 ? std::move(first) : frame(k);
    require::that(screen.fits(raster),
                  "frame " + std::to_string(k) + " of a GIF: expected the size of the first");
    out += screen.next(raster, delays[static_cast<std::size_t>(k)]);
  }
  return out + ';';
}

}  // namespace tumble
