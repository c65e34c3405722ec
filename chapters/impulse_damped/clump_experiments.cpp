/// \file
/// \brief Cubes that fly together and settle, coloured by how much each one still shakes (6.1).
#include "tumble/pictures/film.hpp"

#include "impulse_damped/chatter_colours.hpp"

namespace tumble::chapters {
namespace {

constexpr double kFilmRate = 20.0;  // [1/s]
constexpr double kFilmEnds = 3.01;  // [s]

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
  PlayedScene played(make_scene("fig6_7", {"per_edge=" + std::to_string(settings.count("per_edge")),
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
  const ChatterPicture settled = coloured_by_chatter(played.world(), meter);
  for (PictureBox& box : frames.front()) box.colour = 0xc9c9c4;
  frames.push_back(settled.boxes);
  std::vector<Drawing> drawings;
  const Vec3 direction_w(1.0, 0.3, 0.25);  // the lowest cubes are seen to stand on the ground
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const Camera camera = camera_for(frames[k], direction_w, 600.0, k == 0 ? 380.0 : 340.0, true);
    drawings.push_back({k == 0 ? "start" : "settled", to_gnuplot(draw_boxes(frames[k], camera))});
  }
  return {{chatter_colour_bar()},
          {{"cubes", "-", settled.boxes.size()},
           {"cubes that do not rest", "-", settled.travelling},
           {"largest chatter of those that rest", "mm", settled.worst},
           {"mean distance from the axis at the start", "m", from_axis},
           {"mean distance from the axis in the end", "m", distance_to_axis(played.world())}},
          drawings,
          [film, direction_w] {
            return to_gif(film_of(film, direction_w, 480, 320, true), kFilmRate);
          }};
}

const Registered fig6_7_clump_figure{
    {.name = "fig6_7_clump",
     .parameters = {whole("per_edge", 5, 2, 8, "cubes along each edge of the grid at the start"),
                    number("speed", 2.0, 0.0, 10.0, "m/s", "of each cube at the start"),
                    number("duration", 10.0, 1.0, 100.0, "s", "until they have settled")},
     .quick = {"per_edge=2", "duration=4"},
     .experiment = measure_clump_settles}};

}  // namespace
}  // namespace tumble::chapters
