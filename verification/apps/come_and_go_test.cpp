/// \file
/// \brief A run of a scene in which boxes come and go, from outside.
#include "apps/command.hpp"
#include "support/test.hpp"

TEST_CASE(
    "A run of a scene in which boxes come and go repeats its hash and has rows for the boxes that "
    "are there",
    "[unit][command]") {
  const Folder files("come_and_go");
  const Folder one("come_and_go_one");
  const Folder two("come_and_go_two");
  const std::string file = files.file("mine.toml").string();
  std::ofstream(file) << R"(
[ground]
[[box]]
name = "support"
size = [1, 1, 1]
mass = 1
position = [0, 0.5, 0]
disappears = 0.25
[[box]]
name = "rider"
size = [1, 1, 1]
mass = 1
position = [0, 1.5, 0]
[[box]]
name = "shot"
size = [0.5, 0.5, 0.5]
mass = 0.125
position = [-4, 1, 0]
velocity = [20, 0, 0]
appears = 0.125
disappears = 0.25
)";
  const std::string rest = " --dt 0.015625 --duration 0.75 --quiet --force --contacts --out ";
  for (const std::string options :
       {"", " --filter box:5", " --filter envelope:5mm,1deg", " --halvings 3",
        " --technique damped", " --technique impulse --set sleeping=on"}) {
    INFO(options);
    const Outcome first = run_tumble("run " + file + options + rest + one.text());
    INFO(first.text);
    REQUIRE(first.code == 0);
    REQUIRE(run_tumble("run " + one.text() + "/scene.toml" + options + rest + two.text()).code ==
            0);
    CHECK(hash_of(one.path) != "none");
    CHECK(hash_of(one.path) == hash_of(two.path));
    for (const char* table : {"trajectory.csv", "trajectory_filtered.csv"}) {
      if (!fs::exists(one.path / table)) continue;
      INFO(table);
      std::istringstream rows(content(one.path / table));
      int support = 0;
      int rider = 0;
      int shot = 0;
      std::string last_support;
      for (std::string row; std::getline(rows, row);) {
        if (row.find(",support,") != std::string::npos) last_support = row;
        support += row.find(",support,") != std::string::npos ? 1 : 0;
        rider += row.find(",rider,") != std::string::npos ? 1 : 0;
        shot += row.find(",shot,") != std::string::npos ? 1 : 0;
      }
      CHECK(rider == 49);    // 48 steps and the start
      CHECK(support == 17);  // up to 0.25 s
      CHECK(last_support.find("0.25,") == 0);
      CHECK(shot == 8);  // from the end of its first step
      CHECK(whole_lines(one.path / table));
    }
    for (const char* time : {"0.1", "0.2", "0.5"})
      CHECK(run_tumble("render " + one.text() + " --as svg --at " + time).code == 0);
  }
  // The rider has fallen to the ground.
  const std::string trajectory = content(one.path / "trajectory.csv");
  const std::string last = trajectory.substr(trajectory.rfind(",rider,"));
  CHECK(std::abs(std::stod(last.substr(last.find(',', 7) + 1)) - 0.5) < 0.05);
  CHECK(run_tumble("stability " + file).code == 0);
}
