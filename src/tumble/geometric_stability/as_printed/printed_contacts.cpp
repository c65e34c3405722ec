/// \file
/// \brief Contact points in the terms of the appendix's listings (thesis 4.4, 5.4, A.2).
#include "tumble/geometric_stability/as_printed/printed_contacts.hpp"

#include "tumble/base/error.hpp"

#include <algorithm>
#include <string>

namespace tumble {

std::vector<PrintedContact> sort_contact_points_ascending(const World& world,
                                                          std::span<const Contact> contacts) {
  const auto height_of = [&](int body) {
    require::that(
        body >= 0 && body < world.count(),
        "contact of body " + std::to_string(body) + ": there are " + std::to_string(world.count()));
    return world.states()[static_cast<std::size_t>(body)].position_w.y();
  };
  std::vector<PrintedContact> sorted;
  for (const Contact& contact : contacts) {
    PrintedContact c{contact.second, contact.first, contact.normal_w, Vec3::Zero()};
    if (height_of(contact.first) > height_of(contact.second))
      c = {contact.first, contact.second, -contact.normal_w, Vec3::Zero()};
    for (int k = 0; k < contact.count; ++k) {
      c.point_w = contact.points[static_cast<std::size_t>(k)].position_w;
      sorted.push_back(c);
    }
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const PrintedContact& a, const PrintedContact& b) {
                     return a.point_w.y() < b.point_w.y();
                   });
  return sorted;
}

}  // namespace tumble
