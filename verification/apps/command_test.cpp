/// \file
/// \brief The command `tumble` from outside: exit codes, messages, files.
#include "apps/command.hpp"

#include "support/test.hpp"

TEST_CASE("A run leaves every file, and its own scene.toml repeats its hash", "[unit][command]") {
  const Folder one("one");
  const Folder two("two");
  const Folder three("three");
  const std::string rest = " --duration 1.005 --quiet --contacts --out ";
  REQUIRE(run_tumble(
              "run two_boxes --technique basic --set speed=3 --set technique.impacts=sequential" +
              rest + one.text())
              .code == 0);
  for (const char* name : {"trajectory.csv", "metrics.csv", "events.csv", "contacts.csv",
                           "scene.toml", "summary.json", "timing.csv"}) {
    INFO(name);
    const std::string text = content(one.path / name);
    CHECK(!text.empty());
    CHECK(text.back() == '\n');
  }
  // 61 steps (the last one cut) and the start, two bodies each, and the header.
  const std::string trajectory = content(one.path / "trajectory.csv");
  CHECK(std::ranges::count(trajectory, '\n') == 1 + 2 * 62);
  REQUIRE(run_tumble("run " + one.text() +
                     "/scene.toml --technique basic --set impacts=sequential" + rest + two.text())
              .code == 0);
  CHECK(hash_of(two.path) == hash_of(one.path));
  REQUIRE(
      run_tumble("run two_boxes --technique basic --set scene.speed=3 --set impacts=sequential" +
                 rest + three.text())
          .code == 0);
  for (const char* name : {"trajectory.csv", "metrics.csv", "events.csv", "contacts.csv",
                           "scene.toml", "summary.json"}) {
    INFO(name);
    CHECK(content(three.path / name) == content(one.path / name));
  }
}

TEST_CASE("Every built-in scene runs again from its own scene.toml to the same hash",
          "[determinism][command]") {
  // Three steps and a cut one.
  const std::string rest = " --duration 0.06 --quiet --out ";
  std::istringstream names(run_tumble("scenes").text);
  int count = 0;
  for (std::string line; std::getline(names, line); ++count) {
    const std::string name = line.substr(0, line.find(' '));
    INFO(name);
    std::string small;
    if (name == "wall") small = " --set courses=4 --set bricks=4";
    if (name == "pyramid3d" || name == "pyramid") small = " --set rows=4";
    if (name == "clump" || name == "fig6_7") small = " --set per_edge=2";
    if (name == "fig6_6" || name == "projectile") small = " --set rows=4 --set appears=0.03";
    const tumble::SceneRecipe& recipe = tumble::scene_recipe(name);
    const bool joints = !recipe.build(recipe.parameters(), tumble::Random(5)).joints.empty();
    const std::string how = (joints ? " --technique glued --set contacts=collide" : "") + rest;
    const Folder one("scene_one");
    const Folder two("scene_two");
    const Outcome first = run_tumble("run " + name + small + " --seed 5" + how + one.text());
    const Outcome again =
        run_tumble("run " + one.text() + "/scene.toml --seed 5" + how + two.text());
    INFO(first.text << again.text);
    CHECK((first.code == 0 || first.code == 3));  // 3: the cap was met
    CHECK(again.code == first.code);
    CHECK(hash_of(one.path) != "none");
    CHECK(hash_of(two.path) == hash_of(one.path));
    for (const char* file : {"trajectory.csv", "metrics.csv", "events.csv", "scene.toml"})
      CHECK(content(one.path / file) == content(two.path / file));
  }
  CHECK(count >= 16);
}

TEST_CASE("A scene that is printed runs as the scene itself does", "[unit][command]") {
  const Folder folder("printed");
  const Folder one("printed_one");
  const Folder two("printed_two");
  const std::string rest = " --duration 0.3 --quiet --force --out ";
  const std::string file = folder.file("mine.toml").string();
  REQUIRE(run_tumble("scenes dice --toml --set count=2 --seed 9 > " + file).code == 0);
  run_tumble("run " + file + rest + one.text());
  run_tumble("run dice --set count=2 --seed 9" + rest + two.text());
  CHECK(hash_of(one.path) != "none");
  CHECK(hash_of(one.path) == hash_of(two.path));
  CHECK(
      shell("cat " + file + " | " + TUMBLE_COMMAND + " run /dev/stdin" + rest + one.text()).code !=
      2);  // a pipe is a file too
  CHECK(hash_of(one.path) == hash_of(two.path));
}

