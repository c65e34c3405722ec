/// \file
/// \brief The default technique: the impulses of a island.
#include "tumble/base/index.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/contact_damped/contact_damped.hpp"
#include "tumble/contact_damped/patch_solver.hpp"
#include "tumble/contact_damped/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

constexpr std::size_t kSmallIsland = 20;  // bodies of a island that is solved well at any speed
constexpr double kSoon = 0.05;        // of what a sweep found is left after the next: they soon end
constexpr double kWellSettled = 0.1;  // solving goes on to this share of what is none, to last
constexpr double kToTheEnd =
    1e-3;  // to this share in a small island: so well that rounding has no say
constexpr double kFair = 100.0;   // times what is none: as well as sweeps do what slides
constexpr double kWild = 1e6;     // times what is none: sweeps have lost their way
constexpr int kSmallRounds = 20;  // of friction and pressure in turn, in a small island
constexpr int kPatience = 3;      // times as many rounds for a small island
constexpr int kFewRounds = 20;    // for a island that hardly moves: a start for Newton's steps
constexpr int kFewSteps = 20;     // of Newton's in such a island
constexpr int kFewTurns = 3;     // in which impulses and shifts follow these; the next step goes on
constexpr int kSmallSteps = 50;  // of Newton's in a small island; they cost too much in a large one
constexpr int kSmallPasses = 50;  // over a small island
constexpr int kBlockRounds = 2;   // of friction and pressure in turn within an area; one in a hurry

// Kinetic energy of velocities, for the body's momenta: 1/2 v·P + 1/2 omega·L.
double energy_of(const BodyProperties& body, const Mat3& inertia_w, const MovingBody& moving) {
  return 0.5 * body.mass * moving.velocity_w.squaredNorm() +
         0.5 * moving.angular_velocity_w.dot(inertia_w * moving.angular_velocity_w);
}

// Velocities on the way from one state of motion to another.
void go_back(const MovingBody& from, double share, MovingBody& to) {
  to.velocity_w = from.velocity_w + share * (to.velocity_w - from.velocity_w);
  to.angular_velocity_w =
      from.angular_velocity_w + share * (to.angular_velocity_w - from.angular_velocity_w);
}

// The normal velocity with which a point hits, if it falls freely through its gap; 0 or above if it does not
// approach before gravity has acted: what rests does not hit.
double approach_of(const ContactPatchPoint& p, const Six& before, const Six& after, double dt) {
  const double start = before[2] + p.across * before[3] - p.along * before[4];
  const double end = after[2] + p.across * after[3] - p.along * after[4];
  if (start >= 0.0) return start;
  const double gained = -2.0 * (end - start) / dt * std::max(p.gap, 0.0);
  return -std::sqrt(std::max(start * start + gained, 0.0));
}

}  // namespace

// What gravity does in a step; without it a share of the smallest size of a island in a step.
double ContactDamped::speed_scale(const World& world, int island, double dt) const {
  const double g = world.gravity_w.norm();
  if (g > 0.0) return g * dt;
  return tolerance::weightless_speed * smallest(island) / dt;
}

// The shortest edge that touches another body.
double ContactDamped::smallest(int island) const {
  double size = std::numeric_limits<double>::infinity();
  for (const int contact : islands_.contacts(island))
    size = std::min(size, areas_.blocks()[at(contact)].size);
  return size;
}

// Once down through an area's order, or once up. Returns the largest correction [m/s].
double ContactDamped::sweep(std::span<const int> contacts, bool down, int rounds, double rest,
                            StepReport& report) {
  double most = 0.0;
  const std::size_t count = contacts.size();
  for (std::size_t k = 0; k < count; ++k) {
    ContactPatch& block = areas_.blocks()[at(contacts[down ? count - 1 - k : k])];
    most = std::max(most, solve_patch(block, bodies_[at(block.first)], bodies_[at(block.second)],
                                      rounds, rest));
  }
  ++report.iterations;
  report.impulses += static_cast<std::int64_t>(count);
  return most;
}

// How fast the fastest point of a island moves, as a share of sqrt(g L): when the step begins and with the
// impulses so far, the lower and the higher of the two. What lands is fast before and slow then; what
// impulses that are far from right throw about was slow.
std::pair<double, double> ContactDamped::unrest(const World& world, int island, double dt) const {
  double before = 0.0, now = 0.0;
  const double g = world.gravity_w.norm();
  for (const int k : islands_.bodies(island)) {
    const BodyProperties& body = world.bodies()[at(k)];
    const double size = body.size.minCoeff();
    const double limit = g > 0.0 ? std::sqrt(g * size) : tolerance::weightless_unit * size / dt;
    const auto fastest = [&](const MovingBody& moving) {
      return (moving.velocity_w.norm() +
              0.5 * body.size.norm() * moving.angular_velocity_w.norm()) /
             limit;
    };
    before = std::max(before, fastest(start_[at(k)]));
    now = std::max(now, fastest(bodies_[at(k)]));
  }
  return std::minmax(before, now);
}

