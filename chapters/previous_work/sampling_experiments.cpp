/// \file
/// \brief Three motions that knock down the same three pins (thesis 2.4.2).
#include "tumble/pictures/world_picture.hpp"
#include "tumble/previous_work/parallel_chains.hpp"
#include "tumble/record/sampling.hpp"
#include "tumble/techniques.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

constexpr std::array<double, 3> kMoments = {0.5, 0.8,
                                            2.0};  // [s] of the pictures; the last is the end

// Six pins in a triangle and a box that is thrown at them, as examples/scenes/bowling.toml has them.
Scene bowling() {
  constexpr double apart = 0.3;  // [m]
  constexpr double surface = 0.3;
  Scene scene{.ground = SceneGround{.friction = surface, .restitution = surface}};
  scene.boxes.push_back({.name = "bowl",
                         .size = Vec3::Constant(0.2),
                         .mass = 5.0,
                         .position_w = {0.05, 0.3, 2.0},
                         .orientation_wb = rotation_from_degrees({20.0, 30.0, 10.0}),
                         .velocity_w = {0.0, -1.0, -6.0},
                         .angular_velocity_w = {-10.0, 1.0, 3.0},
                         .friction = surface,
                         .restitution = surface});
  for (int row = 0; row < 3; ++row)
    for (int place = 0; place <= row; ++place)
      scene.boxes.push_back(
          {.name = "pin" + std::to_string(scene.boxes.size()),
           .size = {0.12, 0.38, 0.12},
           .mass = 1.5,
           .position_w = {apart * (place - 0.5 * row), 0.19, -apart * std::sqrt(0.75) * row},
           .friction = surface,
           .restitution = surface});
  scene.wishes = {{.kind = WishKind::topples, .bodies = {"pin1", "pin2", "pin4"}},
                  {.kind = WishKind::stands, .bodies = {"pin3", "pin5", "pin6"}}};
  return scene;
}

// A die of 16 mm, as examples/scenes/six.toml has it, that is to show a six on a square centimetre.
Scene die_on_a_square() {
  Scene scene{.ground = SceneGround{}};
  scene.boxes.push_back({.name = "die",
                         .size = Vec3::Constant(0.016),
                         .mass = 0.005,
                         .position_w = {0.0, 0.2, 0.0},
                         .orientation_wb = rotation_from_degrees({10.0, 20.0, 30.0}),
                         .velocity_w = {0.5, 0.0, 0.0},
                         .angular_velocity_w = {3.0, 20.0, 15.0},
                         .friction = 0.4,
                         .restitution = 0.4});
  scene.wishes = {{.kind = WishKind::face_up, .bodies = {"die"}, .face = 4},
                  {.kind = WishKind::ends_in,
                   .bodies = {"die"},
                   .low_w = {0.09, 0.0, -0.005},
                   .high_w = {0.1, 0.1, 0.005}}};
  return scene;
}

SceneSampler sampler_of(Scene scene) {
  return {std::move(scene),
          make_technique(kDefaultTechnique),
          {.dt = kStep, .duration = kMoments.back()},
          {}};
}

// How many of some motions with independent noise meet the wishes.
int met_by_chance(const SceneSampler& sampler, int drawn) {
  int met = 0;
  for (int k = 0; k < drawn; ++k) {
    const ImpactNoise noise(Random(static_cast<std::uint64_t>(k)).fork(1));
    met += sampler.motion(noise).violation == 0.0 ? 1 : 0;
  }
  return met;
}

// The boxes at some moments of a motion.
class Moments : public RunObserver {
 public:
  void on_step(const World& world, const Technique&, const StepReport& report,
               const Metrics&) override {
    finished(report);
    if (frames.size() < kMoments.size() && world.time() > kMoments[frames.size()] - 0.5 * kStep)
      frames.push_back(picture_boxes(world));
    for (std::size_t k = 0; k < world.states().size(); ++k)
      if (world.name(static_cast<int>(k)) == "bowl") last_w = world.states()[k].position_w;
  }
  std::vector<std::vector<PictureBox>> frames;
  Vec3 last_w = Vec3::Zero();  // [m] of the box that was thrown
};

// The first motion of each of some chains.
struct Sampled {
  std::vector<FoundMotion> motions;
  std::int64_t proposals = 0;
  std::int64_t accepted = 0;
};

