/// \file
/// \brief Boxes, joints and wishes of a scene file.
#include "tumble/base/number_text.hpp"
#include "tumble/base/suggestion.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/scenes/scene.hpp"
#include "tumble/scenes/scene_joint.hpp"
#include "tumble/scenes/scene_table.hpp"
#include "tumble/scenes/wish.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

namespace {

void read_mass(const SceneTable& table, SceneBox& box) {
  table.flag("fixed", box.fixed);
  const bool has_mass = table.number("mass", box.mass);
  if (box.fixed && has_mass)
    table.refuse("mass", "a fixed box has none: give mass or fixed = true");
  if (!box.fixed && !has_mass) table.refuse("mass", "missing: give mass or fixed = true");
  if (has_mass && !(box.mass > 0.0)) table.refuse("mass", "expected a number above 0 kg");
}

void read_orientation(const SceneTable& table, SceneBox& box) {
  Vec3 degrees;
  const bool turned = table.vector("rotation_deg", degrees);
  if (table.quaternion("orientation", box.orientation_wb)) {
    if (turned) table.refuse("rotation_deg", "give orientation or rotation_deg, not both");
    if (std::abs(box.orientation_wb.norm() - 1.0) > tolerance::unit_length)
      table.refuse("orientation", "expected w x y z of length 1, this has length " +
                                      shortest_text(box.orientation_wb.norm()));
  }
  if (turned) box.orientation_wb = rotation_from_degrees(degrees);
}

}  // namespace

void read_surface(const SceneTable& table, double& friction, double& restitution) {
  if (table.number("friction", friction) && friction < 0.0)
    table.refuse("friction", "expected 0 or above");
  if (table.number("restitution", restitution) && !(restitution >= 0.0 && restitution <= 1.0))
    table.refuse("restitution", "expected a number from 0 to 1");
}

SceneBox read_box(const SceneTable& table) {
  table.only({"name", "size", "mass", "fixed", "position", "orientation", "rotation_deg",
              "velocity", "angular_velocity", "friction", "restitution", "appears", "disappears"});
  SceneBox box;
  table.text("name", box.name);
  if (!table.vector("size", box.size)) table.refuse("size", "missing: [x, y, z] in m");
  if (!(box.size.minCoeff() > 0.0)) table.refuse("size", "expected three numbers above 0 m");
  if (!table.vector("position", box.position_w))
    table.refuse("position", "missing: [x, y, z] in m");
  read_mass(table, box);
  read_orientation(table, box);
  table.vector("velocity", box.velocity_w);
  table.vector("angular_velocity", box.angular_velocity_w);
  if (box.fixed && !(box.velocity_w.isZero(0.0) && box.angular_velocity_w.isZero(0.0)))
    table.refuse("velocity", "a fixed box cannot move");
  read_surface(table, box.friction, box.restitution);
  if (table.number("appears", box.appears) && box.appears < 0.0)
    table.refuse("appears", "expected 0 s or later");
  if (table.number("disappears", box.disappears) && !(box.disappears > box.appears))
    table.refuse("disappears",
                 "expected later than " + shortest_text(box.appears) + " s, when it appears");
  return box;
}

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

namespace {

template <std::size_t n>
int place_in(const SceneTable& table, std::string_view key, const std::string& word,
             const std::array<std::string_view, n>& words) {
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) table.refuse(key, expected_names(word, words));
  return static_cast<int>(found - words.begin());
}

void read_face(const SceneTable& table, Wish& wish) {
  table.only({"kind", "body", "face"});
  std::string face;
  if (!table.text("face", face))
    table.refuse("face", "missing: the face that is up, \"+x\", \"-x\", \"+y\" and so on");
  wish.face = place_in(table, "face", face, kFaces);
}

void read_region(const SceneTable& table, Wish& wish) {
  table.only({"kind", "body", "low", "high"});
  if (!table.vector("low", wish.low_w)) table.refuse("low", "missing: [x, y, z] in m");
  if (!table.vector("high", wish.high_w)) table.refuse("high", "missing: [x, y, z] in m");
}

}  // namespace

Wish read_wish(const SceneTable& table) {
  Wish wish;
  std::string kind;
  if (!table.text("kind", kind)) table.refuse("kind", "missing: " + expected_names("", kWishKinds));
  wish.kind = static_cast<WishKind>(place_in(table, "kind", kind, kWishKinds));
  if (!table.texts("body", wish.bodies))
    table.refuse("body", "missing: the name of a box, or a list of names");
  switch (wish.kind) {
    case WishKind::face_up: read_face(table, wish); break;
    case WishKind::ends_in: read_region(table, wish); break;
    case WishKind::topples:
    case WishKind::stands:
      table.only({"kind", "body", "angle"});
      table.number("angle", wish.angle_deg);
      break;
    case WishKind::moves:
    case WishKind::stays:
      table.only({"kind", "body", "distance"});
      if (table.number("distance", wish.distance) && !(wish.distance > 0.0))
        table.refuse("distance", "expected a number above 0 m");
      break;
  }
  return wish;
}

}  // namespace tumble
