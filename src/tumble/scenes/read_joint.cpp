/// \file
/// \brief Reading a table [[joint]] of a scene file.
#include "tumble/base/suggestion.hpp"
#include "tumble/scenes/scene_joint.hpp"
#include "tumble/scenes/scene_table.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace tumble {

SceneJoint read_joint(const SceneTable& table) {
  table.only({"name", "kind", "first", "second", "anchor", "axis"});
  SceneJoint joint;
  table.text("name", joint.name);
  std::vector<std::string_view> known;
  for (const JointKind kind : joint_kinds()) known.push_back(name_of(kind));
  std::string word;
  if (!table.text("kind", word)) table.refuse("kind", "missing: " + expected_names("", known));
  bool found = false;
  for (const JointKind kind : joint_kinds()) {
    if (word != name_of(kind)) continue;
    joint.kind = kind;
    found = true;
  }
  if (!found) table.refuse("kind", expected_names(word, known));
  table.text("first", joint.first);
  table.text("second", joint.second);
  if (!table.vector("anchor", joint.anchor_w))
    table.refuse("anchor", "missing: [x, y, z] in m, the joint's point at the start");
  table.vector("axis", joint.axis_w);
  return joint;
}

}  // namespace tumble
