/// \file
/// \brief Reduction of colours to a small palette.
#pragma once

#include "tumble/pictures/raster.hpp"

#include <cstdint>
#include <vector>

namespace tumble {

/// Colours of pixels, counted.
class ColourCount {
 public:
  /// A colour and its pixels.
  struct Entry {
    std::uint32_t colour = 0;  ///< 0xRRGGBB
    std::uint32_t count = 0;   ///< of pixels
  };

  /// Counts the pixels of a picture.
  void add(const Raster& raster);

  /// Chooses colours that represent all counted ones.
  /// \param most  largest number of them, above 0
  /// \return ascending: exactly the counted colours if they are no more than that
  /// \verified{A palette keeps colours that are few and the most frequent ones of many}
  [[nodiscard]] std::vector<std::uint32_t> chosen(std::size_t most) const;

 private:
  std::vector<Entry> entries_;  // colours ascending
};

/// Nearest colour in a palette.
class Palette {
 public:
  /// Makes it with an empty cache.
  /// \param colours  ascending, 1 to 256
  explicit Palette(std::vector<std::uint32_t> colours);

  /// The index of the nearest colour.
  /// \param colour 0xRRGGBB
  /// \return from 0; for a colour in the palette its own
  [[nodiscard]] std::uint8_t nearest(std::uint32_t colour);

  /// All colours, ascending.
  [[nodiscard]] const std::vector<std::uint32_t>& colours() const { return colours_; }

 private:
  std::vector<std::uint32_t> colours_;
  std::vector<std::int16_t> known_;  // cache by the upper six bits of each channel; -1: empty
};

}  // namespace tumble
