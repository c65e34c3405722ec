/// \file
/// \brief One frame of cubes on a line, watched (thesis A.1).
#include "timewarp/errata_runs.hpp"

#include "driver/finished.hpp"

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
    for (const BodyId id : {event.first, event.second})
      note(static_cast<std::size_t>(world_.index_of(id)), event.time, true);
  }
  void note(std::size_t body, double time, bool hit) {
    run_.ways[body].push_back({time, world_.states()[body].position_w.x(), hit});
  }

 private:
  const World& world_;
  FrameRun& run_;
};

}  // namespace

World line_world(const std::string& boxes, const std::string& restitution) {
  return build_world(scene_with("line", {"boxes=" + boxes, "restitution=" + restitution}));
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
  run.world = world;
  WayWatcher watcher(run.world, run);
  technique.observe(&watcher);
  // Some listings do not end as printed. The cap that ends them then is their fault, and passes() is what it costs.
  ended_at_cap(technique.step(run.world, dt));
  technique.observe(nullptr);
  for (std::size_t body = 0; body < run.ways.size(); ++body) {
    watcher.note(body, dt, false);
    run.places.push_back(run.ways[body].back().place);
  }
  return run;
}

PrintedRun run_printed(const TimewarpAsPrintedOptions& options, const World& world, double dt) {
  TimewarpAsPrinted technique(options);
  return {run_frame(technique, world, dt),
          static_cast<double>(technique.passes()),
          {technique.valid_times().begin(), technique.valid_times().end()}};
}

Figure errata_figure(const std::string& name, TimewarpListing listing,
                     const std::vector<void (*)(ErrataBench&)>& parts) {
  const auto measure = [listing, parts](const Parameters& settings) {
    ErrataBench bench(listing, settings.count("cap"));
    for (const auto part : parts) part(bench);
    return bench.result;
  };
  return {
      .name = name,
      .parameters = Parameters{}.add_whole(
          "cap", 1000, 1, 1000000, "passes of the main loop after which an endless run is left"),
      .quick = {"cap=50"},
      .experiment = measure};
}

ErrataBench::ErrataBench(TimewarpListing listing, int cap) : listing_(listing), cap_(cap) {
  result.tables = {{"",
                    {{"row", "-", "number of the erratum in its listing"},
                     {"failure", "as the number's name says", "with the text taken literally"},
                     {"mended", "as the number's name says", "under the other reading"}}},
                   {"ways",
                    {{"row", "-", "number of the erratum in its listing"},
                     {"mended", "-", "0: taken literally, 1: mended"},
                     {"body", "-", "which cube, from 0"},
                     {"time_s", "s", "since the start of the frame"},
                     {"place_m", "m", "of the cube's centre along the line"},
                     {"hit", "-", "1: it collides there"}}}};
}

TimewarpAsPrintedOptions ErrataBench::as_meant_but(std::string_view left) const {
  TimewarpAsPrintedOptions options;
  options.listing = listing_;
  options.cap = cap_;
  options.repaired = TimewarpErrata::all().without("T5").without("T9").without("F8");
  while (!left.empty()) {
    const std::string_view id = left.substr(0, left.find(','));
    options.repaired = options.repaired.without(id);
    left.remove_prefix(std::min(left.size(), id.size() + 1));
  }
  return options;
}

PrintedRun ErrataBench::run(std::string_view left, const World& world, double dt) const {
  return run_printed(as_meant_but(left), world, dt);
}

void ErrataBench::add(int row, const std::string& what, const std::string& unit,
                      const Reading& printed, const Reading& mended) {
  result.tables[0].add(row, printed.second, mended.second);
  for (const auto& [reading, value] : {printed, mended})
    result.add(what + ", " + reading, unit, value);
}

void ErrataBench::show(int row, const FrameRun& printed, const FrameRun& mended) {
  for (const FrameRun* run : {&printed, &mended})
    for (std::size_t body = 0; body < run->ways.size(); ++body)
      for (const WayPoint& point : run->ways[body])
        result.tables[1].add(row, run == &mended, body, point.time, point.place, point.hit);
}

}  // namespace tumble::chapters
