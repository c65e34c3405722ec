/// \file
/// \brief Reading a joint of a scene file.
#pragma once

#include "tumble/base/suggestion.hpp"
#include "tumble/scenes/scene_joint.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// Reads a table `[[joint]]`. What its values mean is checked by join_bodies().
/// \param place  the table, as scene_file.cpp reads one
/// \return the joint
/// \throws std::invalid_argument "FILE:LINE: KEY = VALUE: what would be right", for a key that is unknown, missing or of
///         another type
template <class Place>
SceneJoint read_joint(const Place& place) {
  place.only({"name", "kind", "first", "second", "anchor", "axis"});
  SceneJoint joint;
  place.text("name", joint.name);
  std::vector<std::string_view> known;
  for (const JointKind kind : joint_kinds()) known.push_back(name_of(kind));
  std::string word;
  if (!place.text("kind", word))
    place.refuse("kind", nullptr, "missing: " + expected_names("", known));
  bool found = false;
  for (const JointKind kind : joint_kinds()) {
    if (word != name_of(kind)) continue;
    joint.kind = kind;
    found = true;
  }
  if (!found) place.refuse("kind", place.find("kind"), expected_names(word, known));
  place.text("first", joint.first);
  place.text("second", joint.second);
  if (!place.vector("anchor", joint.anchor_w))
    place.refuse("anchor", nullptr, "missing: [x, y, z] in m, the joint's point at the start");
  place.vector("axis", joint.axis_w);
  return joint;
}

}  // namespace tumble
