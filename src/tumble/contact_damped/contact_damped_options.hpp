/// \file
/// \brief Description of the options of contact_damped, for the list of techniques.
#pragma once

#include "tumble/base/options.hpp"
#include "tumble/contact_damped/contact_damped.hpp"

namespace tumble {

/// Names the options to a visitor, see options.hpp.
template <class Visitor>
void describe(ContactDampedOptions& o, Visitor& v) {
  v.whole("sweeps", o.sweeps, 1, 1000,
          "sweeps over the contact patches of an island, in one direction each");
  v.whole("admm_iterations", o.admm_iterations, 0, 10000,
          "iterations of the direct solver, for islands that sweeps do not settle; 0: none");
  v.whole("budget", o.budget, 1, 1000000000,
          "sweeps and iterations over a large island in motion, times its contact patches");
  v.whole("correction_sweeps", o.correction_sweeps, 1, 1000, "sweeps of the overlap correction");
  v.whole("parts", o.parts, 1, 100, "parts of a step in which bodies that touch move far, at most");
  v.flag("sleeping", o.sleeping, "do not simulate islands at rest (thesis 4.5)");
  v.word("rotation", o.rotation, words_of(rotation_rules()), kRotationMeaning);
  v.word("pose", o.pose, words_of(pose_updates()), kPoseMeaning);
}

}  // namespace tumble
