/// \file
/// \brief Tables of runs, for readers and for programs.
#include "scene_table.hpp"

#include <algorithm>
#include <cmath>

namespace scene_bench {
namespace {

constexpr double kMilli = 1e3;

// Three digits, at most 7 characters.
std::string number(double value) {
  char text[32];
  const double size = std::abs(value);
  if (size > 0.0 && size < 1e-3)
    std::snprintf(text, sizeof text, "%.1e", value);
  else
    std::snprintf(text, sizeof text, size < 999.5 ? "%.3g" : "%.0f", value);
  return text;
}

std::string ratio(double value, double to) { return to > 0.0 ? number(value / to) : "-"; }

std::string outcome_of(const Outcome& run, bool structure) {
  if (!run.finite) return "broke";
  if (structure && !run.quality.stands) return "fell";
  if (run.steps < run.wanted) return "cut";
  return structure ? "stands" : "-";
}

const Outcome* find(const std::vector<Outcome>& runs, const std::string& name) {
  const auto at =
      std::ranges::find_if(runs, [&name](const Outcome& run) { return run.engine == name; });
  return at == runs.end() ? nullptr : &*at;
}

// The name in the first column; a longer one gets a line of its own.
const char* label(const Outcome& run) {
  constexpr std::size_t kWidth = 16;
  if (run.engine.size() <= kWidth) return run.engine.c_str();
  std::printf("  %s\n", run.engine.c_str());
  return "";
}

void print_awake(const SceneChoice& scene, const std::vector<Outcome>& runs,
                 const Outcome* reference) {
  std::printf("  %-16s %8s %8s %7s %6s | %7s %7s %7s %7s %7s %6s\n", "engine", "median", "p99",
              "total", "ratio", "overlap", "speed", "drift", "sag", "chatter", "end");
  std::printf("  %-16s %8s %8s %7s %6s | %7s %7s %7s %7s %7s\n", "", "ms", "ms", "s", "", "mm",
              "mm/s", "mm", "mm", "mm");
  for (const Outcome& run : runs) {
    const Quality& q = run.quality;
    const auto shown = [&run](bool known, double value) {
      return run.finite && known ? number(kMilli * value) : "-";
    };
    std::printf("  %-16s %8s %8s %7s %6s | %7s %7s %7s %7s %7s %6s\n", label(run),
                number(run.median_ms).c_str(), number(run.p99_ms).c_str(),
                number(run.total_s).c_str(),
                ratio(run.median_ms, reference == nullptr ? 0.0 : reference->median_ms).c_str(),
                shown(true, q.overlap).c_str(), shown(true, q.speed).c_str(),
                shown(scene.structure, q.drift).c_str(), shown(scene.structure, q.sag).c_str(),
                shown(q.chatter.bodies > 0, q.chatter.amplitude).c_str(),
                outcome_of(run, scene.structure).c_str());
  }
}

void print_asleep(const SceneChoice& scene, const std::vector<Outcome>& runs,
                  const Outcome* reference) {
  std::printf("  %-16s %9s %9s %7s %12s %7s | %7s %7s %6s\n", "engine", "awake", "last s", "ratio",
              "us/box/step", "asleep", "overlap", "drift", "end");
  std::printf("  %-16s %9s %9s %7s %12s %7s | %7s %7s\n", "", "ms", "ms", "", "", "boxes", "mm",
              "mm");
  for (const Outcome& run : runs) {
    std::printf(
        "  %-16s %9s %9s %7s %12s %7d | %7s %7s %6s\n", label(run),
        run.awake_ms > 0.0 ? number(run.awake_ms).c_str() : "-", number(run.last_second_ms).c_str(),
        ratio(run.last_second_ms, reference == nullptr ? 0.0 : reference->last_second_ms).c_str(),
        number(1e3 * run.last_second_ms / run.boxes).c_str(), run.asleep,
        number(kMilli * run.quality.overlap).c_str(), number(kMilli * run.quality.drift).c_str(),
        outcome_of(run, scene.structure).c_str());
  }
}

}  // namespace

std::string legend() {
  return "median, p99: of the time of a step of 1/60 s after the first 10; ratio: of medians, to "
         "bullet's\n"
         "here. The rest is the last second before the end or the cut, by one routine for all: "
         "deepest\n"
         "overlap, rms speed of centres from pose to pose, largest way of a box from its start, "
         "how far\n"
         "the top sank, amplitude of the corners of boxes that rest (- if none does). fell: a box "
         "is\n"
         "further than half its shortest edge from its start. _dt4: four steps of 1/240 s each, "
         "their sum\n"
         "is timed; _200: 200 iterations; _2dir: two directions of friction.\n";
}

void print_table(const SceneChoice& scene, const std::vector<Outcome>& runs,
                 const std::string& reference) {
  if (runs.empty()) return;
  std::printf("\n%s: %s, %d boxes, %g s\n", scene.name.c_str(), scene.scene.title.c_str(),
              runs.front().boxes, scene.seconds);
  const Outcome* to = find(runs, reference);
  if (scene.sleeping)
    print_asleep(scene, runs, to);
  else
    print_awake(scene, runs, to);
  for (const Outcome& run : runs) {
    if (run.steps < run.wanted)
      std::printf("  %s: ended after %d of %d steps: %s\n", run.engine.c_str(), run.steps,
                  run.wanted, run.note.c_str());
    else if (!run.note.empty())
      std::printf("  %s: %s\n", run.engine.c_str(), run.note.c_str());
  }
  std::fflush(stdout);
}

void write_csv_head(std::FILE* file) {
  std::fprintf(file,
               "scene,engine,steps,steps_wanted,median_ms,p99_ms,total_s,awake_ms,last_second_ms,"
               "asleep,overlap_mm,speed_mm_s,drift_mm,sag_mm,chatter_mm,chatter_g,resting,"
               "outcome\n");
}

void write_csv(std::FILE* file, const SceneChoice& scene, const std::vector<Outcome>& runs) {
  for (const Outcome& run : runs) {
    const Quality& q = run.quality;
    std::fprintf(file,
                 "%s,\"%s\",%d,%d,%.6g,%.6g,%.6g,%.6g,%.6g,%d,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%d,"
                 "%s\n",
                 scene.name.c_str(), run.engine.c_str(), run.steps, run.wanted, run.median_ms,
                 run.p99_ms, run.total_s, run.awake_ms, run.last_second_ms, run.asleep,
                 kMilli * q.overlap, kMilli * q.speed, kMilli * q.drift, kMilli * q.sag,
                 kMilli * q.chatter.amplitude, q.chatter.acceleration, q.chatter.bodies,
                 outcome_of(run, scene.structure).c_str());
  }
  std::fflush(file);
}

}  // namespace scene_bench
