/// \file
/// \brief Division of colours into cells, split where the spread is largest.
#include "tumble/pictures/palette.hpp"

#include "tumble/base/error.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace tumble {
namespace {

using Entry = ColourCount::Entry;

int channel_of(std::uint32_t colour, int channel) {
  return static_cast<int>(colour >> (16U - 8U * static_cast<unsigned>(channel)) & 0xffU);
}

// Consecutive entries, and the channel in which they differ most.
struct Cell {
  std::vector<Entry> entries;
  int channel = 0;
  double mean = 0.0;    // of that channel
  double spread = 0.0;  // pixels times squared distances from it
};

Cell cell_of(std::vector<Entry> entries) {
  Cell cell;
  for (int channel = 0; channel < 3; ++channel) {
    double pixels = 0.0;
    double sum = 0.0;
    double squares = 0.0;
    for (const Entry& entry : entries) {
      const double value = channel_of(entry.colour, channel);
      pixels += entry.count;
      sum += entry.count * value;
      squares += entry.count * value * value;
    }
    const double spread = squares - sum * sum / pixels;
    if (channel > 0 && spread <= cell.spread) continue;
    cell.channel = channel;
    cell.mean = sum / pixels;
    cell.spread = spread;
  }
  cell.entries = std::move(entries);
  return cell;
}

std::uint32_t most_frequent(const Cell& cell) {
  return std::max_element(cell.entries.begin(), cell.entries.end(),
                          [](const Entry& a, const Entry& b) { return a.count < b.count; })
      ->colour;
}

}  // namespace

void ColourCount::add(const Raster& raster) {
  std::vector<std::uint32_t> colours;
  colours.reserve(raster.rgb.size() / 3);
  for (std::size_t k = 0; k + 2 < raster.rgb.size(); k += 3)
    colours.push_back(static_cast<std::uint32_t>(raster.rgb[k]) << 16U |
                      static_cast<std::uint32_t>(raster.rgb[k + 1]) << 8U | raster.rgb[k + 2]);
  std::sort(colours.begin(), colours.end());
  std::vector<Entry> merged;
  auto old = entries_.begin();
  for (auto at = colours.begin(); at != colours.end();) {
    const auto end = std::upper_bound(at, colours.end(), *at);
    while (old != entries_.end() && old->colour < *at) merged.push_back(*old++);
    Entry entry{*at, static_cast<std::uint32_t>(end - at)};
    if (old != entries_.end() && old->colour == *at) entry.count += (old++)->count;
    merged.push_back(entry);
    at = end;
  }
  merged.insert(merged.end(), old, entries_.end());
  entries_ = std::move(merged);
}

std::vector<std::uint32_t> ColourCount::chosen(std::size_t most) const {
  require::that(most > 0 && !entries_.empty(), "a palette takes a colour: count some pixels first");
  std::vector<Cell> cells = {cell_of(entries_)};
  while (cells.size() < most) {
    const auto widest =
        std::max_element(cells.begin(), cells.end(),
                         [](const Cell& a, const Cell& b) { return a.spread < b.spread; });
    if (widest->entries.size() < 2) break;  // each cell has one colour
    std::array<std::vector<Entry>, 2> parts;
    for (const Entry& entry : widest->entries)
      parts[channel_of(entry.colour, widest->channel) > widest->mean ? 1 : 0].push_back(entry);
    *widest = cell_of(std::move(parts[0]));
    cells.push_back(cell_of(std::move(parts[1])));
  }
  std::vector<std::uint32_t> colours;
  for (const Cell& cell : cells) colours.push_back(most_frequent(cell));
  std::sort(colours.begin(), colours.end());
  return colours;
}

Palette::Palette(std::vector<std::uint32_t> colours)
    : colours_(std::move(colours)), known_(std::size_t{1} << 18U, -1) {
  require::that(!colours_.empty() && colours_.size() <= 256,
                std::to_string(colours_.size()) + " colours in a palette: expected 1 to 256");
}

std::uint8_t Palette::nearest(std::uint32_t colour) {
  const auto own = std::lower_bound(colours_.begin(), colours_.end(), colour);
  if (own != colours_.end() && *own == colour)
    return static_cast<std::uint8_t>(own - colours_.begin());
  std::int16_t& known = known_[(colour >> 18U & 0x3fU) << 12U | (colour >> 10U & 0x3fU) << 6U |
                               (colour >> 2U & 0x3fU)];
  if (known >= 0) return static_cast<std::uint8_t>(known);
  int least = 3 * 256 * 256;
  for (std::size_t k = 0; k < colours_.size(); ++k) {
    int distance = 0;
    for (int channel = 0; channel < 3; ++channel) {
      const int apart = channel_of(colours_[k], channel) - channel_of(colour, channel);
      distance += apart * apart;
    }
    if (distance >= least) continue;
    least = distance;
    known = static_cast<std::int16_t>(k);
  }
  return static_cast<std::uint8_t>(known);
}

}  // namespace tumble
