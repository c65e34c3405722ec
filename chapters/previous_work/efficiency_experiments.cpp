/// \file
/// \brief Motions that chains try until a wish is met, and motions that chance tries (thesis 2.4.2).
#include "tumble/previous_work/parallel_chains.hpp"
#include "tumble/record/sampling.hpp"
#include "tumble/techniques.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

constexpr double kDuration = 2.0;        // [s]
constexpr double kHalfSquare = 0.02;     // [m]
constexpr double kAnywhere = 100.0;      // [m]
constexpr double kStrictness = 30.0;     // [-]
constexpr int kCores = 2;                // results are the same with any number
constexpr std::uint64_t kTargets = 101;  // streams of noise that nothing else uses
constexpr std::uint64_t kChance = 102;

// A brick that is thrown.
Scene brick() {
  Scene scene{.ground = SceneGround{.friction = 0.4, .restitution = 0.3}};
  scene.boxes.push_back({.name = "brick",
                         .size = {0.2, 0.06, 0.1},
                         .mass = 2.0,
                         .position_w = {0.0, 0.4, 0.0},
                         .orientation_wb = rotation_from_degrees({10.0, 20.0, 30.0}),
                         .velocity_w = {3.0, 0.0, 0.0},
                         .angular_velocity_w = {2.0, 4.0, -8.0},
                         .friction = 0.4,
                         .restitution = 0.3});
  return scene;
}

Wish ends_around(const Vec3& middle_w, double half) {
  const Vec3 around_w(half, kAnywhere, half);
  return {.kind = WishKind::ends_in,
          .bodies = {"brick"},
          .low_w = middle_w - around_w,
          .high_w = middle_w + around_w};
}

// The brick, with wishes.
SceneSampler brick_sampler(std::vector<Wish> wishes) {
  Scene scene = brick();
  scene.wishes = std::move(wishes);
  return {std::move(scene),
          make_technique(kDefaultTechnique),
          {.dt = kStep, .duration = kDuration},
          {}};
}

// The world after the last step.
class LastWorld : public RunObserver {
 public:
  void on_step(const World& world, const Technique&, const StepReport& report,
               const Metrics&) override {
    finished(report);
    last = world;
  }
  World last;
};

// How a motion ends.
World end_of(const SceneSampler& sampler, const ImpactNoise& noise) {
  LastWorld observer;
  const std::array<RunObserver*, 1> observers = {&observer};
  sampler.run(noise, observers);
  return observer.last;
}

// Of the faces of the brick, the one that is up.
int face_up(const BodyState& state) {
  const Vec3 up_b = state.orientation_wb.conjugate() * Vec3::UnitY();
  int axis = 0;
  up_b.cwiseAbs().maxCoeff(&axis);
  return 2 * axis + (up_b[axis] < 0.0 ? 1 : 0);
}

// The place and the face with which a motion ends.
std::vector<Wish> wish_like(const World& end) {
  const BodyState& brick = end.states().back();
  Wish face{.kind = WishKind::face_up, .bodies = {"brick"}};
  face.face = face_up(brick);
  return {ends_around(brick.position_w, kHalfSquare), face};
}

double missed(const std::vector<Wish>& wishes, const Scene& scene, const World& end) {
  double sum = 0.0;
  for (const Wish& wish : wishes) sum += violation(wish, scene, end);
  return sum;
}

Result measure_efficiency(const Parameters& settings) {
  const int wishes = settings.count("wishes"), each = settings.count("each"),
            most = settings.count("most");
  const SceneSampler any = brick_sampler({ends_around(Vec3::Zero(), kAnywhere)});
  const Scene& scene = any.scene();
  // The streams of chance are the same for all wishes; what they try does not hang on a wish.
  std::vector<World> ends;
  for (int k = 0; k < each * most; ++k)
    ends.push_back(end_of(any, ImpactNoise(Random(kChance).fork(static_cast<std::uint64_t>(k)))));
  Table table{"",
              {{"wish", "-", "seed"},
               {"chance", "-", "motions that independent noise tries, sum over its streams"},
               {"chains", "-", "motions that chains try, sum over them"}}};
  std::vector<double> decades;
  double chance_sum = 0.0, chain_sum = 0.0;
  for (int seed = 1; seed <= wishes; ++seed) {
    const auto stream = static_cast<std::uint64_t>(seed);
    const World target = end_of(any, ImpactNoise(Random(kTargets).fork(stream)));
    const std::vector<Wish> wish = wish_like(target);
    if (missed(wish, scene, target) > 0.0)
      throw std::runtime_error("the motion of a wish does not meet it: give another seed");
    int chance = 0;
    for (int k = 0; k < each; ++k) {
      const auto first = ends.begin() + static_cast<std::ptrdiff_t>(k) * most;
      const auto hit = std::find_if(
          first, first + most, [&](const World& end) { return missed(wish, scene, end) == 0.0; });
      chance += std::min(most, static_cast<int>(hit - first) + 1);
    }
    const SceneSampler sampler = brick_sampler(wish);
    std::vector<NoiseChain> chains = make_chains(stream, each, kStrictness);
    std::atomic<bool> stop = false;
    run_chains(chains, {.found = 1, .proposals = most}, sampler.simulate(stop), kCores, stop);
    double tried = 0.0;
    for (const NoiseChain& chain : chains) tried += static_cast<double>(chain.proposals().size());
    table.add(seed, chance, tried);
    decades.push_back(elementary::log(chance / tried));
    chance_sum += chance;
    chain_sum += tried;
  }
  Result result{.tables = {table}};
  const Quantity mean = mean_over_seeds("", "-", decades);
  result.add(
      "motions that independent noise tries until a wish is met, over those that chains try, "
      "geometric mean over twenty wishes",
      "-", elementary::exp(mean.value), elementary::exp(mean.low), elementary::exp(mean.high),
      wishes);
  result.add("motions that independent noise tries for a wish, mean", "-",
             chance_sum / (wishes * each));
  result.add("motions that chains try for a wish, mean", "-", chain_sum / (wishes * each));
  return result;
}

const Registered efficiency_figure{
    {.name = "claim_2_4_2b_efficiency",
     .parameters = {whole("wishes", 20, 2, 1000, "places and faces"),
                    whole("each", 8, 1, 100, "chains, and streams of independent noise"),
                    whole("most", 1000, 1, 100000, "motions that each of them tries")},
     .quick = {"wishes=2", "each=1", "most=30"},
     .experiment = measure_efficiency}};

}  // namespace
}  // namespace tumble::chapters
