/// \file
/// \brief The errata of SETGEOMETRICALLYSTABLE (thesis 5.4, A.2; G2 to G8).
#include "tumble/geometric_stability/as_printed/set_geometrically_stable_as_printed.hpp"

#include "impulse_damped/errata_setup.hpp"

namespace tumble::chapters {
namespace {

constexpr PrintedStabilityRepairs kMended{.both_bodies = true,
                                          .vetoes_last = true,
                                          .immovable = true,
                                          .fresh_corners = true,
                                          .rising = true,
                                          .tolerances = true};

// A scene, its contacts, and what is remembered of the step before.
struct StabilityScene {
  World world;
  ContactList contacts;
  std::vector<PrintedStability> bodies;
};

void add_turned_box(World& world, const Vec3& size, const Vec3& place_w,
                    const Quat& orientation = Quat::Identity()) {
  world.add(box_properties(size, 1.0), place_w, orientation);
}

void find_contacts(StabilityScene& scene) {
  constexpr double margin = 1e-9;  // [m]
  scene.contacts = contacts_within(scene.world, margin);
  scene.bodies.resize(scene.world.states().size());
}

// The scene after one run of the listing.
StabilityScene classified(StabilityScene scene, const PrintedStabilityRepairs& repairs) {
  set_geometrically_stable_as_printed(scene.world, scene.contacts, repairs, scene.bodies);
  return scene;
}

// How many movable bodies are called stable.
double stable_count(const StabilityScene& scene) {
  double count = 0.0;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k)
    if (scene.world.bodies()[k].movable() && scene.bodies[k].stable) count += 1.0;
  return count;
}

void draw(double number, const StabilityScene& printed, const StabilityScene& mended,
          Table& table) {
  for (std::size_t k = 0; k < printed.bodies.size(); ++k) {
    const BodyProperties& body = printed.world.bodies()[k];
    if (body.shape == Shape::ground) continue;
    const Vec3& place_w = printed.world.states()[k].position_w;
    table.add(number, place_w.x(), place_w.y(), body.size.x(), body.size.y(), !body.movable(),
              printed.bodies[k].stable, mended.bodies[k].stable);
  }
}

// A scene after the listing, and a word for its number.
struct Outcome {
  std::string words;
  StabilityScene scene;
};

// Adds the two numbers and the boxes of one erratum.
void compare(int number, const std::string& what, const Outcome& printed, const Outcome& mended,
             Result& result) {
  const std::string name = 'G' + std::to_string(number) + ": " + what + ", ";
  result.add(name + printed.words, "-", stable_count(printed.scene));
  result.add(name + mended.words, "-", stable_count(mended.scene));
  draw(number, printed.scene, mended.scene, result.tables[0]);
}

// The same for a scene, without one repair of the listing and with all.
void compare(int number, const std::string& what, const StabilityScene& scene,
             bool PrintedStabilityRepairs::*repair, const std::string& printed,
             const std::string& cured, Result& result) {
  PrintedStabilityRepairs without = kMended;
  without.*repair = false;
  compare(number, what, {printed, classified(scene, without)}, {cured, classified(scene, kMended)},
          result);
}

// G2. Two cubes stand side by side and touch.
StabilityScene side_by_side() {
  StabilityScene scene;
  scene.world.add_ground();
  add_turned_box(scene.world, Vec3::Ones(), Vec3(-0.5, 0.5, 0.0));
  add_turned_box(scene.world, Vec3::Ones(), Vec3(0.5, 0.5, 0.0));
  find_contacts(scene);
  return scene;
}

// G3, G6. A plank on two fixed blocks and, as high as these, a block that balances on a post.
StabilityScene plank_on_three() {
  StabilityScene scene;
  add_fixed_box(scene.world, Vec3::Ones(), Vec3(-2.0, 0.5, 0.0));
  add_fixed_box(scene.world, Vec3::Ones(), Vec3(2.0, 0.5, 0.0));
  add_fixed_box(scene.world, Vec3(0.25, 0.5, 0.25), Vec3(0.0, 0.25, 0.0));
  add_turned_box(scene.world, Vec3(1.0, 0.5, 1.0), Vec3(0.0, 0.75, 0.0));
  add_turned_box(scene.world, Vec3(5.0, 0.25, 1.0), Vec3(0.0, 1.125, 0.0));
  find_contacts(scene);
  return scene;
}

// The contact of the plank with the block that is not stable comes first, last, or not at all.
enum class Place { first, last, left_out };
StabilityScene with_unstable(StabilityScene scene, Place place) {
  const auto of_both = [](const Contact& c) { return c.first == 3 && c.second == 4; };
  const auto other = std::stable_partition(scene.contacts.begin(), scene.contacts.end(), of_both);
  if (place == Place::last) std::rotate(scene.contacts.begin(), other, scene.contacts.end());
  if (place == Place::left_out) scene.contacts.erase(scene.contacts.begin(), other);
  return scene;
}

// G4. A cube on a fixed wall, and one beside it.
StabilityScene beside_wall() {
  StabilityScene scene;
  add_fixed_box(scene.world, Vec3(1.0, 2.0, 1.0), Vec3(0.0, 1.0, 0.0));
  add_turned_box(scene.world, Vec3::Ones(), Vec3(1.0, 0.5, 0.0));
  add_turned_box(scene.world, Vec3::Ones(), Vec3(0.0, 2.5, 0.0));
  find_contacts(scene);
  return scene;
}

// G5. A cube that stood on a fixed block in the step before, and has slid off by a half.
StabilityScene half_off() {
  StabilityScene scene;
  add_fixed_box(scene.world, Vec3(2.0, 1.0, 2.0), Vec3(0.0, 0.5, 0.0));
  add_turned_box(scene.world, Vec3::Ones(), Vec3(0.0, 1.5, 0.0));
  find_contacts(scene);
  scene = classified(scene, kMended);
  scene.world.states()[1].position_w.x() = 1.0;
  find_contacts(scene);
  return scene;
}

// G7. A cube that is about to leave the ground.
StabilityScene rising() {
  StabilityScene scene;
  scene.world.add_ground();
  scene.world.add(unit_cube(), Vec3(0.0, 0.5, 0.0), Quat::Identity(), Vec3(0.0, 1.0, 0.0));
  find_contacts(scene);
  return scene;
}

// G8. A cube on a fixed block, both turned by a millionth.
StabilityScene almost_level() {
  const Quat lean = turned_about_z(1e-6);
  StabilityScene scene;
  add_fixed_box(scene.world, Vec3(2.0, 1.0, 2.0), Vec3(0.0, 0.5, 0.0), lean);
  add_turned_box(scene.world, Vec3::Ones(), Vec3(0.0, 0.5, 0.0) + lean * Vec3::UnitY(), lean);
  find_contacts(scene);
  return scene;
}

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

