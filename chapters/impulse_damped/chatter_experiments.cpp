/// \file
/// \brief Chatter of a stack that is held up by impulses without damping (thesis 3.3.2).
#include "tumble/contact/tolerances.hpp"
#include "tumble/impulse_damped/damped.hpp"
#include "tumble/record/chatter.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

constexpr int kCoarsest = 30;  // [1/s] steps
constexpr std::array<NormalRule, 3> kNormals = {NormalRule::last_face, NormalRule::separation,
                                                NormalRule::signed_distance};
using Shock = decltype(DampedOptions::shock);

// A way to run the stack.
struct Method {
  Shock shock = Shock::position;
  PointRule points = PointRule::one;
  NormalRule normals = NormalRule::last_face;
  int rate = 60;  // [1/s] steps
};

struct Stack {
  int boxes = 5;
  double restitution = 0.9;  // [-]
  double aside = 0.0;        // [m] by how much a box is moved along x and z, at most
  double turn = 0.0;         // [rad] by how much it is turned about the vertical, at most
  double duration = 2.0;     // [s]
};

World build(const Stack& stack, int seed) {
  Random random(static_cast<std::uint64_t>(seed));
  World world;
  world.add_ground(0.5, stack.restitution);
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, 0.5, stack.restitution);
  for (int k = 0; k < stack.boxes; ++k) {
    const double x = stack.aside * random.uniform(-1.0, 1.0);
    const double z = stack.aside * random.uniform(-1.0, 1.0);
    const Vec3 turn_w(0.0, stack.turn * random.uniform(-1.0, 1.0), 0.0);
    world.add(cube, Vec3(x, k + 0.5, z), rotation_from_vector(turn_w));
  }
  return world;
}

Damped without_damping(const Method& method) {
  DampedOptions options{.stable_boxes = StableRule::off, .damping = damping_parts_from("none")};
  options.noise.where = Randomness::off;
  options.shock = method.shock;
  options.points = method.points;
  options.normals = method.normals;
  return Damped(options);
}

// What the windows of one run or of several showed.
struct Shaking {
  double amplitude = 0.0;  // [m] sum over the windows in which a box rests
  double windows = 0.0;    // how many these are

  [[nodiscard]] double mean() const {
    return windows > 0.0 ? amplitude / windows : std::numeric_limits<double>::quiet_NaN();
  }
  void add(const Shaking& other) {
    amplitude += other.amplitude;
    windows += other.windows;
  }
};

// A body is in contact if another surface is within the distance that a body at rest may move.
class Watch {
 public:
  void look(const World& world) {
    near_.gather(world, world.states(), world.states(), nullptr, tolerance::resting_movement,
                 contacts_);
    touching_.assign(world.bodies().size(), 0);
    for (const Contact& contact : contacts_)
      for (const int body : {contact.first, contact.second}) touching_[idx(body)] = 1;
    meter_.add(world, touching_);
  }
  [[nodiscard]] Chatter measure(double gravity) const { return meter_.measure(gravity); }

 private:
  PairGatherer near_{NormalRule::separation, PointRule::one};
  ContactList contacts_;
  std::vector<char> touching_;
  ChatterMeter meter_;
};

// Windows are half seconds that end after the first second.
Shaking shake(const Stack& stack, const Method& method, int seed) {
  World world = build(stack, seed);
  Damped technique = without_damping(method);
  Watch watch;
  watch.look(world);
  Shaking out;
  const int steps = static_cast<int>(stack.duration * method.rate + 0.5);
  for (int step = 1; step <= steps; ++step) {
    finished(technique.step(world, 1.0 / method.rate));
    watch.look(world);
    if (step < method.rate || 2 * step % method.rate != 0) continue;
    const Chatter chatter = watch.measure(world.gravity_w.norm());
    if (chatter.bodies > 0) out.add({chatter.amplitude, 1.0});
  }
  return out;
}

std::vector<Shaking> shake_all(const Stack& stack, const Method& method, int seeds, int after = 0) {
  std::vector<Shaking> out;
  for (int seed = after + 1; seed <= after + seeds; ++seed)
    out.push_back(shake(stack, method, seed));
  return out;
}

double mean_without(const std::vector<Shaking>& runs, int left_out) {
  Shaking all;
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (static_cast<int>(k) != left_out) all.add(runs[k]);
  return all.mean();
}