TEST_CASE("Short runs end well: no step, one step, every third step recorded", "[unit][command]") {
  const Folder folder("short");
  const auto rows = [&](const std::string& options, const char* table = "trajectory.csv") {
    const Outcome outcome =
        run_tumble("run box_drop --quiet --force --out " + folder.text() + " " + options);
    CHECK(outcome.code == 0);
    const std::string text = content(folder.path / table);
    return std::ranges::count(text, '\n') - 1;
  };
  CHECK(rows("--duration 0") == 1);  // the start
  CHECK(content(folder.path / "summary.json").find("\"potential_J\": 0,") == std::string::npos);
  CHECK(rows("--duration 0.1 --dt 1") == 2);
  CHECK(rows("--duration 0.1 --dt 0.01 --every 3") == 4);
  CHECK(rows("--duration 0.1 --dt 0.01 --every 3", "metrics.csv") == 3);
  CHECK(rows("--duration 0.1 --dt 0.01 --every 3", "timing.csv") == 3);
  CHECK(rows("--duration 0.1 --dt 0.01 --every 2147483647") == 1);
}

TEST_CASE("A user's mistake ends with exit code 2, one line that names it, and nothing left behind",
          "[unit][command]") {
  const Folder folder("mistake");
  const Folder files("mistake_files");
  fs::create_directories(files.path / "folder.toml");
  std::ofstream(files.path / "empty.toml").close();
  std::ofstream(files.path / "file") << "x";
  std::ofstream(files.path / "torn.toml") << "[[box]\nsize = [1,1,1]\n";
  std::ofstream(files.path / "zero.toml")
      << "[[box]]\nname = \"a\"\nsize = [1,0,1]\nmass = 1\nposition = [0,1,0]\n";
  std::ofstream(files.path / "binary.toml", std::ios::binary) << std::string(4096, '\xfe');
  for (const auto& [name, scene] : std::vector<std::pair<std::string, std::string>>{
           {"pull", "gravity = [0, -1e300, 0]\n[ground]\n[[box]]\nsize = [1,1,1]"},
           {"spin", "[[box]]\nangular_velocity = [0, 1e300, 0]\nsize = [1,1,1]"},
           {"small", "[[box]]\nsize = [1e-300,1,1]"},
           {"large", "[[box]]\nsize = [1e155,1,1]"}})
    std::ofstream(files.path / (name + ".toml")) << scene << "\nmass = 1\nposition = [0,1,0]\n";
  const std::string in = " " + files.text() + "/";
  std::vector<Refusal> cases = {
      {"run piramid", "unknown scene piramid: did you mean pyramid? Expected one of: box_drop,"},
      {"run stack --technique basics", "unknown technique basics: did you mean basic?"},
      {"run stack --set cuont=3",
       "--set cuont=3: unknown key; did you mean count? Expected one of"},
      {"run stack --set scene.cuont=3", "unknown setting cuont: did you mean count?"},
      {"run" + in + "large.toml --set friction=3", "(those of a scene file are in the file)"},
      {"run stack --technique basic --set technique.count=3",
       "unknown setting count: expected one of: resolution"},
      {"run stack --set count=0", "count = 0: expected a whole number from 1"},
      {"run stack --set count=2.5", "count = 2.5: expected a whole number"},
      {"run stack --set friction=nan", "friction = nan: expected a number from 0"},
      {"run stack --technique basic --set technique.impacts=both",
       "impacts = both: expected one of: simultaneous"},
      {"run stack --set count", "--set count: expected key=value"},
      {"run stack --technique ''", "--technique: \"\": expected a word"},
      {"run stack --out ''", "--out: \"\": expected a word"},
      {"run stack --set =3", "--set =3: expected key=value"},
      {"run stack --dt 0", "dt = 0: expected a finite number above 0"},
      {"run stack --dt -0.1", "dt = -0.1: expected a finite number above 0"},
      {"run stack --dt 1e300 --duration 1e301",
       "dt = 1e+300: expected a number from 1e-15 to 1e+20"},
      {"run stack --dt nan", "--dt: nan: expected a finite number"},
      {"run stack --dt fast", "--dt: fast: expected a finite number"},
      {"run stack --dt 0.1s", "--dt: 0.1s: expected a finite number"},
      {"run stack --duration -1", "duration = -1: expected a finite number, 0 or above"},
      {"run stack --duration nan", "--duration: nan: expected"},
      {"run stack --duration inf", "--duration: inf: expected"},
      {"run stack --duration 1e300", "duration / dt = 6e+301: expected fewer than 1e12 steps"},
      {"run stack --seed -1", "--seed: -1: expected a whole number from 0 to 1844674407370955161"},
      {"run stack --seed 18446744073709551616", "18446744073709551616: expected a whole number"},
      {"run stack --seed 1.5", "--seed: 1.5: expected a whole number"},
      {"run stack --every 0", "every = 0: expected 1 or more"},
      {"run stack --every -3", "--every: -3: expected a whole number"},
      {"run stack --every 99999999999", "--every: 99999999999: expected a whole number"},
      {"run stack --speed 3", "unknown option --speed: "},
      {"run stack --techniqe=damped", "unknown option --techniqe: did you mean --technique?"},
      {"run stack pyramid", "unexpected pyramid: expected an option, or nothing more"},
      {"run nowhere.toml", "nowhere.toml: cannot be read: there is no such file"},
      {"run" + in + "folder.toml", "folder.toml: is a folder: give a scene file"},
      {"run" + in + "empty.toml",
       "empty.toml:1: box: a scene needs at least one [[box]] table, in two brackets"},
      {"run" + in + "torn.toml", "torn.toml:1: not TOML"},
      {"run" + in + "zero.toml", "zero.toml:3: box[1].size = [1, 0, 1]: expected three numbers"},
      {"run" + in + "pull.toml",
       "pull.toml:1: gravity = [0, -1e+300, 0]: expected at most 299792458 m/s²"},
      {"run" + in + "spin.toml",
       "box1: angular_velocity = [0, 1e+300, 0]: expected at most 346170512.6546392 rad/s"},
      {"run" + in + "small.toml", "box1: shortest edge of size = 1e-300: expected a number from"},
      {"run" + in + "large.toml", "box1: longest edge of size = 1e+155: expected a number from"},
      {"run" + in + "binary.toml", "binary.toml:1: not TOML"},
      {"run" + in + "file", "file:1: not TOML"},
      {"run cradle --set moving=5", "moving = 5: expected fewer than count = 5"},
      {"run", "scene is required"},
      {"", "no command: expected one of: run, view, compare"},
      {"fly", "unknown command fly: expected one of: run, view, compare"},
      {"rnu stack", "unknown command rnu: did you mean run?"},
      {"scenes piramid", "did you mean pyramid?"},
      {"scenes --toml", "need the name of a scene"},
      {"techniques bsic", "unknown technique bsic: did you mean basic?"},
      {"compare stack --techniques ,, --duration 1",
       "--techniques: \",,\": expected words between the commas"},
      {"compare stack --techniques basic, --duration 1",
       "--techniques: \"basic,\": expected words"},
      {"compare stack --techniques basic,magic", "unknown technique magic"},
      {"compare stack --techniques basic,basic", "basic is there twice"},
      {"compare stack --limit 0", "limit = 0: expected a finite number above 0"},
      {"render" + in + "folder.toml --as svg", "trajectory.csv: cannot be read: give the folder"},
      {"render" + in + "folder.toml --as gif", "trajectory.csv: cannot be read: give the folder"},
      {"render" + in + "folder.toml --as bmp",
       "--as bmp: expected svg, png, gif, mp4, gltf or html"},
      {"render" + in + "folder.toml --as svg --strip ,, --width 300", "--strip: \",,\": expected"},
      {"render" + in + "folder.toml --as svg --view 1,,2,3", "--view: \"1,,2,3\": expected words"},
      {"render" + in + "folder.toml --as svg --strip 0,soon", "--strip: soon: expected a finite"},
      {"render" + in + "folder.toml --as svg --at soon", "--at: soon: expected a finite number"},
  };
  for (Refusal& c : cases)
    if (c.arguments.find("run ") == 0 || c.arguments.find("compare ") == 0)
      c.arguments += " --out " + folder.text();
  check_refused(cases);
  CHECK(!fs::exists(folder.path));
}

