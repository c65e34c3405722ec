/// \file
/// \brief Experiments on collisions that a test at the end of each step misses (thesis 3.2).
#include "tumble/dynamics/pair_search.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

constexpr double kLarge = 1.0;    // [m] edge of the large cube
constexpr IndexPair kPair{0, 1};  // the large cube, the small one

// How the small cubes fly.
struct Passes {
  double small = 0.0;  // [m] edge: its thickness
  double speed = 0.0;  // [-] thicknesses per step
  double spin = 0.0;   // [rad/s] at most
  bool sort = false;   // distinguish brushes from others, which is slow
};

// One pass: a small cube flies straight by a large one that hangs still, and tumbles.
struct Pass {
  std::array<BodyProperties, 2> bodies;
  std::array<BodyState, 2> states;
  int steps = 0;  // until it is past

  // Cubes turn about a fixed axis, and the simplest rule turns them exactly.
  [[nodiscard]] Flight flight() const {
    return Flight{.bodies = bodies,
                  .states = states,
                  .gravity_w = Vec3::Zero(),
                  .rule = RotationRule::frozen};
  }
  [[nodiscard]] double duration() const { return steps * kStep; }
};

// Radius around the large cube beyond which the small one's centre cannot touch it.
double reach_of(double small) { return 0.5 * std::numbers::sqrt3 * (kLarge + small); }

// All lines that may touch are equally likely: any direction, aimed at any point of the disc that
// the large cube's reach spans across it. Where the first step ends is random as well.
Pass random_pass(const Passes& passes, Random chance) {
  Pass pass;
  pass.bodies = {fixed_box_properties(Vec3::Constant(kLarge)),
                 box_properties(Vec3::Constant(passes.small), 1.0)};
  const Quat large_wb = chance.orientation();
  const Quat small_wb = chance.orientation();
  const Quat aim = chance.orientation();
  const Vec3 spin_w = chance.uniform(0.0, passes.spin) * chance.direction();
  const double phase = chance.unit();
  Vec2 target(1.0, 1.0);
  while (target.squaredNorm() > 1.0) {
    target.x() = chance.uniform(-1.0, 1.0);
    target.y() = chance.uniform(-1.0, 1.0);
  }
  const double reach = reach_of(passes.small);
  const double per_step = passes.speed * passes.small;  // [m]
  const Vec3 start(reach * target.x(), reach * target.y(), -reach - phase * per_step);
  pass.states = {make_state(pass.bodies[0], Vec3::Zero(), large_wb),
                 make_state(pass.bodies[1], aim * start, small_wb,
                            aim * Vec3(0.0, 0.0, per_step / kStep), spin_w)};
  pass.steps = static_cast<int>(std::ceil(2.0 * reach / per_step)) + 1;
  return pass;
}

// What happened in a pass.
struct Outcome {
  bool collided = false;       // says the conservative search
  bool found = false;          // by the end-of-step test
  bool brushed = false;        // never deeper than a tenth of the thickness
  bool contradiction = false;  // a collision that one of the other two saw and that search not
};

// The way of a technique that tests the end of each step: step by step until it finds something.
bool end_of_step_finds(const Pass& pass) {
  const Flight flight = pass.flight();
  for (int k = 0; k < pass.steps; ++k) {
    const PairCollision seen = find_collision(flight, kPair, k * kStep, (k + 1) * kStep);
    if (seen.status == CollisionStatus::found) return true;
  }
  return false;
}

// The deepest overlap among equally spaced times, and the first time with any.
struct Samples {
  double deepest = 0.0;        // [m]
  double first_overlap = 0.0;  // [s]
};

Samples sampled(const Pass& pass, int count) {
  Samples out{.first_overlap = std::numeric_limits<double>::infinity()};
  const Flight flight = pass.flight();
  for (int k = 1; k < count; ++k) {
    const double time = pass.duration() * k / count;
    const double depth = -gap_at(flight, kPair, time).distance;
    if (depth > 0.0) out.first_overlap = std::min(out.first_overlap, time);
    out.deepest = std::max(out.deepest, depth);
  }
  return out;
}

Outcome watch(const Pass& pass, const Passes& passes, bool proof) {
  const PairCollision truth =
      find_collision(pass.flight(), kPair, 0.0, pass.duration(),
                     {.method = SearchMethod::conservative, .cap = 1000000});
  if (truth.status == CollisionStatus::cap_reached) throw std::runtime_error("search not finished");

  Outcome out;
  out.collided = truth.status == CollisionStatus::found;
  out.found = end_of_step_finds(pass);
  out.contradiction = out.found && !out.collided;
  if ((out.collided && passes.sort) || proof) {
    const Samples samples = sampled(pass, proof ? 2000 : 200);
    out.brushed = samples.deepest <= 0.1 * passes.small;
    // The search says that they are apart until this time: the end, if nothing collided.
    out.contradiction = out.contradiction || samples.first_overlap <= truth.time;
  }
  return out;
}