Sampled sample(const SceneSampler& sampler, const Parameters& settings, int count,
               double strictness) {
  std::vector<NoiseChain> chains =
      make_chains(static_cast<std::uint64_t>(settings.whole("seed")), count, strictness);
  std::atomic<bool> stop = false;
  constexpr int cores = 2;
  run_chains(chains, {.found = 1, .proposals = settings.whole("proposals")}, sampler.simulate(stop),
             cores, stop);
  Sampled sampled;
  for (const NoiseChain& chain : chains) {
    if (!chain.found().empty()) sampled.motions.push_back(chain.found().front());
    sampled.proposals += static_cast<std::int64_t>(chain.proposals().size());
    sampled.accepted += chain.accepted();
  }
  return sampled;
}

// A wish that is met more and more: how often chains meet it, and chance.
void measure_die(const Parameters& settings, Result& result) {
  const SceneSampler sampler = sampler_of(die_on_a_square());
  const Sampled sampled =
      sample(sampler, settings, settings.count("chains"), settings.number("die_strictness"));
  const int drawn = settings.count("die_drawn");
  result.add("chains that put a six on a square centimetre", "-", sampled.motions.size());
  result.add("motions that they have tried", "-", sampled.proposals);
  result.add("motions without a chain that put it there", "-", met_by_chance(sampler, drawn));
}

Result measure_sampling(const Parameters& settings) {
  const SceneSampler sampler = sampler_of(bowling());
  const int motions = settings.count("motions");
  const Sampled sampled = sample(sampler, settings, motions, settings.number("strictness"));
  if (sampled.motions.size() < idx(motions))
    throw std::runtime_error("a chain met its cap without a motion: give more proposals");
  Table table{"",
              {{"motion", "-", "row of the picture"},
               {"proposals", "-", "that its chain made before it"},
               {"impacts", "-", "fast impacts of the motion"},
               {"violation", "-", "0: it meets the wishes"},
               {"end_x_m", "m", "where the box that was thrown is at the end"},
               {"end_z_m", "m", "the same"}}};
  std::vector<Moments> rows(sampled.motions.size());
  std::vector<PictureBox> all;
  double apart = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const FoundMotion& found = sampled.motions[k];
    const std::array<RunObserver*, 1> observers = {&rows[k]};
    if (sampler.run(found.noise, observers).worst != StepStatus::done)
      throw std::runtime_error("a motion that was found does not finish");
    const NoisyMotion motion = sampler.motion(found.noise);
    table.add(k + 1, found.proposal, motion.impacts.size(), motion.violation, rows[k].last_w.x(),
              rows[k].last_w.z());
    for (const std::vector<PictureBox>& frame : rows[k].frames)
      all.insert(all.end(), frame.begin(), frame.end());
    for (std::size_t j = 0; j < k; ++j)
      apart = std::min(apart, (rows[k].last_w - rows[j].last_w).norm());
  }

  Camera camera{.eye_w = Vec3(0.35, 1.5, 1.1),
                .target_w = Vec3(0.0, 0.16, -0.7),
                .field_of_view = 0.72,
                .width = 200.0,
                .height = 150.0};
  Result result{.tables = {table}};
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (std::size_t j = 0; j < rows[k].frames.size(); ++j)
      result.drawings.push_back({"motion" + std::to_string(k + 1) + "_" + std::to_string(j + 1),
                                 to_gnuplot(draw_boxes(rows[k].frames[j], camera, true, all))});
  const int drawn = settings.count("drawn");
  result.add("motions tried by the chains until each has found one", "-", sampled.proposals);
  result.add(
      "share of proposals that were accepted", "-",
      static_cast<double>(sampled.accepted) / static_cast<double>(sampled.proposals - motions));
  result.add("share of motions that meet the wishes without a chain", "-",
             static_cast<double>(met_by_chance(sampler, drawn)) / drawn);
  result.add("least distance between the ends of the thrown box in two of the motions", "m", apart);
  measure_die(settings, result);
  return result;
}

const Registered sampling_figure{
    {.name = "chain_motions",
     .parameters = {whole("seed", 1, 0, 1000000, "of the chains"),
                    whole("motions", 3, 1, 3, "rows of the picture"),
                    number("strictness", 10.0, 0.01, 1000.0, "-", "of the wishes"),
                    whole("proposals", 2000, 1, 100000, "of a chain, at most"),
                    whole("drawn", 400, 1, 100000, "motions without a chain"),
                    number("die_strictness", 30.0, 0.01, 1000.0, "-", "of its wishes"),
                    whole("chains", 8, 1, 1000, "of the die"),
                    whole("die_drawn", 2000, 1, 1000000, "motions without a chain")},
     .quick = {"seed=12", "motions=1", "proposals=60", "drawn=2", "chains=1", "die_drawn=20"},
     .experiment = measure_sampling}};

}  // namespace
}  // namespace tumble::chapters
