/// \file
/// \brief `tumble lcp` from outside: answers, exit codes, messages; runs that end on a problem without an answer.
#include "tumble/lcp_solvers/lcp.hpp"
#include "tumble/record/matrix_market.hpp"
#include "tumble/record/table_file.hpp"

#include "apps/command.hpp"
#include "support/test.hpp"

#include <filesystem>
#include <fstream>

namespace {

// A problem in files of a folder of its own, and the command that solves it.
struct Files {
  explicit Files(const char* name) : folder(name) {
    std::filesystem::create_directories(folder.path);
  }

  void write(const MatX& matrix, const MatX& vector) const {
    write_file(folder.path / "A.mtx", to_matrix_market(matrix));
    write_file(folder.path / "b.mtx", to_matrix_market(vector));
  }

  [[nodiscard]] Outcome solve(const std::string& options = "") const {
    return run_tumble("lcp --matrix " + folder.text() + "/A.mtx --vector " + folder.text() +
                      "/b.mtx " + options);
  }

  Folder folder;
};

// The numbers of a list in a JSON text.
std::vector<double> list_of(const std::string& json, const std::string& name) {
  const std::size_t begin = json.find("\"" + name + "\": [");
  if (begin == std::string::npos) return {};
  std::string text = json.substr(begin + name.size() + 5);
  text.resize(text.find(']'));
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream in(text);
  std::vector<double> values;
  for (double value = 0.0; in >> value;) values.push_back(value);
  return values;
}

}  // namespace

TEST_CASE("The command prints forces and accelerations of a problem in files", "[unit][command]") {
  const Files files("lcp_hand");
  // Three contacts in a row: the middle one parts.
  files.write(MatX({{2, -1, 0}, {-1, 2, -1}, {0, -1, 2}}), MatX({{-1}, {2}, {-1}}));
  const Outcome outcome = files.solve();
  INFO(outcome.text);
  CHECK(outcome.code == 0);
  CHECK_THAT(outcome.text, Contains("\"solver\": \"lemke\"") &&
                               Contains("\"status\": \"solved\"") && Contains("\"pivots\": ") &&
                               Contains("\"residual\": "));
  CHECK(list_of(outcome.text, "f") == std::vector<double>{0.5, 0.0, 0.5});
  CHECK(list_of(outcome.text, "a") == std::vector<double>{0.0, 1.0, 0.0});
}

TEST_CASE(
    "Every solver that works on a matrix solves a file with whole numbers, symmetric and sparse",
    "[unit][command]") {
  const Files files("lcp_solvers");
  // ((4, 3), (3, 4)), (-1, -4): the first contact pushes at first and parts in the end.
  write_file(files.folder.path / "A.mtx",
             "%%MatrixMarket matrix coordinate integer symmetric\n2 2 3\n1 1 4\n2 1 3\n2 2 4\n");
  write_file(files.folder.path / "b.mtx",
             "%%MatrixMarket matrix array integer general\n2 1\n-1\n-4\n");
  const Outcome list = run_tumble("lcp --list");
  CHECK(list.code == 0);
  std::istringstream lines(list.text);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    const std::string name = line.substr(0, line.find(' '));
    if (name.find("as_printed") != std::string::npos) continue;  // may fail, that is its point
    const Outcome outcome = files.solve("--solver " + name);
    INFO(outcome.text);
    CHECK(outcome.code == 0);
    CHECK_THAT(outcome.text, Contains("\"solver\": \"" + name + "\""));
    const std::vector<double> f = list_of(outcome.text, "f"), a = list_of(outcome.text, "a");
    REQUIRE(f.size() == 2);
    REQUIRE(a.size() == 2);
    CHECK(std::abs(f[0]) + std::abs(f[1] - 1.0) < 1e-6);  // [-] iterations stop at their tolerance
    CHECK(std::abs(a[0] - 2.0) + std::abs(a[1]) < 1e-6);
  }
  CHECK(count == lcp_solvers().size());
}

TEST_CASE("A problem without solution ends with code 3 and says so", "[unit][command]") {
  const Files files("lcp_infeasible");
  files.write(MatX({{1, -1}, {-1, 1}}), MatX({{-1}, {-1}}));  // squeezed from both sides
  for (const std::string solver : {"lemke", "baraff"}) {
    const Outcome outcome = files.solve("--solver " + solver);
    INFO(outcome.text);
    CHECK(outcome.code == 3);
    CHECK_THAT(outcome.text, Contains("\"status\": \"infeasible\""));
  }
}

TEST_CASE("Rows may be equalities, whose force has any sign", "[unit][command]") {
  const Files files("lcp_equalities");
  files.write(MatX({{2, 1, 0}, {1, 2, 0}, {0, 0, 1}}), MatX({{4}, {0}, {1}}));
  const Outcome glued = files.solve("--equalities 1");
  INFO(glued.text);
  CHECK(glued.code == 0);
  CHECK(list_of(glued.text, "f")[0] < -2.6);  // -8/3, and contact 2 pushes with 4/3
  CHECK(list_of(files.solve("--equalities 1,3-3").text, "f")[2] == -1.0);
  CHECK(list_of(files.solve("--equalities 1-3").text, "a") == std::vector<double>{0, 0, 0});
}

TEST_CASE("A problem that cannot be read ends with code 2 and one line that says why",
          "[unit][command]") {
  const Files files("lcp_bad");
  files.write(MatX({{1, 2}, {0, 1}}), MatX({{-1}, {-1}}));
  const std::string dir = files.folder.text();
  write_file(files.folder.path / "row.mtx", to_matrix_market(MatX({{1, 2}})));
  write_file(files.folder.path / "cut.mtx", "%%MatrixMarket matrix array real general\n2 1\n1\n");
  const auto arguments = [&](const std::string& matrix, const std::string& vector) {
    return "lcp --matrix " + dir + "/" + matrix + " --vector " + dir + "/" + vector;
  };
  check_refused({
      {"lcp", "--matrix and --vector are needed"},
      {"lcp --matrix " + dir + "/A.mtx", "--matrix and --vector are needed"},
      {arguments("none.mtx", "b.mtx"), "none.mtx: cannot be read: there is no such file"},
      {arguments("row.mtx", "b.mtx"), "row.mtx: 1 by 2: expected a square matrix"},
      {arguments("A.mtx", "row.mtx"), "row.mtx: 1 by 2: expected 2 by 1"},
      {arguments("A.mtx", "A.mtx"), "A.mtx: 2 by 2: expected 2 by 1"},
      {arguments("A.mtx", "cut.mtx"), "cut.mtx:3: the file ends here: expected one number"},
      {arguments("A.mtx", "b.mtx") + " --solver lemkee", "lemke"},
      {arguments("A.mtx", "b.mtx") + " --solver baraff", "symmetric"},
      {arguments("A.mtx", "b.mtx") + " --equalities 3",
       "--equalities: 3: expected rows from 1 to 2"},
      {arguments("A.mtx", "b.mtx") + " --equalities 1,",
       "--equalities: a row is missing: expected rows from 1 to 2"},
      {arguments("A.mtx", "b.mtx") + " --equalities 0-2", "--equalities: 0: expected rows from 1"},
      {arguments("A.mtx", "b.mtx") + " --equalities 2-1", "2-1: expected the smaller row first"},
  });
}

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
  const Outcome step = run("contact_damped");  // that of its search is a share of the step
  INFO(step.text);
  CHECK(step.code == 3);
  CHECK_THAT(step.text, Contains("box1 is left 1 m deep in another body"));
  CHECK(fs::exists(folder.path / "contact_damped" / "summary.json"));
}
