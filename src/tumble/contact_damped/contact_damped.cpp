/// \file
/// \brief The default technique: a step.
#include "tumble/contact_damped/contact_damped.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/contact_damped/tolerances.hpp"
#include "tumble/dynamics/integrate.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace tumble {

ContactDamped::ContactDamped(const ContactDampedOptions& options)
    : options_(options), broad_phase_(make_broad_phase("bounding_tree")) {
  for (const auto& [count, least, name] :
       {std::tuple{options.passes, 1, "passes"}, std::tuple{options.rounds, 0, "rounds"},
        std::tuple{options.repair_passes, 1, "repair_passes"}})
    require::that(count >= least, std::string(name) + " = " + std::to_string(count) +
                                      ": expected " + std::to_string(least) + " or more");
}

ContactDamped::ContactDamped(const ContactDamped& other)
    : Technique(other),
      options_(other.options_),
      broad_phase_(other.broad_phase_->clone()),
      areas_(other.areas_),
      island_solver_(other.island_solver_),
      sleeping_(other.sleeping_),
      islands_(other.islands_),
      graph_(other.graph_),
      last_dt_(other.last_dt_),
      unsettled_(other.unsettled_),
      ordered_for_(other.ordered_for_),
      ordered_gravity_w_(other.ordered_gravity_w_),
      touching_(other.touching_),
      names_(other.names_),
      order_(other.order_),
      order_start_(other.order_start_),
      start_(other.start_),
      contact_time_(other.contact_time_) {}

std::unique_ptr<Technique> ContactDamped::clone() const {
  return std::make_unique<ContactDamped>(*this);
}

StepReport ContactDamped::step(World& world, double dt) {
  require::positive(dt, "dt");
  StepReport report;
  contact_time_ = world.time();
  recorded_ = false;
  if (!options_.sleeping)  // whoever another technique has put to sleep
    for (SleepState& rest : world.sleep_states()) rest.asleep = false;
  if (options_.sleeping && sleeping_.wake_disturbed(world) == 0 && sleeping_.nobody_awake()) {
    world.finish_step(dt);
    return report;
  }
  // [S6.3.1:step]
  // Gravity, then the areas in which bodies touch or will within the
  // step, by islands of bodies that touch each other.
  load(world, dt);
  find_areas(world, dt, report);
  // Impulses that end all approach, and slip as far as friction can.
  unsettling_.clear();
  unsettling_.reserve(at(islands_.count()));
  flies_.assign(bodies_.size(), 1);
  for (int island = 0; island < islands_.count(); ++island) solve_island(world, island, dt, report);
  std::swap(unsettled_, unsettling_);
  // Bodies go where these velocities take them; what hit fast enough
  // bounces from there.
  move(world, dt, report);
  bounce(world, dt, report);
  // What overlap is left goes, and no velocity changes.
  repair(world, dt, report);
  // [S6.3.1:step]
  account(world, dt, report);
  if (options_.sleeping)
    report.energy.damping +=
        sleeping_.update_with_pairs(world, touching_, islands_, dt, slow_bodies()).energy;
  last_dt_ = dt;
  world.finish_step(dt);
  return report;
}

// Velocities before gravity, with it, and (to be changed) at the end. Sleepers are as heavy as walls.
void ContactDamped::load(const World& world, double dt) {
  load_moving_bodies(world, start_);
  for (std::size_t k = 0; k < start_.size(); ++k) {
    if (!world.sleep_states()[k].asleep) continue;
    start_[k].inverse_mass.setZero();
    start_[k].inverse_inertia_w.setZero();
  }
  free_ = start_;
  for (MovingBody& body : free_)
    if (body.inverse_mass.x() > 0.0) body.velocity_w += dt * world.gravity_w;
  bodies_ = free_;
  moves_.reserve(free_.size());  // so that a first repair or bounce asks for no memory
  moved_.reserve(free_.size());
}

// Pairs that may come together in the step: bounds that reach as far as the bodies do in it.
void ContactDamped::find_candidates(const World& world, double dt) {
  bounds_.resize(at(world.count()));
  for (std::size_t k = 0; k < bounds_.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable()) {
      bounds_[k] = bounds_of(body, world.states()[k]);
      continue;
    }
    const double turn = 0.5 * body.size.norm() * free_[k].angular_velocity_w.norm();
    bounds_[k] = bounds_of(body, world.states()[k],
                           dt * turn + tolerance::kept_margin * body.size.minCoeff());
    const Vec3 way_w = dt * free_[k].velocity_w;
    bounds_[k].low += way_w.cwiseMin(0.0);
    bounds_[k].high += way_w.cwiseMax(0.0);
  }
  broad_phase_->find_pairs(bounds_, candidates_);
  if (!options_.sleeping) return;
  std::erase_if(candidates_, [&](const IndexPair& pair) {
    return !sleeping_.needs_test(pair.first, pair.second);
  });
}

