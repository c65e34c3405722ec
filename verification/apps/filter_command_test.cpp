/// \file
/// \brief Filters and halved steps from the command line.
#include "apps/command.hpp"
#include "support/test.hpp"

namespace {

// A cell of a table without quoted cells.
std::string cell(const std::string& row, int column) {
  std::istringstream in(row);
  std::string text;
  for (int k = 0; k <= column; ++k) std::getline(in, text, ',');
  return text;
}

}  // namespace

TEST_CASE("A filtered run leaves all other files as they are, and its own twice the same",
          "[unit][command][filtering]") {
  const Folder plain("filter_plain");
  const Folder one("filter_one");
  const Folder two("filter_two");
  const std::string rest =
      "run dice --set count=2 --duration 0.7083 --contacts --quiet --force --out ";
  REQUIRE(run_tumble(rest + plain.text()).code == 0);
  for (const std::string filter : {"box:5", "box:5,causal", "envelope:0.01m,1deg",
                                   "soft_envelope:10mm,0.02rad", "one_euro:1Hz"}) {
    INFO(filter);
    for (const Folder* folder : {&one, &two})
      REQUIRE(run_tumble(rest + folder->text() + " --filter " + filter).code == 0);
    for (const char* name :
         {"trajectory.csv", "metrics.csv", "events.csv", "contacts.csv", "scene.toml"})
      CHECK(content(one.path / name) == content(plain.path / name));
    CHECK(hash_of(one.path) == hash_of(plain.path));
    CHECK(content(one.path / "summary.json") == content(two.path / "summary.json"));
    const std::string shown = content(one.path / "trajectory_filtered.csv");
    CHECK(shown == content(two.path / "trajectory_filtered.csv"));
    CHECK(whole_lines(one.path / "trajectory_filtered.csv"));
    CHECK(shown != content(one.path / "trajectory.csv"));
    // The start, 42 steps and a cut one, two dice each, and the header.
    CHECK(std::ranges::count(shown, '\n') == 1 + 2 * 44);
    CHECK(content(one.path / "summary.json").find("\"filtered_frames\": 44,") != std::string::npos);
  }
  REQUIRE(run_tumble(rest + one.text()).code == 0);
  CHECK(!fs::exists(one.path / "trajectory_filtered.csv"));  // of the earlier run
  CHECK(content(one.path / "summary.json") == content(plain.path / "summary.json"));
}

TEST_CASE("The filter takes the frames that are recorded, not those between them",
          "[exact][command][filtering]") {
  const Folder folder("filter_every");
  REQUIRE(run_tumble("run bouncing_box --duration 0.4 --every 3 --filter box:3 --quiet --out " +
                     folder.text())
              .code == 0);
  // In free fall the mean of three heights, h seconds apart, is g h²/3 below the middle one.
  const auto computed = lines_of(folder.path / "trajectory.csv");
  const auto shown = lines_of(folder.path / "trajectory_filtered.csv");
  REQUIRE(computed.size() == 10);  // the header, and frames 0, 3, ... 24
  REQUIRE(shown.size() == 10);
  CHECK(shown[1] == computed[1]);
  CHECK(shown[9] == computed[9]);
  for (std::size_t k = 2; k < 9; ++k)
    CHECK(std::stod(cell(computed[k], 3)) - std::stod(cell(shown[k], 3)) ==
          near(9.81 * 0.05 * 0.05 / 3.0, 1e-12));  // [m] measured 3e-16
}

TEST_CASE("A filter that there is not ends with code 2 and one line, before anything runs",
          "[unit][command][filtering]") {
  const Folder folder("filter_mistake");
  std::vector<Refusal> cases = {
      {"--filter box:4", "box filter over 4 frames: expected an odd number"},
      {"--filter bx:5", "did you mean box?"},
      {"--filter ''", "there is none called"},
      {"--filter box:five", "\"five\" is not"},
      {"--filter envelope:0.01", "an envelope has a radius and an angle"},
      {"--filter envelope:0.01,1deg", "with the unit m or mm"},
      {"--filter", "--filter"},
      {"--halvings -1", "--halvings: -1: expected a whole number"},
      {"--halvings 2.5", "--halvings: 2.5: expected a whole number"},
      {"--halvings 21", "halvings = 21: expected 0 to 20"},
  };
  for (Refusal& c : cases)
    c.arguments = "run dice --duration 1 --out " + folder.text() + " " + c.arguments;
  check_refused(cases);
  CHECK(!fs::exists(folder.path));
}

