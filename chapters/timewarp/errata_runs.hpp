/// \file
/// \brief One frame of cubes on a line, watched: shared by the experiments with the errata of A.1.
#pragma once

#include "tumble/timewarp/as_printed/timewarp_as_printed.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

inline constexpr double kLineFrame = 1.0;  // [s] of the scenes on a line

// The place of a body at a time, along x.
struct WayPoint {
  double time = 0.0;   // [s] since the start of the frame
  double place = 0.0;  // [m]
  bool hit = false;    // a collision; else the start or the end of the frame
};

// A frame as it went.
struct FrameRun {
  std::vector<double> places;               // [m] along x at the end, by index
  std::vector<std::vector<WayPoint>> ways;  // by index
  std::vector<Event> events;                // collisions, as they were resolved
  World world;                              // at the end
};

// A frame of a listing as printed.
struct PrintedRun : FrameRun {
  double passes = 0.0;              // [-] of the main loop
  std::vector<double> valid_times;  // [s] by index, as the main loop leaves them
};

// Cubes of 1 m and 1 kg on a line, without gravity: the scene `line`.
// restitution: [-] as text
[[nodiscard]] inline World line_world(const std::string& boxes,
                                      const std::string& restitution = "1") {
  return build_world(make_scene("line", {"boxes=" + boxes, "restitution=" + restitution}));
}

// A cube of 1 m and 1 kg above a ground.
// height: [m] of its lower face
[[nodiscard]] inline World world_with_falling_cube(double height, double restitution) {
  World world;
  world.add_ground(0.0, restitution);
  world.add(box_properties(Vec3::Ones(), 1.0, 0.0, restitution), Vec3(0.0, 0.5 + height, 0.0));
  return world;
}

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

// Runs one frame.
[[nodiscard]] inline FrameRun run_frame(Technique& technique, const World& world, double dt) {
  FrameRun run{.world = world};
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

// Runs one frame of a listing as printed.
[[nodiscard]] inline PrintedRun run_printed(const TimewarpAsPrintedOptions& options,
                                            const World& world, double dt = kLineFrame) {
  TimewarpAsPrinted technique(options);
  return {run_frame(technique, world, dt),
          static_cast<double>(technique.passes()),
          {technique.valid_times().begin(), technique.valid_times().end()}};
}

// The experiments with the errata of one listing: runs of it, and the numbers and ways of bodies that they
// collect.
class ErrataBench {
 public:
  using Reading = std::pair<std::string, double>;  // end of a quantity's name, and its value

  // Makes empty tables.
  ErrataBench(TimewarpListing listing, int cap) : listing_(listing), cap_(cap) {
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

  // The listing as meant: all misprints are mended, the choices T5, T9 and F8 are kept.
  [[nodiscard]] TimewarpAsPrintedOptions as_meant_but(std::string_view left = "") const {
    TimewarpAsPrintedOptions options{
        .listing = listing_,
        .repaired = TimewarpErrata::all().without("T5").without("T9").without("F8"),
        .cap = cap_};
    while (!left.empty()) {
      const std::string_view id = left.substr(0, left.find(','));
      options.repaired = options.repaired.without(id);
      left.remove_prefix(std::min(left.size(), id.size() + 1));
    }
    return options;
  }

  // Runs one frame of the listing with some misprints left in.
  [[nodiscard]] PrintedRun run(std::string_view left, const World& world,
                               double dt = kLineFrame) const {
    return run_printed(as_meant_but(left), world, dt);
  }

  // Adds the numbers of an erratum.
  void add(int row, const std::string& what, const std::string& unit, const Reading& printed,
           const Reading& mended) {
    result.tables[0].add(row, printed.second, mended.second);
    for (const auto& [reading, value] : {printed, mended})
      result.add(what + ", " + reading, unit, value);
  }

  // Adds the ways of all bodies on both sides of the figure.
  void show(int row, const FrameRun& printed, const FrameRun& mended) {
    for (const FrameRun* run : {&printed, &mended})
      for (std::size_t body = 0; body < run->ways.size(); ++body)
        for (const WayPoint& point : run->ways[body])
          result.tables[1].add(row, run == &mended, body, point.time, point.place, point.hit);
  }

  Result result;  // tables "" and "ways" and others, and the numbers

 private:
  TimewarpListing listing_;
  int cap_;
};

// The figure of a listing.
[[nodiscard]] inline Figure errata_figure(const std::string& name, TimewarpListing listing,
                                          const std::vector<void (*)(ErrataBench&)>& parts) {
  const auto measure = [listing, parts](const Parameters& settings) {
    ErrataBench bench(listing, settings.count("cap"));
    for (const auto part : parts) part(bench);
    return bench.result;
  };
  return {.name = name,
          .parameters = {whole("cap", 1000, 1, 1000000,
                               "passes of the main loop after which an endless run is left")},
          .quick = {"cap=50"},
          .experiment = measure};
}

}  // namespace tumble::chapters
