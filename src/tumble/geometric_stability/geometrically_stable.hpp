/// \file
/// \brief Who stands firm: the listing SETGEOMETRICALLYSTABLE (thesis 5.4, A.2).
///
/// Uses no other chapter.
#pragma once

#include "tumble/base/tolerance.hpp"
#include "tumble/contact/contact.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace tumble {

/// By which of the thesis's two definitions a box stands firm.
enum class StableRule : std::uint8_t {
  off,      ///< nobody is geometrically stable but immovable bodies
  corners,  ///< all four lower corners are on stable bodies: the text and the listing
  hull      ///< the hull of the points on stable bodies covers the body's outline: the footnote
};

/// The rule that a user means.
/// \param name "off", "corners" or "hull"
/// \return the rule
/// \throws std::invalid_argument for any other name, with the list of choices
StableRule stable_rule_from(std::string_view name);

/// The listing SETGEOMETRICALLYSTABLE, in the sense in which it was meant.
///
/// A body is geometrically stable if it does not accelerate, whatever vertical forces its contacts
/// have and without friction: it is immovable, or
/// - all its contacts have normals along the y axis,
/// - those below it are with stable bodies only, and
/// - they are under all four lower corners (`corners`), or their hull covers the outline of the
///   body as seen from above (`hull`).
///
/// Any load on such a body acts inside the hull of what holds it, so supports can push back without
/// a pull. It is sufficient, not necessary: by itself a box stands if only its centre is over the
/// hull.
///
/// **Mended.** What speaks against a body is found first, and for both bodies of a contact: the
/// listing clears only the upper one, and a later corner may overrule it, so that the order of
/// equal heights decides. Immovable bodies are never cleared. Corner marks start empty. Directions,
/// corners and gaps have tolerances. Who is still going up is not stable yet.
///
/// For boxes both rules say the same, but for their tolerance: a hull covers a corner of the
/// outline only if it has a point there.
/// \par Cost and determinism
/// A sort of the contact points and, in a pile, one sweep over them; repeated while a sweep finds
/// somebody. The result does not depend on the order of contacts. No allocation once warm.
/// \algorithm{SETGEOMETRICALLYSTABLE: section 5.4 and appendix A.2}
/// \deviation{Vetoes come first and hold for both bodies; immovable bodies keep their mark; comparisons have tolerances.}
/// \verified{Who stands firm does not depend on the order of contacts}
class GeometricStability {
 public:
  /// Finds who is stable.
  /// \param world     the bodies where they are
  /// \param contacts  all points of all contact areas, with a margin (tolerance::stability_margin)
  /// \param rule      which definition
  /// \param rising    [-] share of m sqrt(gL): a body with more upward momentum is going up
  /// \param stable    out: one for each body index, 1 if it is stable
  void run(const World& world, std::span<const Contact> contacts, StableRule rule, double rising,
           std::vector<char>& stable);

 private:
  struct Point {
    double height = 0.0;  // [m]
    int top = 0;
    int bottom = 0;
    Vec2 xz = Vec2::Zero();  // [m]
  };
  void sort_contact_points_ascending(std::span<const Contact> contacts);
  void find_vetoes(const World& world, std::span<const Contact> contacts, double rising);
  void mark_projected_corners(const World& world, const Point& c);
  [[nodiscard]] bool covered(const World& world, int body);

  std::vector<Point> sorted_;
  std::vector<char> vetoed_;
  std::vector<std::uint8_t> corners_;  // a bit for each lower corner that is marked
  std::vector<char> holds_;            // for sorted_: whether the body below is stable
  std::vector<int> below_;             // by body: how many points there are under it
  std::vector<int> held_;              // ditto, of these on stable bodies
  std::vector<Vec2> hull_;             // of the points under one body
  std::vector<Vec2> points_;           // ditto, to be sorted
};

/// The corners of the face of a box that looks down most, seen from above.
/// \param box the box
/// \return [m] x and z of each, in order around the face
[[nodiscard]] std::array<Vec2, 4> lower_corners(const Box& box);

/// The convex hull of points in a plane (Andrew's monotone chain).
/// \param points  in any order; sorted on return
/// \param hull    out: its corners, counterclockwise, without those within an edge
void convex_hull(std::vector<Vec2>& points, std::vector<Vec2>& hull);

/// Whether a point lies in a convex polygon, or outside by no more than a margin.
/// \param hull    from convex_hull(); may be a line or a point
/// \param point   [m]
/// \param margin  [m] at least 0
/// \return false for an empty hull
[[nodiscard]] bool hull_contains(std::span<const Vec2> hull, const Vec2& point, double margin);

}  // namespace tumble
