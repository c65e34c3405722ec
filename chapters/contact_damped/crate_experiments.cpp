/// \file
/// \brief A crate that slides off a table and tumbles (thesis 1.1).
#include "tumble/pictures/world_picture.hpp"

#include "driver/experiment.hpp"
#include "driver/side_by_side.hpp"

namespace tumble::chapters {
namespace {

constexpr std::array<double, 4> kFrames{-0.25, 0.2, 0.4, 1.5};  // [s] since the edge was passed
constexpr double kEdge = 1.0;                                   // [m] of the table
constexpr double kStart = -0.6;                                 // [m] of the crate

const BodyState& crate_of(const PlayedScene& played) {
  return played.world().states()[played.index("crate")];
}

// How a crate goes over the edge and comes to rest.
struct CratePath {
  double passes = 0.0;  // [s] when its centre passes the edge; 0: it does not
  double speed = 0.0;   // [m/s] then
  double rests = 0.0;   // [m] along x after five seconds
  double tilt = 0.0;    // [deg] of the face that is nearest to level then
};

CratePath crate_path(const Scene& scene, const PlayedTechnique& technique) {
  PlayedScene played(scene, technique);
  CratePath path;
  played.advance(5.0, [&](const StepReport&) {
    if (path.passes > 0.0 || crate_of(played).position_w.x() < kEdge) return;
    path.passes = played.world().time();
    path.speed = played.speed("crate");
  });
  const BodyState& crate = crate_of(played);
  const double level = crate.orientation_wb.toRotationMatrix().row(1).cwiseAbs().maxCoeff();
  path.rests = crate.position_w.x();
  path.tilt = elementary::acos(std::min(1.0, level)) * 180.0 / std::numbers::pi;
  return path;
}

std::string frame_key(std::size_t k) { return std::string("t").append(std::to_string(k + 1)); }

Result measure_crate(const Parameters& settings) {
  Table table{"", {{"time_s", "s", "since the centre of the crate passed the edge"}}};
  std::vector<Quantity> quantities;
  std::vector<std::vector<PictureBox>> frames;
  std::vector<PictureBox> all;
  std::vector<std::vector<FilmFrame>> films;
  const auto red = [](std::vector<PictureBox>& boxes) { boxes.back().colour = 0xd55e00; };
  const auto scene_of = [&](const char* speed) {
    return make_scene("crate_off_table", {setting("speed", settings.number(speed)),
                                          setting("friction", settings.number("friction"))});
  };
  const auto watch = [&](const PlayedTechnique& technique, const char* speed,
                         const std::string& words) {
    const Scene scene = scene_of(speed);
    const CratePath path = crate_path(scene, technique);
    quantities.push_back(
        {"speed of the crate as its centre passes the edge, " + words, "m/s", path.speed});
    quantities.push_back({"where it rests, from the edge, " + words, "m", path.rests - kEdge});
    quantities.push_back({"how far a face of it is from level then, " + words, "deg", path.tilt});
    PlayedScene played(scene, technique);
    for (std::size_t k = 0; k < kFrames.size(); ++k) {
      const double time = settings.number(frame_key(k));
      played.advance(path.passes + time);
      table.add(time);
      frames.push_back(picture_boxes(played.world()));
      red(frames.back());
      all.insert(all.end(), frames.back().begin(), frames.back().end());
    }
    films.push_back(frames_of_run(scene, technique, path.passes + settings.number("t1"),
                                  path.passes + settings.number("t4"), path.passes, red));
  };
  watch({"damped"}, "damped_speed", "damped");
  watch({"contact_damped"}, "speed", "Coulomb");
  quantities.push_back({"how far it slides, damped, with the start of Coulomb's run", "m",
                        crate_path(scene_of("speed"), {"damped"}).rests - kStart});

  const Camera camera = camera_for(all, Vec3(0.45, 0.3, 1.0), 300.0, 190.0, true);
  std::vector<Drawing> drawings;
  for (std::size_t k = 0; k < frames.size(); ++k)
    drawings.push_back(
        {"frame" + std::to_string(k + 1), to_gnuplot(draw_boxes(frames[k], camera, true, all))});
  return {{table}, quantities, drawings, [films] {
            return film_beside(films[0], films[1], Vec3(0.45, 0.3, 1.0), 240, 200);
          }};
}

Parameters crate_parameters() {
  Parameters parameters;
  parameters.add(number("speed", 3.5, 0.0, 100.0, "m/s", "at the start, Coulomb's friction"))
      .add(number("damped_speed", 10.0, 0.0, 100.0, "m/s", "at the start, damped"))
      .add(number("friction", 0.3, 0.0, 10.0, "-", "Coulomb's coefficient"));
  for (std::size_t k = 0; k < kFrames.size(); ++k)
    parameters.add(number(frame_key(k), kFrames[k], -10.0, 60.0, "s",
                          "of a frame, since the crate passes the edge"));
  return parameters;
}

const Registered crate_off_table_figure{
    {.name = "crate_off_table", .parameters = crate_parameters(), .experiment = measure_crate}};

}  // namespace
}  // namespace tumble::chapters
