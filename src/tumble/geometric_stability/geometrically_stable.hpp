/// \file
/// \brief Who stands firm: the listing SETGEOMETRICALLYSTABLE (thesis 5.4, A.2).
///
/// Uses no other chapter.
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/geometric_stability/support_polygon.hpp"
#include "tumble/geometric_stability/tolerances.hpp"

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// How it is told which boxes stand firm: by one of the thesis's two definitions, or by balance.
enum class StableRule : std::uint8_t {
  off,         ///< nobody is geometrically stable but immovable bodies
  corners,     ///< all four lower corners are on stable bodies: the text and the listing
  hull,        ///< the hull of the points on stable bodies covers the body's outline: the footnote
  equilibrium  ///< ours: hull, and whole groups that are in balance under their weight (StableBoxes)
};

/// How exact supports have to be.
struct StabilityTolerances {
  double vertical = tolerance::vertical_normal;  ///< [-] sine of a normal to the vertical
  double corner =
      tolerance::corner_support;  ///< [-] of the shortest edge: a corner off its support
  /// [-] share of sqrt(gL): who sinks or tips faster is not stable either; infinity: not looked at,
  /// as in the thesis
  double steady = std::numeric_limits<double>::infinity();
};

/// Why a body is geometrically stable, or what speaks against it.
enum class StabilityReason : std::uint8_t {
  immovable,         ///< stable: it has infinite mass
  carried,           ///< stable: whatever is put on it, what is below takes it up
  moving,            ///< goes up, or, where that is looked at, sinks or tips
  side_contact,      ///< has a contact with another normal than the vertical: `contact`
  unstable_support,  ///< rests on a body that is not stable: `contact`
  corner             ///< stable bodies do not hold this corner of its outline: `corner_xz`
};

/// What was found about one body.
struct StabilityVerdict {
  StabilityReason reason = StabilityReason::immovable;  ///< see there
  int contact = -1;               ///< which contact speaks against it; -1: none does
  Vec2 corner_xz = Vec2::Zero();  ///< [m] corner: where it is, x and z; else 0

  /// Whether the body stands firm.
  /// \return true if so
  [[nodiscard]] bool stable() const {
    return reason == StabilityReason::immovable || reason == StabilityReason::carried;
  }
};

/// A verdict in words.
/// \param world     names of bodies
/// \param contacts  those for which it was found
/// \param verdict   what was found
/// \return for example "the corner at x = 1 m, z = 0.5 m is not carried"
std::string told(const World& world, std::span<const Contact> contacts,
                 const StabilityVerdict& verdict);

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
/// outline only if it has a point there. For other shapes only the hull can tell: they come with
/// an outline of their own.
/// \par Cost and determinism
/// A sort of the contact points and, in a pile, one sweep over them; repeated while a sweep finds
/// somebody. The result does not depend on the order of contacts. No allocation once warm.
/// \algorithm{SETGEOMETRICALLYSTABLE: section 5.4 and appendix A.2}
/// \deviation{Vetoes come first and hold for both bodies; immovable bodies keep their mark; comparisons have tolerances.}
/// \verified{Which bodies stand firm does not depend on the order of contacts}
class GeometricStability {
 public:
  /// The outline of a body as seen from above: its corners [m], x and z, in any order.
  using Outline = std::vector<Vec2>;

  /// \param tolerances how exact supports have to be
  explicit GeometricStability(const StabilityTolerances& tolerances = {})
      : tolerances_(tolerances) {}

  /// Finds who is stable.
  /// \param world     the bodies where they are
  /// \param contacts  all points of all contact areas, with a margin (tolerance::stability_margin)
  /// \param rule      which definition; `equilibrium` is taken for `hull`
  /// \param rising    [-] share of m sqrt(gL): a body with more upward momentum is going up
  /// \param stable    out: one for each body index, 1 if it is stable
  /// \param outlines  of bodies that are no boxes, by index; one without corners is that of the box.
  ///                  May be empty: all are boxes
  /// \param moving    by index, not 0: counts as going up. May be empty: nobody else does
  /// \throws std::invalid_argument for outlines or marks that are not one for each body
  void run(const World& world, std::span<const Contact> contacts, StableRule rule, double rising,
           std::vector<char>& stable, std::span<const Outline> outlines = {},
           std::span<const char> moving = {});

  /// Sets how exact supports have to be from now on.
  /// \param tolerances see there
  void set_tolerances(const StabilityTolerances& tolerances) { tolerances_ = tolerances; }

  /// Why a body was found stable, or not, by the last run() with a rule other than `off`.
  /// \param world  as it was
  /// \param body   its index
  /// \return of what speaks against it, the first: motion, a side contact, a support, a corner
  [[nodiscard]] StabilityVerdict verdict(const World& world, int body);

 private:
  struct Point {
    double height = 0.0;  // [m]
    int top = 0;
    int bottom = 0;
    Vec2 xz = Vec2::Zero();  // [m]
    int contact = 0;         // which one it belongs to
  };
  void sort_contact_points_ascending(std::span<const Contact> contacts);
  void find_vetoes(const World& world, std::span<const Contact> contacts, double rising,
                   std::span<const char> moving);
  void mark_projected_corners(const World& world, const Point& c);
  void take_hull(int body);
  [[nodiscard]] bool covered(const World& world, int body);
  void take_outline(const World& world, int body);

  // Instead of a contact's place, in vetoes_.
  static constexpr int kNone = -1;
  static constexpr int kMoving = -2;

  StabilityTolerances tolerances_;
  StableRule rule_ = StableRule::off;
  std::vector<Outline> outlines_;
  std::vector<char> stable_;  // as run() found it
  std::vector<Point> sorted_;
  std::vector<int> vetoes_;  // by body: the first contact from the side, kMoving, or kNone
  std::vector<std::uint8_t> corners_;  // a bit for each lower corner that is marked
  std::vector<char> holds_;            // for sorted_: whether the body below is stable
  std::vector<int> below_;             // by body: how many points there are under it
  std::vector<int> held_;              // ditto, of these on stable bodies
  std::vector<Vec2> hull_;             // of the points under one body
  std::vector<Vec2> points_;           // ditto, to be sorted
  Outline outline_;                    // of one body
};

}  // namespace tumble
