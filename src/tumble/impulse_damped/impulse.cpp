/// \file
/// \brief The technique of Guendelman, Bridson and Fedkiw.
#include "tumble/impulse_damped/impulse.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/contact_records.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/contact/parts_of_turn.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace tumble {
namespace {

void at_least_one(int value, const char* name) {
  require::that(value >= 1,
                std::string(name) + " = " + std::to_string(value) + ": expected 1 or more");
}

}  // namespace

Impulse::Impulse(const ImpulseOptions& options) : options_(options), push_(options.points) {
  at_least_one(options.collision_passes, "collision_passes");
  at_least_one(options.contact_passes, "contact_passes");
  at_least_one(options.level_sweeps, "level_sweeps");
  require::not_negative(options.sticky, "sticky");
}

StepReport Impulse::step(World& world, double dt) {
  return step_in_parts(world, dt, [&](World& w, double part, int) { return step_part(w, part); });
}

StepReport Impulse::step_part(World& world, double dt) {
  StepReport report;
  records_.clear();
  begin(world, dt, report);

  // [S2.5.2:collision]
  // 1. Collisions: pairs that would overlap at the end of the
  // step, and approach with the velocities that bodies have now,
  // before gravity. What rests has none and does not bounce.
  for (int pass = 0; pass < options_.collision_passes; ++pass)
    if (!collide_deepest_first(world, dt, report)) break;
  // [S2.5.2:collision]
  report_collisions(world, report);

  // [S2.5.2:velocity]
  // 2. Velocities: v + h g.
  bodies_.add_gravity(world);
  // [S2.5.2:velocity]

  // [S2.5.2:contact]
  // 3. Contacts: now whatever is held up approaches its support.
  // Passes from the ground up with restitution -1 + i/N slow the
  // approach down more and more; the last one ends it.
  build_graph(world);
  const int count = options_.contact_passes;
  for (int i = 1; i <= count; ++i) {
    const double restitution = -1.0 + static_cast<double>(i) / count;
    if (!hold_by_level(world, 1.0 + restitution, false, dt, report)) break;
  }
  // [S2.5.2:contact]

  // [S2.5.2:shock]
  // 4. Shock propagation: once more without restitution. A level
  // that is done is from then on as heavy as the ground.
  if (options_.shock == ImpulseShock::velocity) {
    hold_by_level(world, 1.0, true, dt, report);
    bodies_.thaw(world);
  }
  // [S2.5.2:shock]

  // [S2.5.2:position]
  // 5. Positions: all bodies go where they were predicted to be.
  bodies_.carry(world);
  const int moved = bodies_.move(world, report.energy.repair);
  report.integrations += bodies_.predictions() + moved;
  // [S2.5.2:position]

  report.energy.restitution += bodies_.moved_against_gravity(world);
  finish(world, dt, report);
  return report;
}

const SleepingRule* Impulse::sleeping() const { return options_.sleeping ? &sleeping_ : nullptr; }

// Velocities and predicted poses; a body that is touched where it sleeps wakes, which has to be known before.
void Impulse::begin(World& world, double dt, StepReport& report) {
  if (!options_.sleeping)
    for (SleepState& rest : world.sleep_states()) rest.asleep = false;
  if (options_.sleeping) sleeping_.wake_disturbed(world);
  list_pushed(world);
  for (bool again = true; again;) {
    bodies_.begin(world, dt, options_.rotation, pushed_);
    // By as much gravity takes a body towards one that it does not take.
    pairs_.begin(dt * dt * world.gravity_w.norm());
    again = false;
    if (!options_.sleeping) break;
    pairs_.find(world, bodies_, sleeping());
    pairs_.list_near(contacts_);
    again = sleeping_.wake_touched(world, contacts_) > 0;
    report.pair_tests += again ? pairs_.tests() : 0;
  }
}

