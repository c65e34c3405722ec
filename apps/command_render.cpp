/// \file
/// \brief `tumble render`: pictures of a recorded run.
#include "tumble/base/error.hpp"
#include "tumble/record/recorded_run.hpp"
#include "tumble/record/world_picture.hpp"

#include "gnuplot.hpp"
#include "request.hpp"

#include <array>
#include <cstdio>
#include <map>

namespace tumble::app {
namespace {

// A page of pictures, row by row.
struct Page {
  double width = 900.0;   // [px] of one picture
  double height = 600.0;  // [px] of one picture
  int columns = 1;
  int rows = 1;
};

// One frame fills the page; several have labels and stand side by side, up to three in a row.
Page page_for(std::size_t frames) {
  Page page;
  if (frames == 1) return page;
  page.columns = static_cast<int>(std::min<std::size_t>(frames, 3));
  page.rows = (static_cast<int>(frames) + page.columns - 1) / page.columns;
  page.width = 900.0 / page.columns;
  page.height = 0.75 * page.width;
  return page;
}

std::string terminal(const std::string& form, const Page& page) {
  const int width = static_cast<int>(page.width) * page.columns;
  const int height = static_cast<int>(page.height) * page.rows;
  std::array<char, 160> text{};
  if (form == "svg") {
    std::snprintf(text.data(), text.size(),
                  "set terminal svg size %d,%d dynamic font 'sans-serif,16' background 'white'\n",
                  width, height);
  } else {
    std::snprintf(
        text.data(), text.size(),
        "set terminal pngcairo size %d,%d fontscale 2 linewidth 2 font 'DejaVu Sans,12'\n",
        2 * width, 2 * height);
  }
  return text.data();
}

std::string label(double time) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(),
                "set label 1 '%.4g s' at graph 0.04,0.93 front textcolor rgb '#202020'\n", time);
  return text.data();
}

// Whether the straight way between two points runs into a box: the part of it inside the slabs of
// all three axes is not empty.
bool hides(const Box& box, const Vec3& from_w, const Vec3& to_w) {
  const Vec3 start_b = box.axes_w.transpose() * (from_w - box.center_w);
  const Vec3 way_b = box.axes_w.transpose() * (to_w - from_w);
  double enter = 0.0;
  double leave = 1.0;
  for (int k = 0; k < 3; ++k) {
    const double low = (-box.half[k] - start_b[k]) / way_b[k];
    const double high = (box.half[k] - start_b[k]) / way_b[k];
    if (way_b[k] == 0.0 && std::abs(start_b[k]) > box.half[k]) return false;
    if (way_b[k] == 0.0) continue;
    enter = std::max(enter, std::min(low, high));
    leave = std::min(leave, std::max(low, high));
  }
  return enter < leave;
}

// A fixed box between the eye and the middle of a movable one, as the front walls of a cage.
bool stands_in_front(const World& world, std::size_t fixed, const Vec3& direction_w) {
  if (world.bodies()[fixed].movable() || world.bodies()[fixed].shape != Shape::box) return false;
  const Box box = box_of(world.bodies()[fixed], world.states()[fixed]);
  for (std::size_t k = 0; k < world.bodies().size(); ++k) {
    if (!world.bodies()[k].movable()) continue;
    const Vec3& middle_w = world.states()[k].position_w;
    const double far = (box.center_w - middle_w).norm() + box.half.norm();
    if (hides(box, middle_w, middle_w + far * direction_w.normalized())) return true;
  }
  return false;
}

// The boxes of every frame; those that stand in front in all frames are left out of all.
std::vector<std::vector<PictureBox>> shown_boxes(const std::vector<World>& worlds,
                                                 const Vec3& direction_w) {
  std::map<std::string, std::size_t> in_front;  // in how many frames
  for (const World& world : worlds)
    for (int k = 0; k < world.count(); ++k)
      if (stands_in_front(world, static_cast<std::size_t>(k), direction_w))
        ++in_front[world.name(k)];
  std::vector<std::vector<PictureBox>> frames;
  for (const World& world : worlds) {
    std::vector<PictureBox>& shown = frames.emplace_back();
    const std::vector<PictureBox> boxes = picture_boxes(world);
    const int ground = has_ground(world) ? 1 : 0;  // comes first in the world, and is no box
    for (std::size_t k = 0; k < boxes.size(); ++k)
      if (in_front[world.name(static_cast<int>(k) + ground)] < worlds.size())
        shown.push_back(boxes[k]);
  }
  return frames;
}

std::vector<double> times_of(const RenderRequest& request, const RecordedRun& run) {
  require::that(request.at.empty() || request.strip.empty(), "give --at or --strip, not both");
  if (!request.strip.empty()) return request.strip;
  return request.at.empty() ? std::vector<double>{run.frames.back().time} : request.at;
}

}  // namespace

int render(const RenderRequest& request) {
  require::that(request.form == "svg" || request.form == "png",
                "--as " + request.form + ": expected svg or png" +
                    (request.form == "gif" || request.form == "mp4" || request.form == "gltf"
                         ? " (gif, mp4 and gltf are not available yet)"
                         : ""));
  require::that(request.view.size() == 3, "--view: expected X,Y,Z");
  const Vec3 direction_w(request.view[0], request.view[1], request.view[2]);
  const RecordedRun run =
      read_run(request.folder, request.filtered ? kFilteredFile : kTrajectoryFile);
  const std::vector<double> times = times_of(request, run);

  // One camera for all frames, so that a viewer can compare them.
  std::vector<World> worlds;
  for (const double time : times) worlds.push_back(world_of(run, nearest_frame(run, time)));
  const std::vector<std::vector<PictureBox>> frames = shown_boxes(worlds, direction_w);
  std::vector<PictureBox> all;
  for (const auto& boxes : frames) all.insert(all.end(), boxes.begin(), boxes.end());
  const Page page = page_for(frames.size());
  const bool floor = run.scene.ground.has_value();
  const Camera camera = camera_for(all, direction_w, page.width, page.height, floor);

  std::string commands = terminal(request.form, page);
  if (frames.size() > 1) {
    commands += "set multiplot layout " + std::to_string(page.rows) + ",";
    commands += std::to_string(page.columns) + "\n";
  }
  for (std::size_t k = 0; k < frames.size(); ++k) {
    if (frames.size() > 1) commands += label(nearest_frame(run, times[k]).time);
    commands += to_gnuplot(draw_boxes(frames[k], camera, floor));
  }
  if (frames.size() > 1) commands += "unset multiplot\n";
  const std::string stem = std::string(request.strip.empty() ? "picture" : "strip") +
                           (request.filtered ? "_filtered" : "");
  const std::string picture = stem + "." + request.form;
  draw_with_gnuplot(request.folder, stem + ".gp", commands, picture);
  std::printf("%s\n", (std::filesystem::path(request.folder) / picture).c_str());
  return kDone;
}

}  // namespace tumble::app
