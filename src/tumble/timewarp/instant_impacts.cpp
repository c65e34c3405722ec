/// \file
/// \brief Impacts of some pairs at one instant, independent of all other bodies (thesis A.1:
///        collideTwoObjects).
#include "tumble/timewarp/instant_impacts.hpp"

#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/contact/contact_records.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/contact/movable_edge.hpp"
#include "tumble/contact/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

// Whether the remaining approach is what gravity adds in a frame, or closes less than repair permits.
bool hardly_approach(const World& world, std::span<const IndexPair> pairs,
                     const InstantReport& left, double dt) {
  double size = std::numeric_limits<double>::infinity();
  for (const IndexPair& pair : pairs)
    size = std::min(
        size, movable_edge(world.bodies()[idx(pair.first)], world.bodies()[idx(pair.second)]));
  return left.approach_left <= world.gravity_w.norm() * dt ||
         left.approach_left * dt <= tolerance::repair_slop * size;
}

}  // namespace

bool only_rounding(const World& world, const Event& event, double time) {
  for (const BodyId id : {event.first, event.second}) {
    const BodyProperties& body = world.bodies()[idx(world.index_of(id))];
    const double way = time * body.inverse_mass * event.impulse_w.norm();
    if (way > tolerance::rounding_overlap * body.size.maxCoeff()) return false;
  }
  return true;
}

void record_impact(const World& world, std::span<const Contact> contacts, const Event& moment,
                   double dt, std::vector<ContactRecord>& records, std::vector<Event>& events) {
  add_records(contacts, moment.time, records);
  for (const Contact& contact : contacts) {
    const std::optional<Event> event = event_of(contact, moment);
    if (event && !only_rounding(world, *event, dt)) events.push_back(*event);
  }
}

void list_movable(const World& world, std::span<const IndexPair> pairs, std::vector<int>& out) {
  out.clear();
  for (const IndexPair& pair : pairs)
    for (const int body : {pair.first, pair.second})
      if (world.bodies()[idx(body)].movable()) out.push_back(body);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
}

InstantReport InstantImpacts::resolve(World& world, std::span<const IndexPair> pairs,
                                      const InstantOptions& options, StepReport& report) {
  moving_.resize(idx(world.count()));
  for (const IndexPair& pair : pairs)
    for (const int body : {pair.first, pair.second})
      moving_[idx(body)] = moving_body_of(world.bodies()[idx(body)], world.states()[idx(body)]);

  const double margin =
      std::max(options.margin, search_margin(world, moving_, pairs, options.resolution));
  const GatherReport gathered = gather_contacts(world, moving_, pairs, margin, {}, contacts_);
  report.pair_tests += gathered.pair_tests;
  if (!options.bounce)
    for (Contact& contact : contacts_) contact.restitution = 0.0;

  InstantReport out;
  if (pairs.size() == 1) {
    resolve_together(contacts_, out, report);
  } else {
    islands_.build(world.bodies(), contacts_);
    for (int k = 0; k < islands_.count(); ++k) resolve_island(islands_.contacts(k), out, report);
  }

  for (const Contact& contact : contacts_)
    for (const int body : {contact.first, contact.second})
      store_moving_body(moving_[idx(body)], world.bodies()[idx(body)], world.states()[idx(body)]);
  out.contacts = contacts_;
  if (out.status == ImpactStatus::cap_reached && hardly_approach(world, pairs, out, options.dt))
    out.status = ImpactStatus::done;
  return out;
}

double InstantImpacts::separation_speed(const World& world, const IndexPair& pair,
                                        double time) const {
  double slowest = slowest_separation(pair, true);
  if (std::isinf(slowest)) slowest = slowest_separation(pair, false);
  if (std::isinf(slowest)) return 0.0;
  double size = 0.0;
  for (const int body : {pair.first, pair.second})
    if (world.bodies()[idx(body)].movable())
      size = std::max(size, world.bodies()[idx(body)].size.maxCoeff());
  return slowest * time > tolerance::rounding_overlap * size ? slowest : 0.0;
}

double InstantImpacts::slowest_separation(const IndexPair& pair, bool pushed_only) const {
  double slowest = std::numeric_limits<double>::infinity();
  for (const Contact& contact : contacts_) {
    if (contact.first != pair.first || contact.second != pair.second) continue;
    const MovingBody& first = moving_[idx(contact.first)];
    const MovingBody& second = moving_[idx(contact.second)];
    for (int p = 0; p < contact.count; ++p) {
      const ContactPoint& point = contact.points[idx(p)];
      if (pushed_only && !(point.normal_impulse > 0.0)) continue;
      const Vec3 velocity_w = relative_velocity(first, second, point.position_w);
      slowest = std::min(slowest, contact.normal_w.dot(velocity_w));
    }
  }
  return slowest;
}

void InstantImpacts::resolve_island(std::span<const int> members, InstantReport& out,
                                    StepReport& report) {
  island_contacts_.clear();
  for (const int c : members) island_contacts_.push_back(contacts_[idx(c)]);
  resolve_together(island_contacts_, out, report);
  for (std::size_t k = 0; k < members.size(); ++k) contacts_[idx(members[k])] = island_contacts_[k];
}

void InstantImpacts::resolve_together(std::span<Contact> contacts, InstantReport& out,
                                      StepReport& report) {
  if (contacts.empty()) return;
  int points = 0;
  for (const Contact& contact : contacts) points += contact.count;
  ImpactOptions how{
      .order = points <= kMostPoints ? ImpactOrder::simultaneous : ImpactOrder::sequential,
      .most_passes = kPasses};
  const ImpactResult impact = solver_.resolve(contacts, moving_, how);
  out.status = std::max(out.status, impact.status);
  out.approach_left = std::max(out.approach_left, impact.worst_approach);
  book(impact, report);
}

}  // namespace tumble
