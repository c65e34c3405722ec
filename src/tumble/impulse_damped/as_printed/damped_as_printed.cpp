/// \file
/// \brief Damped integration as its listings are printed (thesis A.2).
#include "tumble/impulse_damped/as_printed/damped_as_printed.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/impulse_damped/as_printed/dampen_objects_as_printed.hpp"
#include "tumble/impulse_damped/as_printed/fix_contact_constraints_as_printed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace tumble {
namespace {

void require_count(std::int64_t value, std::int64_t least, const char* name) {
  require::that(value >= least, std::string(name) + " = " + std::to_string(value) +
                                    ": give at least " + std::to_string(least));
}

void require_base(int value, const char* name) {
  require::that(value == 0 || value == 1,
                std::string(name) + " = " + std::to_string(value) + ": expected 0 or 1");
}

}  // namespace

DampedAsPrinted::DampedAsPrinted(const DampedAsPrintedOptions& options)
    : options_(options), gatherer_(options.normals, PointRule::area) {
  check(options.numbers);
  require_count(options.collision_passes, 0, "collision_passes");
  require_count(options.contact_passes, 0, "contact_passes");
  require_count(options.push_cap, 1, "push_cap");
  require_base(options.index_base, "index_base");
  require_base(options.loop_base, "loop_base");
}

std::vector<std::string> DampedAsPrinted::ignores(const World& world) const {
  const bool rough = std::any_of(world.bodies().begin(), world.bodies().end(),
                                 [](const BodyProperties& body) { return body.friction > 0.0; });
  if (!rough) return {};
  return {"friction"};
}

bool DampedAsPrinted::geometrically_stable(BodyId id) const {
  const auto found = std::find_if(memory_.begin(), memory_.end(),
                                  [&](const Memory& memory) { return memory.id == id; });
  return found != memory_.end() && found->stability.stable;
}

StepReport DampedAsPrinted::step(World& world, double dt) {
  require::positive(dt, "dt");
  StepReport report;
  remember(world);
  records_.clear();
  start_.assign(world.states().begin(), world.states().end());
  ahead_w_ = dt * world.gravity_w;
  // Erratum D1 mended: the order of 5.2, gravity before contacts.
  const bool as_in_5_2 = options_.repaired.has("D1");

  // [DAMPEDINTEGRATION:1]
  // Let collide what would overlap at the end of the step.
  resolve(world, dt, false, report);
  // [DAMPEDINTEGRATION:1]
  if (as_in_5_2) integrate_object_velocities(world, dt);
  // [DAMPEDINTEGRATION:2]
  // Let contacts hold what gravity would make overlap.
  resolve(world, dt, true, report);
  // [DAMPEDINTEGRATION:2]
  if (!as_in_5_2) {
    // [DAMPEDINTEGRATION:3]
    // Add gravity to the velocities.
    integrate_object_velocities(world, dt);
    // [DAMPEDINTEGRATION:3]
  }
  if (all_finite(world)) {
    // [DAMPEDINTEGRATION:4]
    // Damp, and move all bodies.
    dampen_objects(world, dt, report);
    // [DAMPEDINTEGRATION:4]
    // [DAMPEDINTEGRATION:5-6]
    // Push apart what still overlaps; find out which bodies stand firm.
    fix_contact_constraints(world, report);
    set_geometrically_stable(world, report);
    // [DAMPEDINTEGRATION:5-6]
  }
  if (!all_finite(world)) {
    std::copy(start_.begin(), start_.end(), world.states().begin());
    report.status = StepStatus::not_finite;
  }
  world.finish_step(dt);
  report.contacts = static_cast<std::int64_t>(records_.size());
  // [DAMPEDINTEGRATION:7]
  // The step is done.
  return report;
  // [DAMPEDINTEGRATION:7]
}

