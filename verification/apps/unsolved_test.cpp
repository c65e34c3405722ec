/// \file
/// \brief A run that ends on a problem without an answer leaves the problem behind.
#include "apps/command.hpp"
#include "support/catch.hpp"

using namespace tumble::test;

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
  CHECK(run.text.find("unsolved_A.mtx") != std::string::npos);
  CHECK(run.text.find("unsolved_b.mtx") != std::string::npos);
  CHECK(content(folder.path / "summary.json").find("\"end\": \"failed\"") != std::string::npos);
  const std::string again =
      "lcp --matrix " + path + "/unsolved_A.mtx --vector " + path + "/unsolved_b.mtx --solver ";
  const Outcome first = run_tumble(again + "baraff_as_printed");
  const Outcome second = run_tumble(again + "baraff_as_printed");
  CHECK(first.text == second.text);
  // Another solver finds the forces.
  CHECK(run_tumble(again + "baraff").code == 0);
}
