/// \file
/// \brief Sleeping: timers, groups, and what wakes them.
#include "tumble/contact/sleeping.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

void list_pairs(std::span<const Contact> contacts, std::vector<IndexPair>& pairs) {
  pairs.clear();
  for (const Contact& contact : contacts) pairs.push_back({contact.first, contact.second});
}

}  // namespace

SleepingRule::SleepingRule(const SleepingOptions& options) : options_(options) {
  require::not_negative(options.speed, "speed");
  require::not_negative(options.speed_weightless, "speed_weightless");
  require::not_negative(options.time, "time");
}

int SleepingRule::wake_disturbed(World& world) {
  const std::span<const BodyId> ids = world.ids();
  role_.resize(ids.size());
  group_.resize(ids.size());
  disturbed_.clear();
  woken_.assign(ids.size(), 0);

  // Both lists ascend by id. What is only in the old one has been removed, what is only in the
  // new one has been added.
  auto old = seen_.begin();
  for (std::size_t b = 0; b < ids.size(); ++b) {
    for (; old != seen_.end() && old->id < ids[b]; ++old) disturb(*old);
    const bool known = old != seen_.end() && old->id == ids[b];
    compare(world, static_cast<int>(b), known ? &*old : nullptr);
    if (known) ++old;
  }
  for (; old != seen_.end(); ++old) disturb(*old);

  return wake_groups(world, world.gravity_w != gravity_w_);
}

// What a body is now, and whether that disturbs a group, given how it was.
void SleepingRule::compare(const World& world, int body, const Seen* before) {
  const BodyState& state = world.states()[idx(body)];
  const bool asleep = world.sleep_states()[idx(body)].asleep;
  const bool was_asleep = before != nullptr && before->asleep;
  const bool still = before != nullptr && before->position_w == state.position_w &&
                     before->orientation_wb.coeffs() == state.orientation_wb.coeffs();
  const bool moves = !state.linear_momentum_w.isZero(0.0) || !state.angular_momentum_w.isZero(0.0);
  // An unknown sleeper is a group of its own.
  group_[idx(body)] = was_asleep ? before->group : world.ids()[idx(body)];
  role_[idx(body)] = Role::asleep;
  // First what nearly all bodies of a world at rest do; a body that has slept can move.
  if (was_asleep && asleep && still && !moves) return;
  if (!world.bodies()[idx(body)].movable()) {
    role_[idx(body)] = still ? Role::fixed : Role::changed;
    if (before != nullptr && !still) disturb(*before);
    return;
  }
  if (!asleep) role_[idx(body)] = Role::awake;
  if (was_asleep && !asleep) ++woke_;  // World::push() and the like
  if (was_asleep || asleep) disturbed_.push_back(group_[idx(body)]);
}

// A body has gone or changed: its own group is disturbed, and all groups that touch it if it is
// immovable.
void SleepingRule::disturb(const Seen& before) {
  if (before.asleep) disturbed_.push_back(before.group);
  auto support = std::lower_bound(supports_.begin(), supports_.end(),
                                  std::pair<BodyId, BodyId>{before.id, BodyId{}});
  for (; support != supports_.end() && support->first == before.id; ++support)
    disturbed_.push_back(support->second);
}

bool SleepingRule::needs_test(int first, int second) const {
  if (std::max(idx(first), idx(second)) >= role_.size()) return true;
  const Role a = role_[idx(first)];
  const Role b = role_[idx(second)];
  if (a == Role::awake || b == Role::awake) return true;
  return (a == Role::asleep && b == Role::changed) || (a == Role::changed && b == Role::asleep);
}

bool SleepingRule::nobody_awake() const {
  return std::none_of(role_.begin(), role_.end(), [](Role role) {
    return role == Role::awake || role == Role::changed;  // which may touch a sleeper
  });
}

int SleepingRule::wake_touched(World& world, std::span<const Contact> contacts) {
  list_pairs(contacts, pairs_);
  return wake_touched_pairs(world, pairs_);
}

int SleepingRule::wake_touched_pairs(World& world, std::span<const IndexPair> contacts) {
  require::that(role_.size() == world.states().size(),
                "sleeping: bodies were added or removed: call wake_disturbed() first");
  disturbed_.clear();
  for (const IndexPair& contact : contacts) {
    if (!needs_test(contact.first, contact.second)) continue;  // an old contact of a sleeper
    for (const int body : {contact.first, contact.second})
      if (role_[idx(body)] == Role::asleep) disturbed_.push_back(group_[idx(body)]);
  }
  return wake_groups(world, false);
}

