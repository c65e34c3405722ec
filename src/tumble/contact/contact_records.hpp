/// \file
/// \brief Contacts as users see them: collisions for observers, points for readers and files.
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/dynamics/technique.hpp"

#include <optional>
#include <span>
#include <vector>

namespace tumble {

/// A contact point with its impulse, as users read it.
/// \param time   [s] of the pose that it belongs to
/// \return with normal and friction impulse as they are accumulated in the point
ContactRecord record_of(const Contact& contact, int point, double time);

/// Records of all points of some contacts.
/// \param time     [s] of the pose that they belong to
/// \param records  get one for each point
void add_records(std::span<const Contact> contacts, double time,
                 std::vector<ContactRecord>& records);

/// The collision of two bodies, all points of their contact together.
/// \param contact  with its impulses; they act at their weighted centre
/// \param moment   time, rewinds and restarts are taken over
/// \return the collision; nothing if no point is pushed, that is, if the bodies were separating already
std::optional<Event> event_of(const Contact& contact, const Event& moment);

/// Shows a collision to an observer.
/// \param observer  may be nullptr
/// \return whether there was a collision
bool report_collision(const Contact& contact, const Event& moment, Observer* observer);

}  // namespace tumble
