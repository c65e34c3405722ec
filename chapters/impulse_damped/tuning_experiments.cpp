/// \file
/// \brief Claim 2.5.2b: settings that carry three scenes, penalty forces against impulses.
#include "tumble/contact/effective_mass.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/dynamics/advance_pose.hpp"
#include "tumble/record/overlap.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

constexpr double kSlow = 0.02;     // [m/s] what is faster in the end does not rest
constexpr double kAside = 0.05;    // [m] a box of a stack that has gone so far has left it
constexpr double kVisible = 0.01;  // [m] an overlap that is seen, of edges of 1 m
constexpr std::array<double, 4> kRates{30.0, 60.0, 120.0, 240.0};  // [1/s] steps

// The three scenes: a cube that falls, turned; a stack of three; a light cube under a heavy one.
Scene tuning_scene(int number) {
  Scene scene{.ground = SceneGround{0.5, 0.0}};
  const int count = number == 0 ? 1 : 4 - number;
  for (int k = 0; k < count; ++k) {
    SceneBox box{.name = "cube" + std::to_string(k + 1),
                 .position_w = Vec3(0.0, 0.5 + k, 0.0),
                 .friction = 0.5};
    if (number == 2 && k == 1) box.mass = 100.0;
    scene.boxes.push_back(box);
  }
  if (number == 0) {
    const double angle = std::numbers::pi / 9.0;
    SceneBox& box = scene.boxes.front();
    box.orientation_wb = rotation_from_vector(Vec3(0.0, 0.0, angle));
    // Its lowest edge is half an edge above the ground.
    box.position_w.y() = 0.5 + 0.5 * (elementary::sin(angle) + elementary::cos(angle));
  }
  return scene;
}

// How a run ends.
struct Carried {
  bool carried = false;
  double deepest = 0.0;  // [m] overlap in any step
};

// The same judge for both: poses and speeds alone.
template <class Step>
Carried carry(int number, double rate, double duration, Step step) {
  const Scene scene = tuning_scene(number);
  World world = build_world(scene);
  OverlapMeter overlaps;
  Carried out;
  double last = 0.0;  // [m] overlap
  for (int k = 0; k < static_cast<int>(std::lround(duration * rate)); ++k) {
    step(world, 1.0 / rate);
    for (const BodyState& state : world.states())
      if (!state.position_w.allFinite() || !(state.position_w.norm() < 1e3)) return {false, 1.0};
    last = overlaps.look(world.bodies(), world.states());
    out.deepest = std::max(out.deepest, last);
  }
  out.carried = last <= kVisible;
  for (std::size_t k = 1; k < world.states().size(); ++k) {
    const Vec3 aside_w = world.states()[k].position_w - scene.boxes[k - 1].position_w;
    if (number > 0 && std::hypot(aside_w.x(), aside_w.z()) > kAside) out.carried = false;
    if (velocity(world.bodies()[k], world.states()[k]).norm() > kSlow) out.carried = false;
  }
  return out;
}

// Penalty forces as 2.5.1 describes them: at each point that overlaps a spring and a damper along the normal,
// and a damper across it up to Coulomb's limit.
class Springs {
 public:
  // stiffness: [N/m] of each point; damping: [-] share of the critical one of 1 kg
  Springs(double stiffness, double damping)
      : stiffness_(stiffness), damper_(2.0 * damping * std::sqrt(stiffness)) {}

  void operator()(World& world, double h) {
    load_moving_bodies(world, start_);
    for (std::size_t k = 0; k < start_.size(); ++k)
      if (world.bodies()[k].movable())
        world.states()[k].linear_momentum_w += world.bodies()[k].mass * h * world.gravity_w;
    load_moving_bodies(world, moving_);
    std::vector<IndexPair> pairs;
    for (int first = 0; first < world.count(); ++first)
      for (int second = first + 1; second < world.count(); ++second)
        pairs.push_back({first, second});
    gather_contacts(world, moving_, pairs, 0.0, {}, contacts_);
    for (const Contact& contact : contacts_)
      for (int k = 0; k < contact.count; ++k) push(contact, contact.points[idx(k)], h);
    store_moving_bodies(moving_, world);
    for (std::size_t k = 0; k < moving_.size(); ++k)
      if (world.bodies()[k].movable())
        advance_pose(world.bodies()[k], world.states()[k], h, RotationRule::splitting);
    world.finish_step(h);
  }

 private:
  void push(const Contact& contact, const ContactPoint& point, double h) {
    const Vec3 speed_w = relative_velocity(start_[idx(contact.first)], start_[idx(contact.second)],
                                           point.position_w);
    const double apart = contact.normal_w.dot(speed_w);
    const double force = std::max(0.0, -stiffness_ * point.distance - damper_ * apart);
    Vec3 force_w = force * contact.normal_w;
    const Vec3 slip_w = speed_w - apart * contact.normal_w;
    const double slip = slip_w.norm();
    if (slip > 0.0) force_w -= std::min(damper_ * slip, contact.friction * force) / slip * slip_w;
    apply_impulse(moving_[idx(contact.first)], moving_[idx(contact.second)], point.position_w,
                  h * force_w);
  }

