/// \file
/// \brief The chatter of each technique on a stack, a pyramid and a clump.
///
/// Each technique that has resting contact is tried with each scene, but for those that would take
/// minutes: Coulomb's friction in exact contact forces beyond a stack, and time stepping with 27 cubes.
#include "tumble/record/chatter.hpp"
#include "tumble/record/overlap.hpp"

#include "driver/experiment.hpp"
#include "driver/quick.hpp"
#include "support/test.hpp"

using namespace tumble::chapters;

namespace {

// Sums over the bodies that rest in both; lists in the order of ids.
std::vector<BodyChatter> resting_in_both(const std::vector<BodyChatter>& sums,
                                         const std::vector<BodyChatter>& more) {
  std::vector<BodyChatter> both;
  for (BodyChatter body : sums)
    for (const BodyChatter& other : more)
      if (other.id == body.id) {
        body.amplitude += other.amplitude;
        body.acceleration += other.acceleration;
        both.push_back(body);
      }
  return both;
}

double largest(const std::vector<BodyChatter>& bodies, double BodyChatter::*measure) {
  return bodies.empty() ? std::numeric_limits<double>::quiet_NaN() : largest_of(bodies, measure);
}

// What became of a scene that should come to rest. The same measure for all techniques:
// contact follows from the poses, within the distance of `tolerance::touching`.
struct ChatterRun {
  // Those that rest, half second by half second, from the settling to the end: see ChatterMeter.
  // Their measures are means over the half seconds.
  std::vector<BodyChatter> resting;
  int bodies = 0;                    // how many can move
  double displaced = 0.0;            // [m] from its start, of the centre that got farthest
  bool solved = true;                // false: a step was not solved, and nothing rests
  std::int64_t steps = 0;            // that were done
  std::int64_t capped = 0;           // steps that met the cap of events
  std::int64_t last_collisions = 0;  // that were resolved while the bodies were watched

