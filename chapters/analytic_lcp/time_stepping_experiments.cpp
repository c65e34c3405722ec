/// \file
/// \brief Time stepping without events, and on random problems with friction.
#include "tumble/analytic_lcp/time_stepping.hpp"

#include "analytic_lcp/painleve_rod.hpp"
#include "driver/touching.hpp"

namespace tumble::chapters {
namespace {

// A stack of cubes of 1 m, and one of half a metre that flies into it, a little off its middle plane.
World stack_and_projectile(int cubes, double speed, double height, double aside) {
  World world;
  world.add_ground();
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  for (int k = 0; k < cubes; ++k) world.add(cube, Vec3(0.0, k + 0.5, 0.0));
  const BodyProperties shot = box_properties(Vec3::Constant(0.5), 1.0);
  world.add(shot, Vec3(-4.0, height, aside), Quat::Identity(), Vec3(speed, 2.0, 0.0));
  return world;
}

struct Shots {
  int steps = 0;
  int unsolved = 0;
  int deep = 0;  // steps that left an overlap above 1 % of the smaller cube's edge
};

void shoot(World world, double duration, Shots& shots, Table* table) {
  TimeSteppingOptions options;
  options.velocities.directions = 4;  // as Stewart and Trinkle, and as measured at first
  TimeStepping technique(options);
  const double edge = 0.5;  // [m]
  const int steps = static_cast<int>(std::lround(duration / kStep));
  for (int k = 0; k < steps; ++k) {
    const StepReport report = technique.step(world, kStep);
    ++shots.steps;
    const double overlap = report.deepest_overlap / edge;
    const double error = technique.velocities().residual;
    if (report.status != StepStatus::done) {
      ++shots.unsolved;
      world.finish_step(kStep);
    }
    if (overlap > 0.01) ++shots.deep;
    if (table != nullptr) table->add(world.time(), 100.0 * overlap, std::max(error, 1e-17));
  }
}

BodyState random_motion(Random& random, const BodyProperties& body, const Vec3& place_w,
                        const Quat& turned) {
  const Vec3 velocity_w = random.in_cube(2.0);
  const Vec3 spin_w = random.in_cube(2.0);
  return make_state(body, place_w, turned, velocity_w, spin_w);
}

// Boxes anywhere, the first one fixed, with one to eight points anywhere between them.
Instant random_points(Random& random) {
  Instant instant;
  const BodyProperties fixed = fixed_box_properties(Vec3::Ones());
  instant.world.add(fixed, Vec3::Zero());
  for (int k = 0; k < 3; ++k) {
    const Vec3 size = Vec3::Ones() + random.in_cube(0.5);
    const BodyProperties body = box_properties(size, random.uniform(0.5, 2.0));
    const Vec3 place_w = random.in_cube(1.0);
    const Quat turned = random.orientation();
    instant.world.add(body, random_motion(random, body, place_w, turned));
  }
  const int count = 1 + static_cast<int>(random.below(8));
  for (int k = 0; k < count; ++k) {
    Contact contact{.first = static_cast<int>(random.below(3))};
    contact.second = contact.first + 1 +
                     static_cast<int>(random.below(static_cast<std::uint32_t>(3 - contact.first)));
    contact.normal_w = random.direction();
    contact.friction = random.uniform(0.0, 2.0);
    contact.count = 1;
    contact.points[0].position_w = random.in_cube(1.0);
    instant.contacts.push_back(contact);
  }
  add_gravity(instant);
  return instant;
}

// Three cubes, one on two, with four points to a face, turned by up to a millionth and moving anyhow.
Instant random_bricks(Random& random) {
  Instant instant;
  const double friction = random.uniform(0.05, 2.0);
  instant.world.add_ground(friction);
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, friction);
  const std::array<Vec3, 3> places = {Vec3(-0.52, 0.5, 0.0), Vec3(0.52, 0.5, 0.0),
                                      Vec3(0.0, 1.5, 0.0)};
  for (const Vec3& place_w : places) {
    const Vec3 axis = random.in_cube(1e-6);
    const Quat turned = Quat(1.0, axis.x(), axis.y(), axis.z()).normalized();
    instant.world.add(cube, random_motion(random, cube, place_w, turned));
  }
  add_gravity(instant);
  gather_contacts(instant.world, instant.bodies, all_pairs(instant.world), 1e-3, {},
                  instant.contacts);
  return instant;
}

VelocityStepResult step(Instant& instant) {
  return VelocityStep().solve(instant.world, instant.free, instant.contacts, kStep,
                              {.directions = 4, .form = SteppingForm::anitescu_potra},
                              instant.bodies);
}

// Counts answers by the power of ten of their error; the first class has all below 1e-16.
class Errors {
 public:
  void add(const VelocityStepResult& result) {
    ++count;
    if (!result.solved || result.fallbacks > 0) {  // no bounces here: Lemke's method had no answer
      ++unsolved;
      return;
    }
    int power = 0;
    for (double limit = 1e-16; power < kClasses - 1 && result.residual > limit; limit *= 10.0)
      ++power;
    ++classes[static_cast<std::size_t>(power)];
  }

