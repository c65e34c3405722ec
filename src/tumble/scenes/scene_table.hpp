/// \file
/// \brief A table of a scene file, without the library that reads TOML.
#pragma once

#include "tumble/base/types.hpp"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// A table of a scene file: its values, and refusals that point at the line of a key.
///
/// What reads a value returns whether there is one, leaves `out` alone if not, and throws std::invalid_argument for a value of
/// another kind.
class SceneTable {
 public:
  virtual ~SceneTable() = default;

  /// Refuses the value of a key, or the lack of one.
  /// \param key     of this table
  /// \param wanted  what would be right
  /// \throws std::invalid_argument "FILE:LINE: KEY = VALUE: wanted"
  [[noreturn]] virtual void refuse(std::string_view key, const std::string& wanted) const = 0;
  /// Refuses any other key.
  /// \throws std::invalid_argument as refuse()
  virtual void only(std::initializer_list<std::string_view> known) const = 0;

  /// Reads a number.
  virtual bool number(std::string_view key, double& out) const = 0;
  /// Reads three numbers.
  virtual bool vector(std::string_view key, Vec3& out) const = 0;
  /// Reads a quaternion, w first.
  virtual bool quaternion(std::string_view key, Quat& out) const = 0;
  /// Reads a text.
  virtual bool text(std::string_view key, std::string& out) const = 0;
  /// Reads a text or a list of texts.
  virtual bool texts(std::string_view key, std::vector<std::string>& out) const = 0;
  /// Reads true or false.
  virtual bool flag(std::string_view key, bool& out) const = 0;
};

struct SceneBox;
struct SceneJoint;
struct Wish;

/// Reads friction and restitution.
/// \param table        a box or the ground
/// \param friction     [-] left alone if there is none
/// \param restitution  [-] left alone if there is none
/// \throws std::invalid_argument for a value out of range
void read_surface(const SceneTable& table, double& friction, double& restitution);

/// Reads a box.
/// \return the box, not checked beside others
/// \throws std::invalid_argument for a key or a value that is wrong
SceneBox read_box(const SceneTable& table);

/// Reads a joint. What its values mean is checked by join_bodies().
/// \return the joint, not checked against the scene
/// \throws std::invalid_argument for a key or a value that is wrong
SceneJoint read_joint(const SceneTable& table);

/// Reads a wish.
/// \return the wish, not checked against the scene
/// \throws std::invalid_argument for a key or a value that is wrong
Wish read_wish(const SceneTable& table);

}  // namespace tumble
