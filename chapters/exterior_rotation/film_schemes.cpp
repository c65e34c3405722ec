/// \file
/// \brief The schemes of the film strips, gaps over time, and gaps that single steps make.
#include "exterior_rotation/film_schemes.hpp"

#include <array>

namespace tumble::chapters {

std::span<const FilmScheme> film_schemes() {
  static const std::array<FilmScheme, 6> kSchemes = {{
      {"forward_euler", "forward Euler", GluedScheme::forward_euler},
      {"semi_implicit", "semi-implicit", GluedScheme::semi_implicit},
      {"impulse", "impulses", GluedScheme::impulse},
      {"midpoint", "midpoint", GluedScheme::midpoint},
      {"rk4", "rk4", GluedScheme::rk4},
      {"reference", "reference", GluedScheme::dormand_prince},
  }};
  return kSchemes;
}

GluedOptions options_of(const FilmScheme& scheme, PoseUpdate pose) {
  GluedOptions options;
  options.scheme = scheme.scheme;
  options.pose = pose;
  options.accuracy = 1e-12;
  return options;
}

double outwards(const World& world, const Joint& joint, const Vec3& out_w) {
  const JointPoint held = held_point(joint, world.states());
  return out_w.dot(held.second_w - held.first_w);
}

double gap_of_step(const World& world, const GluedOptions& options, double dt) {
  World moved = world;
  Glued glued(options);
  glued.find(moved);
  glued.step(moved, dt);
  const Joint& joint = glued.joints().back();
  const auto centre = [&](int body) {
    return moved.states()[static_cast<std::size_t>(body)].position_w;
  };
  // The larger box's centre does not turn: its pivot stands for it.
  const bool edge = joint.hold == JointHold::edge;
  const Vec3 from_w = edge ? held_point(joint, moved.states()).first_w : centre(joint.first);
  return outwards(moved, joint, (centre(joint.second) - from_w).normalized());
}

}  // namespace tumble::chapters