  using Repairs = PrintedStabilityRepairs;
  compare(2, "cubes side by side called stable", side_by_side(), &Repairs::both_bodies,
          "upper one cleared", "both cleared", result);
  const std::string plank = "plank with an unstable support called stable";
  const StabilityScene first = with_unstable(plank_on_three(), Place::first);
  const StabilityScene last = with_unstable(plank_on_three(), Place::last);
  compare(3, plank, first, &Repairs::vetoes_last, "its contact is listed first",
          "vetoes count, its contact is listed first", result);
  Repairs without = kMended;
  without.vetoes_last = false;
  result.add("G3: " + plank + ", its contact is listed last", "-",
             stable_count(classified(last, without)));
  result.add("G3: " + plank + ", vetoes count, its contact is listed last", "-",
             stable_count(classified(last, kMended)));
  compare(4, "cube on a fixed wall called stable", beside_wall(), &Repairs::immovable,
          "the wall can lose its flag", "the wall cannot", result);
  compare(5, "cube half off its support called stable", half_off(), &Repairs::fresh_corners,
          "marks of the step before", "marks of this step", result);
  const StabilityScene text = with_unstable(plank_on_three(), Place::left_out);
  compare(6, plank, {"four corners held, as the text asks", classified(text, kMended)},
          {"all supports stable, as the footnote asks", classified(first, kMended)}, result);
  compare(7, "cube that rises at 1 m/s called stable", rising(), &Repairs::rising,
          "speed not looked at", "speed looked at", result);
  compare(8, "cube on a block that leans by 1e-6 rad called stable", almost_level(),
          &Repairs::tolerances, "no tolerance", "with tolerances", result);
  return result;
}

const Registered errata_stability_figure{
    {.name = "errata_stability", .experiment = measure_stability_errata}};

}  // namespace
}  // namespace tumble::chapters
