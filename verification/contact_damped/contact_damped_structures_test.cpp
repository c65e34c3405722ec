/// \file
/// \brief Structures stand: with contact_damped, friction 0.5, no restitution, 60 steps a second
///        and no body asleep.
#include "contact_damped/helpers.hpp"
#include "support/pose.hpp"
#include "support/test.hpp"

namespace {

// [s] A structure may settle for so long, as its boxes come from places that are not exact.
constexpr double kSettling = 2.0;
// [m] After that no box may move farther: invisible on boxes of a metre.
constexpr double kMovement = 1e-3;
// [-] Overlap that stays, over the size of a box, for each level.
constexpr double kSlop = 1e-5;
// [m g L] Energy that appears or goes without being booked, over the weight of a box times its
// edge.
constexpr double kEnergy = 1e-3;

struct Structure {
  const char* scene;
  Settings settings;
  int levels;
  double edge;  // [m] height of a level
};

const Settings kScatter = {{"scatter", "0.001"}, {"scatter_angle", "0.2"}};

Settings joined(Settings a, const Settings& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// How far the lowest box, seen from its exact place, has sunk.
double sag(const World& world, const World& exact) {
  double worst = 0.0;
  for (std::size_t k = 0; k < world.states().size(); ++k)
    worst = std::max(worst, exact.states()[k].position_w.y() - world.states()[k].position_w.y());
  return worst;
}

// [J] m g L of the heaviest box.
double energy_scale(const World& world, double edge) {
  double mass = 0.0;
  for (const BodyProperties& body : world.bodies())
    if (body.movable()) mass = std::max(mass, body.mass);
  return mass * kGravity * edge;
}

void check_standing(const Structure& structure, const Settings& scatter, std::uint64_t seed,
                    double seconds) {
  const World exact = world_of(structure.scene, structure.settings);
  World world = world_of(structure.scene, joined(structure.settings, scatter), seed);
  const double edge_energy = energy_scale(world, structure.edge);
  const std::unique_ptr<Technique> technique = contact_damped();
  const Course settling = run(world, *technique, kSettling);
  const Course rest = run(world, *technique, seconds - kSettling);
  std::string label = structure.scene;
  for (const auto& [key, value] : structure.settings) label += " " + key + "=" + value;
  INFO(label << ", seed " << (scatter.empty() ? 0 : seed));
  CHECK(settling.failed + rest.failed == 0);
  CHECK(rest.moved <= kMovement);
  CHECK(sag(world, exact) <= structure.levels * kSlop * structure.edge);
  CHECK(rest.unbooked <= kEnergy * edge_energy);
  // From exact places nothing falls, so energy is booked from the start.
  if (scatter.empty()) CHECK(settling.unbooked <= kEnergy * edge_energy);
  if (scatter.empty()) CHECK(settling.moved <= kMovement);
}

std::vector<Structure> stacks(const std::vector<int>& counts) {
  std::vector<Structure> all;
  for (const int count : counts)
    all.push_back({"stack", {{"count", std::to_string(count)}}, count, 1.0});
  return all;
}

const std::vector<Structure> kSmall = {
    {"pyramid", {{"rows", "6"}}, 6, 1.0},
    {"pyramid3d", {{"rows", "3"}}, 3, 1.0},
    {"wall", {{"courses", "6"}, {"bricks", "4"}}, 6, 0.5},
};

const std::vector<Structure> kLarge = {
    {"pyramid", {{"rows", "20"}}, 20, 1.0},
    {"pyramid3d", {{"rows", "8"}}, 8, 1.0},
    {"wall", {}, 20, 0.5},
};

std::vector<int> one_to(int last) {
  std::vector<int> all;
  for (int k = 1; k <= last; ++k) all.push_back(k);
  return all;
}

std::vector<Structure> heavy_tops() {
  std::vector<Structure> all;
  for (const char* count : {"2", "10"})
    for (const char* mass : {"10", "100", "1000"})
      all.push_back({"stack", {{"count", count}, {"top_mass", mass}}, std::stoi(count), 1.0});
  return all;
}

}  // namespace

TEST_CASE("Stacks stand for four seconds, from exact and from scattered places",
          "[unit][contact_damped]") {
  BOTH_POSES;
  for (const Structure& stack : stacks({1, 2, 3, 5, 10, 20})) {
    check_standing(stack, {}, 1, 4.0);
    check_standing(stack, kScatter, 1, 4.0);
  }
}

TEST_CASE("Small pyramids and walls stand for four seconds, from exact and from scattered places",
          "[unit][contact_damped]") {
  BOTH_POSES;
  for (const Structure& structure : kSmall) {
    check_standing(structure, {}, 1, 4.0);
    check_standing(structure, kScatter, 1, 4.0);
  }
}

TEST_CASE("A stack carries a top box of a thousand times the mass of the others for four seconds",
          "[unit][contact_damped]") {
  BOTH_POSES;
  for (const Structure& stack : heavy_tops()) {
    check_standing(stack, {}, 1, 4.0);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) check_standing(stack, kScatter, seed, 4.0);
  }
}

TEST_CASE("Stacks of one to twenty boxes stand for a minute", "[.long][unit][contact_damped]") {
  BOTH_POSES;
  for (const Structure& stack : stacks(one_to(20))) {
    check_standing(stack, {}, 1, 60.0);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) check_standing(stack, kScatter, seed, 60.0);
  }
}

TEST_CASE("Pyramids and the wall stand for a minute", "[.long][unit][contact_damped]") {
  BOTH_POSES;
  for (const Structure& structure : kLarge) {
    check_standing(structure, {}, 1, 60.0);
    if (std::string_view(structure.scene) != "wall") check_standing(structure, kScatter, 1, 60.0);
  }
}

// The unbooked energy is half of the weight times the step times the mean velocity: 0 if nothing moves.
TEST_CASE("The scattered wall stands for a minute and its energy is booked",
          "[.long][unit][contact_damped]") {
  BOTH_POSES;
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    check_standing(kLarge.back(), kScatter, seed, 60.0);
}

TEST_CASE("A stack carries a top box of a thousand times the mass of the others for a minute",
          "[.long][unit][contact_damped]") {
  BOTH_POSES;
  for (const Structure& stack : heavy_tops()) {
    check_standing(stack, {}, 1, 60.0);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) check_standing(stack, kScatter, seed, 60.0);
  }
}
