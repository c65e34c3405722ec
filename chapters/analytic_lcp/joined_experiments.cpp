/// \file
/// \brief A bounce, a sticky collision, rest, sliding and toppling in one world and one run (thesis 3.3.1).
#include "driver/csv.hpp"
#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

constexpr double kRestitution = 0.5;  // of the cube that bounces
constexpr double kFriction = 0.3;     // everywhere
constexpr double kSlideSpeed = 3.0;   // [m/s] of the cube that slides
constexpr double kStickSpeed = 0.1;   // [m/s] slower impacts stick
constexpr int kBounces = 6;           // of a drop from 1 m before an impact is as slow as that

// Their indices: the ground comes first.
enum Body : int { bouncer = 1, slider = 2, lowest = 3, highest = 5, post = 6, count = 7 };

SceneBox box_at(const Vec3& position_w, const Vec3& size, const std::string& name) {
  return {.name = name,
          .size = size,
          .mass = size.prod(),
          .position_w = position_w,
          .friction = kFriction};
}

// A cube in the air, one that slides, a stack of three, and a post that leans too far.
World five_things() {
  Scene scene{.title = "a cube that bounces, one that slides, a stack, and a post that falls over",
              .ground = SceneGround{kFriction, 0.0}};
  scene.boxes.push_back(box_at(Vec3(0.0, 1.5, 0.0), Vec3::Ones(), "bouncer"));
  scene.boxes.back().restitution = kRestitution;
  scene.boxes.push_back(box_at(Vec3(3.0, 0.5, 0.0), Vec3::Ones(), "slider"));
  scene.boxes.back().velocity_w = Vec3(kSlideSpeed, 0.0, 0.0);
  for (int k = 0; k < 3; ++k)
    scene.boxes.push_back(
        box_at(Vec3(-3.0, 0.5 + k, 0.0), Vec3::Ones(), "stack" + std::to_string(k + 1)));
  SceneBox leaning = box_at(Vec3::Zero(), Vec3(0.5, 2.0, 0.5), "post");
  leaning.orientation_wb = rotation_from_degrees(Vec3(0.0, 0.0, -20.0));
  const double reach_down =
      reach(make_box(Vec3::Zero(), leaning.orientation_wb, leaning.size), Vec3::UnitY());
  leaning.position_w = Vec3(8.0, reach_down, 0.0);
  scene.boxes.push_back(leaning);
  return build_world(scene);
}

const BodyState& state_of(const World& world, int body) { return world.states()[idx(body)]; }
double speed_of(const World& world, int body) {
  return velocity(world.bodies()[idx(body)], state_of(world, body)).norm();
}
double tilt_of(const World& world) {  // [deg] of the post's long axis from the vertical
  const Vec3 axis_w = state_of(world, post).orientation_wb * Vec3::UnitY();
  const double upwards = std::clamp(axis_w.y(), -1.0, 1.0);
  return std::acos(upwards) * 180.0 / std::acos(-1.0);
}

// Times of the bouncing cube's impacts.
class Watcher : public Observer {
 public:
  explicit Watcher(const World& world) : cube_(world.ids()[bouncer]) {}
  void on_event(const Event& event) override {
    if (event.second == cube_) impacts.push_back(event.time);
  }
  std::vector<double> impacts;  // [s]

 private:
  BodyId cube_;
};

// Largest distance of the impacts from t1 (1 + 2 (e + e² + ...)).
double worst_impact_time(const std::vector<double>& impacts) {
  if (impacts.size() < kBounces) return 1.0;
  double flight = std::sqrt(2.0 / kGravity);
  double exact = 0.0;
  double worst = 0.0;
  for (std::size_t k = 0; k < kBounces; ++k) {
    exact += flight;
    flight *= k == 0 ? 2.0 * kRestitution : kRestitution;
    worst = std::max(worst, std::abs(impacts[k] - exact));
  }
  return worst;
}

Result measure_joined(const Parameters& settings) {
  const double dt = settings.number("step");
  World world = five_things();
  const World start = world;
  const auto technique =
      make_technique("analytic", {"sticky=" + full_text(kStickSpeed / std::sqrt(kGravity)),
                                  "friction=coulomb", "resolution=1e-9"});
  Watcher watcher(world);
  technique->observe(&watcher);

  Table table{"",
              {{"time_s", "s", "time"},
               {"bouncer_m", "m", "height of the bouncing cube over the ground"},
               {"slider_m", "m", "way of the sliding cube"},
               {"stack_m", "m", "largest distance of a cube of the stack from its start"},
               {"post_deg", "deg", "tilt of the post"},
               {"energy_J", "J", "total energy"}}};
  double highest_gain = 0.0;
  double booked = 0.0;
  StepStatus worst = StepStatus::done;
  const auto row = [&] {
    double moved = 0.0;
    for (int k = lowest; k <= highest; ++k)
      moved =
          std::max(moved, (state_of(world, k).position_w - state_of(start, k).position_w).norm());
    table.add(world.time(), state_of(world, bouncer).position_w.y() - 0.5,
              state_of(world, slider).position_w.x() - 3.0, moved, tilt_of(world),
              energy_of(world).total());
    return moved;
  };
  double moved = row();
  const auto steps = static_cast<int>(std::lround(settings.number("duration") / dt));
  for (int k = 0; k < steps; ++k) {
    const double before = table.rows.back().back();
    const StepReport report = technique->step(world, dt);
    worst = std::max(worst, report.status);
    booked = report.energy.total();
    moved = row();
    highest_gain = std::max(highest_gain, table.rows.back().back() - before - booked);
  }

  // What each phase has to come to. Beside the closed forms stand the tolerances of the verdict.
  const double impact_error = worst_impact_time(watcher.impacts);
  const double way = kSlideSpeed * kSlideSpeed / (2.0 * kFriction * kGravity);
  const double way_error = std::abs(table.rows.back()[2] / way - 1.0);
  double fastest = 0.0;
  for (int k = bouncer; k < count; ++k) fastest = std::max(fastest, speed_of(world, k));
  const double lying = std::abs(tilt_of(world) - 90.0);
  const bool ended = worst == StepStatus::done;
  const bool bounce = ended && impact_error < 1e-6;
  const bool sticky = ended && watcher.impacts.size() == kBounces + 1 &&
                      std::abs(state_of(world, bouncer).position_w.y() - 0.5) < 1e-3;
  const bool rest = ended && moved < 1e-3 && fastest < 1e-6;
  const bool slide = ended && way_error < 0.01;
  const bool topple = ended && lying < 0.1;
  const int passed = int{bounce} + int{sticky} + int{rest} + int{slide} + int{topple};
  return {{table},
          {{"of five phases (bounce, sticky collision, rest, slide, topple), those that the joined "
            "simulator passes",
            "-", passed},
           {"bounce: largest error of six impact times", "s", impact_error},
           {"sticky collision: impacts until the cube rests", "-", watcher.impacts.size()},
           {"largest gain of energy in a step that is not booked", "J", highest_gain}}};
}

const Registered claim_3_3_1d_joined_figure{
    {.name = "claim_3_3_1d_joined",
     .parameters = {number("step", 1.0 / 60.0, 1e-4, 0.1, "s", "time step"),
                    number("duration", 5.0, 2.0, 60.0, "s", "length of the run")},
     .quick = {"duration=3.5"},
     .experiment = measure_joined}};

}  // namespace
}  // namespace tumble::chapters
