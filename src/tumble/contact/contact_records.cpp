/// \file
/// \brief Contacts as users see them.
#include "tumble/contact/contact_records.hpp"

namespace tumble {
namespace {

Vec3 impulse_of(const Contact& contact, const ContactPoint& point) {
  return point.normal_impulse * contact.normal_w + point.friction_impulse_w;
}

}  // namespace

ContactRecord record_of(const Contact& contact, int point, double time) {
  const ContactPoint& p = contact.points[static_cast<std::size_t>(point)];
  return ContactRecord{time,         contact.first_id,        contact.second_id,
                       p.position_w, contact.normal_w,        impulse_of(contact, p),
                       true,         state_of(contact, point)};
}

void add_records(std::span<const Contact> contacts, double time,
                 std::vector<ContactRecord>& records) {
  for (const Contact& contact : contacts)
    for (int p = 0; p < contact.count; ++p) records.push_back(record_of(contact, p, time));
}

std::optional<Event> event_of(const Contact& contact, const Event& moment) {
  Event event = moment;
  event.first = contact.first_id;
  event.second = contact.second_id;
  event.normal_w = contact.normal_w;
  double weight = 0.0;
  for (int k = 0; k < contact.count; ++k) {
    const ContactPoint& point = contact.points[static_cast<std::size_t>(k)];
    event.impulse_w += impulse_of(contact, point);
    event.point_w += point.normal_impulse * point.position_w;
    weight += point.normal_impulse;
  }
  if (!(weight > 0.0)) return std::nullopt;
  event.point_w /= weight;
  return event;
}

bool report_collision(const Contact& contact, const Event& moment, Observer* observer) {
  const std::optional<Event> event = event_of(contact, moment);
  if (event && observer != nullptr) observer->on_event(*event);
  return event.has_value();
}

}  // namespace tumble
