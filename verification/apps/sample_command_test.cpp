/// \file
/// \brief The command `tumble sample`: its files, its ends, what it refuses.
#include "apps/command.hpp"

namespace {

using namespace tumble::test;

// A die with a wish.
void write_die(const std::filesystem::path& path, const std::string& wish) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path)
      << "[ground]\n[[box]]\nname = \"die\"\nsize = [0.02, 0.02, 0.02]\nmass = 0.01\n"
         "position = [0, 0.2, 0]\nrotation_deg = [70, 0, 0]\nrestitution = 0.3\n"
         "angular_velocity = [3, 10, 5]\n[[wish]]\nbody = \"die\"\n"
      << wish << '\n';
}

const std::string kSix = "kind = \"face_up\"\nface = \"+z\"";

// All tables of chains and motions, one after the other.
std::string results_in(const std::filesystem::path& folder) {
  std::string all;
  for (int k = 1; k <= 4; ++k)
    for (const char* kind : {"chain_", "motion_"})
      all += content(folder / (kind + std::to_string(k) + ".csv")) + "--\n";
  return all + content(folder / "motions.csv");
}

std::set<std::string> files_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

}  // namespace

TEST_CASE("The command finds motions that meet a wish, writes them, and shows them",
          "[determinism][command][sampling]") {
  const Folder folder("sample");
  const std::string scene = (folder.path / "die.toml").string();
  const std::string out = (folder.path / "out").string();
  write_die(folder.path / "die.toml", kSix);
  const std::string options = scene + " --duration 1 --samples 4 --chains 2 --proposals 60 ";
  const Outcome done = tumble_ends(0, "sample " + options + "--cores 2 --out " + out);
  CHECK_THAT(done.text, Contains("4 of 4 motions meet all wishes"));
  CHECK(done.text.find('\r') == std::string::npos);  // no progress without a terminal
  CHECK(files_in(out) == std::set<std::string>{".tumble", "chain_1.csv", "chain_2.csv",
                                               "motion_1.csv", "motion_2.csv", "motion_3.csv",
                                               "motion_4.csv", "motions.csv", "sampling.txt",
                                               "scene.toml", "summary.json", "timing.csv"});
  for (const char* file : {"chain_1.csv", "motion_4.csv", "motions.csv"})
    CHECK(whole_lines(folder.path / "out" / file));
  CHECK(lines_of(folder.path / "out" / "motions.csv").size() == 5);
  for (const std::string& line : lines_of(folder.path / "out" / "motions.csv"))
    CHECK((line.find("motion,") == 0 || line.find(",done,0,") != std::string::npos));

  const std::string one = (folder.path / "one").string();
  CHECK(run_tumble("sample " + options + "--cores 1 --quiet --out " + one).text.empty());
  CHECK(results_in(one) == results_in(out));

  CHECK(run_tumble("render " + out + " --motion 2 --as gltf").code == 0);
  CHECK(std::filesystem::exists(folder.path / "out" / "film_2.gltf"));
  CHECK(run_tumble("view " + out + " --no-browser").code == 0);
  CHECK(std::filesystem::exists(folder.path / "out" / "view.html"));
  check_refused({{"render " + out + " --motion 9 --as gif", "motion_9.csv: cannot be read"},
                 {"render " + out + " --filtered --as gif", "are not filtered"},
                 {"view dice --motion 2 --no-browser", "dice is not a folder of tumble sample"}});
}

