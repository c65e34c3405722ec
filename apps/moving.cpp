/// \file
/// \brief The frames of a film, and writing it.
#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/pictures/gif.hpp"
#include "tumble/pictures/gltf.hpp"
#include "tumble/record/table_file.hpp"

#include "drawing_programs.hpp"
#include "frames.hpp"
#include "progress.hpp"
#include "view_page.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace tumble::app {
namespace {

constexpr double kRate = 25.0;                  // [1/s]
constexpr double kOnTheGrid = 2.5e-7;           // [-] of an interval: sums of steps are off by less
constexpr double kMostFrames = 20000;           // 13 minutes
constexpr int kGifWidth = 480;                  // [px]
constexpr int kVideoWidth = 960;                // [px]
constexpr int kLeastWidth = 60;                 // [px]
constexpr int kMostWidth = 3840;                // [px]
constexpr double kVideoRates[] = {1.0, 240.0};  // [1/s]
constexpr double kGifRates[] = {1.0, 50.0};     // [1/s] above it browsers slow down
constexpr double kSpeeds[] = {1e-6, 1e6};       // [-]

// The first and the last time.
struct Range {
  double from = 0.0;  // [s]
  double to = 0.0;    // [s]
};

Range range_of(const RenderRequest& request, const RecordedRun& run) {
  const double first = run.frames.front().time;
  const double last = run.frames.back().time;
  require::that(first < last, "the run has one frame only, at " + shortest_text(first) +
                                  " s: run it for longer, or draw it with --as svg");
  // As with --at, half a frame outside is the first or the last one: a run of 5 s ends with rounding.
  const auto recorded = [&](double time) {
    static_cast<void>(nearest_frame(run, time));  // refuses times farther outside
    return std::clamp(time, first, last);
  };
  const Range range{recorded(request.from.value_or(first)), recorded(request.to.value_or(last))};
  require::that(range.from < range.to, "--from " + shortest_text(range.from) + " --to " +
                                           shortest_text(range.to) +
                                           ": expected the end to come after the beginning");
  return range;
}

// The frames that were recorded, or such at equal times from the first to the last one that is not
// too late.
std::vector<RecordedFrame> frames_of(const RenderRequest& request, const RecordedRun& run,
                                     std::optional<double> interval) {
  const Range range = range_of(request, run);
  std::vector<RecordedFrame> frames;
  if (interval) {
    const double last = std::floor((range.to - range.from) / *interval + kOnTheGrid);
    require::that(last < kMostFrames, shortest_text(last + 1.0) +
                                          " frames: expected 20000 at most; take a part with "
                                          "--from and --to, or raise --speed");
    for (int k = 0; k <= static_cast<int>(last); ++k)
      frames.push_back(frame_at(run, std::min(range.to, range.from + k * *interval)));
  } else {
    const double from = nearest_frame(run, range.from).time;
    const double to = nearest_frame(run, range.to).time;
    for (const RecordedFrame& frame : run.frames)
      if (frame.time >= from && frame.time <= to) frames.push_back(frame);
  }
  require::that(frames.size() > 1, "--from " + shortest_text(range.from) + " --to " +
                                       shortest_text(range.to) +
                                       ": fewer than two frames are in between: choose a longer "
                                       "part, or lower --speed");
  return frames;
}

int width_of(const RenderRequest& request) {
  const int width = request.width.value_or(request.form == "gif" ? kGifWidth : kVideoWidth);
  require::that(width >= kLeastWidth && width <= kMostWidth && width % 2 == 0,
                "--width " + std::to_string(width) + ": expected an even number from 60 to 3840");
  return width;
}

void write_film(const RenderRequest& request, const RecordedRun& run,
                const std::filesystem::path& path) {
  const bool gif = request.form == "gif";
  const int width = width_of(request);
  const int height = width / 3 * 2;  // even, as videos ask for
  const double rate = request.rate.value_or(kRate);
  const auto& rates = gif ? kGifRates : kVideoRates;
  require::within(rate, rates[0], rates[1], "--fps");
  const Vec3 direction_w(request.view[0], request.view[1], request.view[2]);
  const std::vector<RecordedFrame> frames =
      frames_of(request, run, request.speed.value_or(1.0) / rate);
  const Film film = film_of(shown_frames(run, frames, direction_w), direction_w, width, height,
                            run.scene.ground.has_value());
  const FilmPainter painter(film);
  const TerminalLine line;
  const auto paint = [&](int frame) {
    if (stop_signal() != 0) throw CannotWrite("tumble: interrupted");
    if (line.shown()) std::fprintf(stderr, "\r\x1b[Kframe %d of %zu", frame + 1, frames.size());
    return painter.painted(frame);
  };
  if (gif) {
    write_file(path, to_gif(film_delays(film, rate), paint));
  } else {
    write_video(path, static_cast<int>(frames.size()), rate, paint);
  }
}

}  // namespace

std::string write_moving(const RenderRequest& request, const RecordedRun& run) {
  const bool page = request.form == "html";
  const std::string name = (page ? "view" : "film") + suffix_of(request) + "." + request.form;
  const std::filesystem::path path = std::filesystem::path(request.folder) / name;
  const double speed = request.speed.value_or(1.0);
  require::within(speed, kSpeeds[0], kSpeeds[1], "--speed");
  if (request.form != "gltf" && !page) {
    write_film(request, run, path);
    return name;
  }
  require::that(!request.width, "--as " + request.form + ": --width is for gif and mp4");
  std::optional<double> interval;
  if (request.rate) {
    require::within(*request.rate, kVideoRates[0], kVideoRates[1], "--fps");
    interval = speed / *request.rate;
  }
  std::string text = to_gltf(run, frames_of(request, run, interval), speed);
  if (page) {
    const std::filesystem::path folder = std::filesystem::absolute(request.folder);
    const std::string title = run.scene.title.empty() ? "" : run.scene.title + ", ";
    const Vec3 direction_w(request.view[0], request.view[1], request.view[2]);
    text = view_page(title + folder.lexically_normal().filename().string(), text, direction_w);
  }
  write_file(path, text);
  return name;
}

}  // namespace tumble::app
