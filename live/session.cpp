/// \file
/// \brief A simulation with boxes thrown in and taken away, and the numbers that are drawn.
#include "session.hpp"

#include "tumble/analytic_lcp/touch.hpp"
#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/islands.hpp"
#include "tumble/contact/pivot_update.hpp"
#include "tumble/geometric_stability/stable_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace tumble::live {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMostEvents = 4096;  // between two looks; a page draws no more

void append(const Vec3& v, std::vector<double>& out) {
  out.insert(out.end(), {v.x(), v.y(), v.z()});
}

void append(const BodyState& state, std::vector<double>& out) {
  append(state.position_w, out);
  const Quat& q = state.orientation_wb;
  out.insert(out.end(), {q.x(), q.y(), q.z(), q.w()});
}

// Calls see(name, value) for each number of a session.
template <class See>
void each_number(const World& world, const StepReport& report, const Metrics& metrics,
                 const See& see) {
  see("time", world.time());
  see("steps", world.steps());
  see("status", static_cast<int>(report.status));
  see("kinetic", metrics.kinetic);
  see("potential", metrics.potential);
  see("booked", metrics.booked.total());
  see("energy_error", metrics.energy_error);
  see("energy_share", metrics.energy_error_share);
  see("overlap", metrics.deepest_overlap);
  see("chatter", metrics.chatter.amplitude);
  see("shaking", metrics.chatter.acceleration);
  see("fastest", metrics.fastest);
  see("asleep", metrics.asleep);
  see("events", report.events);
  see("contacts", report.contacts);
  see("iterations", report.iterations);
  see("pivots", report.pivots);
  see("impulses", report.impulses);
  see("pair_tests", report.pair_tests);
  see("rewinds", report.rewinds);
  see("fallbacks", report.fallbacks);
}

// The two bodies of a record, by index; nothing if one was taken away since.
template <class Record>
std::optional<IndexPair> bodies_of(const World& world, const Record& record) {
  const auto first = world.find(record.first);
  const auto second = world.find(record.second);
  if (!first || !second) return std::nullopt;
  return IndexPair{*first, *second};
}

// Pairs of bodies that push each other, from the contact points of the last step.
std::vector<PushedPair> pushed_pairs(const World& world, std::span<const ContactRecord> records) {
  std::vector<PushedPair> pairs;
  double sum = 0.0;  // of the normal pushes of the pair that is being added up
  for (const ContactRecord& record : records) {
    const auto pair = bodies_of(world, record);
    const double push = record.push_w.dot(record.normal_w);
    if (!pair || !(push > 0.0)) continue;
    const auto [first, second] = *pair;
    if (pairs.empty() || pairs.back().first != first || pairs.back().second != second) {
      pairs.push_back({first, second, Vec3::Zero(), record.normal_w, PushedState::unknown});
      sum = 0.0;
    }
    // The mean so far, moved towards the new point by its share.
    sum += push;
    pairs.back().point_w += (push / sum) * (record.point_w - pairs.back().point_w);
  }
  return pairs;
}

}  // namespace

void Session::EventList::on_event(const Event& event) {
  if (log.size() < kMostEvents) log.push_back(event);
}

Session::Session(std::string_view request) : Session(make_setup(request)) {}

Session::Session(Setup setup) : run_(std::move(setup.scene), std::move(setup.technique)) {
  run_.observe(meter_);
  run_.observe(events_);
}

StepStatus Session::step(double dt) {
  run_.update_boxes();  // so that a box that enters now has a pose before the step
  const World& world = run_.world();
  ids_before_.assign(world.ids().begin(), world.ids().end());
  states_before_.assign(world.states().begin(), world.states().end());
  report_ = run_.step(dt);
  return report_.status;
}

void Session::throw_in(SceneBox box) {
  require::that(thrown_ < kMostThrown,
                std::to_string(kMostThrown) + " boxes have been thrown: reset before the next one");
  // A scene that was saved has what was thrown in it.
  const std::vector<SceneBox>& boxes = run_.scene().boxes;
  int number = thrown_;
  do {
    box.name = "thrown" + std::to_string(++number);
  } while (std::any_of(boxes.begin(), boxes.end(),
                       [&](const SceneBox& other) { return other.name == box.name; }));
  run_.throw_in(std::move(box));
  ++thrown_;
}

void Session::take_away(BodyId id) {
  const auto index = run_.world().find(id);
  require::that(index.has_value(), "there is no such box to take away");
  run_.take_away(run_.world().name(*index));
}

