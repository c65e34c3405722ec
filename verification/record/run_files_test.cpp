/// \file
/// \brief The files of a run: what they hold, and that they read back to the same bits.
#include "tumble/record/run_files.hpp"

#include "tumble/basic_colliding/basic.hpp"
#include "tumble/record/metrics.hpp"
#include "tumble/record/recorded_run.hpp"
#include "tumble/record/table_file.hpp"

#include "support/files.hpp"
#include "support/test.hpp"

#include <fstream>
#include <sys/stat.h>

namespace {

// Keeps every state that a run goes through.
struct Keeper : RunObserver {
  std::vector<World> worlds;
  void on_begin(const World& world) override { worlds.push_back(world); }
  void on_step(const World& world, const Technique&, const StepReport&, const Metrics&) override {
    worlds.push_back(world);
  }
};

Scene two_boxes() {
  Scene scene = make_scene("two_boxes");
  scene.boxes[0].name = "a \"left\", one";  // a name that CSV has to quote
  return checked(scene);
}

RunDescription description() {
  RunDescription d{.scene = "two_boxes",
                   .technique = "basic",
                   .scene_settings = scene_recipe("two_boxes").parameters()};
  d.run.duration = 0.625;  // [s] 37.5 steps; the collision is at 0.5 s
  d.contacts = true;
  d.ignored_physics = {"friction"};
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
  const std::string last = lines_of(folder.path / "trajectory.csv").back();
  std::ofstream(folder.path / "trajectory.csv", std::ios::app) << last << "\n";
  CHECK_THROWS_WITH(read_run(folder.path), Contains("right: twice in one frame"));
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
  CHECK(std::stod(event[0]) == near(0.5, 2e-6));   // 1 m at 2 m/s, found to 1 µs
  CHECK(std::stod(event[6]) == near(1.0, 1e-12));  // from first to second

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
  CHECK(fs::exists(folder.path / "contacts.csv"));  // not before this run has done a step
  Basic basic;
  int steps = 0;
  struct Look : RunObserver {
    std::function<void()> look;
    void on_step(const World&, const Technique&, const StepReport&, const Metrics&) override {
      look();
    }
  } look;
  look.look = [&] {
    ++steps;
    CHECK(!fs::exists(folder.path / "contacts.csv"));
    CHECK(!fs::exists(folder.path / "summary.json"));  // not before the run is over
  };
  const std::array<RunObserver*, 2> observers = {&files, &look};
  files.finish(run_scene(scene, basic, d.run, observers));
  CHECK(steps > 0);
  CHECK(fs::exists(folder.path / "summary.json"));
}

TEST_CASE("A folder is refused if it is a file, holds other things or is in use",
          "[unit][record][files]") {
  const Folder folder("files_output");
  constexpr std::array<std::string_view, 2> kFiles = {"one.csv", "other.csv"};
  const fs::path deep = folder.path / "a" / "b";
  {
    const OutputFolder made(deep, "run", kFiles);
    write_file(made.path() / "one.csv", "x\n");
    CHECK(!fs::exists(deep / "one.csv"));
  }
  CHECK(!fs::exists(folder.path));  // all that was made is gone
  fs::create_directories(deep);
  write_file(deep / "letter.txt", "dear\n");
  write_file(deep / "one.csv", "of another program\n");
  CHECK_THROWS_WITH(OutputFolder(deep, "run", kFiles), Contains("not empty"));
  CHECK_THROWS_WITH(OutputFolder(deep / "letter.txt", "run", kFiles), Contains("is a file"));
  CHECK_THROWS_AS(OutputFolder(deep / "letter.txt" / "c", "run", kFiles), CannotWrite);
  const fs::path used = folder.path / "used";
  {
    OutputFolder first(used, "run", kFiles);
    write_file(first.path() / "one.csv", "first\n");
    write_file(first.path() / "other.csv", "first\n");
    first.publish();
    CHECK_THROWS_WITH(OutputFolder(used, "run", kFiles), Contains("being written by another"));
  }
  write_file(used / "letter.txt", "dear\n");
  CHECK_THROWS_WITH(OutputFolder(used, "comparison", kFiles),
                    Contains("not the folder of a comparison"));
  {
    const OutputFolder refused(used, "run", kFiles);
    write_file(refused.path() / "one.csv", "second\n");
  }
  CHECK(content(used / "one.csv") == "first\n");
  {
    OutputFolder second(used, "run", kFiles);
    write_file(second.path() / "one.csv", "second\n");
    second.publish();
  }
  CHECK(content(used / "one.csv") == "second\n");
  CHECK(!fs::exists(used / "other.csv"));
  CHECK(content(used / "letter.txt") == "dear\n");  // not ours
}

TEST_CASE("A mark that is no file makes no folder a run's, and is not waited for",
          "[unit][record][files]") {
  const Folder folder("files_mark");
  constexpr std::array<std::string_view, 1> kFiles = {"one.csv"};
  const fs::path mark = folder.path / ".tumble";
  fs::create_directories(folder.path);
  const auto refused = [&] {
    CHECK_THROWS_WITH(OutputFolder(folder.path, "run", kFiles),
                      Contains("not the folder of a run"));
    fs::remove(mark);
  };
  fs::create_symlink("/dev/zero", mark);  // has no end
  refused();
  REQUIRE(mkfifo(mark.c_str(), 0600) == 0);  // nothing writes into it
  refused();
  fs::create_directory(mark);
  refused();
}

TEST_CASE("A file is written beside a link, not through it", "[unit][record][files]") {
  const Folder folder("files_links");
  fs::create_directories(folder.path);
  const fs::path letter = folder.path / "letter.txt";
  write_file(letter, "dear\n");
  for (const char* link : {"picture.gp", "film.gif.part"})
    fs::create_symlink(letter, folder.path / link);
  write_file(folder.path / "picture.gp", "plot\n");
  write_file(folder.path / "film.gif", "film\n");
  CHECK(content(letter) == "dear\n");
  CHECK(content(folder.path / "picture.gp") == "plot\n");
  CHECK(content(folder.path / "film.gif") == "film\n");
}
