/// \file
/// \brief Colours of bodies.
#include "tumble/pictures/world_picture.hpp"

#include "tumble/pictures/lighting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace tumble {
namespace {

// Okabe and Ito's colours; vermilion is reserved for the projectile.
constexpr std::array<std::uint32_t, 5> kColours = {0x0072b2, 0xe69f00, 0x009e73, 0xcc79a7,
                                                   0x56b4e9};
constexpr std::uint32_t kProjectile = 0xd55e00;
constexpr std::uint32_t kFixed = 0xc4c4c4;
constexpr std::uint32_t kMuted = 0xdcdcd8;  // many boxes are mixed with this
constexpr double kMutedShare = 0.35;
constexpr std::size_t kMany = 12;
constexpr double kGoldenRatio = 0.6180339887498949;

}  // namespace

std::vector<PictureBox> picture_boxes(const World& world) {
  std::vector<PictureBox> boxes;
  const auto count = static_cast<std::size_t>(world.count());
  const bool many = count > kMany;
  std::size_t coloured = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (body.shape == Shape::ground) continue;
    PictureBox drawn{.box = box_of(body, world.states()[k])};
    const std::string& name = world.name(static_cast<int>(k));
    drawn.die = name.starts_with("die");
    if (!body.movable()) {
      drawn.colour = kFixed;
    } else if (name == "projectile") {
      drawn.colour = kProjectile;
    } else {
      // Steps of the golden ratio: neighbours differ, and rows of five make no stripes.
      const double turn = kGoldenRatio * static_cast<double>(coloured++);
      const double place = static_cast<double>(kColours.size()) * (turn - std::floor(turn));
      drawn.colour = kColours[static_cast<std::size_t>(place)];
      if (many) drawn.colour = mixed(drawn.colour, kMuted, kMutedShare);
    }
    boxes.push_back(drawn);
  }
  return boxes;
}

bool has_ground(const World& world) {
  return std::any_of(world.bodies().begin(), world.bodies().end(),
                     [](const BodyProperties& body) { return body.shape == Shape::ground; });
}

}  // namespace tumble
