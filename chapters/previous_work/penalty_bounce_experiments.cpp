/// \file
/// \brief Length of a bounce on springs, and passage through a plate (thesis 2.5.1).
#include "tumble/previous_work/penalty.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

constexpr int kSubsteps = 8;  // of the default options; each is a step of its own here
constexpr double kSubstep = kStep / kSubsteps;
// The last one is the thesis's (3.3.2), and the one of the bounce that is judged: without any, a cube stays down.
constexpr std::array<double, 3> kRestitutions = {0.0, 0.5, 0.9};

// A cube that falls from a height on the ground, substep by substep: the bits are those of the default options.
class DroppedCube {
 public:
  explicit DroppedCube(double height, double restitution) : technique_({.substeps = 1}) {
    world_.add_ground();
    BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
    cube.restitution = restitution;
    world_.add(cube, Vec3(0.0, 0.5 + height, 0.0));
  }
  void step() { finished(technique_.step(world_, kSubstep)); }
  [[nodiscard]] bool touches() const { return !technique_.contacts().empty(); }
  [[nodiscard]] double time() const { return world_.time(); }
  // [m] of its lower face
  [[nodiscard]] double height() const { return world_.states()[1].position_w.y() - 0.5; }

 private:
  World world_;
  Penalty technique_;
};

// The first bounce of a dropped cube.
struct Bounce {
  int substeps = 0;      // in contact
  int frames = 0;        // with a substep in contact
  double deepest = 0.0;  // [m]
};

Bounce first_bounce(double restitution) {
  DroppedCube cube(1.0, restitution);
  Bounce bounce;
  bool last_frame_touched = false;
  for (int k = 0; k < 20 * kSubsteps * 60; ++k) {
    if (k % kSubsteps == 0) last_frame_touched = false;
    cube.step();
    if (!cube.touches() && bounce.substeps > 0) break;
    if (!cube.touches()) continue;
    ++bounce.substeps;
    bounce.frames += last_frame_touched ? 0 : 1;
    last_frame_touched = true;
    bounce.deepest = std::max(bounce.deepest, -cube.height());
  }
  return bounce;
}

// Heights against time for a restitution in each column.
Table bounce_table() {
  Table table{"bounce", {{"time_s", "s", "from the start"}}};
  std::vector<DroppedCube> cubes;
  for (const double restitution : kRestitutions) {
    table.columns.push_back({"e" + std::to_string(std::lround(10.0 * restitution)), "m",
                             "height of the lower face, restitution " + short_text(restitution)});
    cubes.emplace_back(1.0, restitution);
  }
  for (int k = 0; k < 2 * 60 * kSubsteps; ++k) {
    std::vector<double> heights;
    for (DroppedCube& cube : cubes) {
      cube.step();
      heights.push_back(cube.height());
    }
    table.add(cubes.front().time(), heights);
  }
  return table;
}

// How long a stack of ten, which only touches at the start, still has a box faster than a centimetre a second.
// Returns [s]
double swings(double duration) {
  PlayedScene run(make_scene("stack", {"count=10"}), PlayedTechnique{"penalty"});
  double last = 0.0;
  run.advance(duration, [&](const StepReport&) {
    for (std::size_t k = 0; k < run.world().states().size(); ++k)
      if (velocity(run.world().bodies()[k], run.world().states()[k]).norm() > 0.01)
        last = run.world().time();
  });
  return last;
}

constexpr double kEdge = 0.2;  // [m] of the cube that is shot

// Whether a cube that is shot down at a plate comes out below.
bool passes(double thickness, double speed) {
  World world;
  world.add(fixed_box_properties(Vec3(2.0, thickness, 2.0)), Vec3(0.0, -0.5 * thickness, 0.0));
  world.add(box_properties(Vec3::Constant(kEdge), 1.0), Vec3(0.0, 0.5 * kEdge + 0.01, 0.0),
            Quat::Identity(), Vec3(0.0, -speed, 0.0));
  Penalty technique;
  for (int k = 0; k < 120; ++k) {
    finished(technique.step(world, kStep));
    const double height = world.states()[1].position_w.y();
    if (height < -thickness - 0.5 * kEdge) return true;
    if (height > 0.5 * kEdge && world.states()[1].linear_momentum_w.y() > 0.0) return false;
  }
  return world.states()[1].position_w.y() < -0.5 * thickness;
}

// The lowest speed at which it does, to two per cent [m/s].
double passing_speed(double thickness) {
  double speed = 10.0;
  while (speed < 1e4 && !passes(thickness, speed)) speed *= 1.02;
  return speed;
}

Result measure_bounce(const Parameters& settings) {
  Result result;
  result.tables.push_back(Table{"",
                                {{"thickness_m", "m", "of the plate"},
                                 {"speed_m_s", "m/s", "from which a cube passes"},
                                 {"law_m_s", "m/s", "for one that is critically damped"}}});
  // The direction of the push turns round when the centres have passed each other: at half of both.
  const double omega = std::sqrt(kGravity / (0.01 * kEdge));
  for (const double thickness : {0.01, 0.02, 0.05, 0.1, 0.2, 0.5}) {
    if (thickness > settings.number("thickest")) break;
    const double speed = passing_speed(thickness);
    const double law = 0.5 * (thickness + kEdge) * omega * std::numbers::e;
    result.tables[0].add(thickness, speed, law);
    if (thickness == 0.02)
      result.add("speed from which a cube passes a plate of 2 cm", "m/s", speed);
    if (thickness == 0.2)
      result.add("speed from which a cube passes a plate of 20 cm", "m/s", speed);
  }
  result.tables.push_back(bounce_table());
  const Bounce bounce = first_bounce(kRestitutions.back());
  result.add("frames of 1/60 s in contact in the first bounce of a cube on its default springs",
             "-", bounce.frames);
  result.add("substeps in contact in that bounce", "-", bounce.substeps);
  result.add("depth of that bounce", "m", bounce.deepest);
  result.add("time for which ten boxes swing faster than 1 cm/s", "s",
             swings(settings.number("duration")));
  return result;
}

const Registered penalty_bounce_figure{
    {.name = "claim_2_5_1b_penalty_bounce",
     .parameters = {number("duration", 20.0, 1.0, 100.0, "s", "of the stack at most"),
                    number("thickest", 0.5, 0.01, 0.5, "m", "plate at most")},
     .quick = {"duration=1", "thickest=0.02"},
     .experiment = measure_bounce}};

}  // namespace
}  // namespace tumble::chapters
