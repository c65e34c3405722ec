/// \file
/// \brief The errata of SETGEOMETRICALLYSTABLE (thesis 5.4, A.2; G2 to G8).
#include "tumble/contact/gather.hpp"
#include "tumble/geometric_stability/as_printed/set_geometrically_stable_as_printed.hpp"

#include "impulse_damped/errata_damping_experiments.hpp"
#include "impulse_damped/errata_damping_setup.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace tumble::chapters {
namespace {

using errata_setup::unit_cube;

constexpr PrintedStabilityRepairs kMended{.both_bodies = true,
                                          .vetoes_last = true,
                                          .immovable = true,
                                          .fresh_corners = true,
                                          .rising = true,
                                          .tolerances = true};

// A scene, its contacts, and what is remembered of the step before.
struct Scene {
  World world;
  ContactList contacts;
  std::vector<PrintedStability> bodies;
};

void add_turned_fixed(World& world, const Vec3& size, const Vec3& place_w,
                      const Quat& orientation = Quat::Identity()) {
  const BodyProperties body = fixed_box_properties(size);
  world.add(body, make_state(body, place_w, orientation));
}

void add_turned_box(World& world, const Vec3& size, const Vec3& place_w,
                    const Quat& orientation = Quat::Identity()) {
  const BodyProperties body = box_properties(size, 1.0);
  world.add(body, make_state(body, place_w, orientation));
}

void find_contacts(Scene& scene) {
  std::vector<IndexPair> pairs;
  for (int i = 0; i < scene.world.count(); ++i)
    for (int j = i + 1; j < scene.world.count(); ++j) pairs.push_back({i, j});
  std::vector<MovingBody> moving;
  load_moving_bodies(scene.world, moving);
  constexpr double margin = 1e-9;  // [m]
  gather_contacts(scene.world, moving, pairs, margin, {}, scene.contacts);
  scene.bodies.resize(scene.world.states().size());
}

// The scene after one run of the listing.
Scene classified(Scene scene, const PrintedStabilityRepairs& repairs) {
  set_geometrically_stable_as_printed(scene.world, scene.contacts, repairs, scene.bodies);
  return scene;
}

// How many movable bodies are called stable.
double stable_count(const Scene& scene) {
  double count = 0.0;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k)
    if (scene.world.bodies()[k].movable() && scene.bodies[k].stable) count += 1.0;
  return count;
}

void draw(double number, const Scene& printed, const Scene& mended, Table& table) {
  for (std::size_t k = 0; k < printed.bodies.size(); ++k) {
    const BodyProperties& body = printed.world.bodies()[k];
    if (body.shape == Shape::ground) continue;
    const Vec3& place_w = printed.world.states()[k].position_w;
    table.rows.push_back({number, place_w.x(), place_w.y(), body.size.x(), body.size.y(),
                          body.movable() ? 0.0 : 1.0, printed.bodies[k].stable ? 1.0 : 0.0,
                          mended.bodies[k].stable ? 1.0 : 0.0});
  }
}

// Adds the two numbers and the boxes of one erratum.
void compare(int number, const std::string& what, const Scene& printed, const std::string& how,
             const Scene& mended, const std::string& cure, Result& result) {
  const std::string name = 'G' + std::to_string(number) + ": " + what + ", ";
  result.quantities.push_back({name + how, "-", stable_count(printed)});
  result.quantities.push_back({name + cure, "-", stable_count(mended)});
  draw(number, printed, mended, result.tables[0]);
}

// G2. Two cubes stand side by side and touch.
Scene side_by_side() {
  Scene scene;
  scene.world.add_ground();
  add_turned_box(scene.world, Vec3::Ones(), Vec3(-0.5, 0.5, 0.0));
  add_turned_box(scene.world, Vec3::Ones(), Vec3(0.5, 0.5, 0.0));
  find_contacts(scene);
  return scene;
}

// G3, G6. A plank on two fixed blocks and, as high as these, a block that balances on a post.
Scene plank_on_three() {
  Scene scene;
  add_turned_fixed(scene.world, Vec3::Ones(), Vec3(-2.0, 0.5, 0.0));
  add_turned_fixed(scene.world, Vec3::Ones(), Vec3(2.0, 0.5, 0.0));
  add_turned_fixed(scene.world, Vec3(0.25, 0.5, 0.25), Vec3(0.0, 0.25, 0.0));
  add_turned_box(scene.world, Vec3(1.0, 0.5, 1.0), Vec3(0.0, 0.75, 0.0));
  add_turned_box(scene.world, Vec3(5.0, 0.25, 1.0), Vec3(0.0, 1.125, 0.0));
  find_contacts(scene);
  return scene;
}

