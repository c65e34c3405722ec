/// \file
/// \brief `tumble render`: pictures and films of a recorded run.
#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/pictures/film.hpp"
#include "tumble/record/recorded_run.hpp"
#include "tumble/record/table_file.hpp"

#include "drawing_programs.hpp"
#include "frames.hpp"
#include "request.hpp"

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

// Frames in rows, each with its time.
std::string strip_svg(const Film& film, const Page& page) {
  const auto text = [](double pixels) { return fixed_text(pixels, 0); };
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " +
                    text(page.width * page.columns) + ' ' + text(page.height * page.rows) +
                    "\" font-family=\"sans-serif\" font-size=\"16\">\n";
  for (std::size_t k = 0; k < film.frames.size(); ++k) {
    const double x = page.width * static_cast<double>(k % idx(page.columns));
    const double y = page.height * static_cast<double>(k / idx(page.columns));
    const Picture picture = draw_boxes(film.frames[k].boxes, film.camera, film.floor);
    out += "<svg x=\"" + text(x) + "\" y=\"" + text(y) + "\" width=\"" + text(page.width) +
           "\" height=\"" + text(page.height) + "\" " + to_svg(picture).substr(5);
    out += "<text x=\"" + text(x + 12.0) + "\" y=\"" + text(y + 24.0) + "\">" +
           fixed_text(film.frames[k].time, 2) + " s</text>\n";
  }
  return out + "</svg>\n";
}

// The same as pixels; what is left of the last row is white.
Raster strip_pixels(const Film& film, const Page& page) {
  const FilmPainter painter(film);
  Raster out;
  for (int row = 0; row < page.rows; ++row) {
    Raster line;
    for (int column = 0; column < page.columns; ++column) {
      const int k = row * page.columns + column;
      Raster frame = painter.painted(std::min(k, static_cast<int>(film.frames.size()) - 1));
      if (k >= static_cast<int>(film.frames.size()))
        std::fill(frame.rgb.begin(), frame.rgb.end(), std::uint8_t{255});
      line = column == 0 ? std::move(frame) : beside(line, frame);
    }
    out.width = line.width;
    out.height += line.height;
    out.rgb.insert(out.rgb.end(), line.rgb.begin(), line.rgb.end());
  }
  return out;
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
  Film film{.frames = shown_frames(run, moments, direction_w),
            .floor = run.scene.ground.has_value()};
  std::vector<PictureBox> all;
  for (const FilmFrame& frame : film.frames)
    all.insert(all.end(), frame.boxes.begin(), frame.boxes.end());
  const Page page = page_for(film.frames.size());
  const bool pixels = request.form == "png";
  const double scale = pixels ? 2.0 : 1.0;  // for screens with small pixels
  film.camera = camera_for(all, direction_w, scale * page.width, scale * page.height, film.floor);
  const std::string name =
      (request.strip.empty() ? "picture" : "strip") + suffix_of(request) + "." + request.form;
  const std::filesystem::path path = std::filesystem::path(request.folder) / name;
  if (pixels) {
    write_png(path, strip_pixels(film, page));
  } else if (film.frames.size() > 1) {
    write_file(path, strip_svg(film, page));
  } else {
    write_file(path, to_svg(draw_boxes(film.frames[0].boxes, film.camera, film.floor)));
  }
  return name;
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

int render_command(const RenderRequest& request) {
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
