/// \file
/// \brief Colours and shapes of a world's bodies in pictures.
#pragma once

#include "tumble/dynamics/world.hpp"
#include "tumble/pictures/picture.hpp"

#include <vector>

namespace tumble {

/// All boxes of a world with their colours: immovable ones grey, one named "projectile" vermilion, the
/// others in turn from colours that colour-blind readers can distinguish (Okabe and Ito), muted if there
/// are many. Those whose name begins with "die" get pips.
/// \return one for each body except the ground, in the order of the world
std::vector<PictureBox> picture_boxes(const World& world);

/// Whether a world has a ground.
bool has_ground(const World& world);

}  // namespace tumble
