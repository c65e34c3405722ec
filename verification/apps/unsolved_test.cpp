/// \file
/// \brief A run that ends on a problem without an answer leaves the problem behind.
#include "apps/command.hpp"
#include "support/test.hpp"

#include <filesystem>
#include <fstream>

TEST_CASE("A run that a solver cannot go on with ends with 3 and leaves the problem to tumble lcp",
          "[unit][apps][analytic]") {
  const Folder folder("unsolved_run");
  const std::string path = folder.path.string();
  const Outcome run = run_tumble(
      "run stack --technique analytic --set technique.solver=baraff_as_printed --duration 2 "
      "--quiet --out " +
      path);
  CAPTURE(run.text);
  REQUIRE(run.code == 3);
  CHECK_THAT(run.text, Contains("unsolved_A.mtx"));
  CHECK_THAT(run.text, Contains("unsolved_b.mtx"));
  CHECK(content(folder.path / "summary.json").find("\"end\": \"failed\"") != std::string::npos);
  const std::string again =
      "lcp --matrix " + path + "/unsolved_A.mtx --vector " + path + "/unsolved_b.mtx --solver ";
  const Outcome first = run_tumble(again + "baraff_as_printed");
  const Outcome second = run_tumble(again + "baraff_as_printed");
  CHECK(first.text == second.text);
  // Another solver finds the forces.
  CHECK(run_tumble(again + "baraff").code == 0);
}

TEST_CASE("A user's mistake ends with 2, what is found inside a step with 3, the first step too",
          "[unit][command]") {
  const Folder folder("broken_step");
  const std::string file = folder.file("fast.toml").string();
  std::ofstream(file) << "[[box]]\nsize = [1, 1, 1]\nmass = 1\nposition = [0, 1, 0]\n"
                         "velocity = [2.9e8, 0, 0]\n"
                         "[[box]]\nsize = [1, 1, 1]\nmass = 1\nposition = [2, 1, 0]\n";
  const auto run = [&](const std::string& technique) {
    const std::string out = " --quiet --out " + folder.text() + "/" + technique;
    return run_tumble("run " + file + " --dt 1e20 --duration 1e20 --technique " + technique + out);
  };
  const Outcome user = run("basic");  // its resolution is an option
  CHECK(user.code == 2);
  CHECK_THAT(user.text, Contains("expected more than rounding of a flight of 1e+20 s"));
  CHECK(!fs::exists(folder.path / "basic"));
  const Outcome step = run("contact_damped");  // that of its search is not
  INFO(step.text);
  CHECK(step.code == 3);
  CHECK_THAT(step.text, Contains("contact_damped stopped at 0 s"));
  CHECK(fs::exists(folder.path / "contact_damped" / "summary.json"));
}