// What is known of the bodies that were there in the last step; nothing of new ones.
void DampedAsPrinted::remember(const World& world) {
  std::vector<Memory> now(world.ids().size());
  auto then = memory_.begin();
  for (std::size_t k = 0; k < now.size(); ++k) {
    now[k].id = world.ids()[k];
    while (then != memory_.end() && then->id < now[k].id) ++then;
    if (then != memory_.end() && then->id == now[k].id) now[k] = *then;
    // Erratum DM5 mended: a contact interaction is one of this step.
    if (options_.repaired.has("DM5")) now[k].touched = 0;
  }
  memory_ = std::move(now);
}

// Lines 1 and 2.
void DampedAsPrinted::resolve(World& world, double dt, bool contacts, StepReport& report) {
  std::vector<std::uint8_t> stable(memory_.size());
  std::vector<Vec3> fixed_w(memory_.size());
  for (std::size_t k = 0; k < memory_.size(); ++k) {
    stable[k] = memory_[k].stability.stable ? 1 : 0;
    fixed_w[k] = memory_[k].fixed_velocity_w;
  }
  objects_.begin(world, stable, fixed_w, options_.repaired);
  // No gravity is left to be added if line 3 came first.
  const bool added = !(ahead_w_.squaredNorm() > 0.0);
  const PrintedCollide collide{options_.repaired, added ? Vec3::Zero() : world.gravity_w, dt,
                               options_.index_base};
  PrintedStage stage{.world = world,
                     .objects = objects_,
                     .gatherer = gatherer_,
                     .last = start_,
                     .collide = collide,
                     .ahead_w = ahead_w_,
                     .dt = dt,
                     .rotation = options_.rotation,
                     .passes = contacts ? options_.contact_passes : options_.collision_passes,
                     .loop_base = options_.loop_base,
                     .elastic = options_.elastic_contacts,
                     .collisions = collisions_,
                     .report = report,
                     .told = [&](const Contact& contact, const PrintedCollision& done) {
                       if (done.impulse > 0.0 && !contacts) ++report.events;
                       record(world, dt, contact, done, contacts);
                     }};
  contacts ? resolve_contacts_as_printed(stage) : resolve_collisions_as_printed(stage);
  objects_.end(world);
  for (std::size_t k = 0; k < memory_.size(); ++k)
    memory_[k].stability.stable = objects_.all()[k].geometrically_stable;
}

// Line 3. Erratum D6: of all objects, those that cannot move as well: what stands on them then
// stands on something that falls.
void DampedAsPrinted::integrate_object_velocities(World& world, double dt) {
  for (std::size_t k = 0; k < memory_.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (body.movable()) {
      world.states()[k].linear_momentum_w += dt * (body.mass * world.gravity_w);
    } else if (!options_.repaired.has("D6")) {
      memory_[k].fixed_velocity_w += dt * world.gravity_w;
    }
  }
  ahead_w_.setZero();
}

// The constants: as printed the same for all bodies and steps.
DampedThresholds DampedAsPrinted::thresholds(const World& world, double dt) const {
  const auto first = std::find_if(world.bodies().begin(), world.bodies().end(),
                                  [](const BodyProperties& body) { return body.movable(); });
  if (first == world.bodies().end()) return {};
  return thresholds_of(options_.numbers, *first, world.gravity_w.norm(), dt);
}

// Line 4. Erratum D2: the step is not handed on, so it is the one for which the constants are.
void DampedAsPrinted::dampen_objects(World& world, double dt, StepReport& report) {
  constexpr double usual = 1.0 / kDampedStepsPerSecond;
  const double known_dt = options_.repaired.has("D2") ? dt : usual;
  const double numbers_dt = options_.repaired.has("DM8") ? dt : usual;
  const PrintedNumbers numbers{thresholds(world, numbers_dt),
                               factors_of(options_.numbers, numbers_dt)};
  std::vector<std::uint8_t> touched(memory_.size());
  for (std::size_t k = 0; k < memory_.size(); ++k) touched[k] = memory_[k].touched;
  const DampenReport done = dampen_objects_as_printed(world, touched, numbers, known_dt,
                                                      options_.rotation, options_.repaired);
  report.energy.damping += done.damping;
  report.energy.repair += done.repair;
  report.integrations += done.moved;
}

