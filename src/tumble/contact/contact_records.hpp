/// \file
/// \brief What is told about contacts: collisions for observers, points for readers and files.
#pragma once

#include "tumble/contact/contact.hpp"

#include <optional>

namespace tumble {

/// A contact point with its impulse, as users read it.
/// \param contact  the contact
/// \param point    which of its points
/// \param time     [s] of the pose that it belongs to
/// \return with normal and friction impulse as they are accumulated in the point
ContactRecord record_of(const Contact& contact, int point, double time);

/// The collision of two bodies, all points of their contact together.
/// \param contact  with its impulses; they act at their weighted centre
/// \param moment   time, rewinds and restarts are taken over
/// \return the collision; nothing if no point is pushed, that is, if the bodies were parting already
std::optional<Event> event_of(const Contact& contact, const Event& moment);

}  // namespace tumble
