/// \file
/// \brief Reading a run's folder.
#include "tumble/record/recorded_run.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/base/suggestion.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/record/table_file.hpp"
#include "tumble/scenes/scene_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <istream>
#include <map>
#include <utility>

namespace tumble {
namespace {

constexpr std::size_t kNumbers = 13;                         // in a row, after time and name
constexpr std::size_t kLongestLine = std::size_t{1} << 16U;  // [bytes]

// One row of trajectory.csv. Messages name the file and the line.
class Row {
 public:
  Row(std::string where, const std::string& line)
      : where_(std::move(where)), cells_(cells_of(line)) {
    require::that(cells_.size() == kNumbers + 2,
                  where_ + ": " + std::to_string(cells_.size()) + " cells: expected " +
                      std::to_string(kNumbers + 2) + ", as `tumble run` writes them");
  }

  double number(std::size_t column) const {
    const std::string& text = cells_[column];
    const std::optional<double> value = parse_number(text);
    require::that(value.has_value(), where_ + ": " + one_line(text) + ": expected a finite number");
    return *value;
  }

  const std::string& name() const { return cells_[1]; }
  const std::string& where() const { return where_; }

 private:
  std::string where_;
  std::vector<std::string> cells_;
};

RecordedPose pose_of(const Row& row, const std::map<std::string, int>& boxes) {
  const auto box = boxes.find(row.name());
  require::that(box != boxes.end(),
                row.where() + ": body " + one_line(row.name()) + ": scene.toml has no such box");
  std::array<double, kNumbers> v{};
  for (std::size_t k = 0; k < kNumbers; ++k) v[k] = row.number(k + 2);
  RecordedPose pose;
  pose.box = box->second;
  pose.position_w = Vec3(v[0], v[1], v[2]);
  pose.orientation_wb = Quat(v[3], v[4], v[5], v[6]);
  pose.velocity_w = Vec3(v[7], v[8], v[9]);
  pose.angular_velocity_w = Vec3(v[10], v[11], v[12]);
  return pose;
}

// A time at most so far outside of what was recorded.
void require_recorded(const RecordedRun& run, double time, double outside) {
  const double first = run.frames.front().time;
  const double last = run.frames.back().time;
  require::that(time >= first - outside && time <= last + outside,
                "time " + shortest_text(time) + " s: the run was recorded from " +
                    shortest_text(first) + " to " + shortest_text(last) + " s");
}

}  // namespace

RecordedRun read_trajectory(Scene scene, std::istream& in, const std::string& name) {
  RecordedRun run{.scene = std::move(scene)};
  std::map<std::string, int> boxes;
  for (std::size_t k = 0; k < run.scene.boxes.size(); ++k)
    boxes.emplace(run.scene.boxes[k].name, static_cast<int>(k));

  std::vector<std::size_t> last_frame(run.scene.boxes.size(),
                                      0);  // with a pose of the box; 0: none yet
  std::vector<char> line(kLongestLine);
  for (int number = 1;
       in.getline(line.data(), static_cast<std::streamsize>(line.size())) || in.gcount() > 0;
       ++number) {
    const std::string where = name + ":" + std::to_string(number);
    require::that(in.gcount() + 1 < static_cast<std::streamsize>(line.size()),
                  where + ": a line of 64 KiB and more: expected a row of a trajectory");
    require::that(number <= kMostTrajectoryRows,
                  where + ": more than " + std::to_string(kMostTrajectoryRows) + " rows");
    if (number == 1) continue;  // the names of the columns
    const Row row(where, line.data());
    const double time = row.number(0);
    if (run.frames.empty() || run.frames.back().time != time) {
      require::that(run.frames.empty() || run.frames.back().time < time,
                    row.where() + ": time_s = " + shortest_text(time) + ": expected it to grow");
      run.frames.push_back(RecordedFrame{time, {}});
    }
    const RecordedPose pose = pose_of(row, boxes);
    std::size_t& last = last_frame[static_cast<std::size_t>(pose.box)];
    require::that(last != run.frames.size(),
                  row.where() + ": body " + one_line(row.name()) + ": twice in one frame");
    last = run.frames.size();
    run.frames.back().poses.push_back(pose);
  }
  require::that(!run.frames.empty(), name + ": has no frame");
  return run;
}

RecordedRun read_run(const std::filesystem::path& folder, std::string_view table) {
  const std::filesystem::path path = folder / table;
  // A pipe would be waited for.
  for (const std::filesystem::path& file : {path, folder / "scene.toml"}) {
    std::error_code none;
    require::that(!std::filesystem::is_fifo(file, none),
                  file.string() + ": is a pipe: give the folder of a run");
  }
  std::ifstream in(path);
  if (table == kFilteredFile && !in.is_open() && std::ifstream(folder / kTrajectoryFile).is_open())
    refuse(path.string() +
           ": there is none: run the scene with --filter, for example "
           "--filter box:5");
  require::that(
      in.is_open(),
      path.string() + ": cannot be read: give the folder of a run, such as runs/stack-damped");
  return read_trajectory(read_scene(folder / "scene.toml"), in, path.string());
}

World world_of(const RecordedRun& run, const RecordedFrame& frame) {
  World world;
  world.gravity_w = run.scene.gravity_w;
  if (run.scene.ground) world.add_ground(run.scene.ground->friction, run.scene.ground->restitution);
  for (const RecordedPose& pose : frame.poses) {
    const SceneBox& box = run.scene.boxes[static_cast<std::size_t>(pose.box)];
    const BodyProperties body = properties_of(box);
    world.add(body, make_state(body, pose.position_w, pose.orientation_wb), box.name);
  }
  return world;
}

RecordedFrame frame_at(const RecordedRun& run, double time) {
  const std::vector<RecordedFrame>& frames = run.frames;
  require_recorded(run, time, 0.0);
  const auto after =
      std::upper_bound(frames.begin(), frames.end(), time,
                       [](double t, const RecordedFrame& frame) { return t < frame.time; });
  const RecordedFrame& before = *(after - 1);
  if (before.time == time) return before;
  const double share = (time - before.time) / (after->time - before.time);
  RecordedFrame out{time, {}};
  // Frames have their boxes in the same order, so the next one is looked for after the last.
  auto next = after->poses.begin();
  for (const RecordedPose& pose : before.poses) {
    const auto is_it = [&](const RecordedPose& other) { return other.box == pose.box; };
    auto later = std::find_if(next, after->poses.end(), is_it);
    if (later == after->poses.end()) later = std::find_if(after->poses.begin(), next, is_it);
    if (later == after->poses.end() || !is_it(*later)) continue;
    next = later + 1;
    out.poses.push_back(pose);
    out.poses.back().position_w += share * (later->position_w - pose.position_w);
    out.poses.back().orientation_wb =
        rotation_between(pose.orientation_wb, later->orientation_wb, share);
  }
  return out;
}

const RecordedFrame& nearest_frame(const RecordedRun& run, double time) {
  const std::vector<RecordedFrame>& frames = run.frames;
  require_recorded(run, time, frames.size() > 1 ? 0.5 * (frames[1].time - frames[0].time) : 0.0);
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < frames.size(); ++k)
    if (std::abs(frames[k].time - time) < std::abs(frames[nearest].time - time)) nearest = k;
  return frames[nearest];
}

}  // namespace tumble
