/// \file
/// \brief Fuzz targets for files: scenes, matrices, folders of runs.
#include "tumble/base/number_text.hpp"
#include "tumble/record/matrix_market.hpp"
#include "tumble/record/recorded_run.hpp"
#include "tumble/scenes/scene_file.hpp"
#include "tumble/scenes/simulation.hpp"

#include "fuzz/judged_answer.hpp"
#include "fuzz/targets.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <unistd.h>

namespace tumble::fuzz {
namespace {

constexpr std::size_t kMostBoxes = 8;  // of a scene that is also simulated
constexpr int kMostRows = 8;           // of a problem that is also solved
constexpr int kSteps = 3;
constexpr double kFastSpin = 1000.0;  // [rad] in a step
// A run is written to files and read from them for one input in so many, and read from memory for the others, which takes
// a fifth of the time. A test replays inputs from files.
#ifdef TUMBLE_FUZZ_SEARCH
constexpr std::size_t kInputsPerFolder = 32;
constexpr std::size_t kScenesPerFastSpin = 32;  // that are simulated
#else
constexpr std::size_t kInputsPerFolder = 1;
constexpr std::size_t kScenesPerFastSpin = 1;
#endif

std::string_view text_of(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// What comes before and after the first NUL byte.
struct Halves {
  std::string_view first, second;
};

Halves halves_of(Bytes bytes) {
  const std::string_view text = text_of(bytes);
  const std::size_t nul = text.find('\0');
  if (nul == std::string_view::npos) return {text, {}};
  return {text.substr(0, nul), text.substr(nul + 1)};
}

// Steps in which a body rotates by a thousand radians and more have as many parts; a search that has found such scenes would
// try little else.
bool is_slow(const Scene& scene) {
  return std::ranges::any_of(scene.boxes, [](const SceneBox& box) {
    return kTimeStep * box.angular_velocity_w.norm() > kFastSpin;
  });
}

void simulate(const Scene& scene) {
  Simulation simulation(scene);
  try {
    for (int k = 0; k < kSteps; ++k) {
      if (simulation.step().status != StepStatus::done) return;
      promise(all_finite(simulation.world()),
              "a step that is done, with a state that is not finite");
    }
  } catch (const StepFault& fault) {
    promise(false, std::string("a step that throws: ") + fault.what());
  }
}

// A folder that goes away with its files. Each process that runs the target has one, for all its inputs.
class RunFolder {
 public:
  RunFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "tumble_fuzz_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) std::abort();
    path = name;
  }
  ~RunFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  void write(std::string_view name, std::string_view content) const {
    std::ofstream out(path / name, std::ios::binary);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    if (!out.flush()) std::abort();
  }

  std::filesystem::path path;
};

void look_at(const RecordedRun& run) {
  promise(!run.frames.empty(), "a run without frames");
  double before = -std::numeric_limits<double>::infinity();
  for (const RecordedFrame& frame : run.frames) {
    promise(frame.time > before,
            "time_s = " + shortest_text(frame.time) + " after " + shortest_text(before));
    before = frame.time;
    for (const RecordedPose& pose : frame.poses) {
      promise(pose.box >= 0 && static_cast<std::size_t>(pose.box) < run.scene.boxes.size(),
              "box = " + std::to_string(pose.box));
      promise(pose.position_w.allFinite() && pose.orientation_wb.coeffs().allFinite(),
              "a recorded pose that is not finite");
    }
    refuses([&] { world_of(run, frame); });
  }
  const double first = run.frames.front().time;
  const double last = run.frames.back().time;
  for (const double time : {first, first + 0.5 * (last - first), last}) {
    refuses([&] {
      frame_at(run, time);
      nearest_frame(run, time);
    });
  }
}

}  // namespace

void fuzz_scene(Bytes bytes) {
  Scene scene;
  if (refuses([&] { scene = parse_scene(text_of(bytes), "scene.toml"); })) return;
  const std::string written = to_toml(scene);
  Scene again;
  promise(!refuses([&] { again = parse_scene(written, "again.toml"); }),
          "a scene that was written is refused");
  promise(to_toml(again) == written, "a scene that was written reads back as another one");
  if (is_slow(scene) && bytes.size() % kScenesPerFastSpin != 0) return;
  if (scene.boxes.size() <= kMostBoxes) refuses([&] { simulate(scene); });
}

void fuzz_matrix(Bytes bytes) {
  const Halves text = halves_of(bytes);
  MatX A, b;
  if (refuses([&] { A = parse_matrix_market(text.first, "A.mtx"); })) return;
  MatX again;
  promise(!refuses([&] { again = parse_matrix_market(to_matrix_market(A), "again.mtx"); }),
          "a matrix that was written is refused");
  promise(again.rows() == A.rows() && again.cols() == A.cols() &&
              std::memcmp(again.data(), A.data(),
                          sizeof(double) * static_cast<std::size_t>(A.size())) == 0,
          "a matrix that was written reads back as another one");
  if (text.second.empty()) return;
  if (refuses([&] { b = parse_matrix_market(text.second, "b.mtx"); })) return;
  if (b.cols() != 1 || b.rows() > kMostRows || A.rows() != b.rows() || A.cols() != b.rows()) return;
  require_honest_solvers(LcpProblem{A, b.col(0), {}});
}

void fuzz_run_folder(Bytes bytes) {
  const Halves text = halves_of(bytes);
  RecordedRun run;
  if (bytes.size() % kInputsPerFolder == 0) {
    static const RunFolder folder;
    folder.write("scene.toml", text.first);
    folder.write("trajectory.csv", text.second);
    if (!refuses([&] { run = read_run(folder.path); })) look_at(run);
    return;
  }
  std::istringstream table{std::string(text.second)};
  if (!refuses([&] {
        run = read_trajectory(parse_scene(text.first, "scene.toml"), table, "trajectory.csv");
      }))
    look_at(run);
}

}  // namespace tumble::fuzz
