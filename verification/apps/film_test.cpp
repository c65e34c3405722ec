/// \file
/// \brief `tumble render --as gif|mp4|gltf`: films of a run, their needs, and refusals.
#include "apps/command.hpp"
#include "live/json.hpp"
#include "support/test.hpp"

namespace {

// A folder with a run of half a second: 31 frames.
void run_a_die(const Folder& folder) {
  REQUIRE(run_tumble("run dice --duration 0.5 --quiet --out " + folder.text()).code == 0);
}

// Puts a program called ffmpeg into a folder, which is to be in PATH.
void write_ffmpeg(const Folder& folder, const std::string& script) {
  std::ofstream(folder.file("ffmpeg")) << "#!/bin/sh\n" << script;
  fs::permissions(folder.path / "ffmpeg", fs::perms::owner_all);
}

std::size_t files_in(const Folder& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()));
}

// How many frames a GIF has: each begins with a graphic control block of ours.
std::size_t frames_of_gif(const std::string& bytes) {
  std::size_t count = 0;
  const std::string mark("\x21\xf9\x04\x05", 4);
  for (std::size_t at = bytes.find(mark); at != std::string::npos; at = bytes.find(mark, at + 1))
    ++count;
  return count;
}

}  // namespace

TEST_CASE("A run becomes a GIF without any other program and with the same bytes each time",
          "[unit][command]") {
  const Folder folder("film_gif");
  run_a_die(folder);
  const std::size_t files = files_in(folder);
  const auto film = [&](const std::string& options) {
    const Outcome outcome = shell_ends(0, "PATH=/nowhere " + std::string(TUMBLE_COMMAND) +
                                              " render " + folder.text() + " --as gif " + options);
    CHECK(outcome.text == (folder.path / "film.gif").string() + "\n");
    return content(folder.path / "film.gif");
  };
  const std::string whole = film("--width 120");
  CHECK(whole.substr(0, 6) == "GIF89a");
  CHECK(static_cast<unsigned char>(whole[6]) == 120);
  CHECK(static_cast<unsigned char>(whole[8]) == 80);
  CHECK(frames_of_gif(whole) == 13);  // half a second at 25 frames a second, both ends included
  CHECK(film("--width 120") == whole);
  CHECK(film("--width 120 --view 1,1,1") != whole);
  CHECK(frames_of_gif(film("--width 120 --from 0.1 --to 0.3")) == 6);
  CHECK(frames_of_gif(film("--width 120 --fps 10")) == 6);
  CHECK(frames_of_gif(film("--width 120 --fps 10 --speed 0.5")) == 11);
  const std::string wide = film("--fps 4");
  CHECK(static_cast<unsigned char>(wide[6]) + 256 * static_cast<unsigned char>(wide[7]) == 480);
  CHECK(files_in(folder) == files + 1);  // nothing else is left
}

TEST_CASE("A video is made by ffmpeg from frames that are in no file", "[unit][command]") {
  const Folder folder("film_mp4");
  const Folder programs("film_programs");
  run_a_die(folder);
  const std::size_t files = files_in(folder);
  const std::string render =
      std::string(TUMBLE_COMMAND) + " render " + folder.text() + " --as mp4 --width 120 --fps 10";
  const auto with_programs = [&] { return shell("PATH=" + programs.text() + ":$PATH " + render); };

  // One that writes what it reads into the file that it is asked for, and its words beside it.
  write_ffmpeg(programs, "echo \"$@\" >\"$0.words\"\nfor last; do :; done\ncat >\"$last\"\n");
  const Outcome made = with_programs();
  INFO(made.text);
  CHECK(made.code == 0);
  CHECK(content(folder.path / "film.mp4").size() == 6 * 120 * 80 * 3);
  const std::string words = content(programs.path / "ffmpeg.words");
  CHECK(words.find("-video_size 120x80 -framerate 10 ") != std::string::npos);
  fs::remove(folder.path / "film.mp4");

  // One that stops reading, and one that is not there: both are reported, and leave nothing behind.
  write_ffmpeg(programs, "for last; do :; done\necho x >\"$last\"\nexit 1\n");
  const Outcome failed = with_programs();
  INFO(failed.text);
  CHECK(failed.code == 4);
  CHECK_THAT(failed.text, Contains("ffmpeg could not write " + folder.text()));
  const Outcome missing = shell_ends(4, "PATH=/nowhere " + render);
  CHECK_THAT(missing.text, Contains("install the package ffmpeg"));
  CHECK(files_in(folder) == files);
}

