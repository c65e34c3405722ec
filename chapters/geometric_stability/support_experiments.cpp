/// \file
/// \brief Figures 5.3 to 5.5: corners, hull and verdicts, all from the contacts of the scenes.
#include "geometric_stability/support_experiments.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/geometric_stability/support_polygon.hpp"
#include "tumble/geometric_stability/tolerances.hpp"
#include "tumble/pictures/world_picture.hpp"
#include "tumble/scenes/library.hpp"

#include "geometric_stability/support_instant.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tumble::chapters {
namespace {

// Rows of the table of outlines.
constexpr double kTop = 0.0;
constexpr double kHull = 9.0;

constexpr std::array<std::uint32_t, 3> kColours = {0xe69f00, 0x0072b2, 0x009e73};

// A scene with those of a figure's settings that are its own.
SupportInstant instant_of(std::string_view name, const Parameters& settings,
                          std::initializer_list<const char*> keys) {
  Parameters p = scene_recipe(name).parameters();
  for (const char* key : keys) p.set(key, shortest_text(settings.number(key)));
  return SupportInstant(build_world(scene_recipe(name).build(p, Random(1))));
}

int index_of(const World& world, std::string_view name) {
  for (int k = 0; k < world.count(); ++k)
    if (world.name(k) == name) return k;
  return -1;
}

Box box_at(const World& world, int body) {
  return box_of(world.bodies()[at(body)], world.states()[at(body)]);
}

double area_of(std::span<const Vec2> loop) {
  double twice = 0.0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec2& a = loop[k];
    const Vec2& b = loop[(k + 1) % loop.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * std::abs(twice);
}

// Adds a closed line.
void add_loop(double outline, std::span<const Vec2> loop, Table& table) {
  for (std::size_t k = 0; k <= loop.size() && !loop.empty(); ++k) {
    const Vec2& p = loop[k % loop.size()];
    table.rows.push_back({outline, p.x(), p.y()});
  }
}

// The plane of contact under the top box.
struct ContactPlane {
  std::array<Vec2, 4> corners;    // [m] of the top box
  std::array<bool, 4> carried{};  // by a stable body
  std::vector<Vec2> points;       // [m] contact points
  std::vector<Vec2> hull;         // of these
  std::vector<int> below;         // whom it touches there
};

ContactPlane plane_under(const SupportInstant& instant, int top) {
  ContactPlane plane;
  plane.corners = lower_corners(box_at(instant.world(), top));
  const double near = tolerance::exact_corner * instant.world().bodies()[at(top)].size.minCoeff();
  const std::vector<char> stable = instant.ask(StableRule::corners, top).all;
  for (const Contact& contact : instant.contacts()) {
    if (upper_body(contact) != top) continue;
    plane.below.push_back(lower_body(contact));
    for (std::size_t p = 0; p < at(contact.count); ++p) {
      const Vec3& position_w = contact.points[p].position_w;
      plane.points.emplace_back(position_w.x(), position_w.z());
      for (std::size_t k = 0; k < 4; ++k)
        if ((plane.corners[k] - plane.points.back()).norm() <= near &&
            stable[at(lower_body(contact))] != 0)
          plane.carried[k] = true;
    }
  }
  std::vector<Vec2> sorted = plane.points;
  convex_hull(sorted, plane.hull);
  return plane;
}

std::vector<Table> tables_of(const SupportInstant& instant, const ContactPlane& plane) {
  const Column x{"x_m", "m", "to the right"};
  const Column z{"z_m", "m", "towards the viewer"};
  Table corners{"", {x, z, {"carried", "-", "1 if a stable body is under this lower corner"}}};
  for (std::size_t k = 0; k < 4; ++k)
    corners.rows.push_back(
        {plane.corners[k].x(), plane.corners[k].y(), plane.carried[k] ? 1.0 : 0.0});
  Table points{"points", {x, z}};
  for (const Vec2& p : plane.points) points.rows.push_back({p.x(), p.y()});
  Table outlines{
      "outlines",
      {{"outline", "-", "0: the top box; 1, 2: boxes below; 9: hull of the contact points"}, x, z}};
  add_loop(kTop, plane.corners, outlines);
  for (std::size_t k = 0; k < plane.below.size(); ++k)
    add_loop(static_cast<double>(k + 1), lower_corners(box_at(instant.world(), plane.below[k])),
             outlines);
  add_loop(kHull, plane.hull, outlines);
  return {corners, points, outlines};
}

// The boxes with the colours that the plane has: the top one first.
Drawing drawing_of(const SupportInstant& instant, int top) {
  std::vector<PictureBox> boxes = picture_boxes(instant.world());
  std::size_t below = 0;
  std::size_t k = 0;
  for (int body = 0; body < instant.world().count(); ++body) {
    if (instant.world().bodies()[at(body)].shape == Shape::ground) continue;
    boxes[k++].colour = kColours[body == top ? 0 : ++below];
  }
  const Camera camera = camera_for(boxes, Vec3(-0.5, 0.55, 1.0), 300.0, 270.0, true);
  return {"boxes", to_gnuplot(draw_boxes(boxes, camera))};
}

// What is said under the picture, for gnuplot.
std::string words(const char* name, const RuleAnswer& answer) {
  return std::string(name) + "_stable = " + (answer.stable ? "1" : "0") + "\n" + name + " = \"" +
         answer.told + "\"\n";
}

// [m/s²] What a load and its own weight together would give to the mass of a body.
double loaded_g(const SupportInstant& instant, int body, double load) {
  return instant.world().gravity_w.norm() + load / instant.world().bodies()[at(body)].mass;
}

double yes(bool answer) { return answer ? 1.0 : 0.0; }

// What the three figures have in common.
Result measure(const SupportInstant& instant, const Parameters& settings) {
  const int top = index_of(instant.world(), "top");
  const double g = instant.world().gravity_w.norm();
  const double load = settings.number("load") * instant.world().bodies()[at(top)].mass * g;
  const ContactPlane plane = plane_under(instant, top);
  const RuleAnswer corners = instant.ask(StableRule::corners, top);
  const RuleAnswer hull = instant.ask(StableRule::hull, top);
  const auto below = std::count_if(plane.below.begin(), plane.below.end(),
                                   [&](int body) { return corners.all[at(body)] != 0; });
  Result result;
  result.tables = tables_of(instant, plane);
  result.quantities = {
      {"boxes below that are stable", "-", static_cast<double>(below)},
      {"lower corners of the top box that they carry", "-",
       static_cast<double>(std::count(plane.carried.begin(), plane.carried.end(), true))},
      {"area of the hull of its contact points over that of its outline", "-",
       area_of(plane.hull) / area_of(plane.corners)},
      {"stable by the four corners", "-", yes(corners.stable)},
      {"stable by the hull", "-", yes(hull.stable)},
      {"carries every load by static equilibrium", "-", yes(instant.load_proof(top))},
      {"largest acceleration of its corners under its own weight, over g", "-",
       instant.acceleration(top) / g},
      {"the same under the worst load on a corner of its top, over (load + weight)/mass", "-",
       instant.worst_acceleration(top, load) / loaded_g(instant, top, load)}};
  result.drawings = {drawing_of(instant, top),
                     {"told", words("corners", corners) + words("hull", hull)}};
  return result;
}

// The other half of "if what is below is stable": it is not, since nothing carries it.
void add_without_support(SupportInstant instant, const char* lower, Result& result) {
  const int top = index_of(instant.world(), "top");
  instant.take_support(index_of(instant.world(), lower));
  const RuleAnswer corners = instant.ask(StableRule::corners, top);
  const RuleAnswer hull = instant.ask(StableRule::hull, top);
  const std::string given = std::string(" with nothing under the ") + lower + " box";
  result.quantities.push_back({"stable by the four corners," + given, "-", yes(corners.stable)});
  result.quantities.push_back({"stable by the hull," + given, "-", yes(hull.stable)});
  result.quantities.push_back(
      {"largest acceleration of its corners under its own weight," + given + ", over g", "-",
       instant.acceleration(top) / instant.world().gravity_w.norm()});
  result.drawings.back().commands += words("without", corners);
}

// [m] The shift from which the own weight of the top cube tips it.
double tipping_shift(Parameters settings) {
  double low = 0.0;
  double high = 0.8;
  while (high - low > 1e-9) {
    const double shift = 0.5 * (low + high);
    settings.set("shift", shortest_text(shift));
    const SupportInstant instant = instant_of("fig5_3", settings, {"shift", "yaw"});
    const bool tips = instant.acceleration(index_of(instant.world(), "top")) > 1e-9;
    (tips ? high : low) = shift;
  }
  return 0.5 * (low + high);
}

}  // namespace

Result measure_one_corner(const Parameters& settings) {
  Result result = measure(instant_of("fig5_3", settings, {"shift", "yaw"}), settings);
  Table shifts{
      "shifts",
      {{"shift_m", "m", "of the top cube, along x and along -z"},
       {"own", "-", "acceleration of its worst corner under its own weight, over g"},
       {"loaded", "-", "the same under the worst load on its top, over (load + weight)/mass"},
       {"stable", "-", "1 if it is stable by the four corners"}}};
  Parameters shifted = settings;
  const int count = settings.count("shifts");
  for (int k = 0; k < count; ++k) {
    shifted.set("shift", shortest_text(0.8 * k / (count - 1)));
    const SupportInstant instant = instant_of("fig5_3", shifted, {"shift", "yaw"});
    const int top = index_of(instant.world(), "top");
    const double g = instant.world().gravity_w.norm();
    const double load = settings.number("load") * instant.world().bodies()[at(top)].mass * g;
    shifts.rows.push_back({shifted.number("shift"), instant.acceleration(top) / g,
                           instant.worst_acceleration(top, load) / loaded_g(instant, top, load),
                           yes(instant.ask(StableRule::corners, top).stable)});
  }
  result.tables.push_back(shifts);
  result.drawings.back().commands += "shown = " + shortest_text(settings.number("shift")) + "\n";
  result.quantities.push_back(
      {"shift from which its own weight tips it", "m", tipping_shift(settings)});
  return result;
}

Result measure_all_corners(const Parameters& settings) {
  const SupportInstant instant = instant_of("fig5_4", settings, {"offset"});
  Result result = measure(instant, settings);
  add_without_support(instant, "bottom", result);
  return result;
}

Result measure_two_supports(const Parameters& settings) {
  const SupportInstant instant = instant_of("fig5_5", settings, {"gap", "yaw"});
  Result result = measure(instant, settings);
  add_without_support(instant, "left", result);
  return result;
}

}  // namespace tumble::chapters
