/// \file
/// \brief Trials seen from above.
#include "tumble/geometric_stability/support_polygon.hpp"
#include "tumble/geometric_stability/tolerances.hpp"

#include "geometric_stability/disputes.hpp"

#include <iomanip>
#include <locale>
#include <sstream>

namespace tumble::chapters {
namespace {

// The square that is shown.
struct View {
  Vec2 middle = Vec2::Zero();  // [m]
  double half = 1.0;           // [m] half its edge
};

// Objects of gnuplot in a view.
class Plan {
 public:
  explicit Plan(const View& view) : view_(view) {
    text_.imbue(std::locale::classic());
    text_ << std::fixed << std::setprecision(5) << "unset object\nunset arrow\nset xrange ["
          << -view.half << ':' << view.half << "]\nset yrange [" << -view.half << ':' << view.half
          << "]\n";
  }
  void fill(std::span<const Vec2> corners, const std::string& colour) {
    if (corners.empty()) return;
    text_ << "set object " << ++objects_ << " polygon";
    for (std::size_t k = 0; k <= corners.size(); ++k) {
      text_ << (k == 0 ? " from " : " to ");
      write(corners[k % corners.size()]);
    }
    text_ << " fillcolor rgb '" << colour << "' fillstyle solid noborder back\n";
  }
  // Around a polygon, as far as it is in the view: gnuplot would draw along the edge of the view.
  void outline(std::span<const Vec2> corners, const std::string& style) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vec2 from = corners[k] - view_.middle;
      const Vec2 way = corners[(k + 1) % corners.size()] - corners[k];
      double first = 0.0;
      double last = 1.0;
      for (int axis = 0; axis < 2; ++axis)
        for (const double side : {-1.0, 1.0}) {
          const double inside = view_.half - side * from[axis];
          const double speed = side * way[axis];
          if (speed > 0.0) last = std::min(last, inside / speed);
          if (speed < 0.0) first = std::max(first, inside / speed);
          if (speed == 0.0 && inside < 0.0) last = -1.0;
        }
      if (first >= last) continue;
      text_ << "set arrow " << ++arrows_ << " from ";
      write(corners[k] + first * way);
      text_ << " to ";
      write(corners[k] + last * way);
      text_ << " nohead front " << style << '\n';
    }
  }
  void circle(const Vec2& point, double radius, const std::string& style) {
    text_ << "set object " << ++objects_ << " circle at ";
    write(point);
    text_ << " size " << radius << ' ' << style << '\n';
  }
  void dot(const Vec2& point, const std::string& colour) {
    circle(point, 0.04 * view_.half,
           "fillcolor rgb '" + colour + "' fillstyle solid noborder front");
  }
  [[nodiscard]] std::string commands() const { return text_.str(); }

 private:
  // To the right, and up the page.
  void write(const Vec2& point) {
    text_ << point.x() - view_.middle.x() << ',' << view_.middle.y() - point.y();
  }
  View view_;
  std::ostringstream text_;
  int objects_ = 0;
  int arrows_ = 0;
};

// The outline of a body from above.
std::vector<Vec2> outline_of(const Trial& trial, int body) {
  if (!trial.outlines.empty() && !trial.outlines[idx(body)].empty())
    return trial.outlines[idx(body)];
  std::vector<Vec2> points;
  std::vector<Vec2> hull;
  for (const Vec3& corner_w :
       corners_of(box_of(trial.world.bodies()[idx(body)], trial.world.states()[idx(body)])))
    points.emplace_back(corner_w.x(), corner_w.z());
  convex_hull(points, hull);
  return hull;
}

// The body that a contact has below the one that the trial is about; -1 if it has none.
int below_in(const Trial& trial, const Contact& contact) {
  return upper_body(contact) == trial.body ? lower_body(contact) : -1;
}

// Whether a body carries the one that the trial is about.
bool is_below(const Trial& trial, int body) {
  return std::ranges::any_of(
      trial.contacts, [&](const Contact& contact) { return below_in(trial, contact) == body; });
}

