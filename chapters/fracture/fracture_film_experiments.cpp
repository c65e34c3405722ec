/// \file
/// \brief A plank that breaks across a bar, and a wall that a cube breaks (thesis 2.4.1).
#include "driver/experiment.hpp"
#include "fracture/fracture_pictures.hpp"
#include "fracture/fracture_scenes.hpp"

namespace tumble::chapters {
namespace {

constexpr double kFilmFrame = 0.0025;    // [s] of the scene between two frames
constexpr double kBreakFilmRate = 15.0;  // [1/s] of them
constexpr double kWallStrength = 2.0e6;  // [Pa] more than that of the plank, which is hit less hard

// Where a still is taken, and all that it counts.
struct Watched {
  std::vector<FractureFrame> frames;
  int pieces = 0;        // of more than a hundredth of the mass
  double largest = 0.0;  // share of the mass of the largest
  double mass = 0.0;     // [-] its change
};

Watched watched(Fracture& scene, const Vec3& size, double duration) {
  Watched found;
  const double mass = scene.mesh().mass();
  const int count = std::max(1, static_cast<int>(duration / kFilmFrame + 0.5));
  found.frames.push_back(frame_of(scene, size, 0.0));
  for (int k = 1; k <= count; ++k) {
    finished(scene.step(kFilmFrame));
    found.frames.push_back(frame_of(scene, size, k * kFilmFrame));
  }
  std::vector<int> piece;
  std::vector<double> masses(idx(pieces_of(scene.mesh(), piece)), 0.0);
  for (std::size_t k = 0; k < piece.size(); ++k)
    masses[idx(piece[k])] += scene.mesh().elements[k].volume * scene.mesh().material.density / mass;
  found.pieces =
      static_cast<int>(std::ranges::count_if(masses, [](double share) { return share > 0.01; }));
  found.largest = *std::ranges::max_element(masses);
  found.mass = scene.mesh().mass() / mass - 1.0;
  return found;
}

Result filmed(Fracture scene, const Vec3& size, double duration, const Vec3& direction_w,
              const std::array<double, 4>& stills, const Vec3& shown) {
  const Watched found = watched(scene, size, duration);
  const PictureBox around{make_box(Vec3(0.0, 0.5 * shown.y(), 0.0), Quat::Identity(), shown)};
  const std::vector<PictureBox> extent{around};
  const Camera camera = camera_for(extent, direction_w, 300.0, 200.0, true);
  Table table{"", {{"time_s", "s", "since the start"}}};
  std::vector<Drawing> drawings;
  for (std::size_t k = 0; k < stills.size(); ++k) {
    const std::size_t at =
        std::min(found.frames.size() - 1, static_cast<std::size_t>(stills[k] / kFilmFrame + 0.5));
    table.add(found.frames[at].time);
    drawings.push_back(
        {"frame" + std::to_string(k + 1), to_gnuplot(drawn(found.frames[at], camera, extent))});
  }
  Result result{.tables = {table}};
  result.add("pieces of more than a hundredth of the mass", "-", found.pieces);
  result.add("share of the mass of the largest piece", "-", found.largest);
  result.add("change of the mass", "-", found.mass);
  result.add("substeps", "-", scene.work().substeps);
  result.add("nodes that cracked", "-", scene.work().cracks.cracks);
  result.drawings = std::move(drawings);
  Camera film = camera;
  film.width = 420.0;
  film.height = 280.0;
  result.film = [frames = found.frames, film, extent] {
    return film_of(frames, film, extent, kBreakFilmRate);
  };
  return result;
}

Result measure_plank(const Parameters& settings) {
  const int fine = settings.count("fine");
  return filmed(
      falling_plank(soft_material(), settings.number("speed"), {20 * fine, fine, 2 * fine}), kPlank,
      settings.number("duration"), Vec3(0.35, 0.3, 1.0),
      {0.0, 0.0075, 0.03, settings.number("duration")}, Vec3(1.1, 0.25, 0.3));
}

Result measure_wall(const Parameters& settings) {
  const int fine = settings.count("fine");
  return filmed(
      hit_wall(soft_material(kWallStrength), settings.number("speed"), {10 * fine, 8 * fine, fine}),
      kWall, settings.number("duration"), Vec3(0.7, 0.35, 1.0),
      {0.0, 0.005, 0.02, settings.number("duration")}, Vec3(1.2, 0.85, 0.8));
}

const Registered plank_figure{
    {.name = "fracture_plank",
     .parameters = {whole("fine", 2, 1, 8, "cells through the thickness"),
                    number("speed", 2.0, 0.0, 100.0, "m/s", "of the drop"),
                    number("duration", 0.08, 0.0025, 1.0, "s", "of the film")},
     .quick = {"fine=1", "duration=0.01"},
     .experiment = measure_plank}};

const Registered wall_figure{
    {.name = "fracture_wall",
     .parameters = {whole("fine", 2, 1, 8, "cells through the thickness"),
                    number("speed", 17.0, 0.0, 100.0, "m/s", "of the cube"),
                    number("duration", 0.05, 0.0025, 1.0, "s", "of the film")},
     .quick = {"fine=1", "duration=0.01"},
     .experiment = measure_wall}};

}  // namespace
}  // namespace tumble::chapters
