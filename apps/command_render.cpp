/// \file
/// \brief `tumble render`: pictures and films of a recorded run.
#include "tumble/base/error.hpp"
#include "tumble/record/recorded_run.hpp"

#include "frames.hpp"
#include "gnuplot.hpp"
#include "moving.hpp"
#include "request.hpp"

#include <array>
#include <cstdio>

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

std::vector<double> times_of(const RenderRequest& request, const RecordedRun& run) {
  require::that(request.at.empty() || request.strip.empty(), "give --at or --strip, not both");
  if (!request.strip.empty()) return request.strip;
  return request.at.empty() ? std::vector<double>{run.frames.back().time} : request.at;
}

// The name of the picture, which has been drawn.
std::string draw_still(const RenderRequest& request, const RecordedRun& run) {
  const Vec3 direction_w(request.view[0], request.view[1], request.view[2]);
  std::vector<RecordedFrame> moments;
  for (const double time : times_of(request, run)) moments.push_back(nearest_frame(run, time));

  // One camera for all frames, so that a viewer can compare them.
  const std::vector<FilmFrame> frames = shown_frames(run, moments, direction_w);
  std::vector<PictureBox> all;
  for (const FilmFrame& frame : frames)
    all.insert(all.end(), frame.boxes.begin(), frame.boxes.end());
  const Page page = page_for(frames.size());
  const bool floor = run.scene.ground.has_value();
  const Camera camera = camera_for(all, direction_w, page.width, page.height, floor);

  std::string commands = terminal(request.form, page);
  if (frames.size() > 1) {
    commands += "set multiplot layout " + std::to_string(page.rows) + ",";
    commands += std::to_string(page.columns) + "\n";
  }
  for (const FilmFrame& frame : frames) {
    if (frames.size() > 1) commands += label(frame.time);
    commands += to_gnuplot(draw_boxes(frame.boxes, camera, floor));
  }
  if (frames.size() > 1) commands += "unset multiplot\n";
  const std::string stem = (request.strip.empty() ? "picture" : "strip") + suffix_of(request);
  draw_with_gnuplot(request.folder, stem + ".gp", commands, stem + "." + request.form);
  return stem + "." + request.form;
}

// What belongs to the one kind of output is refused for the other: nothing typed is without effect.
void require_fitting(const RenderRequest& request, bool still) {
  const std::string as = "--as " + request.form + ": ";
  if (still) {
    const bool moves = request.from || request.to || request.rate || request.speed || request.width;
    require::that(!moves,
                  as + "--from, --to, --fps, --speed and --width are for gif, mp4, gltf and html");
  } else {
    require::that(request.at.empty() && request.strip.empty(),
                  as + "--at and --strip are for svg and png; give --from and --to");
  }
  require::that(request.view.size() == 3, "--view: expected X,Y,Z");
}

}  // namespace

std::string table_of(const RenderRequest& request) {
  const bool sampled = request.motion || is_sampling(request.folder);
  require::that(!sampled || !request.filtered,
                "--filtered: the motions of tumble sample are not filtered");
  if (sampled) return motion_file(request.motion.value_or(1));
  return std::string(request.filtered ? kFilteredFile : kTrajectoryFile);
}

std::string suffix_of(const RenderRequest& request) {
  if (request.filtered) return "_filtered";
  return request.motion.value_or(1) != 1 ? "_" + std::to_string(*request.motion) : "";
}

int render(const RenderRequest& request) {
  const bool still = request.form == "svg" || request.form == "png";
  const bool moves = request.form == "gif" || request.form == "mp4" || request.form == "gltf" ||
                     request.form == "html";
  require::that(still || moves,
                "--as " + request.form + ": expected svg, png, gif, mp4, gltf or html");
  require_fitting(request, still);
  const RecordedRun run = read_run(request.folder, table_of(request));
  try {
    const std::string made = still ? draw_still(request, run) : write_moving(request, run);
    std::printf("%s\n", (std::filesystem::path(request.folder) / made).c_str());
  } catch (const CannotWrite&) {
    if (stop_signal() == 0) throw;
    std::fprintf(stderr, "interrupted: nothing was written\n");
    return 128 + stop_signal();  // as a shell reports a process ended by a signal
  }
  return kDone;
}

}  // namespace tumble::app
