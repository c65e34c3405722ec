/// \file
/// \brief F1 to F9, each left in SAFERSYNCTIMEWARP while the other misprints are mended (thesis 5.1, A.1).
#include "tumble/timewarp/timewarp_safer.hpp"
#include "tumble/timewarp/timewarp_swept.hpp"

#include "timewarp/errata_runs.hpp"

namespace tumble::chapters {
namespace {

enum Cube : std::size_t { A, B, C, D, E };  // of figure 5.1, by index

// The place of one cube at the end, with a misprint and without it.
struct PlaceErratum {
  int row;
  std::string left;  // the misprint
  std::string boxes;
  std::size_t cube;
  std::string what;
  std::string printed;
  std::string reading;
};

void add_place(ErrataBench& bench, const PlaceErratum& e) {
  const World world = line_world(e.boxes);
  const PrintedRun printed = bench.run(e.left, world);
  const PrintedRun mended = bench.run("", world);
  bench.add(e.row, e.left + ": " + e.what, "m", {e.printed, printed.places[e.cube]},
            {e.reading, mended.places[e.cube]});
  bench.show(e.row, printed, mended);
}

// F1 to F5: the two cubes, and their neighbours.
void add_states(ErrataBench& bench) {
  const std::string neighbour = "-1.2:-1,0:2,1.5:0";
  add_place(bench, {1, "F1", "0:2,1.5:0,10:1", 0, "place of a cube that has hit another",
                    "test states collide", "valid states collide"});
  add_place(bench, {2, "F2", "0:2,1.5:0,3.4:-1", 2, "place of the third cube",
                    "valid times never advanced", "valid times advanced"});
  add_place(bench, {3, "F3", neighbour, 0, "place of a neighbour", "index of one of the two",
                    "index of the neighbour"});
  add_place(bench, {4, "F4", neighbour, 0, "place of a neighbour", "flown to the collision",
                    "flown to the end of the frame"});
  add_place(bench, {5, "F5", "0:-3,1.5:-4,2.7:0,4.4:-3", 0, "place of a cube that waits its turn",
                    "collision and test states lost", "both kept"});
}

// F6 and F7: the pairs that are searched. F6 can be seen only with T7: else the present pair is a little apart.
void add_group(ErrataBench& bench) {
  const World two = line_world("0:2,1.5:0");
  const PrintedRun present = bench.run("F6,T7", two);
  const PrintedRun others = bench.run("T7", two);
  bench.add(6, "F6: passes of the loop for one collision", "-",
            {"present pair in the group, until a cap", present.passes},
            {"present pair left out", others.passes});
  bench.show(6, present, others);
  TimewarpAsPrintedOptions nothing_mended = bench.as_meant_but();
  nothing_mended.repaired = {};
  bench.result.add("passes of the loop for one collision, nothing mended, until a cap", "-",
                   run_printed(nothing_mended, two).passes);
  add_place(bench, {7, "F7", "0:3,1.7:0,3.1:0", 0, "place of a cube that flies over another",
                    "near at the end of the frame", "near on the way to the collision"});
}

// Keeps what is foreseen before anything has happened.
class FirstLook : public TimewarpWatcher {
 public:
  void on_queue(const TimewarpLook& look) override {
    if (look.current == nullptr) foreseen.assign(look.foreseen.begin(), look.foreseen.end());
  }
  std::vector<ForeseenCollision> foreseen;
};

// F8 and F9: the five cubes of figure 5.1.
void add_figure_errata(ErrataBench& bench) {
  const World world = build_world(make_scene("fig5_1"));
  TimewarpSafer safer;
  FirstLook look;
  safer.watch(&look);
  const FrameRun neighbours = run_frame(safer, world, kStep);
  TimewarpSwept swept;
  const FrameRun ways = run_frame(swept, world, kStep);

  const BodyId b = world.ids()[B];
  const auto hits = [&](const FrameRun& run) {
    return static_cast<double>(std::ranges::count_if(
        run.events, [&](const Event& e) { return e.first == b || e.second == b; }));
  };
  bench.add(8, "F8: collisions of cube B in figure 5.1", "-",
            {"neighbours looked at", hits(neighbours)}, {"ways searched", hits(ways)});
  bench.show(8, neighbours, ways);

  const auto foreseen = [&](Cube other) {
    const IndexPair pair{static_cast<int>(std::min<std::size_t>(other, D)),
                         static_cast<int>(std::max<std::size_t>(other, D))};
    return static_cast<double>(std::ranges::count_if(
        look.foreseen, [&](const ForeseenCollision& c) { return c.pair == pair; }));
  };
  bench.add(9, "F9: collisions foreseen for cube D in figure 5.1", "-",
            {"with C, as the caption says", foreseen(C)}, {"with E", foreseen(E)});

  Table start{"start", {{"place_m", "m", "of a cube's centre"}, {"half_m", "m", "half its edge"}}};
  for (std::size_t k = 0; k < world.states().size(); ++k)
    start.add(world.states()[k].position_w.x(), 0.5 * world.bodies()[k].size.x());
  bench.result.tables.push_back(start);
}

const Registered errata_timewarp_safer_figure(errata_figure(
    "errata_timewarp_safer", TimewarpListing::safer, {add_states, add_group, add_figure_errata}));

}  // namespace
}  // namespace tumble::chapters