  double stiffness_;  // [N/m]
  double damper_;     // [N s/m]
  std::vector<MovingBody> start_, moving_;
  ContactList contacts_;
};

// One setting in all scenes.
struct TuningSetting {
  int scenes = 0;        // of three that it carries
  bool alike = false;    // both scenes in which all cubes have the same mass
  double deepest = 0.0;  // [m] overlap in any step of any of them
};

template <class MakeStep>
TuningSetting attempt(double rate, double duration, const MakeStep& make_step) {
  TuningSetting out;
  for (int number = 0; number < 3; ++number) {
    const Carried run = carry(number, rate, duration, make_step());
    out.scenes += run.carried ? 1 : 0;
    if (number == 1) out.alike = out.scenes == 2;
    out.deepest = std::max(out.deepest, run.deepest);
  }
  return out;
}

TuningSetting impulses(const std::vector<std::string>& options, double rate, double duration) {
  return attempt(rate, duration, [&] {
    return [technique = std::shared_ptr<Technique>(make_technique("impulse", options))](
               World& world, double h) { finished(technique->step(world, h)); };
  });
}

template <class Carries>
double share_that(const std::vector<TuningSetting>& settings, const Carries& carries) {
  const auto some = std::ranges::count_if(settings, carries);
  return static_cast<double>(some) / static_cast<double>(settings.size());
}

bool carries_all(const TuningSetting& setting) { return setting.scenes == 3; }
bool carries_alike(const TuningSetting& setting) { return setting.alike; }

// All settings of penalty forces.
std::vector<TuningSetting> all_springs(double duration, double finer, Table* table) {
  std::vector<TuningSetting> out;
  for (int k = 4; k <= 12; ++k) {
    const double stiffness = elementary::pow(10.0, 0.5 * k);
    for (const double damping : {0.1, 0.5, 1.0}) {
      for (const double rate : kRates) {
        const TuningSetting now =
            attempt(finer * rate, duration, [&] { return Springs(stiffness, damping); });
        if (table != nullptr) table->add(stiffness, damping, rate, now.scenes, now.deepest);
        out.push_back(now);
      }
    }
  }
  return out;
}

Result measure_tuning(const Parameters& settings) {
  const double duration = settings.number("duration");
  Table springs{"",
                {{"stiffness", "N/m", "of each point"},
                 {"damping", "-", "share of the critical one of 1 kg"},
                 {"rate", "1/s", "steps"},
                 {"scenes", "-", "of three that the setting carries"},
                 {"deepest_m", "m", "overlap in any step"}}};
  Table passes{"impulse",
               {{"passes", "-", "of each kind"},
                {"rate", "1/s", "steps"},
                {"scenes", "-", "of three that the setting carries"},
                {"deepest_m", "m", "overlap in any step"}}};
  const std::vector<TuningSetting> of_springs = all_springs(duration, 1.0, &springs);
  const std::vector<TuningSetting> finer = all_springs(duration, 8.0, nullptr);
  std::vector<TuningSetting> of_impulses;
  for (const int count : {1, 2, 5, 10, 20}) {
    for (const double rate : kRates) {
      const std::string passes_of = "_passes=" + std::to_string(count);
      const TuningSetting now =
          impulses({"collision" + passes_of, "contact" + passes_of}, rate, duration);
      of_impulses.push_back(now);
      passes.add(count, rate, now.scenes, now.deepest);
    }
  }
  const double usual = impulses({}, 60.0, duration).deepest;
  const double penalty = share_that(of_springs, carries_all);
  const double impulse = share_that(of_impulses, carries_all);
  const int hold = (impulse >= 2.0 * penalty ? 1 : 0) + (usual <= kVisible ? 1 : 0);
  return {{springs, passes},
          {{"of two sayings about impulses those that hold: twice as large a share of the settings "
            "carries all three scenes as with penalty forces, and with the usual setting nothing "
            "ever overlaps by more than a hundredth of an edge",
            "-", hold},
           {"share of the settings that carry all three scenes, penalty forces", "-", penalty},
           {"the same, steps eight times as short", "-", share_that(finer, carries_all)},
           {"the same, steps eight times as short, without the heavy cube", "-",
            share_that(finer, carries_alike)},
           {"share of the settings that carry all three scenes, impulses", "-", impulse},
           {"deepest overlap with the usual setting of impulses", "mm", 1e3 * usual}}};
}

const Registered claim_2_5_2b_tuning_figure{
    {.name = "claim_2_5_2b_tuning",
     .parameters = {number("duration", 3.0, 0.1, 100.0, "s", "of each run")},
     .quick = {"duration=1"},
     .experiment = measure_tuning}};

}  // namespace
}  // namespace tumble::chapters
