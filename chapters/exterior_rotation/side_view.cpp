/// \file
/// \brief Bodies seen from the side, and a place of them magnified, as commands of gnuplot.
#include "exterior_rotation/side_view.hpp"

#include <cstdio>

namespace tumble::chapters {
namespace {

// Micrometres are too fine to be seen, magnified or not.
std::string point_text(const Vec2& point) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "first %.6f,%.6f", point.x(), point.y());
  return buffer.data();
}

std::string number_text(double number) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.6g", number);
  return buffer.data();
}

std::string colour_text(std::uint32_t colour) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "rgb '#%06x'", static_cast<unsigned>(colour));
  return buffer.data();
}

std::string look_text(const LineLook& look) {
  std::string text = " lw " + number_text(look.width);
  return text.append(look.dashed ? " dt (6,4)" : " dt 1");
}

std::string corners_text(const Polygon& corners) {
  std::string text;
  for (const Vec2& corner : corners)
    text.append(text.empty() ? " from " : " to ").append(point_text(corner));
  return text.append(" to ").append(point_text(corners.front()));
}

Vec2 flat(const Vec3& point_w) { return Vec2(point_w.x(), point_w.y()); }

// Bodies as they are: those that cannot move grey.
void fill_bodies(const World& world, std::span<const BodyState> states, SideView& view) {
  for (std::size_t b = 0; b < world.bodies().size(); ++b) {
    const BodyProperties& body = world.bodies()[b];
    if (body.shape != Shape::box) continue;
    const Polygon side = side_of(body, states[b]);
    view.fill(side, body.movable() ? film_colour::body : film_colour::supporter);
    view.outline(side, {body.movable() ? film_colour::edge : film_colour::supporter_edge, 1.2});
  }
}

}  // namespace

Polygon SideView::inside(const Polygon& corners) const {
  return clipped(corners, {low_, Vec2(high_.x(), low_.y()), high_, Vec2(low_.x(), high_.y())});
}

void SideView::fill(const Polygon& corners, std::uint32_t colour, double opacity) {
  const Polygon seen =
      inside(corners);  // gnuplot's own clipping loses corners that are far outside
  if (seen.size() < 3) return;
  objects_ += "set object polygon" + corners_text(seen) + " fc " + colour_text(colour) +
              (opacity < 1.0 ? " fs transparent solid " : " fs solid ") + number_text(opacity) +
              " noborder\n";
}

void SideView::outline(const Polygon& corners, const LineLook& look) {
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Polygon seen = inside({corners[k], corners[(k + 1) % corners.size()]});
    if (seen.size() < 2) continue;
    if (look.dashed) {  // a polygon of two corners goes there and back, which fills the gaps
      line(seen[0], seen[1], look);
      continue;
    }
    objects_ += "set object polygon" + corners_text(seen) + " fs empty border lc " +
                colour_text(look.colour) + look_text(look) + '\n';
  }
}

void SideView::circle(const Vec2& centre, double radius, const LineLook& look) {
  // A curve and no object: circles that reach out of the view are lost in SVG.
  const auto along = [&](double from, const char* function) {
    return number_text(from) + '+' + number_text(radius) + '*' + function + "(t)";
  };
  circles_ += (circles_.empty() ? "" : ", ") + along(centre.x(), "cos") + ',' +
              along(centre.y(), "sin") + " with lines lc " + colour_text(look.colour) +
              look_text(look);
}

void SideView::dot(const Vec2& centre, double radius, std::uint32_t colour) {
  objects_ += "set object circle at " + point_text(centre) + " size first " + number_text(radius) +
              " fc " + colour_text(colour) + " fs solid 1.0 noborder\n";
}

void SideView::line(const Vec2& from, const Vec2& to, const LineLook& look) {
  objects_ += "set arrow from " + point_text(from) + " to " + point_text(to) + " nohead front lc " +
              colour_text(look.colour) + look_text(look) + '\n';
}

void SideView::frame(const LineLook& look) {
  objects_ += "set object rectangle from graph 0,0 to graph 1,1 noclip fs empty border lc " +
              colour_text(look.colour) + look_text(look) + '\n';
}

void SideView::write(std::string_view text, const Vec2& where) {
  objects_.append("set label '").append(text).append("' at ").append(point_text(where));
  objects_ += " center front textcolor rgb '#202020'\n";
}

std::string SideView::commands() const {
  const auto range = [](double low, double high) {
    return '[' + number_text(low) + ':' + number_text(high) + "]";
  };
  std::string out = "unset key; unset border; unset tics\n";
  out += "set xrange " + range(low_.x(), high_.x());
  out += "; set yrange " + range(low_.y(), high_.y()) + '\n';
  out += objects_;
  if (circles_.empty())
    out += "plot NaN\n";
  else
    out += "set parametric; set trange [0:2*pi]; set samples 361\nplot " + circles_ +
           "\nunset parametric\n";
  return out + "unset object; unset arrow; unset label\n";
}