// By how much this step speeds up the fastest point of a island that hardly moves [m/s].
double ContactDamped::swing(const World& world, int island, double dt) const {
  if (unrest(world, island, dt).second >= tolerance::quiet_speed) return 0.0;
  double most = 0.0;
  for (const int k : islands_.bodies(island)) {
    const MovingBody& before = start_[at(k)];
    const MovingBody& now = bodies_[at(k)];
    most = std::max(most, (now.velocity_w - before.velocity_w).norm() +
                              0.5 * world.bodies()[at(k)].size.norm() *
                                  (now.angular_velocity_w - before.angular_velocity_w).norm());
  }
  return most;
}

// A large island that moves too fast to care about the last digits.
bool ContactDamped::hurries(const World& world, int island, double dt) const {
  return islands_.bodies(island).size() > kSmallIsland &&
         unrest(world, island, dt).first >= tolerance::calm_speed;
}

// How hard the direct solver may make springs in a small island. What they leave in impulses that nothing
// determines, as in boxes that are wedged, is rounding enlarged by as much; but springs are measured by the
// two bodies that they join, and may have to carry heavier ones.
double ContactDamped::hardest(const World& world, int island) const {
  double lightest = std::numeric_limits<double>::infinity(), heaviest = 0.0;
  for (const int k : islands_.bodies(island)) {
    lightest = std::min(lightest, world.bodies()[at(k)].mass);
    heaviest = std::max(heaviest, world.bodies()[at(k)].mass);
  }
  return std::min(tolerance::island_stiffness * (heaviest / lightest), tolerance::island_hardness);
}

// Whether an area slides so fast that friction cannot stop it in a few steps, before and still.
bool ContactDamped::slides(std::span<const int> contacts, double unit) const {
  return std::any_of(contacts.begin(), contacts.end(), [&](int contact) {
    const ContactPatch& block = areas_.blocks()[at(contact)];
    if (!(impulse_of(block)[2] > 0.0 && block.friction > 0.0)) return false;
    const double limit = tolerance::island_slides * block.friction * unit;
    const auto slips = [&](const std::vector<MovingBody>& bodies) {
      const Six u = motion_of(block, bodies[at(block.first)], bodies[at(block.second)]);
      return u[0] * u[0] + u[1] * u[1] > limit * limit;
    };
    return slips(start_) && slips(bodies_);
  });
}

void ContactDamped::solve_island(const World& world, int island, double dt, StepReport& report) {
  const std::span<const int> contacts = ordered(island);
  if (contacts.empty()) return;
  const double enough = tolerance::contact_settled * speed_scale(world, island, dt);
  // [S6.3.1:island]
  // Begin with the impulses of the step before.
  for (const int contact : contacts) {
    ContactPatch& block = areas_.blocks()[at(contact)];
    const Six before = motion_of(block, start_[at(block.first)], start_[at(block.second)]);
    const Six after = motion_of(block, free_[at(block.first)], free_[at(block.second)]);
    for (std::size_t i = 0; i < at(block.count); ++i)
      block.points[i].approach = approach_of(block.points[i], before, after, dt);
    apply(impulse_of(block), block, bodies_[at(block.first)], bodies_[at(block.second)]);
  }
  // One sweep from the top down, as weight goes: at rest it finds nothing
  // to do. Another one up, as support goes, shows whether sweeps soon end.
  const bool small = islands_.bodies(island).size() <= kSmallIsland;
  const int rounds = small ? kSmallRounds : kBlockRounds;
  // What is left alone adds up from step to step, and a small island has no need of it.
  const double rest = small ? 0.0 : kWellSettled * enough;
  const double found = sweep(contacts, true, rounds, rest, report);
  // The impulses that have stopped a island would go on to push, and let it swing:
  // who was solved in the step before must be left as it is by them.
  const BodyId name = world.ids()[at(islands_.bodies(island).front())];
  const bool swings = found < enough &&
                      std::binary_search(unsettled_.begin(), unsettled_.end(), name) &&
                      swing(world, island, dt) > kWellSettled * enough;
  bool settled = found < enough && !swings;
  double left = settled ? 0.0 : sweep(contacts, false, rounds, rest, report);
  const bool soon = !swings && left < kSoon * found;
  // What moves fast or slides is swept on, down and up, which it does well.
  const auto [slowest, fastest] = settled ? std::pair(0.0, 0.0) : unrest(world, island, dt);
  const bool fast = slowest >= tolerance::calm_speed;
  const int passes = small ? std::max(options_.passes, kSmallPasses) : options_.passes;
  const auto sweep_on = [&] {
    for (int pass = 2; pass < passes && !settled; ++pass) {
      left = sweep(contacts, pass % 2 == 0, small || !fast ? rounds : 1, rest, report);
      settled = left < kWellSettled * enough;
    }
    settled = settled || left < kFair * enough;
  };
  const bool sliding = !settled && slides(contacts, enough / tolerance::contact_settled);
  if (fast || sliding || soon) sweep_on();
  // Light boxes under a heavy one may have been thrown about by sweeps, which is no start for others.
  else if (left > kWild * enough)
    forget(island);
  // If that was not enough, all areas are solved together, in a large island
  // only if it is slow. One that hardly moves gets few rounds, which would
  // not end, and few of Newton's steps, which do within some steps of time.
  const bool quiet = !small && fastest < tolerance::quiet_speed;
  if (!settled && options_.rounds > 0 && (small || !fast)) {
    IslandLimits limits;
    limits.enough = (small || quiet ? kToTheEnd : kWellSettled) * enough;
    limits.unit = enough / tolerance::contact_settled;
    limits.most_rounds = small   ? kPatience * options_.rounds
                         : quiet ? std::min(options_.rounds, kFewRounds)
                                 : options_.rounds;
    limits.most_work = tolerance::island_work;
    limits.hardest = small ? hardest(world, island) : tolerance::island_hardness;
    limits.most_steps = small ? kSmallSteps : quiet ? kFewSteps : 0;
    if (quiet) {
      limits.loose = tolerance::contact_damped_slop * smallest(island) / dt;
      limits.most_turns = kFewTurns;
    }
    const IslandResult solved =
        island_solver_.solve(islands_.bodies(island), islands_.contacts(island), limits, free_,
                             areas_.blocks(), bodies_);
    report.iterations += solved.rounds;
    report.pivots += solved.factorings;
    settled = solved.tried;
    if (solved.tried) unsettling_.push_back(name);
  }
  if (!fast && !sliding && !soon) sweep_on();
  // [S6.3.1:island]
  release(island);
  guard_energy(world, island, report);
}

