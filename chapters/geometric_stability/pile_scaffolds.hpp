/// \file
/// \brief Boxes that rest on slanted supports, beside a random pile (thesis 5.4).
#pragma once

#include "driver/experiment.hpp"
#include "geometric_stability/pile_builder.hpp"

namespace tumble::chapters {

// Adds two fixed blocks with faces at right angles, and a box between that lies on both: it rests,
// and none of its contacts is vertical.
inline void add_trough(Random& random, PileBuilder& builder) {
  const double lean = random.uniform(0.4, 1.1);
  const double width = random.uniform(0.6, 1.2);
  const double height = random.uniform(0.6, 1.2);
  const Quat turned = rotation_from_vector(Vec3(0.0, 0.0, lean));
  const Vec3 lowest_w(6.0, 2.0, 0.0);
  const auto add = [&](const BodyProperties& body, const Vec3& centre) {
    builder.add(body, make_state(body, lowest_w + turned * centre, turned));
  };
  add(fixed_box_properties(Vec3(2.0, 0.5, 2.0)), Vec3(1.0, -0.25, 0.0));
  add(fixed_box_properties(Vec3(0.5, 2.0, 2.0)), Vec3(-0.25, 1.0, 0.0));
  add(box_properties(Vec3(width, height, 1.0), 1.0), Vec3(0.5 * width, 0.5 * height, 0.0));
}

// Adds a plank with its foot before a kerb that leans on the edge of a block. In two of three cases the
// block has a kerb behind it, and all rest; else the plank pushes it away.
inline void add_leaning_plank(Random& random, PileBuilder& builder) {
  const double lean = random.uniform(0.5, 0.9);
  const double tall = random.uniform(0.6, 0.9);
  const bool held = random.below(3) != 0;
  const Quat turned = rotation_from_vector(Vec3(0.0, 0.0, lean));
  const auto [s, c] = elementary::sincos(lean);
  constexpr double thick = 0.25;
  const Vec3 foot_w(-7.0, 0.0, 0.0);               // the edge that stands on the ground
  const double leftmost = foot_w.x() - thick * s;  // touches the kerb
  const double edge = foot_w.x() + tall * c / s;   // here its underside is as high as the block
  const auto add = [&](const BodyProperties& body, const Vec3& centre_w, const Quat& q) {
    builder.add(body, make_state(body, centre_w, q));
  };
  const BodyProperties kerb = fixed_box_properties(Vec3(1.0, 0.5, 2.0));
  add(kerb, Vec3(leftmost - 0.5, 0.25, 0.0), Quat::Identity());
  add(box_properties(Vec3(1.0, tall, 1.0), 1.0), Vec3(edge + 0.5, 0.5 * tall, 0.0),
      Quat::Identity());
  if (held) add(kerb, Vec3(edge + 1.5, 0.25, 0.0), Quat::Identity());
  add(box_properties(Vec3(2.0, thick, 0.75), 1.0), foot_w + turned * Vec3(1.0, 0.5 * thick, 0.0),
      turned);
}

}  // namespace tumble::chapters