  // The largest amplitude of a body that rests [m], NaN if nothing rests.
  [[nodiscard]] double amplitude() const { return largest(resting, &BodyChatter::amplitude); }
  // The largest acceleration of a body that rests [-], 1 is a free fall; NaN if nothing rests.
  [[nodiscard]] double acceleration() const { return largest(resting, &BodyChatter::acceleration); }
  // How many do not rest.
  [[nodiscard]] int restless() const { return bodies - static_cast<int>(resting.size()); }
};

// Simulates a scene of cubes with 60 steps a second and measures its chatter.
// settling: [s] before bodies should rest
// watched: [s] after that, half a second or more
ChatterRun chatter_of(const Scene& scene, const PlayedTechnique& played, double settling,
                      double watched, std::uint64_t seed = 1) {
  PlayedScene now(scene, played, seed);
  const std::vector<BodyState> start(now.world().states().begin(), now.world().states().end());
  ChatterRun run;
  for (const BodyProperties& body : now.world().bodies())
    if (body.movable()) ++run.bodies;
  const auto first = std::lround(settling / kStep);
  const auto half_seconds = std::lround(watched / kStep) / (ChatterMeter::kWindow - 1);
  const auto last = first + half_seconds * (ChatterMeter::kWindow - 1);
  OverlapMeter near;
  ChatterMeter meter;
  const auto look = [&] {
    near.look(now.world().bodies(), now.world().states());
    meter.add(now.world(), near.in_contact());
  };
  for (run.steps = 0; run.steps < last;) {
    if (run.steps == first) look();
    const StepReport report = now.Simulation::step(kStep);
    now.update_boxes();
    if (report.status >= StepStatus::unsolved) {
      run.solved = false;
      run.resting.clear();
      return run;
    }
    ++run.steps;
    if (report.status == StepStatus::event_cap) ++run.capped;  // shown in the table
    if (run.steps <= first) continue;
    run.last_collisions += report.events;
    look();
    if ((run.steps - first) % (ChatterMeter::kWindow - 1) != 0) continue;
    const std::vector<BodyChatter> each = meter.each(now.world().gravity_w.norm());
    run.resting =
        run.steps - first < ChatterMeter::kWindow ? each : resting_in_both(run.resting, each);
  }
  for (BodyChatter& body : run.resting) {
    body.amplitude /= static_cast<double>(half_seconds);
    body.acceleration /= static_cast<double>(half_seconds);
  }
  run.displaced = farthest_moved(start, now.world().states());
  return run;
}

// The stack and the pyramid begin up to 1 cm off their places, so that something has to settle.
ChatterRun on_stack(const PlayedTechnique& technique, std::uint64_t seed = 1) {
  const Scene scene = make_scene("stack", {"count=5", "scatter=0.01"}, seed);
  return chatter_of(scene, technique, 2.0, 1.0, seed);
}

ChatterRun on_pyramid(const PlayedTechnique& technique, std::uint64_t seed = 1) {
  const Scene scene = make_scene("pyramid", {"rows=5", "scatter=0.01"}, seed);
  return chatter_of(scene, technique, 2.0, 1.0, seed);
}

// The clump lies by five seconds or, with Coulomb's friction, seven: one of its cubes topples late.
ChatterRun on_clump(const PlayedTechnique& technique, int per_edge, std::uint64_t seed = 1,
                    double seconds = 5.0) {
  const Scene scene = make_scene("fig6_7", {"per_edge=" + std::to_string(per_edge)}, seed);
  return chatter_of(scene, technique, seconds, 1.0, seed);
}

// All rest where they should, and the one that shakes most does so by no more than a bound [m].
void check_pile(const ChatterRun& run, double bound) {
  CHECK(run.solved);
  CHECK(run.restless() == 0);
  CHECK(run.displaced <
        0.1);  // measured: 0.02 to 0.03 m, most of which is the fall by up to 1 cm each
  CHECK(run.amplitude() <= bound);
}

void check_clump(const ChatterRun& run, double bound) {
  CHECK(run.solved);
  CHECK(run.restless() == 0);
  CHECK(run.displaced > 1.0);  // it did fall: measured 1.6 to 5.1 m
  CHECK(run.amplitude() <= bound);
}

}  // namespace

TEST_CASE("Shock propagation holds a stack still; a pyramid and a clump shake by millimetres",
          "[reference][chatter][filtering]") {
  const PlayedTechnique impulse = {"impulse"};
  SECTION("stack") { check_pile(on_stack(impulse), 1e-8); }      // measured: 1.3e-10 m
  SECTION("pyramid") { check_pile(on_pyramid(impulse), 6e-3); }  // measured: 3.7e-3 m
  SECTION("clump") { check_clump(on_clump(impulse, 2), 6e-3); }  // measured: 3.7e-3 m
}

TEST_CASE("Damped integration leaves millimetres of chatter in a stack, a pyramid and a clump",
          "[reference][chatter][filtering]") {
  // From some starts it does not come to a dead stop; these are such. That it chatters at all is what
  // the lower bound says: if it ever stops, this test is to be written anew.
  const PlayedTechnique damped = {"damped"};
  ChatterRun run;
  SECTION("stack") {
    run = on_stack(damped, 1);
    check_pile(run, 6e-3);  // measured: 3.7e-3 m
  }
  SECTION("pyramid") {
    run = on_pyramid(damped, 3);
    check_pile(run, 5e-3);  // measured: 2.6e-3 m
  }
  SECTION("clump") {
    run = on_clump(damped, 3, 2);
    check_clump(run, 5e-3);  // measured: 2.8e-3 m
  }
  CHECK(run.amplitude() > 1e-3);
}