TEST_CASE("Where ffmpeg is installed a video is one that players show", "[unit][command]") {
  if (shell("command -v ffmpeg").code != 0) {
    WARN("ffmpeg is missing (package ffmpeg): not tested");
    return;
  }
  const Folder folder("film_real_mp4");
  run_a_die(folder);
  tumble_ends(0, "render " + folder.text() + " --as mp4 --width 240");
  CHECK(content(folder.path / "film.mp4").substr(4, 4) == "ftyp");
}

TEST_CASE("A run becomes a glTF file with a key for each recorded frame", "[unit][command]") {
  const Folder folder("film_gltf");
  run_a_die(folder);
  const auto keys = [&](const std::string& options) {
    const Outcome outcome = run_tumble("render " + folder.text() + " --as gltf " + options);
    INFO(outcome.text);
    REQUIRE(outcome.code == 0);
    const JsonValue file = JsonReader::read(content(folder.path / "film.gltf"));
    const JsonValue& sampler = file.at("animations").items.at(0).at("samplers").items.at(0);
    const auto input = static_cast<std::size_t>(sampler.at("input").number);
    const JsonValue& times = file.at("accessors").items.at(input);
    return std::pair(times.at("count").number, times.at("max").items.at(0).number);
  };
  CHECK(keys("") == std::pair(31.0, 0.5));
  CHECK(keys("--from 0.25").second == near(0.25, 1e-7));  // [s] single precision
  CHECK(keys("--fps 100") == std::pair(51.0, 0.5));
  CHECK(keys("--fps 100 --speed 0.25") == std::pair(201.0, 2.0));
}

TEST_CASE("A film that cannot be made is refused in one line with a remedy", "[unit][command]") {
  const Folder folder("film_wrong");
  run_a_die(folder);
  const std::size_t files = files_in(folder);
  const std::pair<const char*, const char*> wrong[] = {
      {"avi", "expected svg, png, gif, mp4, gltf or html"},
      {"gif --from 0.6", "time 0.6 s: the run was recorded"},
      {"gif --to nan", "--to: nan: expected a finite number"},
      {"gif --from 0.3 --to 0.2", "expected the end to come after the beginning"},
      {"gif --from 0.3 --to 0.31", "fewer than two frames"},
      {"gltf --from 0.301 --to 0.302", "fewer than two frames"},
      {"gif --fps 60", "--fps"},
      {"mp4 --fps 0", "--fps"},
      {"gltf --fps -1", "--fps"},
      {"gif --speed 0", "--speed"},
      {"gif --speed 0.00001", "20000 at most"},
      {"gif --width 121", "expected an even number from 60 to 3840"},
      {"gif --width 20", "expected an even number from 60 to 3840"},
      {"gltf --width 120", "--width is for gif and mp4"},
      {"gif --at 0.1", "--at and --strip are for svg and png"},
      {"gltf --strip 0,0.1", "--at and --strip are for svg and png"},
      {"svg --speed 2", "are for gif, mp4, gltf and html"},
      {"gif --view 0,1,0", "vertical"},
      {"gif --view 1,2", "--view: expected X,Y,Z"},
      {"gif --filtered", "run the scene with --filter"},
  };
  for (const auto& [options, message] : wrong) {
    const Outcome outcome = tumble_ends(2, "render " + folder.text() + " --as " + options);
    CHECK_THAT(outcome.text, Contains(message));
    CHECK(std::ranges::count(outcome.text, '\n') == 1);
  }
  CHECK(files_in(folder) == files);
}

TEST_CASE("A run without frames, or with one alone, makes no film", "[unit][command]") {
  const Folder folder("film_empty");
  run_a_die(folder);
  const fs::path table = folder.path / "trajectory.csv";
  const std::string rows = content(table);
  const auto head = [&](std::ptrdiff_t lines) {
    std::istringstream in(rows);
    std::ofstream out(table);
    std::string line;
    for (; lines > 0 && std::getline(in, line); --lines) out << line << '\n';
  };
  for (const char* form : {"gif", "mp4", "gltf"}) {
    INFO(form);
    head(1);
    const Outcome none = tumble_ends(2, "render " + folder.text() + " --as " + form);
    CHECK_THAT(none.text, Contains("has no frame"));
    head(2);
    const Outcome one = tumble_ends(2, "render " + folder.text() + " --as " + form);
    CHECK_THAT(one.text, Contains("one frame only, at 0 s"));
  }
  CHECK(!fs::exists(folder.path / "film.gif"));
}
