/// \file
/// \brief Reading a table [[box]] of a scene file.
#include "tumble/base/number_text.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/scenes/scene.hpp"
#include "tumble/scenes/scene_table.hpp"

#include <cmath>

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

}  // namespace tumble
