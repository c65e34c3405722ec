/// \file
/// \brief The overlap that impulses leave to the pass that ends it by moving bodies (thesis 4.4).
#include "tumble/impulse_damped/damped.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

// [m] of all pairs, each with its deepest point.
double total_depth(const World& world, std::span<const BodyState> poses, PairGatherer& gatherer,
                   ContactList& contacts) {
  gatherer.gather(world, poses, poses, nullptr, 0.0, contacts);
  double sum = 0.0;
  for (const Contact& contact : contacts) {
    double deepest = 0.0;
    for (int k = 0; k < contact.count; ++k)
      deepest = std::max(deepest, -contact.points[idx(k)].distance);
    sum += deepest;
  }
  return sum;
}

// Sums over a stretch of time [m].
struct Overlap {
  double free = 0.0;   // if no impulse had acted in the step
  double found = 0.0;  // by the pass
  double left = 0.0;   // by it
};

// Damped integration whose pass is taken out and run after the step, so that one can look before.
class Split {
 public:
  explicit Split(const DampedOptions& options) : technique_(without_pushes(options)) {}

  Overlap step(World& world) {
    Overlap out;
    poses_.assign(world.states().begin(), world.states().end());
    for (std::size_t k = 0; k < poses_.size(); ++k) {
      const BodyProperties& body = world.bodies()[k];
      if (!body.movable()) continue;
      poses_[k].linear_momentum_w += kStep * body.mass * world.gravity_w;
      advance_pose(body, poses_[k], kStep, RotationRule::splitting);
    }
    out.free = total_depth(world, poses_, areas_, contacts_);
    finished(technique_.step(world, kStep));
    out.found = total_depth(world, world.states(), areas_, contacts_);
    fix_.run(world, contacts_, DampedNumbers{}, kStep);
    out.left = total_depth(world, world.states(), areas_, contacts_);
    return out;
  }

 private:
  // Pushes of length 0 move no body.
  static DampedOptions without_pushes(DampedOptions options) {
    options.numbers.eps1 = 0.0;
    return options;
  }

  Damped technique_;
  PairGatherer areas_{NormalRule::separation, PointRule::area};
  FixContactConstraints fix_;
  ContactList contacts_;
  std::vector<BodyState> poses_;
};

// Sums by tenths of a second.
std::vector<Overlap> overlaps(World world, const DampedOptions& options, double duration) {
  Split split(options);
  const int steps = static_cast<int>(duration / kStep + 0.5);
  std::vector<Overlap> out;
  for (int step = 0; step < steps; ++step) {
    if (step % 6 == 0) out.emplace_back();
    const Overlap now = split.step(world);
    out.back().free += now.free;
    out.back().found += now.found;
    out.back().left += now.left;
  }
  return out;
}

World heap(int per_edge, double restitution, int seed) {
  return build_world(make_scene(
      "clump",
      {"per_edge=" + std::to_string(per_edge), "restitution=" + std::to_string(restitution)},
      static_cast<std::uint64_t>(seed)));
}

World stack_of_five(double restitution) {
  World world;
  world.add_ground(0.5, restitution);
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, 0.5, restitution);
  for (int k = 0; k < 5; ++k) world.add(cube, Vec3(0.0, k + 0.5, 0.0));
  return world;
}

// What the pass removes over what there would be, a number for each seed of the sum.
Quantity removed(const std::string& name, const std::vector<std::vector<Overlap>>& runs) {
  std::vector<double> free;
  std::vector<double> gone;
  for (const std::vector<Overlap>& run : runs) {
    free.push_back(0.0);
    gone.push_back(0.0);
    for (const Overlap& part : run) {
      free.back() += part.free;
      gone.back() += part.found - part.left;
    }
  }
  Quantity share = ratio_of_sums(name, "-", gone, free);
  if (runs.size() < 2) share.seeds = 0;  // nothing is random
  return share;
}

Result measure_overlap_left(const Parameters& settings) {
  const int per_edge = settings.count("per_edge");
  const double restitution = settings.number("restitution");
  const double duration = settings.number("duration");
  const int seeds = settings.count("seeds");
  const DampedOptions usual;
  DampedOptions loose{.stable_boxes = StableRule::off, .damping = damping_parts_from("none")};

  std::vector<std::vector<Overlap>> heaps;
  std::vector<std::vector<Overlap>> loose_heaps;
  for (int seed = 1; seed <= seeds; ++seed) {
    heaps.push_back(overlaps(heap(per_edge, restitution, seed), usual, duration));
    loose_heaps.push_back(overlaps(heap(per_edge, restitution, seed), loose, duration));
  }
  std::vector<std::vector<Overlap>> fresh_heaps;
  for (int seed = seeds + 1; seed <= 2 * seeds; ++seed)
    fresh_heaps.push_back(overlaps(heap(per_edge, restitution, seed), usual, duration));
  Table table{"",
              {{"time_s", "s", "middle of a tenth of a second"},
               {"free_m", "m", "overlap if no impulse had acted, mean over steps and heaps"},
               {"found_m", "m", "overlap that the pass finds"},
               {"left_m", "m", "overlap that it leaves"},
               {"loose_found_m", "m", "without damping: overlap that the pass finds"}}};
  for (std::size_t k = 0; k < heaps[0].size(); ++k) {
    Overlap sum;
    Overlap loose_sum;
    for (int seed = 0; seed < seeds; ++seed) {
      const Overlap& one = heaps[idx(seed)][k];
      const Overlap& other = loose_heaps[idx(seed)][k];
      sum = {sum.free + one.free, sum.found + one.found, sum.left + one.left};
      loose_sum.found += other.found;
    }
    const double scale = 1.0 / (6.0 * seeds);
    table.add(0.1 * (static_cast<double>(k) + 0.5), scale * sum.free, scale * sum.found,
              scale * sum.left, scale * loose_sum.found);
  }

  // The pass taken out of the step does what it does within.
  World apart = heap(per_edge, restitution, 1);
  World within = apart;
  Split split(loose);
  Damped whole(loose);
  for (int step = 0; step < 60; ++step) {
    split.step(apart);
    finished(whole.step(within, kStep));
  }
  for (std::size_t k = 0; k < apart.states().size(); ++k)
    if (apart.states()[k].position_w != within.states()[k].position_w)
      throw std::runtime_error("the pass taken out of the step does something else");

  const World five = stack_of_five(restitution);
  const std::vector<std::vector<Overlap>> loose_stack = {overlaps(five, loose, duration)};
  return {{table},
          {removed("overlap that the pass removes, over all overlap that would be there without "
                   "any response",
                   heaps),
           removed("overlap that the pass removes, over all overlap that would be there without "
                   "any response, fresh seeds",
                   fresh_heaps),
           removed("the same without damping", loose_heaps),
           removed("the same for that stack without damping", loose_stack)}};
}

const Registered claim_4_4b_overlap_left_figure{
    {.name = "claim_4_4b_overlap_left",
     .parameters = {whole("per_edge", 3, 1, 20, "cubes along each edge of the heap's grid"),
                    number("restitution", 0.9, 0.0, 1.0, "-", "of cubes and ground: the thesis's"),
                    number("duration", 5.0, 0.2, 600.0, "s", "of each run"),
                    whole("seeds", 20, 2, 1000, "heaps")},
     .quick = {"seeds=2", "duration=2"},
     .experiment = measure_overlap_left}};

}  // namespace
}  // namespace tumble::chapters
