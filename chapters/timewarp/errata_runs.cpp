/// \file
/// \brief One frame of cubes on a line, watched (thesis A.1).
#include "errata_runs.hpp"

#include "tumble/scenes/library.hpp"

#include <algorithm>
#include <utility>

namespace tumble::chapters {
namespace {

// Notes where the two bodies of a collision are.
class WayWatcher : public Observer {
 public:
  WayWatcher(const World& world, FrameRun& run) : world_(world), run_(run) {
    run_.ways.resize(world.ids().size());
    for (std::size_t body = 0; body < run_.ways.size(); ++body) note(body, 0.0, false);
  }
  void on_event(const Event& event) override {
    run_.events.push_back(event);
    for (const BodyId id : {event.first, event.second}) note(index_of(id), event.time, true);
  }
  void note(std::size_t body, double time, bool hit) {
    run_.ways[body].push_back({time, world_.states()[body].position_w.x(), hit});
  }

 private:
  [[nodiscard]] std::size_t index_of(BodyId id) const {
    const auto ids = world_.ids();
    return static_cast<std::size_t>(std::find(ids.begin(), ids.end(), id) - ids.begin());
  }
  const World& world_;
  FrameRun& run_;
};

StepReport run_into(Technique& technique, const World& world, double dt, FrameRun& run) {
  run.world = world;
  WayWatcher watcher(run.world, run);
  technique.observe(&watcher);
  const StepReport report = technique.step(run.world, dt);
  technique.observe(nullptr);
  for (std::size_t body = 0; body < run.ways.size(); ++body) {
    watcher.note(body, dt, false);
    run.places.push_back(run.ways[body].back().place);
  }
  return report;
}

}  // namespace

World line_world(std::string_view boxes, std::string_view restitution) {
  const SceneRecipe& recipe = scene_recipe("line");
  Parameters parameters = recipe.parameters();
  parameters.set("boxes", boxes);
  parameters.set("restitution", restitution);
  return build_world(recipe.build(parameters, Random(0)));
}

World world_with_falling_cube(double height, double restitution) {
  World world;
  world.add_ground(0.0, restitution);
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, 0.0, restitution);
  world.add(cube, make_state(cube, Vec3(0.0, 0.5 + height, 0.0)));
  return world;
}

FrameRun run_frame(Technique& technique, const World& world, double dt) {
  FrameRun run;
  run_into(technique, world, dt, run);
  return run;
}

PrintedRun run_printed(const TimewarpAsPrintedOptions& options, const World& world, double dt) {
  TimewarpAsPrinted technique(options);
  PrintedRun run;
  const StepReport report = run_into(technique, world, dt, run);
  run.passes = technique.passes();
  run.capped = report.status == StepStatus::event_cap;
  run.valid_times.assign(technique.valid_times().begin(), technique.valid_times().end());
  return run;
}

TimewarpAsPrintedOptions as_meant_but(TimewarpListing listing, int cap, std::string_view left) {
  TimewarpAsPrintedOptions options;
  options.listing = listing;
  options.cap = cap;
  options.repaired = TimewarpErrata::all().without("T5").without("T9").without("F8");
  while (!left.empty()) {
    const std::string_view id = left.substr(0, left.find(','));
    options.repaired = options.repaired.without(id);
    left.remove_prefix(std::min(left.size(), id.size() + 1));
  }
  return options;
}

ErrataTables::ErrataTables()
    : pairs_{"",
             {{"row", "-", "number of the erratum in its listing"},
              {"failure", "as the number's name says", "with the text taken literally"},
              {"mended", "as the number's name says", "under the other reading"}}},
      ways_{"ways",
            {{"row", "-", "number of the erratum in its listing"},
             {"mended", "-", "0: taken literally, 1: mended"},
             {"body", "-", "which cube, from 0"},
             {"time_s", "s", "since the start of the frame"},
             {"place_m", "m", "of the cube's centre along the line"},
             {"hit", "-", "1: it collides there"}}} {}

void ErrataTables::add(int row, const std::string& what, const std::string& printed, double failure,
                       const std::string& reading, double mended, const std::string& unit) {
  pairs_.rows.push_back({static_cast<double>(row), failure, mended});
  quantities_.push_back({what + ", " + printed, unit, failure});
  quantities_.push_back({what + ", " + reading, unit, mended});
}

void ErrataTables::add_more(const std::string& name, double value, const std::string& unit) {
  quantities_.push_back({name, unit, value});
}

void ErrataTables::add_ways(int row, bool mended, const FrameRun& run) {
  for (std::size_t body = 0; body < run.ways.size(); ++body)
    for (const WayPoint& point : run.ways[body])
      ways_.rows.push_back({static_cast<double>(row), mended ? 1.0 : 0.0, static_cast<double>(body),
                            point.time, point.place, point.hit ? 1.0 : 0.0});
}

}  // namespace tumble::chapters
