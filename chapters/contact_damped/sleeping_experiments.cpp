/// \file
/// \brief Work of a step against the share of boxes that move, and waking (thesis 4.5).
#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

constexpr double kGap = 0.2;      // [m] between stacks of cubes of 1 m
constexpr double kAsleep = 2.0;   // [s] by when stacks that stand sleep
constexpr double kPushed = 0.25;  // [s] for which work is counted after the push

// Stacks of cubes in a row along x, each in a lane of its own along z.
Scene stacks(int count, int boxes) {
  Scene scene{.title = "stacks side by side", .ground = SceneGround{0.5, 0.0}};
  for (int s = 0; s < count; ++s)
    for (int level = 0; level < boxes; ++level) {
      SceneBox box{.name = "stack" + std::to_string(s + 1) + "_" + std::to_string(level + 1),
                   .position_w = Vec3((1.0 + kGap) * s, 0.5 + level, 0.0)};
      scene.boxes.push_back(box);
    }
  return scene;
}

double asleep(const World& world) {
  return static_cast<double>(std::count_if(world.sleep_states().begin(), world.sleep_states().end(),
                                           [](const SleepState& rest) { return rest.asleep; }));
}

// Mean work of a step while some stacks slide along their lanes and the others rest.
struct Work {
  double pair_tests = 0.0;
  double impulses = 0.0;
  double integrations = 0.0;
  [[nodiscard]] double all() const { return pair_tests + impulses + integrations; }
};

Work work_of(const Parameters& settings, int moving, const PlayedTechnique& technique) {
  const int boxes = settings.count("boxes");
  PlayedScene played(stacks(settings.count("stacks"), boxes), technique);
  played.advance(kAsleep);
  // The ground comes first. Stacks that slide are spread over the row.
  const int count = settings.count("stacks");
  for (int m = 0; m < moving; ++m) {
    const int stack = m * count / moving;
    for (int level = 0; level < boxes; ++level)
      played.world().set_velocity(
          played.world().ids()[static_cast<std::size_t>(1 + stack * boxes + level)],
          Vec3(0.0, 0.0, settings.number("speed")), Vec3::Zero());
  }
  Work work;
  double steps = 0.0;
  played.advance(kAsleep + kPushed, [&](const StepReport& report) {
    steps += 1.0;
    work.pair_tests += static_cast<double>(report.pair_tests);
    work.impulses += static_cast<double>(report.impulses);
    work.integrations += static_cast<double>(report.integrations);
  });
  for (double* part : {&work.pair_tests, &work.impulses, &work.integrations}) *part /= steps;
  return work;
}

PlayedTechnique sleeping(bool on) {
  return {"contact_damped", {on ? "sleeping=on" : "sleeping=off"}};
}

// Two stacks sleep; a box of the first one is taken away.
struct Waking {
  double slept = 0.0;              // movable bodies asleep before
  double woken = 0.0;              // the largest number awake after
  double steps_to_wake = 0.0;      // until the last of them woke
  double steps_to_sleep = 0.0;     // until all sleep again
  std::vector<double> awake = {};  // boxes, after each step
};

Waking wake(int boxes, int level) {
  PlayedScene played(stacks(2, boxes), sleeping(true));
  played.advance(kAsleep);
  Waking result{.slept = asleep(played.world())};
  const std::string name = "stack1_" + std::to_string(level);
  played.world().remove(*played.world().find(name));
  const double left = static_cast<double>(2 * boxes - 1);
  for (int step = 1; step <= 240; ++step) {
    played.step();
    const double awake = left - asleep(played.world());
    if (awake > result.woken) {
      result.woken = awake;
      result.steps_to_wake = step;
    }
    if (awake > 0.0) result.steps_to_sleep = step + 1;
    result.awake.push_back(awake);
  }
  return result;
}

// A pyramid sleeps; its uppermost box is pushed, too slowly to carry the others along.
struct Nudge {
  double woken = 0.0;  // the largest number awake
  double moved = 0.0;  // by more than a thousandth of an edge within a second
};

Nudge nudge() {
  PlayedScene played(make_scene("pyramid"), sleeping(true));
  played.advance(kAsleep);
  played.world().set_velocity(played.world().ids().back(), Vec3(0.0, 0.0, 0.5), Vec3::Zero());
  const World before = played.world();
  Nudge result;
  const auto boxes = static_cast<double>(played.scene().boxes.size());
  played.advance(kAsleep + 1.0, [&](const StepReport&) {
    result.woken = std::max(result.woken, boxes - asleep(played.world()));
  });
  for (std::size_t k = 0; k < before.states().size(); ++k) {
    const Vec3 way_w = played.world().states()[k].position_w - before.states()[k].position_w;
    if (way_w.norm() > 1e-3 * before.bodies()[k].size.minCoeff()) result.moved += 1.0;
  }
  return result;
}

Result measure_sleeping(const Parameters& settings) {
  const int count = settings.count("stacks");
  const int boxes = settings.count("boxes");
  Table table{
      "",
      {{"moving", "-", "share of the boxes that are pushed"},
       {"work", "-", "pair tests, impulses and integrations of a step, resting boxes sleep"},
       {"work_awake", "-", "the same work if nothing sleeps"}}};
  std::vector<Work> works;
  std::vector<Work> awake;
  constexpr int parts = 10;
  for (int part = 0; part <= parts; ++part) {
    works.push_back(work_of(settings, part * count / parts, sleeping(true)));
    awake.push_back(work_of(settings, part * count / parts, sleeping(false)));
    table.add(1.0 * part / parts, works.back().all(), awake.back().all());
  }
  const Nudge top = nudge();
  const Waking lowest = wake(boxes, 1);
  const Waking highest = wake(boxes, boxes);
  Table path{"wake",
             {{"step", "-", "since the box was taken away"},
              {"awake_lowest", "-", "boxes awake, the lowest taken away"},
              {"awake_highest", "-", "boxes awake, the uppermost taken away"}}};
  for (std::size_t k = 0; k < lowest.awake.size(); ++k)
    path.add(k + 1, lowest.awake[k], highest.awake[k]);

  return {{table, path},
          {{"pair tests, impulses and integrations of a step with a tenth of the boxes moving, "
            "over those with all of them moving",
            "-", works[1].all() / works[parts].all()},
           {"the same, pair tests", "-", works[1].pair_tests / works[parts].pair_tests},
           {"the same, integrations", "-", works[1].integrations / works[parts].integrations},
           {"the same, nothing sleeps", "-", awake[1].all() / awake[parts].all()},
           {"work of a step with nothing moving", "-", works[0].all()},
           {"pyramid, top box pushed: boxes that move", "-", top.moved},
           {"pyramid, top box pushed: boxes that wake", "-", top.woken},
           {"lowest box taken away: boxes asleep before", "-", lowest.slept},
           {"lowest box taken away: boxes that wake", "-", lowest.woken},
           {"lowest box taken away: steps until the last one wakes", "-", lowest.steps_to_wake},
           {"lowest box taken away: steps until all sleep again", "-", lowest.steps_to_sleep}}};
}

const Registered claim_4_5a_sleeping_figure{
    {.name = "claim_4_5a_sleeping",
     .parameters = {whole("stacks", 20, 10, 1000, "side by side; tens are best"),
                    whole("boxes", 5, 2, 50, "in each stack"),
                    number("speed", 2.0, 0.0, 10.0, "m/s", "of the boxes that are pushed")},
     .quick = {"stacks=10", "boxes=3"},
     .experiment = measure_sleeping}};

}  // namespace
}  // namespace tumble::chapters
