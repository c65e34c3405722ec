/// \file
/// \brief The numbers of a glTF file: a buffer with views and accessors.
#pragma once

#include "tumble/record/json.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace tumble {

/// Builder for the buffer of a glTF file, with its views and accessors.
class GltfBuffer {
 public:
  /// The use of a part of the buffer.
  enum class Use {
    vertices,  ///< points or normals of a mesh
    indices,   ///< of its triangles
    keys,      ///< of animations; all of them share a view
  };

  /// Adds rows of numbers in single precision.
  /// \param use      vertices or keys
  /// \param columns  of a row: 1, 3 or 4
  /// \param numbers  row by row, at least one row
  /// \param bounds   whether to give the minimum and maximum of each column, as glTF requires for points
  ///                 and times
  /// \return the index of the accessor
  std::int64_t add(Use use, int columns, const std::vector<float>& numbers, bool bounds);

  /// Adds indices of points.
  /// \param numbers at least one
  /// \return the index of the accessor
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
    bool whole = false;  // indices of points
    std::vector<float> low, high;
  };

  View& view_for(Use use);
  void put(std::uint32_t number, int bytes);

  std::string bytes_;
  std::vector<View> views_;
  std::vector<Accessor> accessors_;
};

}  // namespace tumble
