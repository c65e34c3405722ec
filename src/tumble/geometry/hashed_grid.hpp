/// \file
/// \brief The broad phase that sorts bodies into the cells of a hashed grid (thesis 4.1).
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/geometry/broad_phase.hpp"

namespace tumble {

/// A grid of equal cells without limits: only the cells that hold a body exist, in a hash table.
///
/// The edge of a cell is twice the median extent of the bodies. A body is entered into every cell
/// that it reaches, eight at most, and tested against the others there. A body that reaches more
/// cells is big: it is tested against all others. So are bodies that reach to infinity. With
/// sizes within a factor of a few of each other the cost is proportional to n; if a large part of
/// the bodies is far bigger than the median, BoundingTree is the better choice.
///
/// Nothing but room is remembered. Two cells may share a bucket of the table; every entry carries
/// its cell, so this costs time and changes nothing.
///
/// \see Teschner, Heidelberger, Müller, Pomeranets, Gross, "Optimized Spatial Hashing for Collision
///      Detection of Deformable Objects", VMV 2003.
/// \algorithm{Spatial subdivision: section 4.1}
/// \verified{All broad phases agree on thousands of random scenes}
class HashedGrid final : public Cloned<BroadPhase, HashedGrid> {
 public:
  [[nodiscard]] std::string_view name() const override { return "hashed_grid"; }

 private:
  using Cell = Eigen::Vector3i;  // where a cell is, in edges from the origin
  // The cells that a body reaches, from..to in each direction.
  struct Range {
    Cell from = Cell::Zero();
    Cell to = Cell::Zero();
    bool big = false;
  };
  // A body in a cell.
  struct Entry {
    int body = 0;
    Cell cell = Cell::Zero();
  };

  void search(std::span<const Bounds> bounds, std::vector<IndexPair>& out) override;
  double cell_edge(std::span<const Bounds> bounds);
  void enter(std::span<const Bounds> bounds, double edge);
  void search_bucket(std::span<const Bounds> bounds, std::size_t bucket,
                     std::vector<IndexPair>& out);
  [[nodiscard]] std::size_t bucket_of(const Cell& cell) const;
  template <class Visit>
  void for_each_cell(const Range& range, const Visit& visit) const;

  std::vector<double> extents_;     // of all finite bodies, for their median
  std::vector<Range> ranges_;       // of every body
  std::vector<int> big_;            // bodies that are tested against all others
  std::vector<std::size_t> begin_;  // where each bucket begins in entries_; length 2^k + 2
  std::vector<Entry> entries_;      // the contents of all buckets
};

}  // namespace tumble
