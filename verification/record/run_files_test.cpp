/// \file
/// \brief The files of a run: what they hold, and that they read back to the same bits.
#include "tumble/record/run_files.hpp"

#include "tumble/basic_colliding/basic.hpp"
#include "tumble/record/csv_cells.hpp"
#include "tumble/record/metrics_table.hpp"
#include "tumble/record/recorded_run.hpp"
#include "tumble/scenes/library.hpp"

#include "support/catch.hpp"
#include "support/files.hpp"

#include <array>
#include <fstream>
#include <sstream>

namespace {

using namespace tumble;
using namespace tumble::test;
namespace fs = std::filesystem;

// Keeps every state that a run goes through.
struct Keeper : RunObserver {
  std::vector<World> worlds;
  void on_begin(const World& world) override { worlds.push_back(world); }
  void on_step(const World& world, const Technique&, const StepReport&, const Metrics&) override {
    worlds.push_back(world);
  }
};

Scene two_boxes() {
  const SceneRecipe& recipe = scene_recipe("two_boxes");
  Scene scene = recipe.build(recipe.parameters(), Random(1));
  scene.boxes[0].name = "a \"left\", one";  // a name that CSV has to quote
  return checked(scene);
}

RunDescription description() {
  RunDescription d;
  d.scene = "two_boxes";
  d.technique = "basic";
  d.scene_settings = scene_recipe("two_boxes").parameters();
  d.run.duration = 0.625;  // [s] 37.5 steps; the collision is at 0.5 s
  d.contacts = true;
  d.ignored = {"friction"};
  return d;
}

}  // namespace

TEST_CASE("A trajectory reads back to the bits that were simulated", "[unit][record][files]") {
  const Folder folder("files_back");
  const Scene scene = two_boxes();
  RunDescription d = description();
  d.run.every = 7;
  Keeper keeper;
  Basic basic;
  {
    RunFiles files(folder.path, d, scene);
    const std::array<RunObserver*, 2> observers = {&files, &keeper};
    files.finish(run_scene(scene, basic, d.run, observers));
  }
  CHECK(lines_of(folder.path / "trajectory.csv").front() ==
        "time_s,body,px_m,py_m,pz_m,qw,qx,qy,qz,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s");
  const RecordedRun run = read_run(folder.path);
  REQUIRE(run.frames.size() == 6);  // steps 0, 7, 14, 21, 28, 35 of 38
  for (std::size_t f = 0; f < run.frames.size(); ++f) {
    const World& world = keeper.worlds[7 * f];
    CHECK(run.frames[f].time == world.time());
    REQUIRE(run.frames[f].poses.size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
      const RecordedPose& pose = run.frames[f].poses[k];
      const BodyState& state = world.states()[k];
      CHECK(run.scene.boxes[static_cast<std::size_t>(pose.box)].name ==
            world.name(static_cast<int>(k)));
      CHECK(pose.position_w == state.position_w);
      CHECK(pose.orientation_wb.coeffs() == state.orientation_wb.coeffs());
      CHECK(pose.velocity_w == velocity(world.bodies()[k], state));
      CHECK(pose.angular_velocity_w == angular_velocity(world.bodies()[k], state));
    }
    CHECK(world_of(run, run.frames[f]).count() == 2);
  }
}

