/// \file
/// \brief The search for collisions in the listings of the synchronised timewarp, as printed (thesis A.1).
#include "tumble/timewarp/as_printed/queries_as_printed.hpp"

#include "tumble/timewarp/near_pairs.hpp"

#include <algorithm>

namespace tumble {

PrintedQueries::PrintedQueries(const TimewarpAsPrintedOptions& options)
    : options_(options),
      mended_{.valid_times = options.repaired.has("T4"),
              .ways = options.repaired.has("T5"),
              .contact_stage = options.repaired.has("T6"),
              .apart = options.repaired.has("T7"),
              .exact_flight = options.repaired.has("T8"),
              .together = options.repaired.has("T9"),
              .movable_only = options.repaired.has("T10"),
              .strictly_before = options.repaired.has("F6"),
              .swept = options.repaired.has("F7")},
      method_(mended_.ways ? SearchMethod::conservative : SearchMethod::discrete),
      stage_({options.resolution, options.pair_events}) {}

void PrintedQueries::begin(World& world, double dt, Observer* observer) {
  require_step(dt, {.resolution = options_.resolution});
  world_ = &world;
  dt_ = dt;
  observer_ = observer;
  report = {};
  records_.clear();
  stage_.begin();
  start_.assign(world.states().begin(), world.states().end());
  test.resize(start_.size());
  valid_times.resize(start_.size());
  zeros_.assign(start_.size(), 0.0);
  bounds_.resize(start_.size());
  moving_.resize(start_.size());
}

bool PrintedQueries::stamped(int body) const { return movable(body) || !mended_.movable_only; }

// Erratum T8: one step of semi-implicit Euler of any length; two steps do not lead to the same state
// as one step of their total length.
void PrintedQueries::integrate_forward(BodyState& state, int body, double time) {
  if (!movable(body)) return;
  const BodyProperties& properties = world_->bodies()[idx(body)];
  if (mended_.exact_flight)
    fly(properties, state, world_->gravity_w, time, options_.rotation);
  else
    step_semi_implicit(properties, state, world_->gravity_w, time, options_.rotation);
  ++report.integrations;
}

// The gravity of the flight that integrate_forward() computes: x + t (v + t g) is a parabola for twice
// the gravity (T8).
Vec3 PrintedQueries::gravity_of_flight() const {
  return mended_.exact_flight ? world_->gravity_w : Vec3(2.0 * world_->gravity_w);
}

// Erratum T4: the listings pass no valid times to a search.
Flight PrintedQueries::flight() const {
  return Flight{.bodies = world_->bodies(),
                .states = world_->states(),
                .valid_times = mended_.valid_times ? valid_times : zeros_,
                .gravity_w = gravity_of_flight(),
                .rule = options_.rotation};
}

// Erratum T5: bounds of the test state. Mended: of the flight to it.
Bounds PrintedQueries::bounds_of_body(int body) const {
  const BodyProperties& properties = world_->bodies()[idx(body)];
  if (!mended_.ways) return bounds_of(properties, test[idx(body)]);
  const Flight all = flight();
  return bounds_of_flight(properties, all.states[idx(body)], all.gravity_w,
                          dt_ - all.valid_times[idx(body)], 0.5 * properties.size.norm());
}

void PrintedQueries::find_all_collisions(CollisionHeap& heap) {
  heap.reset(world_->count());
  for (int body = 0; body < world_->count(); ++body) bounds_[idx(body)] = bounds_of_body(body);
  broad_phase_.find_pairs(bounds_, candidates_);
  for (const IndexPair& pair : candidates_) search(pair, heap);
}

void PrintedQueries::remove_first_collision(CollisionHeap& heap, PrintedMoment& out) const {
  const ForeseenCollision first = heap.remove_first();
  out.time = first.time;
  out.pairs.assign(1, first.pair);
  // Erratum T9 mended: with all that cannot be distinguished from it in time.
  const double last = first.time + options_.resolution;
  while (mended_.together && !heap.empty() && heap.first().time <= last)
    out.pairs.push_back(heap.remove_first().pair);
  std::sort(out.pairs.begin(), out.pairs.end());
  out.pairs.erase(std::unique(out.pairs.begin(), out.pairs.end()), out.pairs.end());
  out.indices.clear();
  for (const IndexPair& pair : out.pairs)
    out.indices.insert(out.indices.end(), {pair.first, pair.second});
  std::sort(out.indices.begin(), out.indices.end());
  out.indices.erase(std::unique(out.indices.begin(), out.indices.end()), out.indices.end());
}

void PrintedQueries::add_collisions_for(std::span<const int> bodies, CollisionHeap& heap) {
  for (int body = 0; body < world_->count(); ++body) bounds_[idx(body)] = bounds_of_body(body);
  for_each_near_pair(
      bodies, [&](int body) { return stamped(body); }, bounds_,
      [&](const IndexPair& pair) { search(pair, heap); });
}

void PrintedQueries::search(const IndexPair& pair, CollisionHeap& heap) {
  if (!(movable(pair.first) || movable(pair.second)) || stage_.holds(pair)) return;
  if (const std::optional<double> time = first_collision(pair, dt_)) heap.insert({*time, pair});
}

double PrintedQueries::gap_of(std::span<const BodyState> states, const IndexPair& pair) {
  ++report.pair_tests;
  return gap_between(world_->bodies()[idx(pair.first)], states[idx(pair.first)],
                     world_->bodies()[idx(pair.second)], states[idx(pair.second)])
      .distance;
}

// The time of a pair's first collision before `end`: it collides if the test states overlap. The time is
// searched between the later of the valid times and the end, both bodies flown from their valid
// states. So test states that do not follow from the valid ones (T3) are a collision at the end.
std::optional<double> PrintedQueries::first_collision(const IndexPair& pair, double end) {
  const Flight all = flight();
  const double start =
      std::max(all.valid_times[idx(pair.first)], all.valid_times[idx(pair.second)]);
  const auto gap = [&](double time) {
    ++report.pair_tests;
    return gap_at(all, pair, time).distance;
  };
  if (!mended_.ways && gap_of(test, pair) >= 0.0) return std::nullopt;
  // Erratum T7: a pair that overlaps at the start of its search collides now, again and again.
  if (!(start < end)) {
    const bool now = !mended_.apart && (!mended_.ways || gap(end) < 0.0);
    return now ? std::optional(end) : std::nullopt;
  }
  const SearchOptions how{.method = method_,
                          .resolution = std::min(options_.resolution, end - start),
                          .cap = TimewarpOptions::kMostSeparations};
  const double gap_at_start = gap(start);
  if (gap_at_start < 0.0) {
    const bool collides = !mended_.apart || gap(start + how.resolution) < gap_at_start;
    return collides ? std::optional(start) : std::nullopt;
  }
  const PairCollision found = mended_.ways ? advance_to_collision(all, pair, start, end, how)
                                           : bisect_collision(all, pair, {start, end}, how);
  report.pair_tests += found.evaluations;
  report.searches += found.evaluations;
  if (found.status == CollisionStatus::cap_reached && mended_.contact_stage) stage_.defer(pair);
  if (found.status != CollisionStatus::found) return std::nullopt;
  return mended_.apart ? found.time : found.overlap_time;
}

void PrintedQueries::find_near_objects(const PrintedMoment& moment, std::vector<int>& out) const {
  const auto bounds = [&](int body) {
    const BodyProperties& properties = world_->bodies()[idx(body)];
    // Erratum F7: bounds of the test state. Mended: of the flight from the valid time on.
    if (!mended_.swept) return bounds_of(properties, test[idx(body)]);
    return bounds_of_flight(properties, world_->states()[idx(body)], gravity_of_flight(),
                            moment.time - valid_times[idx(body)], 0.5 * properties.size.norm());
  };
  out.clear();
  for (int body = 0; body < world_->count(); ++body) {
    const bool itself = std::binary_search(moment.indices.begin(), moment.indices.end(), body);
    // A body that is valid at a later time has no trajectory until then.
    if (!itself && mended_.swept && valid_times[idx(body)] > moment.time) continue;
    const Bounds own = bounds(body);
    const bool near = std::any_of(moment.indices.begin(), moment.indices.end(),
                                  [&](int index) { return overlap(own, bounds(index)); });
    if (itself || near) out.push_back(body);
  }
}

std::optional<ForeseenCollision> PrintedQueries::find_collisions_for_group(
    std::span<const int> group, const PrintedMoment& moment) {
  std::optional<ForeseenCollision> earliest;
  const double before = moment.time - options_.resolution;
  for (std::size_t i = 0; i < group.size(); ++i) {
    for (std::size_t j = i + 1; j < group.size(); ++j) {
      const IndexPair pair{group[i], group[j]};
      if (!(movable(pair.first) || movable(pair.second)) || stage_.holds(pair)) continue;
      const bool present = std::binary_search(moment.pairs.begin(), moment.pairs.end(), pair);
      if (mended_.strictly_before && present) continue;
      const Bounds first = bounds_of(world_->bodies()[idx(pair.first)], test[idx(pair.first)]);
      const Bounds second = bounds_of(world_->bodies()[idx(pair.second)], test[idx(pair.second)]);
      if (!overlap(first, second)) continue;
      const std::optional<double> time = first_collision(pair, moment.time);
      if (!time || (mended_.strictly_before && !(*time < before))) continue;
      if (!earliest || ForeseenCollision{*time, pair} < *earliest)
        earliest = ForeseenCollision{*time, pair};
    }
  }
  return earliest;
}

}  // namespace tumble