void Session::look(unsigned wanted) {
  look_at_bodies(wanted);
  contacts_.clear();
  if ((wanted & kLookContacts) != 0) look_at_contacts();
  events_.log.clear();
  numbers_.clear();
  each_number(run_.world(), report_, meter_.metrics(), [&](std::string_view, auto value) {
    numbers_.push_back(static_cast<double>(value));
  });
}

const std::vector<std::string_view>& Session::number_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> out;
    each_number(World(), StepReport(), Metrics(),
                [&](std::string_view name, auto) { out.push_back(name); });
    return out;
  }();
  return names;
}

void Session::look_at_bodies(unsigned wanted) {
  const World& world = run_.world();
  const auto n = idx(world.count());
  stable_.assign(n, 0);
  island_of_.assign(n, Islands::kNone);
  pivots_w_.assign(n, Vec3::Constant(kNone));
  if ((wanted & (kLookStable | kLookBalanced)) != 0) find_stable((wanted & kLookBalanced) != 0);
  if ((wanted & kLookIslands) != 0) find_islands();
  if ((wanted & kLookPivots) != 0) find_pivots();
  if ((wanted & kLookOverlap) != 0) overlap_.look(world);

  bodies_.clear();
  for (std::size_t i = 0; i < n; ++i) {
    const BodyProperties& body = world.bodies()[i];
    if (body.shape != Shape::box) continue;
    const BodyId id = world.ids()[i];
    bodies_.push_back(static_cast<double>(number_of(id)));
    append(world.states()[i], bodies_);
    append(body.size, bodies_);
    // A body that was not there before the step has entered since.
    const auto before = std::lower_bound(ids_before_.begin(), ids_before_.end(), id);
    const bool was = before != ids_before_.end() && *before == id;
    const auto place = static_cast<std::size_t>(before - ids_before_.begin());
    append(was ? states_before_[place] : world.states()[i], bodies_);
    const bool thrown = world.name(static_cast<int>(i)).starts_with("thrown");
    const unsigned kind = (body.movable() ? 0U : kFixed) |
                          (world.sleep_states()[i].asleep ? kAsleep : 0U) |
                          (stable_[i] != 0 ? kStable : 0U) | (thrown ? kThrown : 0U);
    bodies_.push_back(kind);
    bodies_.push_back(island_of_[i]);
    bodies_.push_back((wanted & kLookOverlap) != 0 ? overlap_.depths()[i] : 0.0);
    append(pivots_w_[i], bodies_);
  }
}

void Session::look_at_contacts() {
  const World& world = run_.world();
  const auto add = [&](const auto& record, const Vec3& push_w, bool is_impulse, double state) {
    const auto pair = bodies_of(world, record);
    if (!pair) return;
    contacts_.insert(contacts_.end(), {record.time, static_cast<double>(pair->first),
                                       static_cast<double>(pair->second)});
    append(record.point_w, contacts_);
    append(record.normal_w, contacts_);
    append(push_w, contacts_);
    contacts_.insert(contacts_.end(), {is_impulse ? 1.0 : 0.0, state});
  };
  for (const ContactRecord& c : run_.technique().contacts())
    add(c, c.push_w, c.is_impulse, static_cast<double>(c.state));
  for (const Event& e : events_.log) add(e, e.impulse_w, true, 3.0);
}

void Session::find_stable(bool balanced) {
  const World& world = run_.world();
  std::vector<MovingBody> moving;
  load_moving_bodies(world, moving);
  ContactList contacts;
  gather_near(world, moving, contacts);
  StableBoxes boxes(balanced ? StableRule::equilibrium : StableRule::hull);
  const std::span<const char> found = boxes.find(world, moving, contacts);
  stable_.assign(found.begin(), found.end());
}

void Session::find_islands() {
  const World& world = run_.world();
  std::vector<IndexPair> pairs;
  for (const ContactRecord& record : run_.technique().contacts())
    if (const auto pair = bodies_of(world, record)) pairs.push_back(*pair);
  Islands islands;
  islands.build_from_pairs(world.bodies(), pairs);
  for (int b = 0; b < world.count(); ++b) island_of_[idx(b)] = islands.island_of(b);
}

void Session::find_pivots() {
  const World& world = run_.world();
  std::vector<MovingBody> moving;
  load_moving_bodies(world, moving);
  PivotUpdate carried;
  carried.find(world.bodies(), moving, pushed_pairs(world, run_.technique().contacts()));
  for (const int b : carried.bodies())
    if (const auto arm_w = carried.arm_w(b))
      pivots_w_[idx(b)] = world.states()[idx(b)].position_w - *arm_w;
}

}  // namespace tumble::live
