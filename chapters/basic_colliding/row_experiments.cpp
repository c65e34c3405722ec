/// \file
/// \brief Experiments on boxes in a row: one contact after the other, or all at once (thesis 2.5.2, 3.3).
#include "tumble/contact/impacts.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

// Cubes of 1 m and 1 kg side by side along x, each touching the next.
std::vector<MovingBody> row_of_cubes(int count) {
  World world;
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  for (int i = 0; i < count; ++i) world.add(cube, Vec3(i, 0.0, 0.0));
  std::vector<MovingBody> row;
  load_moving_bodies(world, row);
  return row;
}

// Contact i lies between cube i and the next one.
Vec3 contact_point(int contact) { return {contact + 0.5, 0.0, 0.0}; }

double separation_speed(const std::vector<MovingBody>& row, int contact) {
  const auto i = idx(contact);
  return relative_velocity(row[i], row[i + 1], contact_point(contact)).x();
}

// What touches: one point between each two neighbours, without friction.
std::vector<Contact> contacts_of(const std::vector<MovingBody>& row, double restitution) {
  std::vector<Contact> contacts(row.size() - 1);
  for (int i = 0; i + 1 < static_cast<int>(row.size()); ++i) {
    Contact& contact = contacts[idx(i)];
    contact.first = i;
    contact.second = i + 1;
    contact.normal_w = Vec3::UnitX();
    contact.restitution = restitution;
    contact.count = 1;
    contact.points[0].position_w = contact_point(i);
    contact.points[0].approach_speed = separation_speed(row, i);
  }
  return contacts;
}

void collide(std::vector<MovingBody>& row, double restitution, ImpactOrder order) {
  std::vector<Contact> contacts = contacts_of(row, restitution);
  if (ImpactSolver().resolve(contacts, row, {.order = order}).status != ImpactStatus::done)
    throw std::runtime_error("the row still collides");
}

Result measure_cradle(const Parameters& settings) {
  const int boxes = settings.count("boxes");
  const int moving = settings.count("moving");
  const double restitution = settings.number("restitution");
  if (moving >= boxes) throw std::invalid_argument("moving: give fewer than boxes");

  std::vector<MovingBody> before = row_of_cubes(boxes);
  for (int i = 0; i < moving; ++i) before[idx(i)].velocity_w = Vec3::UnitX();
  std::vector<MovingBody> at_once = before;
  collide(at_once, restitution, ImpactOrder::simultaneous);
  std::vector<MovingBody> in_turn = before;
  collide(in_turn, restitution, ImpactOrder::sequential);

  Table table{"",
              {{"box", "-", "from left to right"},
               {"before_m_s", "m/s", "velocity before"},
               {"simultaneous_m_s", "m/s", "velocity after, all impulses at once"},
               {"sequential_m_s", "m/s", "velocity after, one impulse after the other"}}};
  for (std::size_t i = 0; i < before.size(); ++i)
    table.add(i + 1, before[i].velocity_w.x(), at_once[i].velocity_w.x(),
              in_turn[i].velocity_w.x());
  return {{table}, {{"last box, simultaneous", "m/s", at_once.back().velocity_w.x()}}};
}

const Registered cradle_figure{
    {.name = "cradle",
     .parameters = {whole("boxes", 5, 2, 12, "how many boxes in the row"),
                    whole("moving", 1, 1, 11, "how many of them move at first"),
                    number("restitution", 1.0, 0.0, 1.0, "-", "rebound speed over impact speed")},
     .quick = {"boxes=3"},
     .experiment = measure_cradle}};

}  // namespace
}  // namespace tumble::chapters
