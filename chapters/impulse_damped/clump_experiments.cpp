/// \file
/// \brief Cubes that fly together and settle, coloured by how much each one still shakes (6.1).
#include "tumble/pictures/film.hpp"
#include "tumble/pictures/lighting.hpp"
#include "tumble/pictures/world_picture.hpp"
#include "tumble/record/chatter.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

constexpr double kFilmRate = 20.0;  // [1/s]
constexpr double kFilmEnds = 3.01;  // [s]
constexpr double kQuietest = 1e-3;  // [mm] the scale of colours begins here,
constexpr double kLoudest = 1e2;    // [mm] and ends here, a tenth of an edge of 1 m

// From blue to vermilion over a pale grey: lightness turns there only, and both ends differ
// for readers that do not see red or green.
std::uint32_t colour_of(double amplitude) {
  constexpr std::uint32_t cold = 0x0072b2, middle = 0xf0ead2, hot = 0xd55e00;
  const double clipped = std::clamp(amplitude, kQuietest, kLoudest);
  const double place = elementary::log(clipped / kQuietest) / elementary::log(kLoudest / kQuietest);
  return place < 0.5 ? mixed(cold, middle, 2.0 * place) : mixed(middle, hot, 2.0 * place - 1.0);
}

void watch(const PlayedScene& played, ChatterMeter& meter) {
  const World& world = played.world();
  std::vector<char> touches(static_cast<std::size_t>(world.count()), 0);
  for (const ContactRecord& contact : played.technique().contacts())
    for (const BodyId id : {contact.first, contact.second})
      touches[static_cast<std::size_t>(world.index_of(id))] = 1;
  meter.add(world, touches);
}

double distance_to_axis(const World& world) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t k = 0; k < world.bodies().size(); ++k) {
    if (!world.bodies()[k].movable()) continue;
    const Vec3& p = world.states()[k].position_w;
    sum += std::sqrt(p.x() * p.x() + p.z() * p.z());
    count += 1.0;
  }
  return sum / count;
}

Result measure_clump_settles(const Parameters& settings) {
  const double duration = settings.number("duration");
  PlayedScene played(scene_with("fig6_7", {"per_edge=" + std::to_string(settings.count("per_edge")),
                                           setting("speed", settings.number("speed"))}),
                     {"damped"});
  std::vector<std::vector<PictureBox>> frames = {picture_boxes(played.world())};
  const double from_axis = distance_to_axis(played.world());
  ChatterMeter meter;
  std::vector<FilmFrame> film = {{0.0, frames.front()}};
  played.advance(duration, [&](const StepReport&) {
    const double time = played.world().time();
    if (time > duration - 0.6) watch(played, meter);
    const double next = film.back().time + 1.0 / kFilmRate - 0.5 * kStep;
    if (time > next && time < kFilmEnds) film.push_back({time, picture_boxes(played.world())});
  });
  frames.push_back(picture_boxes(played.world()));

  constexpr std::uint32_t moving = 0x8a8a8a;  // does not rest, so chatter does not apply
  double worst = 0.0;                         // [mm]
  double travelling = 0.0;
  std::size_t drawn = 0;
  const std::vector<BodyChatter> resting = meter.each(played.world().gravity_w.norm());
  auto next = resting.begin();  // both are in the order of ids
  for (std::size_t k = 0; k < played.world().bodies().size(); ++k) {
    if (!played.world().bodies()[k].movable()) continue;
    const bool rests = next != resting.end() && next->id == played.world().ids()[k];
    const double amplitude = rests ? 1e3 * (next++)->amplitude : 0.0;
    frames[0][drawn].colour = 0xc9c9c4;
    frames[1][drawn++].colour = rests ? colour_of(amplitude) : moving;
    worst = std::max(worst, amplitude);
    if (!rests) travelling += 1.0;
  }

  Table bar{"bar",
            {{"chatter_mm", "mm", "an amplitude"}, {"colour", "-", "its colour as 0xRRGGBB"}}};
  constexpr int shades = 100;
  for (int k = 0; k <= shades; ++k) {
    const double amplitude = kQuietest * elementary::pow(kLoudest / kQuietest, 1.0 * k / shades);
    bar.add(amplitude, colour_of(amplitude));
  }
  std::vector<Drawing> drawings;
  const Vec3 direction_w(0.55, 0.5, 1.0);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const Camera camera = camera_for(frames[k], direction_w, 600.0, k == 0 ? 380.0 : 340.0, true);
    drawings.push_back({k == 0 ? "start" : "settled", to_gnuplot(draw_boxes(frames[k], camera))});
  }
  return {{bar},
          {{"cubes", "-", drawn},
           {"cubes that do not rest", "-", travelling},
           {"largest chatter of those that rest", "mm", worst},
           {"mean distance from the axis at the start", "m", from_axis},
           {"mean distance from the axis in the end", "m", distance_to_axis(played.world())}},
          drawings,
          [film, direction_w] {
            return to_gif(film_of(film, direction_w, 480, 320, true), kFilmRate);
          }};
}

const Registered fig6_7_clump_figure{
    {.name = "fig6_7_clump",
     .parameters =
         Parameters{}
             .add_whole("per_edge", 5, 2, 8, "cubes along each edge of the grid at the start")
             .add_number("speed", 2.0, 0.0, 10.0, "m/s", "of each cube at the start")
             .add_number("duration", 10.0, 1.0, 100.0, "s", "until they have settled"),
     .quick = {"per_edge=2", "duration=4"},
     .experiment = measure_clump_settles}};

}  // namespace
}  // namespace tumble::chapters
