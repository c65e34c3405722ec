/// \file
/// \brief Overlaps ended by moving bodies, level by level.
#include "tumble/contact/repair.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/tolerances.hpp"

#include <algorithm>
#include <string>
#include <tuple>

namespace tumble {
namespace {

// The pair with the smaller index first, so that its order cannot change a bit of the result.
IndexPair sorted(const IndexPair& pair, int count) {
  const IndexPair result{std::min(pair.first, pair.second), std::max(pair.first, pair.second)};
  if (!(result.first >= 0 && result.first < result.second && result.second < count))
    refuse("pair " + std::to_string(pair.first) + ", " + std::to_string(pair.second) +
           ": give two different indices below " + std::to_string(count));
  return result;
}

// From the ground to a box: the height of its lowest point, along the ground's normal.
Separation separation_from_ground(const Box& box) {
  const Vec3 up_w = Vec3::UnitY();
  return Separation{box.center_w.y() - reach(box, up_w), up_w, kNoAxis};
}

}  // namespace

OverlapRepair::OverlapRepair(const RepairOptions& options) : options_(options) {
  require::positive(options.slop, "slop");
  require::that(options.most_sweeps >= 1,
                "most_sweeps = " + std::to_string(options.most_sweeps) + ": give at least 1");
}

RepairReport OverlapRepair::run(World& world, std::span<const IndexPair> pairs) {
  RepairReport report;
  prepare(world, pairs);
  report.deepest_before = measure_all(world, report);
  const auto any_too_deep = [&] {
    return std::any_of(candidates_.begin(), candidates_.end(),
                       [](const Candidate& c) { return c.too_deep(); });
  };
  bool overlapping = any_too_deep();
  while (overlapping && report.sweeps < options_.most_sweeps) {
    // From the ground up, each pair as it is by now: pairs below it may have moved its bodies.
    ++report.sweeps;
    sort_from_the_ground_up(world);
    for (Candidate& candidate : candidates_) {
      measure(candidate, world, report);
      if (!candidate.too_deep()) continue;
      move_apart(candidate);
      ++report.moves;
    }
    // Which bodies did these moves push into each other?
    report.deepest_after = measure_all(world, report);
    overlapping = any_too_deep();
  }
  if (report.sweeps == 0) report.deepest_after = report.deepest_before;
  if (overlapping) report.status = RepairStatus::unsolved;
  store(world, report);
  return report;
}

bool OverlapRepair::Candidate::too_deep() const {
  return -distance > slop * (1.0 + tolerance::repair_closeness);
}

void OverlapRepair::prepare(const World& world, std::span<const IndexPair> pairs) {
  const std::size_t count = world.bodies().size();
  boxes_.resize(count);
  ease_.resize(count);
  for (std::size_t b = 0; b < count; ++b) {
    if (world.bodies()[b].shape == Shape::box)
      boxes_[b] = box_of(world.bodies()[b], world.states()[b]);
    ease_[b] = world.sleep_states()[b].asleep ? 0.0 : world.bodies()[b].inverse_mass;
  }
  moves_.assign(count, 0);
  stride_.assign(count, 1.0);
  push_w_.assign(count, Vec3::Zero());

  candidates_.clear();
  for (const IndexPair& given : pairs) {
    const IndexPair pair = sorted(given, world.count());
    if (ease_[idx(pair.first)] == 0.0 && ease_[idx(pair.second)] == 0.0) continue;
    Candidate candidate;
    candidate.pair = pair;
    candidate.slop = options_.slop * shortest_edge(world.bodies()[idx(pair.first)],
                                                   world.bodies()[idx(pair.second)]);
    candidates_.push_back(candidate);
  }
}

// Finds distance and normal, unless nothing has moved since they were found last.
void OverlapRepair::measure(Candidate& candidate, const World& world, RepairReport& report) {
  const int first = candidate.pair.first;
  const int second = candidate.pair.second;
  if (candidate.first_moves == moves_[idx(first)] && candidate.second_moves == moves_[idx(second)])
    return;
  candidate.first_moves = moves_[idx(first)];
  candidate.second_moves = moves_[idx(second)];
  ++report.pair_tests;

  Separation found;
  if (world.bodies()[idx(first)].shape == Shape::ground) {
    found = separation_from_ground(boxes_[idx(second)]);
  } else if (world.bodies()[idx(second)].shape == Shape::ground) {
    found = separation_from_ground(boxes_[idx(first)]);
    found.normal_w = -found.normal_w;
  } else {
    // Pairs with a gap of up to the slop count as touching for the order of support.
    found = separation(boxes_[idx(first)], boxes_[idx(second)], {.enough = candidate.slop});
  }
  candidate.distance = found.distance;
  candidate.normal_w = found.normal_w;
}

// [m] the deepest overlap, 0 if there is none
double OverlapRepair::measure_all(const World& world, RepairReport& report) {
  double deepest = 0.0;
  for (Candidate& candidate : candidates_) {
    measure(candidate, world, report);
    deepest = std::max(deepest, -candidate.distance);
  }
  return deepest;
}

// Pairs in order of the upper body's level: all that a body rests on comes before what rests on it.
void OverlapRepair::sort_from_the_ground_up(const World& world) {
  const Vec3 up_w = -world.gravity_w.stableNormalized();  // 0 without gravity: all of one level
  edges_.clear();
  for (const Candidate& c : candidates_) {
    if (c.distance > c.slop) continue;
    const int direction = support_direction(c.normal_w, up_w);
    if (direction > 0) edges_.push_back({c.pair.first, c.pair.second});
    if (direction < 0) edges_.push_back({c.pair.second, c.pair.first});
  }
  graph_.build(world.bodies(), edges_);
  for (Candidate& c : candidates_)
    std::tie(c.lower_level, c.upper_level) =
        std::minmax({graph_.level(c.pair.first), graph_.level(c.pair.second)});
  const auto key = [](const Candidate& c) {
    return std::tuple(c.upper_level, c.lower_level, c.pair.first, c.pair.second);
  };
  std::sort(candidates_.begin(), candidates_.end(),
            [&](const Candidate& a, const Candidate& b) { return key(a) < key(b); });
}

// Moves the upper body along the normal until only the slop is left; both, if they are of one
// level, by shares in the ratio of their inverse masses: then their common centre stays.
void OverlapRepair::move_apart(const Candidate& candidate) {
  const int first = candidate.pair.first;
  const int second = candidate.pair.second;
  double first_ease = ease_[idx(first)];
  double second_ease = ease_[idx(second)];
  if (first_ease > 0.0 && second_ease > 0.0) {
    if (graph_.level(first) < graph_.level(second)) first_ease = 0.0;
    if (graph_.level(first) > graph_.level(second)) second_ease = 0.0;
  }
  const Vec3 parting_w = (-candidate.distance - candidate.slop) * candidate.normal_w;
  const double whole = first_ease + second_ease;
  if (first_ease > 0.0) move(first, -first_ease / whole * parting_w, second_ease == 0.0);
  if (second_ease > 0.0) move(second, second_ease / whole * parting_w, first_ease == 0.0);
}

// Moves a body; `alone`: the other one stays. Two such pushes in opposite directions mean that there
// may be no room. Half the step from then on ends in the middle instead of swinging for ever. Pushes
// that are shared do not count: in a row of boxes they come from both sides and still lead outwards.
void OverlapRepair::move(int body, const Vec3& push_w, bool alone) {
  if (alone) {
    Vec3& before_w = push_w_[idx(body)];
    const double limit = tolerance::repair_to_and_fro * push_w.norm() * before_w.norm();
    if (push_w.dot(before_w) < limit) stride_[idx(body)] *= 0.5;
    before_w = push_w;
  }
  boxes_[idx(body)].center_w += (alone ? stride_[idx(body)] : 1.0) * push_w;
  ++moves_[idx(body)];
}

void OverlapRepair::store(World& world, RepairReport& report) const {
  for (std::size_t b = 0; b < boxes_.size(); ++b) {
    if (moves_[b] == 0) continue;
    Vec3& position_w = world.states()[b].position_w;
    report.energy -= world.bodies()[b].mass * world.gravity_w.dot(boxes_[b].center_w - position_w);
    position_w = boxes_[b].center_w;
  }
}

void book(const RepairReport& repaired, StepReport& report) {
  report.pair_tests += repaired.pair_tests;
  report.energy.repair += repaired.energy;
  report.deepest_overlap = std::max(report.deepest_overlap, repaired.deepest_before);
}

void repair_bounds(const World& world, double margin, std::vector<Bounds>& out) {
  out.resize(world.bodies().size());
  for (std::size_t k = 0; k < out.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    out[k] = bounds_of(body, world.states()[k],
                       0.5 * margin + tolerance::repair_slop * body.size.maxCoeff());
  }
}

}  // namespace tumble
