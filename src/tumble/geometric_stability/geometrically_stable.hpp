/// \file
/// \brief Geometric stability: the listing SETGEOMETRICALLYSTABLE (thesis 5.4, A.2).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/geometric_stability/support_polygon.hpp"
#include "tumble/geometric_stability/tolerances.hpp"

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace tumble {

/// Definition of geometric stability: one of the thesis's two, or static equilibrium.
enum class StableRule : std::uint8_t {
  off,         ///< only immovable bodies are geometrically stable
  corners,     ///< all four lower corners are on stable bodies: the text and the listing
  hull,        ///< the hull of the points on stable bodies covers the body's outline: the footnote
  equilibrium  ///< ours: hull, and whole islands in equilibrium under their weight (StableBoxes)
};

/// Tolerances of supports.
struct StabilityTolerances {
  double vertical = tolerance::vertical_normal;  ///< [-] sine of a normal to the vertical
  double corner =
      tolerance::corner_support;  ///< [-] of the shortest edge: a corner off its support
  /// [-] share of sqrt(gL): a body that sinks or tips faster is not stable; infinity: not tested, as in
  /// the thesis
  double steady = std::numeric_limits<double>::infinity();
};

/// Reason for a body's geometric stability, or against it.
enum class StabilityReason : std::uint8_t {
  immovable,         ///< stable: it has infinite mass
  supported,         ///< stable: its supports can balance any load on it
  moving,            ///< rises or, where that is tested, sinks or tips
  side_contact,      ///< has a contact whose normal is not vertical: `contact`
  unstable_support,  ///< rests on a body that is not stable: `contact`
  corner             ///< stable bodies do not support this corner of its outline: `corner_xz`
};

/// Result for one body.
struct StabilityVerdict {
  StabilityReason reason = StabilityReason::immovable;  ///< see there
  int contact = -1;               ///< index of the contact that is the reason; -1: none
  Vec2 corner_xz = Vec2::Zero();  ///< [m] corner: its x and z; otherwise 0

  /// Whether the body is geometrically stable.
  [[nodiscard]] bool stable() const {
    return reason == StabilityReason::immovable || reason == StabilityReason::supported;
  }
};

/// Explanation of a verdict in words.
/// \param contacts  contacts of the run that found it
/// \return for example "the corner at x = 1 m, z = 0.5 m is not supported"
std::string explanation(const World& world, std::span<const Contact> contacts,
                        const StabilityVerdict& verdict);

/// The listing SETGEOMETRICALLYSTABLE, as it was meant.
///
/// A body is geometrically stable if it does not accelerate under any vertical contact forces, without
/// friction: it is immovable, or
/// - all its contacts have normals along the y axis,
/// - all contacts below it are with stable bodies, and
/// - these are under all four lower corners (`corners`), or their hull covers the outline of the
///   body as seen from above (`hull`).
///
/// Any load on such a body acts inside the hull of its supports, which can balance it by pushing. The
/// condition is sufficient, not necessary: a box alone stands if its centre is over the hull.
///
/// **Mended.** Vetoes are found first, and for both bodies of a contact: the listing clears only the
/// upper body's mark, and a later corner may set it again, so that the order of contacts at equal heights
/// matters. Immovable bodies are never cleared. Corner marks start empty. Directions, corners and
/// gaps have tolerances. A rising body is not stable.
///
/// For boxes the two rules agree up to tolerances: a hull covers a corner of the outline only if it
/// has a point there. Other shapes, which come with their own outline, need the hull.
/// \par Cost and determinism
/// A sort of the contact points and, in a pile, one sweep over them; another sweep as long as stable bodies
/// are found. The result does not depend on the order of contacts. No allocation once warm.
/// \algorithm{SETGEOMETRICALLYSTABLE: section 5.4 and appendix A.2}
/// \deviation{Vetoes come first and hold for both bodies; immovable bodies keep their mark; comparisons have tolerances.}
/// \verified{The set of stable bodies does not depend on the order of contacts}
class GeometricStability {
 public:
  /// The outline of a body as seen from above: its corners [m], x and z, in any order.
  using Outline = std::vector<Vec2>;

  /// \param tolerances of supports
  explicit GeometricStability(const StabilityTolerances& tolerances = {})
      : tolerances_(tolerances) {}

  /// Finds the stable bodies.
  /// \param contacts  all points of all contact areas, with a margin (tolerance::stability_margin)
  /// \param rule      definition; `equilibrium` is treated as `hull`
  /// \param rising    [-] share of m sqrt(gL): a body with more upward momentum is rising
  /// \param stable    out: one for each body index, 1 if it is stable
  /// \param outlines  of bodies other than boxes, by index; an empty one is that of the box. May be
  ///                  empty: all are boxes
  /// \param moving    by index, not 0: treated as rising. May be empty
  /// \throws std::invalid_argument for outlines or marks that are not one for each body
  void run(const World& world, std::span<const Contact> contacts, StableRule rule, double rising,
           std::vector<char>& stable, std::span<const Outline> outlines = {},
           std::span<const char> moving = {});

  /// Sets the tolerances of supports.
  void set_tolerances(const StabilityTolerances& tolerances) { tolerances_ = tolerances; }

  /// Reason for a body's stability, or against it, in the last run() with a rule other than `off`.
  /// \param world  as in that run
  /// \return the first reason against: motion, a side contact, a support, a corner
  [[nodiscard]] StabilityVerdict verdict(const World& world, int body);

 private:
  struct Point {
    double height = 0.0;  // [m]
    int top = 0;
    int bottom = 0;
    Vec2 xz = Vec2::Zero();  // [m]
    int contact = 0;         // its contact
  };
  void sort_contact_points_ascending(std::span<const Contact> contacts);
  void find_vetoes(const World& world, std::span<const Contact> contacts, double rising,
                   std::span<const char> moving);
  void mark_projected_corners(const World& world, const Point& c);
  void take_hull(int body);
  [[nodiscard]] bool covered(const World& world, int body);
  void take_outline(const World& world, int body);

  // Values of vetoes_ other than a contact's index.
  static constexpr int kNone = -1;
  static constexpr int kMoving = -2;

  StabilityTolerances tolerances_;
  StableRule rule_ = StableRule::off;
  std::vector<Outline> outlines_;
  std::vector<char> stable_;  // result of run()
  std::vector<Point> sorted_;
  std::vector<int> vetoes_;            // by body: the first side contact, kMoving, or kNone
  std::vector<std::uint8_t> corners_;  // a bit for each marked lower corner
  std::vector<char> holds_;            // for sorted_: whether the lower body is stable
  std::vector<int> below_;             // by body: number of points below it
  std::vector<int> held_;              // by body: number of these on stable bodies
  std::vector<Vec2> hull_;             // of the points below one body
  std::vector<Vec2> points_;           // the same, unsorted
  Outline outline_;                    // of one body
};

}  // namespace tumble