// Pairs of the last step whose bodies are still where it has left them.
void Impulse::list_pushed(const World& world) {
  pushed_.clear();
  for (const KeptPush& kept : kept_) {
    const std::optional<int> first = world.find(kept.first);
    const std::optional<int> second = world.find(kept.second);
    if (!first || !second) continue;
    if (world.states()[idx(*first)].position_w == kept.first_position_w &&
        world.states()[idx(*second)].position_w == kept.second_position_w)
      pushed_.push_back({*first, *second, kept.pair.point_w, kept.pair.normal_w});
  }
}

// Impulses were decided where the bodies are by now.
void Impulse::keep_pushed(const World& world) {
  kept_.clear();
  if (options_.pose == PoseUpdate::separate) return;
  for (const int number : pairs_.all()) {
    const std::optional<PushedPair> pair = pushed_pair(pairs_[number].contact);
    if (!pair) continue;
    const std::size_t i = idx(pair->first), j = idx(pair->second);
    kept_.push_back({world.ids()[i], world.ids()[j], world.states()[i].position_w,
                     world.states()[j].position_w, *pair});
  }
}

// One pass over all pairs that overlap at its start. Each is looked at where earlier impulses have
// it by then. Returns whether there was an impulse.
bool Impulse::collide_deepest_first(const World& world, double dt, StepReport& report) {
  bodies_.carry(world);
  const std::span<int> found = pairs_.find(world, bodies_, sleeping());
  std::sort(found.begin(), found.end(), [&](int a, int b) {
    const ImpulsePair& p = pairs_[a];
    const ImpulsePair& q = pairs_[b];
    return p.depth != q.depth ? p.depth > q.depth : p.bodies < q.bodies;
  });
  ++report.iterations;
  bool pushed = false;
  for (const int number : found) {
    ImpulsePair& pair = pairs_.look(world, bodies_, number);
    if (!pair.overlaps) continue;
    const double speed = least_normal_speed(pair.contact, bodies_.moving());
    const StickyScale scale{world.gravity_w.norm(), pair.size, dt};
    StickyOptions sticky{.rule = options_.sticky > 0.0 ? StickyRule::speed : StickyRule::off,
                         .threshold = options_.sticky};
    const double restitution = sticky_restitution(pair.contact.restitution, speed, scale, sticky);
    const PushResult push = push_.collide(pair, bodies_.moving(), restitution, dt);
    if (!push.pushed) continue;
    book(push, report);
    bodies_.predict(world, pair.bodies.first);
    bodies_.predict(world, pair.bodies.second);
    pushed = true;
  }
  return pushed;
}

// One event for each pair that collided; then impulses are counted anew, those of contacts.
void Impulse::report_collisions(const World& world, StepReport& report) {
  Event moment{.time = world.time()};
  for (const int number : pairs_.all()) {
    Contact& contact = pairs_[number].contact;
    if (!report_collision(contact, moment, observer())) continue;
    ++report.events;
    for (int k = 0; k < contact.count; ++k) {
      contact.points[idx(k)].normal_impulse = 0.0;
      contact.points[idx(k)].friction_impulse_w.setZero();
    }
  }
}

// Which bodies hold up which. Two boxes of a stack that all fall together do not come nearer; each alone
// would. So all pairs count that are as near as gravity brings a body to one that stays.
void Impulse::build_graph(const World& world) {
  pairs_.find(world, bodies_, sleeping());
  pairs_.list_near(contacts_);
  support_edges(contacts_, world.gravity_w, edges_);
  graph_.build(world.bodies(), edges_);
}