// Bodies that unstable supports touch, but for the trial's: their neighbours and their own supports.
std::vector<int> around_unstable(const Trial& trial) {
  std::vector<int> others;
  for (const Contact& contact : trial.contacts)
    for (const auto& [one, other] :
         {std::pair(contact.first, contact.second), std::pair(contact.second, contact.first)})
      if (is_below(trial, one) && trial.stable[idx(one)] == 0 && other != trial.body &&
          trial.world.bodies()[idx(other)].shape == Shape::box)
        others.push_back(other);
  return others;
}

Vec2 middle_of_trial(const Trial& trial) {
  const Vec3& middle_w = trial.world.states()[idx(trial.body)].position_w;
  return {middle_w.x(), middle_w.z()};
}

// Reach of a body from the middle of the trial's body, along x or z.
double reach_of(const Trial& trial, int body) {
  return largest_of(outline_of(trial, body), [&](const Vec2& corner) {
    return (corner - middle_of_trial(trial)).cwiseAbs().maxCoeff();
  });
}

// All that a view shows.
Plan drawn(const Trial& trial, const View& view) {
  Plan plan(view);
  std::vector<Vec2> held;
  std::vector<std::pair<Vec2, bool>> points;
  for (const Contact& contact : trial.contacts) {
    const int below = below_in(trial, contact);
    if (below < 0) continue;
    const bool firm = trial.stable[idx(below)] != 0;
    if (trial.world.bodies()[idx(below)].shape == Shape::box) {
      const std::vector<Vec2> top = outline_of(trial, below);
      plan.fill(top, firm ? "#cfe3f1" : "#f9d9bf");
      plan.outline(top, firm ? "lc rgb '#0072B2' lw 1.5" : "lc rgb '#D55E00' lw 1.5");
    }
    for (int p = 0; p < contact.count; ++p) {
      const Vec3& point_w = contact.points[idx(p)].position_w;
      points.emplace_back(Vec2(point_w.x(), point_w.z()), firm);
      if (firm) held.push_back(points.back().first);
    }
  }
  for (const int other : around_unstable(trial))
    plan.outline(outline_of(trial, other), "lc rgb '#606060' lw 1.5 dt (6,4)");
  std::vector<Vec2> hull;
  convex_hull(held, hull);
  plan.outline(hull, "lc rgb '#009E73' lw 4");
  plan.outline(outline_of(trial, trial.body), "lc rgb '#202020' lw 2");
  for (const auto& [xz, firm] : points) plan.dot(xz, firm ? "#0072B2" : "#D55E00");
  return plan;
}

}  // namespace

Drawing plan_of(const Trial& trial, const std::string& suffix) {
  double most = reach_of(trial, trial.body);
  const double body = most;
  for (const Contact& contact : trial.contacts)
    if (const int below = below_in(trial, contact);
        below >= 0 && trial.world.bodies()[idx(below)].shape == Shape::box)
      most = std::max(most, reach_of(trial, below));
  for (const int other : around_unstable(trial)) most = std::max(most, reach_of(trial, other));
  return {suffix,
          drawn(trial, {middle_of_trial(trial), std::min(1.05 * most, 1.8 * body)}).commands()};
}

Drawing enlarged_corner_of(const Trial& trial, const std::string& suffix) {
  const std::vector<Vec2> outline = outline_of(trial, trial.body);
  const Vec2 corner = *std::ranges::max_element(
      outline, [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
  const double near =
      tolerance::corner_support * trial.world.bodies()[idx(trial.body)].size.minCoeff();
  Plan plan = drawn(trial, {corner, 3.0 * near});
  plan.circle(corner, near, "fillstyle empty border lc rgb '#606060' lw 1.5 dt (6,4) front");
  return {suffix, plan.commands()};
}

double spread_of(const Trial& trial) {
  double most = 0.0;
  for (const Contact& contact : trial.contacts)
    if (const int below = below_in(trial, contact); below >= 0 && trial.stable[idx(below)] == 0)
      most = std::max(most, reach_of(trial, below));
  for (const int other : around_unstable(trial)) most = std::max(most, reach_of(trial, other));
  return most;
}

}  // namespace tumble::chapters