TEST_CASE("Scenes and techniques are listed, described and printed", "[unit][command]") {
  CHECK(run_tumble("scenes").text.find("crate_off_table") != std::string::npos);
  CHECK(run_tumble("scenes stack").text.find("top_mass") != std::string::npos);
  CHECK(run_tumble("techniques").text.find("basic") != std::string::npos);
  CHECK(run_tumble("scenes stack").text.find("--") == std::string::npos);
  CHECK(run_tumble("techniques basic").text.find("resolution") != std::string::npos);
  CHECK(run_tumble("--help").code == 0);
  CHECK(run_tumble("run --help").text.find("--every") != std::string::npos);
  CHECK(run_tumble("--version").text.find("tumble 0.") != std::string::npos);
  const Outcome toml = run_tumble("scenes stack --toml --set count=3");
  CHECK(toml.code == 0);
  CHECK_THAT(toml.text, Contains("name = \"level3\""));
}

TEST_CASE("Every example scene runs", "[unit][command]") {
  int found = 0;
  for (const auto& entry :
       fs::directory_iterator(fs::path(TUMBLE_SOURCE_DIR) / "examples/scenes")) {
    const Folder folder("example");
    INFO(entry.path());
    const bool joints = !tumble::read_scene(entry.path()).joints.empty();
    const Outcome outcome =
        run_tumble("run " + entry.path().string() + " --duration 0.2 --quiet --out " +
                   folder.text() + (joints ? " --technique glued --set contacts=collide" : ""));
    INFO(outcome.text);
    CHECK((outcome.code == 0 || outcome.code == 3));  // 3: the basic technique does not rest
    ++found;
    if (!joints) continue;
    const Outcome refused = run_tumble("stability " + entry.path().string());
    CHECK(refused.code == 2);
    CHECK_THAT(refused.text, Contains("does not support joints, and the scene has 3"));
  }
  CHECK(found >= 3);
}
