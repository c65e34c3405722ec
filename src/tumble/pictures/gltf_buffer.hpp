/// \file
/// \brief The numbers of a glTF file: a buffer, and what is where in it.
#pragma once

#include "tumble/record/json.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace tumble {

/// The buffer of a glTF file as it is being filled, with its views and accessors.
class GltfBuffer {
 public:
  /// What the numbers of a part are for.
  enum class Use {
    vertices,  ///< points or normals of a mesh
    indices,   ///< of its triangles
    keys,      ///< of animations; all of them share a view
  };

  /// Adds rows of numbers in single precision.
  /// \param use      vertices or keys
  /// \param columns  of a row: 1, 3 or 4
  /// \param numbers  row by row, at least one row
  /// \param bounds   whether the least and the largest number of each column are told, as glTF asks for
  ///                 with points and times
  /// \return the number of the accessor
  std::int64_t add(Use use, int columns, const std::vector<float>& numbers, bool bounds);

  /// Adds numbers of points.
  /// \param numbers at least one
  /// \return the number of the accessor
  std::int64_t add(const std::vector<std::uint16_t>& numbers);

  /// Writes accessors, views and the buffer itself as the fields of a glTF file.
  /// \param json an object is open in it
  void write(Json& json) const;

 private:
  struct View {
    std::size_t offset = 0;  // [bytes]
    std::size_t length = 0;  // [bytes]
    Use use = Use::keys;
  };
  struct Accessor {
    std::size_t view = 0;
    std::size_t offset = 0;  // [bytes] in the view
    std::size_t rows = 0;
    int columns = 0;
    bool whole = false;  // numbers of points
    std::vector<float> low, high;
  };

  View& view_for(Use use);
  void put(std::uint32_t number, int bytes);

  std::string bytes_;
  std::vector<View> views_;
  std::vector<Accessor> accessors_;
};

}  // namespace tumble