// Counts over many passes.
struct Tally {
  std::int64_t collisions = 0;
  std::int64_t found = 0;
  std::int64_t brushes = 0;
  std::int64_t brushes_found = 0;
  std::int64_t contradictions = 0;
};

Tally count_passes(const Passes& passes, int count, Random random) {
  Tally tally;
  for (int k = 0; k < count; ++k) {
    // Every twentieth pass is looked at closely, whether there was a collision or not.
    const Pass pass = random_pass(passes, random.fork(static_cast<std::uint64_t>(k)));
    const Outcome out = watch(pass, passes, k % 20 == 0);
    tally.contradictions += out.contradiction ? 1 : 0;
    if (!out.collided) continue;
    ++tally.collisions;
    tally.found += out.found ? 1 : 0;
    if (!out.brushed) continue;
    ++tally.brushes;
    tally.brushes_found += out.found ? 1 : 0;
  }
  return tally;
}

// Mean length [m] of the way through overlap, over all lines and orientations that touch: 4 V / S of
// the body that the small cube's centre must not enter. Volume and surface of such a sum, averaged
// over orientations, are Steiner's and Minkowski's; a cube has the mean curvature 3 π a.
double mean_overlap_length(double a, double b) {
  const double volume =
      a * a * a + b * b * b + (3.0 * a * 6.0 * b * b + 6.0 * a * a * 3.0 * b) / 4.0;
  const double surface = 6.0 * a * a + 6.0 * b * b + 0.5 * std::numbers::pi * 9.0 * a * b;
  return 4.0 * volume / surface;
}

Result measure_missed_passes(const Parameters& settings) {
  const int count = settings.count("passes");
  const double thickness = settings.number("thickness");
  const double spin = settings.number("spin");

  Table table{"",
              {{"speed", "-", "thicknesses per step"},
               {"half_size", "-", "share found, small cube of half the thickness"},
               {"found", "-", "share of the true collisions that the end-of-step test finds"},
               {"low", "-", "lower end of its interval of 95 %"},
               {"high", "-", "upper end of it"},
               {"double_size", "-", "share found, small cube of twice the thickness"},
               {"brushes", "-", "share found of those never deeper than a tenth of the thickness"},
               {"others", "-", "share found of the deeper ones"},
               {"length", "-", "mean length of the overlap over the way of a step"}}};
  std::vector<Quantity> quantities;
  for (int halving = -3; halving <= 4; ++halving) {
    const double speed = std::ldexp(1.0, halving);
    std::array<Quantity, 3> found;
    std::array<Tally, 3> tallies;
    for (int size = 0; size < 3; ++size) {
      const auto k = idx(size);
      const Random random = Random(1).fork(static_cast<std::uint64_t>(8 * size + halving + 3));
      tallies[k] =
          count_passes({std::ldexp(thickness, size - 1), speed, spin, size == 1}, count, random);
      found[k] = share_of_trials("", tallies[k].found, tallies[k].collisions);
      if (tallies[k].contradictions > 0)
        throw std::runtime_error("the conservative search missed a collision");
    }
    const Tally& middle = tallies[1];
    const Quantity brushes = share_of_trials("", middle.brushes_found, middle.brushes);
    const Quantity others = share_of_trials("", middle.found - middle.brushes_found,
                                            middle.collisions - middle.brushes);
    const double length = mean_overlap_length(kLarge, thickness) / (speed * thickness);
    table.add(speed, found[0].value, found[1].value, found[1].low, found[1].high, found[2].value,
              brushes.value, others.value, length);

    if (halving != 2) continue;
    found[1].name =
        "share of the true collisions that the end-of-step test finds at 4 thicknesses a step";
    found[0].name = "the same with a small cube of half the thickness";
    found[2].name = "the same with a small cube of twice the thickness";
    quantities = {found[1], found[0], found[2]};
  }
  return {{table}, quantities};
}

const Registered claim_3_2a_missed_figure{
    {.name = "claim_3_2a_missed",
     .parameters = {whole("passes", 20000, 100, 1000000, "random passes for each speed and size"),
                    number("thickness", 0.25, 0.01, 1.0, "m",
                           "edge of the small cube; the large one has 1 m"),
                    number("spin", 10.0, 0.0, 100.0, "rad/s", "largest spin of the small cube")},
     .quick = {"passes=1000"},
     .experiment = measure_missed_passes}};

}  // namespace
}  // namespace tumble::chapters
