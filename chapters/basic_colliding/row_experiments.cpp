/// \file
/// \brief Experiments on boxes in a row: one contact after the other, or all at once (thesis 2.5.2, 3.3).
#include "tumble/contact/collision_law.hpp"
#include "tumble/contact/impacts.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

// Cubes of 1 m and 1 kg side by side along x, each touching the next.
std::vector<MovingBody> row_of_cubes(int count, bool wall_first) {
  World world;
  for (int i = 0; i < count; ++i) {
    const bool wall = wall_first && i == 0;
    const BodyProperties cube =
        wall ? fixed_box_properties(Vec3::Ones()) : box_properties(Vec3::Ones(), 1.0);
    world.add(cube, make_state(cube, Vec3(i, 0.0, 0.0)));
  }
  std::vector<MovingBody> row;
  load_moving_bodies(world, row);
  return row;
}

// Contact i lies between cube i and the next one.
Vec3 contact_point(int contact) { return {contact + 0.5, 0.0, 0.0}; }

double separation_speed(const std::vector<MovingBody>& row, int contact) {
  const auto i = static_cast<std::size_t>(contact);
  return relative_velocity(row[i], row[i + 1], contact_point(contact)).x();
}

// What touches: one point between each two neighbours, without friction.
std::vector<Contact> contacts_of(const std::vector<MovingBody>& row, double restitution) {
  std::vector<Contact> contacts(row.size() - 1);
  for (int i = 0; i + 1 < static_cast<int>(row.size()); ++i) {
    Contact& contact = contacts[static_cast<std::size_t>(i)];
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
  ImpactOptions options;
  options.order = order;
  if (ImpactSolver().resolve(contacts, row, options).status != ImpactStatus::done)
    throw std::runtime_error("the row still collides");
}

// --- a stack that lands --------------------------------------------------------------------

// Speed that is left of a falling stack, over its speed at first. Right would be 0.
double left_over(const std::vector<MovingBody>& stack) {
  double most = 0.0;
  for (const MovingBody& cube : stack) most = std::max(most, cube.velocity_w.norm());
  return most;
}

// One pass: each contact once, from the carrier outwards, without rebound.
void collide_in_turn(std::vector<MovingBody>& stack) {
  for (int i = 0; i + 1 < static_cast<int>(stack.size()); ++i) {
    const auto k = static_cast<std::size_t>(i);
    collide_at_point(stack[k], stack[k + 1], contact_point(i), Vec3::UnitX(), 0.0, 0.0);
  }
}

struct Convergence {
  int passes = 0;                                               // until the accuracy is reached
  double contraction = 0.0;                                     // what the last pass left
  double after_ten = std::numeric_limits<double>::quiet_NaN();  // share left after ten passes
};

// A stack of n cubes moves at 1 m/s towards what carries it (to the left: a row is a stack without
// weight). Contacts are resolved from the carrier outwards, without rebound, again and again.
Convergence converge(int cubes, double accuracy) {
  constexpr int cap = 1000000;
  std::vector<MovingBody> stack = row_of_cubes(cubes + 1, true);
  for (int i = 1; i <= cubes; ++i) stack[static_cast<std::size_t>(i)].velocity_w = -Vec3::UnitX();
  Convergence result;
  double last = 1.0;
  while (last > accuracy) {
    if (result.passes == cap) throw std::runtime_error("not at rest after a million passes");
    collide_in_turn(stack);
    ++result.passes;
    const double left = left_over(stack);
    if (result.passes == 10) result.after_ten = left;
    result.contraction = left / last;
    last = left;
  }
  return result;
}

Result measure_cradle(const Parameters& settings) {
  const int boxes = settings.count("boxes");
  const int moving = settings.count("moving");
  const double restitution = settings.number("restitution");
  if (moving >= boxes) throw std::invalid_argument("moving: give fewer than boxes");

  std::vector<MovingBody> before = row_of_cubes(boxes, false);
  for (int i = 0; i < moving; ++i) before[static_cast<std::size_t>(i)].velocity_w = Vec3::UnitX();
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
     .parameters =
         Parameters{}
             .add_whole("boxes", 5, 2, 12, "how many boxes in the row")
             .add_whole("moving", 1, 1, 11, "how many of them move at first")
             .add_number("restitution", 1.0, 0.0, 1.0, "-", "rebound speed over impact speed"),
     .quick = {"boxes=3"},
     .experiment = measure_cradle}};

Result measure_stack_convergence(const Parameters& settings) {
  const int most = settings.count("most");
  const double accuracy = settings.number("accuracy");
  constexpr double accepted = 1e-12;

  Table table{"",
              {{"boxes", "-", "in the stack"},
               {"passes", "-", "counted"},
               {"predicted", "-", "ln(accuracy) / ln(cos²(π/2n))"},
               {"error", "-", "of the share that the last pass left against cos²(π/2n)"},
               {"accepted", "-", "error accepted"}}};
  Result result;
  for (int n = 2; n <= most; ++n) {
    const Convergence found = converge(n, accuracy);
    const double cosine = elementary::cos(std::numbers::pi / (2.0 * n));
    const double rate = cosine * cosine;
    table.add(n, found.passes, elementary::log(accuracy) / elementary::log(rate),
              std::abs(found.contraction - rate), accepted);
    if (n == 5) result.add("left after ten passes, 5 boxes", "-", found.after_ten);
  }
  result.tables = {table};
  return result;
}

const Registered stack_convergence_figure{
    {.name = "stack_convergence",
     .parameters = Parameters{}
                       .add_whole("most", 20, 2, 40, "boxes in the highest stack")
                       .add_number("accuracy", 1e-6, 1e-12, 0.1, "-",
                                   "error to reach, over the error at first"),
     .quick = {"most=6"},
     .experiment = measure_stack_convergence}};

}  // namespace
}  // namespace tumble::chapters
