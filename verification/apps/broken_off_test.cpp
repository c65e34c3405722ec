/// \file
/// \brief Runs that end early: signals, full disks, programs that are missing.
#include "apps/command.hpp"
#include "support/test.hpp"

namespace {

const char* const kTables[] = {"trajectory.csv", "metrics.csv", "events.csv", "contacts.csv",
                               "timing.csv"};

}  // namespace

TEST_CASE("A run that is asked to stop says so and leaves whole lines", "[unit][command]") {
  struct Case {
    const char* signal;
    int code;
  };
  for (const Case& c : {Case{"INT", 130}, Case{"TERM", 143}}) {
    INFO(c.signal);
    const Folder folder("stopped");
    const Outcome outcome =
        shell(std::string("timeout --preserve-status -s ") + c.signal + " 0.3 " + TUMBLE_COMMAND +
              " run cage --duration 100000 --contacts --out " + folder.text());
    INFO(outcome.text);
    CHECK(outcome.code == c.code);
    CHECK_THAT(outcome.text, Contains("interrupted at"));
    CHECK_THAT(outcome.text, Contains("note: trajectory.csv will have about"));
    for (const char* name : kTables) {
      INFO(name);
      CHECK(whole_lines(folder.path / name));
    }
    const std::string summary = content(folder.path / "summary.json");
    CHECK(summary.find("\"end\": \"interrupted\"") != std::string::npos);
    CHECK(summary.substr(summary.size() - 2) == "}\n");
  }
}

TEST_CASE("A comparison that is asked to stop says so", "[unit][command]") {
  const Folder folder("stopped_compare");
  const Outcome outcome =
      shell_ends(130, std::string("timeout --preserve-status -s INT 0.3 ") + TUMBLE_COMMAND +
                          " compare cage --duration 100000 --out " + folder.text());
  CHECK(content(folder.path / "compare.csv").find("contact_damped,interrupted") !=
        std::string::npos);
  CHECK(whole_lines(folder.path / "series.csv"));
}

TEST_CASE("What cannot be written ends with exit code 4", "[unit][command]") {
  for (const char* place : {"/proc/tumble", "/dev/null/tumble"}) {
    const Outcome outcome = tumble_ends(4, std::string("run bouncing_box --out ") + place);
    CHECK_THAT(outcome.text, Contains(std::string("cannot make the folder ") + place));
  }
  if (!fs::exists("/dev/full")) return;
  const Outcome listing = run_tumble("scenes > /dev/full");
  CHECK(listing.code == 4);
  CHECK_THAT(listing.text, Contains("cannot write to the standard output"));
}

TEST_CASE("A disk that fills up during a run ends it with exit code 4 and whole lines",
          "[unit][command]") {
  // The shell's limit on the size of files, in blocks of 512 bytes, stands for the disk.
  const Folder folder("full");
  const Outcome outcome =
      shell("ulimit -f 300; " + std::string(TUMBLE_COMMAND) +
            " run cage --duration 100 --contacts --quiet --out " + folder.text());
  INFO(outcome.text);
  CHECK(outcome.code == 4);
  CHECK_THAT(outcome.text, Contains(folder.text()));
  CHECK_THAT(outcome.text, Contains("have complete lines up to there"));
  for (const char* name : kTables) {
    INFO(name);
    CHECK(whole_lines(folder.path / name));
  }
  CHECK(content(folder.path / "trajectory.csv").size() > 60000);
  CHECK(!fs::exists(folder.path / "summary.json"));  // the run was not finished
}
