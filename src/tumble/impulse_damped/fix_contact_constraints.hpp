/// \file
/// \brief The listing FIXCONTACTCONSTRAINTS: pushes that end overlap (thesis 4.4, A.2).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/geometry/separation.hpp"
#include "tumble/impulse_damped/damped_numbers.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// What the pushes did.
struct FixReport {
  int pushes = 0;               ///< of ε1 each
  int given_up = 0;             ///< pairs that still overlap after the most pushes allowed
  std::int64_t pair_tests = 0;  ///< separation tests of two bodies
  double energy = 0.0;          ///< [J] potential energy added
};

/// The listing FIXCONTACTCONSTRAINTS, in the sense in which it was meant.
///
/// Contact points are visited from the lowest to the highest, and the upper body of each is pushed
/// along the normal by ε1 until the two do not overlap. Only positions change, so no kinetic energy
/// is added; potential energy is.
///
/// **Mended.** The normal is that of the bodies' separation where they are now, and pushes are
/// limited: along another normal the loop need not end. An immovable or sleeping body is not
/// pushed; under a shelf the lower body goes down.
///
/// **Kept.** Heights decide the order, one pass is made, and a gap of up to ε1 is left, into which
/// a body falls back. OverlapRepair does otherwise.
/// \algorithm{FIXCONTACTCONSTRAINTS: section 4.4 and appendix A.2}
/// \deviation{The normal is that of the present overlap, pushes are limited, and immovable bodies stay.}
/// \verified{A box in the ground is lifted by whole pushes and left with a gap below one}
class FixContactConstraints {
 public:
  /// Pushes at one contact point, at most. Reason: a tenth of an edge; a deeper overlap gets the rest
  /// in the next step.
  static constexpr int kMostPushes = 100;

  /// Pushes bodies apart.
  /// \param world     positions in and out
  /// \param contacts  the overlaps: all points of each contact area
  FixReport run(World& world, std::span<const Contact> contacts, const DampedNumbers& numbers,
                double dt);

 private:
  struct Point {
    double height = 0.0;  // [m]
    int contact = 0;
    int point = 0;
  };
  // How a pair lies, and how often each of the two had been pushed when that was found.
  struct Known {
    Separation found{};
    std::array<int, 2> pushes{-1, -1};
  };
  std::vector<Point> sorted_;
  std::vector<Known> known_;  // by contact
  std::vector<int> pushes_;   // by body
};

}  // namespace tumble
