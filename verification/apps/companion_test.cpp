/// \file
/// \brief The command as a companion: nothing is lost, two runs are compared, a run is seen in the browser.
#include "apps/command.hpp"
#include "support/test.hpp"

TEST_CASE("A finished run is replaced only with --force, and without --out never",
          "[unit][command]") {
  const Folder folder("finished");
  const std::string out = " --quiet --out " + folder.text();
  REQUIRE(run_tumble("run box_drop --duration 0.1" + out).code == 0);
  const std::string before = content(folder.path / "summary.json");
  check_refused({{"run box_drop --duration 0.2" + out, "holds a run: give another"}});
  CHECK(content(folder.path / "summary.json") == before);
  CHECK(run_tumble("run box_drop --duration 0.2 --force" + out).code == 0);
  CHECK(content(folder.path / "summary.json") != before);
  const std::string there = "cd " + folder.text() + " && " + TUMBLE_COMMAND + " run box_drop ";
  for (const char* duration : {"0.1", "0.2", "0.3"})
    REQUIRE(shell(there + "--quiet --duration " + duration).code == 0);
  const fs::path runs = folder.path / "runs";
  CHECK(content(runs / "box_drop-contact_damped/summary.json").find("duration_s\": 0.1,") !=
        std::string::npos);
  CHECK(content(runs / "box_drop-contact_damped-2/summary.json").find("duration_s\": 0.2,") !=
        std::string::npos);
  CHECK(fs::exists(runs / "box_drop-contact_damped-3/summary.json"));
}

TEST_CASE("A run says what to look at next, and help has examples and the format of scenes",
          "[unit][command]") {
  const Folder folder("next");
  const Outcome run = run_tumble("run box_drop --duration 0.1 --out " + folder.text());
  CHECK_THAT(run.text, Contains("tumble view " + folder.text() + "\n"));
  CHECK_THAT(run.text, Contains("tumble render " + folder.text() + " --as gif\n"));
  for (const char* command : {"run", "view"}) {
    const Outcome help = run_tumble(std::string(command) + " --help");
    CHECK_THAT(help.text, Contains("tumble run dice --duration 2"));
    CHECK_THAT(help.text, Contains("tumble scenes two_boxes --toml > mine.toml"));
  }
  CHECK_THAT(run_tumble("--help").text, Contains("tumble view pyramid"));
  CHECK_THAT(run_tumble("render --help").text, Contains("--as gif"));
}

TEST_CASE("Lists of the command have lines of at most 110 characters", "[unit][command]") {
  for (const char* list : {"techniques", "scenes", "techniques damped", "techniques glued"}) {
    std::istringstream lines(run_tumble(list).text);
    for (std::string line; std::getline(lines, line);) {
      INFO(line);
      CHECK(line.size() <= 110);
    }
  }
}

TEST_CASE("Two runs are compared bit by bit: the first frame and body that differ are named",
          "[unit][command]") {
  const Folder one("diff_one");
  const Folder two("diff_two");
  const std::string rest = "run two_boxes --duration 0.2 --quiet --force --out ";
  REQUIRE(run_tumble(rest + one.text()).code == 0);
  REQUIRE(run_tumble(rest + two.text()).code == 0);
  const std::string both = "diff " + one.text() + " " + two.text();
  const Outcome equal = run_tumble(both);
  CHECK(equal.code == 0);
  CHECK_THAT(equal.text, Contains("equal: 13 frames have the same bits"));

  // The last bit of the first body's height in frame 4; line 1 is the header, each frame has two bodies.
  std::vector<std::string> lines = lines_of(two.path / "trajectory.csv");
  std::string& row = lines.at(1 + 2 * 4);
  const std::string name =
      row.substr(row.find(',') + 1, row.find(',', row.find(',') + 1) - row.find(',') - 1);
  const std::size_t height = row.find(',', row.find(name) + name.size() + 1) + 1;
  const std::string number = row.substr(height, row.find(',', height) - height);
  std::ostringstream next;
  next.precision(17);
  next << std::nextafter(std::stod(number), 1e9);
  row.replace(height, number.size(), next.str());
  std::ofstream file(two.path / "trajectory.csv");
  for (const std::string& line : lines) file << line << '\n';
  file.close();
  const Outcome parted = tumble_ends(1, both);
  CHECK_THAT(parted.text, Contains("s, frame 4:\n  " + name + ": position by "));
  CHECK_THAT(parted.text, !Contains("velocity by"));
  CHECK_THAT(parted.text, Contains("frames 0 (the start) to 3 are equal"));

  REQUIRE(run_tumble("run two_boxes --duration 0.1 --quiet --force --out " + two.text()).code == 0);
  const Outcome shorter = run_tumble(both);
  CHECK(shorter.code == 1);
  CHECK_THAT(shorter.text, Contains("then the first run continues to 0.2"));
  REQUIRE(run_tumble("run stack --duration 0.1 --quiet --force --out " + two.text()).code == 0);
  CHECK_THAT(run_tumble(both).text,
             Contains("frame 0 is the start: these are other scenes or settings"));
  check_refused({{"diff " + one.text() + " /nowhere", "cannot be read"}});
}

TEST_CASE("A run is shown as one page that holds all of it, whatever its boxes are called",
          "[unit][command]") {
  const Folder folder("view");
  const std::string scene = folder.file("odd.toml").string();
  std::ofstream(scene) << "title = \"a < b & c\"\n[[box]]\nname = \"</script>@VIEW@\"\nmass = 1\n"
                          "size = [1, 1, 1]\nposition = [0, 3, 0]\n";
  const std::string out = folder.text() + "/run";
  const Outcome outcome =
      run_tumble("view " + scene + " --duration 0.2 --no-browser --quiet --out " + out);
  INFO(outcome.text);
  REQUIRE(outcome.code == 0);
  const std::string page = content(out + "/view.html");
  CHECK(page.find("<title>a &lt; b &amp; c, run</title>") != std::string::npos);
  CHECK(page.find("\\u003c/script>@VIEW@") != std::string::npos);
  CHECK(page.find("data:application/octet-stream;base64,") != std::string::npos);
  CHECK(page.find("@RUN@") == std::string::npos);
  CHECK(page.find("http") == std::string::npos);  // nothing is loaded from elsewhere
  fs::remove(out + "/view.html");
  CHECK(run_tumble("view " + out + " --no-browser").code == 0);
  CHECK(content(out + "/view.html") == page);
}

TEST_CASE("Other shapes than boxes are refused by name", "[unit][command]") {
  const Folder folder("shapes");
  const std::string scene = folder.file("ball.toml").string();
  std::ofstream(scene) << "[[sphere]]\nradius = 1\n";
  check_refused({{"run " + scene, ": boxes only, no other shape is simulated"}});
}

TEST_CASE("A figure is found by the beginning of its name, and a mistyped one is suggested",
          "[unit][command]") {
  const std::string draw = std::string(TUMBLE_SOURCE_DIR) + "/figures/draw --program ";
  CHECK(shell(draw + "fig5_6").text == "reproduce_geometric_stability\n");
  CHECK(shell(draw + "zeno").text == "reproduce_basic_colliding\n");
  CHECK(shell(draw + "zenoo").text == "no figure 'zenoo'; did you mean zeno?\n");
  CHECK_THAT(shell(draw + "fig5_").text, Contains("did you mean fig5_1_order, fig5_2_friction,"));
  CHECK(shell(draw + "fig5_").code == 2);
  CHECK_THAT(shell(draw + "''").text, Contains("there are: "));
}
