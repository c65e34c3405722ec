/// \file
/// \brief Adaptive time step by halving (thesis 6.3.1).
#include "tumble/filtering/adaptive_step.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/dynamics/step_report.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace tumble {
namespace {

double thickness(const BodyProperties& body) {
  return body.shape == Shape::ground ? std::numeric_limits<double>::infinity()
                                     : body.size.minCoeff();
}

// [m] Of the movable bodies.
double shortest_edge(const World& world) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const BodyProperties& body : world.bodies())
    if (body.movable()) shortest = std::min(shortest, thickness(body));
  return shortest;
}

// Halvings needed for a sub-step to be aligned at this place. Places and lengths are in the shortest
// sub-steps.
int aligned(std::int64_t place, int halvings) {
  int k = 0;
  while (place % (std::int64_t{1} << (halvings - k)) != 0) ++k;
  return k;
}

void sort_and_thin(std::vector<BodyId>& ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

void require_valid(const AdaptiveStepOptions& options) {
  const auto above_zero = [](double value, const char* name) {  // infinity: no limit
    require::that(value > 0.0,
                  std::string(name) + " = " + shortest_text(value) + ": expected a number above 0");
  };
  require::that(options.halvings >= 0 && options.halvings <= AdaptiveStepOptions::kMostHalvings,
                "halvings = " + std::to_string(options.halvings) + ": expected 0 to " +
                    std::to_string(AdaptiveStepOptions::kMostHalvings));
  require::that(options.fewest >= 0 && options.fewest <= options.halvings,
                "fewest = " + std::to_string(options.fewest) +
                    ": expected 0 to halvings = " + std::to_string(options.halvings));
  above_zero(options.movement, "movement");
  above_zero(options.turn, "turn");
  above_zero(options.overlap, "overlap");
  above_zero(options.shake, "shake");
  require::that(options.calm >= 1,
                "calm = " + std::to_string(options.calm) + ": expected 1 or more");
}

}  // namespace

AdaptiveStep::AdaptiveStep(std::unique_ptr<Technique> inner, const AdaptiveStepOptions& options)
    : Cloned(std::move(inner)), options_(options), level_(options.fewest) {
  require_valid(options);
}

StepReport AdaptiveStep::step(World& world, double dt) {
  require::positive(dt, "dt");
  Technique& technique = prepared_inner();
  const double end = world.time() + dt;
  const std::int64_t whole = std::int64_t{1} << options_.halvings;
  substeps_.clear();
  touched_.clear();
  StepReport total;
  for (std::int64_t place = 0; place < whole;) {
    const int k = halvings_for(world, dt, aligned(place, options_.halvings));
    const std::int64_t length = whole >> k;
    double h = dt / static_cast<double>(std::int64_t{1} << k);
    place += length;
    // The last sub-step absorbs the clock's rounding, unless the clock cannot resolve sub-steps.
    if (place == whole && k > 0 && end > world.time()) h = end - world.time();
    store_corners(world);
    const StepReport report = technique.step(world, h);
    substeps_.push_back(h);
    add_report(report, total);
    total.contacts = report.contacts;
    if (!all_finite(world)) total.status = StepStatus::not_finite;
    if (total.status >= StepStatus::unsolved) break;
    store_displacements(world);
    if (requests_halving(world, report)) {
      level_ = std::min(level_ + 1, options_.halvings);
      quiet_ = 0;
    } else if ((quiet_ += length) >= whole * options_.calm) {
      level_ = std::max(level_ - 1, options_.fewest);
      quiet_ = 0;
    }
  }
  sort_and_thin(touched_);
  return total;
}

