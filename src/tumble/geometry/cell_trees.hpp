/// \file
/// \brief The broad phases that divide space itself: kd-tree and octree (thesis 4.1).
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/geometry/broad_phase.hpp"

#include <array>

namespace tumble {

/// Space is cut into cells, and cells into smaller ones, as long as that saves tests.
///
/// A body belongs to each cell that its bounds reach into, so that it may be in several. In a cell that is cut no
/// further all bodies are tested against one another. Two that overlap share several cells as well; they count where the low
/// corner of their overlap lies, which is in exactly one. The cells are made anew in each call: nothing is remembered.
///
/// A cut is made if the pairs in all its parts together are at most three quarters of those in the cell.
class CellTree : public BroadPhase {
 protected:
  static constexpr int kMostLevels =
      24;  ///< [-] of cells within cells: a millionth of the scene, three axes each, for a kd-tree

  /// Where to cut a cell.
  struct Cut {
    std::array<bool, 3> axes{};  ///< along which axes; none: no cut
    Vec3 at = Vec3::Zero();      ///< [m] the planes
  };

  /// Chooses the planes at which a cell is cut.
  /// \param bodies  those in the cell
  /// \param extent  the part of space that the cell stands for
  [[nodiscard]] virtual Cut cut_of(std::span<const Bounds> bounds, std::span<const int> bodies,
                                   const Bounds& extent) = 0;

  void search(std::span<const Bounds> bounds, std::vector<IndexPair>& out) override;

 private:
  // A cell: the bodies from begin on to the end of the list.
  struct Cell {
    Bounds
        owned;  // [m] half open; its low corner belongs to it. The outermost cells reach to infinity
    Bounds extent;  // [m] the same within what the bodies cover
    std::size_t begin = 0, end = 0;
    int level = 0;
  };

  void search_cell(std::span<const Bounds> bounds, const Cell& cell, std::vector<IndexPair>& out);
  void test_all(std::span<const Bounds> bounds, const Cell& cell, std::vector<IndexPair>& out);

  std::vector<int> bodies_;  // of the cell and of those that it is a part of
};

/// A kd-tree: each cell is cut in two by one plane, through the median of its bodies along the axis where they are spread
/// most.
/// \see Bentley, "Multidimensional binary search trees used for associative searching", Comm. ACM 18(9), 1975.
/// \algorithm{Spatial subdivision: section 4.1}
/// \verified{All broad phases agree on thousands of random scenes}
class KdTree final : public Cloned<CellTree, KdTree> {
 public:
  [[nodiscard]] std::string_view name() const override { return "kd_tree"; }

 private:
  [[nodiscard]] Cut cut_of(std::span<const Bounds> bounds, std::span<const int> bodies,
                           const Bounds& extent) override;

  std::vector<double> lows_;
};

/// An octree: each cell is cut into eight equal ones.
///
/// It knows nothing of where in a cell the bodies are, so a single body far away takes some levels.
/// \see Meagher, "Geometric modeling using octree encoding", Computer Graphics and Image Processing 19, 1982.
/// \algorithm{Spatial subdivision: section 4.1}
/// \verified{All broad phases agree on thousands of random scenes}
class Octree final : public Cloned<CellTree, Octree> {
 public:
  [[nodiscard]] std::string_view name() const override { return "octree"; }

 private:
  [[nodiscard]] Cut cut_of(std::span<const Bounds> bounds, std::span<const int> bodies,
                           const Bounds& extent) override;
};

}  // namespace tumble