TEST_CASE("The printed listings of damped integration, repaired, chatter by as much, or fall",
          "[reference][chatter][filtering]") {
  const PlayedTechnique listings = {"damped", {"reading=as_printed", "repaired=all"}};
  SECTION("stack") { check_pile(on_stack(listings, 1), 6e-3); }      // measured: 3.8e-3 m
  SECTION("pyramid") { check_pile(on_pyramid(listings, 1), 5e-3); }  // measured: 2.8e-3 m
  SECTION("clump") { check_clump(on_clump(listings, 3, 8), 5e-3); }  // measured: 2.5e-3 m
  // Known to fail: from three of eight starts a box leaves the stack at more than 100 m/s.
  SECTION("a stack that falls") { CHECK(on_stack(listings, 2).displaced > 10.0); }
}

TEST_CASE("Stiff contact areas hold a stack, a pyramid and a clump within micrometres",
          "[reference][chatter][filtering]") {
  const PlayedTechnique areas = {"contact_damped"};
  SECTION("stack") { check_pile(on_stack(areas), 1e-7); }              // measured: 3.4e-9 m
  SECTION("pyramid") { check_pile(on_pyramid(areas), 1e-8); }          // measured: 2.7e-11 m
  SECTION("clump") { check_clump(on_clump(areas, 3, 1, 7.0), 1e-5); }  // measured: 1.3e-7 m
}

TEST_CASE("Exact contact forces with damping for friction do not shake a stack or a pyramid",
          "[reference][chatter][filtering]") {
  const PlayedTechnique analytic = {"analytic", {"friction=damping"}};
  SECTION("stack") { check_pile(on_stack(analytic), 1e-9); }      // measured: 2.4e-15 m
  SECTION("pyramid") { check_pile(on_pyramid(analytic), 1e-6); }  // measured: 8.7e-8 m, sliding
  SECTION("clump") {
    const ChatterRun run = on_clump(analytic, 2);
    check_clump(run, 1e-3);             // measured: 2.8e-4 m: it slides until it is slow enough
    CHECK(run.acceleration() <= 1e-3);  // [-] of free fall; measured: 1.6e-4
  }
}

TEST_CASE("Exact contact forces with Coulomb's friction do not shake a stack",
          "[reference][chatter][filtering]") {
  check_pile(on_stack({"analytic"}), 1e-9);  // measured: 1.7e-14 m
}

TEST_CASE("Time stepping does not shake a stack, a pyramid or a clump of eight",
          "[reference][chatter][filtering]") {
  const PlayedTechnique stepping = {"time_stepping"};
  SECTION("stack") { check_pile(on_stack(stepping), 1e-9); }      // measured: 3.7e-15 m
  SECTION("pyramid") { check_pile(on_pyramid(stepping), 1e-9); }  // measured: 1.0e-13 m
  SECTION("clump") { check_clump(on_clump(stepping, 2), 1e-9); }  // measured: 7.9e-15 m
}

TEST_CASE("Without resting contact a stack falls from impact to impact and meets the cap",
          "[reference][chatter][filtering]") {
  // basic has impacts and nothing else (2.1): a box that lies on another one collides with it without
  // end. Where a step has more collisions than its cap, the rest of it is flown through them.
  const ChatterRun run = on_stack({"basic"});
  CHECK(run.resting.empty());
  CHECK(run.capped > 20);           // of 180 steps; measured: 41
  CHECK(run.last_collisions > 60);  // in 60 steps; measured: 356
}

TEST_CASE(
    "Timewarps stop resting bodies at the end of each frame, and a stack creeps but does not shake",
    "[reference][chatter][filtering]") {
  // A timewarp is about the order of collisions (5.1) and has no resting contact either: pairs that
  // collide again and again are left to the frame's end and stopped there.
  for (const char* name :
       {"timewarp_simple", "timewarp_safer", "timewarp_swept", "timewarp_full"}) {
    INFO(name);
    const ChatterRun run = on_stack({name});
    CHECK(run.last_collisions > 60);  // in 60 steps; measured: 162 to 194
    CHECK(run.restless() == 0);
    CHECK(run.amplitude() > 1e-6);  // [m] measured: 3e-5 to 1.4e-4
    CHECK(run.amplitude() < 1e-3);
    CHECK(run.acceleration() < 1e-5);  // [-] of free fall; measured: 5e-8 to 7e-8
  }
}