// Wakes the disturbed groups, or all of them. Their bodies have to prove again that they rest.
int SleepingRule::wake_groups(World& world, bool all) {
  if (!all && disturbed_.empty()) return 0;
  std::sort(disturbed_.begin(), disturbed_.end());
  const auto is_disturbed = [&](BodyId group) {
    return all || std::binary_search(disturbed_.begin(), disturbed_.end(), group);
  };
  int woken = 0;
  for (std::size_t b = 0; b < role_.size(); ++b) {
    if (role_[b] != Role::asleep || !is_disturbed(group_[b])) continue;
    role_[b] = Role::awake;
    world.sleep_states()[b] = SleepState{};
    woken_[b] = 1;
    ++woken;
  }
  std::erase_if(supports_, [&](const auto& support) { return is_disturbed(support.second); });
  woke_ += woken;
  return woken;
}

SleepReport SleepingRule::update(World& world, std::span<const Contact> contacts,
                                 const Islands& islands, double dt, std::span<const char> slow) {
  list_pairs(contacts, pairs_);
  return update_with_pairs(world, pairs_, islands, dt, slow);
}

SleepReport SleepingRule::update_with_pairs(World& world, std::span<const IndexPair> contacts,
                                            const Islands& islands, double dt,
                                            std::span<const char> slow) {
  require::positive(dt, "dt");
  require::that(slow.empty() || slow.size() == world.states().size(),
                "sleeping: slow: one entry for each body, or none");
  wake_touched_pairs(world, contacts);  // in case that the technique has not: then one step late

  for (std::size_t b = 0; b < role_.size(); ++b) {
    if (role_[b] != Role::awake) continue;
    double& quiet_time = world.sleep_states()[b].quiet_time;
    const bool counts = !slow.empty() && slow[b] != 0 && woken_[b] == 0;
    quiet_time = is_slow(world, static_cast<int>(b), dt, counts) ? quiet_time + dt : 0.0;
  }
  SleepReport report;
  for (int island = 0; island < islands.count(); ++island)
    if (can_sleep(world, contacts, islands, island))
      put_to_sleep(world, contacts, islands, island, report);
  remember(world);
  report.woke = woke_;
  woke_ = 0;
  return report;
}

// No point of a body is faster than |v| + |ω| r, r half its diagonal; a body with a momentum that
// is not finite is not slow, whatever it counts as.
bool SleepingRule::is_slow(const World& world, int body, double dt, bool counts) const {
  const BodyProperties& constant = world.bodies()[idx(body)];
  const BodyState& state = world.states()[idx(body)];
  const double length = constant.size.minCoeff();
  const double g = world.gravity_w.norm();
  const double limit =
      g > 0.0 ? options_.speed * std::sqrt(g * length) : options_.speed_weightless * length / dt;
  const double fastest = velocity(constant, state).norm() +
                         angular_velocity(constant, state).norm() * 0.5 * constant.size.norm();
  return fastest <= limit || (counts && std::isfinite(fastest));
}

// Whether all bodies of an island have been slow for long enough. Under gravity nothing rests
// unless something immovable holds it: without this a heap thrown upwards could stop at the top.
bool SleepingRule::can_sleep(const World& world, std::span<const IndexPair> contacts,
                             const Islands& islands, int island) const {
  for (const int body : islands.bodies(island))
    if (role_[idx(body)] != Role::awake ||
        world.sleep_states()[idx(body)].quiet_time < options_.time)
      return false;
  if (world.gravity_w.isZero(0.0)) return true;
  const std::span<const BodyProperties> bodies = world.bodies();
  for (const int c : islands.contacts(island))
    if (!bodies[idx(contacts[idx(c)].first)].movable() ||
        !bodies[idx(contacts[idx(c)].second)].movable())
      return true;
  return false;
}

void SleepingRule::put_to_sleep(World& world, std::span<const IndexPair> contacts,
                                const Islands& islands, int island, SleepReport& report) {
  const BodyId group = world.ids()[idx(islands.bodies(island).front())];
  for (const int body : islands.bodies(island)) {
    BodyState& state = world.states()[idx(body)];
    report.energy -= kinetic_energy(world.bodies()[idx(body)], state);
    state.linear_momentum_w.setZero();
    state.angular_momentum_w.setZero();
    world.sleep_states()[idx(body)].asleep = true;
    role_[idx(body)] = Role::asleep;
    group_[idx(body)] = group;
    ++report.fell_asleep;
  }
  for (const int c : islands.contacts(island))
    for (const int body : {contacts[idx(c)].first, contacts[idx(c)].second})
      if (!world.bodies()[idx(body)].movable())
        supports_.emplace_back(world.ids()[idx(body)], group);
}

void SleepingRule::remember(const World& world) {
  std::sort(supports_.begin(), supports_.end());
  supports_.erase(std::unique(supports_.begin(), supports_.end()), supports_.end());
  gravity_w_ = world.gravity_w;
  seen_.resize(role_.size());
  for (std::size_t b = 0; b < role_.size(); ++b) {
    const BodyState& state = world.states()[b];
    seen_[b] = Seen{world.ids()[b], role_[b] == Role::asleep, group_[b], state.position_w,
                    state.orientation_wb};
  }
}

}  // namespace tumble
