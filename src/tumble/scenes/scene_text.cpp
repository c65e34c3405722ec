/// \file
/// \brief Writing a scene as a TOML file.
#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/scenes/scene_file.hpp"

#include <cmath>

namespace tumble {
namespace {

// A number as TOML writes floats: with a point or an exponent, and reading back to the same bits.
std::string number(double value) {
  std::string out = shortest_text(value);
  if (out.find_first_of(".e") == std::string::npos) out += ".0";
  return out;
}

std::string list(const Vec3& v) {
  std::string out = "[";
  return out.append(number(v.x()))
             .append(", ")
             .append(number(v.y()))
             .append(", ")
             .append(number(v.z())) +
         "]";
}

// Text in quotes: backslash, quote and control characters are escaped as TOML asks.
std::string quoted(const std::string& text) {
  constexpr const char* digits = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') out += '\\';
    if (code < 0x20U || code == 0x7fU) {
      out.append("\\u00").append(1, digits[code >> 4U]).append(1, digits[code & 0xfU]);
    } else {
      out += c;
    }
  }
  return out + '"';
}

void write(const Wish& wish, std::string& out) {
  out.append("\n[[wish]]\nkind = ")
      .append(quoted(std::string(kWishKinds[static_cast<std::size_t>(wish.kind)])));
  out.append("\nbody = [");
  for (const std::string& name : wish.bodies)
    out.append(&name == &wish.bodies.front() ? "" : ", ").append(quoted(name));
  out.append("]\n");
  switch (wish.kind) {
    case WishKind::face_up:
      out.append("face = ").append(quoted(std::string(kFaces[idx(wish.face)]))).append("\n");
      break;
    case WishKind::ends_in:
      out.append("low = ").append(list(wish.low_w)).append("\n");
      out.append("high = ").append(list(wish.high_w)).append("\n");
      break;
    case WishKind::topples:
    case WishKind::stands:
      out.append("angle = ").append(number(wish.angle_deg)).append("\n");
      break;
    case WishKind::moves:
    case WishKind::stays:
      if (wish.distance > 0.0) out.append("distance = ").append(number(wish.distance)).append("\n");
      break;
  }
}

void write(const SceneBox& box, std::string& out) {
  const Quat& q = box.orientation_wb;
  out.append("\n[[box]]\n");
  if (!box.name.empty()) out.append("name = ").append(quoted(box.name)).append("\n");
  out.append("size = ").append(list(box.size)).append("\n");
  if (box.fixed) out.append("fixed = true\n");
  if (!box.fixed) out.append("mass = ").append(number(box.mass)).append("\n");
  out.append("position = ").append(list(box.position_w)).append("\n");
  out.append("orientation = [").append(number(q.w()));
  for (int k = 0; k < 3; ++k) out.append(", ").append(number(q.vec()[k]));
  out.append("]\n");
  if (!box.fixed) {
    out.append("velocity = ").append(list(box.velocity_w)).append("\n");
    out.append("angular_velocity = ").append(list(box.angular_velocity_w)).append("\n");
  }
  out.append("friction = ").append(number(box.friction)).append("\n");
  out.append("restitution = ").append(number(box.restitution)).append("\n");
  if (box.appears > 0.0) out.append("appears = ").append(number(box.appears)).append("\n");
  if (std::isfinite(box.disappears))
    out.append("disappears = ").append(number(box.disappears)).append("\n");
}

void write(const SceneJoint& joint, std::string& out) {
  out.append("\n[[joint]]\n");
  if (!joint.name.empty()) out.append("name = ").append(quoted(joint.name)).append("\n");
  out.append("kind = ").append(quoted(std::string(name_of(joint.kind)))).append("\n");
  out.append("first = ").append(quoted(joint.first)).append("\n");
  out.append("second = ").append(quoted(joint.second)).append("\n");
  out.append("anchor = ").append(list(joint.anchor_w)).append("\n");
  if (joint.kind == JointKind::hinge) out.append("axis = ").append(list(joint.axis_w)).append("\n");
}

}  // namespace

std::string to_toml(const Scene& scene) {
  std::string out;
  out.append("title = ").append(quoted(scene.title)).append("\n");
  out.append("gravity = ").append(list(scene.gravity_w)).append("\n");
  if (scene.ground) {
    out.append("\n[ground]\nfriction = ").append(number(scene.ground->friction));
    out.append("\nrestitution = ").append(number(scene.ground->restitution)).append("\n");
  }
  for (const SceneBox& box : scene.boxes) write(box, out);
  for (const Wish& wish : scene.wishes) write(wish, out);
  for (const SceneJoint& joint : scene.joints) write(joint, out);
  return out;
}

}  // namespace tumble
