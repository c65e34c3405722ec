/// \file
/// \brief T1 to T10, each left in SIMPLESYNCTIMEWARP while the other misprints are mended (thesis A.1).
#include "tumble/timewarp/timewarp_swept.hpp"

#include "timewarp/errata_runs.hpp"

namespace tumble::chapters {
namespace {

// T1, T2 and T3: two cubes.
void add_loop_errata(ErrataBench& bench) {
  const World head_on = line_world("0:1,2:-1");
  const PrintedRun right = bench.run("", head_on);
  const PrintedRun each = bench.run("T1", head_on);
  bench.add(1, "T1: place of the second of two cubes", "m",
            {"each turn of the loop collides", each.places[1]},
            {"both cubes fly before they collide", right.places[1]});
  bench.show(1, each, right);
  TimewarpAsPrintedOptions separating = bench.as_meant_but("T1");
  separating.collide_separating = true;
  bench.result.add("T1: place of the first of two cubes, each turn collides, separating cubes too",
                   "m", run_printed(separating, head_on).places[0]);

  // T2 can be seen only with T1: in two loops one after the other a counter does no harm.
  const PrintedRun counter = bench.run("T1,T2", head_on);
  bench.add(2, "T2: place of the second of two cubes", "m",
            {"one counter for both loops", counter.places[1]},
            {"two loops one after the other", right.places[1]});
  bench.show(2, counter, right);

  const World from_behind = line_world("0:2,1.5:0", "0.5");
  const PrintedRun early = bench.run("T3", from_behind);
  const PrintedRun late = bench.run("", from_behind);
  bench.add(3, "T3: time up to which two cubes are valid", "s",
            {"one asked before the other flies", early.valid_times[0]},
            {"asked when both have flown", late.valid_times[0]});
  bench.show(3, early, late);
}

// T4 and T5: three cubes.
void add_row_errata(ErrataBench& bench) {
  const World row = line_world("0:2,1.5:0,3.4:-1");
  const PrintedRun without = bench.run("T4", row);
  const PrintedRun with = bench.run("", row);
  bench.add(4, "T4: time of the second collision in a row", "s",
            {"searched as if all began together", without.events.at(1).time},
            {"searched from the valid times", with.events.at(1).time});
  bench.show(4, without, with);

  const World through = line_world("0:2,1.5:0,2.8:-1");
  const PrintedRun end = bench.run("", through);
  TimewarpSwept swept;
  const FrameRun way = run_frame(swept, through, kLineFrame);
  const auto ahead = [](const FrameRun& run) { return run.places[2] - run.places[1]; };
  bench.add(5, "T5: third cube ahead of the second", "m", {"end of the frame tested", ahead(end)},
            {"way there searched", ahead(way)});
  bench.show(5, end, way);
}

Table bounce_table(const FrameRun& run, const std::string& suffix) {
  Table table{suffix,
              {{"time_ms", "ms", "since the start of the frame"}, {"count", "-", "so far"}}};
  for (const Event& event : run.events) table.add(1e3 * event.time, table.rows.size() + 1);
  return table;
}

// T6 and T7: collisions that do not end.
void add_progress_errata(ErrataBench& bench) {
  constexpr double speed = 0.05;  // [m/s] of the landing
  const World landing = world_with_falling_cube(0.5 * speed * speed / kGravity, 0.5);
  const PrintedRun endless = bench.run("T6", landing, kStep);
  const PrintedRun ended = bench.run("", landing, kStep);
  bench.add(6, "T6: passes of the loop for a landing", "-",
            {"nothing ends them, until a cap", endless.passes},
            {"hops below the resolution end them", ended.passes});
  bench.result.tables.push_back(bounce_table(endless, "bounces_printed"));
  bench.result.tables.push_back(bounce_table(ended, "bounces_mended"));

  // T7 can be seen only with T6: otherwise a pair that sticks is left to the end of the frame.
  const World sticky = line_world("0:1,1.4:0", "0");
  const PrintedRun inside = bench.run("T6,T7", sticky);
  const PrintedRun apart = bench.run("T6", sticky);
  bench.add(7, "T7: passes of the loop for one collision", "-",
            {"overlapping end kept, until a cap", inside.passes},
            {"end that is apart kept", apart.passes});
  bench.show(7, inside, apart);
}

// T8: a cube falls from 1 mm, over frames of several lengths.
void add_flow_erratum(ErrataBench& bench) {
  constexpr double height = 1e-3;  // [m]
  constexpr int frames = 80;       // [-] lengths of a frame that are shown
  const World falling = world_with_falling_cube(height, 0.0);
  const PrintedRun euler = bench.run("T8", falling, kStep);
  const PrintedRun exact = bench.run("", falling, kStep);
  bench.add(8, "T8: time of the landing from 1 mm", "s",
            {"integrated by Euler's steps", euler.events.at(0).time},
            {"flown exactly", exact.events.at(0).time});
  Table table{"fall",
              {{"time_ms", "ms", "length of the frame"},
               {"printed_mm", "mm", "height at its end, integrated by Euler's steps"},
               {"mended_mm", "mm", "the same, flown"}}};
  const auto millimetres = [&](std::string_view left, double dt) {
    const PrintedRun run = bench.run(left, falling, dt);
    return 1e3 * (run.world.states()[1].position_w.y() - 0.5);
  };
  for (int k = 1; k <= frames; ++k) {
    const double dt = kStep * k / frames;
    table.add(1e3 * dt, millimetres("T8", dt), millimetres("", dt));
  }
  bench.result.tables.push_back(table);
}

// T9: a cube is hit from both sides alike. T10: the bodies that are stamped.
void add_order_errata(ErrataBench& bench) {
  const World squeezed = line_world("-1.5:1,0:0,1.5:-1", "0.5");
  TimewarpAsPrintedOptions options = bench.as_meant_but();
  const PrintedRun in_turn = run_printed(options, squeezed);
  options.repaired = options.repaired.with("T9");
  const PrintedRun together = run_printed(options, squeezed);
  const auto middle = [](const PrintedRun& run) { return BodyView(run.world, 1).velocity_w().x(); };
  bench.add(9, "T9: speed of a cube hit from both sides alike", "m/s",
            {"one after the other", middle(in_turn)}, {"at one stroke", middle(together)});
  bench.show(9, in_turn, together);

  const World falling = world_with_falling_cube(1e-3, 0.0);
  const PrintedRun all = bench.run("T10", falling, kStep);
  const PrintedRun movable = bench.run("", falling, kStep);
  bench.add(10, "T10: time up to which the ground is valid", "s",
            {"all bodies stamped", all.valid_times[0]},
            {"only movable bodies", movable.valid_times[0]});
  Table stamps{"stamps",
               {{"body", "-", "0: the ground, 1: the cube"},
                {"printed_ms", "ms", "its valid time after the landing, all bodies stamped"},
                {"mended_ms", "ms", "the same, only movable bodies"}}};
  for (std::size_t k = 0; k < all.valid_times.size(); ++k)
    stamps.add(k, 1e3 * all.valid_times[k], 1e3 * movable.valid_times[k]);
  bench.result.tables.push_back(stamps);
}

const Registered errata_timewarp_simple_figure(errata_figure(
    "errata_timewarp_simple", TimewarpListing::simple,
    {add_loop_errata, add_row_errata, add_progress_errata, add_flow_erratum, add_order_errata}));

}  // namespace
}  // namespace tumble::chapters
