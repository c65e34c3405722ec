/// \file
/// \brief Two planks on three posts: a small problem on which Baraff's algorithm shows all it does.
#pragma once

#include "tumble/analytic_lcp/assembly.hpp"

#include <vector>

namespace tumble::chapters {

// A plank on two posts, and a longer one that lies on its right half and on a third post, seen from
// the side. All contacts are points in the plane.
//
// | contact | between | x [m] |
// |---|---|---|
// | 1, 2 | posts and lower plank | -0.75, 0.25 |
// | 3, 4 | lower and upper plank: the ends of the area that touches | centre - 1.25, 1 |
// | 5 | third post and upper plank | post |
struct Planks {
  World world;                     // three fixed posts, then the lower and the upper plank
  std::vector<MovingBody> bodies;  // how they are moved
  ContactList contacts;            // five, with a point each
  ContactProblem problem;          // of their forces
};

// Planks of 1 kg and 2 m, and of 1.25 kg and 2.5 m, 0.1 m thick; centre [m] of the upper plank and place
// [m] of the third post.
Planks make_planks(double centre, double post);

}  // namespace tumble::chapters
