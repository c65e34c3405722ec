/// \file
/// \brief A look at a session of the live page, with names instead of places in a row of numbers.
#pragma once

#include "session.hpp"
#include "support/catch.hpp"

namespace tumble::live {

// [s] Steps of the tests; sums of it are not rounded.
inline constexpr double kDt = 1.0 / 64.0;
// All bits of Look.
inline constexpr unsigned kEverything = 63U;

// Two on a fixed table, and one that comes in later.
inline const std::string kTable = R"(toml
[ground]
[[box]]
name = "table"
size = [4, 1, 4]
fixed = true
position = [0, 0.5, 0]
[[box]]
name = "lower"
size = [1, 1, 1]
mass = 1
position = [0, 1.5, 0]
[[box]]
name = "upper"
size = [1, 1, 1]
mass = 1
position = [0.25, 2.5, 0]
[[box]]
name = "late"
size = [1, 1, 1]
mass = 1
position = [9, 5, 0]
velocity = [1, 0, 0]
angular_velocity = [0, 1, 0]
appears = 0.0625
)";

// One body of a look.
struct SeenBody {
  std::uint32_t id = 0;  // of the world
  Vec3 position_w;       // [m] now
  Quat orientation_wb;   // [-] now
  Vec3 size;             // [m]
  Vec3 before_w;         // [m] before the last step
  Quat before_wb;        // [-] ditto
  unsigned kind = 0;     // bits of Kind
  int island = 0;        // -1: none
  double overlap = 0.0;  // [m]
  Vec3 pivot_w;          // [m] NaN: none
};

// One contact point or collision of a look.
struct SeenContact {
  double time = 0.0;        // [s]
  int first = 0;            // index of a body
  int second = 0;           // index of another one
  Vec3 point_w;             // [m]
  Vec3 normal_w;            // [-]
  Vec3 push_w;              // [N s] or [N]
  bool is_impulse = false;  // [N s]
  int state = 0;            // ContactState, or 3: a collision
};

// Reads three numbers.
inline Vec3 vector_at(const double* at) { return {at[0], at[1], at[2]}; }

// Reads four numbers, x y z w.
inline Quat turn_at(const double* at) { return {at[3], at[0], at[1], at[2]}; }

// The bodies of a session's last look.
inline std::vector<SeenBody> bodies_of(const Session& session) {
  const std::vector<double>& all = session.bodies();
  REQUIRE(all.size() % kBodyNumbers == 0);
  std::vector<SeenBody> bodies;
  for (std::size_t k = 0; k < all.size(); k += kBodyNumbers) {
    const double* at = all.data() + k;
    bodies.push_back({static_cast<std::uint32_t>(at[0]), vector_at(at + 1), turn_at(at + 4),
                      vector_at(at + 8), vector_at(at + 11), turn_at(at + 14),
                      static_cast<unsigned>(at[18]), static_cast<int>(at[19]), at[20],
                      vector_at(at + 21)});
  }
  return bodies;
}

// The contact points and collisions of a session's last look.
inline std::vector<SeenContact> contacts_of(const Session& session) {
  const std::vector<double>& all = session.contacts();
  REQUIRE(all.size() % kContactNumbers == 0);
  std::vector<SeenContact> contacts;
  for (std::size_t k = 0; k < all.size(); k += kContactNumbers) {
    const double* at = all.data() + k;
    contacts.push_back({at[0], static_cast<int>(at[1]), static_cast<int>(at[2]), vector_at(at + 3),
                        vector_at(at + 6), vector_at(at + 9), at[12] == 1.0,
                        static_cast<int>(at[13])});
  }
  return contacts;
}

// A number of a session's last look.
inline double number(const Session& session, std::string_view name) {
  const auto& names = Session::number_names();
  const auto place = std::ranges::find(names, name);
  REQUIRE(place != names.end());
  return session.numbers().at(static_cast<std::size_t>(place - names.begin()));
}

// Does steps that have to end well.
inline void step(Session& session, int count) {
  for (int k = 0; k < count; ++k) REQUIRE(session.step(kDt) < StepStatus::unsolved);
}

// A cube of 1 m and 1 kg to throw.
// velocity_w: [m/s] of it
inline SceneBox cube(const Vec3& position_w, const Vec3& velocity_w = Vec3::Zero()) {
  return SceneBox{.name = "", .position_w = position_w, .velocity_w = velocity_w};
}

// The id of a body that is there.
inline BodyId id_of(const Session& session, std::string_view name) {
  return session.run().world().find(name).value();
}

}  // namespace tumble::live
