/// \file
/// \brief From pairs of bodies that are near each other to the contacts of a step (thesis 3.2).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/geometry/broad_phase.hpp"

#include <cstdint>

namespace tumble {

/// Contact points of two bodies, either of which may be the ground.
/// \param states      poses of all bodies
/// \param margin      [m] surfaces up to this far apart count as touching, at least 0
/// \param remembered  the axis that the pair had before, or kNoAxis
/// \param out         is overwritten; the normal points from the first to the second
/// \return whether there is a point
bool touch_pair(const World& world, std::span<const BodyState> states, const IndexPair& pair,
                double margin, AxisIndex remembered, Manifold& out);

/// The same of two bodies whose boxes are known.
/// \param first       the box of the first; not used for the ground
/// \param second      ditto of the second
bool touch_pair(const World& world, const IndexPair& pair, const Box& first, const Box& second,
                double margin, AxisIndex remembered, Manifold& out);

/// Sets bodies, friction (the geometric mean of the two coefficients) and restitution (the larger).
/// \param contact  in and out; the rest of it stays
void set_pair(const World& world, const IndexPair& pair, Contact& contact);

/// The same of a contact without points.
Contact contact_of(const World& world, const IndexPair& pair);

/// Takes over normal and points.
/// \param manifold  as touch_pair() finds it
/// \param contact   in and out; the impulses of its points stay
void set_points(const Manifold& manifold, Contact& contact);

/// The speed at which a pair approaches at its fastest point.
/// \return [m/s] the least normal velocity; below 0 they approach
double least_normal_speed(const Contact& contact, std::span<const MovingBody> bodies);

/// What gather_contacts() did.
struct GatherReport {
  std::int64_t pair_tests = 0;   ///< pairs of which the geometry was looked at
  std::int64_t points = 0;       ///< contact points found
  double deepest_overlap = 0.0;  ///< [m] 0 or above
};

/// Finds the contacts among pairs of bodies.
///
/// Pairs of two immovable bodies are skipped. Friction is the geometric mean of the two bodies'
/// coefficients, restitution the larger. Each point gets its present approach speed, which Newton's
/// restitution uses for the whole event; impulses are 0 (see carry_over_impulses()).
/// \param candidates  pairs by index, first < second, each once, sorted, as a BroadPhase gives them
/// \param margin      [m] surfaces up to this far apart count as touching, at least 0
/// \param previous    contacts of an earlier step, sorted by id; may be empty. A pair that touched
///                    then is looked at along the axis that it had. Must not be `out`: keep two
///                    lists and swap them
/// \param out         is overwritten; sorted by id
/// \throws std::invalid_argument if there is not one entry of `bodies` for each body, for a pair
///         out of range or out of order, or a margin that is negative or not finite
/// \par Cost and determinism
/// One test of two boxes for each candidate; no allocation once `out` is warm. The result depends
/// on the remembered axes only within `tolerance::face_preference`.
GatherReport gather_contacts(const World& world, std::span<const MovingBody> bodies,
                             std::span<const IndexPair> candidates, double margin,
                             std::span<const Contact> previous, ContactList& out);

/// How far contact has to reach among bodies that a search for collisions has stopped just before
/// they touch: as far as two of them can come in twice its resolution, and `tolerance::contact_gap`
/// of their size.
/// \param pairs       bodies that are about to touch
/// \param resolution  [s] of the search
/// \return [m]
[[nodiscard]] double search_margin(const World& world, std::span<const MovingBody> bodies,
                                   std::span<const IndexPair> pairs, double resolution);

/// Gives points that touched before the impulses that they had, as a start for iterative solvers.
///
/// A point is the same if its pair and its feature are. The rest of the friction impulse
/// across the new normal is kept.
/// \param previous  contacts of an earlier step, sorted by id
/// \param contacts  contacts of this step, sorted by id; impulses in and out
/// \return how many points were found again
int carry_over_impulses(std::span<const Contact> previous, std::span<Contact> contacts);

/// Multiplies the impulses of all points, as a start for a step of another length.
/// \param factor    [-] length of this step over that of the one before
void scale_impulses(double factor, std::span<Contact> contacts);

/// Stamps every point with the speed at which the bodies approach there now.
/// \param contacts  approach speeds are overwritten
void stamp_approach_speeds(std::span<const MovingBody> bodies, std::span<Contact> contacts);

}  // namespace tumble