  static constexpr int kClasses = 10;  // up to 1e-7, what is accepted
  int count = 0;
  int unsolved = 0;
  std::array<int, kClasses> classes{};
};

Result measure_no_events(const Parameters& settings) {
  Table run{"",
            {{"time_s", "s", "end of the step"},
             {"overlap_percent", "%", "deepest overlap over the smaller cube's edge"},
             {"error", "-", "of the velocities, over the fastest; 1e-17 for none"}}};
  Random random(263);
  const int cubes = settings.count("cubes");
  Shots all;
  for (int k = 0; k < settings.count("shots"); ++k) {
    const double speed = k == 0 ? 12.0 : random.uniform(5.0, 20.0);
    const double height = k == 0 ? 1.3 : random.uniform(0.5, cubes - 1.0);
    const double aside = k == 0 ? 0.1 : random.uniform(-0.5, 0.5);
    shoot(stack_and_projectile(cubes, speed, height, aside), settings.number("duration"), all,
          k == 0 ? &run : nullptr);
  }
  const double failed = static_cast<double>(all.unsolved + all.deep) / all.steps;
  return {{run},
          {{"steps that were not solved or left an overlap above 1 % of the size, over all steps",
            "-", failed},
           {"steps with an overlap above 1 %", "-", all.deep}}};
}

const Registered claim_2_6_3a_no_events_figure{
    {.name = "claim_2_6_3a_no_events",
     .parameters = {whole("cubes", 4, 2, 10, "in the stack"),
                    number("duration", 3.0, 0.1, 60.0, "s", "of each run"),
                    whole("shots", 10, 1, 1000, "the first one is drawn, the others are random")},
     .quick = {"duration=1", "shots=2", "cubes=3"},
     .experiment = measure_no_events}};

Result measure_always_solved(const Parameters& settings) {
  Random random(static_cast<std::uint64_t>(settings.count("seed")));
  Errors points;
  Errors bricks;
  for (int k = 0; k < settings.count("problems"); ++k) {
    Instant instant = k % 2 == 0 ? random_points(random) : random_bricks(random);
    (k % 2 == 0 ? points : bricks).add(step(instant));
  }
  Errors rods;
  for (int degrees = 5; degrees <= 85; degrees += 5)
    for (int tenths = 0; tenths <= 30; tenths += 2)
      for (const double spin : {-5.0, 0.0, 2.0, 5.0}) {
        Instant instant = rod_on_end({degrees * std::numbers::pi / 180.0, 0.1 * tenths, spin});
        rods.add(step(instant));
      }

  Table errors{"",
               {{"power", "-", "errors up to ten to this power"},
                {"points_percent", "%", "share of the random points"},
                {"bricks_percent", "%", "share of the bricks"},
                {"rods_percent", "%", "share of the rods"}}};
  for (int k = 0; k < Errors::kClasses; ++k) {
    const auto share = [k](const Errors& e) {
      return 100.0 * e.classes[static_cast<std::size_t>(k)] / std::max(e.count, 1);
    };
    errors.add(k - 16.0, share(points), share(bricks), share(rods));
  }
  const double all = points.count + bricks.count + rods.count;
  const double unsolved = points.unsolved + bricks.unsolved + rods.unsolved;
  return {{errors},
          {{"problems that were not solved over all problems", "-", unsolved / all},
           {"bricks not solved", "-", bricks.unsolved}}};
}

const Registered claim_2_6_3b_always_solved_figure{
    {.name = "claim_2_6_3b_always_solved",
     .parameters = {whole("problems", 10000, 2, 1000000, "random ones, half of each kind"),
                    whole("seed", 2, 0, 1000000000, "of the random problems")},
     .quick = {"problems=400"},
     .experiment = measure_always_solved}};

}  // namespace
}  // namespace tumble::chapters