// Line 5. Erratum D4: with what was gathered in the last pass of line 2, where bodies would have
// been; mended, with what overlaps now.
void DampedAsPrinted::fix_contact_constraints(World& world, StepReport& report) {
  ContactList fresh;  // without D4 for the report only
  gather_again(world, 0.0, fresh, report);
  if (options_.repaired.has("D4")) collisions_ = fresh;
  const double push = thresholds(world, 1.0 / kDampedStepsPerSecond).push;
  if (!(push > 0.0)) return;  // neither can be moved
  const PrintedFixReport done = fix_contact_constraints_as_printed(
      world, collisions_, push, options_.push_cap, options_.repaired);
  if (!done.ended) report.status = StepStatus::event_cap;
  report.pair_tests += done.pair_tests;
  report.energy.repair += done.energy;
}

// Line 6. Erratum D4: ditto; mended, with what touches now, though it may have been pushed a little
// apart.
void DampedAsPrinted::set_geometrically_stable(World& world, StepReport& report) {
  if (!options_.stable_boxes) return;
  double shortest = std::numeric_limits<double>::infinity();
  for (const BodyProperties& body : world.bodies())
    if (body.shape == Shape::box) shortest = std::min(shortest, body.size.minCoeff());
  if (options_.repaired.has("D4") && std::isfinite(shortest))
    gather_again(world, tolerance::stability_margin * shortest, collisions_, report);

  const DampedErrata& mended = options_.repaired;
  const PrintedStabilityRepairs repairs{
      .both_bodies = mended.has("G2"),
      .vetoes_last = mended.has("G3"),
      .immovable = mended.has("G4"),
      .fresh_corners = mended.has("G5"),
      .rising = mended.has("G7"),
      .tolerances = mended.has("G8"),
      .upward_momentum = thresholds(world, 1.0 / kDampedStepsPerSecond).rising};
  std::vector<PrintedStability> bodies(memory_.size());
  for (std::size_t k = 0; k < bodies.size(); ++k) bodies[k] = memory_[k].stability;
  set_geometrically_stable_as_printed(world, collisions_, repairs, bodies);
  for (std::size_t k = 0; k < bodies.size(); ++k) memory_[k].stability = bodies[k];
}

void DampedAsPrinted::gather_again(const World& world, double margin, ContactList& out,
                                   StepReport& report) {
  const PairReport found = gatherer_.gather(world, start_, world.states(), nullptr, margin, out);
  report.pair_tests += found.pair_tests;
  report.deepest_overlap = std::max(report.deepest_overlap, found.deepest_overlap);
}

// Reports an impulse: a collision at once, contacts summed up over the passes.
void DampedAsPrinted::record(const World& world, double dt, const Contact& contact,
                             const PrintedCollision& done, bool contacts) {
  const Vec3 impulse_w = done.impulse * contact.normal_w;
  if (!contacts) {
    const Event event{world.time(), contact.first_id, contact.second_id,
                      done.point_w, contact.normal_w, impulse_w};
    if (done.impulse != 0.0 && observer() != nullptr) observer()->on_event(event);
    return;
  }
  // "Has had a contact interaction." DM5 mended: the bodies pressed against each other.
  if (done.approached || !options_.repaired.has("DM5"))
    for (const int body : {contact.first, contact.second}) memory_[idx(body)].touched = 1;

  auto told = std::find_if(records_.begin(), records_.end(), [&](const ContactRecord& r) {
    return r.first == contact.first_id && r.second == contact.second_id;
  });
  if (told == records_.end())
    told = records_.insert(told,
                           ContactRecord{.first = contact.first_id, .second = contact.second_id});
  told->time = world.time() + dt;
  told->point_w = done.point_w;
  told->normal_w = contact.normal_w;
  told->push_w += impulse_w;
  const bool pushed = told->push_w.dot(contact.normal_w) > 0.0;
  told->state = pushed ? ContactState::slip : ContactState::open;
}

}  // namespace tumble