// [S6.3.1:ahead]
// The longest length that may begin here and in which no two near bodies move too far.
int AdaptiveStep::halvings_for(const World& world, double dt, int least) {
  int k = std::max(least, level_);
  if (k == options_.halvings) return k;
  double h = dt / static_cast<double>(std::int64_t{1} << k);
  find_near(world, h);
  const double gravity = world.gravity_w.norm();
  for (const IndexPair& pair : pairs_) {
    const auto i = static_cast<std::size_t>(pair.first);
    const auto j = static_cast<std::size_t>(pair.second);
    const BodyProperties& a = world.bodies()[i];
    const BodyProperties& b = world.bodies()[j];
    if (!a.movable() && !b.movable()) continue;
    const BodyState& s = world.states()[i];
    const BodyState& t = world.states()[j];
    // Gravity does not change the relative velocity of two movable bodies.
    const double fall = a.movable() && b.movable() ? 0.0 : gravity;
    const double speed = (velocity(a, s) - velocity(b, t)).norm();
    const double spin = std::max(angular_velocity(a, s).norm(), angular_velocity(b, t).norm());
    const double room = options_.movement * std::min(thickness(a), thickness(b));
    while (k < options_.halvings && ((speed + fall * h) * h > room || spin * h > options_.turn)) {
      ++k;
      h *= 0.5;
    }
  }
  return k;
}
// [S6.3.1:ahead]

// Pairs of bodies whose bounds, swept over h, overlap.
void AdaptiveStep::find_near(const World& world, double h) {
  bounds_.resize(world.bodies().size());
  for (std::size_t i = 0; i < bounds_.size(); ++i) {
    const BodyProperties& body = world.bodies()[i];
    const BodyState& state = world.states()[i];
    if (!body.movable() || world.sleep_states()[i].asleep) {
      bounds_[i] = bounds_of(body, state);
      continue;
    }
    const double reach = 0.5 * body.size.norm();
    const double turn = std::min(1.0, h * angular_velocity(body, state).norm());
    bounds_[i] = bounds_of(body, state, turn * reach);
    const Vec3 displacement_w = h * (velocity(body, state) + h * world.gravity_w);
    bounds_[i].low += displacement_w.cwiseMin(0.0);
    bounds_[i].high += displacement_w.cwiseMax(0.0);
  }
  broad_phase_.find_pairs(bounds_, pairs_);
}

void AdaptiveStep::store_corners(const World& world) {
  before_.resize(world.bodies().size());
  for (std::size_t i = 0; i < before_.size(); ++i)
    if (world.bodies()[i].movable())
      before_[i] = corners_of(box_of(world.bodies()[i], world.states()[i]));
}

// Stores the displacements of the bodies in contact.
void AdaptiveStep::store_displacements(const World& world) {
  touching_.clear();
  for (const ContactRecord& contact : contacts()) {
    touching_.push_back(contact.first);
    touching_.push_back(contact.second);
  }
  sort_and_thin(touching_);
  touched_.insert(touched_.end(), touching_.begin(), touching_.end());
  std::swap(displacements_, displacements_before_);
  displacements_.clear();
  for (const BodyId id : touching_) {
    const auto i = static_cast<std::size_t>(world.index_of(id));
    if (!world.bodies()[i].movable()) continue;
    Displacement moved{id, corners_of(box_of(world.bodies()[i], world.states()[i]))};
    for (std::size_t c = 0; c < moved.corners_w.size(); ++c) moved.corners_w[c] -= before_[i][c];
    displacements_.push_back(moved);
  }
}

// [S6.3.1:call]
// Whether the sub-step requests smaller ones.
bool AdaptiveStep::requests_halving(const World& world, const StepReport& report) const {
  if (report.deepest_overlap > options_.overlap * shortest_edge(world)) return true;
  auto before = displacements_before_.begin();
  for (const Displacement& now : displacements_) {
    while (before != displacements_before_.end() && before->id < now.id) ++before;
    if (before == displacements_before_.end()) break;
    if (before->id != now.id) continue;
    const auto i = static_cast<std::size_t>(world.index_of(now.id));
    const double least = options_.shake * thickness(world.bodies()[i]);
    for (std::size_t c = 0; c < now.corners_w.size(); ++c)
      if (now.corners_w[c].dot(before->corners_w[c]) < 0.0 &&
          std::min(now.corners_w[c].norm(), before->corners_w[c].norm()) > least)
        return true;
  }
  return false;
}
// [S6.3.1:call]

}  // namespace tumble
