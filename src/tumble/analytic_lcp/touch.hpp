/// \file
/// \brief The state of a contact point: about to collide, colliding, at rest, or separating (thesis 3.3.1, 4.3).
#pragma once

#include "tumble/contact/gather.hpp"

#include <cstdint>

namespace tumble {

/// What a point of a contact does at an instant.
enum class PointMotion : std::uint8_t {
  waits,     ///< approaches, and the surfaces are still apart: a collision to come
  collides,  ///< approaches, and the surfaces touch
  rests,     ///< touches or nearly so, and moves neither way to speak of: there is a contact force
  parts      ///< moves apart
};

/// The size of a pair [m]: the shortest edge of the smaller one; the ground has none.
double pair_size(const World& world, int first, int second);

/// What lengths and speeds of a pair of bodies are compared with.
struct TouchScale {
  double size = 1.0;           ///< [m] the shortest edge of the smaller body
  double resting_speed = 0.0;  ///< [m/s] slower than this a point rests
};

/// The scale of a pair.
/// \param dt      [s] the time step; matters only where there is no gravity
/// \return L and tolerance::resting_speed times sqrt(g L); without gravity
///         tolerance::resting_speed_weightless times L / dt
TouchScale touch_scale(const World& world, int first, int second, double dt);

/// What a point does.
/// \param point  its distance, and its approach speed of now
/// \return see PointMotion; surfaces that are less than tolerance::contact_gap apart touch
PointMotion motion_of(const ContactPoint& point, const TouchScale& scale);

/// Finds all points within the margin of their pair, tolerance::contact_margin of its size.
/// \param candidates  pairs as gather_contacts() takes them
/// \param previous    contacts of an earlier instant: axes and impulses are taken over from them
/// \param out         is overwritten; every contact has a point. Not `previous`
/// \throws std::invalid_argument as gather_contacts()
GatherReport gather_near(const World& world, std::span<const MovingBody> bodies,
                         std::span<const IndexPair> candidates, std::span<const Contact> previous,
                         ContactList& out);

/// The same for all pairs of a world at an instant.
/// \param out     is overwritten; contacts in the order of their indices
/// \par Cost
/// n log n, and a closest-feature search for each pair whose boxes come near.
void gather_near(const World& world, std::span<const MovingBody> bodies, ContactList& out);

/// Takes points out of contacts, and then contacts that have none left.
/// \param contacts  in and out; the order of what stays is kept
/// \param keep      called with a contact and one of its points; false takes the point out
template <class Keep>
void keep_points(ContactList& contacts, const Keep& keep) {
  std::size_t kept = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    Contact& contact = contacts[c];
    int count = 0;
    for (int k = 0; k < contact.count; ++k) {
      const ContactPoint point = contact.points[static_cast<std::size_t>(k)];
      if (keep(contact, point)) contact.points[static_cast<std::size_t>(count++)] = point;
    }
    contact.count = count;
    if (count == 0) continue;
    if (kept != c) contacts[kept] = contact;
    ++kept;
  }
  contacts.resize(kept);
}

/// Pairs that may touch later in a flight: those that rest on each other, and of bodies that slide far those that they may
/// come to stand on.
/// \param world       the bodies at its start
/// \param bodies      how they move there, one for each body index
/// \param resting     contacts at its start, in ascending order
/// \param candidates  pairs that may meet, in ascending order
/// \param time        [s] from its start
/// \param out         is overwritten, in ascending order
void pairs_after(const World& world, std::span<const MovingBody> bodies,
                 std::span<const Contact> resting, std::span<const IndexPair> candidates,
                 double time, std::vector<IndexPair>& out);

}  // namespace tumble
