/// \file
/// \brief One rotation for the group, one for each body, or a tree of pivots: figure 6.3 (claim 6.2c).
#include "tumble/exterior_rotation/glued.hpp"

#include "exterior_rotation/best_frame.hpp"
#include "exterior_rotation/glued_runs.hpp"

namespace tumble::chapters {
namespace {

// Chosen before the first run. All ways move with the velocities at the start of the step. The gap of a
// joint is the distance of its two material points, at the middle of its edge, after the step; of the two
// joints the larger counts. The single rotation is a frame with one centre c and one rate Omega for both
// boxes, see moved_in_frame(): orientations turn at their own rates, or nothing would be left of the
// scene's motion. One rotation for each body is the exponential of its own twist. What a tree of pivots
// leaves instead, which is what the option `pose=exponential` of the techniques makes, is measured beside.
constexpr double kWidest = 30.0;  // [rad/s] of the frames that are tried

struct Spins {
  double lower = 0.0;  // [rad/s]
  double upper = 0.0;
};
constexpr std::array kSpins = {Spins{-1.5, 1.5}, Spins{-1.5, -1.0}, Spins{-6.0, 2.0},
                               Spins{-0.3, 9.0}};

constexpr Spins kSlowBelow{-0.3, -9.0};  // over a lower box that hardly turns

// Figure 6.3 at one instant.
struct NestedInstant {
  World world;
  std::vector<Joint> joints;  // lower, upper
  Vec3 pivot_w = Vec3::Zero();
  Vec3 lower_spin_w = Vec3::Zero();
  double spin_apart = 0.0;   // [rad/s] |Δω|
  double joint_speed = 0.0;  // [m/s] |v_p| of the upper joint

  explicit NestedInstant(const Scene& scene) : world(build_world(scene)) {
    Glued glued;
    glued.find(world);
    joints.assign(glued.joints().begin(), glued.joints().end());
    pivot_w = held_point(joints[0], world.states()).first_w;
    const auto index = [&](const char* name) {
      return static_cast<std::size_t>(world.index_of(*world.find(std::string_view(name))));
    };
    const auto spin = [&](std::size_t k) {
      return angular_velocity(world.bodies()[k], world.states()[k]);
    };
    lower_spin_w = spin(index("lower"));
    spin_apart = (spin(index("upper")) - lower_spin_w).norm();
    joint_speed =
        lower_spin_w.cross(held_point(joints[1], world.states()).first_w - pivot_w).norm();
  }