void ContactDamped::find_areas(World& world, double dt, StepReport& report) {
  double ratio = last_dt_ > 0.0 ? dt / last_dt_ : 1.0;
  for (;;) {
    find_candidates(world, dt);
    const ManifoldsFound found = areas_.find(world, free_, candidates_, dt, ratio);
    report.pair_tests += found.pair_tests;
    std::swap(touching_, touched_);
    std::swap(names_, named_);
    touching_.clear();
    names_.clear();
    for (const ContactPatch& block : areas_.blocks()) {
      touching_.push_back({block.first, block.second});
      names_.emplace_back(block.first_id, block.second_id);
    }
    // Who is touched wakes up, and his neighbours have to be looked for.
    if (options_.sleeping && sleeping_.wake_touched_pairs(world, touching_) > 0) {
      load(world, dt);
      ratio = 1.0;  // impulses have it already
      ordered_for_ = -1;
      continue;
    }
    report.deepest_overlap = found.deepest_overlap;
    if (touching_ != touched_ || names_ != named_ || ordered_for_ != world.count() ||
        ordered_gravity_w_ != world.gravity_w)
      order_islands(world);
    return;
  }
}

// The areas of each island from the ground up: by the level of the higher of their two bodies.
void ContactDamped::order_islands(const World& world) {
  islands_.build_from_pairs(world.bodies(), touching_);
  ordered_for_ = world.count();
  ordered_gravity_w_ = world.gravity_w;
  const double g = world.gravity_w.norm();
  edges_.clear();
  if (g > 0.0) {
    for (const ContactPatch& block : areas_.blocks()) {
      const int direction = support_direction(block.frame_w.col(2), -world.gravity_w / g);
      if (direction > 0) edges_.push_back({block.first, block.second});
      if (direction < 0) edges_.push_back({block.second, block.first});
    }
  }
  graph_.build(world.bodies(), edges_);
  order_.clear();
  order_start_.assign(1, 0);
  const auto level = [&](int area) {
    const IndexPair& pair = touching_[at(area)];
    return std::max(graph_.level(pair.first), graph_.level(pair.second));
  };
  for (int island = 0; island < islands_.count(); ++island) {
    const std::span<const int> areas = islands_.contacts(island);
    order_.insert(order_.end(), areas.begin(), areas.end());
    std::sort(order_.begin() + order_start_.back(), order_.end(),
              [&](int a, int b) { return level(a) != level(b) ? level(a) < level(b) : a < b; });
    order_start_.push_back(static_cast<int>(order_.size()));
  }
}

std::span<const int> ContactDamped::ordered(int island) const {
  const auto begin = at(order_start_[at(island)]);
  return std::span<const int>(order_).subspan(begin, at(order_start_[at(island) + 1]) - begin);
}

// Who is carried by whom: areas push at the centre of their pressure. Where surfaces that touch stick, what
// they still move against each other is what the solver has left.
void ContactDamped::find_carried(const World& world) {
  pushed_.clear();
  for (const ContactPatch& block : areas_.blocks()) {
    PushedPair pair{block.first, block.second, Vec3::Zero(), block.frame_w.col(2)};
    double weight = 0.0;
    const Six all = impulse_of(block);
    const double limit = (1.0 - tolerance::friction_limit) * block.friction * all[2];
    if (std::sqrt(all[0] * all[0] + all[1] * all[1]) < limit) pair.state = PushedState::held;
    for (std::size_t i = 0; i < at(block.count); ++i) {
      const ContactPatchPoint& p = block.points[i];
      if (p.impulse > 0.0 && std::abs(p.gap) > tolerance::contact_damped_slop * block.size)
        pair.state = PushedState::unknown;  // it closes a gap, or there is overlap
      pair.point_w += p.impulse * position_of(block, start_[at(block.first)], p);
      weight += p.impulse;
    }
    if (!(weight > 0.0)) continue;
    pair.point_w /= weight;
    pushed_.push_back(pair);
  }
  carried_.find(world.bodies(), bodies_, pushed_);
}

// Bodies that are pushed move with the velocity at the end of the step, which keeps what contacts ask for;
// the others fly their parabola.
void ContactDamped::move(World& world, double dt, StepReport& report) {
  store_moving_bodies(bodies_, world);
  if (options_.pose == PoseUpdate::exponential) find_carried(world);
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (bodies_[k].inverse_mass.x() == 0.0) continue;
    BodyState& state = world.states()[k];
    if (flies_[k] != 0) {
      fly(body, state, world.gravity_w, dt, options_.rotation);
    } else {
      state.linear_momentum_w = body.mass * bodies_[k].velocity_w;
      if (carried_.carries(static_cast<int>(k))) {
        report.energy.repair += carried_.move(static_cast<int>(k), dt, world);
      } else {
        advance_pose(body, state, dt, options_.rotation);
      }
    }
    ++report.integrations;
  }
}

}  // namespace tumble
