/// \file
/// \brief Tilts of boxes that flew together and settled (thesis 3.1).
#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kFlat = 1.0 * kDegree;  // [rad] a face that is less tilted is down
constexpr double kSlow = 1e-2;           // [-] a box slower than this share of sqrt(g L) rests

// [rad] between the vertical and the nearest axis of a box.
double tilt_of(const BodyState& state) {
  const Vec3 up_b = state.orientation_wb.conjugate() * Vec3::UnitY();
  int axis = 0;
  up_b.cwiseAbs().maxCoeff(&axis);
  Vec3 level_b = up_b;
  level_b[axis] = 0.0;
  return elementary::atan2(level_b.norm(), std::abs(up_b[axis]));
}

// [-] speed of a box, at most that of its corners, over sqrt(g L).
double speed_of(const BodyProperties& body, const BodyState& state, double gravity) {
  return (velocity(body, state).norm() +
          0.5 * body.size.norm() * angular_velocity(body, state).norm()) /
         std::sqrt(gravity * body.size.minCoeff());
}

// One clump, settled.
struct Settled {
  std::vector<double> tilts;  // [rad] of each box, ascending
  double resting = 0.0;       // boxes
};

Settled settled(int per_edge, int seed, double duration, const PlayedTechnique& technique) {
  // Cubes start as near to each other as they may, so that they meet soon.
  PlayedScene played(make_scene("fig6_7", {"per_edge=" + std::to_string(per_edge), "spacing=1.75"},
                                static_cast<std::uint64_t>(seed)),
                     technique, static_cast<std::uint64_t>(seed));
  played.advance(duration);
  Settled end;
  const World& world = played.world();
  for (std::size_t k = 0; k < world.bodies().size(); ++k) {
    if (!world.bodies()[k].movable()) continue;
    end.tilts.push_back(tilt_of(world.states()[k]));
    if (speed_of(world.bodies()[k], world.states()[k], world.gravity_w.norm()) < kSlow)
      end.resting += 1.0;
  }
  std::ranges::sort(end.tilts);
  return end;
}

double up_to(const Settled& clump, double tilt) {
  return static_cast<double>(std::upper_bound(clump.tilts.begin(), clump.tilts.end(), tilt) -
                             clump.tilts.begin());
}

// By seed: the clumps of this seed.
using Clumps = std::vector<std::vector<Settled>>;

// Of all boxes: the share that a count counts.
template <typename Count>
Quantity share_of(const std::string& name, const Clumps& clumps, const Count& count) {
  std::vector<double> hits;
  std::vector<double> boxes;
  for (const std::vector<Settled>& of_seed : clumps) {
    hits.push_back(0.0);
    boxes.push_back(0.0);
    for (const Settled& clump : of_seed) {
      hits.back() += count(clump);
      boxes.back() += static_cast<double>(clump.tilts.size());
    }
  }
  return ratio_of_sums(name, "-", hits, boxes);
}

Result measure_faces(const Parameters& settings) {
  const int smallest = settings.count("smallest");
  const int largest = settings.count("largest");
  const int seeds = settings.count("seeds");
  const double duration = settings.number("duration");
  const auto all = [&](const PlayedTechnique& technique, int first, int last) {
    Clumps clumps;
    for (int seed = first; seed <= last; ++seed) {
      clumps.emplace_back();
      for (int per_edge = smallest; per_edge <= largest; ++per_edge)
        clumps.back().push_back(settled(per_edge, seed, duration, technique));
    }
    return clumps;
  };
  const auto flat = [](const Settled& clump) { return up_to(clump, kFlat); };
  const Clumps coulomb = all({"contact_damped"}, 1, seeds);
  const Clumps damped = all({"damped"}, 1, settings.count("damped_seeds"));
  Result result;
  std::vector<Quantity>& out = result.quantities;
  out.push_back(
      share_of("share of the boxes of settled clumps that rest with a face down, within a degree",
               coulomb, flat));
  out.push_back(
      share_of("share of the boxes of settled clumps that rest with a face down, within a degree, "
               "fresh seeds",
               all({"contact_damped"}, seeds + 1, 2 * seeds), flat));
  const auto of_size = [&](int per_edge) {
    Clumps some;
    for (const std::vector<Settled>& of_seed : coulomb)
      some.push_back({of_seed[static_cast<std::size_t>(per_edge - smallest)]});
    return some;
  };
  for (int per_edge = smallest; per_edge <= largest; ++per_edge)
    out.push_back(share_of("the same, " + std::to_string(per_edge * per_edge * per_edge) + " boxes",
                           of_size(per_edge), flat));
  out.push_back(share_of("the same, within five degrees", coulomb,
                         [](const Settled& clump) { return up_to(clump, 5.0 * kDegree); }));
  out.push_back(share_of("the same, damped as in the thesis", damped, flat));
  const auto resting = [](const Settled& clump) { return clump.resting; };
  out.push_back(share_of("share of the boxes that rest in the end", coulomb, resting));
  out.push_back(share_of("share of the boxes that rest in the end, damped as in the thesis", damped,
                         resting));

  Table table{"",
              {{"tilt_deg", "deg", "between the vertical and the nearest axis of a box"},
               {"share", "-", "of the boxes with at most this tilt, contact_damped"},
               {"share_smallest", "-", "the same, smallest clumps only"},
               {"share_largest", "-", "the same, largest clumps only"},
               {"share_damped", "-", "of all boxes, damped as in the thesis"}}};
  constexpr int lines = 120;
  const Clumps small = of_size(smallest);
  const Clumps large = of_size(largest);
  for (int k = 0; k <= lines; ++k) {
    const double tilt = 0.01 * elementary::pow(6000.0, 1.0 * k / lines);
    const auto below = [&](const Settled& clump) { return up_to(clump, tilt * kDegree); };
    const auto share = [&](const Clumps& clumps) { return share_of("", clumps, below).value; };
    table.add(tilt, share(coulomb), share(small), share(large), share(damped));
  }
  result.tables = {table};
  return result;
}

const Registered claim_3_1a_faces_figure{
    {.name = "claim_3_1a_faces",
     .parameters = {whole("smallest", 2, 1, 10, "cubes along each edge of the smallest grid"),
                    whole("largest", 4, 1, 10, "cubes along each edge of the largest grid"),
                    number("duration", 7.0, 0.1, 100.0, "s", "until they have settled"),
                    whole("seeds", 20, 2, 1000, "clumps of each size"),
                    whole("damped_seeds", 5, 2, 1000, "the same, damped as in the thesis")},
     .quick = {"largest=2", "seeds=3", "damped_seeds=3", "duration=5"},
     .experiment = measure_faces}};

}  // namespace
}  // namespace tumble::chapters
