/// \file
/// \brief Impacts and the end of a frame in the listings of the synchronised timewarp, as printed
///        (thesis A.1).
#include "tumble/contact/effective_mass.hpp"
#include "tumble/timewarp/as_printed/queries_as_printed.hpp"

#include <algorithm>
#include <utility>

namespace tumble {
namespace {

// [-] A margin beyond a gap, so that all corners of a face are reached in spite of rounding.
constexpr double kMore = 1.0 + 1e-9;

}  // namespace

void PrintedQueries::collide_two_objects(CollidedObjects objects, const PrintedMoment& moment) {
  const auto exchange = [&] {
    for (const int body : moment.indices) std::swap(world_->states()[idx(body)], test[idx(body)]);
  };
  if (objects == CollidedObjects::test) exchange();
  collide_valid(moment);
  if (objects == CollidedObjects::test) exchange();
}

void PrintedQueries::collide_valid(const PrintedMoment& moment) {
  for (const int body : moment.indices)
    moving_[idx(body)] = moving_body_of(world_->bodies()[idx(body)], world_->states()[idx(body)]);
  approaching_.clear();
  for (const IndexPair& pair : moment.pairs) {
    const bool bounced = options_.collide_separating && bounce_separating(pair, moment.time);
    if (!bounced) approaching_.push_back(pair);
  }
  missed_.clear();
  collide_approaching(approaching_, 0.0, moment.time);
  // As printed a pair need not be in contact when it is resolved (T1, T3, T4).
  const std::vector<IndexPair> apart = std::exchange(missed_, {});
  for (const IndexPair& pair : apart) {
    const double margin = kMore * std::max(gap_of(world_->states(), pair), 0.0);
    collide_approaching({&pair, 1}, margin, moment.time);
  }
}

// Resolves pairs whose gap is at most the margin [m], or at most as wide as a search may leave it; other
// pairs are added to missed_.
void PrintedQueries::collide_approaching(std::span<const IndexPair> pairs, double margin,
                                         double time) {
  if (pairs.empty()) return;
  const InstantReport impact = impacts_.resolve(
      *world_, pairs, {.resolution = options_.resolution, .dt = dt_, .margin = margin}, report);
  if (impact.status != ImpactStatus::done)
    report.status = std::max(report.status, StepStatus::event_cap);

  Event moment{.time = world_->time() + time, .rewinds = keep_pushed(pairs)};
  report.rewinds += margin == 0.0 ? moment.rewinds : 0;  // otherwise already counted
  std::vector<Event> events;
  record_impact(*world_, impact.contacts, moment, dt_, records_, events);
  report.events += static_cast<std::int64_t>(events.size());
  for (const Event& event : events)
    if (observer_ != nullptr) observer_->on_event(event);

  const auto touched = [&](const IndexPair& pair) {
    return std::any_of(impact.contacts.begin(), impact.contacts.end(), [&](const Contact& c) {
      return c.first == pair.first && c.second == pair.second;
    });
  };
  stage_.release_pushed(*world_, pushed_, moving_, dt_);
  for (const IndexPair& pair : pairs) {
    if (!touched(pair) && margin == 0.0)
      missed_.push_back(pair);
    else if (mended_.contact_stage)
      stage_.count(pair, impacts_.separation_speed(*world_, pair, dt_), world_->gravity_w.norm());
  }
}

// Applies the impulse of a collision to two separating bodies, at the centre of their contact, so that
// they approach afterwards. False if they approach, or have no contact.
bool PrintedQueries::bounce_separating(const IndexPair& pair, double time) {
  ContactList contacts;
  double margin = search_margin(*world_, moving_, {&pair, 1}, options_.resolution);
  margin = std::max(margin, kMore * gap_of(world_->states(), pair));
  report.pair_tests +=
      gather_contacts(*world_, moving_, {&pair, 1}, margin, {}, contacts).pair_tests;
  if (contacts.empty()) return false;
  const Contact& contact = contacts.front();
  Event event{.time = world_->time() + time,
              .first = contact.first_id,
              .second = contact.second_id,
              .normal_w = contact.normal_w,
              .rewinds = keep_pushed({&pair, 1})};
  for (int p = 0; p < contact.count; ++p)
    event.point_w += contact.points[idx(p)].position_w / contact.count;

  MovingBody first =
      moving_body_of(world_->bodies()[idx(pair.first)], world_->states()[idx(pair.first)]);
  MovingBody second =
      moving_body_of(world_->bodies()[idx(pair.second)], world_->states()[idx(pair.second)]);
  const double speed = contact.normal_w.dot(relative_velocity(first, second, event.point_w));
  if (!(speed > 0.0)) return false;
  const double impulse = -(1.0 + contact.restitution) * speed *
                         effective_mass(first, second, event.point_w, contact.normal_w);
  event.impulse_w = impulse * contact.normal_w;
  apply_impulse(first, second, event.point_w, event.impulse_w);
  store_moving_body(first, world_->bodies()[idx(pair.first)], world_->states()[idx(pair.first)]);
  store_moving_body(second, world_->bodies()[idx(pair.second)], world_->states()[idx(pair.second)]);
  report.energy.restitution += 0.5 * impulse * speed * (1.0 - contact.restitution);
  report.rewinds += event.rewinds;
  ++report.events;
  ++report.impulses;
  if (observer_ != nullptr) observer_->on_event(event);
  if (mended_.contact_stage)
    stage_.count(pair, contact.restitution * speed, world_->gravity_w.norm());
  return true;
}

// Stores the movable bodies of some pairs; returns their number.
int PrintedQueries::keep_pushed(std::span<const IndexPair> pairs) {
  list_movable(*world_, pairs, pushed_);
  return static_cast<int>(pushed_.size());
}

void PrintedQueries::fix_interpenetration() {
  if (!all_finite(*world_)) {
    std::copy(start_.begin(), start_.end(), world_->states().begin());
    report.status = StepStatus::not_finite;
  }
  end_.settle(*world_, dt_, options_.resolution, stage_.pairs(), report, records_);
  report.contacts = static_cast<std::int64_t>(records_.size());
  report.fallbacks += stage_.entered();
  world_->finish_step(dt_);
}

}  // namespace tumble
