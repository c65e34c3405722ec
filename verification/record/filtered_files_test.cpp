/// \file
/// \brief trajectory_filtered.csv: what a filter shows of a run, streamed into a file.
#include "tumble/filtering/filters.hpp"
#include "tumble/record/recorded_run.hpp"
#include "tumble/record/run_files.hpp"
#include "tumble/record/table_file.hpp"

#include "support/files.hpp"
#include "support/test.hpp"

#include <fstream>

namespace {

std::vector<std::vector<std::string>> rows_of(const fs::path& path) {
  std::ifstream in(path);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);) rows.push_back(cells_of(line));
  return rows;
}

// A box of which one appears later; turning, so that angular velocity depends on the orientation.
Scene dice() {
  Scene scene = make_scene("dice", {"count=2"}, 3);
  scene.boxes[0].size = Vec3(0.02, 0.03, 0.05);
  scene.boxes[1].appears = 0.2;
  scene.boxes[1].name = "a \"late\", one";
  return checked(scene);
}

RunDescription description(const std::string& filter, int every = 1) {
  RunDescription d{.scene = "dice", .technique = "contact_damped"};
  d.run.duration = 0.8083;  // [s] 48 steps and a cut one
  d.run.every = every;
  d.filter = filter;
  return d;
}

// Records the frames that a run's files have.
struct Recorder : RunObserver {
  explicit Recorder(int steps) : every(steps) {}
  void on_begin(const World& world) override { frames.record(world); }
  void on_step(const World& world, const Technique&, const StepReport&, const Metrics&) override {
    if (++step % every == 0) frames.record(world);
  }
  int every;
  int step = 0;
  Trajectory frames;
};

// Moves all bodies straight ahead, and spoils something in one step.
class Spoiler : public Cloned<Technique, Spoiler> {
 public:
  Spoiler(int step, bool momentum) : bad_(step), momentum_(momentum) {}
  std::string_view name() const override { return "spoiler"; }
  StepReport step(World& world, double dt) override {
    world.finish_step(dt);
    for (BodyState& state : world.states()) {
      state.position_w.x() += dt;
      if (world.steps() == bad_ && !momentum_) state.position_w.y() = kNan;
      if (world.steps() == bad_ && momentum_) state.angular_momentum_w.y() = kNan;
    }
    return {};
  }

 private:
  int bad_;
  bool momentum_;
};

}  // namespace

TEST_CASE("The filtered trajectory has the filter's poses, the same rows and computed velocities",
          "[unit][record][filtering]") {
  for (const std::string filter :
       {"box:5", "box:15", "box:5,causal", "envelope:2mm,5deg", "soft_envelope", "one_euro"})
    for (const int every : {1, 4}) {
      INFO(filter << ", every " << every);
      const Folder folder("filtered_poses");
      const Scene scene = dice();
      Recorder recorder(every);
      const RunDescription d = description(filter, every);
      RunFiles files(folder.path, d, scene);
      const std::array<RunObserver*, 2> observers = {&files, &recorder};
      files.finish(run_scene(scene, *make_technique("contact_damped"), d.run, observers));
      CHECK(files.filter_refusal().empty());

      const Trajectory shown = filtered(recorder.frames, *filter_of(filter));
      const RecordedRun run = read_run(folder.path, kFilteredFile);
      REQUIRE(static_cast<int>(run.frames.size()) == shown.count());
      int late = 0;
      for (int f = 0; f < shown.count(); ++f) {
        const RecordedFrame& frame = run.frames[idx(f)];
        CHECK(frame.time == shown.frame(f).time);
        const auto states = shown.frame(f).states.subspan(1);  // the ground has no rows
        REQUIRE(frame.poses.size() == states.size());
        for (std::size_t k = 0; k < states.size(); ++k) {
          CHECK(frame.poses[k].position_w == states[k].position_w);
          CHECK(frame.poses[k].orientation_wb.coeffs() == states[k].orientation_wb.coeffs());
        }
        if (states.size() == 2) ++late;
      }
      CHECK(late > 0);
      CHECK(late < shown.count());

      // Row by row beside the computed ones: time, name and the six velocities are the same text.
      const auto computed = rows_of(folder.path / kTrajectoryFile);
      const auto filtered_rows = rows_of(folder.path / kFilteredFile);
      REQUIRE(computed.size() == filtered_rows.size());
      CHECK(computed[0] == filtered_rows[0]);
      int different = 0;
      for (std::size_t k = 1; k < computed.size(); ++k) {
        for (const std::size_t c : {0u, 1u, 9u, 10u, 11u, 12u, 13u, 14u})
          CHECK(computed[k][c] == filtered_rows[k][c]);
        if (computed[k] != filtered_rows[k]) ++different;
      }
      if (every == 1) CHECK(different > 0);  // between far frames an envelope is left each time
      const std::string summary = content(folder.path / "summary.json");
      CHECK_THAT(summary, Contains("\"filter\": \"" + filter + "\""));
      CHECK_THAT(summary, Contains("\"filtered_frames\": " + std::to_string(shown.count()) + ","));
    }
}

TEST_CASE("Frames are written when the filter shows them, and the rest when the run is over",
          "[unit][record][filtering]") {
  const Folder folder("filtered_stream");
  fs::create_directories(folder.path);
  World world;
  world.add(box_properties(Vec3::Ones(), 1.0), Vec3::Zero());
  FilteredTrajectoryFile file(folder.path / kFilteredFile, *filter_of("box:7"));
  for (int k = 0; k < 10; ++k) {
    file.write(world);
    CHECK(file.frames() == std::max(0, k + 1 - 3));
    world.finish_step(0.01);
  }
  file.finish();
  CHECK(file.frames() == 10);
  CHECK(rows_of(folder.path / kFilteredFile).size() == 11);
}

TEST_CASE("A run that ends with a state that is no number leaves the filtered frames before it",
          "[unit][record][filtering]") {
  for (const std::string filter : {"box:5", "box:5,causal", "envelope", "one_euro"})
    for (const bool momentum : {false, true})
      for (const int bad : {1, 2, 7}) {
        INFO(filter << ", step " << bad << (momentum ? ", momentum" : ""));
        const Folder folder("filtered_broken");
        const Scene scene = dice();
        const RunDescription d = description(filter);
        Spoiler spoiler(bad, momentum);
        RunFiles files(folder.path, d, scene);
        const std::array<RunObserver*, 1> observers = {&files};
        const RunResult result = run_scene(scene, spoiler, d.run, observers);
        files.finish(result);
        CHECK(result.worst == StepStatus::not_finite);
        CHECK(!files.filter_refusal().empty());
        const RecordedRun run = read_run(folder.path, kFilteredFile);
        CHECK(static_cast<int>(run.frames.size()) == bad);
        CHECK(rows_of(folder.path / kTrajectoryFile).size() >
              rows_of(folder.path / kFilteredFile).size());
      }
}