// Back to no impulses at all.
void ContactDamped::forget(int island) {
  for (const int contact : islands_.contacts(island)) {
    ContactPatch& block = areas_.blocks()[at(contact)];
    block.along_impulse = block.across_impulse = block.twist_impulse = 0.0;
    for (ContactPatchPoint& p : block.points) {
      p.impulse = 0.0;
      p.given.setZero();
    }
  }
  for (const int k : islands_.bodies(island)) bodies_[at(k)] = free_[at(k)];
}

// Bodies that nothing pushes move as if there were no contact: what was given and taken back leaves rounding.
void ContactDamped::release(int island) {
  for (const int contact : islands_.contacts(island)) {
    const ContactPatch& block = areas_.blocks()[at(contact)];
    const bool pushes = std::any_of(block.points.begin(), block.points.begin() + block.count,
                                    [](const ContactPatchPoint& p) { return p.impulse > 0.0; });
    if (!pushes) continue;
    flies_[at(block.first)] = 0;
    flies_[at(block.second)] = 0;
  }
  for (const int k : islands_.bodies(island))
    if (flies_[at(k)] != 0) bodies_[at(k)] = free_[at(k)];
}

// Impulses that are not quite solved could raise the kinetic energy. Then they are drawn back to where they
// do not: the energy is a parabola in their share, and no share is none.
void ContactDamped::guard_energy(const World& world, int island, StepReport& report) {
  double before = 0.0, after = 0.0, halfway = 0.0;
  for (const int k : islands_.bodies(island)) {
    if (bodies_[at(k)].inverse_mass.x() == 0.0) continue;
    const BodyProperties& body = world.bodies()[at(k)];
    const Mat3 axes_w = world.states()[at(k)].orientation_wb.toRotationMatrix();
    const Mat3 inertia_w = axes_w * body.inertia_b.asDiagonal() * axes_w.transpose();
    before += energy_of(body, inertia_w, free_[at(k)]);
    after += energy_of(body, inertia_w, bodies_[at(k)]);
    MovingBody middle = bodies_[at(k)];
    go_back(free_[at(k)], 0.5, middle);
    halfway += energy_of(body, inertia_w, middle);
  }
  if (after <= before * (1.0 + tolerance::energy_rounding)) return;
  // E(t) = before + b t + a t², E(1) = after, E(1/2) = halfway.
  const double a = 2.0 * (before + after - 2.0 * halfway);
  const double share = std::clamp(1.0 - (after - before) / a, 0.0, 1.0);
  for (const int k : islands_.bodies(island)) go_back(free_[at(k)], share, bodies_[at(k)]);
  for (const int contact : islands_.contacts(island)) {
    ContactPatch& block = areas_.blocks()[at(contact)];
    block.along_impulse *= share;
    block.across_impulse *= share;
    block.twist_impulse *= share;
    for (std::size_t i = 0; i < at(block.count); ++i) {
      block.points[i].impulse *= share;
      block.points[i].given *= share;
    }
  }
  ++report.fallbacks;
}

}  // namespace tumble
