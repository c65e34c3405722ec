/// \file
/// \brief A cube that is shot at a pyramid (thesis 6.1).
#include "tumble/pictures/film.hpp"
#include "tumble/pictures/world_picture.hpp"
#include "tumble/record/metrics.hpp"

#include "impulse_damped/damped_variants.hpp"

namespace tumble::chapters {
namespace {

constexpr std::array<double, 6> kFrames{0.05, 0.25, 0.4, 0.55, 0.8, 3.0};  // [s] since the shot

constexpr double kShotFilmRate = 20.0;        // [1/s]
constexpr double kFilmTimes[] = {-0.3, 3.0};  // [s] since the shot

// Takes a frame of the film, if it is time for one: every third step is.
void take(const PlayedScene& played, double shot, std::vector<FilmFrame>& frames) {
  const double time = played.world().time() - shot;
  const double next = frames.empty() ? kFilmTimes[0] : frames.back().time + 1.0 / kShotFilmRate;
  constexpr double half = 0.5 * kStep;
  if (time < next - half || time > kFilmTimes[1] + half) return;
  frames.push_back({time, picture_boxes(played.world())});
}

std::string frame_key(std::size_t k) { return std::string("t").append(std::to_string(k + 1)); }

Scene shot_scene(const Parameters& settings) {
  std::vector<std::string> scene = {"rows=" + std::to_string(settings.count("rows"))};
  for (const char* key : {"height", "speed", "mass", "appears"})
    scene.push_back(setting(key, settings.number(key)));
  return make_scene("fig6_6", scene);
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

Result measure_projectile(const Parameters& settings) {
  const double appears = settings.number("appears");
  PlayedScene played(shot_scene(settings), {"damped"});
  const auto poses = [&] {
    return std::vector<BodyState>(played.world().states().begin(), played.world().states().end());
  };
  // Its boxes are built to touch exactly, and settle a little in the beginning.
  const std::vector<BodyState> built = poses();
  played.advance(0.5);
  const double settles = farthest_moved(built, played.world().states());
  const std::vector<BodyState> stands = poses();
  Film film;
  const auto watch = [&](const StepReport&) { take(played, appears, film.frames); };
  played.advance(appears - 2.0 * kStep, watch);
  const double moves = farthest_moved(stands, played.world().states());

  Table table{"", {{"time_s", "s", "since the shot"}}};
  std::vector<std::vector<PictureBox>> frames;
  std::vector<PictureBox> all;
  for (std::size_t k = 0; k < kFrames.size(); ++k) {
    const double time = settings.number(frame_key(k));
    played.advance(appears + time, watch);
    table.add(time);
    frames.push_back(picture_boxes(played.world()));
    all.insert(all.end(), frames.back().begin(), frames.back().end());
  }

  // From behind and above the start of the shot.
  const SceneBox& shot = played.scene().boxes.back();
  Camera camera{.eye_w = shot.position_w + Vec3(3.5, 4.5, 9.0),
                .target_w = Vec3(0.0, 0.47 * settings.count("rows"), 0.0),
                .field_of_view = 0.74,
                .width = 300.0,
                .height = 200.0};
  std::vector<Drawing> drawings;  // all show the ground around the boxes of every frame
  // The hole and what was shot out of it are behind the pyramid: the later half is seen from there.
  Camera behind = camera;
  behind.eye_w = Vec3(0.8, 1.3, -1.35).cwiseProduct(shot.position_w + Vec3(9.0, 6.0, 9.0));
  film.camera = behind;
  film.camera.width = 480.0;
  film.camera.height = 320.0;
  for (std::size_t k = 0; k < frames.size(); ++k)
    drawings.push_back(
        {"frame" + std::to_string(k + 1),
         to_gnuplot(draw_boxes(frames[k], k < frames.size() / 2 ? camera : behind, true, all))});
  return {{table},
          {{"farthest that a box moves in the first half second", "mm", 1e3 * settles},
           {"farthest that a box moves from then to the shot", "mm", 1e3 * moves},
           {"boxes of the pyramid", "-", played.scene().boxes.size() - 1},
           {"boxes that have fallen in the last frame", "-", fallen(played)}},
          drawings,
          [film] { return to_gif(film, kShotFilmRate); }};
}

// Of both figures.
Parameters shot_parameters() {
  return {whole("rows", 10, 2, 30, "of the pyramid"),
          number("height", 3.5, 0.5, 30.0, "m", "of the projectile's centre"),
          number("speed", 20.0, 0.1, 100.0, "m/s", "of the projectile"),
          number("mass", 5.0, 1e-3, 1e3, "kg", "of the projectile; a box has 1 kg"),
          number("appears", 5.0, 1.0, 100.0, "s", "for how long the pyramid stands before")};
}

Parameters projectile_parameters() {
  Parameters parameters = shot_parameters();
  for (std::size_t k = 0; k < kFrames.size(); ++k)
    parameters.add(number(frame_key(k), kFrames[k], 0.0, 60.0, "s", "of a frame, since the shot"));
  return parameters;
}

const Registered fig6_6_projectile_figure{{.name = "fig6_6_projectile",
                                           .parameters = projectile_parameters(),
                                           .quick = {"rows=4", "height=1.5", "appears=1"},
                                           .experiment = measure_projectile}};

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
               {"chatter_mm", "mm", "amplitude over the last half second, of the worst box"}}};
  double rest = 0.0;
  double deepest_before = 0.0;
  double chatter_before = 0.0;
  double most_gained = 0.0;
  double last_total = 0.0;
  double deepest_after = 0.0;
  double chatter_after = 0.0;
  int bodies = played.world().count();
  bool shot = false;
  played.advance(appears + settings.number("duration"), [&](const StepReport& report) {
    const Metrics m = meter.measure(played.world(), report);
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
      deepest_after = std::max(deepest_after, m.deepest_overlap);
      chatter_after = std::max(chatter_after, m.chatter.amplitude);
    }
    last_total = total;
    if (time > -1.0 - 0.5 * kStep)
      table.add(time, m.kinetic, total, 1e3 * m.deepest_overlap, 1e3 * m.chatter.amplitude);
  });
  for (auto& row : table.rows) row[2] -= rest;
  return {{table},
          {{"deepest overlap before the shot", "mm", 1e3 * deepest_before},
           {"largest chatter before the shot, after a second", "mm", 1e3 * chatter_before},
           {"deepest overlap after the shot", "mm", 1e3 * deepest_after},
           {"largest chatter after the shot", "mm", 1e3 * chatter_after},
           {"largest gain of energy in a step", "J", most_gained}}};
}

const Registered fig6_6_projectile_curves_figure{
    {.name = "fig6_6_projectile_curves",
     .parameters = shot_parameters().add(number("duration", 5.0, 1.0, 60.0, "s", "after the shot")),
     .quick = {"rows=4", "height=1.5", "appears=1", "duration=2"},
     .experiment = measure_projectile_curves}};

}  // namespace
}  // namespace tumble::chapters
