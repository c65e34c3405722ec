/// \file
/// \brief A cube shot at a pyramid, and a crate that falls off a table (thesis 1.1, 6.1).
#include "impulse_damped/scene_experiments.hpp"

#include "tumble/math/elementary.hpp"
#include "tumble/pictures/film.hpp"
#include "tumble/pictures/world_picture.hpp"
#include "tumble/record/metrics.hpp"

#include "driver/played_scene.hpp"
#include "impulse_damped/damped_variants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace tumble::chapters {
namespace {

constexpr int kFrames = 6;

// Draws frames by one camera that shows the ground around all of them.
std::vector<Drawing> drawings_of(const std::vector<std::vector<PictureBox>>& frames,
                                 const Camera& camera) {
  std::vector<PictureBox> all;
  for (const auto& boxes : frames) all.insert(all.end(), boxes.begin(), boxes.end());
  std::vector<Drawing> drawings;
  for (std::size_t k = 0; k < frames.size(); ++k)
    drawings.push_back(
        {"frame" + std::to_string(k + 1), to_gnuplot(draw_boxes(frames[k], camera, true, all))});
  return drawings;
}

constexpr double kFilmRate = 20.0;            // [1/s]
constexpr double kFilmTimes[] = {-0.3, 3.0};  // [s] since the shot

// Takes a frame of the film, if it is time for one: every third step is.
void take(const PlayedScene& played, double shot, std::vector<FilmFrame>& frames) {
  const double time = played.world().time() - shot;
  const double next = frames.empty() ? kFilmTimes[0] : frames.back().time + 1.0 / kFilmRate;
  constexpr double half = 0.5 * kStep;
  if (time < next - half || time > kFilmTimes[1] + half) return;
  frames.push_back({time, picture_boxes(played.world())});
}

Scene shot_scene(const Parameters& settings) {
  std::vector<std::string> scene = {"rows=" + std::to_string(settings.count("rows"))};
  for (const char* key : {"height", "speed", "mass", "appears"})
    scene.push_back(setting(key, settings.number(key)));
  return scene_with("fig6_6", scene);
}

// The largest distance that a box is from where it was.
double farthest_moved(const World& world, const std::vector<BodyState>& from) {
  double moved = 0.0;
  for (std::size_t k = 0; k < from.size(); ++k)
    moved = std::max(moved, (world.states()[k].position_w - from[k].position_w).norm());
  return moved;
}

// Boxes without a face that is level within two degrees.
double leaning(const PlayedScene& played) {
  constexpr double level = 0.99939;  // [-] cosine of two degrees
  double count = 0.0;
  for (const SceneBox& box : played.scene().boxes) {
    const BodyState& state = played.world().states()[played.index(box.name)];
    const Mat3 axes_w = state.orientation_wb.toRotationMatrix();
    count += axes_w.row(1).cwiseAbs().maxCoeff() < level ? 1.0 : 0.0;
  }
  return count;
}

// Boxes that are lower than at the start by more than half an edge.
double fallen(const PlayedScene& played) {
  double count = 0.0;
  for (const SceneBox& box : played.scene().boxes) {
    if (box.appears > 0.0) continue;
    const BodyState& state = played.world().states()[played.index(box.name)];
    count += state.position_w.y() < box.position_w.y() - 0.5 ? 1.0 : 0.0;
  }
  return count;
}

constexpr int kCrateFrames = 4;
constexpr double kEdge = 1.0;  // [m] of the table

Scene crate_scene(const Parameters& settings, double speed) {
  return scene_with("crate_off_table",
                    {setting("speed", speed), setting("friction", settings.number("friction"))});
}

double degrees(double angle) { return angle * 180.0 / std::numbers::pi; }

// How a crate goes over the edge and comes to rest.
struct CratePath {
  double passes = 0.0;          // [s] when its centre passes the edge; 0: it does not
  double speed = 0.0;           // [m/s] then
  Vec3 rests_w = Vec3::Zero();  // [m] after five seconds
  double tilt = 0.0;            // [deg] how far a face is from level then
};

CratePath crate_path(const Scene& scene, const PlayedTechnique& technique) {
  PlayedScene played(scene, technique);
  CratePath path;
  played.advance(5.0, [&](const StepReport&) {
    const double x = played.world().states()[played.index("crate")].position_w.x();
    if (path.passes > 0.0 || x < kEdge) return;
    path.passes = played.world().time();
    path.speed = played.speed("crate");
  });
  const BodyState& crate = played.world().states()[played.index("crate")];
  const double level = crate.orientation_wb.toRotationMatrix().row(1).cwiseAbs().maxCoeff();
  path.rests_w = crate.position_w;
  path.tilt = degrees(elementary::acos(std::min(1.0, level)));
  return path;
}

}  // namespace