TEST_CASE("A run's tables have the columns, rows and numbers that they promise",
          "[unit][record][files]") {
  const Folder folder("files_tables");
  const Scene scene = two_boxes();
  Basic basic;
  RunFiles files(folder.path, description(), scene);
  const std::array<RunObserver*, 1> observers = {&files};
  RunDescription d = description();
  const RunResult result = run_scene(scene, basic, d.run, observers);
  files.finish(result);

  const std::vector<std::string> metrics = lines_of(folder.path / "metrics.csv");
  CHECK(metrics.size() == 39);  // the header and a row per step
  const std::vector<std::string> names = cells_of(metrics.front());
  REQUIRE(names.size() == 2 + metrics_columns().size());
  CHECK(names[0] == "time_s");
  CHECK(names[1] == "status");
  const std::vector<std::string> last = cells_of(metrics.back());
  REQUIRE(last.size() == names.size());
  CHECK(last[1] == "done");
  for (std::size_t k = 0; k < metrics_columns().size(); ++k) {
    INFO(names[k + 2]);
    CHECK(names[k + 2] == metrics_columns()[k].name);
    CHECK(std::stod(last[k + 2]) == metrics_columns()[k].value(result.last, result.last_report));
  }

  const std::vector<std::string> events = lines_of(folder.path / "events.csv");
  REQUIRE(events.size() == 2);  // one collision
  CHECK(events[0] ==
        "time_s,first,second,px_m,py_m,pz_m,nx,ny,nz,jx_N_s,jy_N_s,jz_N_s,rewinds,restarts");
  const std::vector<std::string> event = cells_of(events[1]);
  REQUIRE(event.size() == 14);
  CHECK(event[1] == "a \"left\", one");
  CHECK(event[2] == "right");
  CHECK(std::stod(event[0]) == near(0.5).margin(2e-6));   // 1 m at 2 m/s, found to 1 µs
  CHECK(std::stod(event[6]) == near(1.0).margin(1e-12));  // from first to second

  const std::vector<std::string> contacts = lines_of(folder.path / "contacts.csv");
  REQUIRE(contacts.size() > 1);
  CHECK(contacts[0] == "time_s,first,second,px_m,py_m,pz_m,nx,ny,nz,fx,fy,fz,unit,state");
  for (std::size_t k = 1; k < contacts.size(); ++k) {
    const std::vector<std::string> cells = cells_of(contacts[k]);
    REQUIRE(cells.size() == 14);
    CHECK(cells[12] == "N s");
    CHECK((cells[13] == "stick" || cells[13] == "slip" || cells[13] == "open"));
  }
}

TEST_CASE("The summary has settings, hash and every number at the end and at worst",
          "[unit][record][files]") {
  const Folder folder("files_summary");
  const Scene scene = two_boxes();
  Basic basic;
  RunDescription d = description();
  d.run.seed = 18446744073709551615U;
  RunFiles files(folder.path, d, scene);
  const std::array<RunObserver*, 1> observers = {&files};
  const RunResult result = run_scene(scene, basic, d.run, observers);
  files.finish(result);
  const std::string text = content(folder.path / "summary.json");
  for (const std::string& part :
       {"\"state_hash\": \"" + result.state_hash + "\"", std::string("\"end\": \"complete\""),
        std::string("\"dt_s\": 0.016666666666666666"), std::string("\"duration_s\": 0.625"),
        std::string("\"seed\": \"18446744073709551615\""), std::string("\"contacts\": \"on\""),
        std::string("\"speed\": 2"), std::string("\"friction\"\n"), std::string("\"version\": "),
        std::string("\"compiler\": "), std::string("\"flags\": ")}) {
    INFO(part);
    CHECK(text.find(part) != std::string::npos);
  }
  const std::size_t end = text.find("\"at_the_end\"");
  const std::size_t worst = text.find("\"at_worst\"");
  REQUIRE(end < worst);
  for (const MetricsColumn& column : metrics_columns()) {
    INFO(column.name);
    std::string key = "\"";
    key.append(column.name).append("\": ");
    CHECK(text.find(key, end) < worst);
    CHECK(text.find(key, worst) != std::string::npos);
  }
}

TEST_CASE("A run leaves nothing of an earlier one in its folder", "[unit][record][files]") {
  const Folder folder("files_again");
  const Scene scene = two_boxes();
  RunDescription d = description();
  {
    Basic basic;
    RunFiles files(folder.path, d, scene);
    const std::array<RunObserver*, 1> observers = {&files};
    files.finish(run_scene(scene, basic, d.run, observers));
  }
  CHECK(fs::exists(folder.path / "contacts.csv"));
  d.contacts = false;
  RunFiles files(folder.path, d, scene);
  CHECK(!fs::exists(folder.path / "contacts.csv"));
  CHECK(!fs::exists(folder.path / "summary.json"));  // not before the run is over
}

