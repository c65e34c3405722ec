/// \file
/// \brief Figures 5.3 to 5.5: corners, hull and verdicts, all from the contacts of the scenes.
#include "tumble/base/number_text.hpp"
#include "tumble/geometric_stability/support_polygon.hpp"
#include "tumble/geometric_stability/tolerances.hpp"
#include "tumble/pictures/world_picture.hpp"

#include "geometric_stability/pile_builder.hpp"
#include "geometric_stability/pile_forces.hpp"
#include "geometric_stability/pile_levels.hpp"
#include "geometric_stability/resting_pile.hpp"

#include <initializer_list>

namespace tumble::chapters {
namespace {

constexpr std::array<std::uint32_t, 3> kColours = {0xe69f00, 0x0072b2, 0x009e73};

// A scene with those of a figure's settings that are its own.
RestingPile pile_with(std::string_view name, const Parameters& settings,
                      std::initializer_list<const char*> keys) {
  std::vector<std::string> own;
  for (const char* key : keys) own.push_back(setting(key, settings.number(key)));
  return pile_of(build_world(make_scene(name, own)));
}

int index_of(const World& world, std::string_view name) {
  return world.index_of(world.find(name).value());
}

Box box_at(const World& world, int body) {
  return box_of(world.bodies()[idx(body)], world.states()[idx(body)]);
}

// [m/s²] The largest acceleration of a corner of a body under the forces of the whole complementarity problem,
// without friction and with no body left out, with a weight [N] on a point of the body.
double acceleration(const RestingPile& pile, int body, double load = 0.0,
                    const Vec3& at_w = Vec3::Zero()) {
  std::vector<Wrench> loads(pile.bodies.size());
  loads[idx(body)] = weight_at(pile.world.states()[idx(body)], at_w, load);
  PileForces forces;
  if (!forces.solve(pile.world, pile.contacts, loads))
    throw std::runtime_error("the contact forces were not found");
  return largest_of(corners_of(box_at(pile.world, body)), [&](const Vec3& corner_w) {
    return acceleration_at(pile.bodies[idx(body)], forces.accelerations()[idx(body)], corner_w)
        .norm();
  });
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

// Adds a closed line. It begins and ends in the middle of an edge, where the ends of a thick line are not seen.
void add_loop(std::size_t outline, std::span<const Vec2> loop, Table& table) {
  if (loop.empty()) return;
  const Vec2 middle = 0.5 * (loop.back() + loop.front());
  table.add(outline, middle.x(), middle.y());
  for (const Vec2& p : loop) table.add(outline, p.x(), p.y());
  table.add(outline, middle.x(), middle.y());
}

// The plane of contact under the top box.
struct ContactPlane {
  std::array<Vec2, 4> corners;    // [m] of the top box
  std::array<bool, 4> carried{};  // by a stable body
  std::vector<Vec2> points;       // [m] contact points
  std::vector<Vec2> hull;         // of these
  std::vector<int> below;         // the bodies that it touches there
};

ContactPlane plane_under(const RestingPile& pile, int top) {
  ContactPlane plane;
  plane.corners = lower_corners(box_at(pile.world, top));
  const double near = tolerance::exact_corner * pile.world.bodies()[idx(top)].size.minCoeff();
  const std::vector<char> stable =
      verdict_of(StableRule::corners, pile.world, pile.contacts, top).all;
  for (const Contact& contact : pile.contacts) {
    if (upper_body(contact) != top) continue;
    plane.below.push_back(lower_body(contact));
    for (std::size_t p = 0; p < idx(contact.count); ++p) {
      const Vec3& position_w = contact.points[p].position_w;
      plane.points.emplace_back(position_w.x(), position_w.z());
      for (std::size_t k = 0; k < 4; ++k)
        if ((plane.corners[k] - plane.points.back()).norm() <= near &&
            stable[idx(lower_body(contact))] != 0)
          plane.carried[k] = true;
    }
  }
  std::vector<Vec2> sorted = plane.points;
  convex_hull(sorted, plane.hull);
  return plane;
}

std::vector<Table> tables_of(const RestingPile& pile, const ContactPlane& plane) {
  const Column x{"x_m", "m", "to the right"};
  const Column z{"z_m", "m", "towards the viewer"};
  Table corners{"", {x, z, {"carried", "-", "1 if a stable body is under this lower corner"}}};
  for (std::size_t k = 0; k < 4; ++k)
    corners.add(plane.corners[k].x(), plane.corners[k].y(), plane.carried[k]);
  Table points{"points", {x, z}};
  for (const Vec2& p : plane.points) points.add(p.x(), p.y());
  Table outlines{
      "outlines",
      {{"outline", "-", "0: the top box; 1, 2: boxes below; 9: hull of the contact points"}, x, z}};
  add_loop(0, plane.corners, outlines);
  for (std::size_t k = 0; k < plane.below.size(); ++k)
    add_loop(k + 1, lower_corners(box_at(pile.world, plane.below[k])), outlines);
  add_loop(9, plane.hull, outlines);
  return {corners, points, outlines};
}

// The boxes with the colours that the plane has: the top one first.
Drawing drawing_of(const RestingPile& pile, int top) {
  std::vector<PictureBox> boxes = picture_boxes(pile.world);
  std::size_t below = 0;
  std::size_t k = 0;
  for (int body = 0; body < pile.world.count(); ++body) {
    if (pile.world.bodies()[idx(body)].shape == Shape::ground) continue;
    boxes[k++].colour = kColours[body == top ? 0 : ++below];
  }
  const Camera camera = camera_for(boxes, Vec3(-0.5, 0.55, 1.0), 300.0, 270.0, true);
  return {"boxes", to_gnuplot(draw_boxes(boxes, camera))};
}

// The verdict under the picture, for gnuplot.
std::string words(const char* name, const RuleVerdict& answer) {
  return std::string(name) + "_stable = " + (answer.stable ? "1" : "0") + "\n" + name + " = \"" +
         answer.reason + "\"\n";
}

// Accelerations of the worst corner of the top box: under its own weight, over g; and under the worst load
// on a corner of its top, over the acceleration of its mass by load and weight together.
std::array<double, 2> accelerations_of(const RestingPile& pile, const Parameters& settings) {
  const int top = index_of(pile.world, "top");
  const double g = pile.world.gravity_w.norm();
  const double mass = pile.world.bodies()[idx(top)].mass;
  const double load = settings.number("load") * mass * g;
  double worst = 0.0;  // [m/s²]
  for (const Vec3& corner_w : corners_of(box_at(pile.world, top)))
    if (corner_w.y() > pile.world.states()[idx(top)].position_w.y())
      worst = std::max(worst, acceleration(pile, top, load, corner_w));
  return {acceleration(pile, top) / g, worst / (g + load / mass)};
}

// The part that the three figures have in common.
Result measure(const RestingPile& pile, const Parameters& settings) {
  const int top = index_of(pile.world, "top");
  const ContactPlane plane = plane_under(pile, top);
  const RuleVerdict corners = verdict_of(StableRule::corners, pile.world, pile.contacts, top);
  const RuleVerdict hull = verdict_of(StableRule::hull, pile.world, pile.contacts, top);
  const auto [by_weight, by_load] = accelerations_of(pile, settings);
  const auto below =
      std::ranges::count_if(plane.below, [&](int body) { return corners.all[idx(body)] != 0; });
  Result result{.tables = tables_of(pile, plane)};
  result.quantities = {
      {"boxes below that are stable", "-", below},
      {"lower corners of the top box that they carry", "-",
       std::ranges::count(plane.carried, true)},
      {"area of the hull of its contact points over that of its outline", "-",
       area_of(plane.hull) / area_of(plane.corners)},
      {"stable by the four corners", "-", corners.stable},
      {"stable by the hull", "-", hull.stable},
      {"carries every load by static equilibrium", "-",
       called_stable(StabilityLevel::load_proof, pile.world, pile.contacts)[idx(top)] != 0},
      {"largest acceleration of its corners under its own weight, over g", "-", by_weight},
      {"the same under the worst load on a corner of its top, over (load + weight)/mass", "-",
       by_load}};
  result.drawings = {drawing_of(pile, top),
                     {"marked", words("corners", corners) + words("hull", hull)}};
  return result;
}

// The other half of "if what is below is stable": it is not, since nothing carries it.
void add_without_support(RestingPile pile, const char* lower, Result& result) {
  const int top = index_of(pile.world, "top");
  std::erase_if(pile.contacts, [below = index_of(pile.world, lower)](const Contact& contact) {
    return upper_body(contact) == below;
  });
  const RuleVerdict corners = verdict_of(StableRule::corners, pile.world, pile.contacts, top);
  const RuleVerdict hull = verdict_of(StableRule::hull, pile.world, pile.contacts, top);
  const std::string given = std::string(" with nothing under the ") + lower + " box";
  result.add("stable by the four corners," + given, "-", corners.stable);
  result.add("stable by the hull," + given, "-", hull.stable);
  result.add("largest acceleration of its corners under its own weight," + given + ", over g", "-",
             acceleration(pile, top) / pile.world.gravity_w.norm());
  result.drawings.back().commands += words("without", corners);
}

// [m] The shift from which the own weight of the top cube tips it.
double tipping_shift(Parameters settings) {
  double low = 0.0;
  double high = 0.8;
  while (high - low > 1e-9) {
    const double shift = 0.5 * (low + high);
    settings.set("shift", shortest_text(shift));
    const RestingPile pile = pile_with("fig5_3", settings, {"shift", "yaw"});
    const bool tips = acceleration(pile, index_of(pile.world, "top")) > 1e-9;
    (tips ? high : low) = shift;
  }
  return 0.5 * (low + high);
}

Result measure_one_corner(const Parameters& settings) {
  Result result = measure(pile_with("fig5_3", settings, {"shift", "yaw"}), settings);
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
    const RestingPile pile = pile_with("fig5_3", shifted, {"shift", "yaw"});
    shifts.add(
        shifted.number("shift"), accelerations_of(pile, settings),
        verdict_of(StableRule::corners, pile.world, pile.contacts, index_of(pile.world, "top"))
            .stable);
  }
  result.tables.push_back(shifts);
  result.drawings.back().commands += "shown = " + shortest_text(settings.number("shift")) + "\n";
  result.add("shift from which its own weight tips it", "m", tipping_shift(settings));
  return result;
}

Parameters with_load(Parameters first) {
  return first.add(number("load", 10.0, 0.0, 1e6, "-",
                          "on a corner of the top, over the weight of the top box"));
}

const Registered fig5_3_one_corner_figure{
    {.name = "fig5_3_one_corner",
     .parameters = with_load(Parameters{number("shift", 0.6, 0.0, 0.8, "m",
                                               "of the top cube, along x and along -z"),
                                        number("yaw", 20.0, -45.0, 45.0, "deg",
                                               "of the top cube about the vertical")})
                       .add(whole("shifts", 81, 2, 1000, "points of the curves")),
     .quick = {"shifts=9"},
     .experiment = measure_one_corner}};

Result measure_all_corners(const Parameters& settings) {
  const RestingPile pile = pile_with("fig5_4", settings, {"offset"});
  Result result = measure(pile, settings);
  add_without_support(pile, "bottom", result);
  return result;
}

const Registered fig5_4_all_corners_figure{
    {.name = "fig5_4_all_corners",
     .parameters = with_load(Parameters{
         number("offset", 0.2, -0.5, 0.5, "m", "of the top cube from the middle, along x")}),
     .experiment = measure_all_corners}};

Result measure_two_supports(const Parameters& settings) {
  const RestingPile pile = pile_with("fig5_5", settings, {"gap", "yaw"});
  Result result = measure(pile, settings);
  add_without_support(pile, "left", result);
  return result;
}

const Registered fig5_5_two_supports_figure{
    {.name = "fig5_5_two_supports",
     .parameters = with_load(
         Parameters{number("gap", 0.4, 0.0, 0.8, "m", "between the two boxes below"),
                    number("yaw", 15.0, -30.0, 30.0, "deg", "of the top box about the vertical")}),
     .experiment = measure_two_supports}};

}  // namespace
}  // namespace tumble::chapters
