/// \file
/// \brief Pictures and films of a body of tetrahedra among boxes.
#pragma once

#include "tumble/fracture/fracture.hpp"
#include "tumble/pictures/back_to_front.hpp"
#include "tumble/pictures/picture.hpp"

#include <string>
#include <vector>

namespace tumble::chapters {

// A frame: triangles of the body's outside, and boxes.
struct FractureFrame {
  double time = 0.0;                   // [s]
  std::vector<FacePart> faces;         // of the body; in any order
  std::vector<std::uint32_t> colours;  // by face
  std::vector<PictureBox> boxes;       // around it
};

// What a scene looks like now. Faces that were inside of the box at rest, the cracks, are light.
FractureFrame frame_of(const Fracture& scene, const Vec3& size, double time);

// All of a frame as areas, with shadows on the floor.
Picture drawn(const FractureFrame& frame, const Camera& camera, std::span<const PictureBox> around);

// The film: the bytes of a GIF, with the time in milliseconds in a corner.
std::string film_of(const std::vector<FractureFrame>& frames, const Camera& camera,
                    std::span<const PictureBox> around, double rate);

}  // namespace tumble::chapters