TEST_CASE("An interrupted run has as many filtered frames as recorded ones",
          "[unit][command][filtering]") {
  const Folder folder("filter_interrupted");
  const Outcome outcome =
      shell(std::string("timeout -s INT 0.5 ") + TUMBLE_COMMAND +
            " run cage --duration 1e6 --quiet --filter box:9 --out " + folder.text());
  INFO(outcome.text);
  CHECK_THAT(outcome.text, Contains("interrupted at"));
  CHECK(whole_lines(folder.path / "trajectory_filtered.csv"));
  CHECK(lines_of(folder.path / "trajectory_filtered.csv").size() ==
        lines_of(folder.path / "trajectory.csv").size());
}

TEST_CASE("Filters are listed with the form in which they are written",
          "[unit][command][filtering]") {
  const Outcome outcome = run_tumble("filters");
  CHECK(outcome.code == 0);
  for (const char* message : {"box[:FRAMES=5[,causal]]", "envelope:RADIUS,ANGLE",
                              "soft_envelope:RADIUS", "one_euro:CUTOFF"})
    CHECK_THAT(outcome.text, Contains(message));
  CHECK(std::ranges::count(outcome.text, '\n') == 4);
  CHECK(run_tumble("run --help").text.find("tumble filters") != std::string::npos);
  CHECK(run_tumble("filers").text.find("did you mean filters?") != std::string::npos);
}

TEST_CASE("A halved step keeps the times of the frames, and no halving keeps the hash",
          "[unit][command][filtering]") {
  const Folder plain("halvings_plain");
  const Folder never("halvings_never");
  const Folder halved("halvings_some");
  const Folder again("halvings_again");
  const std::string rest = "run dice --technique damped --duration 0.8 --quiet --out ";
  run_tumble(rest + plain.text());
  run_tumble(rest + never.text() + " --halvings 0");
  run_tumble(rest + halved.text() + " --halvings 3");
  run_tumble(rest + again.text() + " --halvings 3");
  CHECK(hash_of(plain.path) != "none");
  CHECK(hash_of(never.path) == hash_of(plain.path));
  CHECK(content(never.path / "summary.json") == content(plain.path / "summary.json"));
  CHECK(hash_of(halved.path) != hash_of(plain.path));
  CHECK(hash_of(halved.path) == hash_of(again.path));
  CHECK(content(halved.path / "summary.json").find("\"halvings\": 3,") != std::string::npos);
  CHECK(content(plain.path / "summary.json").find("\"halvings\": 0,") != std::string::npos);
  const auto one = lines_of(plain.path / "trajectory.csv");
  const auto two = lines_of(halved.path / "trajectory.csv");
  REQUIRE(one.size() == two.size());
  for (std::size_t k = 0; k < one.size(); ++k) CHECK(cell(one[k], 0) == cell(two[k], 0));
}

TEST_CASE("A run is drawn as its filter showed it, beside the picture of what was computed",
          "[unit][command][filtering]") {
  const Folder folder("filter_drawn");
  const std::string rest = "run bouncing_box --duration 0.4 --quiet --force --out " + folder.text();
  REQUIRE(run_tumble(rest).code == 0);
  const std::string draw = "render " + folder.text() + " --as svg --at 0.2";
  const Outcome missing = tumble_ends(2, draw + " --filtered");
  CHECK_THAT(missing.text,
             Contains("trajectory_filtered.csv: there is none: run the scene with --filter"));
  REQUIRE(run_tumble(rest + " --filter box:9").code == 0);
  CHECK(run_tumble(draw).code == 0);
  CHECK(run_tumble(draw + " --filtered").code == 0);
  const std::string computed = content(folder.path / "picture.svg");
  const std::string shown = content(folder.path / "picture_filtered.svg");
  CHECK(computed.find("</svg>") != std::string::npos);
  CHECK(shown.find("</svg>") != std::string::npos);
  CHECK(shown != computed);
}