Polygon side_of(const BodyProperties& body, const BodyState& state) {
  const Vec3 along_w = state.orientation_wb * Vec3(0.5 * body.size.x(), 0.0, 0.0);
  const Vec3 up_w = state.orientation_wb * Vec3(0.0, 0.5 * body.size.y(), 0.0);
  const Vec3& centre_w = state.position_w;
  return {flat(centre_w - along_w - up_w), flat(centre_w + along_w - up_w),
          flat(centre_w + along_w + up_w), flat(centre_w - along_w + up_w)};
}

Drawing FilmLayout::drawing() const {
  const Vec2 from_corner = scale() * (inset_low - low);
  std::string text;
  const auto say = [&](std::string_view name, double points) {
    text.append(name).append(" = ").append(number_text(points)).append("\n");
  };
  say("frame_wide", width);
  say("frame_tall", scale() * (high.y() - low.y()));
  say("inset_left", from_corner.x());
  say("inset_foot", from_corner.y());
  say("inset_edge", inset);
  say("magnification", magnification);
  return {"layout", text};
}

void FilmLayout::put_inset_above() {
  const double edge = inset / scale();
  const double margin = 2.0 / scale();
  inset_low = Vec2(low.x() + margin, high.y() - edge - margin);
}

namespace {

SideView film_view(const World& world, const FilmLayout& layout, const SideViewFrame& frame) {
  SideView view(layout.low, layout.high);
  const double point = 1.0 / layout.scale();  // [m]
  fill_bodies(world, frame.states, view);
  for (std::size_t b = 0; b < frame.exact.size(); ++b)
    if (world.bodies()[b].movable())
      view.outline(side_of(world.bodies()[b], frame.exact[b]), {film_colour::dark, 1.0, true});
  for (std::size_t b = 0; b < frame.states.size(); ++b)
    if (world.bodies()[b].movable())
      view.dot(flat(frame.states[b].position_w), 2.0 * point, film_colour::dark);
  for (const Vec2& pivot : frame.pivots) view.dot(pivot, 4.0 * point, film_colour::pivot);
  // A ring around what is magnified.
  view.circle(frame.magnified, 6.0 * point, {film_colour::dark, 1.2});
  for (const FilmCircle& circle : frame.circles)
    view.circle(circle.centre, circle.radius, circle.look);
  return view;
}

SideView film_inset(const World& world, const FilmLayout& layout, const SideViewFrame& frame) {
  const double half = 0.5 * layout.seen();
  const Vec2 low = frame.magnified - Vec2(half, half);
  const Vec2 high = frame.magnified + Vec2(half, half);
  SideView view(low, high);
  const Polygon all = {low, Vec2(high.x(), low.y()), high, Vec2(low.x(), high.y())};
  view.fill(all, 0xffffff, 1.0);
  fill_bodies(world, frame.states, view);
  const double point = 2.0 * half / layout.inset;  // [m]
  const Vec2 foot(frame.magnified.x(), low.y() + 6.0 * point);
  const double strip = low.y() + 30.0 * point;  // white, so that the scale can be read
  view.fill({low, Vec2(high.x(), low.y()), Vec2(high.x(), strip), Vec2(low.x(), strip)}, 0xffffff,
            0.85);
  const Vec2 reach(0.5 * layout.bar, 0.0);
  view.line(foot - reach, foot + reach, {film_colour::dark, 3.0});
  view.write(number_text(1e3 * layout.bar) + " mm", foot + Vec2(0.0, 13.0 * point));
  view.frame({film_colour::dark, 1.4});
  return view;
}

}  // namespace

Parameters film_parameters(Parameters first, double duration,
                           const std::array<double, kFilmFrames>& times) {
  first.add(number("rate", 60.0, 10.0, 1e4, "1/s", "steps a second"))
      .add(number("duration", duration, 0.1, 1.2, "s", "of the motion"))
      .add(number("magnification", 50.0, 2.0, 1e3, "-", "of the insets over the frames"));
  for (std::size_t k = 0; k < times.size(); ++k)
    first.add(number(std::string("t").append(std::to_string(k + 1)), times[k], 0.0, 1.2, "s",
                     "of a frame"));
  return first;
}

double film_time(const Parameters& settings, int number) {
  return settings.number(std::string("t").append(std::to_string(number)));
}

void add_film_frame(const World& world, const FilmLayout& layout, const SideViewFrame& frame,
                    int number, Result& result) {
  result.drawings.push_back(
      {"frame" + std::to_string(number), film_view(world, layout, frame).commands()});
  result.drawings.push_back(
      {"inset" + std::to_string(number), film_inset(world, layout, frame).commands()});
}

}  // namespace tumble::chapters
