/// \file
/// \brief A few colours for many.
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
  /// \param raster the picture
  void add(const Raster& raster);

  /// Chooses colours that stand for all that were counted.
  /// \param most  how many at most, above 0
  /// \return so many or fewer, ascending: exactly those that were counted if they are no more
  /// \verified{A palette keeps colours that are few and the most frequent ones of many}
  [[nodiscard]] std::vector<std::uint32_t> chosen(std::size_t most) const;

 private:
  std::vector<Entry> entries_;  // colours ascending
};

/// The nearest of a few colours.
class Palette {
 public:
  /// Makes an empty table of answers.
  /// \param colours  ascending, 1 to 256
  explicit Palette(std::vector<std::uint32_t> colours);

  /// The number of the colour that is shown for another.
  /// \param colour 0xRRGGBB
  /// \return from 0; of a colour that is in the palette its own
  [[nodiscard]] std::uint8_t nearest(std::uint32_t colour);

  /// All colours.
  /// \return ascending
  [[nodiscard]] const std::vector<std::uint32_t>& colours() const { return colours_; }

 private:
  std::vector<std::uint32_t> colours_;
  std::vector<std::int16_t> known_;  // by the upper six bits of each channel; -1: not asked yet
};

}  // namespace tumble
