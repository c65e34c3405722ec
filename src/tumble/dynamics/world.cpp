/// \file
/// \brief All bodies of a simulation, as a value.
#include "tumble/dynamics/world.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/base/suggestion.hpp"
#include "tumble/dynamics/tolerances.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace tumble {
void require_gravity(const Vec3& gravity_w) {
  require::finite(gravity_w, "gravity");
  if (gravity_w.cwiseAbs().maxCoeff() > tolerance::largest_speed ||
      gravity_w.norm() > tolerance::largest_speed)
    refuse_value("gravity", vector_text(gravity_w),
                 "at most " + shortest_text(tolerance::largest_speed) +
                     " m/s², which leads to the speed of light in a second: make it weaker");
}

BodyId World::append(const BodyProperties& body, const BodyState& state, std::string name) {
  if (find(std::string_view(name))) refuse("the name \"" + name + "\" is taken");
  masses_.add(body, name);
  const BodyId id{next_id_};
  ids_.push_back(id);
  bodies_.push_back(body);
  states_.push_back(state);
  sleep_states_.emplace_back();
  names_.push_back(std::move(name));
  if (2 * names_.size() > places_.size()) {
    places_.resize(std::max<std::size_t>(16, 2 * places_.size()));
    fill_places();
  } else {
    places_[place_of(names_.back())] = static_cast<std::int32_t>(names_.size()) - 1;
  }
  ++next_id_;
  return id;
}

// Where a name is in the hash table, or the empty place where it would be.
std::size_t World::place_of(std::string_view name) const {
  std::uint64_t hash = 0xcbf29ce484222325U;  // FNV-1a
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  std::size_t place = (hash ^ (hash >> 32U)) & (places_.size() - 1);
  while (places_[place] >= 0 && names_[static_cast<std::size_t>(places_[place])] != name)
    place = (place + 1) & (places_.size() - 1);
  return place;
}

void World::fill_places() {
  std::fill(places_.begin(), places_.end(), -1);
  for (std::size_t i = 0; i < names_.size(); ++i)
    places_[place_of(names_[i])] = static_cast<std::int32_t>(i);
}

BodyId World::add_ground(double friction, double restitution) {
  const BodyProperties ground = ground_properties(friction, restitution);
  for (const BodyProperties& body : bodies_)
    require::that(body.shape != Shape::ground, "there is a ground already: expected one at most");
  return append(ground, BodyState{}, "ground");
}

BodyId World::add(const BodyProperties& body, const BodyState& state, std::string name) {
  std::uint32_t number = boxes_added_ + 1;
  if (name.empty()) {
    // The number of this box, counted from 1, unless another body is called so.
    while (find(std::string_view("box" + std::to_string(number)))) ++number;
    name = "box" + std::to_string(number);
  }
  require_valid(body);
  require_valid(body, state, name);
  const BodyId id = append(body, state, std::move(name));
  ++boxes_added_;
  return id;
}

void World::remove(BodyId id) {
  const std::ptrdiff_t i = index_of(id);
  const auto has_it = [&](const std::array<BodyId, 2>& pair) {
    return pair[0] == id || pair[1] == id;
  };
  std::erase_if(joints_, [&](const BodyJoint& joint) { return has_it(joint.bodies); });
  std::erase_if(joined_, has_it);
  ids_.erase(ids_.begin() + i);
  bodies_.erase(bodies_.begin() + i);
  states_.erase(states_.begin() + i);
  sleep_states_.erase(sleep_states_.begin() + i);
  names_.erase(names_.begin() + i);
  fill_places();
  masses_ = {};
  for (std::size_t k = 0; k < names_.size(); ++k) masses_.add(bodies_[k], names_[k]);
}

int World::index_of_movable(BodyId id) const {
  const int i = index_of(id);
  if (!bodies()[static_cast<std::size_t>(i)].movable())
    refuse("body \"" + name(i) + "\" is immovable: expected a movable one");
  return i;
}

void World::push(BodyId id, const Vec3& impulse_w, const Vec3& point_w) {
  require::finite(impulse_w, "impulse_w");
  require::finite(point_w, "point_w");
  const auto i = static_cast<std::size_t>(index_of_movable(id));
  // ΔP = j and ΔL = r × j, with the arm r from the centre of mass.
  BodyState state = states_[i];
  state.linear_momentum_w += impulse_w;
  state.angular_momentum_w += (point_w - state.position_w).cross(impulse_w);
  set_state(id, state);
}

void World::set_velocity(BodyId id, const Vec3& velocity_w, const Vec3& angular_velocity_w) {
  const auto i = static_cast<std::size_t>(index_of_movable(id));
  const BodyState& old = states_[i];
  set_state(id, make_state(bodies_[i], old.position_w, old.orientation_wb, velocity_w,
                           angular_velocity_w));
}

void World::set_state(BodyId id, const BodyState& state) {
  const auto i = static_cast<std::size_t>(index_of(id));
  require::that(bodies_[i].shape != Shape::ground, "the ground cannot be moved: it is y <= 0");
  require_valid(bodies_[i], state, names_[i]);
  states_[i] = state;
  sleep_states_[i] = SleepState{};
}

std::optional<int> World::find(BodyId id) const {
  const auto place = std::lower_bound(ids_.begin(), ids_.end(), id);
  if (place == ids_.end() || *place != id) return std::nullopt;
  return static_cast<int>(place - ids_.begin());
}

int World::index_of(BodyId id) const {
  const std::optional<int> index = find(id);
  if (!index)  // the message is made only when it is needed: this is called often
    refuse("there is no body with id " + std::to_string(number_of(id)) + " in this world");
  return *index;
}

std::optional<BodyId> World::find(std::string_view name) const {
  if (places_.empty()) return std::nullopt;
  const std::int32_t index = places_[place_of(name)];
  if (index < 0) return std::nullopt;
  return ids_[static_cast<std::size_t>(index)];
}

int World::index_of(std::string_view name) const {
  const std::int32_t index = places_.empty() ? -1 : places_[place_of(name)];
  if (index < 0) {
    const std::vector<std::string_view> known(names_.begin(), names_.end());
    const std::string_view close = closest_name(name, known);
    std::string message = "there is no body called " + std::string(name);
    if (!close.empty()) message.append(": did you mean ").append(close).append("?");
    refuse(message);
  }
  return index;
}

BodyView World::body(std::string_view name) const { return {*this, index_of(name)}; }

BodyView World::body(BodyId id) const { return {*this, index_of(id)}; }

StateHash World::hash() const {
  StateHash hash;
  hash.add(gravity_w);
  hash.add(time_);
  hash.add(static_cast<std::uint64_t>(steps_));
  hash.add(std::uint64_t{next_id_});
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    hash.add(std::uint64_t{number_of(ids_[i])});
    hash.add(states_[i].position_w);
    hash.add(states_[i].orientation_wb);
    hash.add(states_[i].linear_momentum_w);
    hash.add(states_[i].angular_momentum_w);
    hash.add(sleep_states_[i].quiet_time);
    hash.add(std::uint64_t{sleep_states_[i].asleep ? 1U : 0U});
  }
  return hash;
}

bool all_finite(const World& world) {
  return std::all_of(world.states().begin(), world.states().end(), is_finite);
}

}  // namespace tumble
