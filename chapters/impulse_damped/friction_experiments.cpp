/// \file
/// \brief Two blocks, and a stack on a sled: damped and with Coulomb's friction (thesis 5.3).
#include "impulse_damped/damped_variants.hpp"

namespace tumble::chapters {
namespace {

// Speeds of bodies after each step, the first row being the start.
struct Speeds {
  std::vector<double> time;                // [s]
  std::vector<std::vector<double>> speed;  // [m/s] along x, of each body
  std::vector<double> momentum;            // [kg m/s] along x, of all bodies
  std::vector<Vec3> end_w;                 // [m] where they end

  // [m/s] of all bodies after a step.
  [[nodiscard]] std::vector<double> at(std::size_t step) const {
    std::vector<double> all;
    for (const std::vector<double>& one : speed) all.push_back(one[step]);
    return all;
  }
  // The largest speed that a body has had.
  [[nodiscard]] double fastest(std::size_t body) const {
    return *std::ranges::max_element(speed[body]);
  }
};

Speeds speeds_of(const Scene& scene, const PlayedTechnique& technique,
                 const std::vector<std::string>& names, double duration) {
  PlayedScene played(scene, technique);
  Speeds speeds;
  speeds.speed.resize(names.size());
  const auto note = [&](const StepReport&) {
    speeds.time.push_back(played.world().time());
    double momentum = 0.0;
    for (std::size_t k = 0; k < names.size(); ++k) {
      speeds.speed[k].push_back(played.speed(names[k]));
      momentum += played.world().states()[played.index(names[k])].linear_momentum_w.x();
    }
    speeds.momentum.push_back(momentum);
  };
  note({});
  played.advance(duration, note);
  for (const std::string& name : names)
    speeds.end_w.push_back(played.world().states()[played.index(name)].position_w);
  return speeds;
}

Speeds blocks(const std::vector<std::string>& scene, const PlayedTechnique& technique,
              double duration) {
  return speeds_of(make_scene("fig5_2", scene), technique, {"A", "B"}, duration);
}

// When the upper block does not slide on the lower one any more.
std::size_t end_of_slide(const Speeds& speeds) {
  constexpr double still = 1e-6;  // [m/s] a micrometre in a second
  std::size_t k = 0;
  while (k + 1 < speeds.time.size() && speeds.speed[0][k] - speeds.speed[1][k] > still) ++k;
  return k;
}

// Largest difference between the speeds of the upper block up to an entry, over that at the start.
double largest_difference(const Speeds& damped, const Speeds& coulomb, std::size_t last) {
  double largest = 0.0;
  for (std::size_t k = 0; k <= last; ++k)
    largest = std::max(largest, std::abs(damped.speed[0][k] - coulomb.speed[0][k]));
  return largest / damped.speed[0][0];
}

// The coefficient of friction is ours too.
struct OtherFriction {
  std::string words;
  std::string setting;  // of the scene
};

std::vector<OtherFriction> other_frictions(const char* scene) {
  const double usual = scene_recipe(scene).parameters().number("friction");
  return {{"half the friction", setting("friction", 0.5 * usual)},
          {"twice the friction", setting("friction", 2.0 * usual)}};
}

Result measure_sliding_blocks(const Parameters& settings) {
  std::vector<std::string> scene;
  for (const char* key : {"speed", "mass", "lower_mass", "friction", "ground_friction"})
    scene.push_back(setting(key, settings.number(key)));
  const double duration = settings.number("duration");
  const Speeds damped = blocks(scene, {"damped"}, duration);
  const Speeds coulomb = blocks(scene, coulomb_technique(), duration);

  Table table{"",
              {{"time_s", "s", "time"},
               {"damped_a_m_s", "m/s", "speed of A, damped"},
               {"damped_b_m_s", "m/s", "speed of B, damped"},
               {"coulomb_a_m_s", "m/s", "speed of A, Coulomb's friction"},
               {"coulomb_b_m_s", "m/s", "speed of B, Coulomb's friction"},
               {"damped_momentum", "kg m/s", "of both, damped"},
               {"coulomb_momentum", "kg m/s", "of both, Coulomb's friction"}}};
  for (std::size_t k = 0; k < damped.time.size(); ++k)
    table.add(damped.time[k], damped.at(k), coulomb.at(k), damped.momentum[k], coulomb.momentum[k]);

  // Forces are what momentum changes by, as a mean over the time in which A slides on B with
  // Coulomb's friction: no technique has to be asked, and damping gives no forces by itself.
  const std::size_t slide = end_of_slide(coulomb);
  const auto force = [&](const Speeds& run, std::size_t body, const char* mass) {
    const double change = run.speed[body][slide] - run.speed[body][0];
    return settings.number(mass) * change / run.time[slide];
  };
  Table drawn{"blocks",
              {{"x_m", "m", "centre at the start"},
               {"y_m", "m", "centre at the start"},
               {"width_m", "m", "along x"},
               {"height_m", "m", "along y"},
               {"damped_N", "N", "mean force along x while A slides, damped"},
               {"coulomb_N", "N", "the same, Coulomb's friction"}}};
  const std::array<const char*, 2> masses{"mass", "lower_mass"};
  std::array<std::array<double, 2>, 2> forces{};  // of A and B: damped, Coulomb
  const Scene layout = make_scene("fig5_2", scene);
  for (std::size_t body = 0; body < 2; ++body) {
    forces[body] = {force(damped, body, masses[body]), force(coulomb, body, masses[body])};
    const auto box = std::ranges::find_if(
        layout.boxes, [&](const SceneBox& b) { return b.name == (body == 0 ? "A" : "B"); });
    drawn.add(box->position_w.x(), box->position_w.y(), box->size.x(), box->size.y(), forces[body]);
  }
  const double common = settings.number("mass") * settings.number("speed") /
                        (settings.number("mass") + settings.number("lower_mass"));
  return {{table, drawn},
          {{"speed of A at the end, Coulomb", "m/s", coulomb.speed[0].back()},
           {"common speed if momentum is kept", "m/s", common},
           {"speed of A at the end, damped", "m/s", damped.speed[0].back()},
           {"mean braking force on A until then, Coulomb", "N", -forces[0][1]},
           {"mean braking force on A until then, damped", "N", -forces[0][0]},
           {"mean force on B until then, Coulomb", "N", forces[1][1]},
           {"mean force on B until then, damped", "N", forces[1][0]},
           {"momentum at the end over that at the start, damped", "-",
            damped.momentum.back() / damped.momentum.front()}},
          {},
          [layout, duration] { return film_of_both(layout, duration); }};
}

const Registered fig5_2_friction_figure{
    {.name = "fig5_2_friction",
     .parameters = {number("speed", 2.0, 0.1, 3.0, "m/s", "of A at the start"),
                    number("mass", 1.0, 1e-3, 1e3, "kg", "of A"),
                    number("lower_mass", 2.0, 1e-3, 1e3, "kg", "of B"),
                    number("friction", 0.5, 0.01, 10.0, "-", "Coulomb's coefficient of A and B"),
                    number("ground_friction", 0.0, 0.0, 10.0, "-", "of the ground"),
                    number("duration", 1.0, 0.1, 10.0, "s", "of the run")},
     .experiment = measure_sliding_blocks}};

Result measure_friction_on_upper(const Parameters& settings) {
  const double duration = settings.number("duration");
  const std::string speed = setting("speed", settings.number("speed"));
  constexpr const char* held = "ground_friction=10";  // the lower block does not move
  const Speeds coulomb = blocks({speed}, coulomb_technique(), duration);
  const Speeds coulomb_held = blocks({speed, held}, coulomb_technique(), duration);
  const std::size_t all = coulomb.time.size() - 1;
  const std::string decides =
      "largest difference between the speeds of the upper block, damped and with Coulomb's "
      "friction, until it stops, over its speed at the start";

  Table table{"",
              {{"time_s", "s", "time"},
               {"coulomb_m_s", "m/s", "speed of A, Coulomb's friction"},
               {"held_m_s", "m/s", "the same, the lower block being held by the ground"},
               {"damped_m_s", "m/s", "speed of A, damped"},
               {"half_m_s", "m/s", "the same, half the damping"},
               {"twice_m_s", "m/s", "the same, twice the damping"}}};
  std::vector<Quantity> quantities;
  std::vector<Speeds> runs;
  for (const DampedVariant& variant : damped_variants()) {
    runs.push_back(blocks({speed}, variant.technique, duration));
    quantities.push_back({variant.words.empty() ? decides : "the same, " + variant.words, "-",
                          largest_difference(runs.back(), coulomb, all)});
  }
  for (std::size_t k = 0; k <= all; ++k)
    table.add(coulomb.time[k], coulomb.speed[0][k], coulomb_held.speed[0][k], runs[0].speed[0][k],
              runs[3].speed[0][k], runs[4].speed[0][k]);

  const std::size_t slide = end_of_slide(coulomb);
  quantities.push_back({"the same, only while it slides on the lower block with Coulomb's friction",
                        "-", largest_difference(runs[0], coulomb, slide)});

  const auto difference = [&](const std::vector<std::string>& changed) {
    return largest_difference(blocks(changed, {"damped"}, duration),
                              blocks(changed, coulomb_technique(), duration), all);
  };
  for (const OtherFriction& other : other_frictions("fig5_2"))
    quantities.push_back({"the same, " + other.words, "-", difference({speed, other.setting})});

  // The mass below is a choice, and the push that B does not get is no friction on A: a second measurement.
  double of_masses = 0.0;
  for (const double mass : {0.5, 1.0, 5.0, 20.0, 100.0}) {
    const std::string below = setting("lower_mass", mass);
    const Speeds free = blocks({speed, below}, coulomb_technique(), duration);
    of_masses = std::max(of_masses, largest_difference(blocks({speed, below}, {"damped"}, duration),
                                                       free, end_of_slide(free)));
  }
  quantities.push_back(
      {"largest difference between the speeds of the upper block while it slides on the lower one, "
       "damped and with Coulomb's friction, over its speed at the start, of five mass ratios",
       "-", of_masses});
  quantities.push_back({"the same, the lower block being held", "-",
                        largest_difference(blocks({speed, held}, {"damped"}, duration),
                                           coulomb_held, end_of_slide(coulomb_held))});
  // Is there a friction that damping comes close to? It knows none.
  Table friction{"friction",
                 {{"friction", "-", "Coulomb's coefficient"},
                  {"free", "-", "the number that decides"},
                  {"held", "-", "the same, the lower block being held by the ground"}}};
  const int steps = settings.count("steps");
  double least = 1.0;
  double least_at = 0.0;
  for (int k = 1; k <= steps; ++k) {
    const double mu = static_cast<double>(k) / steps;
    const std::string with = setting("friction", mu);
    const double on_held = difference({speed, with, held});
    friction.add(mu, difference({speed, with}), on_held);
    if (on_held < least) {
      least = on_held;
      least_at = mu;
    }
  }
  quantities.push_back(
      {"least difference over all frictions, the lower block being held", "-", least});
  quantities.push_back({"friction at which it is least", "-", least_at});
  return {{table, friction}, quantities};
}

const Registered claim_5_3c_friction_figure{
    {.name = "claim_5_3c_friction",
     .parameters = {number("speed", 2.0, 0.1, 3.0, "m/s", "of the upper block at the start"),
                    number("duration", 2.0, 0.1, 10.0, "s", "of the runs"),
                    whole("steps", 40, 2, 400, "coefficients of friction from 0 to 1")},
     .quick = {"steps=10"},
     .experiment = measure_friction_on_upper}};

Result measure_friction_chain(const Parameters& settings) {
  const double duration = settings.number("duration");
  const std::string fast = setting("speed", settings.number("speed"));
  const Scene scene = make_scene("sled", {fast});
  const std::vector<std::string> names = {"sled", "load1", "load2"};
  const Speeds coulomb = speeds_of(scene, coulomb_technique(), names, duration);
  const std::string decides =
      "speed that friction gives to the upper box of a stack on a sled, damped, over that with "
      "Coulomb's friction";
  std::vector<Quantity> quantities;
  Speeds damped;
  for (const DampedVariant& variant : damped_variants()) {
    Speeds run = speeds_of(scene, variant.technique, names, duration);
    quantities.push_back({variant.words.empty() ? decides : "the same, " + variant.words, "-",
                          run.fastest(2) / coulomb.fastest(2)});
    if (variant.words.empty()) damped = std::move(run);
  }
  for (const OtherFriction& other : other_frictions("sled")) {
    const Scene changed = make_scene("sled", {fast, other.setting});
    quantities.push_back({"the same, " + other.words, "-",
                          speeds_of(changed, {"damped"}, names, duration).fastest(2) /
                              speeds_of(changed, coulomb_technique(), names, duration).fastest(2)});
  }
  quantities.push_back({"the same of the lower box", "-", damped.fastest(1) / coulomb.fastest(1)});
  quantities.push_back(
      {"speed of the upper box at the end, Coulomb", "m/s", coulomb.speed[2].back()});
  quantities.push_back({"speed of the sled at the end, damped", "m/s", damped.speed[0].back()});

  Table table{"", {{"time_s", "s", "time"}}};
  Table boxes{"boxes",
              {{"damped_x_m", "m", "centre at the end, damped"},
               {"coulomb_x_m", "m", "centre at the end, Coulomb's friction"},
               {"start_x_m", "m", "centre at the start"},
               {"y_m", "m", "centre"},
               {"width_m", "m", "along x"},
               {"height_m", "m", "along y"}}};
  for (const char* technique : {"damped", "coulomb"})
    for (const std::string& name : names)
      table.columns.push_back({std::string(technique) + "_" + name + "_m_s", "m/s", "its speed"});
  for (std::size_t k = 0; k < damped.time.size(); ++k)
    table.add(damped.time[k], damped.at(k), coulomb.at(k));
  for (std::size_t k = 0; k < names.size(); ++k) {
    const SceneBox& box = scene.boxes[k];
    boxes.add(damped.end_w[k].x(), coulomb.end_w[k].x(), box.position_w.x(), box.position_w.y(),
              box.size.x(), box.size.y());
  }
  return {{table, boxes}, quantities};
}

const Registered claim_5_3f_chain_figure{
    {.name = "claim_5_3f_chain",
     .parameters = {number("speed", 1.0, 0.1, 10.0, "m/s", "of the sled at the start"),
                    number("duration", 1.0, 0.1, 10.0, "s", "of the runs")},
     .experiment = measure_friction_chain}};

}  // namespace
}  // namespace tumble::chapters
