/// \file
/// \brief A scene: the bodies at the start of a run.
#pragma once

#include "tumble/dynamics/world.hpp"
#include "tumble/scenes/scene_joint.hpp"
#include "tumble/scenes/wish.hpp"

#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// One box of a scene; the fields are the keys of scene files.
struct SceneBox {
  std::string name = {};                   ///< unique; empty: see checked()
  Vec3 size = Vec3::Ones();                ///< [m] full edge lengths
  bool fixed = false;                      ///< immovable; the mass is not used
  double mass = 1.0;                       ///< [kg]
  Vec3 position_w = Vec3::Zero();          ///< [m] centre
  Quat orientation_wb = Quat::Identity();  ///< [-] body to world
  Vec3 velocity_w = Vec3::Zero();          ///< [m/s] of the centre
  Vec3 angular_velocity_w = Vec3::Zero();  ///< [rad/s] world frame
  double friction = 0.5;                   ///< [-] Coulomb's coefficient
  double restitution = 0.0;                ///< [-] 0 sticks, 1 bounces back
  double appears = 0.0;                    ///< [s] when it enters the scene, 0: at the start
  /// [s] when it is removed, later than it appears; infinity: never
  double disappears = std::numeric_limits<double>::infinity();
};

/// The half-space y <= 0 of a scene.
struct SceneGround {
  double friction = 0.5;     ///< [-] Coulomb's coefficient
  double restitution = 0.0;  ///< [-] 0 sticks, 1 bounces back
};

/// The start of a run.
struct Scene {
  std::string title = {};                  ///< one line
  Vec3 gravity_w = Vec3(0.0, -9.81, 0.0);  ///< [m/s²]
  std::optional<SceneGround> ground = {};  ///< none: bodies may fall for ever
  std::vector<SceneBox> boxes = {};        ///< in the order in which they get their ids
  std::vector<Wish> wishes = {};           ///< about its end; only for sampling
  std::vector<SceneJoint> joints = {};     ///< between boxes, or a box and the ground
};

/// The constant part of a box.
/// \throws std::invalid_argument naming the value that is out of range
BodyProperties properties_of(const SceneBox& box);

/// A mistake in a scene. It names its position in the scene, from which a reader of files finds the line.
class SceneMistake : public std::invalid_argument {
 public:
  /// Makes the exception.
  /// \param box      place of the box, or other table, in the scene, from 0; -1 if it is about the scene
  /// \param key      the wrong key of scene files; empty: the box as a whole
  /// \param message  the value and the expected one, for example "= die: two boxes have this name"
  /// \param table    the key of the table in scene files
  SceneMistake(int box, std::string key, const std::string& message,
               std::string_view table = "box");

  /// The box, or other table: its place in the scene, from 0; -1 if it is about the scene.
  [[nodiscard]] int box() const { return box_; }
  /// What it is about, unless it is about the scene: the key of a table in scene files.
  [[nodiscard]] const std::string& table() const { return table_; }
  /// The wrong key of scene files; may be empty.
  [[nodiscard]] const std::string& key() const { return key_; }
  /// Sets the key, where the message names the quantity as SceneBox has it.
  void set_key(std::string key) { key_ = std::move(key); }

 private:
  int box_;
  std::string key_;
  std::string table_;
};

/// The message of a mistake without the name of the program.
/// \param error from this library
/// \return its text without "tumble: "
std::string_view message_of(const std::invalid_argument& error);

/// Checks a scene, names its boxes and builds its world: the ground first, then every box that appears at once.
///
/// A box without a name gets "box" and its place from 1, or the next number that is free.
/// \param scene  as written by a user or built by a program; then each box has a name
/// \throws SceneMistake naming the first value that is wrong: no box, a size or mass that
///         box_properties() refuses, a place or motion that require_motion_limits() refuses, a gravity that require_gravity() refuses,
///         a quaternion that is not of length 1, a name that is used twice, is "ground" beside a ground or has control characters in it, a velocity of
///         a fixed box, a joint that join_bodies() refuses, or two boxes present at the start, not both fixed and
///         in no joint, that overlap by more than `tolerance::start_overlap` of the smaller one's smallest edge
/// \par Cost
/// n log n, and 60 ns for each pair of boxes that are near each other.
World start_world(Scene& scene);

/// Checks a scene and names its boxes.
/// \return the same scene, each box with a name
/// \throws SceneMistake as start_world() does
Scene checked(Scene scene);

/// Checks a scene and builds its world.
/// \throws SceneMistake as start_world() does
World build_world(const Scene& scene);

/// Adds a box in its initial state.
/// \param box    of a scene that is checked
/// \throws std::invalid_argument as World::add(), so if its name is taken by now
void add_box(const SceneBox& box, World& world);

/// The moment up to which boxes appear and disappear before a step: the time, and a little more since it is a sum of
/// rounded steps.
/// \param time  [s] when the step begins
/// \param dt    [s] length of the step before it
/// \return [s] the time and `tolerance::moment` of dt
/// \verified{A box appears with the step that begins at its time, though times are sums of rounded steps}
double due_until(double time, double dt);

/// Removes the boxes that disappear, and adds those that appear, after `from` and until `until`, in the order of the
/// scene.
/// \param scene  the scene that the world was built from
/// \param from   [s] `until` of the last call; 0 at first
/// \param until  [s] due_until() now
/// \throws std::invalid_argument if a name is taken by now
void update_boxes(const Scene& scene, double from, double until, World& world);

}  // namespace tumble