Table all_rules(const Stack& stack, int finest, int seeds) {
  Table table{"",
              {{"shock", "-", "0: bodies are pushed out of overlap, 1: velocities are stopped"},
               {"points", "-", "0: one of a pair, 1: the whole contact area"},
               {"normals", "-", "0: closest face of the last step, 1: exact, 2: signed distance"},
               {"dt_s", "s", "time step"},
               {"amplitude_m", "m", "of chatter, mean over the windows in which a box rests"},
               {"windows", "-", "how many these are"}}};
  for (const Shock shock : {Shock::position, Shock::velocity})
    for (const PointRule points : {PointRule::one, PointRule::area})
      for (std::size_t n = 0; n < kNormals.size(); ++n)
        for (int rate = finest; rate >= kCoarsest; rate /= 2) {
          Shaking all;
          for (const Shaking& run : shake_all(stack, {shock, points, kNormals[n], rate}, seeds))
            all.add(run);
          table.add(shock == Shock::velocity, points == PointRule::area, n, 1.0 / rate, all.mean(),
                    all.windows);
        }
  return table;
}

// The two causes that the text names, together and one at a time, and the pushes.
void add_shares(const Stack& stack, int seeds, std::vector<Quantity>& out) {
  const std::vector<Shaking> base = shake_all(stack, {}, seeds);
  const auto share = [&](const std::string& name, const Method& method) {
    const std::vector<Shaking> changed = shake_all(stack, method, seeds);
    out.push_back(over_seeds(name, "-", seeds, [&](int left_out) {
      return 1.0 - mean_without(changed, left_out) / mean_without(base, left_out);
    }));
  };
  share(
      "share of the chatter of a stack on the ground that goes away with a quarter of the step and "
      "true normals",
      {.normals = NormalRule::separation, .rate = 240});
  const std::vector<Shaking> fresh = shake_all(stack, {}, seeds, seeds);
  const std::vector<Shaking> cured =
      shake_all(stack, {.normals = NormalRule::separation, .rate = 240}, seeds, seeds);
  out.push_back(over_seeds(
      "share of the chatter of a stack on the ground that goes away with a quarter of the step and "
      "true normals, fresh seeds",
      "-", seeds, [&](int k) { return 1.0 - mean_without(cured, k) / mean_without(fresh, k); }));
  share("share that goes away with a quarter of the step", {.rate = 240});
  share("share that goes away with true normals", {.normals = NormalRule::separation});
  share("share that goes away if velocities are stopped in place of pushes",
        {.shock = Shock::velocity});
  out.push_back({"amplitude of chatter at 1/60 s with the normals of the thesis", "m",
                 mean_without(base, -1)});
  Stack dull = stack;
  dull.restitution = 0.0;
  out.push_back({"the same amplitude without restitution", "m",
                 mean_without(shake_all(dull, {}, seeds), -1)});
}

Result measure_oscillation(const Parameters& settings) {
  const Stack stack{settings.count("boxes"), settings.number("restitution"),
                    settings.number("aside"), settings.number("turn"), settings.number("duration")};
  Result result{.tables = {all_rules(stack, settings.count("finest"), settings.count("seeds"))}};
  add_shares(stack, settings.count("many"), result.quantities);

  return result;
}

const Registered claim_3_3_2a_oscillation_figure{
    {.name = "claim_3_3_2a_oscillation",
     .parameters = {whole("boxes", 5, 1, 50, "in the stack"),
                    number("restitution", 0.9, 0.0, 1.0, "-", "of boxes and ground: the thesis's"),
                    number("aside", 0.02, 0.0, 0.4, "m",
                           "by how much a box is moved aside, at most"),
                    number("turn", 0.05, 0.0, 0.7, "rad", "by how much it is turned, at most"),
                    number("duration", 2.0, 1.0, 60.0, "s", "of each run"),
                    whole("finest", 480, 60, 3840, "steps a second; others are halves of it"),
                    whole("seeds", 2, 1, 1000, "stacks for each point that is drawn"),
                    whole("many", 20, 2, 1000, "stacks for the numbers")},
     .quick = {"seeds=1", "many=2", "duration=1", "finest=240"},
     .experiment = measure_oscillation}};

}  // namespace
}  // namespace tumble::chapters