  [[nodiscard]] double predicted(double dt) const {
    return 0.5 * dt * dt * spin_apart * joint_speed;
  }
};

NestedInstant nested(const Spins& spins) {
  return NestedInstant(make_scene(
      "fig6_3", {setting("lower_spin", spins.lower), setting("upper_spin", spins.upper)}));
}

// Mismatch that each way of moving leaves in a step.
struct Left {
  double straight = 0.0;  // [m] centre and orientation apart
  double pivot = 0.0;     // [m] the frame of the lower box
  double best = 0.0;      // [m] the best frame
  double own = 0.0;       // [m] one twist for each body
  double tree = 0.0;      // [m]
};

Left left_in_step(const NestedInstant& scene, double dt) {
  const auto after = [&](const std::vector<BodyState>& states) {
    return mismatch(scene.joints, states);
  };
  return {after(moved_in_frame(scene.world, GroupFrame{}, dt)),
          after(moved_in_frame(scene.world, {scene.pivot_w, scene.lower_spin_w}, dt)),
          best_frame(scene.world, scene.joints, dt, kWidest).left,
          after(moved_by_own_twist(scene.world, dt)),
          after(moved_in_tree(scene.world, scene.joints, dt))};
}

// The mismatch with one twist for each body, by spins and step.
Table step_table(const std::vector<double>& dts, std::vector<double>& first,
                 double& worst_at_finest) {
  Table table{
      "",
      {{"spins", "-", "1 to 4: spins of the lower and the upper box, see the picture's legend"},
       {"step_s", "s", "length of the step"},
       {"measured_m", "m", "mismatch of the joints after it, one twist for each body"},
       {"predicted_m", "m", "half h² |Δω| |v_p|"},
       {"ratio", "-", "measured over predicted"}}};
  for (std::size_t s = 0; s < kSpins.size(); ++s) {
    const NestedInstant scene = nested(kSpins[s]);
    for (const double dt : dts) {
      const double measured = mismatch(scene.joints, moved_by_own_twist(scene.world, dt));
      const double ratio = measured / scene.predicted(dt);
      table.add(s + 1, dt, measured, scene.predicted(dt), ratio);
      if (dt == dts.front()) worst_at_finest = std::max(worst_at_finest, std::abs(ratio - 1.0));
      if (s == 0) first.push_back(measured);
    }
  }
  return table;
}

// Whether one frame leaves ten times what frames within frames leave, and a hundred-thousandth of an edge or more,
// for random spins: a second measurement of the claim.
Quantity frames_within_frames(double dt) {
  constexpr int kPairs = 100;
  constexpr double kSeen = 1e-5;     // [m] on edges of a metre, in a step
  constexpr double kFastest = 10.0;  // [rad/s]
  Random random(1);
  std::int64_t apart = 0;
  for (int k = 0; k < kPairs; ++k) {
    const double lower = random.uniform(-kFastest, 0.0);  // what the scene allows
    const double upper = random.uniform(-kFastest, kFastest);
    const Left left = left_in_step(nested({lower, upper}), dt);
    if (left.best >= kSeen && left.best >= 10.0 * left.tree) ++apart;
  }
  return share_of_trials(
      "share of random spins of figure 6.3 for which the best single frame leaves ten times what "
      "frames within frames leave, and a hundred-thousandth of an edge or more",
      apart, kPairs);
}

Result measure_one_pivot(const Parameters& settings) {
  const double dt = 1.0 / settings.number("rate");
  const int count = settings.count("spins");
  const std::vector<double> dts = log_spaced(1.0 / 2000.0, 1.0 / 20.0, settings.count("steps"));
  std::vector<double> first;  // [m] for the spins of figure 6.3
  double worst_at_finest = 0.0;
  const Table steps = step_table(dts, first, worst_at_finest);

  Table spins{"spins",
              {{"upper_rad_s", "rad/s", "spin of the upper box, anticlockwise"},
               {"straight_m", "m", "centres on straight lines"},
               {"pivot_m", "m", "the lower box's rotation for the whole group"},
               {"best_m", "m", "the best single rotation for the group"},
               {"own_m", "m", "one twist for each body"},
               {"tree_m", "m", "a tree of pivots"}}};
  const auto drawn = [](double left) { return std::max(left, kNearNothing); };
  double largest_ratio = 0.0;
  for (int k = 0; k < count; ++k) {
    const double upper = -10.0 + 20.0 * k / (count - 1);
    const Left left = left_in_step(nested({kSpins[0].lower, upper}), dt);
    spins.add(upper, drawn(left.straight), drawn(left.pivot), drawn(left.best), drawn(left.own),
              drawn(left.tree));
    largest_ratio = std::max(largest_ratio, left.best / left.own);
  }

  const NestedInstant scene = NestedInstant(make_scene("fig6_3"));
  const Left left = left_in_step(scene, dt);
  const Left slow = left_in_step(nested(kSlowBelow), dt);
  return {
      {steps, spins},
      {{"gap or overlap that the best single rotation leaves in a step of figure 6.3 at 60 steps a "
        "second, over what one rotation for each body leaves",
        "-", left.best / left.own},
       frames_within_frames(dt),
       {"what the best single rotation leaves", "m", left.best},
       {"what one twist for each body leaves", "m", left.own},
       {"half h² |Δω| |v_p|", "m", scene.predicted(dt)},
       {"what a tree of pivots leaves", "m", left.tree},
       {"the same ratio for spins of -0.3 and -9 rad/s", "-", slow.best / slow.own},
       {"largest ratio of the best single rotation to one twist each, upper box within 10 rad/s",
        "-", largest_ratio},
       {"order of the mismatch in the step, one twist each", "-", fitted_order(dts, first)},
       {"largest error of the prediction in the shortest step, over it", "-", worst_at_finest}}};
}

const Registered claim_6_2c_one_pivot_figure{
    {.name = "claim_6_2c_one_pivot",
     .parameters = {number("rate", 60.0, 1.0, 1e4, "1/s", "steps a second, of the comparison"),
                    whole("steps", 12, 2, 100, "lengths of a step"),
                    whole("spins", 100, 2, 1000, "of the upper box, from -10 to 10 rad/s")},
     .quick = {"spins=10", "steps=6"},
     .experiment = measure_one_pivot}};

}  // namespace
}  // namespace tumble::chapters
