/// \file
/// \brief `tumble compare` and `tumble render`: pictures, and messages where none can be drawn.
#include "apps/command.hpp"
#include "support/test.hpp"

namespace {

bool has_gnuplot() { return shell("command -v gnuplot").code == 0; }

// A path in which no program is.
std::string without_programs() { return "PATH=/nowhere " + std::string(TUMBLE_COMMAND) + " "; }

}  // namespace

TEST_CASE("A comparison leaves tables, a scene and a picture, the same on every run",
          "[unit][command]") {
  const Folder one("compare_one");
  const Folder two("compare_two");
  const std::string rest = "compare bouncing_box --techniques basic --duration 0.5 --out ";
  const Outcome outcome = tumble_ends(0, rest + one.text());
  CHECK_THAT(outcome.text, Contains("one technique only (basic)"));
  CHECK(run_tumble(rest + two.text()).code == 0);
  CHECK(run_tumble(rest + two.text()).code == 2);
  CHECK(run_tumble(rest + two.text() + " --force").code == 0);  // its own folder may be used again
  CHECK(content(one.path / "compare.csv").find("\nbasic,complete,done,30,") != std::string::npos);
  const std::string series = content(one.path / "series.csv");
  CHECK(std::ranges::count(series, '\n') == 31);
  for (const char* file : {"compare.csv", "series.csv", "scene.toml", "compare.gp"}) {
    INFO(file);
    CHECK(!content(one.path / file).empty());
    CHECK(content(one.path / file) == content(two.path / file));
  }
  if (!has_gnuplot()) return;
  CHECK(content(one.path / "compare.svg").find("</svg>") != std::string::npos);
  CHECK(content(one.path / "compare.svg") == content(two.path / "compare.svg"));
}

TEST_CASE("The picture of a comparison has room for the names of all techniques",
          "[unit][command]") {
  const Folder folder("compare_all");
  const Outcome outcome =
      tumble_ends(0, "compare bouncing_box --duration 0.1 --out " + folder.text());
  CHECK(outcome.text.find("arning") == std::string::npos);  // of gnuplot
}

TEST_CASE("A technique that takes too long is marked as such in the comparison",
          "[unit][command]") {
  const Folder folder("limit");
  const Outcome outcome =
      tumble_ends(0, "compare cage --duration 100000 --limit 0.1 --quiet --out " + folder.text());
  CHECK(content(folder.path / "compare.csv").find("basic,time_limit") != std::string::npos);
}

TEST_CASE("A comparison marks what no scene can do, and what refuses the scene",
          "[unit][command]") {
  const Folder fell("unphysical"), joined("refused");
  CHECK(run_tumble("compare bouncing_box --techniques glued --duration 1 --out " + fell.text())
            .text.find("3.9 m deep in another body") != std::string::npos);
  CHECK(content(fell.path / "compare.csv").find("\nglued,unphysical,") != std::string::npos);
  const Outcome outcome =
      run_tumble("compare chain --techniques basic,glued --duration 0.1 --out " + joined.text());
  INFO(outcome.text);
  CHECK_THAT(outcome.text, Contains("refused by basic: the technique does not support joints"));
  CHECK(content(joined.path / "compare.csv").find("\nbasic,refused,") != std::string::npos);
  CHECK(content(joined.path / "compare.csv").find("\nglued,complete,") != std::string::npos);
}

TEST_CASE("Where gnuplot is missing its package is named", "[unit][command]") {
  const Folder compared("no_gnuplot_compare");
  const Outcome table =
      shell(without_programs() + "compare bouncing_box --duration 0.1 --out " + compared.text());
  CHECK(table.code == 0);  // the numbers are there
  CHECK_THAT(table.text, Contains("no picture: "));
  CHECK_THAT(table.text, Contains("gnuplot-nox"));
  CHECK(!content(compared.path / "compare.csv").empty());
}

TEST_CASE("Frames of a run are drawn as SVG and PNG, one or several", "[unit][command]") {
  const Folder folder("render's folder");  // with a quote and a space in its name
  const std::string quoted = "\"" + folder.text() + "\"";
  REQUIRE(run_tumble("run dice --duration 0.4 --quiet --out " + quoted).code == 0);
  const auto draw = [&](const std::string& options) {
    const Outcome outcome = shell_ends(0, without_programs() + "render " + quoted + " " + options);
    std::string path = outcome.text.substr(0, outcome.text.find('\n'));
    CHECK(path.find(folder.text()) == 0);
    const std::string picture = content(path);
    fs::remove(path);
    return picture;
  };
  const std::string last = draw("--as svg");
  CHECK(last.find("</svg>") != std::string::npos);
  CHECK(draw("--as svg --at 0.4") == last);  // the last frame, and the same bytes again
  const std::string first = draw("--as svg --at 0");
  CHECK(first.find("</svg>") != std::string::npos);
  CHECK(first != last);
  CHECK(draw("--as svg --view 1,1,1") != last);
  const std::string strip = draw("--as svg --strip 0,0.2,0.4,0.3");
  CHECK(strip.find("0.20 s") != std::string::npos);
  CHECK(strip.find("0.40 s") != std::string::npos);
  const std::string png = draw("--as png --strip 0,0.1,0.2,0.3");
  CHECK(png.substr(1, 3) == "PNG");
  CHECK(png.substr(16, 8) ==
        std::string("\0\0\x07\x08\0\0\x03\x84", 8));  // 1800 x 900: three and one
  CHECK(!fs::exists(folder.path / "picture.svg.part"));

  for (const char* wrong : {"--at 0.5", "--at nan", "--strip 0,7", "--view 0,1,0", "--view 1,2",
                            "--at 0.1 --strip 0,0.1"}) {
    const Outcome outcome = tumble_ends(2, "render " + quoted + " --as svg " + wrong);
    CHECK(std::ranges::count(outcome.text, '\n') == 1);
    CHECK(!fs::exists(folder.path / "picture.svg"));
  }
}