Result measure_projectile(const Parameters& settings) {
  const double appears = settings.number("appears");
  PlayedScene played(shot_scene(settings), {"damped"});
  const auto poses = [&] {
    return std::vector<BodyState>(played.world().states().begin(), played.world().states().end());
  };
  // Its boxes are built to touch exactly, and settle a little in the beginning.
  const std::vector<BodyState> built = poses();
  played.advance(0.5);
  const double settles = farthest_moved(played.world(), built);
  const std::vector<BodyState> stands = poses();
  Film film;
  const auto watch = [&](const StepReport&) { take(played, appears, film.frames); };
  played.advance(appears - 2.0 * kStep, watch);
  const double moves = farthest_moved(played.world(), stands);

  Table table{"", {{"time_s", "s", "since the shot"}, {"fallen", "-", "boxes that have fallen"}}};
  std::vector<std::vector<PictureBox>> frames;
  for (int k = 0; k < kFrames; ++k) {
    const double time = settings.number(std::string("t").append(std::to_string(k + 1)));
    played.advance(appears + time, watch);
    table.rows.push_back({time, fallen(played)});
    frames.push_back(picture_boxes(played.world()));
  }
  PlayedScene other(shot_scene(settings), coulomb_technique());
  other.advance(played.world().time());

  // From behind and above the one who shoots.
  const SceneBox& shot = played.scene().boxes.back();
  Camera camera;
  camera.eye_w = shot.position_w + Vec3(3.5, 4.5, 9.0);
  camera.target_w = Vec3(0.0, 0.47 * settings.count("rows"), 0.0);
  camera.field_of_view = 0.74;
  camera.width = 300.0;
  camera.height = 200.0;
  film.camera = camera;
  film.camera.width = 480.0;
  film.camera.height = 320.0;
  return {{table},
          {{"farthest that a box moves in the first half second", "mm", 1e3 * settles},
           {"farthest that a box moves from then to the shot", "mm", 1e3 * moves},
           {"boxes of the pyramid", "-", static_cast<double>(played.scene().boxes.size()) - 1.0},
           {"boxes that have fallen in the last frame", "-", table.rows.back()[1]},
           {"the same, Coulomb", "-", fallen(other)}},
          drawings_of(frames, camera),
          [film] { return to_gif(film, kFilmRate); }};
}