TEST_CASE("Sampling that was cut off and goes on ends as if it had not been",
          "[determinism][command][sampling]") {
  const Folder folder("sample_resume");
  const std::string scene = (folder.path / "die.toml").string();
  const auto out = [&](const char* name) { return (folder.path / name).string(); };
  write_die(folder.path / "die.toml", kSix);
  const std::string options =
      scene + " --dt 0.003 --duration 1 --chains 2 --quiet --proposals 200 ";
  CHECK(run_tumble("sample " + options + "--samples 8 --out " + out("whole")).code == 0);
  CHECK(run_tumble("sample " + options + "--samples 4 --out " + out("part")).code == 0);
  CHECK(run_tumble("sample " + options + "--samples 8 --resume --out " + out("part")).code == 0);
  CHECK(results_in(out("part")) == results_in(out("whole")));

  // One that is killed leaves whole tables, if any, and no summary.
  const std::string long_run =
      scene +
      " --dt 0.003 --duration 1 --chains 2 --quiet --cores 1 --samples 1000 --proposals 1000000 ";
  shell("timeout -s KILL 1.2 " + std::string(TUMBLE_COMMAND) + " sample " + long_run + "--out " +
        out("killed"));
  REQUIRE(std::filesystem::exists(folder.path / "killed" / "chain_1.csv"));
  const std::string killed = content(folder.path / "killed" / "chain_1.csv");
  CHECK(whole_lines(folder.path / "killed" / "chain_1.csv"));
  CHECK_FALSE(std::filesystem::exists(folder.path / "killed" / "summary.json"));
  check_refused({{"sample " + options + "--out " + out("killed"),
                  "chains that are not finished: continue with --resume"},
                 {"sample " + options + "--seed 2 --resume --out " + out("killed"),
                  "sampling.txt has \"seed = 1\", and this is \"seed = 2\""}});
  const Outcome on = shell("timeout -s INT 0.3 " + std::string(TUMBLE_COMMAND) + " sample " +
                           long_run + "--resume --out " + out("killed"));
  CHECK_THAT(on.text, Contains("interrupted: the chains in"));
  CHECK(run_tumble("sample " + options + "--samples 8 --resume --out " + out("killed")).code == 0);
  // Nothing was begun anew: no row is lost, and they are those of a run that was not cut off.
  const std::string last = content(folder.path / "killed" / "chain_1.csv");
  CHECK(last.find(killed) == 0);
  CHECK(last.find(content(folder.path / "whole" / "chain_1.csv")) == 0);
}

TEST_CASE("Chains that find too little end at their cap with the nearest motion and exit code 3",
          "[unit][command][sampling]") {
  const Folder folder("sample_cap");
  const std::string scene = (folder.path / "die.toml").string();
  write_die(folder.path / "die.toml", "kind = \"ends_in\"\nlow = [5, 0, 0]\nhigh = [6, 1, 1]");
  const Outcome capped = tumble_ends(
      3, "sample " + scene + " --duration 0.5 --samples 2 --chains 2 --proposals 5 --out " +
             (folder.path / "out").string());
  CHECK_THAT(capped.text,
             Contains("0 of 2 motions were found before chains ended at 5 proposals; the "
                      "closest one has a violation of 0.99"));
  CHECK(files_in(folder.path / "out").count("motion_1.csv") == 1);
  CHECK(lines_of(folder.path / "out" / "chain_2.csv").size() == 6);
  const Outcome slow = run_tumble(
      "sample " + scene + " --duration 0.5 --samples 1 --proposals 3 --noise-speed 1000 --out " +
      (folder.path / "slow").string());
  CHECK(slow.code == 3);
  CHECK_THAT(slow.text,
             Contains("no impact was fast enough for noise: try a smaller --noise-speed"));
}

TEST_CASE("What tumble sample cannot do is refused, and nothing of others is touched",
          "[unit][command][sampling]") {
  const Folder folder("sample_refused");
  const std::string scene = (folder.path / "die.toml").string();
  write_die(folder.path / "die.toml", kSix);
  write_die(folder.path / "bad.toml", "kind = \"face_up\"\nface = \"top\"");
  std::filesystem::create_directories(folder.path / "mine");
  std::ofstream(folder.path / "mine" / "notes.txt") << "mine\n";
  const std::string out = " --out " + (folder.path / "out").string();
  check_refused(
      {{"sample dice" + out, "the scene has no wish: add a table [[wish]]"},
       {"sample " + (folder.path / "bad.toml").string() + out, "wish[1].face = \"top\""},
       {"sample " + scene + " --samples 0" + out, "--samples 0: expected 1 to 1000"},
       {"sample " + scene + " --chains 9" + out, "--chains 9: more than the 4 of --samples"},
       {"sample " + scene + " --proposals 0" + out, "--proposals 0: expected 1 to 1000000"},
       {"sample " + scene + " --cores 5000" + out, "--cores 5000: expected 0 to 1024"},
       {"sample " + scene + " --strictness 0" + out, "--strictness 0: expected a number above 0"},
       {"sample " + scene + " --noise-normal 2" + out, "noise normal = 2"},
       {"sample " + scene + " --noise-speed -1" + out, "noise speed = -1"},
       {"sample " + scene + " --technique nothing" + out, "nothing"},
       {"sample " + scene + " --resume" + out, "has no chains to continue"},
       {"sample " + scene + " --resume --force" + out, "give one of them"},
       {"sample " + scene + " --samples many" + out, "expected a whole number"},
       {"sample " + scene + " --out " + (folder.path / "mine").string(),
        "is not empty and not the folder of a sampling"},
       {"sample " + scene + " --out " + folder.text(), "holds the scene that is read"}});
  CHECK_FALSE(std::filesystem::exists(folder.path / "out"));
  CHECK(files_in(folder.path / "mine") == std::set<std::string>{"notes.txt"});
}
