/// \file
/// \brief Description of the options of contact_damped, for the list of techniques.
#pragma once

#include "tumble/base/options.hpp"
#include "tumble/contact_damped/contact_damped.hpp"

namespace tumble {

/// Names the options to a visitor, see options.hpp.
/// \param o  the options
/// \param v  an OptionDeclarer or OptionReader
template <class Visitor>
void describe(ContactDampedOptions& o, Visitor& v) {
  v.whole("passes", o.passes, 1, 1000, "sweeps down and up over the contact patches of an island");
  v.whole("rounds", o.rounds, 0, 10000,
          "iterations of the direct solver, for islands that sweeps do not settle; 0: none");
  v.whole("repair_passes", o.repair_passes, 1, 1000, "sweeps of the overlap repair");
  v.flag("sleeping", o.sleeping, "do not simulate islands at rest (thesis 4.5)");
  v.word("rotation", o.rotation, words_of(rotation_rules()), kRotationMeaning);
  v.word("pose", o.pose, words_of(pose_updates()), kPoseMeaning);
}

}  // namespace tumble
