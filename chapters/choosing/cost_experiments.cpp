/// \file
/// \brief The cost of a step at 10, 100 and 1000 boxes, in counts.
#include "choosing/experiments.hpp"

namespace tumble::chapters {
namespace {

struct Sized {
  const char* words;  // empty: only the picture has it
  Scene scene;
  int boxes = 0;
  bool large = false;
  bool pyramid = false;  // all boxes are in contact
};

std::vector<Sized> sized_scenes() {
  return {{"", separate_stacks(10), 10},
          {"100 boxes in stacks", separate_stacks(100), 100},
          {"", separate_stacks(1000), 1000, true},
          {"", make_scene("pyramid", {"rows=4"}), 10, false, true},
          {"105 boxes in a pyramid", make_scene("pyramid", {"rows=14"}), 105, false, true},
          {"990 boxes in a pyramid", make_scene("pyramid", {"rows=44"}), 990, true, true}};
}

// Whether a step takes a second or more: these are run on demand.
bool takes_long(const std::string& technique, const Sized& sized) {
  if (technique == "basic") return sized.large || (sized.pyramid && sized.boxes > 10);
  if (technique == "microcollisions") return sized.large;
  if (technique == "time_stepping") return sized.pyramid && sized.boxes > 10;
  const bool sweeps = technique == "contact_damped" || technique == "damped" ||
                      technique == "impulse" || technique == "penalty" || technique == "faure" ||
                      technique == "relaxation" || technique == "settling" ||
                      technique == "glued" || technique == "optimised";
  return sized.large && sized.pyramid && !sweeps;
}

}  // namespace

double step_cost(const Scene& scene, const PlayedTechnique& played, int steps) {
  try {
    const RunResult run = run_compared(scene, played, kStep, steps * kStep);
    return run.end == RunEnd::complete ? work_of(run.totals) / steps : kNoNumber;
  } catch (const std::invalid_argument&) {
    return kNoNumber;
  }
}

Scene separate_stacks(int boxes) {
  constexpr int high = 5;
  constexpr double spacing = 2.0;  // [m] centre to centre
  const int stacks = boxes / high;
  const int edge = static_cast<int>(std::ceil(std::sqrt(stacks)));
  Scene scene{.title = "stacks of five cubes", .ground = SceneGround{}};
  for (int k = 0; k < stacks; ++k) {
    for (int level = 0; level < high; ++level) {
      SceneBox box{.position_w = Vec3(spacing * (k % edge), level + 0.5, spacing * (k / edge))};
      scene.boxes.push_back(box);
    }
  }
  return scene;
}

namespace {

// Work of a step in separate stacks and in one pyramid, by technique and number of boxes.
Result measure_cost(const Parameters& settings) {
  Table table{"",
              {{"technique", "-", "its row, from 0"},
               {"scene", "-", "0: stacks of five, 1: one pyramid"},
               {"boxes", "-", "in the scene"},
               {"work", "-", "of a step: everything that its report counts"}}};
  Result result;
  const std::vector<Sized> scenes = sized_scenes();
  const std::vector<PlayedTechnique> techniques = compared_techniques();
  for (std::size_t t = 0; t < techniques.size(); ++t)
    for (const Sized& sized : scenes) {
      const bool left_out = takes_long(techniques[t].name, sized) && !settings.flag("patient");
      const double work =
          left_out ? kNoNumber : step_cost(sized.scene, techniques[t], settings.count("steps"));
      table.add(t, sized.pyramid ? 1 : 0, sized.boxes, work);
      if (*sized.words != '\0')
        add_number(result.quantities,
                   number_name(techniques[t].name, std::string("work of a step, ") + sized.words),
                   "-", work);
    }
  result.tables = {table};
  return result;
}

const Registered choose_cost_figure{
    {.name = "choose_cost",
     .parameters = {whole("steps", 4, 1, 1000, "of 1/60 s, over which the work is averaged"),
                    flag("patient", false, "run what takes a second or more for a step too")},
     .quick = {"steps=1"},
     .experiment = measure_cost}};

}  // namespace
}  // namespace tumble::chapters