Result measure_projectile_curves(const Parameters& settings) {
  const double appears = settings.number("appears");
  PlayedScene played(shot_scene(settings), {"damped"});
  MetricsMeter meter;
  meter.begin(played.world());
  Table table{"",
              {{"time_s", "s", "since the shot"},
               {"kinetic_J", "J", "kinetic energy"},
               {"total_J", "J", "kinetic and potential energy, over those of the pyramid at rest"},
               {"overlap_mm", "mm", "deepest overlap of all pairs"},
               {"chatter_mm", "mm", "amplitude over the last half second, of the worst box"},
               {"resting", "-", "boxes that rest and are measured"}}};
  double rest = 0.0;
  double deepest_before = 0.0;
  double chatter_before = 0.0;
  double most_gained = 0.0;
  double last_total = 0.0;
  std::array<double, 3> worst{};  // overlap [mm], chatter [mm], acceleration [-] after the shot
  Metrics m;
  int bodies = played.world().count();
  bool shot = false;
  played.advance(appears + settings.number("duration"), [&](const StepReport& report) {
    m = meter.measure(played.world(), report);
    const double time = played.world().time() - appears;
    const double total = m.kinetic + m.potential;
    const bool enters = played.world().count() > bodies;  // with its energy
    bodies = played.world().count();
    shot = shot || enters;
    if (!shot) {
      rest = m.potential;
      deepest_before = std::max(deepest_before, m.deepest_overlap);
      // The meter looks half a second back, and the first half second is for settling.
      if (played.world().time() > 1.0)
        chatter_before = std::max(chatter_before, m.chatter.amplitude);
    } else if (!enters) {
      most_gained = std::max(most_gained, total - last_total);
      worst = {std::max(worst[0], 1e3 * m.deepest_overlap),
               std::max(worst[1], 1e3 * m.chatter.amplitude),
               std::max(worst[2], m.chatter.acceleration)};
    }
    last_total = total;
    if (time > -1.0 - 0.5 * kStep)
      table.rows.push_back({time, m.kinetic, total, 1e3 * m.deepest_overlap,
                            1e3 * m.chatter.amplitude, static_cast<double>(m.chatter.bodies)});
  });
  for (auto& row : table.rows) row[2] -= rest;
  return {{table},
          {{"deepest overlap before the shot", "mm", 1e3 * deepest_before},
           {"largest chatter before the shot, after a second", "mm", 1e3 * chatter_before},
           {"deepest overlap after the shot", "mm", worst[0]},
           {"largest chatter after the shot", "mm", worst[1]},
           {"largest acceleration of chatter after the shot, over g", "-", worst[2]},
           {"chatter at the end", "mm", 1e3 * m.chatter.amplitude},
           {"boxes that rest at the end", "-", static_cast<double>(m.chatter.bodies)},
           {"boxes that lean by more than two degrees at the end", "-", leaning(played)},
           {"kinetic energy at the end", "J", m.kinetic},
           {"largest gain of energy in a step", "J", most_gained}}};
}

Result measure_crate(const Parameters& settings) {
  Table table{"",
              {{"technique", "-", "0: damped; 1: Coulomb's friction"},
               {"time_s", "s", "since the centre of the crate passed the edge"},
               {"x_m", "m", "centre of the crate, from the edge"},
               {"y_m", "m", "centre of the crate"},
               {"turned_deg", "deg", "between its upright axis and the vertical"}}};
  std::vector<Quantity> quantities;
  std::vector<std::vector<PictureBox>> frames;
  const auto watch = [&](const PlayedTechnique& technique, const char* speed,
                         const std::string& words) {
    const Scene scene = crate_scene(settings, settings.number(speed));
    const CratePath path = crate_path(scene, technique);
    quantities.push_back(
        {"speed of the crate as its centre passes the edge, " + words, "m/s", path.speed});
    quantities.push_back(
        {"where it rests, from the edge, " + words, "m", path.rests_w.x() - kEdge});
    quantities.push_back({"how far a face of it is from level then, " + words, "deg", path.tilt});
    PlayedScene played(scene, technique);
    for (int k = 0; k < kCrateFrames; ++k) {
      const double time = settings.number(std::string("t").append(std::to_string(k + 1)));
      played.advance(path.passes + time);
      const BodyState& crate = played.world().states()[played.index("crate")];
      const double up = (crate.orientation_wb * Vec3::UnitY()).y();
      table.rows.push_back({frames.size() < kCrateFrames ? 0.0 : 1.0, time,
                            crate.position_w.x() - kEdge, crate.position_w.y(),
                            degrees(elementary::acos(std::clamp(up, -1.0, 1.0)))});
      frames.push_back(picture_boxes(played.world()));
      frames.back().back().colour = 0xd55e00;
    }
  };
  watch({"damped"}, "damped_speed", "damped");
  watch(coulomb_technique(), "speed", "Coulomb");
  const CratePath stays = crate_path(crate_scene(settings, settings.number("speed")), {"damped"});
  quantities.push_back(
      {"how far it slides, damped, with the start of Coulomb's run", "m", stays.rests_w.x() + 0.6});

  std::vector<PictureBox> all;
  for (const auto& boxes : frames) all.insert(all.end(), boxes.begin(), boxes.end());
  const Camera camera = camera_for(all, Vec3(0.45, 0.3, 1.0), 300.0, 190.0, true);
  return {{table}, quantities, drawings_of(frames, camera)};
}

}  // namespace tumble::chapters
