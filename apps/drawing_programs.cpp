/// \file
/// \brief Running gnuplot and ffmpeg.
#include "drawing_programs.hpp"

#include "tumble/base/number_text.hpp"
#include "tumble/record/table_file.hpp"

#include "program.hpp"

namespace tumble::app {
namespace {

// Puts a file that a program has written in its place, or removes what there is of it.
void finish(int code, const std::filesystem::path& part, const std::filesystem::path& path,
            const std::string& missing, const std::string& failure) {
  std::error_code failed;
  if (code == 0) std::filesystem::rename(part, path, failed);
  if (code == 0 && !failed) return;
  std::filesystem::remove(part, failed);
  throw CannotWrite("tumble: " + (code == kNoProgram ? missing : failure));
}

std::string_view bytes_of(const Raster& raster) {
  return {reinterpret_cast<const char*>(raster.rgb.data()), raster.rgb.size()};
}

}  // namespace

void draw_with_gnuplot(const std::filesystem::path& folder, const std::string& script,
                       const std::string& commands, const std::string& picture) {
  const std::string part = picture + ".part";
  write_file(folder / script, "set output '" + part + "'\n" + commands);
  std::error_code failed;
  std::filesystem::remove(folder / part, failed);  // a link there would be followed
  finish(run_program({"gnuplot", script}, folder), folder / part, folder / picture,
         "gnuplot is missing: install the package gnuplot-nox",
         "gnuplot could not draw " + (folder / picture).string() + ", its script is " + script +
             " beside it");
}

void write_video(const std::filesystem::path& path, int frames, double rate,
                 const std::function<Raster(int)>& frame) {
  const Raster first = frame(0);
  const std::filesystem::path folder = path.parent_path();
  const std::string part = path.filename().string() + ".part";
  const std::vector<std::string> words = {
      "ffmpeg", "-hide_banner", "-loglevel", "error", "-y",
      // what comes in
      "-f", "rawvideo", "-pixel_format", "rgb24", "-video_size",
      std::to_string(first.width) + "x" + std::to_string(first.height), "-framerate",
      shortest_text(rate), "-i", "-",
      // what goes out: what every player shows, at once, and the same bytes every time
      "-c:v", "libx264", "-crf", "20", "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-fflags",
      "+bitexact", "-flags:v", "+bitexact", "-f", "mp4", part};
  std::error_code failed;
  std::filesystem::remove(folder / part, failed);  // a link there would be followed
  int code = 0;
  try {
    code = run_program(words, folder, [&](const Feeder& feed) {
      for (int k = 0; k < frames; ++k)
        if (!feed(k == 0 ? bytes_of(first) : bytes_of(frame(k)))) return;
    });
  } catch (...) {
    std::filesystem::remove(folder / part, failed);
    throw;
  }
  finish(code, folder / part, path,
         "ffmpeg is missing: install the package ffmpeg, or take --as gif, which needs none",
         "ffmpeg could not write " + path.string());
}

}  // namespace tumble::app
