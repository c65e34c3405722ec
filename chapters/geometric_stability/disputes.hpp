/// \file
/// \brief Bodies on which the rule of the text and that of its footnote differ (thesis 5.4).
#pragma once

#include "tumble/contact/tolerances.hpp"
#include "tumble/geometric_stability/geometrically_stable.hpp"
#include "tumble/geometric_stability/tolerances.hpp"
#include "tumble/geometric_stability/upright.hpp"

#include "driver/experiment.hpp"
#include "geometric_stability/pile_builder.hpp"
#include "geometric_stability/pile_levels.hpp"
#include "geometric_stability/pile_loads.hpp"
#include "geometric_stability/prisms.hpp"
#include "geometric_stability/random_piles.hpp"

namespace tumble::chapters {

// The bodies that are stable by the two bullets of 5.4 alone: all normals vertical, and each of the four
// lower corners at a contact point with a stable body. Whether other bodies below are stable is not asked, as the
// footnote does, and with it GeometricStability (erratum G6).
inline std::vector<char> called_stable_by_text(const World& world,
                                               std::span<const Contact> contacts,
                                               const StabilityTolerances& tolerances) {
  std::vector<char> stable;
  for (const BodyProperties& body : world.bodies()) stable.push_back(body.movable() ? 0 : 1);
  std::vector<char> from_the_side(stable.size(), 0);
  for (const Contact& c : contacts)
    if (!is_vertical(c.normal_w, tolerances.vertical))
      from_the_side[idx(c.first)] = from_the_side[idx(c.second)] = 1;
  std::vector<unsigned> marked(stable.size(), 0U);  // a bit for each lower corner
  for (bool found = true; found;) {
    found = false;
    for (const Contact& c : contacts) {
      const int top = upper_body(c);
      const bool holds = stable[idx(lower_body(c))] != 0 && stable[idx(top)] == 0;
      if (!holds || from_the_side[idx(top)] != 0) continue;
      const BodyProperties& body = world.bodies()[idx(top)];
      const std::array<Vec2, 4> corners = lower_corners(box_of(body, world.states()[idx(top)]));
      for (int p = 0; p < c.count; ++p) {
        const Vec3& point_w = c.points[idx(p)].position_w;
        for (std::size_t k = 0; k < corners.size(); ++k)
          if ((corners[k] - Vec2(point_w.x(), point_w.z())).norm() <=
              tolerances.corner * body.size.minCoeff())
            marked[idx(top)] |= 1U << k;
      }
      if (marked[idx(top)] != 0b1111U) continue;
      stable[idx(top)] = 1;
      found = true;
    }
  }
  return stable;
}

// A body on which both rules were tried, and whether it moves.
struct Trial {
  World world;                                        // the bodies, at rest
  ContactList contacts;                               // all that touch
  std::vector<GeometricStability::Outline> outlines;  // of bodies that are no boxes; may be empty
  int body = 0;                                       // its index
  bool text = false;                                  // stable by the text
  bool hull = false;                                  // stable by the footnote
  bool moves = false;             // accelerates under some load, see moves_under_loads()
  std::vector<char> stable = {};  // by body index, by the footnote

  // Whether the rules differ.
  [[nodiscard]] bool differ() const { return text != hull; }
  // Whether the footnote is right.
  [[nodiscard]] bool hull_right() const { return hull != moves; }
};

inline constexpr StabilityTolerances kExact{tolerance::exact_vertical, tolerance::exact_corner};

// Asks both rules about one body, and loads it.
inline void judge(const StabilityTolerances& tolerances, Trial& trial) {
  GeometricStability rules(tolerances);
  rules.run(trial.world, trial.contacts, StableRule::hull, tolerance::resting_speed, trial.stable,
            trial.outlines);
  trial.hull = trial.stable[idx(trial.body)] != 0;
  trial.text = called_stable_by_text(trial.world, trial.contacts, tolerances)[idx(trial.body)] != 0;
  trial.moves =
      moves_under_loads(trial.world, trial.contacts, trial.outlines)[idx(trial.body)] != 0;
}

// A cube on a fixed block that ends under it, so that a corner hangs over by about a hundredth of an edge.
//
// Rules have the tolerances of `damped`.
inline Trial cut_corner(Random& random) {
  const double turn = random.uniform(0.5, 0.5 * std::numbers::pi - 0.5);
  const double beyond = random.uniform(0.004, 0.014);  // [m]
  const Quat turned = rotation_from_vector(Vec3(0.0, turn, 0.0));
  const auto [s, c] = elementary::sincos(turn);
  const double reaches = 0.5 * (s + c);  // [m] from the centre to the corner, along x
  Trial trial;
  trial.world.add(fixed_box_properties(Vec3(4.0, 1.0, 4.0)), Vec3(0.0, 0.5, 0.0));
  trial.world.add(box_properties(Vec3::Ones(), 1.0), Vec3(2.0 + beyond - reaches, 1.5, 0.0),
                  turned);
  trial.contacts = touching(trial.world);
  trial.body = 1;
  judge({}, trial);
  return trial;
}

// A tall box on a fixed block, both off the vertical by 2e-3 rad, which `damped` takes for upright.
// height: [m] of the box; its other edges have 1 m
inline Trial leaning_tower(double height) {
  constexpr double lean = 2e-3;  // [rad]
  const Quat turned = rotation_from_vector(Vec3(0.0, 0.0, lean));
  Trial trial;
  trial.world.add(fixed_box_properties(Vec3(3.0, 1.0, 3.0)), Vec3::Zero(), turned);
  trial.world.add(box_properties(Vec3(1.0, height, 1.0), 1.0),
                  turned * Vec3(0.0, 0.5 + 0.5 * height, 0.0), turned);
  trial.contacts = touching(trial.world);
  trial.body = 1;
  judge({}, trial);
  return trial;
}

// A prism on blocks, with exact rules; `text` is what the corners of the box around it give.
inline Trial prism_trial(int sides, Random& random) {
  PrismOnBlocks scene = random_prism(sides, random);
  Trial trial{std::move(scene.world), std::move(scene.contacts), std::move(scene.outlines),
              scene.prism};
  judge(kExact, trial);
  return trial;
}

// All bodies of a random pile on which exact rules differ.
inline std::vector<Trial> pile_disputes(std::uint64_t seed) {
  std::vector<Trial> trials;
  Trial trial{.world = random_pile(seed)};
  trial.contacts = touching(trial.world);
  trial.stable = called_stable(StabilityLevel::hull, trial.world, trial.contacts);
  const std::vector<char> text = called_stable_by_text(trial.world, trial.contacts, kExact);
  std::vector<char> moves;
  for (int b = 0; b < trial.world.count(); ++b) {
    trial.body = b;
    trial.text = text[idx(b)] != 0;
    trial.hull = trial.stable[idx(b)] != 0;
    if (!trial.differ()) continue;
    if (moves.empty()) moves = moves_under_loads(trial.world, trial.contacts);
    trial.moves = moves[idx(b)] != 0;
    trials.push_back(trial);
  }
  return trials;
}

// A trial from above: the bodies below, the body's outline, the points that stable bodies hold it by, and
// their hull.
Drawing plan_of(const Trial& trial, const std::string& suffix);

// The same of a small part of it, around the body's lower corner with the largest x, and a circle with
// the radius of the tolerance of `damped` around that corner.
Drawing enlarged_corner_of(const Trial& trial, const std::string& suffix);

// Reach of the unstable supports of a trial and their neighbours, for choosing one to draw.
// Returns [m] from the middle of the body to the farthest corner of them; 0 if there are none
double spread_of(const Trial& trial);

}  // namespace tumble::chapters