TEST_CASE("A folder is refused if it is a file or holds other things, and taken away on request",
          "[unit][record][files]") {
  const Folder folder("files_output");
  constexpr std::array<std::string_view, 2> kFiles = {"mark.csv", "other.csv"};
  const fs::path deep = folder.path / "a" / "b";
  {
    const OutputFolder made(deep, "mark.csv", kFiles);
    write_file(deep / "mark.csv", "x\n");
    CHECK(fs::exists(deep / "mark.csv"));
    made.discard();
  }
  CHECK(!fs::exists(folder.path));  // all that was made is gone
  fs::create_directories(deep);
  write_file(deep / "letter.txt", "dear\n");
  CHECK_THROWS_WITH(OutputFolder(deep, "mark.csv", kFiles), Catch::Matchers::Contains("not empty"));
  CHECK_THROWS_WITH(OutputFolder(deep / "letter.txt", "mark.csv", kFiles),
                    Catch::Matchers::Contains("is a file"));
  CHECK_THROWS_AS(OutputFolder(deep / "letter.txt" / "c", "mark.csv", kFiles), CannotWrite);
  write_file(deep / "mark.csv", "x\n");
  write_file(deep / "other.csv", "x\n");
  const OutputFolder again(deep, "mark.csv", kFiles);
  CHECK(!fs::exists(deep / "other.csv"));
  again.discard();
  CHECK(content(deep / "letter.txt") == "dear\n");  // not ours
}

TEST_CASE("A damaged trajectory is refused with its file and line", "[unit][record][files]") {
  const Folder folder("files_damaged");
  fs::create_directories(folder.path);
  const auto refusal = [&](const std::string& rows) {
    write_file(folder.path / "trajectory.csv", "header\n" + rows);
    write_file(folder.path / "scene.toml",
               "[[box]]\nname = \"a\"\nsize = [1,1,1]\nmass = 1\nposition = [0,1,0]\n");
    try {
      (void)read_run(folder.path);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("not refused");
  };
  const std::string rest = ",1,0,0,0,0,0,0,0,0,0\n";  // orientation and velocities
  CHECK(refusal("0,a,0,1,0" + rest) == "not refused");
  CHECK(refusal("").find("has no frame") != std::string::npos);
  CHECK(refusal("0,a,0,1\n").find("trajectory.csv:2: 4 cells") != std::string::npos);
  CHECK(refusal("0,a,0,one,0" + rest).find(":2: one: expected a finite") != std::string::npos);
  CHECK(refusal("0,a,0,nan,0" + rest).find(":2: nan: expected a finite") != std::string::npos);
  CHECK(refusal("0,b,0,1,0" + rest).find("body b: scene.toml has no such") != std::string::npos);
  CHECK(refusal("1,a,0,1,0" + rest + "0,a,0,1,0" + rest).find(":3: time_s = 0") !=
        std::string::npos);
  CHECK_THROWS_WITH(read_run(folder.path / "nowhere"),
                    Catch::Matchers::Contains("give the folder of a run"));
}

TEST_CASE("The nearest frame is found, and a time outside the record is refused",
          "[unit][record][files]") {
  RecordedRun run;
  for (const double time : {0.0, 0.5, 1.0}) run.frames.push_back(RecordedFrame{time, {}});
  CHECK(nearest_frame(run, 0.7).time == 0.5);
  CHECK(nearest_frame(run, 0.8).time == 1.0);
  CHECK(nearest_frame(run, 1.2).time == 1.0);
  CHECK(nearest_frame(run, -0.1).time == 0.0);
  CHECK_THROWS_WITH(nearest_frame(run, 1.3), Catch::Matchers::Contains("from 0 to 1 s"));
  CHECK_THROWS_AS(nearest_frame(run, std::nan("")), std::invalid_argument);
}
