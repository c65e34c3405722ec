/// \file
/// \brief Safety of files: the command destroys nothing that it did not write, and ends in time.
#include "apps/command.hpp"
#include "support/test.hpp"

#include <chrono>

namespace {

const std::string kTumble = TUMBLE_COMMAND;

}  // namespace

TEST_CASE("A run that is refused leaves the run before it, and a user's scene, as they were",
          "[unit][command]") {
  const Folder folder("refused_run");
  const std::string out = " --quiet --force --out " + folder.text();
  REQUIRE(run_tumble("run box_drop --duration 0.1" + out).code == 0);
  const std::string summary = content(folder.path / "summary.json");
  const std::string trajectory = content(folder.path / "trajectory.csv");
  // Refused by the technique at the first step.
  CHECK(run_tumble("run box_drop --dt 1e300 --duration 1e301" + out).code == 2);
  CHECK(content(folder.path / "summary.json") == summary);
  CHECK(content(folder.path / "trajectory.csv") == trajectory);
  // The scene that is read lies in the folder.
  std::ofstream(folder.path / "scene.toml", std::ios::app) << "# my own comment\n";
  const Outcome own = run_tumble("run " + folder.text() + "/scene.toml" + out);
  CHECK(own.code == 2);
  CHECK_THAT(own.text, Contains("holds the scene that is read"));
  CHECK(content(folder.path / "scene.toml").find("# my own comment") != std::string::npos);
}

TEST_CASE("Of two runs into one folder the second is refused", "[unit][command]") {
  const Folder folder("two_runs");
  const std::string run = kTumble + " run stack --quiet --out " + folder.text();
  const Outcome both = shell(run + " --duration 100000 & p=$!; while ! [ -e " + folder.text() +
                             "/trajectory.csv ]; do sleep 0.02; done; " + run +
                             " --set count=3 --duration 1; echo second $?; kill $p; wait $p");
  INFO(both.text);
  CHECK_THAT(both.text, Contains("is being written by another tumble"));
  CHECK_THAT(both.text, Contains("second 2"));
  CHECK(both.code == 143);
  CHECK(run_tumble("run stack --duration 0.1 --quiet --force --out " + folder.text()).code == 0);
}

TEST_CASE("A signal ends the command within a second, wherever it waits", "[unit][command]") {
  const Folder folder("waiting");
  const std::string pipe = folder.file("scene.toml").string();
  const std::string out = " --out " + folder.text() + "/out";
  for (const std::string& arguments :
       {"run " + pipe + out, "compare " + pipe + out, "stability " + pipe,
        // One step of it takes minutes.
        "run wall --set courses=60 --set bricks=60 --technique analytic" + out}) {
    INFO(arguments);
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    const Outcome outcome = shell("mkfifo -m 600 " + pipe + " 2>/dev/null; timeout -k 20 1 " +
                                  kTumble + " " + arguments);
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    INFO(outcome.text);
    CHECK(outcome.code == 124);  // as timeout says it, not 137: killed
    CHECK(seconds < 4.0);        // on a loaded machine
  }
}

TEST_CASE("Files without an end are refused", "[unit][command]") {
  const Outcome matrix = tumble_ends(2, "lcp --matrix /dev/zero --vector /dev/zero");
  CHECK_THAT(matrix.text, Contains("has at most 256 MiB"));
  const Folder folder("endless");
  REQUIRE(run_tumble("run box_drop --duration 0.1 --quiet --out " + folder.text()).code == 0);
  const std::string row = content(folder.path / "trajectory.csv");
  const auto refused = [&](const std::string& rows, const char* message) {
    std::ofstream(folder.path / "trajectory.csv") << row << rows << '\n';
    const Outcome outcome = tumble_ends(2, "render " + folder.text() + " --as svg");
    CHECK_THAT(outcome.text, Contains(message));
    CHECK(outcome.text.find('\x1b') == std::string::npos);
    CHECK(outcome.text.size() < 500);
  };
  refused(std::string(100000, '1'), "a line of 64 KiB and more");
  refused("\x1b[31m,box1,0,0,0,1,0,0,0,0,0,0,0,0,0", "expected a finite number");
  refused("9,\x1b]0;title\x07,0,0,0,1,0,0,0,0,0,0,0,0,0", "has no such box");
  fs::remove(folder.path / "scene.toml");
  REQUIRE(shell("mkfifo " + folder.text() + "/scene.toml").code == 0);
  refused("", "is a pipe");
}

TEST_CASE("A name that no reader of tables would take is refused", "[unit][command]") {
  const Folder folder("long_name");
  const std::string file = folder.file("named.toml").string();
  const auto named = [&](std::size_t bytes) {
    std::ofstream(file) << "[[box]]\nname = \"" << std::string(bytes, 'n')
                        << "\"\nsize = [1, 1, 1]\nmass = 1\nposition = [0, 1, 0]\n";
    return run_tumble("run " + file + " --duration 0.1 --quiet --out " + folder.text() + "/run");
  };
  const Outcome refused = named(1001);
  CHECK(refused.code == 2);
  CHECK_THAT(refused.text, Contains("1001 bytes: expected at most 1000"));
  CHECK(named(1000).code == 0);
  CHECK(run_tumble("diff " + folder.text() + "/run " + folder.text() + "/run").code == 0);
}

TEST_CASE("Pictures are drawn beside links that lie in a run's folder, not through them",
          "[unit][command]") {
  if (shell("command -v gnuplot").code != 0) return;
  const Folder folder("linked");
  REQUIRE(run_tumble("run box_drop --duration 0.1 --quiet --out " + folder.text()).code == 0);
  std::ofstream(folder.path / "letter.txt") << "dear\n";
  for (const char* link : {"picture.gp", "picture.svg", "picture.svg.part"})
    fs::create_symlink("letter.txt", folder.path / link);
  CHECK(run_tumble("render " + folder.text() + " --as svg").code == 0);
  CHECK(content(folder.path / "letter.txt") == "dear\n");
}
