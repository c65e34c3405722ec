/// \file
/// \brief Checking a scene and building its world.
#include "tumble/scenes/scene.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/dynamics/mass_range.hpp"
#include "tumble/geometry/bounding_tree.hpp"
#include "tumble/geometry/separation.hpp"
#include "tumble/scenes/scene_joint.hpp"
#include "tumble/scenes/scene_names.hpp"

#include <algorithm>

namespace tumble {
namespace {

void refuse_overlap(const Scene& scene, int box, const std::string& other, double depth,
                    double allowed) {
  if (depth <= allowed) return;
  const SceneBox& b = scene.boxes[static_cast<std::size_t>(box)];
  std::string message = " = ";
  message.append(vector_text(b.position_w))
      .append(": ")
      .append(b.name)
      .append(" and ")
      .append(other);
  message.append(" overlap by ").append(shortest_text(depth)).append(" m at the start: ");
  message.append("move them apart, up to ").append(shortest_text(allowed));
  throw SceneMistake(box, "position", message.append(" m is accepted"));
}

// Boxes may touch and overlap a little at the start, as numbers typed by hand do.
void refuse_overlaps(const Scene& scene, const World& world) {
  const auto joined = [&](const std::string& a, const std::string& b) {
    return !scene.joints.empty() && world.joined(*world.find(a), *world.find(b));
  };
  std::vector<int> present;  // places of the boxes that are there at the start
  std::vector<Box> shapes;
  std::vector<Bounds> bounds;
  auto body = static_cast<std::size_t>(scene.ground ? 1 : 0);
  for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
    const SceneBox& box = scene.boxes[i];
    if (box.appears > 0.0) continue;
    present.push_back(static_cast<int>(i));
    shapes.push_back(box_of(world.bodies()[body], world.states()[body]));
    ++body;
    bounds.push_back(bounds_of(shapes.back()));
    const double lowest = box.position_w.y() - reach(shapes.back(), Vec3::UnitY());
    if (scene.ground && !box.fixed && !joined(box.name, "ground"))
      refuse_overlap(scene, present.back(), "the ground", -lowest,
                     tolerance::start_overlap * box.size.minCoeff());
  }
  std::vector<IndexPair> pairs;
  BoundingTree().find_pairs(bounds, pairs);
  SeparationOptions exact;
  exact.prefer_faces = false;
  for (const IndexPair& pair : pairs) {
    const auto first = static_cast<std::size_t>(pair.first);
    const auto second = static_cast<std::size_t>(pair.second);
    const SceneBox& a = scene.boxes[static_cast<std::size_t>(present[first])];
    const SceneBox& b = scene.boxes[static_cast<std::size_t>(present[second])];
    if ((a.fixed && b.fixed) || joined(a.name, b.name)) continue;
    refuse_overlap(scene, present[second], a.name,
                   -separation(shapes[first], shapes[second], exact).distance,
                   tolerance::start_overlap * std::min(a.size.minCoeff(), b.size.minCoeff()));
  }
}

BodyState state_of(const SceneBox& box, const BodyProperties& body) {
  require_motion_limits(body, box.position_w, box.velocity_w, box.angular_velocity_w);
  return make_state(body, box.position_w, box.orientation_wb, box.velocity_w,
                    box.angular_velocity_w);
}

// The key of scene files that a message is about: "velocity_w = ..." is about velocity.
std::string key_of(std::string_view message) {
  std::string_view key = message.substr(0, message.find(" = "));
  if (key.ends_with("_w")) key.remove_suffix(2);
  for (const std::string_view known :
       {"position", "velocity", "angular_velocity", "friction", "appears", "disappears"})
    if (key == known) return std::string(key);
  return "";
}

}  // namespace

BodyProperties properties_of(const SceneBox& box) {
  return box.fixed ? fixed_box_properties(box.size, box.friction, box.restitution)
                   : box_properties(box.size, box.mass, box.friction, box.restitution);
}

SceneMistake::SceneMistake(int box, std::string key, const std::string& message,
                           std::string_view table)
    : std::invalid_argument("tumble: " +
                            (box < 0 ? key
                                     : std::string(table) + "[" + std::to_string(box + 1) + "]" +
                                           (key.empty() ? "" : "." + key)) +
                            message),
      box_(box),
      key_(std::move(key)),
      table_(table) {}

std::string_view message_of(const std::invalid_argument& error) {
  constexpr std::string_view program = "tumble: ";
  const std::string_view text = error.what();
  return text.substr(0, program.size()) == program ? text.substr(program.size()) : text;
}

World start_world(Scene& scene) {
  if (scene.boxes.empty()) throw SceneMistake(-1, "box", ": a scene needs at least one");
  World world;
  try {
    if (scene.ground) world.add_ground(scene.ground->friction, scene.ground->restitution);
    require_gravity(scene.gravity_w);
  } catch (const std::invalid_argument& error) {
    throw SceneMistake(-1, "", std::string(message_of(error)));
  }
  world.gravity_w = scene.gravity_w;
  settle_names(scene.boxes, "box", "boxes", scene.ground.has_value(),
               [](std::size_t place, const std::string& message) {
                 throw SceneMistake(static_cast<int>(place), "name", message);
               });
  MassRange masses;  // of boxes that appear later, too
  for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
    const SceneBox& box = scene.boxes[i];
    try {
      const BodyProperties body = properties_of(box);
      require::not_negative(box.appears, "appears");
      if (!(box.disappears > box.appears))
        refuse("disappears = " + shortest_text(box.disappears) + ": expected later than " +
               shortest_text(box.appears) + " s, when it appears");
      const BodyState state = state_of(box, body);
      masses.add(body, box.name);
      if (!(box.appears > 0.0)) world.add(body, state, box.name);
    } catch (const std::invalid_argument& error) {
      const std::string name = ", " + box.name + ": ";
      SceneMistake mistake(static_cast<int>(i), "", name + std::string(message_of(error)));
      mistake.set_key(key_of(message_of(error)));
      throw mistake;
    }
  }
  join_bodies(scene, world);
  refuse_overlaps(scene, world);
  check_wishes(scene);
  return world;
}

Scene checked(Scene scene) {
  start_world(scene);
  return scene;
}

World build_world(const Scene& scene) {
  Scene named = scene;
  return start_world(named);
}

void add_box(const SceneBox& box, World& world) {
  const BodyProperties body = properties_of(box);
  world.add(body, state_of(box, body), box.name);
}

double due_until(double time, double dt) { return time + tolerance::moment * dt; }

void update_boxes(const Scene& scene, double from, double until, World& world) {
  const auto now = [&](double time) { return time > from && time <= until; };
  for (const SceneBox& box : scene.boxes) {
    if (!now(box.disappears)) continue;
    if (const auto id = world.find(box.name)) world.remove(*id);
  }
  for (const SceneBox& box : scene.boxes) {
    // A step so long that a box would come and go within it does not see it.
    if (now(box.appears) && !now(box.disappears)) add_box(box, world);
  }
}

}  // namespace tumble
