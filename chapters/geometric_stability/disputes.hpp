/// \file
/// \brief Bodies on which the rule of the text and that of its footnote differ (thesis 5.4).
#pragma once

#include "tumble/geometric_stability/geometrically_stable.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// The bodies that are stable by the two bullets of 5.4 alone: all normals vertical, and each of the four
// lower corners
// at a contact point with a stable body. Whether other bodies below are stable is not asked, as the
// footnote does, and with it GeometricStability (erratum G6).
std::vector<char> called_stable_by_text(const World& world, std::span<const Contact> contacts,
                                        const StabilityTolerances& tolerances);

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

// A cube on a fixed block that ends under it, so that a corner hangs over by about a hundredth of an edge.
//
// Rules have the tolerances of `damped`.
Trial cut_corner(Random& random);

// A tall box on a fixed block, both off the vertical by 2e-3 rad, which `damped` takes for upright.
// height: [m] of the box; its other edges have 1 m
Trial leaning_tower(double height);

// A prism on blocks, with exact rules; `text` is what the corners of the box around it give.
Trial prism_trial(int sides, Random& random);

// All bodies of a random pile on which exact rules differ.
std::vector<Trial> pile_disputes(std::uint64_t seed);

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