// The contact of the plank with the block that is not stable comes first, last, or not at all.
enum class Place { first, last, left_out };
Scene with_unstable(Scene scene, Place place) {
  const auto of_both = [](const Contact& c) { return c.first == 3 && c.second == 4; };
  const auto other = std::stable_partition(scene.contacts.begin(), scene.contacts.end(), of_both);
  if (place == Place::last) std::rotate(scene.contacts.begin(), other, scene.contacts.end());
  if (place == Place::left_out) scene.contacts.erase(scene.contacts.begin(), other);
  return scene;
}

// G4. A cube on a fixed wall, and one beside it.
Scene beside_wall() {
  Scene scene;
  add_turned_fixed(scene.world, Vec3(1.0, 2.0, 1.0), Vec3(0.0, 1.0, 0.0));
  add_turned_box(scene.world, Vec3::Ones(), Vec3(1.0, 0.5, 0.0));
  add_turned_box(scene.world, Vec3::Ones(), Vec3(0.0, 2.5, 0.0));
  find_contacts(scene);
  return scene;
}

// G5. A cube that stood on a fixed block in the step before, and has slid off by a half.
Scene half_off() {
  Scene scene;
  add_turned_fixed(scene.world, Vec3(2.0, 1.0, 2.0), Vec3(0.0, 0.5, 0.0));
  add_turned_box(scene.world, Vec3::Ones(), Vec3(0.0, 1.5, 0.0));
  find_contacts(scene);
  scene = classified(scene, kMended);
  scene.world.states()[1].position_w.x() = 1.0;
  find_contacts(scene);
  return scene;
}

// G7. A cube that is about to leave the ground.
Scene rising() {
  Scene scene;
  scene.world.add_ground();
  scene.world.add(unit_cube(), make_state(unit_cube(), Vec3(0.0, 0.5, 0.0), Quat::Identity(),
                                          Vec3(0.0, 1.0, 0.0)));
  find_contacts(scene);
  return scene;
}

// G8. A cube on a fixed block, both turned by a millionth.
Scene almost_level() {
  constexpr double half_angle = 0.5e-6;  // [rad]
  const Quat lean(std::cos(half_angle), 0.0, 0.0, std::sin(half_angle));
  Scene scene;
  add_turned_fixed(scene.world, Vec3(2.0, 1.0, 2.0), Vec3(0.0, 0.5, 0.0), lean);
  add_turned_box(scene.world, Vec3::Ones(), Vec3(0.0, 0.5, 0.0) + lean * Vec3::UnitY(), lean);
  find_contacts(scene);
  return scene;
}

}  // namespace

Result measure_stability_errata(const Parameters&) {
  Result result;
  result.tables.push_back({"",
                           {{"scene", "-", "the number of its erratum"},
                            {"x_m", "m", "middle of a box"},
                            {"y_m", "m", "its height"},
                            {"width_m", "m", "of the box"},
                            {"height_m", "m", "of the box"},
                            {"fixed", "-", "1: it is immovable"},
                            {"printed", "-", "1: called stable as printed"},
                            {"mended", "-", "1: called stable as mended"}}});

  PrintedStabilityRepairs without = kMended;
  without.both_bodies = false;
  compare(2, "cubes side by side called stable", classified(side_by_side(), without),
          "upper one cleared", classified(side_by_side(), kMended), "both cleared", result);

  without = kMended;
  without.vetoes_last = false;
  const std::string plank = "plank with an unstable support called stable";
  const Scene first = with_unstable(plank_on_three(), Place::first);
  const Scene last = with_unstable(plank_on_three(), Place::last);
  compare(3, plank, classified(first, without), "its contact is listed first",
          classified(first, kMended), "vetoes count, its contact is listed first", result);
  result.quantities.push_back({"G3: " + plank + ", its contact is listed last", "-",
                               stable_count(classified(last, without))});
  result.quantities.push_back({"G3: " + plank + ", vetoes count, its contact is listed last", "-",
                               stable_count(classified(last, kMended))});

  without = kMended;
  without.immovable = false;
  compare(4, "cube on a fixed wall called stable", classified(beside_wall(), without),
          "the wall can lose its flag", classified(beside_wall(), kMended), "the wall cannot",
          result);

  without = kMended;
  without.fresh_corners = false;
  compare(5, "cube half off its support called stable", classified(half_off(), without),
          "marks of the step before", classified(half_off(), kMended), "marks of this step",
          result);

  const Scene text = with_unstable(plank_on_three(), Place::left_out);
  compare(6, plank, classified(text, kMended), "four corners held, as the text asks",
          classified(first, kMended), "all supports stable, as the footnote asks", result);

  without = kMended;
  without.rising = false;
  compare(7, "cube that rises at 1 m/s called stable", classified(rising(), without),
          "speed not looked at", classified(rising(), kMended), "speed looked at", result);

  without = kMended;
  without.tolerances = false;
  compare(8, "cube on a block that leans by 1e-6 rad called stable",
          classified(almost_level(), without), "no tolerance", classified(almost_level(), kMended),
          "with tolerances", result);
  return result;
}

}  // namespace tumble::chapters
