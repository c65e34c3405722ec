/// \file
/// \brief Checking the joints of a scene and joining bodies.
#include "tumble/scenes/scene_joint.hpp"

#include "tumble/base/number_text.hpp"
#include "tumble/base/suggestion.hpp"
#include "tumble/dynamics/tolerances.hpp"
#include "tumble/scenes/scene.hpp"
#include "tumble/scenes/scene_names.hpp"

#include <vector>

namespace tumble {
namespace {

// The joint at a place of the scene, for messages.
class JointInScene {
 public:
  JointInScene(const Scene& scene, std::size_t place) : scene_(scene), place_(place) {}

  [[noreturn]] void refuse(const std::string& key, const std::string& message) const {
    throw SceneMistake(static_cast<int>(place_), key, message, "joint");
  }

  // The body of that name. Joints are made at the start, so it has to be there then.
  [[nodiscard]] BodyId body(const std::string& key, const std::string& name,
                            const World& world) const {
    if (const auto found = world.find(std::string_view(name))) return *found;
    const std::string given = " = " + one_line(name) + ": ";
    if (name.empty()) refuse(key, ": missing: the name of a box, or \"ground\"");
    for (const SceneBox& box : scene_.boxes)
      if (box.name == name)
        refuse(key, given + "it appears later: a joint holds boxes that are there at the start");
    if (name == "ground")
      refuse(key, given + "the scene has none: write a table [ground], or join a fixed box");
    std::vector<std::string_view> known;
    for (const SceneBox& box : scene_.boxes) known.push_back(box.name);
    const std::string close(closest_name(name, known));
    refuse(key, given + "no box has this name: " +
                    (close.empty() ? "expected one of [[box]], or \"ground\""
                                   : "did you mean " + close + "?"));
  }

  void require_limited(const std::string& key, const Vec3& value) const {
    if (value.allFinite() && value.cwiseAbs().maxCoeff() <= tolerance::largest_value) return;
    refuse(key, ": expected three finite numbers from -" + shortest_text(tolerance::largest_value) +
                    " to " + shortest_text(tolerance::largest_value));
  }

 private:
  const Scene& scene_;
  std::size_t place_;
};

}  // namespace

void join_bodies(Scene& scene, World& world) {
  settle_names(scene.joints, "joint", "joints", false,
               [&](std::size_t place, const std::string& message) {
                 JointInScene(scene, place).refuse("name", message);
               });
  for (std::size_t i = 0; i < scene.joints.size(); ++i) {
    const SceneJoint& joint = scene.joints[i];
    const JointInScene place(scene, i);
    const BodyId first = place.body("first", joint.first, world);
    const BodyId second = place.body("second", joint.second, world);
    if (first == second)
      place.refuse("second", " = " + joint.second + ": the same body twice: name another one");
    const auto fixed = [&](BodyId id) { return !world.body(id).properties().movable(); };
    if (fixed(first) && fixed(second))
      place.refuse("second", " = " + joint.second + ": neither it nor " + joint.first +
                                 " can move: give one of them a mass, or leave the joint out");
    place.require_limited("anchor", joint.anchor_w);
    place.require_limited("axis", joint.axis_w);
    const bool hinge = joint.kind == JointKind::hinge;
    if (hinge && joint.axis_w.isZero(0.0))
      place.refuse("axis", ": missing or 0: a hinge needs the direction of its axis");
    if (!hinge && !joint.axis_w.isZero(0.0))
      place.refuse("axis", ": a " + std::string(name_of(joint.kind)) +
                               " joint has none: leave it out, or write kind = \"hinge\"");
    world.join(joint.kind, first, second, joint.anchor_w, joint.axis_w, joint.name);
  }
}

}  // namespace tumble
