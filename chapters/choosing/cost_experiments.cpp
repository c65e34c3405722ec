/// \file
/// \brief What a step costs at 10, 100 and 1000 boxes, in counts.
#include "choosing/cost_experiments.hpp"

#include "driver/common_numbers.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

namespace tumble::chapters {
namespace {

struct Sized {
  std::string words;
  Scene scene;
  int boxes = 0;
  bool large = false;
  bool heap = false;  // all boxes hang together
};

std::vector<Sized> sized_scenes() {
  return {{"10 boxes in stacks", separate_stacks(10), 10},
          {"100 boxes in stacks", separate_stacks(100), 100},
          {"1000 boxes in stacks", separate_stacks(1000), 1000, true},
          {"10 boxes in a pyramid", scene_with("pyramid", {"rows=4"}), 10, false, true},
          {"105 boxes in a pyramid", scene_with("pyramid", {"rows=14"}), 105, false, true},
          {"990 boxes in a pyramid", scene_with("pyramid", {"rows=44"}), 990, true, true}};
}

// Whoever takes a second or more for a step: only the patient run them.
bool takes_long(const std::string& technique, const Sized& sized) {
  if (technique == "basic") return sized.large || (sized.heap && sized.boxes > 10);
  if (technique == "time_stepping") return sized.heap && sized.boxes > 10;
  const bool sweeps =
      technique == "contact_damped" || technique == "damped" || technique == "impulse";
  return sized.large && sized.heap && !sweeps;
}

}  // namespace

StepCost step_cost(const Scene& scene, const PlayedTechnique& played, int steps) {
  StepCost cost;
  try {
    const RunResult run = run_compared(scene, played, kStep, steps * kStep);
    cost.work = work_of(run.totals) / steps;
    cost.pivots = static_cast<double>(run.totals.pivots) / steps;
    cost.refused = run.end != RunEnd::complete;
  } catch (const std::invalid_argument&) {
    cost.refused = true;
  }
  return cost;
}

Scene separate_stacks(int boxes) {
  constexpr int high = 5;
  constexpr double spacing = 2.0;  // [m] centre to centre
  const int stacks = boxes / high;
  const int edge = static_cast<int>(std::ceil(std::sqrt(stacks)));
  Scene scene;
  scene.title = "stacks of five cubes";
  scene.ground = SceneGround{};
  for (int k = 0; k < stacks; ++k) {
    for (int level = 0; level < high; ++level) {
      SceneBox box;
      box.position_w = Vec3(spacing * (k % edge), level + 0.5, spacing * (k / edge));
      scene.boxes.push_back(box);
    }
  }
  return scene;
}

Result measure_cost(const Parameters& settings) {
  Table table{"",
              {{"technique", "-", "its row, from 0"},
               {"scene", "-", "0: stacks of five, 1: one pyramid"},
               {"boxes", "-", "in the scene"},
               {"run", "-", "0: left out, a step takes a second or more; -1: refused"},
               {"work", "-", "of a step: everything that its report counts"},
               {"pivots", "-", "of these"}}};
  Result result;
  const std::vector<Sized> scenes = sized_scenes();
  const std::vector<PlayedTechnique> techniques = compared_techniques();
  for (std::size_t t = 0; t < techniques.size(); ++t) {
    for (const Sized& sized : scenes) {
      const bool left_out = takes_long(techniques[t].name, sized) && !settings.flag("patient");
      StepCost cost{true, kNoNumber, kNoNumber};
      if (!left_out) cost = step_cost(sized.scene, techniques[t], settings.count("steps"));
      const double work = cost.refused ? kNoNumber : cost.work;
      table.rows.push_back({static_cast<double>(t), sized.heap ? 1.0 : 0.0,
                            static_cast<double>(sized.boxes),
                            left_out ? 0.0 : (cost.refused ? -1.0 : 1.0), work,
                            cost.refused ? kNoNumber : cost.pivots});
      add_number(result.quantities,
                 number_name(techniques[t].name, "work of a step, " + sized.words), "-", work);
    }
  }
  result.tables = {table};
  return result;
}

}  // namespace tumble::chapters