// One pass from the ground up over all pairs that have been near each other: one that is apart
// when the pass begins may overlap by the time its lower body has been lifted. A pair belongs to
// the level of its upper body. Returns whether there was an impulse.
bool Impulse::hold_by_level(const World& world, double share, bool freeze, double dt,
                            StepReport& report) {
  bodies_.carry(world);
  pairs_.find(world, bodies_, sleeping());
  order_.assign(pairs_.all().begin(), pairs_.all().end());
  const auto level = [&](int number) {
    const IndexPair& pair = pairs_[number].bodies;
    return std::max(graph_.level(pair.first), graph_.level(pair.second));
  };
  std::sort(order_.begin(), order_.end(), [&](int a, int b) {
    if (level(a) != level(b)) return level(a) < level(b);
    const ImpulsePair& p = pairs_[a];
    const ImpulsePair& q = pairs_[b];
    return p.depth != q.depth ? p.depth > q.depth : p.bodies < q.bodies;
  });
  const std::span<const int> upwards = graph_.order();
  std::size_t frozen = 0;  // how many bodies of this order
  bool pushed = false;
  for (std::size_t begin = 0; begin < order_.size();) {
    const int here = level(order_[begin]);
    std::size_t end = begin;
    while (end < order_.size() && level(order_[end]) == here) ++end;
    for (; freeze && frozen < upwards.size() && graph_.level(upwards[frozen]) < here; ++frozen)
      bodies_.freeze(upwards[frozen]);
    const std::span<const int> pairs = std::span(order_).subspan(begin, end - begin);
    const bool rising = options_.level_restitution == LevelRestitution::rising ||
                        (freeze && options_.level_restitution == LevelRestitution::shock);
    if (hold_level(world, pairs, share, rising, dt, report)) pushed = true;
    begin = end;
  }
  return pushed;
}

// The pairs of one level, a few times over: they have bodies in common. A share that rises is the
// schedule of the contact passes over again, up to that of this pass.
bool Impulse::hold_level(const World& world, std::span<const int> pairs, double share, bool rising,
                         double dt, StepReport& report) {
  bool pushed = false;
  for (int sweep = 1; sweep <= options_.level_sweeps; ++sweep) {
    ++report.iterations;
    const double now = rising ? share * sweep / options_.level_sweeps : share;
    bool quiet = true;
    for (const int number : pairs) {
      ImpulsePair& pair = pairs_.look(world, bodies_, number);
      if (!pair.overlaps) continue;
      const PushResult push =
          push_.hold(pair, bodies_.moving(), now, dt, 0.5 * dt * world.gravity_w);
      if (!push.pushed) continue;
      book(push, report);
      bodies_.predict(world, pair.bodies.first);
      bodies_.predict(world, pair.bodies.second);
      quiet = false;
    }
    if (quiet) break;
    pushed = true;
  }
  return pushed;
}

void Impulse::book(const PushResult& push, StepReport& report) const {
  report.impulses += push.impulses;
  report.pivots += push.pivots;
  report.energy.restitution += push.normal_work;
  report.energy.friction += push.friction_work;
}

// What the thesis does in place of shock propagation: moves bodies out of each other (4.4).
void Impulse::repair_overlap(World& world, StepReport& report) {
  repair_bounds(world, 0.0, bounds_);
  repair_phase_.find_pairs(bounds_, near_);
  tumble::book(repair_.run(world, near_), report);
}

// Records of the step; bodies at rest may fall asleep.
void Impulse::finish(World& world, double dt, StepReport& report) {
  for (const int number : pairs_.find(world, bodies_, sleeping()))
    report.deepest_overlap = std::max(report.deepest_overlap, pairs_[number].depth);
  report.pair_tests += pairs_.tests();
  for (const int number : pairs_.all()) {
    const Contact& contact = pairs_[number].contact;
    for (int k = 0; k < contact.count; ++k)
      if (contact.points[idx(k)].normal_impulse > 0.0)
        records_.push_back(record_of(contact, k, world.time() + dt));
  }
  report.contacts = static_cast<std::int64_t>(records_.size());
  if (options_.shock == ImpulseShock::position || options_.repair) repair_overlap(world, report);
  keep_pushed(world);
  if (options_.sleeping) {
    islands_.build(world.bodies(), contacts_);
    report.energy.damping += sleeping_.update(world, contacts_, islands_, dt, slow_bodies()).energy;
  }
}

}  // namespace tumble
